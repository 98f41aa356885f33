// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/hdf5/hdf5_objects.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace rollfem::result::hdf5 {
namespace {

[[noreturn]] void fail(const std::string& what, const std::string& name) {
  throw std::runtime_error(fmt::format("{} {}", what, name));
}

bool is_number(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  return kind == H5T_FLOAT || kind == H5T_INTEGER;
}

/// An attribute or a dataset with its type and shape.
struct Content {
  Handle object, type, space;

  bool is_text() const { return H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) > 0; }
  Shape shape() const {
    const int rank = H5Sget_simple_extent_ndims(space);
    Shape shape(static_cast<std::size_t>(std::max(rank, 0)));
    if (rank > 0) H5Sget_simple_extent_dims(space, shape.data(), nullptr);
    return shape;
  }
  hsize_t count() const {
    hsize_t count = 1;
    for (const hsize_t extent : shape()) count *= extent;
    return count;
  }
  bool read(hid_t wanted, void* values) const {
    return (H5Iget_type(object) == H5I_ATTR
                ? H5Aread(object, wanted, values)
                : H5Dread(object, wanted, H5S_ALL, H5S_ALL, H5P_DEFAULT, values)) >= 0;
  }
  /// Strings of variable length; false if they are unreadable. HDF5 owns them in memory.
  bool read(std::vector<std::string>& lines) const {
    const Handle wanted = text_type();
    std::vector<char*> texts(count());
    const bool readable = read(wanted, texts.data());
    for (const char* text : texts) lines.emplace_back(text == nullptr ? "" : text);
    H5Dvlen_reclaim(wanted, space, H5P_DEFAULT, texts.data());
    return readable;
  }
};

Content open_attribute(hid_t object, const std::string& name) {
  if (!has_attribute(object, name)) fail("there is no attribute", name);
  Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), "H5Aopen");
  Handle type(H5Aget_type(attribute), "H5Aget_type");
  Handle space(H5Aget_space(attribute), "H5Aget_space");
  return {std::move(attribute), std::move(type), std::move(space)};
}

Content open_dataset(hid_t parent, const std::string& name) {
  if (!has_member(parent, name)) fail("there is no dataset", name);
  const hid_t id = H5Dopen2(parent, name.c_str(), H5P_DEFAULT);
  if (id < 0) fail("there is no readable dataset", name);
  Handle dataset(id, "H5Dopen2");
  Handle type(H5Dget_type(dataset), "H5Dget_type");
  Handle space(H5Dget_space(dataset), "H5Dget_space");
  return {std::move(dataset), std::move(type), std::move(space)};
}

}  // namespace

File open_file(const std::string& path) {
  Alone alone;
  const hid_t id = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (id < 0) fail("HDF5 cannot open", path);
  return {std::move(alone), id, "H5Fopen"};
}

bool has_member(hid_t group, const std::string& name) {
  return H5Lexists(group, name.c_str(), H5P_DEFAULT) > 0;
}

bool has_attribute(hid_t object, const std::string& name) {
  return H5Aexists(object, name.c_str()) > 0;
}

Handle open_group(hid_t parent, const std::string& name) {
  if (!has_member(parent, name)) fail("there is no group", name);
  const hid_t id = H5Gopen2(parent, name.c_str(), H5P_DEFAULT);
  if (id < 0) fail("there is no readable group", name);
  return {id, "H5Gopen2"};
}

double read_number(hid_t object, const std::string& name) {
  const Content attribute = open_attribute(object, name);
  double value = 0.0;
  if (!is_number(attribute.type) || attribute.count() != 1 ||
      !attribute.read(H5T_NATIVE_DOUBLE, &value))
    fail("not one number: attribute", name);
  return value;
}

std::string read_text(hid_t object, const std::string& name) {
  const Content attribute = open_attribute(object, name);
  if (!attribute.is_text() || attribute.count() != 1) fail("not a string: attribute", name);
  std::vector<std::string> lines;
  if (!attribute.read(lines)) fail("unreadable attribute", name);
  return lines.front();
}

Numbers read_dataset(hid_t parent, const std::string& name) {
  const Content dataset = open_dataset(parent, name);
  if (!is_number(dataset.type)) fail("no numbers in dataset", name);
  Numbers numbers{dataset.shape(), std::vector<double>(dataset.count())};
  if (!numbers.values.empty() && !dataset.read(H5T_NATIVE_DOUBLE, numbers.values.data()))
    fail("damaged or truncated: dataset", name);
  return numbers;
}

template <std::size_t N>
std::vector<std::array<double, N>> read_rows(hid_t parent, const std::string& name) {
  const Numbers numbers = read_dataset(parent, name);
  if (numbers.shape.size() != 2 || numbers.shape[1] != N)
    fail(fmt::format("not {} numbers in a row: dataset", N), name);
  std::vector<std::array<double, N>> rows(numbers.shape[0]);
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (std::size_t c = 0; c < N; ++c) rows[k][c] = numbers.values[N * k + c];
  return rows;
}

template std::vector<std::array<double, 3>> read_rows(hid_t, const std::string&);

std::vector<std::string> read_lines(hid_t parent, const std::string& name) {
  const Content dataset = open_dataset(parent, name);
  if (!dataset.is_text()) fail("no text in dataset", name);
  std::vector<std::string> lines;
  if (dataset.count() > 0 && !dataset.read(lines)) fail("damaged or truncated: dataset", name);
  return lines;
}

}  // namespace rollfem::result::hdf5
