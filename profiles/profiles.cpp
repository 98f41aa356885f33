// SPDX-License-Identifier: LGPL-2.1-or-later
#include "profiles/profiles.hpp"

#include "base/errors.hpp"
#include "profiles/formula_profiles.hpp"
#include "profiles/profile_curve.hpp"
#include "profiles/profile_format.hpp"
#include "profiles/profile_points.hpp"
#include "profiles/section_list.hpp"
#include "scene/patch_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace rollfem::profiles {

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
    throw InputError(
        fmt::format("{}: profile = \"{}\" belongs to a {}, not to a {}; allowed: {}, arcs, "
                    "polynomial or a file; do: name another one",
                    case_file, profile.name, wheel ? "rail" : "wheel", wheel ? "wheel" : "rail",
                    built_in_names(wheel)));
  return profile.make();
}

/// The largest power of ten, 0.1 to 1e-7 mm, of which all heights are multiples; otherwise 0.
double decimal_step(const ProfilePoints& points) {
  constexpr double exact = 1e-6;
  for (double per_mm = 10.0; per_mm < 2e7; per_mm *= 10.0)
    if (std::all_of(points.list.begin(), points.list.end(), [&](const ListedPoint& point) {
          return std::abs(point.z * per_mm - std::round(point.z * per_mm)) < exact;
        }))
      return 1.0 / per_mm;
  return 0.0;
}

/// If the rounding of closely spaced points changes the pressure noticeably, adds a warning and
/// sets the rounding of the curve, at most the scatter of the points, because points on straight
/// lines may happen to be multiples of the step. Points that scatter by `least_scatter` or more are
/// measured, not rounded.
ProfileCurve with_rounding(const ProfileCurve& curve, const ProfilePoints& points, bool wheel,
                           ProfileReport& report) {
  constexpr double steel = 115e3, noticeable = 40.0, aim = 20.0;  // MPa: E*, pressures
  if (report.smoothing->scatter >= least_scatter) return curve;
  const double step = decimal_step(points);
  const double scatter = std::min(step / std::sqrt(12.0), report.smoothing->scatter);
  const double spacing =
      (curve.last() - curve.first()) / static_cast<double>(points.list.size() - 1);
  const double pressure = contact::pressure_of_scatter(steel, scatter, spacing);
  if (pressure < noticeable) return curve;
  // Means of n points scatter by 1 / sqrt(n) and are n times as far apart.
  const double apart = spacing * std::pow(pressure / aim, 2.0 / 3.0);
  report.neglected += fmt::format(
      "{}{}: points {:.2g} mm apart with heights rounded to {:g} mm: the rounding is waves that "
      "press steel bodies with up to {:.0f} MPa; do: give more decimals or fewer points, or put "
      "`thinning = {:.1g}` or `smoothing = {:.1g}` under [{}_profile]",
      report.neglected.empty() ? "" : "; ", points.file, spacing, step, pressure, apart, scatter,
      wheel ? "wheel" : "rail");
  return ProfileCurve(curve.knots(), scatter);
}

ProfileCurve through(ProfilePoints points, const ProfileSource& source, bool wheel,
                     ProfileReport& report) {
  report.neglected = points.neglected;
  mend_and_check(points, source, wheel);
  report.points = points.list.size();
  report.smoothing.emplace();
  try {
    const ProfileCurve curve =
        smoothing_spline(row_of(points), source.smoothing, &*report.smoothing);
    return source.smoothing > 0.0 ? curve : with_rounding(curve, points, wheel, report);
  } catch (const std::invalid_argument&) {
    throw InputError(fmt::format(
        "{}: smoothing = {} mm exceeds the height of the whole profile; allowed: about the scatter "
        "of the measured points, typically 0.01 mm; do: give a smaller value",
        source.name, source.smoothing));
  }
}

ProfileCurve from_file(const ProfileSource& source, bool wheel, const std::string& case_file,
                       ProfileReport& report) {
  if (!source.text.empty())
    return through(parse_profile_points(source.text, source, wheel), source, wheel, report);
  const std::filesystem::path path = std::filesystem::path(case_file).parent_path() / source.name;
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw contact::FileError(fmt::format(
        "{}: profile = \"{}\" is neither a known profile nor an existing file; allowed: {}, arcs, "
        "polynomial or a file path relative to the case file; do: correct the name",
        case_file, source.name, built_in_names(wheel)));
  return through(read_profile_points(path.string(), source, wheel), source, wheel, report);
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
  if (source.lists_sections()) {
    const auto sections = make_sections(source, wheel, case_file);
    report.kind = fmt::format("{} sections", sections->sections());
    return sections->section(sections->first());
  }
  report.kind = "file";
  return from_file(source, wheel, case_file, report);
}

/// Knots that side faces add at each end.
constexpr std::size_t knots_of_side_face = 2;

