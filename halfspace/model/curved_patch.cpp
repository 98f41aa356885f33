#include "halfspace/model/curved_patch.hpp"

#include "contact/base/errors.hpp"
#include "contact/scene/contact_surface.hpp"
#include "contact/scene/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rollfem::halfspace {

using contact::Case;
using contact::ContactGrid;
using contact::CurveValue;
using contact::Field;
using contact::HeightCurve;
using contact::PatchGeometry;

namespace {

/// Distance where the wheel has no surface, mm.
constexpr double beyond_the_wheel = 1e3;
constexpr double knot_distance = 0.05;  // mm
/// Surfaces steeper than this belong to no patch.
constexpr double steepest = 2.0;
/// Radii are laid out as circles as far as this, mm, or this share of the radius.
constexpr double farthest = 100.0;
constexpr double share_of_radius = 0.7;

double stretch_of(double climb) {
  return std::sqrt(1.0 + climb * climb);
}

void refuse(const Case& input, bool asked, const char* what) {
  if (!asked) return;
  throw contact::InputError(fmt::format(
      "{}: halfspace.surface = \"curved\": it does not go with {}; allowed: steady or frictionless "
      "rolling of like materials over profiles or radii; do: leave that out, or run with surface = "
      "\"planar\"",
      input.file, what));
}

void check(const Case& input) {
  using contact::Problem;
  const Problem problem = input.rolling.problem;
  refuse(input, problem == Problem::shift || problem == Problem::transient,
         "rolling.problem shift or transient");
  refuse(input, input.undeformed_distance.values || input.undeformed_distance.quadratic,
         "undeformed_distance");
  refuse(input, input.given_pressure.has_value(), "given_pressure");
  refuse(input, input.rolling.extra_slip != contact::ExtraSlip::none,
         "rolling.extra_slip, which it contains");
  refuse(input, !input.subsurface.empty() || input.output.stress_maxima.value_or(false),
         "subsurface stresses, which are those of a plane half-space");
  refuse(input,
         std::abs(contact::combine(input.wheel.material, input.rail.material).difference) > 1e-12,
         "unlike materials");
}

/// Both circles of a case with radii.
std::shared_ptr<const PatchGeometry> patch_of_radii(const Case& input) {
  const double least =
      std::min(std::abs(input.wheel.transverse_radius), std::abs(input.rail.transverse_radius));
  const double reach = std::min(farthest, share_of_radius * least);
  const auto curve = [&](double radius, double start) {
    std::vector<double> y, z, slope;
    const int pieces = static_cast<int>(std::ceil(reach / knot_distance));
    for (int k = -pieces; k <= pieces; ++k) {
      const double at = reach * k / pieces;
      const contact::ProfileDrop drop = contact::profile_drop(radius, at);
      y.push_back(at);
      z.push_back(start - drop.value);
      slope.push_back(-drop.slope);
    }
    return HeightCurve(y, z, slope);
  };
  const double radius = input.wheel.rolling_radius;
  return std::make_shared<PatchGeometry>(
      curve(input.rail.transverse_radius, 0.0), curve(input.wheel.transverse_radius, radius),
      contact::Axle{{0.0, 0.0, radius}, {0.0, 1.0, 0.0}}, -reach, reach);
}

double climb_at(const PatchGeometry& patch, double y) {
  return 0.5 * (patch.rail().at(y).slope + patch.wheel().at(y).slope);
}

/// y over arc length from y = 0.
HeightCurve unrolled(const PatchGeometry& patch) {
  const double lower = std::max(patch.rail().first(), patch.wheel().first());
  const double upper = std::min(patch.rail().last(), patch.wheel().last());
  std::vector<double> y, s, slope;
  const auto walk = [&](double direction, double end) {
    double at = 0.0, way = 0.0;
    double stretch = stretch_of(climb_at(patch, at));
    while (direction * at < direction * end) {
      const double next = at + direction * std::min(knot_distance, std::abs(end - at));
      const double climb = climb_at(patch, next);
      if (std::abs(climb) > steepest) return;
      const double middle = stretch_of(climb_at(patch, 0.5 * (at + next)));
      way += (next - at) * (stretch + 4.0 * middle + stretch_of(climb)) / 6.0;
      at = next;
      stretch = stretch_of(climb);
      y.push_back(at);
      s.push_back(way);
      slope.push_back(1.0 / stretch);
    }
  };
  walk(-1.0, lower);
  for (auto* values : {&y, &s, &slope}) std::reverse(values->begin(), values->end());
  y.push_back(0.0);
  s.push_back(0.0);
  slope.push_back(1.0 / stretch_of(climb_at(patch, 0.0)));
  walk(1.0, upper);
  return {s, y, slope};
}

}  // namespace

