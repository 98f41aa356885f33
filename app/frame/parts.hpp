// SPDX-License-Identifier: LGPL-2.1-or-later
// Work that is divided among independent calls (--part, --merge) or the processes of mpirun: each
// keeps what it has solved beside the future result, and one call finds all of it and writes the
// result, equal to that of a single call to the last bit.
#pragma once

#include "contact/base/share.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace rollfem::app {

struct ComputingRequest;

/// Name of the record that a part leaves when it is done.
inline constexpr const char* part_done = "part-done";

/// Beside which a part keeps its work: the folder of the result itself when nothing is divided.
std::string part_directory(const std::filesystem::path& directory, contact::Share share);

/// "3/8": the third of eight parts. Throws contact::InputError.
contact::Share parse_part(const std::string& text);

/// Refuses --part with --merge, and either where there is nothing to divide: `items` of `kind`
/// ("positions of the wheelset"). Throws contact::InputError.
void check_division(const ComputingRequest& request, std::size_t items, const std::string& kind);

/// Calls `work` once, as it was asked. Under mpirun, where `divisible`, each process does its part
/// of it, and the first puts all together when it finds them done in `directory`.
void in_parts(ComputingRequest& request, bool divisible, const std::filesystem::path& directory,
              const std::function<void()>& work);

}  // namespace rollfem::app
