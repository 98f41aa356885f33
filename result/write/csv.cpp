// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/write/csv.hpp"

#include "result/bars.hpp"
#include "result/derived.hpp"
#include "result/patch_size.hpp"
#include "result/quantities.hpp"
#include "result/stress_measures.hpp"
#include "result/write/columns.hpp"
#include "result/write/contents.hpp"
#include "result/write/wheelset_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace rollfem::result {
namespace {

using contact::ContactGrid;
using contact::Field;
using contact::ModelResult;
using contact::PointResult;
using contact::Quantity;

/// A load point as a row of a table.
struct Line {
  const ModelResult* model;
  std::size_t number;
  const PointResult& point() const { return model->points[number]; }
  const contact::ContactPlace& place() const { return *model->place; }
};

std::vector<Line> lines_of(const RunRecord& run) {
  std::vector<Line> lines;
  for (const ModelResult& model : run.models)
    for (std::size_t number = 0; number < model.points.size(); ++number)
      lines.push_back({&model, number});
  return lines;
}

Columns<Line> model_and_point() {
  Columns<Line> columns;
  columns.add("model", "", [](const Line& line) { return line.model->name; });
  columns.add("point", "", [](const Line& line) { return line.number + 1; });
  return columns;
}

/// Where the patch is, with profiles, then model and load point.
Columns<Line> first_columns(const RunRecord& run) {
  Columns<Line> columns;
  if (std::any_of(run.models.begin(), run.models.end(),
                  [](const ModelResult& model) { return model.place.has_value(); })) {
    columns.add("wheel", "", [](const Line& line) { return line.place().side(); });
    columns.add("position", "", [](const Line& line) { return line.place().position; });
    columns.add("patch", "", [](const Line& line) { return line.place().patch; });
  }
  columns.append(model_and_point());
  return columns;
}

/// Whether a quantity has a column for its bar: not counts and times, but given values, which may
/// be results in other problems.
bool may_have_bar(const Quantity& quantity) {
  return quantity.no_bar.value_or(contact::NoBar::given) == contact::NoBar::given;
}

void add_value(Columns<Line>& columns, const Quantity& quantity) {
  columns.add(quantity.name, quantity.unit,
              [&quantity](const Line& line) { return quantity.value(line.point()); });
}

/// The bar, or the word instead of it; empty without a value.
std::string bar_cell(const PointResult& point, const std::string& name) {
  if (point.has_bar(name)) return csv_cell(point.bar_of(name));
  const auto word = point.no_bar.find(name);
  return word == point.no_bar.end() ? "" : word_of(word->second);
}

void add_bar(Columns<Line>& columns, const Quantity& quantity) {
  columns.add(std::string("error_estimate ") + quantity.name, quantity.unit,
              [name = std::string(quantity.name)](const Line& line) {
                return bar_cell(line.point(), name);
              });
}

void add_model_error(Columns<Line>& columns, const Quantity& quantity) {
  columns.add(std::string("model_error ") + quantity.name, quantity.unit,
              [name = std::string(quantity.name)](const Line& line) -> std::optional<double> {
                const auto error = line.point().model_error.find(name);
                if (error == line.point().model_error.end()) return {};
                return error->second;
              });
}

/// Rows of the parts of load points, `parts_of(line)`; without any empty, or the head alone.
template <class Part, class Parts>
std::string table_of_parts(const RunRecord& run, const Columns<Part>& columns,
                           const Parts& parts_of, bool head_alone = false) {
  const Columns<Line> first = first_columns(run);
  std::string text;
  for (const Line& line : lines_of(run)) {
    const std::string begin = first.line(line) + ',';
    for (const Part& part : parts_of(line)) text += begin + columns.line(part) + '\n';
  }
  if (text.empty() && !head_alone) return text;
  return first.head() + ',' + columns.head() + '\n' + text;
}

}  // namespace

std::vector<int> middle_lines(double first, double step, int count) {
  if (count < 1 || !(step > 0.0)) return {};
  const double position = -first / step;  // position of the origin, in elements
  const double below = std::floor(position);
  const bool between = std::abs(position - below - 0.5) < 1e-6;
  const auto clamp = [count](double k) {
    return static_cast<int>(std::clamp(k, 0.0, static_cast<double>(count - 1)));
  };
  const int low = between ? clamp(below) : clamp(std::round(position));
  const int high = between ? clamp(below + 1.0) : low;
  return low == high ? std::vector<int>{low} : std::vector<int>{low, high};
}

