// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/hdf5/named_values.hpp"

#include "postprocess/files/files_together.hpp"
#include "postprocess/files/seal.hpp"
#include "postprocess/hdf5/hdf5_objects.hpp"

#include <stdexcept>

namespace fs = std::filesystem;

namespace rollfem::postprocess {
namespace {

using ByRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::string image_of(const NamedValues& values) {
  const hdf5::File file = hdf5::create_file_in_memory();
  for (const auto& [name, text] : values.texts) hdf5::write_attribute(file, name, text);
  for (const auto& [name, number] : values.numbers) hdf5::write_attribute(file, name, number);
  for (const auto& [name, matrix] : values.matrices) {
    const ByRows by_rows = matrix;
    hdf5::write_dataset(file, name,
                        {static_cast<hsize_t>(matrix.rows()), static_cast<hsize_t>(matrix.cols())},
                        by_rows.data());
  }
  return hdf5::sealed_image(file);
}

NamedValues values_of(hid_t file) {
  NamedValues values;
  values.texts = hdf5::read_texts(file);
  values.numbers = hdf5::read_numbers(file);
  for (const std::string& name : hdf5::members(file)) {
    const hdf5::Numbers numbers = hdf5::read_dataset(file, name);
    if (numbers.shape.size() != 2) throw std::runtime_error("not a matrix: " + name);
    values.matrices[name] =
        Eigen::Map<const ByRows>(numbers.values.data(), static_cast<Eigen::Index>(numbers.shape[0]),
                                 static_cast<Eigen::Index>(numbers.shape[1]));
  }
  return values;
}

}  // namespace

void write_named_values(const fs::path& path, const NamedValues& values) {
  replace_file(path, image_of(values));
}

std::optional<NamedValues> read_named_values(const fs::path& path) {
  try {
    if (!hdf5_seal_is_intact(path.string())) return {};
    return values_of(hdf5::open_file(path.string()));
  } catch (const std::runtime_error&) {
    return {};
  }
}

}  // namespace rollfem::postprocess
