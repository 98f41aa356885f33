// SPDX-License-Identifier: LGPL-2.1-or-later
// A table for spreadsheets: each column is its heading, with unit, and its cell in a row.
#pragma once

#include "base/members.hpp"

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace rollfem::result {

/// A number or text; nothing where there is none.
template <class Value>
std::string csv_cell(const Value& value) {
  return fmt::format("{}", value);
}
template <class Value>
std::string csv_cell(const std::optional<Value>& value) {
  return value ? fmt::format("{}", *value) : std::string();
}

/// "max_pressure [MPa]"
inline std::string heading(const std::string& name, const std::string& unit) {
  return name + " [" + unit + "]";
}

template <class Row>
class Columns {
 public:
  /// `cell`: a number or a text of a row, or one that may be absent.
  template <class Cell>
  void add(std::string head, Cell cell) {
    heads_.push_back(std::move(head));
    cells_.push_back(
        [cell = std::move(cell)](const Row& row) { return csv_cell(std::invoke(cell, row)); });
  }
  /// A column for each member of a struct that a row has, by `whole_of(row)`.
  template <class Whole, class Of>
  void add_members(const Of& whole_of) {
    contact::for_members<Whole>([&](const auto& each) {
      if constexpr (std::decay_t<decltype(each)>::kept != contact::Kept::within)
        add(*each.unit == '\0' ? each.name : heading(each.name, each.unit),
            [part = each.part, whole_of](const Row& row) {
              return std::invoke(part, std::invoke(whole_of, row));
            });
    });
  }

  /// The columns of another table behind these, of the part of a row that it is about.
  template <class Other, class Of>
  void append(const Columns<Other>& others, const Of& part_of) {
    for (std::size_t k = 0; k < others.heads_.size(); ++k)
      add(others.heads_[k], [cell = others.cells_[k], part_of](const Row& row) {
        return cell(std::invoke(part_of, row));
      });
  }
  void append(const Columns& others) {
    append(others, [](const Row& row) -> const Row& { return row; });
  }

  std::string head() const {
    return joined(heads_, [](const std::string& head) { return head; });
  }
  std::string line(const Row& row) const {
    return joined(cells_, [&](const auto& cell) { return cell(row); });
  }
  std::string lines(const std::vector<Row>& rows) const {
    std::string text;
    for (const Row& row : rows) text += line(row) + '\n';
    return text;
  }

 private:
  template <class Parts, class Text>
  static std::string joined(const Parts& parts, const Text& text_of) {
    std::string text;
    for (const auto& part : parts) {
      if (&part != &parts.front()) text += ',';
      text += text_of(part);
    }
    return text;
  }

  template <class Other>
  friend class Columns;
  std::vector<std::string> heads_;
  std::vector<std::function<std::string(const Row&)>> cells_;
};

}  // namespace rollfem::result
