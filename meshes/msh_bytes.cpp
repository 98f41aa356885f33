// SPDX-License-Identifier: LGPL-2.1-or-later
#include "meshes/msh_bytes.hpp"

#include "base/errors.hpp"
#include "base/text_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

namespace rollfem::meshes {

namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

}  // namespace

MshBytes::MshBytes(const std::string& path, std::string name) : name_(std::move(name)) {
  constexpr std::size_t largest_file = 20'000'000'000;
  bytes_ =
      contact::text_of_file(path, name_, largest_file,
                            "name a gmsh mesh file (.msh), its path relative to the case file");
}

void MshBytes::fail_file(const std::string& wrong, const std::string& action) const {
  throw contact::InputError(fmt::format("{}: {}; do: {}", name_, wrong, action));
}

void MshBytes::fail_at(std::size_t place, const std::string& wrong,
                       const std::string& action) const {
  if (format_.binary) fail_file(fmt::format("byte {}: {}", place, wrong), action);
  const auto end = bytes_.begin() + static_cast<std::ptrdiff_t>(std::min(place, bytes_.size()));
  fail_file(fmt::format("line {}: {}", 1 + std::count(bytes_.begin(), end, '\n'), wrong), action);
}

bool MshBytes::at_end() {
  while (next_ < bytes_.size() && is_blank(bytes_[next_])) ++next_;
  place_ = next_;
  return next_ == bytes_.size();
}

std::string_view MshBytes::line() {
  place_ = next_;
  const std::size_t end = std::min(bytes_.find('\n', next_), bytes_.size());
  const std::string_view text = std::string_view(bytes_).substr(next_, end - next_);
  next_ = std::min(end + 1, bytes_.size());
  return contact::trimmed(text);
}

bool MshBytes::pass(std::string_view text) {
  for (std::size_t found = bytes_.find(text, next_); found != std::string::npos;
       found = bytes_.find(text, found + 1)) {
    const std::size_t end = found + text.size();
    if (found == 0 || bytes_[found - 1] != '\n' || (end < bytes_.size() && !is_blank(bytes_[end])))
      continue;
    next_ = end;
    return true;
  }
  return false;
}

std::string_view MshBytes::token(const char* what) {
  if (at_end()) fail(fmt::format("the file ends before {}", what));
  while (next_ < bytes_.size() && !is_blank(bytes_[next_])) ++next_;
  return std::string_view(bytes_).substr(place_, next_ - place_);
}

template <class Number>
Number MshBytes::raw(const char* what) {
  place_ = next_;
  Number number{};
  if (bytes_.size() - next_ < sizeof number) fail(fmt::format("the file ends before {}", what));
  std::memcpy(&number, bytes_.data() + next_, sizeof number);
  next_ += sizeof number;
  return number;
}

std::int64_t MshBytes::from_text(const char* what) {
  const std::string_view text = token(what);
  std::int64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end)
    fail(fmt::format("`{}` is not {}, a whole number", contact::printable(text), what));
  return number;
}

std::int64_t MshBytes::checked(std::int64_t number, const char* what, std::int64_t least,
                               std::int64_t most) const {
  if (number >= least && number <= most) return number;
  fail(fmt::format("{} is {}; allowed: {} to {}", what, number, least, most));
}

std::int64_t MshBytes::integer(const char* what, std::int64_t least, std::int64_t most) {
  return checked(format_.binary ? raw<std::int32_t>(what) : from_text(what), what, least, most);
}

std::int64_t MshBytes::large(const char* what, std::int64_t least, std::int64_t most) {
  if (!format_.binary || format_.old || format_.count_bytes == sizeof(std::int32_t))
    return integer(what, least, most);
  return checked(raw<std::int64_t>(what), what, least, most);
}

std::size_t MshBytes::count(const char* what, std::size_t text_bytes, std::size_t binary_bytes) {
  std::int64_t number = 0;
  if (format_.old) {  // also a line of text before binary numbers
    number = checked(from_text(what), what, 0, INT64_MAX);
    const std::size_t begin = place_;
    line();
    place_ = begin;
  } else {
    number = large(what, 0, INT64_MAX);
  }
  const std::size_t each = format_.binary ? binary_bytes : text_bytes;
  // The last number of a text may be followed by the end of the file instead of a blank.
  const std::size_t most = (bytes_.size() - next_ + 1) / each;
  if (static_cast<std::uint64_t>(number) > most)
    fail(fmt::format("{} is {}, but the rest of the file has room for at most {}", what, number,
                     most));
  return static_cast<std::size_t>(number);
}

double MshBytes::real(const char* what) {
  if (format_.binary) return raw<double>(what);
  std::string_view text = token(what);
  if (text.size() > 1 && text.front() == '+') text.remove_prefix(1);
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (stop != end || error == std::errc::invalid_argument)
    fail(fmt::format("`{}` is not {}, a number", contact::printable(text), what));
  // Out of range of a double: underflow gives 0, overflow fails like infinity.
  if (error == std::errc::result_out_of_range)
    return text.find("e-") == text.npos && text.find("E-") == text.npos ? HUGE_VAL : 0.0;
  return number;
}

}  // namespace rollfem::meshes
