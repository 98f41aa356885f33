// SPDX-License-Identifier: LGPL-2.1-or-later
// Profiles of SIMPACK Rail, in any unit.
#include "base/errors.hpp"
#include "profiles/profile_format.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace rollfem::profiles {

namespace {

using contact::InputError;
using contact::TextLines;

/// Settings of a SIMPACK file: type of its header, and the section `spline`.
using Settings = std::map<std::string, double>;

const Settings defaults{{"header.type", -1.0},  {"point.dist.min", 0.0}, {"shift.y", 0.0},
                        {"shift.z", 0.0},       {"rotate", 0.0},         {"bound.y.min", 1.0},
                        {"bound.y.max", 0.0},   {"bound.z.min", 1.0},    {"bound.z.max", 0.0},
                        {"mirror.y", 0.0},      {"mirror.z", 0.0},       {"inversion", 0.0},
                        {"approx.smooth", 0.0}, {"units.len.f", 1.0},  // user unit per m
                        {"units.ang.f", 1.0}};                         // per rad

/// Applied in SIMPACK's numbered order (comments of the file).
ProfilePoints processed(const ProfilePoints& listed, const Settings& settings) {
  ProfilePoints result;
  const auto of = [&](const char* key) { return settings.at(key); };
  const double angle = of("rotate") / of("units.ang.f");
  const double c = std::cos(angle), s = std::sin(angle);
  const double to_mm = 1000.0 / of("units.len.f");
  const double shift_y = of("shift.y"), shift_z = of("shift.z");
  const auto beyond = [](double value, double least, double most) {
    return least < most && (value < least || value > most);
  };
  ListedPoint last;
  for (const ListedPoint& point : listed.list) {
    if (&point != &listed.list.front() &&
        std::hypot(point.y - last.y, point.z - last.z) < of("point.dist.min"))
      continue;
    last = point;
    double y = c * (last.y + shift_y) - s * (last.z + shift_z);
    double z = s * (last.y + shift_y) + c * (last.z + shift_z);
    if (beyond(y, of("bound.y.min"), of("bound.y.max"))) continue;
    if (beyond(z, of("bound.z.min"), of("bound.z.max"))) continue;
    if (of("mirror.y") == 1.0) y = -y;
    if (of("mirror.z") == 1.0) z = -z;
    result.list.push_back({to_mm * y, to_mm * z, point.line});
  }
  return result;
}

ProfilePoints read_simpack(std::string_view text, const contact::ProfileSource& source,
                           bool wheel) {
  const std::string& name = source.name;
  ProfilePoints listed;
  std::size_t weighted = 0;
  Settings settings = defaults;
  enum class Place { outside, header, spline, points } place = Place::outside;
  bool seen = false;
  for (TextLines lines(text); lines.next();) {
    const std::string_view line = before_comment(lines.line());
    if (line.empty()) continue;
    if (line == "header.begin")
      place = Place::header;
    else if (line == "spline.begin" || line == "point.end")
      place = Place::spline;
    else if (line == "point.begin")
      place = Place::points, seen = true;
    else if (line == "header.end" || line == "spline.end")
      place = Place::outside;
    else if (place == Place::points) {
      const NumberRow row = numbers_of(line);
      if (!row.wrong.empty()) not_numbers(name, lines, row.wrong);
      if (row.count < 2) too_few_numbers(name, lines);
      add(listed, row.values[0], row.values[1], lines);
      if (row.count > 2 && row.values[2] != 1.0) ++weighted;
    } else if (std::string key, value; key_and_value(line, key, value)) {
      const auto known = settings.find(place == Place::header ? "header." + key : key);
      if (known == settings.end()) continue;
      const auto given = contact::number_of(value);
      const bool factor = key.rfind("units.", 0) == 0;
      if (!given || (factor && *given <= 0.0)) not_numbers(name, lines, value);
      known->second = *given;
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
  const double type = settings.at("header.type");
  if (type >= 0.0 && (type == 1.0) != wheel)
    throw InputError(fmt::format(
        "{}: is the profile of a {} (header, type = {}), but the case uses it for the {}; allowed: "
        "type = {}; do: name the other file",
        name, wheel ? "rail" : "wheel", type, wheel ? "wheel" : "rail", wheel ? 1 : 0));
  ProfilePoints result = processed(listed, settings);
  const double smooth = settings.at("approx.smooth");
  if ((smooth != 0.0 || weighted > 0) && source.smoothing == 0.0)
    result.neglected = fmt::format(
        "{}: approx.smooth = {:g} and weights other than 1 (of {} points) are not applied; do: "
        "give "
        "`smoothing` under [{}_profile] (mm, the scatter of the points), or set them to 0 and 1",
        name, smooth, weighted, wheel ? "wheel" : "rail");
  return result;
}

const KnownFormat simpack(
    {"SIMPACK", {{".prw", true}, {".prr", false}}, read_simpack, true, "units.len.f"});

}  // namespace

}  // namespace rollfem::profiles
