// SPDX-License-Identifier: LGPL-2.1-or-later
#include "convert/conversion.hpp"

#include "base/errors.hpp"
#include "case/keys/case_keys.hpp"
#include "case/keys/case_text.hpp"

#include <fmt/format.h>

#include "convert/equivalent_case.hpp"
#include "convert/steps.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <regex>
#include <sstream>
#include <utility>

namespace rollfem::convert {

namespace {

/// Cases that share a case file.
struct Group {
  Equivalent first;
  std::vector<int> cases;
  std::vector<Point> points;
  std::vector<std::string> notes;
  double place = 0.0;  ///< Equivalent::place of the last case
};

bool is_in(const std::string& section, const std::string& path) {
  return contact::find_key(path)->section == section;
}

/// Turns a shift into a step of rolling by `length`.
void roll(Point& point, double length) {
  point["history.step_length"] = length;
  for (const auto& [shift, creepage] :
       {std::pair("history.longitudinal_shift", "rolling.longitudinal_creepage"),
        {"history.lateral_shift", "rolling.lateral_creepage"},
        {"history.spin_shift", "rolling.spin"}})
    if (auto found = point.extract(shift)) point[creepage] = found.mapped() / length;
}

/// Turns a shift from rest into the first step of a transient (of any length), so that all steps
/// are of one kind. `next` is the step that rolls.
void roll_first_step(Group& group, const Equivalent& next) {
  roll(group.points.front(), next.varied.at("history.step_length"));
  group.first.problem = "transient";
  group.first.fixed["rolling"] = next.fixed.at("rolling");
  group.notes.push_back(
      "the first step is a shift in CONTACT; from rest it equals a step of rolling under the same "
      "force");
}

/// Turns a shift of a patch that has moved on along x into a step of rolling in axes that move with
/// it. The grid is that of the first step.
void follow_patch(const Group& group, Equivalent& next) {
  const double length = next.place - group.place;
  if (!next.continues || next.problem != "shift" || !(length > 0.0) ||
      next.varied["history.spin_shift"] != 0.0)
    return;
  roll(next.varied, length);
  next.problem = "transient";
  next.set("rolling", "upwind_order", "first");
  next.fixed["contact_grid"] = group.first.fixed.at("contact_grid");
  next.notes.push_back(
      "the patch moves along x in CONTACT's axes: here the axes move with it, and it rolls");
}

/// Gives the first step the approach of the next one, to which its force leads.
void press_first_step(Group& group, const Equivalent& next) {
  const auto approach = next.varied.find("history.approach");
  Point& point = group.points.front();
  const auto force = point.find("history.normal_force");
  constexpr double alike = 0.01;
  if (approach == next.varied.end() || force == point.end() ||
      !(std::abs(group.first.approach - approach->second) < alike * approach->second))
    return;
  point.erase(force);
  point["history.approach"] = approach->second;
  group.notes.push_back("the first step has the approach of the second, to which its FN leads");
}

bool joins(const Group& group, const Equivalent& next) {
  return follows(group.first, group.points.front(), next);
}

/// Turns the last steady case, alone in its group, into the first step of the transient that `next`
/// continues; false if that is impossible.
bool start_steadily(std::vector<Group>& groups, const Equivalent& next) {
  Group& last = groups.back();
  Equivalent steady = last.first;
  steady.varied = last.points.back();
  const auto start = steady_start(std::move(steady), next);
  if (!start) return false;
  Group steps{*start, {last.cases.back()}, {start->varied}, last.notes, last.place};
  if (last.first.from_sliding != next.from_sliding)
    steps.notes.push_back(
        fmt::format("INISLP of case {} is taken to be that of the steps", steps.cases.front()));
  last.cases.pop_back();
  last.points.pop_back();
  if (last.cases.empty()) groups.pop_back();
  groups.push_back(steps);
  return true;
}

/// Whether `next` may join the last group; an initial shift or steady case there becomes a step if
/// needed.
bool can_join(std::vector<Group>& groups, const Equivalent& next) {
  Group& group = groups.back();
  if (joins(group, next) || start_steadily(groups, next)) return true;
  if (!next.continues || group.points.size() != 1) return false;
  Group changed = group;
  press_first_step(changed, next);
  if (next.problem == "transient" && group.first.problem == "shift") roll_first_step(changed, next);
  if (!joins(changed, next)) return false;
  group = changed;
  return true;
}

void add(Group& group, int number, const Equivalent& made) {
  group.cases.push_back(number);
  group.points.push_back(made.varied);
  group.place = made.place;
  if (group.first.stresses.empty()) group.first.stresses = made.stresses;
  for (const std::string& note : made.notes)
    if (std::find(group.notes.begin(), group.notes.end(), note) == group.notes.end())
      group.notes.push_back(note);
}

/// One number if all are equal, otherwise, or if `listed`, a list with ten numbers per line.
std::string values_text(const std::string& key, const std::vector<double>& values, bool listed) {
  if (!listed &&
      std::all_of(values.begin(), values.end(), [&](double v) { return v == values.front(); }))
    return fmt::format("{} = {:.12g}", key, values.front());
  std::string text = key + " = [";
  for (std::size_t k = 0; k < values.size(); ++k)
    text += fmt::format("{}{:.12g}", k == 0 ? "" : k % 10 == 0 ? ",\n  " : ", ", values[k]);
  return text + "]";
}

/// Whether there are several load points and no value tells how many.
bool are_alike(const std::vector<Point>& points) {
  return points.size() > 1 && std::all_of(points.begin(), points.end(), [&](const Point& point) {
           return point == points.front();
         });
}

std::string distance_text(const std::vector<std::array<double, 3>>& points) {
  std::string text = "x, y, h\n";
  for (const auto& [x, y, h] : points) text += fmt::format("{:.12g}, {:.12g}, {:.12g}\n", x, y, h);
  return text;
}

/// Text of a section of the case file `name`; empty without keys.
std::string section_text(const Group& group, const std::string& section, const std::string& name) {
  std::string text;
  const auto add = [&](const std::string& line) { text += line + "\n"; };
  if (section == "rolling" && group.first.problem != "steady")
    add(fmt::format("problem = \"{}\"", group.first.problem));
  if (const auto fixed = group.first.fixed.find(section); fixed != group.first.fixed.end())
    for (const Setting& setting : fixed->second) add(setting.line());
  const bool alike = are_alike(group.points);
  bool listed = alike && !group.first.history() && section != "load";
  for (const auto& [path, value] : group.points.front()) {
    if (!is_in(section, path)) continue;
    std::vector<double> values;
    for (const Point& point : group.points) values.push_back(point.at(path));
    add(values_text(contact::find_key(path)->name, values, std::exchange(listed, false)));
  }
  if (section == "friction" && group.first.from_sliding) add("branch = \"sliding\"");
  if (section == "history" && group.first.starts_steady) add("start = \"steady\"");
  if (section == "history" && group.first.history() && alike)
    add(fmt::format("steps = {}", group.points.size()));
  if (section == "undeformed_distance" && !group.first.distance.empty())
    add("file = " + contact::toml_text(name + "_distance.csv"));
  return text.empty() ? text : fmt::format("\n[{}]\n", section) + text;
}

std::string case_text(const Group& group, const std::string& name, const std::string& source) {
  const bool one = group.cases.size() == 1;
  const std::string which =
      fmt::format("{}, {} {}", source, one ? "case" : "cases", numbers_text(group.cases));
  std::string text = fmt::format("# Made by rollfem convert of {}{}.\n", which,
                                 one ? "" : ", one load point each, in this order");
  text += "# Signs, and how every digit is converted: docs/coming_from_contact.md\n";
  text += "# Units: mm, N, MPa, rad. Keys: docs/case-file.md\n";
  for (const std::string& note : group.notes) text += "# note: " + note + "\n";
  text += fmt::format("\ntitle = {}\nmodels = [\"{}\"]\n", contact::toml_text(which),
                      group.first.model);
  for (const contact::Section& section : contact::case_sections())
    text += section_text(group, section.name, name);
  return text + group.first.stresses;
}

}  // namespace

std::string numbers_text(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t k = 0; k < numbers.size();) {
    std::size_t end = k;
    while (end + 1 < numbers.size() && numbers[end + 1] == numbers[end] + 1) ++end;
    text += (text.empty() ? "" : ", ") + std::to_string(numbers[k]);
    if (end > k) text += fmt::format("{}{}", end == k + 1 ? ", " : " to ", numbers[end]);
    k = end + 1;
  }
  return text;
}

