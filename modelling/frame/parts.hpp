// SPDX-License-Identifier: LGPL-2.1-or-later
// Work divided among independent calls (--part, --merge) or the processes of mpirun: each stores
// its solutions beside the future result, and one call collects them and writes the result,
// identical to the last bit to that of a single call.
#pragma once

#include "contact/solve/run_part.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace rollfem::modelling {

struct Computing;

/// Name of the record that marks a finished part.
inline constexpr const char* part_done = "part-done";

/// Folder beside which a part stores its work; the result folder itself if nothing is divided.
std::string part_directory(const std::filesystem::path& directory, contact::RunPart own);

/// "3/8": the third of eight parts. Throws contact::InputError.
contact::RunPart parse_part(const std::string& text);

/// Refuses --part together with --merge, and either one if there is nothing to divide: `items` of
/// `kind` ("positions of the wheelset"). Throws contact::InputError.
void check_division(const Computing& request, std::size_t items, const std::string& kind);

/// Calls `work` once. Under mpirun, if `divisible`, each process does its part, and the first
/// merges the parts once all are done in `directory`.
void in_parts(Computing& request, bool divisible, const std::filesystem::path& directory,
              const std::function<void()>& work);

}  // namespace rollfem::modelling
