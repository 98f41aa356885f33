// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/hdf5/hdf5_objects.hpp"

#include "result/files/seal.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace rollfem::result::hdf5 {
namespace {

[[noreturn]] void fail(const char* call) {
  throw std::runtime_error(std::string("HDF5: ") + call + " failed");
}

void check(herr_t status, const char* call) {
  if (status < 0) fail(call);
}

void write_scalar_attribute(hid_t object, const std::string& name, hid_t type, const void* value) {
  const Handle space(H5Screate(H5S_SCALAR), "H5Screate");
  const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                         "H5Acreate2");
  check(H5Awrite(attribute, type, value), "H5Awrite");
}

/// A small buffer: by default HDF5 zeroes two buffers of a megabyte for every line of text.
Handle transfer_of_text() {
  constexpr std::size_t bytes = 1U << 14U;
  Handle transfer(H5Pcreate(H5P_DATASET_XFER), "H5Pcreate");
  check(H5Pset_buffer(transfer, bytes, nullptr, nullptr), "H5Pset_buffer");
  return transfer;
}

}  // namespace

Handle write_dataset(hid_t parent, const std::string& name, const Shape& shape, hid_t type,
                     const void* values, hid_t transfer) {
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                     "H5Screate_simple");
  const Handle options(H5Pcreate(H5P_DATASET_CREATE), "H5Pcreate");
  // Without time stamps, so that equal results give equal bytes.
  check(H5Pset_obj_track_times(options, false), "H5Pset_obj_track_times");
  hsize_t count = 1;
  for (const hsize_t extent : shape) count *= extent;
  if (count >= 512) {
    check(H5Pset_chunk(options, static_cast<int>(shape.size()), shape.data()), "H5Pset_chunk");
    check(H5Pset_shuffle(options), "H5Pset_shuffle");
    check(H5Pset_deflate(options, 1), "H5Pset_deflate");
  }
  Handle dataset(H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, options, H5P_DEFAULT),
                 "H5Dcreate2");
  if (count > 0) check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, transfer, values), "H5Dwrite");
  return dataset;
}

Handle::Handle(hid_t id, const char* call) : id_(id) {
  if (id < 0) fail(call);
}

Handle::~Handle() {
  if (id_ >= 0) H5Idec_ref(id_);
}

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), "H5Tcopy");
  check(H5Tset_size(type, H5T_VARIABLE), "H5Tset_size");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "H5Tset_cset");
  return type;
}

Alone::Alone() {
  static std::recursive_mutex one_at_a_time;
  lock_ = std::unique_lock(one_at_a_time);
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Alone::~Alone() {
  if (lock_.owns_lock()) H5Eset_auto2(H5E_DEFAULT, function_, data_);
}

File create_file_in_memory() {
  Alone alone;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), "H5Pcreate");
  check(H5Pset_fapl_core(access, 1U << 20U, false), "H5Pset_fapl_core");
  // The name is never used on disk, but must not name an existing file.
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), "H5Pcreate");
  check(H5Pset_userblock(creation, seal_size), "H5Pset_userblock");
  // Every dataset is a single chunk; the default index would take 2 kB.
  check(H5Pset_istore_k(creation, 1), "H5Pset_istore_k");
  return {std::move(alone),
          H5Fcreate("rollfem-results-in-memory.h5", H5F_ACC_TRUNC, creation, access), "H5Fcreate"};
}

std::string sealed_image(hid_t file) {
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), "H5Fflush");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  if (size <= 0) fail("H5Fget_file_image");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file, bytes.data(), bytes.size()) != size) fail("H5Fget_file_image");
  // The image contains the data without the user block.
  return hdf5_seal(bytes) + bytes;
}

Handle create_group(hid_t parent, const std::string& name, const std::string& comment) {
  Handle group(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
               "H5Gcreate2");
  write_comment(group, comment);
  return group;
}

void write_attribute(hid_t object, const std::string& name, double value) {
  write_scalar_attribute(object, name, H5T_NATIVE_DOUBLE, &value);
}

void write_attribute(hid_t object, const std::string& name, long value) {
  write_scalar_attribute(object, name, H5T_NATIVE_LONG, &value);
}

void write_attribute(hid_t object, const std::string& name, const std::string& value) {
  const char* const text = value.c_str();
  write_scalar_attribute(object, name, text_type(), &text);
}

Handle write_dataset(hid_t parent, const std::string& name, const std::vector<std::string>& lines) {
  std::vector<const char*> texts;
  texts.reserve(lines.size());
  for (const std::string& line : lines) texts.push_back(line.c_str());
  return write_dataset(parent, name, {texts.size()}, text_type(), texts.data(), transfer_of_text());
}

