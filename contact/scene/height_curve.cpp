#include "contact/scene/height_curve.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace rollfem::contact {

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
  const auto above = std::upper_bound(y_.begin() + 1, y_.end() - 1, y);
  const auto k = static_cast<std::size_t>(above - y_.begin()) - 1;
  const double h = y_[k + 1] - y_[k];
  const double t = (y - y_[k]) / h;
  // Newton's form of the cubic: chord, then what the slopes at both ends say beyond it.
  const double chord = (z_[k + 1] - z_[k]) / h;
  const double left = slope_[k] - chord;
  const double right = slope_[k + 1] - chord;
  const double sum = left + right;
  CurveValue result;
  result.value = z_[k] + h * t * (chord + (1.0 - t) * (left - t * sum));
  result.slope = chord + left * (1.0 - 2.0 * t) - sum * t * (2.0 - 3.0 * t);
  result.second = (-2.0 * left - sum * (2.0 - 6.0 * t)) / h;
  return result;
}

}  // namespace rollfem::contact
