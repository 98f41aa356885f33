// SPDX-License-Identifier: LGPL-2.1-or-later
// The conditions of contact element by element, where fields come from an iteration that ends when
// the displacement changes by less than 1e-4 of itself.
#pragma once

#include "result/result.hpp"

#include "support/test.hpp"

namespace rollfem::testing {

inline void expect_contact_laws(const contact::PointResult& point, double friction, double p0) {
  const contact::ContactFields& f = point.fields;
  for (Eigen::Index k = 0; k < f.gap.size(); ++k) {
    EXPECT_GE(f.traction.n[k], 0.0);
    EXPECT_GE(f.gap[k], -1e-4 * point.approach);
    EXPECT_LE(f.traction.n[k] > 0.0 ? f.gap[k] : 0.0, 1e-4 * point.approach);
    const contact::ElementState state = f.state[static_cast<std::size_t>(k)];
    const double size = std::hypot(f.traction.x[k], f.traction.y[k]);
    EXPECT_LE(size, friction * (f.traction.n[k] + 1e-5 * p0));
    const double slip = std::hypot(f.slip.x[k], f.slip.y[k]);
    EXPECT_LT(state == contact::ElementState::adhesion ? slip : 0.0, 1e-5);
    const bool slips = state == contact::ElementState::slip;
    EXPECT_GE(size, slips ? friction * (0.999 * f.traction.n[k] - 1e-4 * p0) : 0.0);
  }
}

}  // namespace rollfem::testing
