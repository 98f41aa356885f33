// SPDX-License-Identifier: LGPL-2.1-or-later
#include "convert/steps.hpp"

#include "case/keys/case_keys.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rollfem::convert {

namespace {

/// Turns a value that all cases share into a value of one of them.
void loosen(Equivalent& made, const std::string& section, const std::string& key,
            const std::string& path) {
  auto& settings = made.fixed[section];
  const auto found = std::find_if(settings.begin(), settings.end(),
                                  [&](const Setting& setting) { return setting.key == key; });
  if (found != settings.end()) {
    made.varied[path] = std::get<double>(found->value);
    settings.erase(found);
  }
  if (settings.empty()) made.fixed.erase(section);
}

/// Whether the keys are equal, some of them may be lists over load points, and the values of load
/// keys, which may not, are equal.
bool same_keys(const Point& a, const Point& b) {
  const auto is_load = [](auto& entry) {
    return contact::find_key(entry.first)->section == "load";
  };
  return !std::all_of(a.begin(), a.end(), is_load) &&
         std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](auto& x, auto& y) {
           return x.first == y.first && (!is_load(x) || x.second == y.second);
         });
}

}  // namespace

bool follows(const Equivalent& first, const Point& point, const Equivalent& next) {
  return first.from_sliding == next.from_sliding && first.model == next.model &&
         first.problem == next.problem && first.fixed == next.fixed &&
         first.distance == next.distance && first.history() == next.continues &&
         same_keys(point, next.varied);
}

void set_way(double before, Equivalent& next) {
  const double way = next.place - before;
  if (way > 0.0)
    next.varied["history.step_length"] = way;
  else
    next.impossible.push_back(
        fmt::format("digit T = 1: the contact moves by {:g} mm (S) and does not roll", way));
}

std::optional<Equivalent> steady_start(Equivalent steady, const Equivalent& next) {
  if (!next.continues || next.problem != "transient" || steady.problem != "steady") return {};
  steady.problem = next.problem;
  steady.starts_steady = true;
  steady.from_sliding = next.from_sliding;
  loosen(steady, "load", "vertical_force", "history.vertical_force");
  loosen(steady, "wheelset", "rotation_change", "wheelset.rotation_change");
  for (const std::string load : {"normal_force", "approach"})
    if (next.varied.count("history." + load) != 0)
      if (auto found = steady.varied.extract("load." + load)) {
        found.key() = "history." + load;
        steady.varied.insert(std::move(found));
      }
  const double length = steady.varied["history.step_length"] =
      next.varied.at("history.step_length");
  if (next.varied.count("history.wheel_way") != 0) steady.varied["history.wheel_way"] = length;
  if (!follows(steady, steady.varied, next)) return {};
  return steady;
}

}  // namespace rollfem::convert
