// SPDX-License-Identifier: LGPL-2.1-or-later
// Named strings, numbers and matrices in one HDF5 file with a checksum (seal.hpp): internal data of
// the program in a readable format.
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

/// Writes or replaces a file atomically; several processes may do so at once. Throws
/// contact::InputError with file and reason.
void write_named_values(const std::filesystem::path& path, const NamedValues& values);

/// Empty if the file is damaged, has no checksum, or is not an HDF5 file.
std::optional<NamedValues> read_named_values(const std::filesystem::path& path);

}  // namespace rollfem::postprocess