/// Continues the profile by side faces. They lean by 18 degrees, because finite elements mesh
/// surfaces up to 75 degrees and a profile may be turned a little.
ProfileCurve with_side_faces(const ProfileCurve& curve, bool wheel) {
  constexpr double slope = 3.0, height = 0.3;  // height over the width of the profile
  constexpr double edge = 0.012;               // mm, over which the profile turns
  const double inwards = wheel ? -1.0 : 1.0;
  const double cosine = 1.0 / std::hypot(1.0, slope), sine = slope * cosine;
  std::vector<ProfileKnot> knots = curve.knots();
  const double length = height * std::abs(knots.back().y - knots.front().y) / sine;
  for (const double outwards : {1.0, -1.0}) {
    const bool last = outwards > 0.0;
    const double at = last ? curve.last() : curve.first();
    const ProfilePoint end = curve.at(at);
    const double end_y = outwards * end.tangent_y, end_z = outwards * end.tangent_z;
    const bool steeper = inwards * end_z > sine;
    const double face_y = steeper ? end_y : outwards * cosine;
    const double face_z = steeper ? end_z : inwards * sine;
    double y = end.y + 0.5 * edge * (end_y + face_y), z = end.z + 0.5 * edge * (end_z + face_z);
    for (const double way : {edge, edge + length}) {
      knots.insert(last ? knots.end() : knots.begin(),
                   {at + outwards * way, y, z, outwards * face_y, outwards * face_z});
      y += length * face_y;
      z += length * face_z;
    }
  }
  return ProfileCurve(std::move(knots), curve.rounding());
}

/// The flange tip lies behind the flange back: a profile measured from the back has its tip where
/// the tread should be, and would roll on it.
void check_flange(const contact::Case& input, const ProfileCurve& curve) {
  constexpr double thickest = 45.0;  // mm, flanges are some 22 to 34 thick
  const std::optional<double> tip = flange_tip(curve);
  const double back = input.wheelset.flange_back_position;
  if (!tip || (*tip > back && *tip < back + thickest)) return;
  const ProfilePoint start = curve.at(curve.first());
  const std::array<double, 2>& shift = input.wheel.profile.shift;
  throw InputError(fmt::format(
      "{}: wheel.profile = \"{}\": the tip of the flange is at y = {:.4g} mm, where the tread "
      "should be, {:.4g} mm from the back of the flange (wheelset.flange_back_position = {:g} mm); "
      "allowed: up to {} mm; do: put `shift = [{:g}, {:g}]` under [wheel_profile] if the profile "
      "is measured from the back of the flange (it begins at y = {:.4g} mm), or give the back in "
      "its own coordinates as flange_back_position under [wheelset]",
      input.file, input.wheel.profile.name, *tip, *tip - back, back, thickest, shift[0] + back,
      shift[1], start.y));
}

}  // namespace

std::array<ProfilePoint, 2> free_ends_of(const ProfileCurve& curve) {
  const std::vector<ProfileKnot>& knots = curve.knots();
  return {curve.at(knots[knots_of_side_face].parameter),
          curve.at(knots[knots.size() - 1 - knots_of_side_face].parameter)};
}

std::optional<double> flange_tip(const ProfileCurve& curve) {
  constexpr double lowest_flange = 15.0;  // mm; those of wheels are 25 to 36 high
  constexpr std::size_t samples = 101;
  const ProfilePoint tip = profile_features(curve, true).bottom;
  std::vector<double> heights;
  const double step = (curve.last() - curve.first()) / (samples - 1);
  for (std::size_t k = 0; k < samples; ++k)
    heights.push_back(curve.at(curve.first() + static_cast<double>(k) * step).z);
  // An end of the measured part on the rising flank is not a tip.
  const bool ends = std::abs(tip.y - curve.at(curve.first()).y) < 0.5;
  if (ends || tip.z < median(std::move(heights)) + lowest_flange) return {};
  return tip.y;
}

std::vector<std::string> neglected_in_files(const contact::Case& input) {
  std::vector<std::string> warnings;
  for (const bool wheel : {true, false}) {
    const ProfileSource& source = wheel ? input.wheel.profile : input.rail.profile;
    ProfileReport report;
    if (!source.name.empty() && !source.lists_sections() && source.smoothing == 0.0)
      static_cast<void>(
          contact::attempt([&] { return make_profile(source, wheel, input.file, &report); }));
    if (!report.neglected.empty()) warnings.push_back(report.neglected);
  }
  return warnings;
}

std::string scatter_advice(const ProfileReport& report, bool wheel) {
  constexpr double rounding = 1e-9;  // mm, distance of points from a curve through them
  if (!report.smoothing || report.smoothing->rms > rounding ||
      report.smoothing->scatter < least_scatter)
    return "";
  return fmt::format("put `smoothing = {}` under [{}_profile]",
                     smoothing_for(report.smoothing->scatter), wheel ? "wheel" : "rail");
}

ProfileCurve profile_of_text(const std::string& text, const ProfileSource& source, bool wheel) {
  ProfileReport report;
  return through(parse_profile_points(text, source, wheel), source, wheel, report);
}

ProfileCurve make_profile(const ProfileSource& source, bool wheel, const std::string& case_file,
                          ProfileReport* report) {
  ProfileReport here;
  ProfileCurve curve = of_source(source, wheel, case_file, here);
  // The points of a file were mirrored before they were checked.
  if (report != nullptr) *report = here;
  // Each section has been placed by itself.
  if (source.lists_sections()) return curve;
  if (source.mirror && here.kind != "file") curve = curve.mirrored();
  if (source.rotation != 0.0 || source.shift[0] != 0.0 || source.shift[1] != 0.0)
    curve = curve.moved(source.rotation, source.shift[0], source.shift[1]);
  if (source.free_ends) curve = with_side_faces(curve, wheel);
  return curve;
}

ProfileCurve profile_of_case(const contact::Case& input, bool wheel, ProfileReport* report) {
  const ProfileSource& source = wheel ? input.wheel.profile : input.rail.profile;
  if (!source.name.empty()) {
    ProfileCurve curve = make_profile(source, wheel, input.file, report);
    if (wheel && source.for_track) check_flange(input, curve);
    return curve;
  }
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

}  // namespace rollfem::profiles
