// SPDX-License-Identifier: LGPL-2.1-or-later
#include "theories/strip.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/pi.hpp"
#include "contact/base/root.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::theories {

namespace {

using contact::pi;

double smallest_distance(const StripProfile& profile) {
  return *std::min_element(profile.distance.begin(), profile.distance.end());
}

/// g(y) of one strip, positive where the profiles overlap.
double overlap(const StripProfile& profile, int strip, double level) {
  return level - profile.distance[strip];
}

/// Where the overlap vanishes between a strip in contact and its neighbour out of contact; the
/// border of the profile when there is none.
double edge(const StripProfile& profile, int inside, int outside, double level) {
  const double half = 0.5 * (outside - inside) * profile.width;
  if (outside < 0 || outside >= profile.size()) return profile.y(inside) + half;
  const double within = overlap(profile, inside, level);
  return profile.y(inside) + 2.0 * half * within / (within - overlap(profile, outside, level));
}

/// The run of overlapping strips that begins at `first`.
StripPatch find_patch(const StripProfile& profile, int first, double level) {
  StripPatch patch;
  patch.first = patch.last = patch.deepest = first;
  while (patch.last + 1 < profile.size() && overlap(profile, patch.last + 1, level) > 0.0) {
    ++patch.last;
    if (profile.distance[patch.last] < profile.distance[patch.deepest]) patch.deepest = patch.last;
  }
  patch.y_lower = edge(profile, first, first - 1, level);
  patch.y_upper = edge(profile, patch.last, patch.last + 1, level);
  return patch;
}

/// Strips of one patch from Hertz's ellipse. A parabola B y^2 penetrating to the depth g0 has the
/// volume 4/3 g0 sqrt(g0/B); the ellipse's B gives the same depth and volume.
void solve_as_hertz(const StripProfile& profile, const StripLaw& law, double level,
                    StripPatch& patch, StripNormalSolution& solution) {
  const double depth = overlap(profile, patch.deepest, level);
  double volume = 0.0;
  for (int j = patch.first; j <= patch.last; ++j)
    volume += profile.width * overlap(profile, j, level);
  const double half_width = 0.75 * volume / depth;
  const double A = profile.curvature[patch.deepest];
  const double B = depth / (half_width * half_width);
  const halfspace::HertzContact shape = halfspace::hertz_from_force(A, B, law.contact_modulus, 1.0);
  const double aspect = shape.semi_axis_x / shape.semi_axis_y;
  patch.semi_axis_y = half_width;
  patch.semi_axis_x = aspect * half_width;
  // All of Hertz's figures scale with the size of the ellipse: p0 with a, the approach with a^2.
  const double scale = patch.semi_axis_x / shape.semi_axis_x;
  patch.max_pressure = shape.max_pressure * scale;
  patch.approach = shape.approach * scale * scale;
  for (int j = patch.first; j <= patch.last; ++j) {
    const double relative_curvature = profile.curvature[j] / A;
    const double length =
        patch.semi_axis_x * std::sqrt(overlap(profile, j, level) / (depth * relative_curvature));
    const double pressure = patch.max_pressure * relative_curvature * length / patch.semi_axis_x;
    solution.half_length[j] = length;
    solution.max_pressure[j] = pressure;
    solution.normal_force += 0.5 * pi * pressure * length * profile.width;
  }
}

/// Integral of sqrt(a^2 - x^2) / r over a strip of half length a whose middle is at lateral
/// distance `distance` from the origin of r, mm^2; x_m = 0.
double strip_potential(double a, double distance, double width) {
  // x = a sin(pi/2 u^2): points are dense at x = 0, where the integral of 1/r over the origin's own
  // strip is logarithmic, and the root at the ends becomes smooth.
  constexpr int places = 32;
  double sum = 0.0;
  for (int k = 0; k < places; ++k) {
    const double u = (k + 0.5) / places;
    const double angle = 0.5 * pi * u * u;
    const double x = a * std::sin(angle);
    const double across =
        std::asinh((distance + 0.5 * width) / x) - std::asinh((distance - 0.5 * width) / x);
    sum += u * std::pow(std::cos(angle), 2) * across;
  }
  return 2.0 * pi * a * a * sum / places;
}

/// Strips of one patch from its virtual penetration.
void solve_by_penetration(const StripProfile& profile, const StripLaw& law, double level,
                          StripPatch& patch, StripNormalSolution& solution) {
  const double depth = overlap(profile, patch.deepest, level);
  const double A = profile.curvature[patch.deepest];
  patch.semi_axis_y = 0.5 * (patch.y_upper - patch.y_lower);
  const double B = depth / (patch.semi_axis_y * patch.semi_axis_y);
  const halfspace::HertzContact shape = halfspace::hertz_from_force(A, B, law.contact_modulus, 1.0);
  patch.semi_axis_x = patch.semi_axis_y * shape.semi_axis_x / shape.semi_axis_y;
  const double stretch = patch.semi_axis_x / std::sqrt(depth / A);
  double potential = 0.0;
  for (int j = patch.first; j <= patch.last; ++j) {
    const double length = stretch * std::sqrt(overlap(profile, j, level) / profile.curvature[j]);
    solution.half_length[j] = length;
    potential += strip_potential(length, profile.y(j) - profile.y(patch.deepest), profile.width);
  }
  patch.approach = depth / *law.virtual_penetration;
  // The displacement of both surfaces under p is 1/(pi E*) times the integral of p / r.
  const double kappa = patch.approach * pi * law.contact_modulus / potential;
  patch.max_pressure = kappa * patch.semi_axis_x;
  for (int j = patch.first; j <= patch.last; ++j) {
    const double length = solution.half_length[j];
    solution.max_pressure[j] = kappa * length;
    solution.normal_force += 0.5 * pi * kappa * length * length * profile.width;
  }
}

/// Solution at the penetration at which `value`, which increases with it, reaches `target`.
StripNormalSolution find_penetration(const StripProfile& profile, const StripLaw& law,
                                     double target, const char* quantity,
                                     double StripNormalSolution::*value) {
  const double available =
      std::min(profile.distance.front(), profile.distance.back()) - smallest_distance(profile);
  const auto solve = [&](double g) { return strips_at_penetration(profile, law, g); };
  if (!(available > 0.0) || solve(available).*value < target)
    throw contact::SolveError(fmt::format(
        "strip model: at the {} of {:g} the patch reaches the end of the profiles; give "
        "profiles wider than the contact",
        quantity, target));
  // Bisected to the last digit, because the force jumps where two patches merge.
  const StripNormalSolution solution =
      solve(contact::bracketed_root([&](double g) { return solve(g).*value / target - 1.0; }, 0.0,
                                    available, 0.0, "strip model: penetration"));
  const double error = std::abs(solution.*value / target - 1.0);
  if (error > 1e-6)
    throw contact::SolveError(
        fmt::format("strip model: no penetration gives the {} of {:g}, because two patches merge "
                    "there (closest: a relative error of {:.2g}); use the model halfspace",
                    quantity, target, error));
  return solution;
}

}  // namespace

