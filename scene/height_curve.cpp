// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/height_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace rollfem::contact {

namespace {

bool is_before(double y, const HeightKnot& knot) {
  return y < knot.y;
}

}  // namespace

HeightCurve::HeightCurve(std::vector<HeightKnot> knots) : knots_(std::move(knots)) {
  if (knots_.size() < 2) throw std::invalid_argument("a height curve needs at least two knots");
  for (std::size_t k = 1; k < knots_.size(); ++k)
    if (!(knots_[k].y > knots_[k - 1].y))
      throw std::invalid_argument("the knots of a height curve must increase");
  knots_before_.assign(knots_.size() + 1, 0);
  stretches_per_length_ = static_cast<double>(knots_.size()) / (last() - first());
  for (const HeightKnot& knot : knots_) ++knots_before_[stretch_of(knot.y) + 1];
  std::partial_sum(knots_before_.begin(), knots_before_.end(), knots_before_.begin());
}

/// Non-decreasing in y despite rounding; 0 for NaN.
std::size_t HeightCurve::stretch_of(double y) const {
  const double place = (y - first()) * stretches_per_length_;
  return place > 0.0 ? std::min(knots_.size() - 1, static_cast<std::size_t>(place)) : 0;
}

std::size_t HeightCurve::piece_of(double y) const {
  const std::size_t stretch = stretch_of(y);
  std::size_t above = knots_before_[stretch];
  const std::size_t end = knots_before_[stretch + 1];
  constexpr std::size_t few = 8;
  if (end - above > few)
    above = static_cast<std::size_t>(
        std::upper_bound(knots_.begin() + static_cast<std::ptrdiff_t>(above),
                         knots_.begin() + static_cast<std::ptrdiff_t>(end), y, is_before) -
        knots_.begin());
  else
    while (above < end && knots_[above].y <= y) ++above;
  return std::clamp<std::size_t>(above, 1, knots_.size() - 1) - 1;
}

CurveValue HeightCurve::at(double y) const {
  const HeightKnot &begin = knots_.front(), &end = knots_.back();
  if (y < begin.y) return {begin.z + begin.slope * (y - begin.y), begin.slope, 0};
  if (y > end.y) return {end.z + end.slope * (y - end.y), end.slope, 0};
  const std::size_t k = piece_of(y);
  const HeightKnot &a = knots_[k], &b = knots_[k + 1];
  const double h = b.y - a.y;
  return hermite(h, (y - a.y) * (1.0 / h), a.z, b.z, a.slope, b.slope);
}

double HeightCurve::mean(double from, double to) const {
  // Integral of a cubic between two points: the trapezium, then a correction from the slopes at
  // both ends.
  const auto area = [](double h, const CurveValue& a, const CurveValue& b) {
    return h * (0.5 * (a.value + b.value) + h * (a.slope - b.slope) / 12.0);
  };
  double sum = 0.0, last = from;
  CurveValue before = at(from);
  auto knot = std::upper_bound(knots_.begin(), knots_.end(), from, is_before);
  for (; knot != knots_.end() && knot->y < to; ++knot) {
    const CurveValue here{knot->z, knot->slope, 0.0};
    sum += area(knot->y - last, before, here);
    before = here;
    last = knot->y;
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
