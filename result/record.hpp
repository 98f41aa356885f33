// SPDX-License-Identifier: LGPL-2.1-or-later
// Serialises results to bytes and back, bit for bit, for checkpoints. One description
// serves both directions, so they cannot drift apart. The bytes are specific to this
// machine and program version; the exchange format is results.h5.
#pragma once

#include "base/checkpoint.hpp"
#include "base/errors.hpp"
#include "base/grid.hpp"
#include "base/members.hpp"
#include "result/result.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace rollfem::contact {

class Record {
 public:
  /// For writing.
  Record() = default;
  /// For reading. `elements`: of the grid that fields belong to; fields of another size are
  /// refused.
  explicit Record(std::string bytes, Eigen::Index elements = -1)
      : bytes_(std::move(bytes)), elements_(elements), reading_(true) {}

  bool reading() const { return reading_; }
  const std::string& bytes() const { return bytes_; }
  /// Whether everything was read. A record of another layout ends early or late.
  bool exhausted() const { return reading_ && position_ == bytes_.size(); }

  /// Each function appends the value, or replaces it by the value read. Reading throws
  /// FileError when the record ends too early.
  template <class Plain, std::enable_if_t<std::is_trivially_copyable_v<Plain>, int> = 0>
  void value(Plain& plain) {
    raw(&plain, sizeof plain);
  }
  template <class Entry>
  void value(std::vector<Entry>& entries) {
    constexpr bool plain = std::is_trivially_copyable_v<Entry>;
    entries.resize(length(entries.size(), plain ? sizeof(Entry) : 1));
    if constexpr (plain)
      raw(entries.data(), entries.size() * sizeof(Entry));
    else
      for (Entry& entry : entries) value(entry);
  }
  template <class Entry>
  void value(std::map<std::string, Entry>& entries) {
    std::size_t count = length(entries.size(), 1);
    if (!reading_)
      for (auto& [name, entry] : entries) values(const_cast<std::string&>(name), entry);
    else
      for (entries.clear(); count > 0; --count) {
        std::string name;
        value(name);
        value(entries[name]);
      }
  }
  template <class Entry>
  void value(std::optional<Entry>& entry) {
    bool there = entry.has_value();
    value(there);
    if (there != entry.has_value()) there ? void(entry.emplace()) : entry.reset();
    if (entry) value(*entry);
  }
  /// A type with a function exchange(Record&, Type&) in its namespace.
  template <class Type, std::enable_if_t<!std::is_trivially_copyable_v<Type>, int> = 0>
  auto value(Type& whole) -> decltype(exchange(*this, whole)) {
    exchange(*this, whole);
  }
  void value(bool& truth);
  void value(std::string& text);
  void value(Field& field);
  void value(TangentialField& field) {
    values(field.x, field.y);
    demand(field.x.size() == field.y.size());
  }
  void value(SurfaceField& field) { values(field.x, field.y, field.n); }
  void value(Response& response) { values(response.displacement, response.curvature_slip); }
  /// A struct that lists its members.
  template <class Whole,
            std::enable_if_t<has_members<Whole> && !std::is_trivially_copyable_v<Whole>, int> = 0>
  void value(Whole& whole) {
    for_members<Whole>([&](const auto& each) {
      if constexpr (std::is_member_object_pointer_v<decltype(each.part)>) value(whole.*each.part);
    });
  }
  void value(PointResult& point);

  /// Throws FileError unless what was read fits.
  void demand(bool fits) const;

  /// Several in a row.
  template <class... Values>
  void values(Values&... all) {
    (value(all), ...);
  }

 private:
  void raw(void* data, std::size_t size);
  /// Length of a list: given when writing, found when reading.
  std::size_t length(std::size_t size, std::size_t bytes_each);

  std::string bytes_;
  std::size_t position_ = 0;
  Eigen::Index elements_ = -1;
  bool reading_ = false;
};

/// The bytes of some values in a row.
template <class... Values>
std::string record_of(const Values&... all) {
  Record record;
  record.values(const_cast<Values&>(all)...);  // only reading changes them
  return record.bytes();
}

/// Whether `read` reads the bytes to their end.
template <class Read>
bool reads(Record record, const Read& read) {
  try {
    read(record);
    return record.exhausted();
  } catch (const FileError&) {
    return false;
  }
}

/// Whether a checkpoint has a record of this name that `read` reads to its end. A damaged one is
/// reported, counts as missing and may have been read in part.
template <class Read>
bool found(Checkpoint& checkpoint, const std::string& name, const Read& read,
           Eigen::Index elements = -1) {
  const std::optional<std::string> bytes = checkpoint.find(name);
  if (!bytes) return false;
  if (reads(Record(*bytes, elements), read)) return true;
  checkpoint.refuse(name);
  return false;
}

/// 64-bit FNV-1a, to detect a damaged or foreign record; no protection against malice.
unsigned long long checksum(std::string_view bytes, unsigned long long begin = 0xcbf29ce484222325U);

}  // namespace rollfem::contact
