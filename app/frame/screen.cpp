// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/frame/screen.hpp"

#include "models/program/provenance.hpp"

#include <nlohmann/json.hpp>

#include <iostream>
#include <sstream>
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

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream rest(line + ",");
  for (std::string cell; std::getline(rest, cell, ',');) cells.push_back(cell);
  return cells;
}

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
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string> cells = cells_of(line);
    const bool heading = names.empty();
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (heading) {
        const std::size_t unit = cells[k].find(" [");
        names.push_back(cells[k].substr(0, unit));
        columns[names[k]] = Json::array();
        if (unit != std::string::npos)
          units[names[k]] = cells[k].substr(unit + 2, cells[k].size() - unit - 3);
      } else {
        columns[names[k]].push_back(cells[k].empty() ? Json() : Json(std::stod(cells[k])));
      }
    }
  }
  return {{"columns", columns}, {"units", units}};
}

}  // namespace rollfem::app
