// SPDX-License-Identifier: LGPL-2.1-or-later
// A table for spreadsheets: each column is its name, its unit and its cell in a row.
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

template <class Row>
class Columns {
 public:
  struct Column {
    std::string name, unit;  ///< unit: "-" of a number without one; empty: not a number
    std::function<std::string(const Row&)> cell;
    /// "max_pressure [MPa]"
    std::string head() const { return unit.empty() ? name : name + " [" + unit + "]"; }
  };
  const std::vector<Column>& all() const { return all_; }

  /// `cell`: a number or a text of a row, or one that may be absent.
  template <class Cell>
  void add(std::string name, std::string unit, Cell cell) {
    all_.push_back({std::move(name), std::move(unit), [cell = std::move(cell)](const Row& row) {
                      return csv_cell(std::invoke(cell, row));
                    }});
  }
  /// A column for each member of a struct that a row has, by `whole_of(row)`.
  template <class Whole, class Of>
  void add_members(const Of& whole_of) {
    contact::for_members<Whole>([&](const auto& each) {
      if constexpr (std::decay_t<decltype(each)>::kept != contact::Kept::within)
        add(each.name, each.unit, [part = each.part, whole_of](const Row& row) {
          return std::invoke(part, std::invoke(whole_of, row));
        });
    });
  }

  /// The columns of another table behind these, of the part of a row that it is about.
  template <class Other, class Of>
  void append(const Columns<Other>& others, const Of& part_of) {
    for (const auto& other : others.all())
      add(other.name, other.unit,
          [cell = other.cell, part_of](const Row& row) { return cell(std::invoke(part_of, row)); });
  }
  void append(const Columns& others) {
    append(others, [](const Row& row) -> const Row& { return row; });
  }

  std::string head() const {
    return joined([](const Column& column) { return column.head(); });
  }
  std::string line(const Row& row) const {
    return joined([&](const Column& column) { return column.cell(row); });
  }
  std::string lines(const std::vector<Row>& rows) const {
    std::string text;
    for (const Row& row : rows) text += line(row) + '\n';
    return text;
  }
  /// Head and rows.
  std::string table(const std::vector<Row>& rows) const { return head() + '\n' + lines(rows); }

 private:
  template <class Text>
  std::string joined(const Text& text_of) const {
    std::string text;
    for (const Column& column : all_) {
      if (&column != &all_.front()) text += ',';
      text += text_of(column);
    }
    return text;
  }

  std::vector<Column> all_;
};

}  // namespace rollfem::result