StripNormalSolution strips_at_penetration(const StripProfile& profile, const StripLaw& law,
                                          double penetration) {
  const double level = smallest_distance(profile) + penetration;
  StripNormalSolution solution;
  solution.half_length.assign(profile.size(), 0.0);
  solution.max_pressure.assign(profile.size(), 0.0);
  solution.penetration = penetration;
  double deepest = 0.0;
  for (int j = 0; j < profile.size(); ++j) {
    if (!(overlap(profile, j, level) > 0.0)) continue;
    StripPatch patch = find_patch(profile, j, level);
    (law.virtual_penetration ? solve_by_penetration : solve_as_hertz)(profile, law, level, patch,
                                                                      solution);
    if (overlap(profile, patch.deepest, level) > deepest) {
      deepest = overlap(profile, patch.deepest, level);
      solution.approach = patch.approach;
    }
    solution.patches.push_back(patch);
    j = patch.last;
  }
  return solution;
}

StripNormalSolution strips_for_force(const StripProfile& profile, const StripLaw& law,
                                     double normal_force) {
  return find_penetration(profile, law, normal_force, "normal force",
                          &StripNormalSolution::normal_force);
}

StripNormalSolution strips_for_approach(const StripProfile& profile, const StripLaw& law,
                                        double approach) {
  return find_penetration(profile, law, approach, "approach", &StripNormalSolution::approach);
}

StripSection strip_section(const StripProfile& profile, const StripNormalSolution& solution,
                           double y) {
  const double position = (y - profile.y_first) / profile.width;
  if (!(position >= 0.0) || position > profile.size() - 1) return {};
  const int j = std::min(static_cast<int>(position), profile.size() - 2);
  const double weight = position - j;
  const auto at = [&](const std::vector<double>& values) {
    const double square =
        (1.0 - weight) * values[j] * values[j] + weight * values[j + 1] * values[j + 1];
    return std::sqrt(square);
  };
  const double middle = profile.middle.empty()
                            ? 0.0
                            : (1.0 - weight) * profile.middle[j] + weight * profile.middle[j + 1];
  return {at(solution.half_length), at(solution.max_pressure), middle};
}

}  // namespace rollfem::theories