std::string quoted(const std::string& text) {
  // A spreadsheet would compute a text that begins like a formula.
  const bool formula =
      !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos;
  std::string out = formula ? "\"'" : "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

std::string creep_curve_csv(const RunRecord& run) {
  Columns<Line> columns = first_columns(run);
  for (const Quantity& quantity : contact::quantities()) add_value(columns, quantity);
  for (const auto add : {add_bar, add_model_error})
    for (const Quantity& quantity : contact::quantities())
      if (may_have_bar(quantity)) add(columns, quantity);
  return columns.table(lines_of(run));
}

namespace {

/// A point below the surface.
struct Below {
  const contact::SubsurfaceField* field;
  std::size_t k;
};

const Columns<Below>& below_columns() {
  static const Columns<Below> all = [] {
    using F = contact::SubsurfaceField;
    Columns<Below> columns;
    columns.add("distance", "mm", [](const Below& below) {
      const auto &at = below.field->points[below.k], &from = below.field->points.front();
      return std::hypot(at[0] - from[0], at[1] - from[1], at[2] - from[2]);
    });
    const auto add = [&](auto member, const char* unit, std::initializer_list<const char*> names) {
      for (std::size_t c = 0; c < names.size(); ++c)
        columns.add(names.begin()[c], unit,
                    [member, c](const Below& below) { return (below.field->*member)[below.k][c]; });
    };
    add(&F::points, "mm", {"x", "y", "z"});
    add(&F::displacement, "mm", {"displacement_x", "displacement_y", "displacement_z"});
    add(&F::stress, "MPa", {"xx", "yy", "zz", "xy", "yz", "xz"});
    using contact::SymmetricTensor;
    for (const contact::StressMeasure& measure : std::initializer_list<contact::StressMeasure>{
             {"hydrostatic", contact::hydrostatic},
             {"von_mises", contact::von_mises},
             {"tresca", contact::tresca},
             {"orthogonal_shear", contact::orthogonal_shear},
             {"principal_1",
              [](const SymmetricTensor& stress) { return contact::principal(stress)[0]; }},
             {"principal_2",
              [](const SymmetricTensor& stress) { return contact::principal(stress)[1]; }},
             {"principal_3",
              [](const SymmetricTensor& stress) { return contact::principal(stress)[2]; }}})
      columns.add(measure.name, "MPa", [value = measure.value](const Below& below) {
        return value(below.field->stress[below.k]);
      });
    return columns;
  }();
  return all;
}

}  // namespace

std::string subsurface_csv(const RunRecord& run) {
  using InSet = std::pair<std::size_t, Below>;
  Columns<InSet> columns;
  columns.add("set", "", [](const InSet& row) { return row.first; });
  columns.add("body", "", [](const InSet& row) { return row.second.field->body(); });
  columns.append(below_columns(), &InSet::second);
  return table_of_parts(run, columns, [](const Line& line) {
    std::vector<InSet> rows;
    const auto& fields = line.point().subsurface;
    for (std::size_t set = 0; set < fields.size(); ++set)
      if (fields[set].request.kind != contact::SubsurfaceRequest::Kind::plane)
        for (std::size_t k = 0; k < fields[set].points.size(); ++k)
          rows.push_back({set, {&fields[set], k}});
    return rows;
  });
}

std::string contacts_csv(const RunRecord& run) {
  static const char* const main_results[] = {
      "longitudinal_creepage", "lateral_creepage", "spin",           "normal_force",
      "longitudinal_force",    "lateral_force",    "max_pressure",   "contact_length",
      "contact_width",         "approach",         "vertical_force", "lateral_force_track",
      "loaded_height"};
  Columns<Line> columns;
  columns.add_members<contact::ContactPlace>(
      [](const Line& line) -> const contact::ContactPlace& { return line.place(); });
  for (const WayScalar& way : ways_of(run.input))
    columns.add(way.name, way.unit,
                [&run, way](const Line& line) { return way.at(run.input, line.place().position); });
  columns.append(model_and_point());
  for (const char* name : main_results) add_value(columns, contact::quantity_named(name));
  columns.add("contact_elements", "-",
              [](const Line& line) { return line.model->contact_elements; });
  for (const char* name : main_results) add_bar(columns, contact::quantity_named(name));
  std::vector<Line> lines;
  for (const Line& line : lines_of(run))
    if (line.model->place) lines.push_back(line);
  return lines.empty() ? "" : columns.table(lines);
}

std::string patches_csv(const RunRecord& run) {
  using Region = std::pair<std::size_t, contact::PatchPart>;
  Columns<Region> columns;
  columns.add("region", "-", &Region::first);
  columns.add_members<contact::PatchPart>(&Region::second);
  columns.add("error_estimate", "",
              [](const Region&) { return word_of(contact::NoBar::one_grid); });
  return table_of_parts(run, columns, [](const Line& line) {
    std::vector<Region> regions;
    if (line.point().patch_count > 1)
      for (const auto& part : contact::patch_parts(line.model->grid, line.point().fields))
        regions.push_back({regions.size() + 1, part});
    return regions;
  });
}

std::string pass_work_csv(const RunRecord& run) {
  struct Row {
    double y, y_wheel, y_rail, width, work;
    std::string bar;
  };
  Columns<Row> columns;
  columns.add("y", "mm", &Row::y);
  columns.add("y_wheel", "mm", &Row::y_wheel);
  columns.add("y_rail", "mm", &Row::y_rail);
  columns.add("width", "mm", &Row::width);
  columns.add("pass_work", "N/mm", &Row::work);
  columns.add("error_estimate", "N/mm", &Row::bar);
  return table_of_parts(run, columns, [](const Line& line) {
    const Field work = contact::pass_work(line.model->grid, line.point());
    const contact::ProfileRows& at = line.model->rows;
    std::vector<Row> rows;
    for (int j = 0; j < static_cast<int>(work.size()); ++j)
      if (work[j] != 0.0)
        rows.push_back({line.model->grid.y(j), at.y_wheel[j], at.y_rail[j], at.width[j], work[j],
                        bar_cell(line.point(), "max_pass_work")});
    return rows;
  });
}

std::string path_csv(const RunRecord& run, Path path) {
  /// Element k along the path; values are the mean over the middle rows or columns.
  struct Row {
    const Line* line;
    Path path;
    const std::vector<int>* across;
    int k;
    const ContactGrid& grid() const { return line->model->grid; }
    std::optional<double> mean(const Field& field) const {
      if (field.size() == 0) return {};
      double sum = 0.0;
      for (const int at : *across)
        sum += field[path == Path::x ? grid().index(k, at) : grid().index(at, k)];
      return sum / static_cast<double>(across->size());
    }
  };
  Columns<Row> columns;
  for (const char* name : {"longitudinal_creepage", "lateral_creepage", "spin"}) {
    const Quantity& motion = contact::quantity_named(name);
    columns.add(name, motion.unit,
                [&motion](const Row& row) { return motion.value(row.line->point()); });
  }
  columns.add(path == Path::x ? "x" : "y", "mm", [](const Row& row) {
    return row.path == Path::x ? row.grid().x(row.k) : row.grid().y(row.k);
  });
  for (const contact::PointField& field : contact::point_fields())
    columns.add(field.name, field.unit, [&field](const Row& row) {
      return row.mean(field.value(row.line->point().fields));
    });
  std::vector<int> across;
  const auto rows_of = [&](const Line& line) {
    const ContactGrid& grid = line.model->grid;
    across = path == Path::x ? middle_lines(grid.y_first, grid.dy, grid.ny)
                             : middle_lines(grid.x_first, grid.dx, grid.nx);
    std::vector<Row> rows;
    if (keeps_grid(run.input, *line.model, line.number) && !across.empty())
      for (int k = 0; k < (path == Path::x ? grid.nx : grid.ny); ++k)
        rows.push_back({&line, path, &across, k});
    return rows;
  };
  return table_of_parts(run, columns, rows_of, true);
}

}  // namespace rollfem::result
