// SPDX-License-Identifier: LGPL-2.1-or-later
// How a layer between the bodies yields (Plasticity) while a particle moves from one contact
// element to the next, or in a step of a history: the plastic displacement u* that it has gathered.
#pragma once

#include "contact/scene/friction_law.hpp"

namespace rollfem::contact {

/// What a particle meets on its way to an element, and the motion there.
struct YieldStep {
  double before = 0.0;          ///< u* at the beginning, mm
  double way = 0.0;             ///< mm rolled, 1 in a shift
  double slip = 0.0;            ///< |w| at the end, as results give it
  double slip_ahead = 0.0;      ///< the same at the beginning
  double friction = 0.0;        ///< mu p_n at rest at the end, MPa
  double friction_ahead = 0.0;  ///< the same at the beginning; as at the end: only the end counts
};

/// u* at the end if the layer yields there, with derivatives.
struct PlasticDisplacement {
  double value = 0.0;  ///< mm
  double by_slip = 0.0;
  double by_slip_ahead = 0.0;
  double by_before = 1.0;
};

/// u* grows by the integral of |w| (trapezoidal rule: second order) over the part of the way in
/// which the yield stress is below the friction. The square of the friction is taken as linear over
/// the way, which pressures are at the edge of the patch.
PlasticDisplacement yielding(const Plasticity& layer, const YieldStep& step);

}  // namespace rollfem::contact
