#include "contact/scene/height_curve.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace rollfem::contact {

namespace {

/// The interval from knot k to k + 1 that holds a place between the first and the last: looked for
/// about where it is if knots are evenly spaced, as those of profiles nearly are.
std::size_t interval_of(const std::vector<double>& knots, double y) {
  const std::size_t last = knots.size() - 2;
  const double place =
      (y - knots.front()) / (knots.back() - knots.front()) * static_cast<double>(last + 1);
  // Of a place that is not a number, 0.
  const std::size_t guess = place > 0.0 ? std::min(last, static_cast<std::size_t>(place)) : 0;
  std::size_t lower = guess, upper = guess + 1;
  for (std::size_t step = 1; lower > 0 && knots[lower] > y; step *= 2) {
    upper = lower;
    lower -= std::min(lower, step);
  }
  for (std::size_t step = 1; upper <= last && knots[upper] <= y; step *= 2) {
    lower = upper;
    upper = std::min(last + 1, upper + step);
  }
  const auto begin = knots.begin();
  const auto above = std::upper_bound(begin + static_cast<std::ptrdiff_t>(lower) + 1,
                                      begin + static_cast<std::ptrdiff_t>(upper), y);
  return static_cast<std::size_t>(above - begin) - 1;
}

}  // namespace

HeightCurve::HeightCurve(std::vector<double> y, std::vector<double> z, std::vector<double> slope)
    : y_(std::move(y)), z_(std::move(z)), slope_(std::move(slope)) {
  if (y_.size() < 2 || z_.size() != y_.size() || slope_.size() != y_.size())
    throw std::invalid_argument("a height curve needs two knots at least, each with a slope");
  for (std::size_t k = 1; k < y_.size(); ++k)
    if (!(y_[k] > y_[k - 1])) throw std::invalid_argument("the knots of a height curve must rise");
}

CurveValue HeightCurve::at(double y) const {
  if (y <= y_.front()) {
    if (y < y_.front()) return {z_.front() + slope_.front() * (y - y_.front()), slope_.front(), 0};
  } else if (y > y_.back()) {
    return {z_.back() + slope_.back() * (y - y_.back()), slope_.back(), 0};
  }
  const std::size_t k = interval_of(y_, y);
  const double h = y_[k + 1] - y_[k];
  const double by_h = 1.0 / h;
  const double t = (y - y_[k]) * by_h;
  // Newton's form of the cubic: chord, then what the slopes at both ends say beyond it.
  const double chord = (z_[k + 1] - z_[k]) * by_h;
  const double left = slope_[k] - chord;
  const double right = slope_[k + 1] - chord;
  const double sum = left + right;
  CurveValue result;
  result.value = z_[k] + h * t * (chord + (1.0 - t) * (left - t * sum));
  result.slope = chord + left * (1.0 - 2.0 * t) - sum * t * (2.0 - 3.0 * t);
  result.second = (-2.0 * left - sum * (2.0 - 6.0 * t)) * by_h;
  return result;
}

std::array<double, 2> HeightCurve::gentle_part(double steepest) const {
  constexpr double step = 0.05;  // mm
  const auto end = [&](double direction, double last) {
    double y = 0.0;
    while (direction * (y + direction * step) <= direction * last &&
           std::abs(at(y + direction * step).slope) <= steepest)
      y += direction * step;
    return y;
  };
  return {end(-1.0, first()), end(1.0, last())};
}

}  // namespace rollfem::contact
