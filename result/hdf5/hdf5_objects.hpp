// SPDX-License-Identifier: LGPL-2.1-or-later
// The HDF5 calls needed to write and read results.h5, with handles that close themselves and errors
// as exceptions.
#pragma once

#include <hdf5.h>

#include <array>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::result::hdf5 {

/// Owns one HDF5 identifier of any kind.
class Handle {
 public:
  /// Throws std::runtime_error naming `call` if `id` is invalid.
  Handle(hid_t id, const char* call);
  Handle(Handle&& other) noexcept : id_(other.id_) { other.id_ = H5I_INVALID_HID; }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;
  ~Handle();
  operator hid_t() const { return id_; }  // NOLINT: stands in for the identifier in HDF5 calls

 private:
  hid_t id_;
};

/// The type of texts: UTF-8 strings of variable length, which h5py and MATLAB read directly.
Handle text_type();

/// While one exists, its thread alone uses HDF5, which prints nothing on failures: they become
/// exceptions. Debian's HDF5 is not thread-safe, and the files in memory share a name.
class Alone {
 public:
  Alone();
  Alone(Alone&&) = default;
  ~Alone();

 private:
  std::unique_lock<std::recursive_mutex> lock_;
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

/// An open file; the thread that has it open keeps all others waiting until it is closed. Other
/// objects belong to a file, so they need no lock of their own.
class File {
 public:
  /// `alone`: taken before any call of HDF5.
  File(Alone alone, hid_t id, const char* call) : alone_(std::move(alone)), file_(id, call) {}
  operator hid_t() const { return file_; }  // NOLINT: as Handle

 private:
  Alone alone_;
  Handle file_;
};

/// Creates a file in memory. Its bytes on disk start with a user block that holds the checksum
/// (seal.hpp).
File create_file_in_memory();
std::string sealed_image(hid_t file);

/// A new group; `comment` is shown by h5dump -H.
Handle create_group(hid_t parent, const std::string& name, const std::string& comment);

void write_attribute(hid_t object, const std::string& name, double value);
void write_attribute(hid_t object, const std::string& name, long value);
void write_attribute(hid_t object, const std::string& name, const std::string& value);

using Shape = std::vector<hsize_t>;

/// HDF5's type of numbers in memory.
inline hid_t type_of(const double* /*number*/) {
  return H5T_NATIVE_DOUBLE;
}
inline hid_t type_of(const float* /*number*/) {
  return H5T_NATIVE_FLOAT;
}
inline hid_t type_of(const int* /*number*/) {
  return H5T_NATIVE_INT;
}
inline hid_t type_of(const unsigned char* /*number*/) {
  return H5T_NATIVE_UCHAR;
}

/// Writes a dataset of any type with `shape` in row-major order (without extents: one value),
/// compressed above a certain size.
Handle write_dataset(hid_t parent, const std::string& name, const Shape& shape, hid_t type,
                     const void* values, hid_t transfer = H5P_DEFAULT);
Handle write_dataset(hid_t parent, const std::string& name, const std::vector<std::string>& lines);
Handle write_dataset(hid_t parent, const std::string& name, const std::string& text);

void write_comment(hid_t object, const std::string& comment);

/// Links the object `path` of `parent` under a second name in `group`.
void link(hid_t parent, const std::string& path, hid_t group, const std::string& name);

/// Describes a dataset by the attributes unit, description and sign and by a comment.
void describe(hid_t object, const std::string& unit, const std::string& description,
              const std::string& sign = "");

/// Writes numbers with their description, by default as a list.
template <class Number>
void write_values(hid_t group, const char* name, const std::vector<Number>& values,
                  const std::string& unit, const std::string& description,
                  const std::string& sign = "", Shape shape = {}) {
  if (shape.empty()) shape = {values.size()};
  describe(write_dataset(group, name, shape, type_of(values.data()), values.data()), unit,
           description, sign);
}

/// Writes N numbers of every point as a dataset [points, N].
template <std::size_t N, class Number>
void write_rows(hid_t group, const char* name, const std::vector<std::array<Number, N>>& rows,
                const std::string& unit, const std::string& description) {
  // Arrays lie one after another.
  const auto* const first = reinterpret_cast<const Number*>(rows.data());
  describe(write_dataset(group, name, {rows.size(), N}, type_of(first), first), unit, description);
}

/// Opens a file for reading; std::runtime_error if it is not an HDF5 file or damaged.
File open_file(const std::string& path);

/// Whether an object has a member (a group, a dataset), or an attribute, of that name.
bool has_member(hid_t group, const std::string& name);
bool has_attribute(hid_t object, const std::string& name);
Handle open_group(hid_t parent, const std::string& name);

/// Attributes; std::runtime_error if one is missing or has another type.
double read_number(hid_t object, const std::string& name);
std::string read_text(hid_t object, const std::string& name);

/// A dataset of numbers with its shape; integers are converted.
struct Numbers {
  Shape shape;
  std::vector<double> values;
};
Numbers read_dataset(hid_t parent, const std::string& name);
/// A dataset [n, N]; std::runtime_error if it has another shape.
template <std::size_t N>
std::vector<std::array<double, N>> read_rows(hid_t parent, const std::string& name);
/// A dataset of texts; a single text is one line.
std::vector<std::string> read_lines(hid_t parent, const std::string& name);

}  // namespace rollfem::result::hdf5
