// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/hdf5/hdf5_objects.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace rollfem::postprocess::hdf5 {
namespace {

/// Suppresses HDF5's own text on stderr; failures become exceptions.
class Silence {
 public:
  Silence() {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Silence() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

[[noreturn]] void fail(const std::string& what, const std::string& name) {
  throw std::runtime_error(fmt::format("{} {}", what, name));
}

/// Strings of variable length in memory owned by the HDF5 library.
class Texts {
 public:
  Texts(hid_t type, hid_t space, std::size_t count) : type_(type), space_(space), data_(count) {}
  ~Texts() { H5Dvlen_reclaim(type_, space_, H5P_DEFAULT, data_.data()); }
  Texts(const Texts&) = delete;
  Texts& operator=(const Texts&) = delete;
  void* data() { return data_.data(); }
  std::vector<std::string> lines() const {
    std::vector<std::string> out;
    for (const char* text : data_) out.emplace_back(text == nullptr ? "" : text);
    return out;
  }

 private:
  hid_t type_;
  hid_t space_;
  std::vector<char*> data_;
};

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), "H5Tcopy");
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

bool is_text(hid_t type) {
  return H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) > 0;
}

bool is_number(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  return kind == H5T_FLOAT || kind == H5T_INTEGER;
}

std::vector<hsize_t> shape_of(hid_t space) {
  const int rank = H5Sget_simple_extent_ndims(space);
  std::vector<hsize_t> shape(static_cast<std::size_t>(std::max(rank, 0)));
  if (rank > 0) H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  return shape;
}

hsize_t count_of(const std::vector<hsize_t>& shape) {
  hsize_t count = 1;
  for (const hsize_t extent : shape) count *= extent;
  return count;
}

Handle open_attribute(hid_t object, const std::string& name) {
  if (!has_attribute(object, name)) fail("there is no attribute", name);
  return {H5Aopen(object, name.c_str(), H5P_DEFAULT), "H5Aopen"};
}

Handle open_dataset(hid_t parent, const std::string& name) {
  const Silence silence;
  if (!has_member(parent, name)) fail("there is no dataset", name);
  const hid_t id = H5Dopen2(parent, name.c_str(), H5P_DEFAULT);
  if (id < 0) fail("there is no readable dataset", name);
  return {id, "H5Dopen2"};
}

herr_t keep_name(hid_t /*group*/, const char* name, const H5L_info_t* /*info*/, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

herr_t keep_attribute(hid_t /*object*/, const char* name, const H5A_info_t* /*info*/, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

}  // namespace

File open_file(const std::string& path) {
  File::Alone alone = File::alone();
  const Silence silence;
  const hid_t id = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (id < 0) fail("HDF5 cannot open", path);
  return {std::move(alone), id, "H5Fopen"};
}

bool has_member(hid_t group, const std::string& name) {
  const Silence silence;
  return H5Lexists(group, name.c_str(), H5P_DEFAULT) > 0;
}

bool has_attribute(hid_t object, const std::string& name) {
  const Silence silence;
  return H5Aexists(object, name.c_str()) > 0;
}

std::vector<std::string> members(hid_t group) {
  const Silence silence;
  std::vector<std::string> names;
  hsize_t at = 0;
  if (H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, &at, keep_name, &names) < 0)
    fail("there is no readable", "list of members");
  return names;
}

Handle open_group(hid_t parent, const std::string& name) {
  const Silence silence;
  if (!has_member(parent, name)) fail("there is no group", name);
  const hid_t id = H5Gopen2(parent, name.c_str(), H5P_DEFAULT);
  if (id < 0) fail("there is no readable group", name);
  return {id, "H5Gopen2"};
}

double read_number(hid_t object, const std::string& name) {
  const Silence silence;
  const Handle attribute = open_attribute(object, name);
  const Handle type(H5Aget_type(attribute), "H5Aget_type");
  const Handle space(H5Aget_space(attribute), "H5Aget_space");
  double value = 0.0;
  if (!is_number(type) || count_of(shape_of(space)) != 1 ||
      H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0)
    fail("not one number: attribute", name);
  return value;
}

