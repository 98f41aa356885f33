// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/record.hpp"

#include "base/errors.hpp"
#include "result/quantities.hpp"

#include <cmath>
#include <cstring>

namespace rollfem::contact {

void Record::demand(bool fits) const {
  if (!fits) throw FileError("a record is damaged; do: delete it, or run without --resume");
}

void Record::raw(void* data, std::size_t size) {
  if (size == 0) return;
  if (!reading_) {
    bytes_.append(static_cast<const char*>(data), size);
    return;
  }
  demand(size <= bytes_.size() - position_);
  std::memcpy(data, bytes_.data() + position_, size);
  position_ += size;
}

std::size_t Record::length(std::size_t size, std::size_t bytes_each) {
  unsigned long long count = size;
  raw(&count, sizeof count);
  // A damaged length must not allocate all memory.
  demand(!reading_ || count <= (bytes_.size() - position_) / bytes_each);
  return static_cast<std::size_t>(count);
}

void Record::value(bool& truth) {
  unsigned char byte = truth ? 1 : 0;
  raw(&byte, 1);
  truth = byte != 0;
}

void Record::value(std::string& text) {
  text.resize(length(text.size(), 1));
  raw(text.data(), text.size());
}

void Record::value(Field& field) {
  const auto size = length(static_cast<std::size_t>(field.size()), sizeof(double));
  demand(!reading_ || elements_ < 0 || size == 0 || static_cast<Eigen::Index>(size) == elements_);
  field.resize(static_cast<Eigen::Index>(size));
  raw(field.data(), size * sizeof(double));
}

void Record::value(PointResult& p) {
  for (const Quantity& quantity : quantities()) {
    std::optional<double> number = quantity.value(p);
    value(number);
    if (reading_ && (number || !quantity.member.may_be_absent))
      quantity.member.set(p, number.value_or(std::nan("")));
  }
  for (const PointField& field : point_fields()) value(field.member(p.fields));
  value(p.fields.state);
  for_members<PointResult>([&](const auto& each) { value(p.*each.part); });
}

unsigned long long checksum(std::string_view bytes, unsigned long long begin) {
  unsigned long long hash = begin;
  for (const char c : bytes) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3U;
  }
  return hash;
}

}  // namespace rollfem::contact
