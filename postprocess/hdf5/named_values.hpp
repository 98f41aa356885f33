// SPDX-License-Identifier: LGPL-2.1-or-later
// Named strings, numbers and matrices in one HDF5 file with a checksum (seal.hpp): data that
// the program stores for itself and that anyone can read.
#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace rollfem::postprocess {

struct NamedValues {
  std::map<std::string, std::string> texts;
  std::map<std::string, double> numbers;
  std::map<std::string, Eigen::MatrixXd> matrices;
};

/// Writes a file, whole or not at all, in place of one that may be there; several processes may do
/// it at once. Throws contact::InputError naming file and reason.
void write_named_values(const std::filesystem::path& path, const NamedValues& values);

/// Nothing where the file is damaged, has no checksum, or is no HDF5 file.
std::optional<NamedValues> read_named_values(const std::filesystem::path& path);

}  // namespace rollfem::postprocess
