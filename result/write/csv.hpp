// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables for spreadsheets: creep curves and path plots of all models, one
// file each, with units in the column headers.
#pragma once

#include "result/write/columns.hpp"
#include "result/write/output.hpp"

#include <optional>
#include <string>

namespace rollfem::result {

/// A text that may hold commas, in quotation marks; an apostrophe goes before one that begins like
/// a formula of a spreadsheet.
std::string quoted(const std::string& text);

/// One row per model and load point with all scalars.
std::string creep_curve_csv(const RunRecord& run);

enum class Path { x, y };

/// Tractions, bound, slip and gap along a centre line of the grid for every model and load point.
/// Path x runs through the elements nearest to y = 0; if two rows are equally near, their mean is
/// used (likewise path y). Values that a model does not give are empty cells.
std::string path_csv(const RunRecord& run, Path path);

/// Displacement, stress and stress measures at the requested points and lines below the surface;
/// empty without requests. Planes are only in results.h5.
std::string subsurface_csv(const RunRecord& run);

/// Place of every patch on track and profiles with its main results: one row per patch, model and
/// load point. Empty without profiles.
std::string contacts_csv(const RunRecord& run);

/// A lateral sweep of a wheelset: one row per position, model and load point with geometry, patches
/// and forces of both wheels. Empty if RunRecord::wheelset is.
std::string wheelset_csv(const RunRecord& run);

/// The rigid wheelset over its lateral shift, written by `rollfem wheelset` and by a run beside its
/// wheelset.csv.
const Columns<RigidWheelset>& rigid_wheelset_columns();

/// The regions of contacts with several regions; empty if there are none.
std::string patches_csv(const RunRecord& run);

/// Frictional work per pass over the profiles: a row per model, load point and row of the grid that
/// slips; empty if nothing does.
std::string pass_work_csv(const RunRecord& run);

/// The one or two rows (or columns) of elements nearest to 0, for elements at first + k * step.
std::vector<int> middle_lines(double first, double step, int count);

}  // namespace rollfem::result
