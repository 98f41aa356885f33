// SPDX-License-Identifier: LGPL-2.1-or-later
// table.h5 and table.csv, the files of `rollfem table`: writing both, reading table.h5.
#pragma once

#include "tables/files/creep_table.hpp"

#include <string>

namespace rollfem::tables {

/// The bytes of table.h5, a self-describing file that begins with its checksum (seal.hpp).
std::string table_hdf5(const CreepTable& table);

/// One row for each point: axes, forces, bars.
std::string table_csv(const CreepTable& table);
/// One row for each point at which interpolation was checked.
std::string interpolation_csv(const CreepTable& table);
/// For a table over lateral shifts: one row per load and shift, with the wheel's contact.
std::string shifts_csv(const CreepTable& table);

/// Reads a file table.h5, or the one in a folder. Throws contact::InputError if it is no table or
/// damaged.
CreepTable read_table(const std::string& path);

}  // namespace rollfem::tables
