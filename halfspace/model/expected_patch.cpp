#include "halfspace/model/expected_patch.hpp"

#include "contact/base/errors.hpp"
#include "contact/result/patch_size.hpp"
#include "contact/scene/geometry.hpp"
#include "contact/solve/normal.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/elasticity/compliance.hpp"
#include "halfspace/model/patch_ridge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rollfem::halfspace {

using contact::Case;
using contact::ContactGrid;

namespace {

/// Elements across the box of a search, and across the patch that it must find at least.
constexpr int elements_of_box = 30;
constexpr int fewest_across_patch = 20;
constexpr int most_rounds = 12;
/// On each side of the patch of the round before, relative to its extent.
constexpr double margin = 0.2;

struct Box {
  double x_lower, x_upper, y_lower, y_upper;
};

/// Nothing touches outside of the overlap: the elastic displacement only ever opens the gap, so
/// that h < approach wherever there is pressure.
Box box_of(const std::vector<RidgeRegion>& regions) {
  Box box{regions.front().x_lower, regions.front().x_upper, regions.front().y_lower,
          regions.back().y_upper};
  for (const RidgeRegion& region : regions) {
    box.x_lower = std::min(box.x_lower, region.x_lower);
    box.x_upper = std::max(box.x_upper, region.x_upper);
  }
  return box;
}

std::optional<double> largest_force(const Case& input) {
  std::optional<double> force = input.load.normal_force;
  for (const double other : input.load.normal_forces)
    force = std::max(force.value_or(other), other);
  return force;
}

/// An overlap that is likely to carry the force: that of Hertz's ellipse for a parabola as wide as
/// the overlap of the profiles.
double overlap_for_force(const Ridge& ridge, double A, double modulus, double force) {
  double overlap = 1e-6;  // mm
  for (int step = 0; step < 200; ++step, overlap *= 1.2) {
    const auto regions = ridge.contact_regions(ridge.least_distance() + overlap);
    if (regions.empty()) continue;
    const double half = 0.5 * (regions.back().y_upper - regions.front().y_lower);
    if (hertz_from_force(A, overlap / (half * half), modulus, force).approach < overlap) break;
  }
  return overlap;
}

struct Found {
  contact::NormalSolution normal;
  contact::PatchSize size;
  ContactGrid grid;
};

Found solve_in(const Case& input, const Box& box, const std::optional<double>& force,
               int n = elements_of_box) {
  const double dx = (box.x_upper - box.x_lower) / n;
  const double dy = (box.y_upper - box.y_lower) / n;
  Found found;
  found.grid = {n, n, dx, dy, box.x_lower + 0.5 * dx, box.y_lower + 0.5 * dy};
  contact::CombinedMaterial material = contact::combine(input.wheel.material, input.rail.material);
  material.difference = 0.0;
  const HalfspaceCompliance compliance(found.grid, material);
  contact::NormalProblem problem{contact::undeformed_distance(input, found.grid), {}, {}};
  if (force)
    problem.normal_force = force;
  else
    problem.approach = input.load.approach;
  contact::NormalOptions options;
  options.tolerance = 1e-4;
  found.normal = contact::solve_normal(compliance.normal(), problem, options);
  found.size = contact::patch_size(found.grid, found.normal.pressure);
  return found;
}

/// The patch with a margin.
Box next_box(const Found& found) {
  const auto grow = [](double& lower, double& upper, double step) {
    const double extent = std::max(upper - lower, 2.0 * step);
    lower -= margin * extent;
    upper += margin * extent;
  };
  const contact::PatchSize& size = found.size;
  Box next{size.x_lower, size.x_upper, size.y_lower, size.y_upper};
  grow(next.x_lower, next.x_upper, found.grid.dx);
  grow(next.y_lower, next.y_upper, found.grid.dy);
  return next;
}

bool fine_enough(const Found& found) {
  return found.size.length >= fewest_across_patch * found.grid.dx &&
         found.size.width >= fewest_across_patch * found.grid.dy &&
         !contact::touches_border(found.grid, found.normal.pressure);
}

ExpectedPatch summary(const Found& found) {
  const contact::Field& pressure = found.normal.pressure;
  const auto centre = [&](auto&& coordinate) {
    return found.grid.sample(coordinate).dot(pressure) / pressure.sum();
  };
  ExpectedPatch patch;
  patch.x_lower = found.size.x_lower;
  patch.x_upper = found.size.x_upper;
  patch.y_lower = found.size.y_lower;
  patch.y_upper = found.size.y_upper;
  patch.x_centre = centre([](double x, double) { return x; });
  patch.y_centre = centre([](double, double y) { return y; });
  patch.approach = found.normal.approach;
  patch.max_pressure = pressure.maxCoeff();
  patch.normal_force = found.normal.normal_force;
  patch.area = found.size.area;
  return patch;
}

ExpectedPatch patch_of_profiles(const Case& input, int elements) {
  const Ridge ridge(*input.patch);
  const std::optional<double> force = largest_force(input);
  const double A = contact::relative_curvatures(input).A;
  const double modulus =
      contact::combine(input.wheel.material, input.rail.material).contact_modulus;
  double level = force ? ridge.least_distance() + 1.1 * overlap_for_force(ridge, A, modulus, *force)
                       : input.load.approach.value_or(0.0);
  const auto overlap_box = [&] {
    const auto regions = ridge.contact_regions(level);
    if (regions.empty())
      throw contact::SolveError(fmt::format(
          "{}: no contact: the approach {} mm does not exceed the smallest distance {} mm",
          input.file, level, ridge.least_distance()));
    return box_of(regions);
  };
  Box box = overlap_box();
  Found found = solve_in(input, box, force);
  for (int round = 0; round < most_rounds && force && found.normal.approach > level; ++round) {
    level = ridge.least_distance() + 1.2 * (found.normal.approach - ridge.least_distance());
    box = overlap_box();
    found = solve_in(input, box, force);
  }
  for (int round = 0; round < most_rounds && !fine_enough(found); ++round) {
    box = next_box(found);
    found = solve_in(input, box, force);
  }
  check_profiles_reach(input, found.size.y_lower, found.size.y_upper);
  if (elements > elements_of_box) found = solve_in(input, next_box(found), force, elements);
  return summary(found);
}

}  // namespace

