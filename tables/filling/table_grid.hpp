// SPDX-License-Identifier: LGPL-2.1-or-later
// The axes of a table, from the section [table] of a case.
#pragma once

#include "contact/case/case.hpp"
#include "tables/files/creep_table.hpp"

namespace rollfem::tables {

/// A table without forces, over lateral shifts also without wheels and scales, which
/// tables/filling/wheel_source.cpp finds. Throws contact::InputError where the lists do not
/// increase, the bodies are of unlike materials, there is no ellipse whose ratio could be taken, or
/// no single wheel that could be shifted.
CreepTable empty_table(const contact::Case& input);

/// C11/3, C22/3 and sqrt(C23^2 + C33^2) of the ratio: CreepTable::scale.
Scaled scale_of_ratio(double axis_ratio, double poisson_ratio);

}  // namespace rollfem::tables
