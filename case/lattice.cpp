// SPDX-License-Identifier: LGPL-2.1-or-later
#include "case/lattice.hpp"

#include "base/errors.hpp"
#include "base/text_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <string_view>

namespace rollfem::contact {

namespace {

constexpr std::size_t most_points = 4000000;
constexpr int fewest_across = 4;
/// Tolerance for rounded numbers in files: points this close (relative to the spacing) are on the
/// lattice.
constexpr double rounding = 1e-3;

struct Row {
  double x;
  double y;
  std::vector<double> values;
  std::size_t line;
};

[[noreturn]] void fail_at(const std::string& file, std::size_t line, const std::string& wrong,
                          const std::string& action) {
  throw InputError(line > 0 ? fmt::format("{}:{}: {}; do: {}", file, line, wrong, action)
                            : fmt::format("{}: {}; do: {}", file, wrong, action));
}

/// A plausible coordinate or value.
std::optional<double> number_in(std::string_view field) {
  const std::optional<double> value = number_of(field);
  return value && std::abs(*value) < 1e12 ? value : std::nullopt;
}

Row row_of(const std::vector<std::string_view>& fields, const std::string& file, std::size_t line,
           const std::string& columns) {
  const std::size_t expected = fields_of(columns, ",").size();
  if (fields.size() != expected)
    fail_at(file, line, fmt::format("has {} numbers, not {}: {}", fields.size(), expected, columns),
            "write one point on each line");
  std::vector<double> numbers(expected);
  for (std::size_t k = 0; k < expected; ++k) {
    const std::optional<double> number = number_in(fields[k]);
    if (!number)
      fail_at(file, line, fmt::format("'{}' is not a finite number", printable(fields[k])),
              "correct this line; lengths are in mm");
    numbers[k] = *number;
  }
  return {numbers[0], numbers[1], {numbers.begin() + 2, numbers.end()}, line};
}

/// `columns`: their names, separated by commas.
std::vector<Row> rows_of(std::string_view text, const std::string& shown,
                         const std::string& columns) {
  // Never quote the contents of files that hold no table.
  if (!looks_like_table(text, "#"))
    fail_at(shown, 0, "has no points: most of its lines do not begin with a number",
            "name a file with lines of " + columns);
  std::vector<Row> rows;
  for (TextLines lines(text); lines.next();) {
    const std::size_t line = lines.number();
    const auto fields = fields_of(without_comment(lines.line(), "#"), " ,;\t\r");
    if (fields.empty()) continue;
    // A line of names may precede the table.
    const bool heading = rows.empty() && !number_in(fields.front()) &&
                         std::isalpha(static_cast<unsigned char>(fields.front().front())) != 0;
    if (heading && line < 20) continue;
    if (rows.size() >= most_points)
      fail_at(shown, line, fmt::format("has more than {} points", most_points),
              "give a coarser lattice");
    rows.push_back(row_of(fields, shown, line, columns));
  }
  if (rows.empty()) fail_at(shown, 0, "has no points", "write lines of " + columns);
  return rows;
}

struct Axis {
  double first = 0.0;
  double step = 0.0;
  int count = 0;
  int index(double at) const { return static_cast<int>(std::lround((at - first) / step)); }
  bool on_lattice(double at) const { return std::abs((at - first) / step - index(at)) <= rounding; }
};

/// Ends and spacing of the coordinates; the spacing is refined over the whole range.
Axis axis_of(std::vector<double> at, const std::string& file, const char* name) {
  std::sort(at.begin(), at.end());
  const double range = at.back() - at.front();
  const double same = 1e-9 * range;
  double smallest = std::numeric_limits<double>::infinity();
  int count = 1;
  for (std::size_t k = 1; k < at.size(); ++k)
    if (at[k] - at[k - 1] > same) smallest = std::min(smallest, at[k] - at[k - 1]);
  // The median spacing below separates rounded copies of one coordinate from its neighbours.
  for (std::size_t k = 1; k < at.size(); ++k)
    if (at[k] - at[k - 1] > 0.5 * smallest) ++count;
  if (count < fewest_across)
    fail_at(file, 0, fmt::format("has {} different values of {}", count, name),
            fmt::format("give a lattice of at least {0} by {0} points", fewest_across));
  return {at.front(), range / (count - 1), count};
}

std::string text_of_points(const std::string& path, const std::string& shown) {
  constexpr std::size_t largest_file = 1'000'000'000;
  return text_of_file(path, shown, largest_file);
}

}  // namespace

Lattice read_lattice(const std::string& path, const std::string& shown_name, int columns) {
  return parse_lattice(text_of_points(path, shown_name), shown_name, columns);
}

BodyPlasticity::ResidualStress read_residual_stress(const std::string& path,
                                                    const std::string& shown_name) {
  BodyPlasticity::ResidualStress residual;
  residual.file = shown_name;
  for (const Row& row :
       rows_of(text_of_points(path, shown_name), shown_name, "depth, along, across")) {
    if (row.x < 0.0 || (!residual.depth.empty() && row.x <= residual.depth.back()))
      fail_at(shown_name, row.line, fmt::format("the depth {} does not ascend from 0", row.x),
              "give depths below the surface in ascending order, each once");
    residual.depth.push_back(row.x);
    residual.along.push_back(row.y);
    residual.across.push_back(row.values.front());
  }
  return residual;
}

Lattice parse_lattice(std::string_view text, const std::string& shown_name, int columns) {
  const std::vector<Row> rows =
      rows_of(text, shown_name, columns == 1 ? "x, y, value" : "x, y, value, value");
  std::vector<double> xs;
  std::vector<double> ys;
  for (const Row& row : rows) {
    xs.push_back(row.x);
    ys.push_back(row.y);
  }
  const Axis x = axis_of(std::move(xs), shown_name, "x");
  const Axis y = axis_of(std::move(ys), shown_name, "y");
  const double size = static_cast<double>(x.count) * y.count;
  const char* regular = "give every point of a lattice of equal steps along x and along y";
  std::vector<std::size_t> lines;
  if (size <= static_cast<double>(most_points)) lines.resize(static_cast<std::size_t>(size), 0);
  Lattice lattice{shown_name, x.count, y.count, x.first, y.first, x.step, y.step, {}};
  lattice.values.assign(static_cast<std::size_t>(columns), std::vector<double>(lines.size()));
  for (const Row& row : rows) {
    if (lines.empty() || !x.on_lattice(row.x) || !y.on_lattice(row.y))
      fail_at(shown_name, row.line,
              fmt::format("the point ({}, {}) is not on a regular lattice with the others (steps "
                          "{:.6g} and {:.6g} mm)",
                          row.x, row.y, x.step, y.step),
              regular);
    const std::size_t at = static_cast<std::size_t>(y.index(row.y)) * x.count + x.index(row.x);
    if (lines[at] > 0)
      fail_at(
          shown_name, row.line,
          fmt::format("the point ({}, {}) was given before, in line {}", row.x, row.y, lines[at]),
          "remove one of the two");
    lines[at] = row.line;
    for (int c = 0; c < columns; ++c) lattice.values[c][at] = row.values[c];
  }
  const auto missing = std::find(lines.begin(), lines.end(), std::size_t{0});
  if (missing == lines.end()) return lattice;
  const int at = static_cast<int>(missing - lines.begin());
  const int column = at % x.count, row = at / x.count;
  fail_at(
      shown_name, 0,
      fmt::format("has {} points, but the lattice of {} by {} lacks ({:.6g}, {:.6g})", rows.size(),
                  x.count, y.count, x.first + column * x.step, y.first + row * y.step),
      regular);
}

namespace {

/// First of the four points around a position, and Lagrange's weights there.
struct Stencil {
  int first;
  std::array<double, 4> weight;
};

Stencil stencil_at(double position, int count) {
  const int first = std::clamp(static_cast<int>(std::floor(position)) - 1, 0, count - 4);
  const double t = position - first;
  return {first,
          {(t - 1) * (t - 2) * (t - 3) / -6.0, t * (t - 2) * (t - 3) / 2.0,
           t * (t - 1) * (t - 3) / -2.0, t * (t - 1) * (t - 2) / 6.0}};
}

}  // namespace

double lattice_value(const Lattice& lattice, int column, double x, double y) {
  const Stencil along = stencil_at((x - lattice.x_first) / lattice.dx, lattice.nx);
  const Stencil across = stencil_at((y - lattice.y_first) / lattice.dy, lattice.ny);
  const std::vector<double>& values = lattice.values.at(static_cast<std::size_t>(column));
  double sum = 0.0;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      sum += across.weight[j] * along.weight[i] *
             values[static_cast<std::size_t>(across.first + j) * lattice.nx + along.first + i];
  return sum;
}

bool covers(const Lattice& lattice, const ContactGrid& grid) {
  const auto within = [](double first, double last, double low, double step, int count) {
    return first >= low - 1e-6 * step && last <= low + (count - 1 + 1e-6) * step;
  };
  return within(grid.x(0), grid.x(grid.nx - 1), lattice.x_first, lattice.dx, lattice.nx) &&
         within(grid.y(0), grid.y(grid.ny - 1), lattice.y_first, lattice.dy, lattice.ny);
}

Field sample_lattice(const Lattice& lattice, int column, const ContactGrid& grid,
                     const std::string& what) {
  if (!covers(lattice, grid))
    throw InputError(fmt::format(
        "{} = \"{}\": its points cover x from {:.6g} to {:.6g}, y from {:.6g} to {:.6g} mm, but "
        "the contact grid extends from {:.6g} to {:.6g} and from {:.6g} to {:.6g}; do: give points "
        "over a larger area, or make contact_grid.extent smaller",
        what, lattice.file, lattice.x_first, lattice.x_first + (lattice.nx - 1) * lattice.dx,
        lattice.y_first, lattice.y_first + (lattice.ny - 1) * lattice.dy, grid.x(0),
        grid.x(grid.nx - 1), grid.y(0), grid.y(grid.ny - 1)));
  return grid.sample([&](double x, double y) { return lattice_value(lattice, column, x, y); });
}

}  // namespace rollfem::contact
