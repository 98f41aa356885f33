// SPDX-License-Identifier: LGPL-2.1-or-later
// CSV files that the program wrote.
#pragma once

#include "support/test.hpp"

namespace rollfem::testing {

/// Cells row by row, the head first.
inline std::vector<std::vector<std::string>> csv_rows(const std::string& text) {
  std::istringstream lines(text);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(lines, line);) {
    rows.push_back({""});
    bool quoted = false;
    for (const char c : line)
      if (c == '"')
        quoted = !quoted;
      else if (c == ',' && !quoted)
        rows.back().emplace_back();
      else
        rows.back().back() += c;
  }
  return rows;
}

/// The rows below the head, each cell under its heading or the first word of it.
inline std::vector<std::map<std::string, std::string>> csv_records(const std::string& text,
                                                                   bool first_word = true) {
  const auto rows = csv_rows(text);
  std::vector<std::map<std::string, std::string>> records(rows.size() - 1);
  for (std::size_t r = 1; r < rows.size(); ++r)
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      const std::string& heading = rows[0].at(c);
      records[r - 1][first_word ? heading.substr(0, heading.find(' ')) : heading] = rows[r][c];
    }
  return records;
}

}  // namespace rollfem::testing
