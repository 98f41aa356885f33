// SPDX-License-Identifier: LGPL-2.1-or-later
// Checksums by which a damaged result is told before anything in it is used. They tell damage, not
// malice.
//
// results.h5 begins with an HDF5 user block, which HDF5 libraries pass over: 512 bytes of text with
// size and CRC-32 of what follows. JSON files end with a member `checksum`: the CRC-32 of all the
// text before it. A file without one is of an earlier version, or of another program.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rollfem::postprocess {

/// Bytes of the user block before the HDF5 data.
inline constexpr std::size_t seal_size = 512;

/// The user block for this data.
std::string hdf5_seal(std::string_view data);

enum class Seal { intact, none, broken };

/// Looks at a file that should be results.h5, without HDF5. Throws contact::InputError when it
/// cannot be read or is no HDF5 file at all.
Seal check_hdf5_seal(const std::string& path);

/// The text of a JSON object with its checksum as the last member.
std::string sealed_json(std::string text);
Seal check_json_seal(std::string_view text);

}  // namespace rollfem::postprocess
