// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/iteration/yielding.hpp"

namespace rollfem::contact {

PlasticDisplacement yielding(const Plasticity& layer, const YieldStep& step) {
  const double stress = layer.yield_stress + layer.hardening * step.before;
  if (step.friction <= stress) return {step.before};
  double part = 1.0, part_by_stress = 0.0;
  if (step.friction_ahead < stress) {
    const double rise =
        (step.friction - step.friction_ahead) * (step.friction + step.friction_ahead);
    part = (step.friction - stress) * (step.friction + stress) / rise;
    part_by_stress = -2.0 * stress / rise;
  }
  const double own = step.way * part * (1.0 - 0.5 * part);
  const double ahead = step.way * 0.5 * part * part;
  const double by_part = step.way * ((1.0 - part) * step.slip + part * step.slip_ahead);
  return {step.before + own * step.slip + ahead * step.slip_ahead, own, ahead,
          1.0 + by_part * part_by_stress * layer.hardening};
}

}  // namespace rollfem::contact
