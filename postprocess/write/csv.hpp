// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables for spreadsheets: creep curves and path plots of all models, one
// file each, with units in the column headers.
#pragma once

#include "postprocess/write/output.hpp"

#include <string>

namespace rollfem::postprocess {

/// One row per model and load point with all scalars.
std::string creep_curve_csv(const RunRecord& run);

enum class Path { x, y };

/// Tractions, bound, slip and gap along the middle line of the grid for every model and load point.
/// The line of path x runs through the elements nearest to y = 0; when two rows are equally near,
/// their mean is taken (path y alike). What a model does not give is an empty cell.
std::string path_csv(const RunRecord& run, Path path);

/// Displacement, stress and its scalars at the points and along the lines below the surface that
/// the case asks for; empty when there are none. Planes are in results.h5 alone.
std::string subsurface_csv(const RunRecord& run);

/// The columns of place, displacement and stress of a point below the surface, with units, and the
/// values of point k: distance is that from the first point of the set.
std::string subsurface_columns();
std::string subsurface_row(const contact::SubsurfaceField& field, std::size_t k);

/// Where every patch is on track and profiles, and its main results: one row per patch, model and
/// load point. Empty without profiles.
std::string contacts_csv(const RunRecord& run);

/// A wheelset that is shifted sideways: one row per position, model and load point with geometry,
/// patches and forces of both wheels. Empty where RunRecord::wheelset is.
std::string wheelset_csv(const RunRecord& run);

/// The rigid wheelset over its lateral shift: what `rollfem wheelset` writes, and a run beside its
/// wheelset.csv.
std::string rigid_wheelset_csv(const std::vector<RigidWheelset>& rows);

/// The regions of contacts that fall into several; empty where none does.
std::string patches_csv(const RunRecord& run);

/// The one or two rows (or columns) of elements nearest to 0, for elements at first + k * step.
std::vector<int> middle_lines(double first, double step, int count);

}  // namespace rollfem::postprocess
