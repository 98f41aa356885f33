// SPDX-License-Identifier: LGPL-2.1-or-later
// Places beside a solved patch where wheel and rail touch again or nearly do.
#pragma once

#include "contact/base/grid.hpp"
#include "halfspace/patch/ridge.hpp"

namespace rollfem::halfspace {

/// Normal displacement at (x, y) by pressure elsewhere on the grid, with each element as a point
/// load on the half-space of this contact modulus, mm.
double displacement_beside(double x, double y, const contact::ContactGrid& grid,
                           const contact::Field& pressure, double modulus);

/// `patch`, extended to the places beside it where the gap falls again and the bodies would overlap
/// at this approach (mm) if half-spaces were not displaced there: finite bodies may be displaced by
/// far less than half-spaces, or the other way.
Box with_near_misses(const Box& patch, const Ridge& ridge, double approach,
                     const contact::ContactGrid& grid, const contact::Field& pressure,
                     double modulus);

}  // namespace rollfem::halfspace
