// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/frame/screen.hpp"

#include "base/text_fields.hpp"
#include "models/program/provenance.hpp"

#include <nlohmann/json.hpp>

#include <iostream>
#include <streambuf>
#include <vector>

namespace rollfem::app {

using Json = nlohmann::ordered_json;

namespace {

/// Accepts everything and keeps nothing.
class Nowhere : public std::streambuf {
  int_type overflow(int_type c) override { return traits_type::not_eof(c); }
  std::streamsize xsputn(const char*, std::streamsize count) override { return count; }
};

std::streambuf* shown = nullptr;

}  // namespace

void silence() {
  static Nowhere nowhere;
  if (shown == nullptr) shown = std::cout.rdbuf(&nowhere);
}

void print_result(const std::string& json) {
  std::streambuf* const before = shown == nullptr ? nullptr : std::cout.rdbuf(shown);
  std::cout << json << (json.empty() || json.back() != '\n' ? "\n" : "") << std::flush;
  // A failure of the real output stays in the state of the stream.
  const std::ios::iostate state = std::cout.rdstate();
  if (before != nullptr) std::cout.rdbuf(before);
  std::cout.setstate(state);
}

Json result_head(const std::string& kind) {
  return {{"format", 1},
          {"kind", kind},
          {"program", {{"version", modelling::version()}, {"commit", modelling::commit()}}}};
}

Json columns_of(const std::string& csv) {
  Json columns = Json::object(), units = Json::object();
  std::vector<std::string> names;
  for (contact::TextLines lines(csv); lines.next();) {
    if (lines.line().empty() || lines.line().front() == '#') continue;
    const bool heading = names.empty();
    std::size_t k = 0;
    for (const std::string_view part : contact::parts_of(lines.line(), ",")) {
      const std::string cell(part);
      if (!heading) {
        columns[names[k++]].push_back(cell.empty() ? Json() : Json(std::stod(cell)));
        continue;
      }
      const std::size_t unit = cell.find(" [");
      names.push_back(cell.substr(0, unit));
      columns[names.back()] = Json::array();
      if (unit != std::string::npos)
        units[names.back()] = cell.substr(unit + 2, cell.size() - unit - 3);
    }
  }
  return {{"columns", columns}, {"units", units}};
}

}  // namespace rollfem::app
