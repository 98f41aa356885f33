// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `profile`: a wheel or rail profile as a table on the screen and in a file and as a
// figure, with its curvature as the contact sees it.
#include "app/frame/commands.hpp"
#include "app/frame/screen.hpp"
#include "base/errors.hpp"
#include "base/text_fields.hpp"
#include "case/reading/case_reader.hpp"
#include "modelling/solving/case_scenes.hpp"
#include "profiles/formula_profiles.hpp"
#include "profiles/profile_curve.hpp"
#include "profiles/profile_format.hpp"
#include "profiles/profiles.hpp"
#include "profiles/section_list.hpp"
#include "result/files/files_together.hpp"
#include "result/write/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <vector>

namespace rollfem::app {

namespace fs = std::filesystem;

namespace {

using profiles::ListedSections;
using profiles::PlacedSection;
using profiles::ProfileCurve;
using profiles::ProfilePoint;
using profiles::ProfileRow;
using result::Columns;

struct ProfileRequest {
  std::string name;       ///< a built-in profile, a profile file, or a case file (.toml)
  bool wheel = false;     ///< the file is the profile of a wheel
  bool rail = false;      ///< the file is the profile of a rail
  std::string directory;  ///< empty: results/<name without extension>_profile
  bool json = false;      ///< print JSON; files are then written only into `directory`
};

struct NamedProfile {
  std::string file;   ///< of the table and the figure, without extension
  std::string title;  ///< "wheel S1002"
  bool wheel = false;
  ProfileCurve curve;
  profiles::ProfileReport report;
  std::optional<double> gauge_face = {};  ///< y as features have it, or of the track of a case
  double gauge_height = 14.0;             ///< mm
};

std::string radius_of(double curvature) {
  // Radii above 1 km are straight lines with rounding errors of the cubics.
  return std::abs(curvature) < 1e-6 ? "straight" : fmt::format("{:.2f}", 1.0 / curvature);
}

std::string place_of(const ProfilePoint& place) {
  return fmt::format("y = {:.4f}, z = {:.4f}", place.y, place.z);
}

/// The places of the smallest radii, convex and hollow as seen from the body: the rail's material
/// is towards +z, the wheel's towards -z.
std::array<ProfilePoint, 2> sharpest(const NamedProfile& profile,
                                     const profiles::ProfileFeatures& features) {
  if (profile.wheel) return {features.sharpest_down, features.sharpest_up};
  return {features.sharpest_up, features.sharpest_down};
}

std::string described(const NamedProfile& profile) {
  const profiles::ProfileFeatures features =
      profiles::profile_features(profile.curve, profile.wheel);
  std::string text = fmt::format("{} ({})\n", profile.title, profile.report.kind);
  const auto line = [&](const std::string& what, const std::string& value) {
    text += fmt::format("  {:<36}{}\n", what, value);
  };
  line("ends, mm", place_of(features.start) + " and " + place_of(features.end));
  line("length, mm", fmt::format("{:.4f}", features.length));
  if (profile.wheel) {
    line("farthest from the axle, mm", place_of(features.bottom));
    if (features.gauge_face)
      line("flange face at z = 10, mm", fmt::format("y = {:.4f}", *features.gauge_face));
    // (0, 0) is the tape line; the flange back is 70 mm from it.
    if (const auto tip = profiles::flange_tip(profile.curve); tip && (*tip < -70.0 || *tip > -25.0))
      line("measured from the flange back:",
           "if so, put `shift = [-70, 0]` under [wheel_profile], so that y = 0 is the tape line");
  } else {
    line("top, mm", place_of(features.top));
    if (profile.gauge_face)
      line(fmt::format("gauge face {:g} mm below the top, mm", profile.gauge_height),
           fmt::format("y = {:.4f}", *profile.gauge_face));
  }
  const auto [convex, hollow] = sharpest(profile, features);
  for (const auto& [what, place] :
       {std::pair{"smallest radius, convex, mm", convex}, {"smallest radius, hollow, mm", hollow}})
    if (std::abs(place.curvature) > 1e-6)
      line(what, fmt::format("{:.3f} at {}", 1.0 / std::abs(place.curvature), place_of(place)));
  if (profile.report.smoothing) {
    const profiles::SmoothingReport& smoothing = *profile.report.smoothing;
    line("points", fmt::format("{}", profile.report.points));
    if (!profile.report.neglected.empty()) warn({profile.report.neglected});
    const std::string advice = profiles::scatter_advice(profile.report, profile.wheel);
    line("scatter of the points, mm",
         fmt::format("{:.2g}{}", smoothing.scatter, advice.empty() ? "" : "; " + advice));
    line("distance from the points, mm",
         fmt::format("{:.3g} rms, {:.3g} largest", smoothing.rms, smoothing.largest));
  }
  constexpr std::size_t most_joints = 20;
  if (!features.joints.empty()) text += "  joints, where the radius jumps, mm:\n";
  for (std::size_t k = 0; k < std::min(most_joints, features.joints.size()); ++k) {
    const profiles::ProfileJoint& joint = features.joints[k];
    text += fmt::format("    {:<34}{} -> {}\n", place_of(joint.place),
                        radius_of(joint.curvature_before), radius_of(joint.place.curvature));
  }
  if (features.joints.size() > most_joints)
    text += fmt::format("    and {} more\n", features.joints.size() - most_joints);
  return text;
}

std::string list(const ProfileCurve& curve) {
  std::string text =
      fmt::format("  {:>10}{:>12}{:>14}{:>14}\n", "y, mm", "z, mm", "angle, deg", "radius, mm");
  constexpr int steps = 30;
  for (int k = 0; k <= steps; ++k) {
    const ProfilePoint place = curve.at(curve.first() + (curve.last() - curve.first()) * k / steps);
    text += fmt::format("  {:>10.4f}{:>12.4f}{:>14.3f}{:>14}\n", place.y, place.z,
                        profiles::angle_of(place), radius_of(place.curvature));
  }
  return text;
}

Columns<ProfileRow> profile_columns() {
  Columns<ProfileRow> columns;
  const auto add = [&](const char* name, const char* unit, const char* format,
                       double ProfileRow::*member) {
    columns.add(name, unit, [format, member](const ProfileRow& row) {
      return fmt::format(fmt::runtime(format), row.*member);
    });
  };
  add("s", "mm", "{:.6f}", &ProfileRow::s);
  add("y", "mm", "{:.9f}", &ProfileRow::y);
  add("z", "mm", "{:.9f}", &ProfileRow::z);
  add("angle", "deg", "{:.6f}", &ProfileRow::angle);
  add("curvature", "1/mm", "{:.8g}", &ProfileRow::curvature);
  return columns;
}

std::vector<ProfileRow> rows_of(const NamedProfile& profile) {
  return profiles::profile_rows(profile.curve, profile.wheel);
}

bool is_wheel(const ProfileRequest& request) {
  if (request.wheel || request.rail) return request.wheel;
  if (const auto wheel = profiles::body_of_profile(request.name)) return *wheel;
  throw contact::InputError(
      fmt::format("profile: {} may be a wheel or a rail; do: add --wheel or --rail", request.name));
}

std::vector<NamedProfile> of_case(const ProfileRequest& request) {
  const contact::Case input = contact::read_case(request.name);
  std::vector<NamedProfile> profiles;
  for (const bool wheel : {true, false}) {
    if (wheel ? request.rail : request.wheel) continue;
    NamedProfile profile;
    profile.wheel = wheel;
    profile.file = wheel ? "wheel" : "rail";
    const std::string& name = (wheel ? input.wheel.profile : input.rail.profile).name;
    profile.title = profile.file + (name.empty() ? "" : " " + name);
    profile.curve = profiles::profile_of_case(input, wheel, &profile.report);
    profile.gauge_face = profiles::profile_features(profile.curve, wheel).gauge_face;
    if (!wheel && input.has_profiles())
      if (const auto search = contact::attempt([&] { return track::search_scene_of(input); });
          search && search->gauge_face) {
        profile.gauge_face = search->gauge_face;
        profile.gauge_height = input.track.gauge_height;
      }
    profiles.push_back(std::move(profile));
  }
  return profiles;
}

std::vector<NamedProfile> asked_for(const ProfileRequest& request) {
  if (request.wheel && request.rail)
    throw contact::InputError(
        "profile: --wheel and --rail exclude each other; do: give one of them");
  if (fs::path(request.name).extension() == ".toml") return of_case(request);
  std::error_code error;
  if (profiles::find_built_in_profile(request.name) == nullptr &&
      !fs::exists(request.name, error)) {
    std::vector<std::string> names;
    for (const profiles::BuiltInProfile& profile : profiles::built_in_profiles())
      names.push_back(profile.name);
    throw contact::InputError(fmt::format(
        "profile: {} is neither a known profile nor an existing file; {}allowed: {}, a profile "
        "file or a case file; do: correct the name",
        request.name, contact::did_you_mean(request.name, names), fmt::join(names, ", ")));
  }
  NamedProfile profile;
  profile.wheel = is_wheel(request);
  profile.file = "profile";
  profile.title = fmt::format("{} {}", profile.wheel ? "wheel" : "rail", request.name);
  contact::ProfileSource source;
  source.name = request.name;
  profile.curve = profiles::make_profile(source, profile.wheel, "profile", &profile.report);
  profile.gauge_face = profiles::profile_features(profile.curve, profile.wheel).gauge_face;
  return {std::move(profile)};
}

fs::path folder_for(const ProfileRequest& request) {
  if (!request.directory.empty()) return request.directory;
  return fs::path("results") / (fs::path(request.name).stem().string() + "_profile");
}

nlohmann::ordered_json json_of(const NamedProfile& profile) {
  const profiles::ProfileFeatures features =
      profiles::profile_features(profile.curve, profile.wheel);
  nlohmann::ordered_json json{{"title", profile.title},
                              {"body", profile.wheel ? "wheel" : "rail"},
                              {"source", profile.report.kind},
                              {"length", features.length}};
  if (profile.gauge_face) json["gauge_face"] = *profile.gauge_face;
  const auto [convex, hollow] = sharpest(profile, features);
  for (const auto& [name, place] :
       {std::pair{"smallest_radius_convex", convex}, {"smallest_radius_hollow", hollow}})
    if (std::abs(place.curvature) > 1e-6)
      json[name] = {{"radius", 1.0 / std::abs(place.curvature)}, {"y", place.y}, {"z", place.z}};
  json["joints"] = nlohmann::ordered_json::array();
  for (const profiles::ProfileJoint& joint : features.joints)
    json["joints"].push_back({{"y", joint.place.y},
                              {"z", joint.place.z},
                              {"curvature_before", joint.curvature_before},
                              {"curvature_after", joint.place.curvature}});
  json.update(columns_json(profile_columns(), rows_of(profile)));
  return json;
}

void print(const std::vector<NamedProfile>& profiles) {
  nlohmann::ordered_json json = result_head("profile");
  json["profiles"] = nlohmann::ordered_json::array();
  for (const NamedProfile& profile : profiles) json["profiles"].push_back(json_of(profile));
  print_result(json.dump(1));
}

/// For a case with both profiles: draws wheel on rail and prints their contacts.
void print_pair(const contact::Case& input, const fs::path& folder, Call& call) {
  if (!input.has_profiles()) return;
  const track::SearchScene search = track::search_scene_of(input);
  std::cout << "where wheel and rail touch\n" << modelling::contacts_text(input, search);
  for (const auto& [name, table] : modelling::pair_tables(input, search)) {
    const fs::path file = folder / (name + ".csv");
    result::replace_file(file, table);
    draw_and_print(call, file);
  }
}

// A family of sections along the way.

std::string steps_of(const std::vector<PlacedSection>& sections) {
  double least = std::abs(sections[1].position - sections[0].position), largest = least;
  for (std::size_t k = 2; k < sections.size(); ++k) {
    const double step = sections[k].position - sections[k - 1].position;
    least = std::min(least, step);
    largest = std::max(largest, step);
  }
  return largest - least < 1e-6 * largest ? fmt::format("{:.4g}", largest)
                                          : fmt::format("{:.4g} to {:.4g}", least, largest);
}

/// Number and positions of the sections, and where their features run.
std::string sections_text(const ListedSections& family, const std::string& title, bool wheel) {
  const std::vector<PlacedSection>& sections = family.sections;
  const PlacedSection &first = sections.front(), &last = sections.back();
  std::string text = fmt::format("{}\n", title);
  const auto line = [&](const std::string& what, const std::string& value) {
    text += fmt::format("  {:<36}{}\n", what, value);
  };
  line("sections", fmt::format("{}", sections.size()));
  line(wheel ? "angles about the axle, rad" : "positions along the track, mm",
       fmt::format("{:g} to {:g}, {} apart{}", first.position, last.position, steps_of(sections),
                   family.around ? "; a full turn, which repeats"
                   : wheel       ? "; beyond these angles the wheel is round"
                                 : ""));
  line("between sections", family.spline == profiles::SectionSpline::through
                               ? "every point follows a cubic spline through them"
                               : "every point follows a spline that rounds kinks");
  const std::size_t count = first.features.size();
  line("features",
       count == 0 ? "none: points correspond by the fraction of the whole arc length" +
                        (family.without_features.empty() ? "" : "; " + family.without_features)
                  : fmt::format("{} {}; their ways, y, z in mm:", count,
                                family.found ? "found, bends and kinks" : "given in the list"));
  for (std::size_t k = 0; k < count; ++k) {
    const auto has = [&](const PlacedSection& section) { return !std::isnan(section.features[k]); };
    const auto from = std::find_if(sections.begin(), sections.end(), has);
    if (from == sections.end()) continue;
    const PlacedSection &start = *from,
                        &end = *std::find_if(sections.rbegin(), sections.rend(), has);
    const auto at = [&](const PlacedSection& section) {
      const profiles::ProfilePoint place = section.curve.at(section.features[k]);
      return fmt::format("{:9.3f},{:8.3f}", place.y, place.z);
    };
    text += fmt::format("    {:<34}{}  -> {}{}\n", k + 1, at(start), at(end),
                        has(first) && has(last)
                            ? ""
                            : fmt::format("  from {:g} to {:g}", start.position, end.position));
  }
  return text;
}

/// A point of a section, or of one that lacks the part.
struct SectionRow {
  double position = 0.0;  ///< of the section
  std::size_t part = 0;   ///< between features, from 1
  std::optional<ProfilePoint> place = {};
};

/// All sections: a part has as many points in each, so that equal rows of sections correspond.
std::vector<SectionRow> section_rows(const ListedSections& family) {
  constexpr double spacing = 0.5;  // mm
  std::vector<int> steps(family.sections.front().features.size() + 1, 1);
  for (const PlacedSection& section : family.sections) {
    const std::vector<double> ends = ends_of_parts(section);
    for (std::size_t part = 0; part < steps.size(); ++part)
      if (const double length = ends[part + 1] - ends[part]; length > 0.0)
        steps[part] = std::max(steps[part], static_cast<int>(std::ceil(length / spacing)));
  }
  std::vector<SectionRow> rows;
  for (const PlacedSection& section : family.sections) {
    const std::vector<double> ends = ends_of_parts(section);
    for (std::size_t part = 0; part < steps.size(); ++part)
      for (int k = 0; k <= steps[part]; ++k) {
        const double at = ends[part] + (ends[part + 1] - ends[part]) * k / steps[part];
        SectionRow& row = rows.emplace_back(SectionRow{section.position, part + 1});
        if (!std::isnan(at)) row.place = section.curve.at(at);
      }
  }
  return rows;
}

Columns<SectionRow> section_columns(bool wheel) {
  Columns<SectionRow> columns;
  columns.add("position", wheel ? "rad" : "mm",
              [](const SectionRow& row) { return fmt::format("{:g}", row.position); });
  columns.add("part", "-", &SectionRow::part);
  const auto add = [&](const char* name, double ProfilePoint::*member) {
    columns.add(name, "mm", [member](const SectionRow& row) {
      return row.place ? fmt::format("{:.6f}", (*row.place).*member) : "";
    });
  };
  add("y", &ProfilePoint::y);
  add("z", &ProfilePoint::z);
  return columns;
}

/// A list of sections: .slcw of a wheel, others of a rail unless --wheel says otherwise.
void sections(const ProfileRequest& request, const contact::ProfileSource& source, Call& call) {
  const bool wheel = request.wheel || fs::path(source.name).extension() == ".slcw";
  const profiles::ListedSections family = profiles::read_sections(source, wheel, "profile");
  const std::string title = fmt::format("{} {}", wheel ? "wheel" : "rail", source.name);
  const Columns<SectionRow> columns = section_columns(wheel);
  const std::vector<SectionRow> rows = section_rows(family);
  if (request.json) {
    nlohmann::ordered_json json = result_head("profile");
    json["title"] = title;
    json["features"] = family.sections.front().features.size();
    json.update(columns_json(columns, rows));
    print_result(json.dump(1));
    if (request.directory.empty()) return;
  }
  const fs::path file = folder_for(request) / "sections.csv";
  result::replace_file(file, fmt::format("# {}\n{}", title, columns.table(rows)));
  std::cout << sections_text(family, title, wheel);
  draw_and_print(call, file);
}

void profile(const ProfileRequest& request, Call& call) {
  contact::ProfileSource source;
  source.name = request.name;
  source.for_track = false;  // a section may hold two heads
  if (source.lists_sections() && !(request.wheel && request.rail))
    return sections(request, source, call);
  const std::vector<NamedProfile> profiles = asked_for(request);
  if (request.json) print(profiles);
  if (request.json && request.directory.empty()) return;
  const fs::path folder = folder_for(request);
  for (const NamedProfile& profile : profiles) {
    const fs::path file = folder / (profile.file + ".csv");
    std::error_code error;
    if (fs::equivalent(file, request.name, error))
      throw contact::InputError(fmt::format(
          "profile: {} is the input and would be overwritten; do: name another folder with -o",
          file.string()));
    result::replace_file(
        file, fmt::format("# {}\n{}", profile.title, profile_columns().table(rows_of(profile))));
    std::cout << described(profile) << list(profile.curve);
    draw_and_print(call, file);
  }
  if (fs::path(request.name).extension() == ".toml" && request.wheel == request.rail)
    print_pair(contact::read_case(request.name), folder, call);
}

}  // namespace

void add_profile(CLI::App& program, Call& call) {
  const auto request = std::make_shared<ProfileRequest>();
  CLI::App* profile = program.add_subcommand(
      "profile", "print, write and draw a profile of wheel or rail with its curvature");
  profile
      ->add_option(
          "name", request->name,
          "a built-in profile, a profile file, a list of sections along the way (.sections, "
          ".slcs, .slcw), or a case file (.toml) with profiles")
      ->required();
  profile->add_flag("--wheel", request->wheel, "the file is the profile of a wheel");
  profile->add_flag("--rail", request->rail, "the file is the profile of a rail");
  profile->add_option(
      "-o,--output", request->directory,
      "folder for the table (.csv) and the figure (.svg) (default: results/<name>_profile)");
  add_json_flag(*profile, request->json);
  profile->footer("example: rollfem profile S1002 -o /tmp/profile");
  profile->callback([request, &call] { app::profile(*request, call); });
}

}  // namespace rollfem::app