std::vector<int> numbers_of(const std::string& text, int count, const std::string& file) {
  const auto refuse = [&](const std::string& word, const std::string& what) {
    throw contact::InputError(fmt::format(
        "--cases {}: {}: {}; allowed: numbers and ranges from 1 to {}, the cases in {}; do: e.g. "
        "--cases 1-{}",
        text, word, what, count, file, count));
  };
  std::vector<int> numbers;
  std::istringstream words(text + ",");
  for (std::string word; std::getline(words, word, ',');) {
    static const std::regex range("([0-9]{1,9})(-([0-9]{1,9}))?");
    std::smatch ends;
    if (!std::regex_match(word, ends, range)) refuse(word, "not a number or a range");
    const int first = std::stoi(ends[1]), last = ends[3].matched ? std::stoi(ends[3]) : first;
    if (first > last) refuse(word, "the range runs backwards");
    for (const int end : {first, last})
      if (end < 1 || end > count) refuse(word, fmt::format("there is no case {}", end));
    for (int number = first; number <= last; ++number) numbers.push_back(number);
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

Conversion convert_cases(const std::vector<ContactCase>& cases, const std::string& stem,
                         const std::string& source, const std::string& profile_folder,
                         const std::vector<int>& chosen) {
  Conversion conversion;
  std::vector<Group> groups;
  bool open = false;  // whether the last case is in the last group
  bool chosen_before = true;
  for (const ContactCase& given : cases) {
    const bool is_chosen =
        chosen.empty() || std::binary_search(chosen.begin(), chosen.end(), given.number);
    const bool follows_chosen = std::exchange(chosen_before, is_chosen);
    Equivalent made = equivalent_of(given, profile_folder);
    open = open && follows_chosen;
    if (!is_chosen) continue;
    if (open) follow_patch(groups.back(), made);
    if (open && made.continues && given.module == 1 && given.digits.T == 1)
      set_way(groups.back().place, made);
    const bool joined = made.impossible.empty() && open && can_join(groups, made);
    if (made.impossible.empty() && made.continues && !joined)
      made.impossible.push_back(
          open ? "digit P = 0: the case continues another one but differs from it in "
                 "more than load, creepages and forces"
          : follows_chosen
              ? "digit P = 0: the case continues one that has no equivalent"
              : fmt::format("digit P = 0: the case continues case {}, which --cases leaves out",
                            given.number - 1));
    open = made.impossible.empty();
    if (!open) {
      conversion.refused.push_back({given.number, given.line, made.impossible});
      continue;
    }
    if (!joined) groups.push_back({made, {}, {}, {}, 0.0});
    add(groups.back(), given.number, made);
  }
  const std::size_t digits =
      std::to_string(cases.size()).size();  // leading zeros, so that files sort
  for (Group& group : groups) {
    remove_unused_values(group.points);
    const std::string name = groups.size() == 1 && group.cases.size() == cases.size()
                                 ? stem
                                 : fmt::format("{}_{:0{}}", stem, group.cases.front(), digits);
    CaseFile file{name + ".toml", group.cases, case_text(group, name, source), {}, group.notes};
    if (!group.first.distance.empty())
      file.attached_files[name + "_distance.csv"] = distance_text(group.first.distance);
    conversion.files.push_back(file);
  }
  return conversion;
}

}  // namespace rollfem::convert
