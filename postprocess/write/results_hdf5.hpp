// SPDX-License-Identifier: LGPL-2.1-or-later
// results.h5: grid, fields per load point, scalars and provenance, self-describing (units, signs
// and descriptions are attributes and comments). Layout: docs/results.md.
#pragma once

#include "postprocess/write/output.hpp"

#include <string>

namespace rollfem::postprocess {

/// Incremented when names or meanings change; readers of an earlier version must refuse the file.
inline constexpr int hdf5_format_version = 2;
/// Incremented when something is added; readers of the version may ignore it.
inline constexpr int hdf5_format_minor = 0;

/// The bytes of results.h5. The file is created in memory, so that HDF5 cannot fail half-way on a
/// full disk and the bytes are written like those of other files. The record must have passed
/// check_record.
std::string results_hdf5(const RunRecord& run);

}  // namespace rollfem::postprocess
