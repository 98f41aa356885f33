// SPDX-License-Identifier: LGPL-2.1-or-later
// Solves the points of a table on all cores; finished parts survive an interrupted run.
#pragma once

#include "base/checkpoint.hpp"
#include "base/progress.hpp"
#include "case/case.hpp"
#include "contact/solve/run_part.hpp"
#include "tables/files/creep_table.hpp"

namespace rollfem::tables {

/// Fills forces, bars and elements_across of an empty_table, over lateral shifts first its wheels
/// and scales, and then checks interpolation at the number of random points in the case and, with a
/// fourth as many each, along every axis. Reports the expected time beforehand as a progress event.
/// `checkpoint` may be null. Values depend neither on resumed points nor on the number of threads.
/// With an `own` part, only that part of the points is solved and stored for the merging call, and
/// the table stays incomplete. Throws contact::SolveError if a point does not converge or a wheel
/// does not touch.
void fill_table(CreepTable& table, const contact::Case& input, const contact::Progress& progress,
                contact::Checkpoint* checkpoint, contact::RunPart own = {});

}  // namespace rollfem::tables
