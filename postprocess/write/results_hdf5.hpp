// SPDX-License-Identifier: LGPL-2.1-or-later
// results.h5: grid, fields per load point, scalars and provenance, self-describing (units, signs
// and descriptions are attributes and comments). Layout: docs/results.md.
#pragma once

#include "postprocess/write/output.hpp"

#include <string>

namespace rollfem::postprocess {

/// Raised when names or meanings change: a reader of an earlier one must refuse the file.
inline constexpr int hdf5_format_version = 2;
/// Raised when something is added, which a reader of the version may ignore.
inline constexpr int hdf5_format_minor = 0;

/// The bytes of results.h5. The file is made in memory: HDF5 cannot fail on a full disk half-way,
/// and bytes are written like those of every other file. The record must have passed check_record.
std::string results_hdf5(const RunRecord& run);

}  // namespace rollfem::postprocess
