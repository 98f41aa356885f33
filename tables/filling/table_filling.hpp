// SPDX-License-Identifier: LGPL-2.1-or-later
// The axes of a table, from the section [table] of a case, and its points, solved on all cores;
// finished parts survive an interrupted run.
#pragma once

#include "contact/base/checkpoint.hpp"
#include "contact/base/progress.hpp"
#include "contact/base/share.hpp"
#include "contact/case/case.hpp"
#include "tables/files/creep_table.hpp"

#include <string>

namespace rollfem::tables {

/// A table with axes but without forces; over lateral shifts also without wheels and scales, which
/// tables/filling/wheel_source.cpp computes. Throws contact::InputError if a list does not
/// increase, the materials are unlike, there is no ellipse for the axis ratio, or no single wheel
/// to shift.
CreepTable empty_table(const contact::Case& input);

/// Names the keys of the case that its table does not use, in one sentence; empty if there are
/// none.
std::string ignored_keys(const contact::Case& input);

/// CreepTable::scale of an axis ratio: C11/3, C22/3 and sqrt(C23^2 + C33^2).
Scaled scale_of_ratio(double axis_ratio, double poisson_ratio);

/// Fills forces, bars and elements_across of an empty_table, over lateral shifts first its wheels
/// and scales, and then checks interpolation at the number of random points in the case and, with a
/// fourth as many each, along every axis. Reports the expected time beforehand as a progress event.
/// `checkpoint` may be null. Values depend neither on resumed points nor on the number of threads.
/// With a `share`, only that part of the points is solved and stored for the merging call, and the
/// table stays incomplete. Throws contact::SolveError if a point does not converge or a wheel does
/// not touch.
void fill_table(CreepTable& table, const contact::Case& input, const contact::Progress& progress,
                contact::Checkpoint* checkpoint, contact::Share share = {});

}  // namespace rollfem::tables
