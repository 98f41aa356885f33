// SPDX-License-Identifier: LGPL-2.1-or-later
// Reads profile files written by instruments and programs. Separators are blanks, comma or
// semicolon; with semicolons a comma is the decimal mark. Comments are ignored in every format.
#include "contact/base/errors.hpp"
#include "contact/base/text_fields.hpp"
#include "profiles/profile_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

namespace rollfem::profiles {

namespace {

using contact::InputError;
using contact::TextLines;
using contact::trimmed;

/// Numbers read from a line; further columns are ignored.
constexpr std::size_t most_columns = 16;

/// Characters that begin comments, in addition to "//".
constexpr std::string_view comment_marks = "#!%\"";

std::string_view before_comment(std::string_view line) {
  const std::string_view text = contact::without_comment(line, comment_marks);
  return trimmed(text.substr(0, text.find("//")));
}

struct Row {
  std::array<double, most_columns> values{};
  std::size_t count = 0;
  std::string wrong;  ///< the first field that is no number
  /// Whether the words may be a heading: none of them looks like a misspelt number.
  bool is_heading() const {
    const bool spoilt =
        std::string_view("+-.0123456789").find(wrong[0]) != std::string_view::npos &&
        wrong.find_first_of("0123456789") != std::string::npos;
    return !spoilt;
  }
};

Row numbers(std::string_view text) {
  Row row;
  const bool semicolons = text.find(';') != std::string_view::npos;
  for (const std::string_view field : contact::fields_of(text, semicolons ? " \t;" : " \t,")) {
    const std::optional<double> value = contact::number_of(field, semicolons);
    if (!value) {
      row.wrong = contact::printable(field);
      return row;
    }
    if (row.count < most_columns) row.values[row.count++] = *value;
  }
  return row;
}

void add(ProfilePoints& points, double y, double z, const TextLines& at) {
  points.list.push_back({y, z, static_cast<unsigned>(at.number())});
}

[[noreturn]] void not_numbers(const std::string& file, const TextLines& at,
                              const std::string& field) {
  throw InputError(
      fmt::format("{}:{}: expected a number, got `{}`; allowed: lines of two numbers, y and z; do: "
                  "correct the line, or "
                  "put # before it if it is a comment",
                  file, at.number(), contact::printable(field)));
}

[[noreturn]] void too_few_numbers(const std::string& file, const TextLines& at) {
  throw InputError(
      fmt::format("{}:{}: only one number; allowed: two columns, y and z; do: complete the line",
                  file, at.number()));
}

/// Columns named y and z in a header such as "parameter,y,z" or "y [mm]; z [mm]".
std::optional<std::array<std::size_t, 2>> named_columns(std::string_view header) {
  std::array<std::size_t, 2> found{most_columns, most_columns};
  const bool listed = header.find_first_of(",;\t") != std::string_view::npos;
  std::size_t column = 0;
  for (const std::string_view part : contact::parts_of(header, listed ? ",;\t" : " ")) {
    const std::string_view field = trimmed(part);
    // In blank-separated headers, units are separate words.
    if (!listed && (field.empty() || field.front() == '[' || field.front() == '(')) continue;
    const std::string_view name = field.substr(0, field.find_first_of(" [(_/"));
    if (name == "y" || name == "Y") found[0] = column;
    if (name == "z" || name == "Z") found[1] = column;
    ++column;
  }
  if (found[0] == most_columns || found[1] == most_columns) return {};
  return found;
}

/// A file may begin with its number of points.
bool is_count(const Row& row) {
  return row.count == 1 && row.values[0] == std::floor(row.values[0]);
}

/// Headings may fill several lines before the first point; in a text without points the last line
/// is rejected.
ProfilePoints read_columns(std::string_view text, const std::string& name) {
  ProfilePoints points;
  std::optional<std::array<std::size_t, 2>> columns;
  std::optional<TextLines> heading;
  std::string word;
  std::optional<std::pair<TextLines, double>> announced;
  for (TextLines lines(text); lines.next();) {
    const std::string_view line = before_comment(lines.line());
    if (line.empty()) continue;
    const Row row = numbers(line);
    const bool begun = !points.list.empty();
    if (!row.wrong.empty()) {
      if (begun || row.count > 0 || !row.is_heading()) not_numbers(name, lines, row.wrong);
      heading = lines;
      word = row.wrong;
      if (const auto named = named_columns(line)) columns = named;
      continue;
    }
    if (!begun && !announced && is_count(row)) {
      announced.emplace(lines, row.values[0]);
      continue;
    }
    if (row.count < 2) too_few_numbers(name, announced ? announced->first : lines);
    if (row.count > 2 && !columns)
      throw InputError(fmt::format(
          "{}:{}: has {} numbers; allowed: two columns, y and z, or a first line that names the "
          "columns; do: put a line such as `s, y, z` before the numbers",
          name, lines.number(), row.count));
    const auto use = columns.value_or(std::array<std::size_t, 2>{0, 1});
    if (std::max(use[0], use[1]) >= row.count) too_few_numbers(name, lines);
    add(points, row.values[use[0]], row.values[use[1]], lines);
  }
  if (announced && announced->second != static_cast<double>(points.list.size()))
    too_few_numbers(name, announced->first);
  if (points.list.empty() && heading) not_numbers(name, *heading, word);
  return points;
}

/// "key = value", the line without its comment.
bool key_and_value(std::string_view line, std::string& key, std::string& value) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return false;
  key = trimmed(line.substr(0, equals));
  value = trimmed(line.substr(equals + 1));
  return true;
}

/// Settings of the section `spline` of a SIMPACK file, applied in SIMPACK's numbered order
/// (comments of the file).
struct SimpackData {
  double type = -1.0;
  double point_dist_min = 0.0;
  double shift_y = 0.0, shift_z = 0.0, rotate = 0.0;
  double y_min = 1.0, y_max = 0.0, z_min = 1.0, z_max = 0.0;
  double mirror_y = 0.0, mirror_z = 0.0, inversion = 0.0;
  double length_factor = 1.0, angle_factor = 1.0;  ///< user unit per m, per rad
};

double* simpack_member(SimpackData& data, const std::string& key, bool header) {
  if (header) return key == "type" ? &data.type : nullptr;
  if (key == "point.dist.min") return &data.point_dist_min;
  if (key == "shift.y") return &data.shift_y;
  if (key == "shift.z") return &data.shift_z;
  if (key == "rotate") return &data.rotate;
  if (key == "bound.y.min") return &data.y_min;
  if (key == "bound.y.max") return &data.y_max;
  if (key == "bound.z.min") return &data.z_min;
  if (key == "bound.z.max") return &data.z_max;
  if (key == "mirror.y") return &data.mirror_y;
  if (key == "mirror.z") return &data.mirror_z;
  if (key == "inversion") return &data.inversion;
  if (key == "units.len.f") return &data.length_factor;
  if (key == "units.ang.f") return &data.angle_factor;
  return nullptr;
}

ProfilePoints processed(const ProfilePoints& listed, const SimpackData& data) {
  ProfilePoints result;
  const double c = std::cos(data.rotate / data.angle_factor);
  const double s = std::sin(data.rotate / data.angle_factor);
  const double to_mm = 1000.0 / data.length_factor;
  ListedPoint last;
  for (const ListedPoint& point : listed.list) {
    if (&point != &listed.list.front() &&
        std::hypot(point.y - last.y, point.z - last.z) < data.point_dist_min)
      continue;
    last = point;
    double y = c * (last.y + data.shift_y) - s * (last.z + data.shift_z);
    double z = s * (last.y + data.shift_y) + c * (last.z + data.shift_z);
    if (data.y_min < data.y_max && (y < data.y_min || y > data.y_max)) continue;
    if (data.z_min < data.z_max && (z < data.z_min || z > data.z_max)) continue;
    if (data.mirror_y == 1.0) y = -y;
    if (data.mirror_z == 1.0) z = -z;
    result.list.push_back({to_mm * y, to_mm * z, point.line});
  }
  return result;
}

ProfilePoints read_simpack(std::string_view text, const std::string& name, bool wheel) {
  ProfilePoints listed;
  SimpackData data;
  enum class Place { outside, header, spline, points } place = Place::outside;
  bool seen = false;
  for (TextLines lines(text); lines.next();) {
    const std::string_view line = before_comment(lines.line());
    if (line.empty()) continue;
    if (line == "header.begin")
      place = Place::header;
    else if (line == "spline.begin")
      place = Place::spline;
    else if (line == "point.begin")
      place = Place::points, seen = true;
    else if (line == "point.end")
      place = Place::spline;
    else if (line == "header.end" || line == "spline.end")
      place = Place::outside;
    else if (place == Place::points) {
      const Row row = numbers(line);
      if (!row.wrong.empty()) not_numbers(name, lines, row.wrong);
      if (row.count < 2) too_few_numbers(name, lines);
      add(listed, row.values[0], row.values[1], lines);
    } else if (std::string key, value; key_and_value(line, key, value)) {
      double* member = simpack_member(data, key, place == Place::header);
      if (member == nullptr) continue;
      const auto given = contact::number_of(value);
      const bool factor = member == &data.length_factor || member == &data.angle_factor;
      if (!given || (factor && *given <= 0.0)) not_numbers(name, lines, value);
      *member = *given;
    } else if (place != Place::outside) {
      throw InputError(fmt::format(
          "{}:{}: `{}` is not a key with a value; allowed: lines KEY = VALUE, and numbers between "
          "point.begin and point.end; do: correct the line, or put ! before it if it is a comment",
          name, lines.number(), contact::printable(line)));
    }
  }
  if (!seen)
    throw InputError(fmt::format(
        "{}: has no section point.begin ... point.end; allowed: a SIMPACK profile; do: check the "
        "file, or end its name with .csv if it has two columns",
        name));
  if (data.type >= 0.0 && (data.type == 1.0) != wheel)
    throw InputError(fmt::format(
        "{}: is the profile of a {} (header, type = {}), but the case uses it for the {}; allowed: "
        "type = {}; do: name the other file",
        name, wheel ? "rail" : "wheel", data.type, wheel ? "wheel" : "rail", wheel ? 1 : 0));
  ProfilePoints points = processed(listed, data);
  points.any_direction = points.own_unit = true;
  return points;
}

/// The points under one `[SECTION]` of a MiniProf file, or before any.
struct MiniprofPart {
  std::string section;
  ProfilePoints points;
};

/// The part that `source` names, or the only one.
ProfilePoints chosen(const std::vector<MiniprofPart>& parts, const contact::ProfileSource& source,
                     bool wheel) {
  std::string found;
  const MiniprofPart* last = nullptr;
  std::size_t count = 0;
  for (const MiniprofPart& part : parts) {
    if (part.points.list.empty()) continue;
    if (!source.section.empty() && part.section == source.section) return part.points;
    found += fmt::format("{}{} ({} points)", found.empty() ? "" : ", ",
                         part.section.empty() ? "points of no section" : part.section,
                         part.points.list.size());
    last = &part;
    ++count;
  }
  if (count == 0) return {};
  if (count == 1 && source.section.empty()) return last->points;
  throw InputError(fmt::format(
      "{}: {}; allowed: {}; do: put `section = \"{}\"`, or the name of another one, under "
      "[{}_profile]",
      source.name,
      source.section.empty()
          ? fmt::format("holds {} profiles", count)
          : fmt::format("section = \"{}\" is not one of its profiles", source.section),
      found, last->section, wheel ? "wheel" : "rail"));
}

/// Old headers are plain words, rows of numbers with words among them, and up to an empty line.
ProfilePoints read_miniprof(std::string_view text, const contact::ProfileSource& source,
                            bool wheel) {
  std::vector<MiniprofPart> parts(1);
  std::array<std::size_t, 2> columns{0, 1};
  bool in_words = false;
  for (TextLines lines(text); lines.next();) {
    std::vector<ListedPoint>& list = parts.back().points.list;
    const std::string_view line = before_comment(lines.line());
    if (line.empty()) {
      if (!lines.line().empty()) continue;
      if (in_words && list.size() == 1) list.clear();
      in_words = false;
      continue;
    }
    if (line.front() == '[' && line.back() == ']') {
      parts.push_back({contact::printable(trimmed(line.substr(1, line.size() - 2))), {}});
      continue;
    }
    std::string key, value;
    if (key_and_value(line, key, value)) {
      if (key != "ColumnDef") continue;
      const auto names = contact::parts_of(value, ",");
      for (std::size_t column = 0; column < names.size(); ++column) {
        if (trimmed(names[column]) == "X") columns[0] = column;
        if (trimmed(names[column]) == "Y") columns[1] = column;
      }
      continue;
    }
    const Row row = numbers(line);
    const bool complete = std::max(columns[0], columns[1]) < row.count;
    if (!row.wrong.empty()) {
      const bool header = list.empty() || (list.size() == 1 && in_words);
      if (!row.is_heading() || (!header && !complete)) not_numbers(source.name, lines, row.wrong);
      if (header && (in_words || !complete)) {
        list.clear();
        in_words = true;
        continue;
      }
    }
    if (!complete) too_few_numbers(source.name, lines);
    list.push_back(
        {row.values[columns[0]], row.values[columns[1]], static_cast<unsigned>(lines.number())});
  }
  ProfilePoints points = chosen(parts, source, wheel);
  points.any_direction = true;
  return points;
}

std::string ending(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  std::string result = dot == std::string::npos ? "" : path.substr(dot + 1);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Never quote the contents of files that hold no profile.
void check_is_table(std::string_view text, const std::string& name) {
  std::size_t last = 0;
  for (TextLines lines(text); lines.next();)
    if (!before_comment(lines.line()).empty()) last = lines.number();
  if (last == 0 || contact::looks_like_table(text, comment_marks)) return;
  throw InputError(
      fmt::format("{}:{}: is not a profile: most of its lines, up to this one, do not begin with a "
                  "number; allowed: lines of two numbers, y and z, SIMPACK (.prw, .prr) or "
                  "MiniProf (.whl, .ban, .mpt); do: check the path",
                  name, last));
}

ProfilePoints points_in(std::string_view text, const contact::ProfileSource& source, bool wheel) {
  const std::string kind = ending(source.name);
  if (kind == "whl" || kind == "ban" || kind == "mpt") return read_miniprof(text, source, wheel);
  const auto refuse = [&](const char* key, const char* why) {
    throw InputError(
        fmt::format("{}: {} cannot be set for {}; do: remove `{}`", source.name, key, why, key));
  };
  if (!source.section.empty()) refuse("section", "a file that is not of MiniProf");
  if (kind != "prw" && kind != "prr") return read_columns(text, source.name);
  if (source.unit != contact::LengthUnit::mm)
    refuse("unit", "a SIMPACK file, which specifies its unit (units.len.f)");
  return read_simpack(text, source.name, wheel);
}

}  // namespace

ProfilePoints read_profile_points(const std::string& path, const contact::ProfileSource& source,
                                  bool wheel) {
  constexpr std::size_t largest_file = 100'000'000;
  return parse_profile_points(contact::text_of_file(path, source.name, largest_file), source,
                              wheel);
}

ProfilePoints parse_profile_points(std::string_view text, const contact::ProfileSource& source,
                                   bool wheel) {
  const std::string& name = source.name;
  if (text.find('\0') != std::string_view::npos)
    throw InputError(fmt::format(
        "{}: is a binary file, not a profile; do: give lines of two numbers, y and z", name));
  check_is_table(text, name);
  ProfilePoints points = points_in(text, source, wheel);
  points.file = name;
  if (points.list.empty())
    throw InputError(
        fmt::format("{}: is empty; do: give lines of two numbers, y and z, in mm", name));
  return points;
}

}  // namespace rollfem::profiles
