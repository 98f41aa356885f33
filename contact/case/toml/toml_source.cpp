// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/toml/toml_source.hpp"

#include <algorithm>

namespace rollfem::contact {

namespace {

/// Shortened, and without characters that would disturb a terminal.
std::string printable(std::string text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\r')) text.pop_back();
  const bool cut = text.size() > 60;
  if (cut) text.resize(57);
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
  return cut ? text + "..." : text;
}

}  // namespace

TomlSource::TomlSource(const std::string& text, std::string file)
    : text_(text), file_(std::move(file)) {
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines_.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
}

std::string TomlSource::line(unsigned number) const {
  return number == 0 || number > lines_.size() ? "" : printable(lines_[number - 1]);
}

std::string TomlSource::value(const toml::source_region& region) const {
  if (region.begin.line == 0 || region.begin.line > lines_.size()) return "";
  const std::string& line = lines_[region.begin.line - 1];
  const std::size_t begin = std::min<std::size_t>(region.begin.column - 1, line.size());
  const bool one_line = region.end.line == region.begin.line;
  const std::size_t end =
      one_line ? std::min<std::size_t>(region.end.column - 1, line.size()) : line.size();
  return printable(line.substr(begin, end > begin ? end - begin : std::string::npos)) +
         (one_line ? "" : " ...");
}

}  // namespace rollfem::contact
