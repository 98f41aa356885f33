// SPDX-License-Identifier: LGPL-2.1-or-later
// Checksums that detect a damaged result before anything in it is used. They detect damage, not
// manipulation.
//
// results.h5 begins with an HDF5 user block, which HDF5 libraries skip: 512 bytes of text with size
// and CRC-32 of the data that follow. JSON files end with a member `checksum`: the CRC-32 of all
// the text before it. A file without a checksum counts as damaged: its head may be cut off.
// Records, which only the program itself reads, begin with 16 hexadecimal digits.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace rollfem::result {

/// Bytes of the user block before the HDF5 data.
inline constexpr std::size_t seal_size = 512;

/// The user block for this data.
std::string hdf5_seal(std::string_view data);

/// Whether the checksum of a file that should be results.h5 is there and right, without using HDF5,
/// which may crash on a damaged file. Throws contact::FileError with the advice `action` if it
/// cannot be read or is not an HDF5 file.
bool hdf5_seal_is_intact(const std::string& path, const std::string& action);

/// The text of a JSON object with its checksum as the last member.
std::string sealed_json(std::string text);

/// A record behind a checksum that binds it to where it belongs, such as a program, a case and a
/// name; anywhere else it counts as damaged.
std::string sealed_record(std::string_view place, std::string_view record);
/// Empty if the record is damaged or belongs elsewhere.
std::optional<std::string> opened_record(std::string_view place, const std::string& bytes);

}  // namespace rollfem::result
