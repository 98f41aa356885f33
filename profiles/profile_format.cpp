// SPDX-License-Identifier: LGPL-2.1-or-later
// Reads profile files: the formats that are known, and columns. Separators are blanks, comma or
// semicolon; with semicolons a comma is the decimal mark. Comments are ignored in every format.
#include "profiles/profile_format.hpp"

#include "base/errors.hpp"
#include "profiles/formula_profiles.hpp"

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

/// Characters that begin comments, in addition to "//".
constexpr std::string_view comment_marks = "#!%\"";

std::vector<ProfileFormat>& known_formats() {
  static std::vector<ProfileFormat> formats;
  return formats;
}

/// A format with one of its endings; null: columns.
struct FormatOfFile {
  const ProfileFormat* format = nullptr;
  std::optional<bool> wheel;
};

FormatOfFile format_of(const std::string& file) {
  std::string ending = file.substr(std::min(file.rfind('.'), file.size()));
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const ProfileFormat& format : known_formats())
    for (const auto& [known, wheel] : format.endings)
      if (known == ending) return {&format, wheel};
  return {};
}

/// "MiniProf (.whl, .ban, .mpt) or SIMPACK (.prw, .prr)"
std::string formats_text(bool with_sections) {
  std::string text;
  for (const ProfileFormat& format : known_formats()) {
    if (with_sections && !format.has_sections) continue;
    text += (text.empty() ? "" : " or ") + format.name;
    for (const ProfileEnding& one : format.endings)
      text += (&one == &format.endings.front() ? " (" : ", ") + one.ending;
    text += ')';
  }
  return text;
}

}  // namespace

KnownFormat::KnownFormat(ProfileFormat format) {
  std::vector<ProfileFormat>& all = known_formats();
  // By name, because files are initialised in no particular order.
  const auto after = [](const ProfileFormat& a, const ProfileFormat& b) { return a.name < b.name; };
  all.insert(std::upper_bound(all.begin(), all.end(), format, after), std::move(format));
}

std::string_view before_comment(std::string_view line) {
  const std::string_view text = contact::without_comment(line, comment_marks);
  return trimmed(text.substr(0, text.find("//")));
}

NumberRow numbers_of(std::string_view text) {
  NumberRow row;
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

void not_numbers(const std::string& file, const TextLines& at, const std::string& field) {
  throw InputError(
      fmt::format("{}:{}: expected a number, got `{}`; allowed: lines of two numbers, y and z; do: "
                  "correct the line, or "
                  "put # before it if it is a comment",
                  file, at.number(), contact::printable(field)));
}

void refuse_section(const contact::ProfileSource& source, bool wheel, const std::string& several,
                    const std::string& allowed, const std::string& one) {
  throw InputError(fmt::format(
      "{}: {}; allowed: {}; do: put `section = \"{}\"`, or the name of another one, under "
      "[{}_profile]",
      source.name,
      source.section.empty()
          ? several
          : fmt::format("section = \"{}\" is not one of its profiles", source.section),
      allowed, one, wheel ? "wheel" : "rail"));
}

void too_few_numbers(const std::string& file, const TextLines& at) {
  throw InputError(
      fmt::format("{}:{}: only one number; allowed: two columns, y and z; do: complete the line",
                  file, at.number()));
}

bool key_and_value(std::string_view line, std::string& key, std::string& value) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return false;
  key = trimmed(line.substr(0, equals));
  value = trimmed(line.substr(equals + 1));
  return true;
}

namespace {

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
bool is_count(const NumberRow& row) {
  return row.count == 1 && row.values[0] == std::floor(row.values[0]);
}

/// Headings may fill several lines before the first point; in a text without points the last line
/// is rejected.
ProfilePoints read_columns(std::string_view text, const std::string& name) {
  ProfilePoints points;
  std::optional<std::array<std::size_t, 2>> columns;
  bool both_sides = false;  // a table of `rollfem profile` has two rows where the curvature jumps
  std::optional<TextLines> heading;
  std::string word;
  std::optional<std::pair<TextLines, double>> announced;
  for (TextLines lines(text); lines.next();) {
    const std::string_view line = before_comment(lines.line());
    if (line.empty()) continue;
    const NumberRow row = numbers_of(line);
    const bool begun = !points.list.empty();
    if (!row.wrong.empty()) {
      if (begun || row.count > 0 || !row.is_heading()) not_numbers(name, lines, row.wrong);
      heading = lines;
      word = row.wrong;
      if (const auto named = named_columns(line)) columns = named;
      both_sides = columns && line.find("curvature") != std::string_view::npos;
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
    const double y = row.values[use[0]], z = row.values[use[1]];
    const bool again =
        both_sides && begun && y == points.list.back().y && z == points.list.back().z;
    if (!again) add(points, y, z, lines);
  }
  if (announced && announced->second != static_cast<double>(points.list.size()))
    too_few_numbers(name, announced->first);
  if (points.list.empty() && heading) not_numbers(name, *heading, word);
  return points;
}

/// Never quote the contents of files that hold no profile.
void check_is_table(std::string_view text, const std::string& name) {
  std::size_t last = 0;
  for (TextLines lines(text); lines.next();)
    if (!before_comment(lines.line()).empty()) last = lines.number();
  if (last == 0 || contact::looks_like_table(text, comment_marks)) return;
  throw InputError(
      fmt::format("{}:{}: is not a profile: most of its lines, up to this one, do not begin with a "
                  "number; allowed: lines of two numbers, y and z, {}; do: check the path",
                  name, last, formats_text(false)));
}

ProfilePoints points_in(std::string_view text, const contact::ProfileSource& source, bool wheel) {
  const ProfileFormat* format = format_of(source.name).format;
  const auto refuse = [&](const char* key, const std::string& why) {
    throw InputError(
        fmt::format("{}: {} cannot be set for {}; do: remove `{}`", source.name, key, why, key));
  };
  if (!source.section.empty() && (format == nullptr || !format->has_sections))
    refuse("section", "a file that is not of " + formats_text(true));
  if (format == nullptr) return read_columns(text, source.name);
  if (!format->unit_key.empty() && source.unit != contact::LengthUnit::mm)
    refuse("unit",
           fmt::format("a {} file, which specifies its unit ({})", format->name, format->unit_key));
  ProfilePoints points = format->read(text, source, wheel);
  points.any_direction = format->any_direction;
  points.own_unit = !format->unit_key.empty();
  return points;
}

}  // namespace

std::optional<bool> body_of_profile(const std::string& name) {
  if (const BuiltInProfile* built_in = find_built_in_profile(name)) return built_in->wheel;
  return format_of(name).wheel;
}

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