CurvedPatch::CurvedPatch(const Case& input) {
  check(input);
  patch_ = input.patch ? input.patch : patch_of_radii(input);
  y_ = unrolled(*patch_);
}

double CurvedPatch::climb(double s) const {
  return climb_at(*patch_, y(s));
}

Field CurvedPatch::cosine(const ContactGrid& grid) const {
  return grid.sample([&](double, double s) { return 1.0 / stretch_of(climb(s)); });
}

contact::PatchShape CurvedPatch::shape(const ContactGrid& grid) const {
  contact::PatchShape shape;
  shape.stretch = Field::Ones(grid.size());
  shape.climb = grid.sample([&](double, double s) { return climb(s); });
  shape.y = grid.sample([&](double, double s) { return y(s); });
  return shape;
}

/// By Newton's method with the slope of the section; what yaw and x leave out of that costs digits
/// of each step, not of the result.
double CurvedPatch::way_along_normal(bool wheel, double x, double s) const {
  const double y0 = y(s);
  const double rise = climb_at(*patch_, y0);
  const double stretch = stretch_of(rise);
  const double z0 = 0.5 * (patch_->rail().at(y0).value + patch_->wheel().at(y0).value);
  double way = 0.0;
  for (int step = 0; step < 30; ++step) {
    const double at = y0 - rise * way / stretch;
    const CurveValue section = (wheel ? patch_->wheel() : patch_->rail()).at(at);
    const double height = wheel ? patch_->wheel_height(x, at) : section.value;
    if (!std::isfinite(height)) return beyond_the_wheel;
    const double change = (height - (z0 + way / stretch)) * stretch / (1.0 + rise * section.slope);
    way += change;
    if (std::abs(change) < 1e-11) break;
  }
  return way;
}

Field CurvedPatch::undeformed_distance(const ContactGrid& grid) const {
  Field distance(grid.size());
  for (int j = 0; j < grid.ny; ++j) {
    const double rail = way_along_normal(false, 0.0, grid.y(j));
    for (int i = 0; i < grid.nx; ++i)
      distance[grid.index(i, j)] =
          std::min(way_along_normal(true, grid.x(i), grid.y(j)) - rail, beyond_the_wheel);
  }
  return distance;
}

contact::TangentialField CurvedPatch::rigid_slip(const contact::Creepage& creepage,
                                                 const ContactGrid& grid) const {
  const double radius = patch_->local_rolling_radius(0.0);
  const contact::Vector3& e = patch_->axle().direction;
  const double turning = (1.0 - creepage.longitudinal) / radius;
  const double beyond = creepage.spin - turning * e[2];
  contact::TangentialField slip{Field(grid.size()), Field(grid.size())};
  for (int j = 0; j < grid.ny; ++j) {
    const double at = y(grid.y(j));
    const double rise = climb(grid.y(j));
    const double cosine = 1.0 / stretch_of(rise);
    // 1 - (1 - xi) rho / rho_0 without cancellation.
    const double along =
        creepage.longitudinal + turning * (radius - patch_->local_rolling_radius(at)) - beyond * at;
    const double turning_about_normal = turning * (e[2] - rise * e[1]) * cosine;
    for (int i = 0; i < grid.nx; ++i) {
      const int k = grid.index(i, j);
      const double x = grid.x(i);
      slip.x[k] = along;
      slip.y[k] = (creepage.lateral + beyond * x) * cosine + turning_about_normal * x;
    }
  }
  return slip;
}

}  // namespace rollfem::halfspace
