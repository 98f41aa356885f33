// SPDX-License-Identifier: LGPL-2.1-or-later
// Profiles in a case file: one shape for each body, and only keys used by its kind of profile.
#include "contact/case/checks/case_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace rollfem::contact {

namespace {

/// Keys used by only one kind of profile.
bool is_read(const std::string& key, const std::string& profile, std::string& by) {
  const auto among = [&](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), key) != names.end();
  };
  const bool arcs = profile == "arcs";
  const bool polynomial = profile == "polynomial";
  if (among({"radii", "ends", "symmetric", "slope"})) {
    by = "profile = \"arcs\"";
    return arcs;
  }
  if (among({"coefficients", "limits"})) {
    by = "profile = \"polynomial\"";
    return polynomial;
  }
  if (among({"mirror", "rotation", "shift"})) return true;
  by = "profiles from files";
  // Names of built-in profiles have no extension; a file without extension is given as "./name".
  return !arcs && !polynomial && profile.find_first_of("./") != std::string::npos;
}

void check_body(const GivenCase& given, const std::string& body) {
  const GivenValue* profile = given.find(body, "profile");
  const std::string section = body + "_profile";
  for (const auto& [key, value] : given.values) {
    if (key->section != section) continue;
    CaseProblem problem = problem_at(key->path(), value);
    if (profile == nullptr) {
      problem.wrong = fmt::format("is not used, because {}.profile is missing", body);
      problem.allowed = fmt::format("[{}] together with [{}] profile", section, body);
      problem.action =
          fmt::format("add `profile = \"FILE\"` under [{}], or remove [{}]", body, section);
      fail(given.file, problem);
    }
    std::string by;
    if (is_read(key->name, std::get<std::string>(profile->value), by)) continue;
    problem.wrong = fmt::format("is not used with {}.profile = {}", body, profile->text);
    problem.allowed = by;
    problem.action = "remove it, or name another profile";
    fail(given.file, problem);
  }
  if (profile == nullptr) return;
  CaseProblem problem = problem_at(body + ".profile", *profile);
  if (std::get<std::string>(profile->value).empty()) {
    problem.wrong = "is empty";
    problem.allowed = "a built-in profile, arcs, polynomial or a file";
    problem.action = "name one";
    fail(given.file, problem);
  }
}

}  // namespace

void check_profiles(const GivenCase& given) {
  check_body(given, "wheel");
  check_body(given, "rail");
}

}  // namespace rollfem::contact