Handle write_dataset(hid_t parent, const std::string& name, const std::string& text) {
  const char* const start = text.c_str();
  return write_dataset(parent, name, Shape{}, text_type(), &start, transfer_of_text());
}

void write_comment(hid_t object, const std::string& comment) {
  check(H5Oset_comment(object, comment.c_str()), "H5Oset_comment");
}

void link(hid_t parent, const std::string& path, hid_t group, const std::string& name) {
  check(H5Lcreate_hard(parent, path.c_str(), group, name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
        "H5Lcreate_hard");
}

void describe(hid_t object, const std::string& unit, const std::string& description,
              const std::string& sign) {
  write_attribute(object, "unit", unit);
  write_attribute(object, "description", description);
  if (!sign.empty()) write_attribute(object, "sign", sign);
  write_comment(object,
                fmt::format("{} [{}]{}{}", description, unit, sign.empty() ? "" : "; ", sign));
}

namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& name) {
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
  if (!has_attribute(object, name)) refuse("there is no attribute", name);
  Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), "H5Aopen");
  Handle type(H5Aget_type(attribute), "H5Aget_type");
  Handle space(H5Aget_space(attribute), "H5Aget_space");
  return {std::move(attribute), std::move(type), std::move(space)};
}

Content open_dataset(hid_t parent, const std::string& name) {
  if (!has_member(parent, name)) refuse("there is no dataset", name);
  const hid_t id = H5Dopen2(parent, name.c_str(), H5P_DEFAULT);
  if (id < 0) refuse("there is no readable dataset", name);
  Handle dataset(id, "H5Dopen2");
  Handle type(H5Dget_type(dataset), "H5Dget_type");
  Handle space(H5Dget_space(dataset), "H5Dget_space");
  return {std::move(dataset), std::move(type), std::move(space)};
}

}  // namespace

File open_file(const std::string& path) {
  Alone alone;
  const hid_t id = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (id < 0) refuse("HDF5 cannot open", path);
  return {std::move(alone), id, "H5Fopen"};
}

bool has_member(hid_t group, const std::string& name) {
  return H5Lexists(group, name.c_str(), H5P_DEFAULT) > 0;
}

bool has_attribute(hid_t object, const std::string& name) {
  return H5Aexists(object, name.c_str()) > 0;
}

Handle open_group(hid_t parent, const std::string& name) {
  if (!has_member(parent, name)) refuse("there is no group", name);
  const hid_t id = H5Gopen2(parent, name.c_str(), H5P_DEFAULT);
  if (id < 0) refuse("there is no readable group", name);
  return {id, "H5Gopen2"};
}

double read_number(hid_t object, const std::string& name) {
  const Content attribute = open_attribute(object, name);
  double value = 0.0;
  if (!is_number(attribute.type) || attribute.count() != 1 ||
      !attribute.read(H5T_NATIVE_DOUBLE, &value))
    refuse("not one number: attribute", name);
  return value;
}

std::string read_text(hid_t object, const std::string& name) {
  const Content attribute = open_attribute(object, name);
  if (!attribute.is_text() || attribute.count() != 1) refuse("not a string: attribute", name);
  std::vector<std::string> lines;
  if (!attribute.read(lines)) refuse("unreadable attribute", name);
  return lines.front();
}

Numbers read_dataset(hid_t parent, const std::string& name) {
  const Content dataset = open_dataset(parent, name);
  if (!is_number(dataset.type)) refuse("no numbers in dataset", name);
  Numbers numbers{dataset.shape(), std::vector<double>(dataset.count())};
  if (!numbers.values.empty() && !dataset.read(H5T_NATIVE_DOUBLE, numbers.values.data()))
    refuse("damaged or truncated: dataset", name);
  return numbers;
}

template <std::size_t N>
std::vector<std::array<double, N>> read_rows(hid_t parent, const std::string& name) {
  const Numbers numbers = read_dataset(parent, name);
  if (numbers.shape.size() != 2 || numbers.shape[1] != N)
    refuse(fmt::format("not {} numbers in a row: dataset", N), name);
  std::vector<std::array<double, N>> rows(numbers.shape[0]);
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (std::size_t c = 0; c < N; ++c) rows[k][c] = numbers.values[N * k + c];
  return rows;
}

template std::vector<std::array<double, 3>> read_rows(hid_t, const std::string&);

std::vector<std::string> read_lines(hid_t parent, const std::string& name) {
  const Content dataset = open_dataset(parent, name);
  if (!dataset.is_text()) refuse("no text in dataset", name);
  std::vector<std::string> lines;
  if (dataset.count() > 0 && !dataset.read(lines)) refuse("damaged or truncated: dataset", name);
  return lines;
}

}  // namespace rollfem::result::hdf5
