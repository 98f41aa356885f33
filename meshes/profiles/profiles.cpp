#include "meshes/profiles/profiles.hpp"

#include "contact/base/errors.hpp"
#include "meshes/profiles/built_in_profiles.hpp"
#include "meshes/profiles/formula_profiles.hpp"
#include "meshes/profiles/profile_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace rollfem::meshes {

namespace {

using contact::InputError;
using contact::ProfileSource;

std::string built_in_names(bool wheel) {
  std::string names;
  for (const BuiltInProfile& profile : built_in_profiles())
    if (profile.wheel == wheel) names += (names.empty() ? "" : ", ") + profile.name;
  return names;
}

ProfileCurve built_in(const BuiltInProfile& profile, bool wheel, const std::string& case_file) {
  if (profile.wheel != wheel)
    throw InputError(fmt::format(
        "{}: profile = \"{}\" is that of a {}, not of a {}; allowed: {}, arcs, polynomial or a "
        "file; do: name another one",
        case_file, profile.name, wheel ? "rail" : "wheel", wheel ? "wheel" : "rail",
        built_in_names(wheel)));
  return profile.make();
}

ProfileCurve from_file(const ProfileSource& source, bool wheel, const std::string& case_file,
                       ProfileReport& report) {
  const std::filesystem::path path = std::filesystem::path(case_file).parent_path() / source.name;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw InputError(fmt::format(
        "{}: profile = \"{}\" is no profile that is known, and no such file is there; allowed: {}, "
        "arcs, polynomial or a file, its path relative to the case file; do: correct the name",
        case_file, source.name, built_in_names(wheel)));
  ProfilePoints points = read_profile_points(path.string(), source.name, wheel, source.unit);
  mend_and_check(points, source, wheel);
  report.points = points.y.size();
  report.smoothing.emplace();
  try {
    return smoothing_spline(points.y, points.z, source.smoothing, &*report.smoothing);
  } catch (const std::invalid_argument&) {
    throw InputError(fmt::format(
        "{}: smoothing = {} mm is more than the profile as a whole is curved; allowed: about the "
        "scatter of the measured points, some 0.01 mm; do: give a smaller one",
        source.name, source.smoothing));
  }
}

ProfileCurve of_source(const ProfileSource& source, bool wheel, const std::string& case_file,
                       ProfileReport& report) {
  const std::string section =
      fmt::format("{}: [{}]", case_file, wheel ? "wheel_profile" : "rail_profile");
  if (const BuiltInProfile* profile = find_built_in_profile(source.name)) {
    report.kind = "built in: " + profile->sentence;
    return built_in(*profile, wheel, case_file);
  }
  report.kind = source.name;
  if (source.name == "arcs") return arc_profile_curve(source, wheel, section);
  if (source.name == "polynomial") return polynomial_profile_curve(source, section);
  report.kind = "file";
  return from_file(source, wheel, case_file, report);
}

}  // namespace

ProfileCurve make_profile(const ProfileSource& source, bool wheel, const std::string& case_file,
                          ProfileReport* report) {
  ProfileReport here;
  ProfileCurve curve = of_source(source, wheel, case_file, here);
  // The points of a file were mirrored before they were checked.
  if (source.mirror && here.kind != "file") curve = curve.mirrored();
  if (source.rotation != 0.0 || source.shift[0] != 0.0 || source.shift[1] != 0.0)
    curve = curve.moved(source.rotation, source.shift[0], source.shift[1]);
  if (report != nullptr) *report = here;
  return curve;
}

ProfileCurve profile_of_case(const contact::Case& input, bool wheel, ProfileReport* report) {
  const ProfileSource& source = wheel ? input.wheel.profile : input.rail.profile;
  if (!source.name.empty()) return make_profile(source, wheel, input.file, report);
  const double radius = wheel ? input.wheel.transverse_radius : input.rail.transverse_radius;
  constexpr double half_width = 60.0;  // mm, wider than treads and heads are
  ProfileSource arc;
  arc.name = "arcs";
  arc.radii = {radius};
  arc.ends = {std::min(half_width, 0.95 * std::abs(radius))};
  arc.symmetric = true;
  ProfileCurve curve = make_profile(arc, wheel, input.file, report);
  if (report != nullptr) report->kind = "radius";
  return curve;
}

}  // namespace rollfem::meshes
