// The few HDF5 calls that results.h5 needs, with handles that close themselves and errors as
// exceptions.
#pragma once

#include <hdf5.h>

#include <string>
#include <vector>

namespace rollfem::postprocess::hdf5 {

/// Owns one HDF5 identifier of any kind.
class Handle {
 public:
  /// Throws std::runtime_error naming `call` when `id` is invalid.
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

/// A new file in memory, and the bytes it would have on disk.
Handle create_file_in_memory();
std::string file_image(hid_t file);

/// A new group; `comment` is shown by h5dump -H.
Handle create_group(hid_t parent, const std::string& name, const std::string& comment);

void write_attribute(hid_t object, const std::string& name, double value);
void write_attribute(hid_t object, const std::string& name, long value);
void write_attribute(hid_t object, const std::string& name, const std::string& value);

/// Datasets; `shape` in row-major order, compressed from some size on.
Handle write_dataset(hid_t parent, const std::string& name, const std::vector<hsize_t>& shape,
                     const double* values);
Handle write_dataset(hid_t parent, const std::string& name, const std::vector<hsize_t>& shape,
                     const unsigned char* values);
Handle write_dataset(hid_t parent, const std::string& name, const std::vector<std::string>& lines);
Handle write_dataset(hid_t parent, const std::string& name, const std::string& text);

void write_comment(hid_t object, const std::string& comment);

}  // namespace rollfem::postprocess::hdf5
