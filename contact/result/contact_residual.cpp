#include "contact/result/contact_residual.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

ContactResidual contact_residual(const ContactFields& fields) {
  ContactResidual residual;
  const Field& pressure = fields.traction.n;
  const Eigen::Index n = pressure.size();
  if (n == 0) return residual;
  if (fields.gap.size() == n && fields.displacement.n.size() == n) {
    double violation = 0.0;
    for (Eigen::Index k = 0; k < n; ++k)
      violation = std::max(violation, pressure[k] > 0.0 ? std::abs(fields.gap[k]) : -fields.gap[k]);
    const double displacement = fields.displacement.n.cwiseAbs().maxCoeff();
    if (violation > 0.0) residual.gap = violation / displacement;
  }
  const Field& bound = fields.traction_bound;
  if (bound.size() != n || fields.traction.x.size() != n || fields.traction.y.size() != n)
    return residual;
  double excess = 0.0;
  for (Eigen::Index k = 0; k < n; ++k)
    excess = std::max(excess, std::hypot(fields.traction.x[k], fields.traction.y[k]) - bound[k]);
  if (excess > 0.0) residual.excess = excess / bound.maxCoeff();
  return residual;
}

}  // namespace rollfem::contact
