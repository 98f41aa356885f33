// SPDX-License-Identifier: LGPL-2.1-or-later
// Profiles of VAMPIRE: a header, then rows of y, z of the left and y, z of the right side, mm, y
// from the middle of the track (as CONTACT's matlab/read_vampire.m reads them).
#include "base/errors.hpp"
#include "profiles/profile_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace rollfem::profiles {

namespace {

using contact::InputError;
using contact::TextLines;

[[noreturn]] void wrong_header(const std::string& name, std::size_t line, const std::string& wrong,
                               const std::string& allowed) {
  throw InputError(
      fmt::format("{}:{}: {}; allowed: {}; do: correct the header of the VAMPIRE file, or end its "
                  "name with .csv if it has two columns",
                  name, line, wrong, allowed));
}

/// Distance of the tread datum from the back of the flange, mm.
double datum_of(const std::vector<std::string_view>& words, const std::string& name,
                std::size_t line) {
  constexpr double inch = 25.4;
  static const std::map<std::string_view, double> known{
      {"EUROPEAN", 70.0}, {"US1", (2.0 + 27.0 / 32.0) * inch}, {"US2", (3.0 + 1.0 / 16.0) * inch}};
  if (words.size() > 1) {
    const auto found = known.find(words[1]);
    if (found != known.end()) return found->second;
    if (const auto given = contact::number_of(words.back()); words[1] == "CUSTOM" && given)
      return *given;
  }
  wrong_header(name, line, "unknown TREADDATUM", "EUROPEAN, US1, US2, or CUSTOM and mm");
}

struct Header {
  std::optional<double> datum;  ///< of a wheel's tread, mm from the back of the flange
  std::optional<double> width;  ///< between the backs of the flanges or the gauge faces, mm
};

void read_header_line(std::string_view line, Header& header, const std::string& name,
                      const TextLines& at) {
  const auto words = contact::fields_of(line, " \t,");
  if (words[0] == "TREADDATUM") {
    header.datum = datum_of(words, name, at.number());
  } else if (words[0] == "FLANGEBACK" || words[0] == "GAUGE") {
    header.width = words.size() > 1 ? contact::number_of(words[1]) : std::nullopt;
    if (!header.width)
      wrong_header(name, at.number(), fmt::format("{} without a number", words[0]),
                   "the distance between left and right, mm");
  } else if (words[0] != "GAUGEPOINT") {
    not_numbers(name, at, std::string(words[0]));
  }
}

void add_row(std::array<ProfilePoints, 2>& sides, const NumberRow& row, const std::string& name,
             const TextLines& at) {
  if (row.count < 4 || row.values[0] > 0.0 || row.values[2] < 0.0)
    throw InputError(fmt::format(
        "{}:{}: has {} numbers{}; allowed: y and z of the left side, then y and z of the right "
        "one, with y from the middle of the track, mm, to the right; do: correct the line",
        name, at.number(), row.count,
        row.count < 4
            ? ""
            : fmt::format(", y = {:g} (left), {:g} (right)", row.values[0], row.values[2])));
  add(sides[0], -row.values[0], row.values[1], at);
  add(sides[1], row.values[2], row.values[3], at);
}

/// y = 0 is the tread datum of a wheel, the gauge face of a rail; its highest point has z = 0.
void place(ProfilePoints& side, const Header& header, bool wheel) {
  double top = side.list.front().z;
  for (const ListedPoint& point : side.list) top = std::max(top, point.z);
  for (ListedPoint& point : side.list) {
    point.y -= 0.5 * *header.width + (wheel ? *header.datum : 0.0);
    if (!wheel) point.z = top - point.z;
  }
}

ProfilePoints chosen(const std::array<ProfilePoints, 2>& sides,
                     const contact::ProfileSource& source, bool wheel) {
  constexpr double rounding = 1e-3;  // mm
  double apart = 0.0;
  for (std::size_t k = 0; k < sides[0].list.size(); ++k)
    apart = std::max(apart, std::hypot(sides[0].list[k].y - sides[1].list[k].y,
                                       sides[0].list[k].z - sides[1].list[k].z));
  if (source.section == "left" || (source.section.empty() && apart < rounding)) return sides[0];
  if (source.section == "right") return sides[1];
  refuse_section(source, wheel,
                 fmt::format("its left and right profiles differ by up to {:.3g} mm", apart),
                 "left, right", "left");
}

ProfilePoints read_vampire(std::string_view text, const contact::ProfileSource& source,
                           bool wheel) {
  const std::string& name = source.name;
  const std::string_view expected = wheel ? "WHEELPROFILE" : "RAILPROFILE";
  TextLines lines(text);
  if (!lines.next() || lines.line() != expected)
    wrong_header(name, 1, fmt::format("the first line is not {}", expected),
                 fmt::format("{} for the profile of a {}", expected, wheel ? "wheel" : "rail"));
  lines.next();  // the title
  Header header;
  std::array<ProfilePoints, 2> sides;
  while (lines.next()) {
    const std::string_view line = before_comment(lines.line());
    if (line.empty()) continue;
    const NumberRow row = numbers_of(line);
    if (row.wrong.empty())
      add_row(sides, row, name, lines);
    else if (row.count == 0 && sides[0].list.empty())
      read_header_line(line, header, name, lines);
    else
      not_numbers(name, lines, row.wrong);
  }
  for (const auto& [key, missing] : {std::pair{"TREADDATUM", wheel && !header.datum},
                                     std::pair{wheel ? "FLANGEBACK" : "GAUGE", !header.width}})
    if (missing)
      wrong_header(name, 3, fmt::format("{} is missing", key),
                   wheel ? "TREADDATUM and FLANGEBACK in lines 3 and 4"
                         : "GAUGEPOINT and GAUGE in lines 3 and 4");
  if (sides[0].list.empty()) return {};
  for (ProfilePoints& side : sides) place(side, header, wheel);
  return chosen(sides, source, wheel);
}

const KnownFormat vampire(
    {"VAMPIRE", {{".whe", true}, {".rai", false}}, read_vampire, true, "mm", true});

}  // namespace

}  // namespace rollfem::profiles
