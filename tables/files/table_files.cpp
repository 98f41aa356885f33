// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tables/files/table_files.hpp"

#include "base/errors.hpp"
#include "result/files/seal.hpp"
#include "result/hdf5/hdf5_objects.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <iterator>

namespace rollfem::tables {

namespace {

const char* const creepage_columns =
    ",longitudinal_scaled [-],lateral_scaled [-],spin_scaled [-],longitudinal_force [mu "
    "F_n],lateral_force [mu F_n],spin_moment [mu F_n c],";

/// Names of the axes other than the creepages.
std::string first_columns(const CreepTable& table) {
  return std::string(table.load.size() > 1 ? "load [N]," : "") +
         (table.speed.size() > 1 ? "speed [mm/s]," : "") +
         (table.over_shifts() ? "lateral_shift [mm]" : "axis_ratio [-]");
}

std::string values_of(const CreepTable& table, const TablePlace& place) {
  return (table.load.size() > 1 ? fmt::format("{},", place.load) : "") +
         (table.speed.size() > 1 ? fmt::format("{},", place.speed) : "") +
         fmt::format("{}", place.first);
}

using namespace result::hdf5;

const char* const table_format = "rollfem table";
/// Version 1 had axis ratios only, version 2 neither load nor speed; their content is unchanged.
constexpr long table_version = 3;

const char* const table_conventions =
    "Scaled creepages: xi' = xi G a b C11 / (3 mu F_n), eta' = eta G a b C22 / (3 mu F_n), phi' = "
    "phi G (a b)^(3/2) sqrt(C23^2 + C33^2) / (mu F_n); G combined shear modulus, C Kalker's "
    "coefficients, a along rolling. Axes of load (in the case's terms) and speed come before those "
    "named below if they have several values. Forces act on the wheel, F_x and F_y over mu F_n, "
    "M_z over mu "
    "F_n sqrt(a b). ";
const char* const ratio_conventions =
    "Arrays [axis_ratio, longitudinal, lateral, spin]. At -xi' F_x changes sign; at -eta' and "
    "-phi' F_y and M_z change sign.";
const char* const shift_conventions =
    "Arrays [lateral_shift, longitudinal, lateral, spin]. Creepages and forces are those of the "
    "main contact, the most loaded one, in its frame; the other contacts of the wheel move with it "
    "as one rigid body, and forces are the sums over all contacts; F_n is the sum of their normal "
    "forces. Forces are friction only; the group wheel holds the force of the pressure. G is "
    "shear_modulus, a and b "
    "are wheel/semi_axis_x and wheel/semi_axis_y. The table holds for the load of the case.";

constexpr std::pair<const char*, std::string CreepTable::*> table_texts[] = {
    {"title", &CreepTable::title},
    {"program", &CreepTable::program},
    {"command", &CreepTable::command},
    {"started", &CreepTable::started},
    {"case_file", &CreepTable::case_file}};

/// An axis in the group axes; not there without values.
struct Axis {
  const char *name, *unit, *says;
  std::vector<double> CreepTable::*values;
};
constexpr Axis table_axes[] = {
    {"axis_ratio", "1", "a/b of the ellipse, a along rolling", &CreepTable::axis_ratio},
    {"lateral_shift", "mm", "lateral shift of the wheelset", &CreepTable::lateral_shift},
    {"load", "N", "force under [load] that the forces are computed for", &CreepTable::load},
    {"speed", "mm/s", "rolling speed that the forces are computed for", &CreepTable::speed},
    {"mean_axis", "mm", "sqrt(a b) of every ratio at the first load", &CreepTable::mean_axis}};
constexpr std::array<const char*, 2> creepage_axes[] = {
    {"longitudinal", "xi', scaled longitudinal creepage"},
    {"lateral", "eta', scaled lateral creepage"},
    {"spin", "phi', scaled spin"}};

/// The numbers of every point, with unit and meaning; the last one over lateral shifts only.
constexpr std::array<const char*, 3> point_columns[] = {
    {"longitudinal_force", "mu F_n", "F_x"},
    {"lateral_force", "mu F_n", "F_y"},
    {"spin_moment", "mu F_n c", "M_z, c = sqrt(a b)"},
    {"force_bar", "mu F_n", "error bar of the force vector"},
    {"moment_bar", "mu F_n c", "error bar of M_z"},
    {"force_along_normal", "mu F_n",
     "force of friction along the normal of the main contact: nonzero on a curved surface and with "
     "contacts in other planes"},
    {"temperature_rise", "(mu F_n)^2 sqrt(V) / (G beta c^3.5)",
     "largest rise of the temperature in contact by friction, beta of the group heat"}};

std::vector<std::size_t> columns_of(const CreepTable& table) {
  std::vector<std::size_t> columns{0, 1, 2, 3, 4};
  if (table.over_shifts()) columns.push_back(5);
  if (table.heat) columns.push_back(6);
  return columns;
}

template <class Table>
auto& number_of(Table& table, std::size_t point, std::size_t column) {
  if (column < 3) return table.forces[point][column];
  if (column < 5) return table.bars[point][column - 3];
  return column == 5 ? table.along_normal[point] : table.rise[point];
}

void write_axes(hid_t file, const CreepTable& table) {
  const Handle group = create_group(file, "axes", "The axes of the arrays");
  for (const auto& [name, unit, says, values] : table_axes)
    if (!(table.*values).empty())
      write_values(group, name, table.*values, unit, says,
                   values == &CreepTable::lateral_shift ? "positive to the right" : "");
  for (std::size_t q = 0; q < 3; ++q)
    write_values(group, creepage_axes[q][0], table.creepage[q], "1", creepage_axes[q][1]);
  write_rows(group, "scale", table.scale, "1",
             "For every ratio, or load and shift (fastest): C11/3, C22/3 and sqrt(C23^2 + C33^2), "
             "the factors of xi G a b/(mu "
             "F_n), eta "
             "G a b/(mu F_n) and phi G (a b)^(3/2)/(mu F_n); interpolation uses their logarithms");
}

void write_friction(hid_t group, const CreepTable& table) {
  write_attribute(group, "shear_modulus", table.shear_modulus);
  write_attribute(group, "friction_coefficient", table.friction_coefficient);
  if (!table.only_for.empty()) write_attribute(group, "only_for", table.only_for);
  if (!table.over_shifts()) write_attribute(group, "load_sets", static_cast<long>(table.load_sets));
}

void write_wheels(hid_t file, const CreepTable& table) {
  const Handle group = create_group(
      file, "wheel", "The wheel at every load and lateral shift, loaded without friction");
  write_friction(group, table);
  std::vector<hsize_t> shape{table.lateral_shift.size()};
  if (table.load.size() > 1) shape.insert(shape.begin(), table.load.size());
  for (const WheelColumn& entry : wheel_columns()) {
    std::vector<double> values;
    for (const TableWheel& wheel : table.wheels) values.push_back(wheel.*entry.member);
    write_values(group, entry.name, values, entry.unit, entry.says, "", shape);
  }
}

void write_interpolation(hid_t file, const CreepTable& table) {
  const InterpolationError& error = table.interpolation;
  const Handle group = create_group(file, "interpolation",
                                    "Errors of interpolation at random points between the grid "
                                    "points:  forces over mu F_n, the moment over mu F_n c");
  write_attribute(group, "points", static_cast<long>(error.points));
  write_attribute(group, "seed", static_cast<long>(error.seed));
  for (const auto& [name, member] : interpolation_errors)
    write_attribute(group, name, error.*member);
  if (table.checked.empty()) return;
  std::vector<std::array<double, 12>> rows;
  for (const InterpolatedPoint& p : table.checked)
    rows.push_back({p.place.first, p.creepage[0], p.creepage[1], p.creepage[2], p.interpolated[0],
                    p.interpolated[1], p.interpolated[2], p.solved[0], p.solved[1], p.solved[2],
                    p.place.load, p.place.speed});
  write_rows(group, "checked", rows, "1",
             "a/b or lateral shift, xi', eta', phi', then F_x, F_y, M_z as interpolated and as "
             "solved for, then load and speed, 0 where the table has none");
}

void write_points(hid_t file, const CreepTable& table) {
  const std::vector<std::size_t> lengths = table.shape();
  const std::vector<hsize_t> shape(lengths.begin(), lengths.end());
  for (const std::size_t c : columns_of(table)) {
    std::vector<double> values(table.size());
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = number_of(table, k, c);
    const auto& [name, unit, says] = point_columns[c];
    write_values(file, name, values, unit, says, c == 6 ? "" : "on the wheel", shape);
  }
  if (table.heat) {
    const Handle group = create_group(file, "heat",
                                      "Of the case: effusivity of both bodies together in N/(mm K "
                                      "s^0.5), temperature in contact before friction heats it in "
                                      "degC, speed in mm/s, shear modulus in MPa");
    for (const auto& [name, member] : heat_numbers)
      write_attribute(group, name, *table.heat.*member);
  }
  write_values(file, "elements_across", table.elements_across, "1",
               "contact elements across the patch on the finest grid", "", shape);
}

const char* const table_wanted = "name a table.h5 written by rollfem table";

[[noreturn]] void refuse_file(const std::string& path, const std::string& why) {
  throw contact::FileError(fmt::format("{}: {}; do: {}", path, why, table_wanted));
}

std::vector<double> numbers_of(hid_t parent, const char* name) {
  return read_dataset(parent, name).values;
}

void read_friction(hid_t group, CreepTable& table) {
  table.shear_modulus = read_number(group, "shear_modulus");
  table.friction_coefficient = read_number(group, "friction_coefficient");
  if (has_attribute(group, "only_for")) table.only_for = read_text(group, "only_for");
  if (!has_attribute(group, "load_sets")) return;
  const double sets = read_number(group, "load_sets");
  if (!(sets >= 0.0 && sets <= static_cast<double>(LoadSets::all)))
    throw std::runtime_error("what its load sets is not known");
  table.load_sets = static_cast<LoadSets>(sets);
}

void read_wheels(hid_t file, CreepTable& table) {
  const Handle group = open_group(file, "wheel");
  read_friction(group, table);
  table.wheels.resize(table.loads() * table.lateral_shift.size());
  for (const WheelColumn& entry : wheel_columns()) {
    const std::vector<double> values = numbers_of(group, entry.name);
    if (values.size() != table.wheels.size())
      throw std::runtime_error("its wheels do not fit its lateral shifts");
    for (std::size_t k = 0; k < values.size(); ++k) table.wheels[k].*entry.member = values[k];
  }
}

void read_points(hid_t file, CreepTable& table) {
  for (const double across : numbers_of(file, "elements_across"))
    table.elements_across.push_back(static_cast<int>(across));
  const std::size_t count = table.elements_across.size();
  table.forces.resize(count);
  table.bars.resize(count);
  if (table.over_shifts()) table.along_normal.resize(count);
  if (has_member(file, "heat")) {
    const Handle group = open_group(file, "heat");
    table.heat.emplace();
    for (const auto& [name, member] : heat_numbers) *table.heat.*member = read_number(group, name);
    table.rise.resize(count);
  }
  for (const std::size_t c : columns_of(table)) {
    const std::vector<double> values = numbers_of(file, point_columns[c][0]);
    if (values.size() != count) throw std::runtime_error("its arrays have different sizes");
    for (std::size_t k = 0; k < count; ++k) number_of(table, k, c) = values[k];
  }
}

CreepTable table_of(hid_t file) {
  CreepTable table;
  for (const auto& [name, member] : table_texts) table.*member = read_text(file, name);
  table.poisson_ratio = read_number(file, "poisson_ratio");
  for (const std::string& line : read_lines(file, "case_text")) table.case_text += line;
  const Handle axes = open_group(file, "axes");
  for (const Axis& axis : table_axes)
    if (has_member(axes, axis.name)) table.*axis.values = numbers_of(axes, axis.name);
  if (table.first_axis().empty()) throw std::runtime_error("there is no dataset axis_ratio");
  for (std::size_t q = 0; q < 3; ++q) table.creepage[q] = numbers_of(axes, creepage_axes[q][0]);
  if (table.over_shifts()) read_wheels(file, table);
  if (has_member(file, "friction")) read_friction(open_group(file, "friction"), table);
  table.scale = read_rows<3>(axes, "scale");
  read_points(file, table);
  return table;
}

void read_interpolation(hid_t file, CreepTable& table) {
  const Handle group = open_group(file, "interpolation");
  InterpolationError& error = table.interpolation;
  error.points = static_cast<int>(read_number(group, "points"));
  error.seed = static_cast<unsigned>(read_number(group, "seed"));
  for (const auto& [name, member] : interpolation_errors) error.*member = read_number(group, name);
  if (!has_member(group, "checked")) return;
  const Numbers found = read_dataset(group, "checked");
  const std::size_t wide = found.shape.size() == 2 ? found.shape[1] : 0;
  if (wide != 10 && wide != 12)  // 10: before version 3
    throw std::runtime_error("its checked points have the wrong shape");
  for (std::size_t k = 0; k < found.values.size(); k += wide) {
    const double* r = &found.values[k];
    const TablePlace place = wide == 12 ? TablePlace(r[0], r[10], r[11]) : TablePlace(r[0]);
    table.checked.push_back({place, {r[1], r[2], r[3]}, {r[4], r[5], r[6]}, {r[7], r[8], r[9]}});
  }
}

}  // namespace

std::string table_csv(const CreepTable& table) {
  std::string text =
      first_columns(table) + creepage_columns +
      "force_bar [mu F_n],moment_bar [mu F_n c],elements_across [-]" +
      (table.over_shifts() ? ",force_along_normal [mu F_n]" : "") +
      (table.heat ? ",temperature_rise [(mu F_n)^2 sqrt(V) / (G beta c^3.5)]\n" : "\n");
  const auto& [xi, eta, phi] = table.creepage;
  std::size_t at = 0;
  for (std::size_t node = 0; node < table.nodes(); ++node) {
    const std::string place = values_of(table, table.node(node));
    for (const double x : xi)
      for (const double y : eta)
        for (const double z : phi) {
          const Scaled& force = table.forces[at];
          fmt::format_to(std::back_inserter(text),
                         "{},{},{},{},{:.7g},{:.7g},{:.7g},{:.2g},{:.2g},{}", place, x, y, z,
                         force[0], force[1], force[2], table.bars[at][0], table.bars[at][1],
                         table.elements_across[at]);
          if (table.over_shifts())
            fmt::format_to(std::back_inserter(text), ",{:.7g}", table.along_normal[at]);
          if (table.heat) fmt::format_to(std::back_inserter(text), ",{:.7g}", table.rise[at]);
          text += '\n';
          ++at;
        }
  }
  return text;
}

std::string interpolation_csv(const CreepTable& table) {
  std::string text =
      first_columns(table) + creepage_columns + "force_error [mu F_n],moment_error [mu F_n c]\n";
  for (const InterpolatedPoint& point : table.checked) {
    const auto& [x, y, z] = point.creepage;
    const Scaled& found = point.interpolated;
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{:.7g},{:.7g},{:.7g},{:.3g},{:.3g}\n",
                   values_of(table, point.place), x, y, z, point.solved[0], point.solved[1],
                   point.solved[2],
                   std::hypot(found[0] - point.solved[0], found[1] - point.solved[1]),
                   found[2] - point.solved[2]);
  }
  return text;
}

