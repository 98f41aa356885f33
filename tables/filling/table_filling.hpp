// SPDX-License-Identifier: LGPL-2.1-or-later
// Solving the points of a table on all cores; finished parts outlive a run that is ended.
#pragma once

#include "contact/base/checkpoint.hpp"
#include "contact/base/progress.hpp"
#include "contact/base/share.hpp"
#include "contact/case/case.hpp"
#include "tables/files/creep_table.hpp"

namespace rollfem::tables {

/// Fills forces, bars and elements_across of a table with its axes (tables/filling/table_grid.hpp),
/// over lateral shifts its wheels and scales before, then looks at interpolation at as many points
/// at random as the case asks for. `checkpoint` may be null. Numbers do not depend on what was
/// taken up from it, nor on the number of threads. A `share` of the points is solved and kept for
/// the call that finds all of them, nothing else; the table is then no table. Throws
/// contact::SolveError where a point does not converge or a wheel does not touch.
void fill_table(CreepTable& table, const contact::Case& input, const contact::Progress& progress,
                contact::Checkpoint* checkpoint, contact::Share share = {});

}  // namespace rollfem::tables
