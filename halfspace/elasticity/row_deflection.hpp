// SPDX-License-Identifier: LGPL-2.1-or-later
// Deflection beside a row of elements along rolling under a semi-elliptic pressure.
#pragma once

namespace rollfem::halfspace {

/// G(t), the integral over |u| < 1 of sqrt(1 - u^2) / sqrt(u^2 + t^2): at lateral distance s from
/// its middle, a row of half length a with unit pressure in its middle deflects the half-space by
/// G(s / a) / (pi E*) times its width. From a table over ln t, with relative accuracy 1e-3.
double row_deflection(double t);

}  // namespace rollfem::halfspace
