// Checks of profiles, track and wheelset against each other and the rest of the case.
#include "contact/case/checks/case_checks.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rollfem::contact {

namespace {

bool is_word(const GivenValue* value, const std::string& word) {
  return value != nullptr && std::get<std::string>(value->value) == word;
}

/// What only has a meaning with profiles.
void check_without_profiles(const GivenCase& given) {
  for (const auto& [key, value] : given.values) {
    const bool is_vertical = key->path() == "load.vertical_force";
    if (key->section != "track" && key->section != "wheelset" && !is_vertical) continue;
    fail_at(given, key->path(), value,
            is_vertical ? "is for wheels and rails with profiles, but this case has none"
                        : "places profiles on a track, but this case has none",
            "profiles of both bodies, or radii without it",
            is_vertical ? "write `normal_force` instead, or give wheel.profile and rail.profile"
                        : "give wheel.profile and rail.profile, or remove it");
  }
}

void check_pair(const GivenCase& given) {
  for (const auto& [body, other] : {std::pair{"wheel", "rail"}, std::pair{"rail", "wheel"}}) {
    const GivenValue* profile = given.find(body, "profile");
    if (profile == nullptr || given.find(other, "profile") != nullptr) continue;
    fail_at(given, std::string(body) + ".profile", *profile,
            fmt::format("is given alone: {}.profile is missing", other),
            "profiles of both bodies, or of none",
            fmt::format("add `profile = \"{}\"` under [{}]; \"arcs\" makes one of radii",
                        other == std::string("rail") ? "60E1" : "S1002", other));
  }
}

void check_inclination(const GivenCase& given) {
  if (given.find("track", "inclination") != nullptr) return;
  CaseProblem problem;
  problem.line = section_line(given, "track");
  problem.column = problem.line > 0 ? 1 : 0;
  problem.key = "track.inclination";
  problem.wrong = "is missing";
  problem.allowed =
      "\"none\", \"1:20\", \"1:40\", any other ratio, or an angle in rad; there is no default, "
      "because it moves the contact";
  problem.action = "add `inclination = \"1:40\"` under [track]";
  fail(given.file, problem);
}

/// One thing only decides the longitudinal creepage.
void check_rotation(const GivenCase& given) {
  const GivenValue* free_rolling = given.find("wheelset", "free_rolling");
  const bool free = free_rolling != nullptr && !is_word(free_rolling, "none");
  struct Source {
    std::string path;
    const GivenValue* value;
  };
  const Source sources[] = {
      {"wheelset.free_rolling", free ? free_rolling : nullptr},
      {"wheelset.rotation_change", given.find("wheelset", "rotation_change")},
      {"rolling.longitudinal_creepage", given.find("rolling", "longitudinal_creepage")},
      {"rolling.longitudinal_force", given.find("rolling", "longitudinal_force")},
  };
  const Source* first = nullptr;
  for (const Source& source : sources) {
    if (source.value == nullptr) continue;
    if (first != nullptr)
      fail_at(
          given, source.path, *source.value,
          fmt::format("contradicts {} = {} of line {}, which also determines the creepage along x",
                      first->path, first->value->text, first->value->line),
          "at most one of free_rolling, rotation_change, longitudinal_creepage and "
          "longitudinal_force",
          "remove one of the two");
    first = &source;
  }
  if (is_word(free_rolling, "torque") && !is_word(given.find("wheelset", "side"), "both"))
    fail_at(given, "wheelset.free_rolling", *free_rolling,
            "needs both wheels, because their forces balance each other",
            "\"torque\" with side = \"both\", or \"force\" for each wheel separately",
            "write `side = \"both\"` under [wheelset]");
}

/// Problems that free rolling does not go with.
void check_rivals(const GivenCase& given) {
  for (const char* problem : {"shift", "transient"})
    if (is_word(given.find("rolling", "problem"), problem) &&
        given.find("wheelset", "free_rolling"))
      fail_at(given, "wheelset.free_rolling", *given.find("wheelset", "free_rolling"),
              fmt::format("is for steady rolling, and rolling.problem is {}", problem),
              "free rolling with the problem steady", "remove it");
}

}  // namespace

void check_track(const GivenCase& given) {
  if (!has_profiles(given)) {
    check_without_profiles(given);
    return;
  }
  check_pair(given);
  check_inclination(given);
  check_rotation(given);
  check_rivals(given);
}

void complete_track(const GivenCase& given, Case& input) {
  input.rolling.given = {given.find("rolling", "longitudinal_creepage") != nullptr,
                         given.find("rolling", "lateral_creepage") != nullptr,
                         given.find("rolling", "spin") != nullptr};
  Wheelset& wheelset = input.wheelset;
  const std::size_t count =
      std::max({wheelset.lateral_shift.size(), wheelset.yaw.size(), wheelset.roll.size()});
  for (auto* list : {&wheelset.lateral_shift, &wheelset.yaw, &wheelset.roll})
    if (!list->empty()) list->resize(count, list->front());
}

}  // namespace rollfem::contact
