// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/files/seal.hpp"

#include "base/errors.hpp"
#include "base/text_fields.hpp"
#include "result/record.hpp"

#include <fmt/format.h>

#include <fstream>
#include <vector>
#include <zlib.h>

namespace rollfem::result {
namespace {

constexpr std::string_view seal_begin = "rollfem results\n";
constexpr std::string_view hdf5_signature("\x89HDF\r\n\x1a\n", 8);
constexpr std::string_view json_member = "\"checksum\": \"crc32 ";

uLong crc_of(std::string_view bytes, uLong before = 0) {
  return crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
}

std::string seal_text(std::size_t bytes, uLong crc) {
  std::string text = fmt::format(
      "{}bytes: {}\ncrc32: {:08x}\nof the HDF5 data behind this user block of {} bytes\n",
      seal_begin, bytes, crc, seal_size);
  text.resize(seal_size, '\n');
  return text;
}

bool begins_with(std::string_view text, std::string_view begin) {
  return text.substr(0, begin.size()) == begin;
}

}  // namespace

std::string hdf5_seal(std::string_view data) {
  return seal_text(data.size(), crc_of(data));
}

bool hdf5_seal_is_intact(const std::string& path, const std::string& action) {
  contact::OpenedFile file(path, path, action);
  std::string block(seal_size, '\0');
  block.resize(file.read(block.data(), block.size()));
  if (begins_with(block, hdf5_signature)) return false;
  std::vector<char> buffer(1U << 20U);
  std::size_t bytes = 0;
  uLong crc = 0;
  bool is_hdf5 = begins_with(block, seal_begin);
  while (const std::size_t count = file.read(buffer.data(), buffer.size())) {
    const std::string_view part(buffer.data(), count);
    is_hdf5 = is_hdf5 || (bytes == 0 && begins_with(part, hdf5_signature));
    crc = crc_of(part, crc);
    bytes += part.size();
  }
  if (!is_hdf5) file.fail("is not a result of rollfem (no HDF5 file)");
  return block == seal_text(bytes, crc);
}

std::string sealed_json(std::string text) {
  text.erase(text.rfind('}'));
  text.erase(text.find_last_not_of(" \n") + 1);
  text += ",\n  ";
  return text + fmt::format("{}{:08x}\"\n}}\n", json_member, crc_of(text));
}

std::string sealed_record(std::string_view place, std::string_view record) {
  const auto seal = contact::checksum(record, contact::checksum(place));
  return fmt::format("{:016x}{}", seal, record);
}

std::optional<std::string> opened_record(std::string_view place, const std::string& bytes) {
  if (bytes.size() < 16) return {};
  std::string record = bytes.substr(16);
  if (bytes != sealed_record(place, record)) return {};
  return record;
}

}  // namespace rollfem::result
