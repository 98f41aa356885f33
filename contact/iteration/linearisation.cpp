// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/iteration/linearisation.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Shift in adhesion that keeps the inverse bounded where the symbol of T almost vanishes, as for
/// tractions that alternate from row to row.
constexpr double least_shift = 1e-3;

}  // namespace

ContactElements::ContactElements(const Field& bound) : grid_size_(bound.size()) {
  for (Index k = 0; k < bound.size(); ++k)
    if (bound[k] > 0.0) places_.push_back(k);
}

VectorXd ContactElements::gathered(const TangentialField& field) const {
  VectorXd values(2 * count());
  for (Index e = 0; e < count(); ++e) {
    values[e] = field.x[(*this)[e]];
    values[count() + e] = field.y[(*this)[e]];
  }
  return values;
}

TangentialField ContactElements::scattered(const VectorXd& values) const {
  TangentialField field{Field::Zero(grid_size_), Field::Zero(grid_size_)};
  for (Index e = 0; e < count(); ++e) {
    field.x[(*this)[e]] = values[e];
    field.y[(*this)[e]] = values[count() + e];
  }
  return field;
}

JacobianInverse::JacobianInverse(const TangentialOperator& compliance,
                                 const ContactElements& elements, double r, double drag,
                                 const Linearisation& at)
    : compliance_(compliance),
      elements_(elements),
      at_(at),
      r_(r),
      drag_(drag),
      slipping_(std::count(at.adheres.begin(), at.adheres.end(), 0)) {
  if (slipping_ == 0) return;
  const Index count = elements_.count();
  scale_ = VectorXd::Ones(count);
  double logarithms = 0.0;
  for (Index e = 0; e < count; ++e) {
    if (at_.adheres[static_cast<std::size_t>(e)]) continue;
    scale_[e] = std::max(1.0 / at_.factor[e] - 1.0, least_shift);
    logarithms += std::log2(scale_[e]);
  }
  // A power of two, so that the next step may reuse the shift and its inverse.
  damping_ = std::exp2(std::round(logarithms / static_cast<double>(slipping_)));
  scale_ = ((1.0 + damping_) / (1.0 + scale_.array())).sqrt();
}

VectorXd JacobianInverse::times(const VectorXd& p) const {
  VectorXd result = adhering(p);
  if (slipping_ > 0) add_across(p, result);
  return result;
}

VectorXd JacobianInverse::times_adhesion(const VectorXd& p) const {
  VectorXd result = adhering(p);
  const Index count = elements_.count();
  for (Index e = 0; e < count; ++e) {
    if (at_.adheres[static_cast<std::size_t>(e)]) continue;
    result[e] = p[e];
    result[count + e] = p[count + e];
  }
  return result;
}

/// The circulant where elements adhere, the part along the slip where they slip.
VectorXd JacobianInverse::adhering(const VectorXd& p) const {
  const Index count = elements_.count();
  VectorXd result = p;
  if (slipping_ < count) {
    for (Index e = 0; e < count; ++e)
      if (!at_.adheres[static_cast<std::size_t>(e)]) result[e] = result[count + e] = 0.0;
    result = elements_.gathered(
        compliance_.precondition(elements_.scattered(result), r_, least_shift + drag_));
  }
  for (Index e = 0; e < count; ++e) {
    if (at_.adheres[static_cast<std::size_t>(e)]) continue;
    const Index f = count + e;
    const double along = at_.normal[e] * p[e] + at_.normal[f] * p[f];
    result[e] = at_.normal[e] * along;
    result[f] = at_.normal[f] * along;
  }
  return result;
}

void JacobianInverse::add_across(const VectorXd& p, VectorXd& result) const {
  const Index count = elements_.count();
  const VectorXd known = r_ * elements_.gathered(compliance_.apply(elements_.scattered(result)));
  VectorXd rest = VectorXd::Zero(2 * count);
  for (Index e = 0; e < count; ++e) {
    if (at_.adheres[static_cast<std::size_t>(e)]) continue;
    const Index f = count + e;
    const double x = p[e] / at_.factor[e] - known[e];
    const double y = p[f] / at_.factor[e] - known[f];
    const double across = scale_[e] * (at_.normal[e] * y - at_.normal[f] * x);
    rest[e] = -at_.normal[f] * across;
    rest[f] = at_.normal[e] * across;
  }
  rest =
      elements_.gathered(compliance_.precondition(elements_.scattered(rest), r_, damping_ + drag_));
  for (Index e = 0; e < count; ++e) {
    if (at_.adheres[static_cast<std::size_t>(e)]) continue;
    const Index f = count + e;
    const double across = scale_[e] * (at_.normal[e] * rest[f] - at_.normal[f] * rest[e]);
    result[e] -= at_.normal[f] * across;
    result[f] += at_.normal[e] * across;
  }
}

VectorXd full_adhesion(const TangentialOperator& compliance, const ContactElements& elements,
                       double r, const VectorXd& p) {
  return elements.gathered(compliance.precondition(elements.scattered(p), r, least_shift));
}

}  // namespace rollfem::contact
