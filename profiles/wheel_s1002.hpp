// SPDX-License-Identifier: LGPL-2.1-or-later
// The wheel profile S1002 as a curve.
#pragma once

#include "profiles/profile_curve.hpp"

namespace rollfem::profiles {

/// `smooth`: zone C is moved to its neighbours as a whole, by up to 1.2e-4 mm (within the
/// uncertainty of its printed digits), and the curvature follows the formulas. Otherwise the
/// formulas hold everywhere except within 0.23 mm about y = -35 and 0.31 mm about y = -26, where
/// their steps are blended.
ProfileCurve s1002(bool smooth);

}  // namespace rollfem::profiles
