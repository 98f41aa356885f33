#include "track/search/load_estimate.hpp"

#include "contact/base/pi.hpp"
#include "contact/base/root.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace rollfem::track {

namespace {

using contact::pi;
/// Of the approach, overlap that has the extent of the patch. A half would be exact for a circular
/// patch (Hertz: a^2 = R approach); Kik and Piotrowski have 0.55. With every row on its own normal
/// and the deflection of the whole patch this one is nearest to CONTACT's approaches.
constexpr double overlap_fraction = 0.57;

/// G(t), the integral over |u| < 1 of sqrt(1 - u^2) / sqrt(u^2 + t^2), from a table over ln t:
/// what a semi-elliptic row of half length 1 deflects at a distance t beside its middle.
class RowDeflection {
 public:
  RowDeflection() {
    for (std::size_t k = 0; k < table_.size(); ++k)
      table_[k] = integral(std::exp(first_ + step_ * static_cast<double>(k)));
  }

  double operator()(double t) const {
    const double most = static_cast<double>(table_.size() - 1) - 1e-9;
    const double place = std::clamp((std::log(t) - first_) / step_, 0.0, most);
    const auto k = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(k);
    return (1.0 - share) * table_[k] + share * table_[k + 1];
  }

 private:
  static double integral(double t) {
    constexpr int points = 400;
    // u = t sinh(v), v even over its range: the peak at 0 and the tails have points alike.
    const double end = std::asinh(1.0 / t);
    const double ratio = std::exp(end / points);
    double power = std::exp(0.5 * end / points);  // e^v
    double sum = 0.0;
    for (int k = 0; k < points; ++k, power *= ratio) {
      const double u = 0.5 * t * (power - 1.0 / power);
      sum += std::sqrt(std::max(0.0, 1.0 - u * u)) * end;
    }
    return 2.0 * sum / points;
  }

  static constexpr double first_ = -9.0;  ///< ln t
  static constexpr double step_ = 0.05;
  std::array<double, 321> table_{};
};

/// Rows of elements across a stretch at a sinking.
struct Rows {
  static constexpr std::size_t cells = 120;
  std::array<double, cells> place{};     ///< mm along the common surface
  std::array<double, cells> width{};     ///< mm along it
  std::array<double, cells> half{};      ///< mm, half length of the patch; 0: nothing overlaps
  std::array<double, cells> approach{};  ///< mm, of the bodies along the local normal
  double vertical = 0.0;                 ///< integral of pi/2 half^2 over y, mm^3
};

/// `way`: vertical, of the deepest place of the stretch, mm. Every row takes its own normal.
Rows rows_of(const VerticalGap& gap, const Stretch& stretch, double way) {
  const double overlap = overlap_fraction * way;
  const double least = stretch.deepest.gap;
  // All humps of the stretch that are below the limit count, valleys between them or not, so that
  // nothing jumps where they meet.
  const auto [lower, upper] =
      gap.span_below(least + overlap, stretch.deepest.y, stretch.limits[0], stretch.limits[1]);
  const double dy = (upper - lower) / static_cast<double>(Rows::cells);
  Rows rows;
  double place = 0.0;
  for (std::size_t k = 0; k < Rows::cells; ++k) {
    const double y = lower + (static_cast<double>(k) + 0.5) * dy;
    const contact::CurveValue here = gap.at(y);
    const double slope = gap.rail().at(y).slope - 0.5 * here.slope;
    const double stretched = std::sqrt(1.0 + slope * slope);
    const double depth = std::max(0.0, overlap - (here.value - least));
    const double half_square = 2.0 * stretch.rolling_radius * depth;
    rows.place[k] = place + 0.5 * dy * stretched;
    place += dy * stretched;
    rows.width[k] = dy * stretched;
    rows.half[k] = std::sqrt(half_square);
    rows.approach[k] = (way - (here.value - least)) / stretched;
    rows.vertical += 0.5 * pi * half_square * dy;
  }
  return rows;
}

/// Approach over deflection under semi-elliptic rows of unit pressure over half length, the mean of
/// both over the patch with the eighth power of the overlap. At the deepest place alone it would
/// jump where another hump becomes the deepest.
double approach_per_deflection(const Rows& rows) {
  static const RowDeflection row_deflection;
  constexpr std::size_t every = 3;
  double approach = 0.0, deflection = 0.0;
  for (std::size_t j = every / 2; j < rows.place.size(); j += every) {
    const double half = rows.half[j];
    if (!(half > 0.0)) continue;
    const double weight = std::pow(half, 16);
    double sum = 0.0;
    for (std::size_t k = 0; k < rows.place.size(); ++k) {
      if (!(rows.half[k] > 0.0)) continue;
      // A quarter of the width keeps the row itself off the logarithm.
      const double s = std::max(std::abs(rows.place[k] - rows.place[j]), 0.25 * rows.width[k]);
      sum += rows.half[k] * row_deflection(s / rows.half[k]) * rows.width[k];
    }
    approach += weight * rows.approach[j];
    deflection += weight * sum;
  }
  return deflection > 0.0 ? approach / deflection : 0.0;
}

/// The sinking by the secant method between logarithms of approach and force, which a power law
/// of both makes straight; nothing where that does not converge.
template <class Carried>
std::optional<double> power_law_root(const Carried& carried, double least, double vertical,
                                     double tolerance) {
  constexpr int most_steps = 20;
  double approach = 0.05, exponent = 1.5;  // mm; Hertz's
  double last_logarithm = 0.0, last_force = 0.0;
  for (int step = 0; step < most_steps; ++step) {
    const double force = carried(least + approach);
    if (!(force > 0.0)) return {};
    const double logarithm = std::log(approach);
    if (step > 0 && logarithm != last_logarithm)
      exponent = std::log(force / last_force) / (logarithm - last_logarithm);
    if (!(exponent > 0.3 && exponent < 6.0)) return {};
    last_logarithm = logarithm;
    last_force = force;
    const double next = approach * std::pow(vertical / force, 1.0 / exponent);
    if (!std::isfinite(next)) return {};
    if (std::abs(next - approach) <= tolerance) return least + next;
    approach = next;
  }
  return {};
}

}  // namespace

double approach_of(const Stretch& stretch, double sinking) {
  return (sinking - stretch.deepest.gap) * std::cos(stretch.deepest.angle());
}

double estimate_force(const VerticalGap& gap, const Stretch& stretch, double approach,
                      double modulus) {
  if (!(approach > 0.0)) return 0.0;
  const double cosine = std::cos(stretch.deepest.angle());
  const Rows rows = rows_of(gap, stretch, approach / cosine);
  return pi * modulus * approach_per_deflection(rows) * rows.vertical / cosine;
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
  constexpr double tolerance = 1e-12;  // mm
  if (const auto found = power_law_root(carried, least, vertical, tolerance)) return *found;
  double lower = 0.0, upper = 0.01;
  const auto excess = [&](double approach) { return carried(least + approach) - vertical; };
  for (int step = 0; step < 30 && excess(upper) < 0.0; ++step) {
    lower = upper;
    upper *= 2.0;
  }
  return least +
         contact::bracketed_root(excess, lower, upper, tolerance, "estimate of the sinking");
}

}  // namespace rollfem::track
