// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/height_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace rollfem::contact {

HeightCurve::HeightCurve(std::vector<double> y, std::vector<double> z, std::vector<double> slope)
    : y_(std::move(y)), z_(std::move(z)), slope_(std::move(slope)) {
  if (y_.size() < 2 || z_.size() != y_.size() || slope_.size() != y_.size())
    throw std::invalid_argument("a height curve needs at least two knots, each with a slope");
  for (std::size_t k = 1; k < y_.size(); ++k)
    if (!(y_[k] > y_[k - 1]))
      throw std::invalid_argument("the knots of a height curve must increase");
  knots_before_.assign(y_.size() + 1, 0);
  stretches_per_length_ = static_cast<double>(y_.size()) / (y_.back() - y_.front());
  for (const double knot : y_) ++knots_before_[stretch_of(knot) + 1];
  std::partial_sum(knots_before_.begin(), knots_before_.end(), knots_before_.begin());
}

/// Non-decreasing in y despite rounding; 0 for NaN.
std::size_t HeightCurve::stretch_of(double y) const {
  const double place = (y - y_.front()) * stretches_per_length_;
  return place > 0.0 ? std::min(y_.size() - 1, static_cast<std::size_t>(place)) : 0;
}

std::size_t HeightCurve::piece_of(double y) const {
  const std::size_t stretch = stretch_of(y);
  std::size_t above = knots_before_[stretch];
  const std::size_t end = knots_before_[stretch + 1];
  constexpr std::size_t few = 8;
  if (end - above > few)
    above = static_cast<std::size_t>(
        std::upper_bound(y_.begin() + static_cast<std::ptrdiff_t>(above),
                         y_.begin() + static_cast<std::ptrdiff_t>(end), y) -
        y_.begin());
  else
    while (above < end && y_[above] <= y) ++above;
  return std::clamp<std::size_t>(above, 1, y_.size() - 1) - 1;
}

CurveValue HeightCurve::at(double y) const {
  if (y <= y_.front()) {
    if (y < y_.front()) return {z_.front() + slope_.front() * (y - y_.front()), slope_.front(), 0};
  } else if (y > y_.back()) {
    return {z_.back() + slope_.back() * (y - y_.back()), slope_.back(), 0};
  }
  const std::size_t k = piece_of(y);
  const double h = y_[k + 1] - y_[k];
  return hermite(h, (y - y_[k]) * (1.0 / h), z_[k], z_[k + 1], slope_[k], slope_[k + 1]);
}

double HeightCurve::mean(double from, double to) const {
  // Integral of a cubic between two points: the trapezium, then a correction from the slopes at
  // both ends.
  const auto area = [](double h, const CurveValue& a, const CurveValue& b) {
    return h * (0.5 * (a.value + b.value) + h * (a.slope - b.slope) / 12.0);
  };
  double sum = 0.0, last = from;
  CurveValue before = at(from);
  auto knot = std::upper_bound(y_.begin(), y_.end(), from);
  for (; knot != y_.end() && *knot < to; ++knot) {
    const auto k = static_cast<std::size_t>(knot - y_.begin());
    const CurveValue here{z_[k], slope_[k], 0.0};
    sum += area(*knot - last, before, here);
    before = here;
    last = *knot;
  }
  return (sum + area(to - last, before, at(to))) / (to - from);
}

double HeightCurve::averaging(double y, double width) const {
  const double lower = y - 0.5 * width, upper = y + 0.5 * width;
  const double here = mean(lower, upper);
  const double second = mean(lower - width, lower) - 2.0 * here + mean(upper, upper + width);
  return here - second / 24.0 - at(y).value;
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
