// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/write/csv.hpp"

#include "contact/result/bars.hpp"
#include "contact/result/derived.hpp"
#include "contact/result/patch_size.hpp"
#include "contact/result/quantities.hpp"
#include "contact/result/stress_measures.hpp"
#include "postprocess/write/point_table.hpp"
#include "postprocess/write/wheelset_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rollfem::postprocess {
namespace {

using contact::ContactGrid;
using contact::Field;
using contact::ModelResult;
using contact::PointResult;
using contact::Quantity;

std::string header(const std::string& name, const std::string& unit) {
  return fmt::format(",{} [{}]", name, unit);
}

/// Whether a quantity has a column for its bar: not counts and times, but given values, which may
/// be results in other problems.
bool may_have_bar(const Quantity& quantity) {
  const std::string word = quantity.no_bar;
  return word.empty() || word == contact::no_bar::given;
}

/// The bar, or the word instead of it; empty without a value.
std::string bar_cell(const PointResult& point, const std::string& name) {
  if (const auto bar = point.error_estimate.find(name); bar != point.error_estimate.end())
    return fmt::format(",{}", bar->second);
  const auto word = point.no_bar.find(name);
  return word == point.no_bar.end() ? "," : "," + word->second;
}

std::string model_error_cell(const PointResult& point, const std::string& name) {
  const auto error = point.model_error.find(name);
  return error == point.model_error.end() ? "," : fmt::format(",{}", error->second);
}

/// Whether rows have columns for the patch, as with profiles.
bool has_places(const RunRecord& run) {
  return std::any_of(run.models.begin(), run.models.end(),
                     [](const ModelResult& model) { return model.place.has_value(); });
}

std::string place_head(const RunRecord& run) {
  return has_places(run) ? "wheel,position,patch," : "";
}

std::string place_cells(const ModelResult& model) {
  return model.place ? model.place->key(',') + ',' : "";
}

/// Mean over the middle rows or columns at position k along the path.
double along_path(const ContactGrid& grid, const Field& field, Path path,
                  const std::vector<int>& lines, int k) {
  double sum = 0.0;
  for (const int line : lines)
    sum += field[path == Path::x ? grid.index(k, line) : grid.index(line, k)];
  return sum / static_cast<double>(lines.size());
}

void append_path(std::string& text, const ModelResult& model, std::size_t number, Path path) {
  const ContactGrid& grid = model.grid;
  const PointResult& point = model.points[number];
  const std::vector<int> lines = path == Path::x ? middle_lines(grid.y_first, grid.dy, grid.ny)
                                                 : middle_lines(grid.x_first, grid.dx, grid.nx);
  if (lines.empty()) return;
  const int count = path == Path::x ? grid.nx : grid.ny;
  for (int k = 0; k < count; ++k) {
    fmt::format_to(std::back_inserter(text), "{}{},{},{},{},{},{}", place_cells(model), model.name,
                   number + 1, point.creepage.longitudinal, point.creepage.lateral,
                   point.creepage.spin, path == Path::x ? grid.x(k) : grid.y(k));
    for (const PointField& field : point_fields()) {
      const Field& values = field.value(point.fields);
      text += ',';
      if (values.size() > 0)
        fmt::format_to(std::back_inserter(text), "{}", along_path(grid, values, path, lines, k));
    }
    text += '\n';
  }
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

std::string csv_cell(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : std::string();
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
  std::string text = place_head(run) + "model,point";
  for (const Quantity& quantity : contact::quantities())
    text += header(quantity.name, quantity.unit);
  std::vector<Quantity> with_bar;
  for (const Quantity& quantity : contact::quantities())
    if (may_have_bar(quantity)) with_bar.push_back(quantity);
  for (const char* what : {"error_estimate", "model_error"})
    for (const Quantity& quantity : with_bar)
      text += header(fmt::format("{} {}", what, quantity.name), quantity.unit);
  text += '\n';
  for (const ModelResult& model : run.models)
    for (std::size_t k = 0; k < model.points.size(); ++k) {
      const PointResult& point = model.points[k];
      text += fmt::format("{}{},{}", place_cells(model), model.name, k + 1);
      for (const Quantity& quantity : contact::quantities())
        text += ',' + csv_cell(quantity.value(point));
      for (const Quantity& quantity : with_bar) text += bar_cell(point, quantity.name);
      for (const Quantity& quantity : with_bar) text += model_error_cell(point, quantity.name);
      text += '\n';
    }
  return text;
}

std::string subsurface_columns() {
  return "distance [mm],x [mm],y [mm],z [mm],displacement_x [mm],displacement_y "
         "[mm],displacement_z [mm],xx [MPa],yy [MPa],zz [MPa],xy [MPa],yz [MPa],xz "
         "[MPa],hydrostatic [MPa],von_mises [MPa],tresca [MPa],orthogonal_shear "
         "[MPa],principal_1 [MPa],principal_2 [MPa],principal_3 [MPa]";
}

std::string subsurface_row(const contact::SubsurfaceField& field, std::size_t k) {
  const auto& at = field.points[k];
  const auto& from = field.points.front();
  std::string text =
      fmt::format("{},{},{},{}", std::hypot(at[0] - from[0], at[1] - from[1], at[2] - from[2]),
                  at[0], at[1], at[2]);
  for (const double value : field.displacement[k])
    fmt::format_to(std::back_inserter(text), ",{}", value);
  for (const double value : field.stress[k]) fmt::format_to(std::back_inserter(text), ",{}", value);
  const contact::Stress stress = contact::Stress::from_array(field.stress[k]);
  const auto main = contact::principal(stress);
  fmt::format_to(std::back_inserter(text), ",{},{},{},{},{},{},{}", contact::hydrostatic(stress),
                 contact::von_mises(stress), contact::tresca(stress),
                 contact::orthogonal_shear(stress), main[0], main[1], main[2]);
  return text;
}

namespace {

void append_subsurface(std::string& text, const std::string& model, std::size_t number,
                       std::size_t set, const contact::SubsurfaceField& field) {
  for (std::size_t k = 0; k < field.points.size(); ++k)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", model, number + 1, set,
                   field.request.wheel ? "wheel" : "rail", subsurface_row(field, k));
}

}  // namespace

std::string subsurface_csv(const RunRecord& run) {
  std::string text;
  for (const ModelResult& model : run.models)
    for (std::size_t k = 0; k < model.points.size(); ++k) {
      const auto& fields = model.points[k].subsurface;
      for (std::size_t set = 0; set < fields.size(); ++set)
        if (fields[set].request.kind != contact::SubsurfaceRequest::Kind::plane)
          append_subsurface(text, place_cells(model) + model.name, k, set, fields[set]);
    }
  if (text.empty()) return text;
  return place_head(run) + "model,point,set,body," + subsurface_columns() + "\n" + text;
}

std::string contacts_csv(const RunRecord& run) {
  if (!has_places(run)) return {};
  static const char* const main_results[] = {
      "longitudinal_creepage", "lateral_creepage", "spin",           "normal_force",
      "longitudinal_force",    "lateral_force",    "max_pressure",   "contact_length",
      "contact_width",         "approach",         "vertical_force", "lateral_force_track",
      "loaded_height"};
  std::string text = "wheel";
  for (const PlaceScalar& scalar : place_scalars()) text += header(scalar.name, scalar.unit);
  const std::vector<WayScalar> ways = ways_of(run.input);
  for (const WayScalar& way : ways) text += header(way.name, way.unit);
  text += ",model,point";
  for (const char* name : main_results) text += header(name, contact::quantity_named(name).unit);
  text += ",contact_elements [-]";
  for (const char* name : main_results)
    text += header(std::string("error_estimate ") + name, contact::quantity_named(name).unit);
  text += '\n';
  for (const ModelResult& model : run.models) {
    if (!model.place) continue;
    std::string place = model.place->side();
    for (const PlaceScalar& scalar : place_scalars())
      place += fmt::format(",{}", scalar.value(*model.place));
    for (const WayScalar& way : ways)
      place += fmt::format(",{}", way.at(run.input, model.place->position));
    for (std::size_t k = 0; k < model.points.size(); ++k) {
      text += fmt::format("{},{},{}", place, model.name, k + 1);
      for (const char* name : main_results)
        text += ',' + csv_cell(contact::quantity_named(name).value(model.points[k]));
      text += fmt::format(",{}", model.contact_elements);
      for (const char* name : main_results) text += bar_cell(model.points[k], name);
      text += '\n';
    }
  }
  return text;
}

std::string patches_csv(const RunRecord& run) {
  std::string text;
  for (const ModelResult& model : run.models)
    for (std::size_t k = 0; k < model.points.size(); ++k) {
      if (model.points[k].patch_count < 2) continue;
      int number = 0;
      for (const auto& part : contact::patch_parts(model.grid, model.points[k].fields))
        text += fmt::format("{}{},{},{},{},{},{},{},{},{},{},{},{}\n", place_cells(model),
                            model.name, k + 1, ++number, part.x, part.y, part.length, part.width,
                            part.normal_force, part.longitudinal_force, part.lateral_force,
                            part.max_pressure, contact::no_bar::one_grid);
    }
  if (text.empty()) return text;
  return place_head(run) +
         "model,point,region [-],x [mm],y [mm],length [mm],width [mm],normal_force [N],"
         "longitudinal_force [N],lateral_force [N],max_pressure [MPa],error_estimate\n" +
         text;
}

std::string pass_work_csv(const RunRecord& run) {
  std::string text;
  for (const ModelResult& model : run.models)
    for (std::size_t k = 0; k < model.points.size(); ++k) {
      const Field work = contact::pass_work(model.grid, model.points[k]);
      const contact::ProfileRows& rows = model.rows;
      for (int j = 0; j < static_cast<int>(work.size()); ++j)
        if (work[j] != 0.0)
          text += fmt::format("{}{},{},{},{},{},{},{}{}\n", place_cells(model), model.name, k + 1,
                              model.grid.y(j), rows.y_wheel[j], rows.y_rail[j], rows.width[j],
                              work[j], bar_cell(model.points[k], "max_pass_work"));
    }
  if (text.empty()) return text;
  return place_head(run) +
         "model,point,y [mm],y_wheel [mm],y_rail [mm],width [mm],pass_work [N/mm],error_estimate "
         "[N/mm]\n" +
         text;
}

std::string path_csv(const RunRecord& run, Path path) {
  std::string text =
      place_head(run) + "model,point,longitudinal_creepage [-],lateral_creepage [-],spin [rad/mm]";
  text += header(path == Path::x ? "x" : "y", "mm");
  for (const PointField& field : point_fields()) text += header(field.name, field.unit);
  text += '\n';
  for (const ModelResult& model : run.models)
    for (std::size_t k = 0; k < model.points.size(); ++k)
      if (run.input.output.keeps_grid(k, model.points.size())) append_path(text, model, k, path);
  return text;
}

}  // namespace rollfem::postprocess
