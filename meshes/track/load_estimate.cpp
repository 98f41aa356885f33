#include "meshes/track/load_estimate.hpp"

#include "contact/base/pi.hpp"
#include "contact/base/root.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollfem::meshes {

namespace {

using contact::pi;
/// Of the approach, overlap that has the extent of the patch. A half would be exact for a circular
/// patch (Hertz: a^2 = R approach).
constexpr double overlap_fraction = 0.55;

/// Integral over |x| < half of sqrt(half^2 - x^2) / sqrt(x^2 + s^2), by x = half sin(t).
double over_distance(double half, double s) {
  constexpr int points = 16;
  double sum = 0.0;
  for (int k = 0; k < points; ++k) {
    const double t = pi * (k + 0.5) / (2.0 * points);
    const double x = half * std::sin(t);
    const double cosine = half * std::cos(t);
    sum += cosine * cosine / std::sqrt(x * x + s * s);
  }
  return sum * pi / points;
}

}  // namespace

double approach_of(const Stretch& stretch, double sinking) {
  return (sinking - stretch.deepest.gap) * std::cos(stretch.deepest.angle());
}

double estimate_force(const VerticalGap& gap, const Stretch& stretch, double approach,
                      double modulus) {
  if (!(approach > 0.0)) return 0.0;
  const double cosine = std::cos(stretch.deepest.angle());
  const double overlap = overlap_fraction * approach;
  const double limit = stretch.deepest.gap + overlap / cosine;
  // All humps of the stretch that are below the limit count, valleys between them or not, so that
  // nothing jumps where they meet; the farther ones press the deepest down as well.
  const auto [lower, upper] =
      gap.span_below(limit, stretch.deepest.y, stretch.limits[0], stretch.limits[1]);
  constexpr int cells = 160;
  const double ds = (upper - lower) / cosine / cells;
  double force = 0.0, deflection = 0.0;
  for (int k = 0; k < cells; ++k) {
    const double y = lower + (upper - lower) * (k + 0.5) / cells;
    const double depth = overlap - (gap.at(y).value - stretch.deepest.gap) * cosine;
    if (!(depth > 0.0)) continue;
    const double half_square = 2.0 * stretch.rolling_radius / cosine * depth;
    const double s = (y - stretch.deepest.y) / cosine;
    force += 0.5 * pi * half_square * ds;
    // A quarter of the cell keeps the middle one off the logarithm.
    deflection += over_distance(std::sqrt(half_square), std::max(std::abs(s), 0.25 * ds)) * ds;
  }
  return deflection > 0.0 ? pi * modulus * approach * force / deflection : 0.0;
}

double estimate_sinking(const VerticalGap& gap, const std::vector<Stretch>& stretches,
                        double vertical, double modulus) {
  double least = std::numeric_limits<double>::infinity();
  for (const Stretch& stretch : stretches) least = std::min(least, stretch.deepest.gap);
  const auto carried = [&](double sinking) {
    double sum = 0.0;
    for (const Stretch& stretch : stretches)
      sum += std::cos(stretch.deepest.angle()) *
             estimate_force(gap, stretch, approach_of(stretch, sinking), modulus);
    return sum;
  };
  double lower = 0.0, upper = 0.01;
  const auto excess = [&](double approach) { return carried(least + approach) - vertical; };
  for (int step = 0; step < 30 && excess(upper) < 0.0; ++step) {
    lower = upper;
    upper *= 2.0;
  }
  return least + contact::bracketed_root(excess, lower, upper, 1e-12, "estimate of the sinking");
}

}  // namespace rollfem::meshes