ExpectedPatch expected_patch(const Case& input, int elements) {
  if (input.patch) return patch_of_profiles(input, elements);
  constexpr double pi = 3.14159265358979323846;
  const HertzContact hertz = hertz_of_case(input);
  ExpectedPatch patch;
  patch.x_lower = -hertz.semi_axis_x;
  patch.x_upper = hertz.semi_axis_x;
  patch.y_lower = -hertz.semi_axis_y;
  patch.y_upper = hertz.semi_axis_y;
  patch.approach = hertz.approach;
  patch.max_pressure = hertz.max_pressure;
  patch.normal_force = hertz.normal_force;
  patch.area = pi * hertz.semi_axis_x * hertz.semi_axis_y;
  return patch;
}

void check_profiles_reach(const Case& input, double y_lower, double y_upper) {
  if (!input.patch) return;
  const auto check = [&](const contact::HeightCurve& curve, const char* body) {
    const bool below = y_lower < curve.first();
    if (!below && y_upper <= curve.last()) return;
    throw contact::InputError(fmt::format(
        "{}: {}.profile: {}profile too short for the contact: it ends at y = {:.4g} mm of the "
        "patch, the contact reaches from {:.4g} to {:.4g} mm; allowed: profiles that go beyond the "
        "patch; do: give a profile that is measured or defined farther, or move the wheelset",
        input.file, body, input.place ? input.place->label() + ": " : std::string(),
        below ? curve.first() : curve.last(), y_lower, y_upper));
  };
  check(input.patch->rail(), "rail");
  check(input.patch->wheel(), "wheel");
}

}  // namespace rollfem::halfspace
