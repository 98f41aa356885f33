// SPDX-License-Identifier: LGPL-2.1-or-later
// The axes of a table, from the section [table] of a case.
#pragma once

#include "case/case.hpp"
#include "tables/files/creep_table.hpp"

#include <string>

namespace rollfem::tables {

/// A table with axes but without forces; over lateral shifts also without wheels and scales, which
/// table_source.cpp computes. Throws contact::InputError if a list does not
/// increase, the materials are unlike, there is no ellipse for the axis ratio, or no single wheel
/// to shift.
CreepTable empty_table(const contact::Case& input);

/// Names the keys of the case that its table does not use, in one sentence; empty if there are
/// none.
std::string ignored_keys(const contact::Case& input);

/// CreepTable::scale of an axis ratio: C11/3, C22/3 and sqrt(C23^2 + C33^2).
Scaled scale_of_ratio(double axis_ratio, double poisson_ratio);

}  // namespace rollfem::tables
