// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/hdf5/hdf5_objects.hpp"

#include "result/files/seal.hpp"

#include <fmt/core.h>

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

}  // namespace rollfem::result::hdf5
