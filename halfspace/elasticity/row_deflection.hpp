// SPDX-License-Identifier: LGPL-2.1-or-later
// What a row of elements along rolling under a semi-elliptic pressure deflects beside itself.
#pragma once

namespace rollfem::halfspace {

/// G(t), the integral over |u| < 1 of sqrt(1 - u^2) / sqrt(u^2 + t^2): a row of half length a and
/// of unit pressure in its middle deflects the half-space by G(s / a) / (pi E*) of its width, at a
/// distance s beside its middle. From a table over ln t, to 1e-3 of itself.
double row_deflection(double t);

}  // namespace rollfem::halfspace
