// SPDX-License-Identifier: LGPL-2.1-or-later
// Serialises results to bytes and back, bit for bit, for checkpoints. One description
// serves both directions, so they cannot drift apart. The bytes are specific to this
// machine and program version; the exchange format is results.h5.
#pragma once

#include "contact/base/grid.hpp"
#include "contact/result/result.hpp"

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
  /// For reading.
  explicit Record(std::string bytes) : bytes_(std::move(bytes)), reading_(true) {}

  bool reading() const { return reading_; }
  const std::string& bytes() const { return bytes_; }
  /// Whether everything was read. A record of another layout ends early or late.
  bool exhausted() const { return reading_ && position_ == bytes_.size(); }

  /// Each function appends the value, or replaces it by the value read. Reading throws
  /// std::runtime_error when the record ends too early.
  template <class Number, std::enable_if_t<std::is_arithmetic_v<Number>, int> = 0>
  void value(Number& number) {
    raw(&number, sizeof number);
  }
  void value(bool& truth);
  void value(std::optional<double>& number);
  void value(std::string& text);
  void value(Field& field);
  void value(TangentialField& field);
  void value(SurfaceField& field);
  void value(Response& response);
  void value(std::vector<ElementState>& states);
  void value(std::map<std::string, double>& numbers);
  void value(std::map<std::string, std::string>& words);
  void value(SubsurfaceField& field);
  void value(BodyValues& values);
  void value(std::vector<BodyField>& bodies);
  void value(PointResult& point);

  /// Several in a row.
  template <class... Values>
  void values(Values&... all) {
    (value(all), ...);
  }

 private:
  void raw(void* data, std::size_t size);
  /// Length of a list: given when writing, found when reading.
  std::size_t length(std::size_t size, std::size_t bytes_each);
  template <class Entry>
  void plain(std::vector<Entry>& entries);
  template <class Entry>
  void by_name(std::map<std::string, Entry>& entries);

  std::string bytes_;
  std::size_t position_ = 0;
  bool reading_ = false;
};

/// 64-bit FNV-1a, to detect a damaged or foreign record; no protection against malice.
unsigned long long checksum(std::string_view bytes, unsigned long long begin = 0xcbf29ce484222325U);

}  // namespace rollfem::contact
