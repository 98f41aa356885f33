// results.h5: grid, fields per load point, scalars and provenance, self-describing (units, signs
// and descriptions are attributes and comments). Layout: docs/results.md.
#pragma once

#include "postprocess/output.hpp"

#include <string>

namespace rollfem::postprocess {

inline constexpr int hdf5_format_version = 1;

/// The bytes of results.h5. The file is made in memory: HDF5 cannot fail on a full disk half-way,
/// and bytes are written like those of every other file. The record must have passed check_record.
std::string results_hdf5(const RunRecord& run);

}  // namespace rollfem::postprocess