std::string read_text(hid_t object, const std::string& name) {
  const Silence silence;
  const Handle attribute = open_attribute(object, name);
  const Handle type(H5Aget_type(attribute), "H5Aget_type");
  const Handle space(H5Aget_space(attribute), "H5Aget_space");
  if (!is_text(type) || count_of(shape_of(space)) != 1) fail("not a string: attribute", name);
  const Handle wanted = text_type();
  Texts texts(wanted, space, 1);
  if (H5Aread(attribute, wanted, texts.data()) < 0) fail("unreadable attribute", name);
  return texts.lines().front();
}

namespace {

std::vector<std::string> attribute_names(hid_t object) {
  std::vector<std::string> names;
  hsize_t at = 0;
  if (H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &at, keep_attribute, &names) < 0)
    fail("there is no readable", "list of attributes");
  return names;
}

}  // namespace

std::map<std::string, std::string> read_texts(hid_t object) {
  const Silence silence;
  std::map<std::string, std::string> texts;
  for (const std::string& name : attribute_names(object)) {
    const Handle attribute = open_attribute(object, name);
    const Handle type(H5Aget_type(attribute), "H5Aget_type");
    if (!is_number(type)) texts[name] = read_text(object, name);
  }
  return texts;
}

std::map<std::string, double> read_numbers(hid_t object) {
  const Silence silence;
  std::map<std::string, double> numbers;
  for (const std::string& name : attribute_names(object)) {
    const Handle attribute = open_attribute(object, name);
    const Handle type(H5Aget_type(attribute), "H5Aget_type");
    if (is_number(type)) numbers[name] = read_number(object, name);
  }
  return numbers;
}

Numbers read_dataset(hid_t parent, const std::string& name) {
  const Silence silence;
  const Handle dataset = open_dataset(parent, name);
  const Handle type(H5Dget_type(dataset), "H5Dget_type");
  const Handle space(H5Dget_space(dataset), "H5Dget_space");
  if (!is_number(type)) fail("no numbers in dataset", name);
  Numbers numbers;
  numbers.shape = shape_of(space);
  numbers.values.resize(count_of(numbers.shape));
  if (!numbers.values.empty() &&
      H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.values.data()) < 0)
    fail("damaged or truncated: dataset", name);
  return numbers;
}

template <std::size_t N, class Number>
std::vector<std::array<Number, N>> read_rows(hid_t parent, const std::string& name) {
  const Numbers numbers = read_dataset(parent, name);
  if (numbers.shape.size() != 2 || numbers.shape[1] != N)
    fail(fmt::format("not {} numbers in a row: dataset", N), name);
  std::vector<std::array<Number, N>> rows(numbers.shape[0]);
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (std::size_t c = 0; c < N; ++c) rows[k][c] = static_cast<Number>(numbers.values[N * k + c]);
  return rows;
}

template std::vector<std::array<double, 3>> read_rows(hid_t, const std::string&);
template std::vector<std::array<double, 8>> read_rows(hid_t, const std::string&);
template std::vector<std::array<float, 3>> read_rows(hid_t, const std::string&);
template std::vector<std::array<float, 6>> read_rows(hid_t, const std::string&);

std::vector<std::string> read_lines(hid_t parent, const std::string& name) {
  const Silence silence;
  const Handle dataset = open_dataset(parent, name);
  const Handle type(H5Dget_type(dataset), "H5Dget_type");
  const Handle space(H5Dget_space(dataset), "H5Dget_space");
  if (!is_text(type)) fail("no text in dataset", name);
  const hsize_t count = count_of(shape_of(space));
  if (count == 0) return {};
  const Handle wanted = text_type();
  Texts texts(wanted, space, count);
  if (H5Dread(dataset, wanted, H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()) < 0)
    fail("damaged or truncated: dataset", name);
  return texts.lines();
}

}  // namespace rollfem::postprocess::hdf5
