// SPDX-License-Identifier: LGPL-2.1-or-later
// table.h5 and table.csv: what `rollfem table` writes, and the table from its HDF5 file again.
#pragma once

#include "tables/files/creep_table.hpp"

#include <string>

namespace rollfem::tables {

/// The bytes of table.h5, which describes itself and begins with its checksum (seal.hpp).
std::string table_hdf5(const CreepTable& table);

/// One row for each point: axes, forces, bars.
std::string table_csv(const CreepTable& table);
/// One row for each point at which interpolation was looked at.
std::string interpolation_csv(const CreepTable& table);
/// Of a table over lateral shifts: one row for each, with the wheel's contact.
std::string shifts_csv(const CreepTable& table);

/// A file table.h5, or the folder that holds it. Throws contact::InputError for one that is none,
/// or damaged.
CreepTable read_table(const std::string& path);

}  // namespace rollfem::tables
