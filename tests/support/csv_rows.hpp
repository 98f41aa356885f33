// CSV files that the program wrote.
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace rollfem::testing {

/// Cells row by row, the head first.
inline std::vector<std::vector<std::string>> csv_rows(const std::string& text) {
  std::istringstream lines(text);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
    if (!line.empty() && line.back() == ',') rows.back().emplace_back();
  }
  return rows;
}

/// The numbers below the head, from that column on.
inline std::vector<double> csv_numbers(const std::string& text, std::size_t first_column) {
  const auto rows = csv_rows(text);
  std::vector<double> numbers;
  for (std::size_t r = 1; r < rows.size(); ++r)
    for (std::size_t c = first_column; c < rows[r].size(); ++c)
      numbers.push_back(std::stod(rows[r][c]));
  return numbers;
}

}  // namespace rollfem::testing