std::string shifts_csv(const CreepTable& table) {
  const bool loads = table.load.size() > 1;
  std::string text = loads ? "load [N],lateral_shift [mm]" : "lateral_shift [mm]";
  for (const WheelColumn& column : wheel_columns())
    text +=
        fmt::format(",{} [{}]", column.name, column.unit == std::string("1") ? "-" : column.unit);
  text += '\n';
  for (std::size_t k = 0; k < table.wheels.size(); ++k) {
    const std::size_t shifts = table.lateral_shift.size();
    if (loads) fmt::format_to(std::back_inserter(text), "{},", table.load[k / shifts]);
    fmt::format_to(std::back_inserter(text), "{}", table.lateral_shift[k % shifts]);
    for (const WheelColumn& column : wheel_columns())
      fmt::format_to(std::back_inserter(text), ",{:.9g}", table.wheels[k].*column.member);
    text += '\n';
  }
  return text;
}

std::string table_hdf5(const CreepTable& table) {
  const File file = create_file_in_memory();
  write_attribute(file, "format", std::string(table_format));
  write_attribute(file, "format_version", table_version);
  const bool shifts = table.over_shifts();
  write_attribute(file, "kind",
                  std::string(shifts ? "creep force law of a wheel on its rail over lateral shift"
                                     : "creep force law of Hertzian contacts"));
  write_attribute(file, "conventions",
                  table_conventions + std::string(shifts ? shift_conventions : ratio_conventions));
  for (const auto& [name, member] : table_texts) write_attribute(file, name, table.*member);
  write_attribute(file, "poisson_ratio", table.poisson_ratio);
  write_dataset(file, "case_text", table.case_text);
  write_axes(file, table);
  write_points(file, table);
  if (shifts) write_wheels(file, table);
  if (!shifts && !table.only_for.empty())
    write_friction(create_group(file, "friction", "What the forces depend on beside mu F_n"),
                   table);
  write_interpolation(file, table);
  return sealed_image(file);
}

CreepTable read_table(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code none;
  const std::string file_name =
      fs::is_directory(path, none) ? (fs::path(path) / "table.h5").string() : path;
  if (!result::hdf5_seal_is_intact(file_name, table_wanted))
    refuse_file(file_name, "is damaged: its checksum is missing or does not match");
  try {
    const File file = open_file(file_name);
    if (!has_attribute(file, "format") || read_text(file, "format") != table_format)
      refuse_file(file_name, "is not a table");
    const double version = read_number(file, "format_version");
    if (!(version >= 1.0 && version <= static_cast<double>(table_version)))
      refuse_file(file_name, "belongs to another version");
    CreepTable table = table_of(file);
    read_interpolation(file, table);
    return table;
  } catch (const contact::InputError&) {
    throw;
  } catch (const std::runtime_error& error) {
    refuse_file(file_name, error.what());
  }
}

}  // namespace rollfem::tables
