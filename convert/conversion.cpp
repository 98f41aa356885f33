#include "convert/conversion.hpp"

#include <fmt/format.h>

#include "convert/equivalent.hpp"
#include <algorithm>
#include <array>

namespace rollfem::convert {

namespace {

/// Cases that share a file.
struct Group {
  Equivalent first;
  std::vector<int> cases;
  std::vector<std::map<std::string, double>> points;
  std::vector<std::string> notes;
};

bool is_load(const std::string& key) {
  return key.rfind("load.", 0) == 0;
}

bool same_keys(const std::map<std::string, double>& a, const std::map<std::string, double>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](auto& x, auto& y) {
           return x.first == y.first && (!is_load(x.first) || x.second == y.second);
         });
}

/// A shift from rest is the first step of a transient, whatever its length: then all steps are of
/// one kind. `next` is the step that rolls.
void roll_first_step(Group& group, const Equivalent& next) {
  const double length = next.varied.at("history.step_length");
  std::map<std::string, double> point{{"history.step_length", length}};
  const std::map<std::string, std::string> creepages{
      {"history.longitudinal_shift", "rolling.longitudinal_creepage"},
      {"history.lateral_shift", "rolling.lateral_creepage"},
      {"history.spin_shift", "rolling.spin"}};
  for (const auto& [key, value] : group.points.front()) {
    const auto creepage = creepages.find(key);
    if (creepage == creepages.end())
      point[key] = value;
    else
      point[creepage->second] = value / length;
  }
  group.points.front() = point;
  group.first.problem = "transient";
  group.first.fixed["rolling"] = next.fixed.at("rolling");
  group.notes.push_back(
      "the first step is a shift in CONTACT; from rest it equals a step of rolling under the same "
      "force");
}

bool joins(const Group& group, const Equivalent& next) {
  const Equivalent& first = group.first;
  return first.model == next.model && first.problem == next.problem && first.fixed == next.fixed &&
         first.files == next.files && first.history() == next.continues &&
         same_keys(group.points.front(), next.varied);
}

/// Whether `next` may follow, which turns a shift at the beginning into a step.
bool admits(Group& group, const Equivalent& next) {
  if (joins(group, next)) return true;
  const bool onset = next.continues && next.problem == "transient" &&
                     group.first.problem == "shift" && group.points.size() == 1;
  if (!onset) return false;
  Group rolled = group;
  roll_first_step(rolled, next);
  if (!joins(rolled, next)) return false;
  group = rolled;
  return true;
}

void add(Group& group, int number, const Equivalent& made) {
  group.cases.push_back(number);
  group.points.push_back(made.varied);
  if (group.first.stresses.empty()) group.first.stresses = made.stresses;
  for (const std::string& note : made.notes)
    if (std::find(group.notes.begin(), group.notes.end(), note) == group.notes.end())
      group.notes.push_back(note);
}

/// One number where all are the same, else a list, ten to a line.
std::string values_text(const std::string& key, const std::vector<double>& values) {
  if (std::all_of(values.begin(), values.end(), [&](double v) { return v == values.front(); }))
    return fmt::format("{} = {:.12g}", key, values.front());
  std::string text = key + " = [";
  for (std::size_t k = 0; k < values.size(); ++k)
    text += fmt::format("{}{:.12g}", k == 0 ? "" : k % 10 == 0 ? ",\n  " : ", ", values[k]);
  return text + "]";
}

/// Sections in the order in which a case is read.
constexpr std::array<const char*, 15> sections{
    "load",           "friction",     "wheel",    "rail",    "geometry", "wheel_profile",
    "rail_profile",   "track",        "wheelset", "rolling", "history",  "undeformed_distance",
    "given_pressure", "contact_grid", "halfspace"};

/// Lines of a section; `several` where a list says how many load points there are.
std::vector<std::string> lines_of(const Group& group, const std::string& section, bool& several) {
  std::vector<std::string> lines;
  const auto fixed = group.first.fixed.find(section);
  if (section == "rolling" && group.first.problem != "steady")
    lines.push_back(fmt::format("problem = \"{}\"", group.first.problem));
  if (fixed != group.first.fixed.end())
    lines.insert(lines.end(), fixed->second.begin(), fixed->second.end());
  for (const auto& [key, value] : group.points.front()) {
    if (key.rfind(section + ".", 0) != 0) continue;
    std::vector<double> values;
    for (const auto& point : group.points) values.push_back(point.at(key));
    lines.push_back(values_text(key.substr(section.size() + 1), values));
    several = several || lines.back().find('[') != std::string::npos;
  }
  return lines;
}

std::string case_text(const Group& group, const std::string& name, const std::string& source) {
  const std::string which = group.cases.size() == 1 ? "case" : "cases";
  std::string text = fmt::format("# Made by rollfem convert of {}, {} {}", source, which,
                                 numbers_text(group.cases));
  text += group.cases.size() == 1 ? ".\n" : ", one load point each, in this order.\n";
  text += "# Signs, and how every digit is converted: docs/coming_from_contact.md\n";
  text += "# Units: mm, N, MPa, rad. Keys: docs/case-file.md\n";
  for (const std::string& note : group.notes) text += "# note: " + note + "\n";
  text += fmt::format("\ntitle = {}\nmodels = [\"{}\"]\n",
                      quoted(fmt::format("{}, {} {}", source, which, numbers_text(group.cases))),
                      group.first.model);
  bool several = false;
  std::string body;
  const auto write = [&](const std::string& section, std::vector<std::string> lines) {
    if (section == "history" && !several && group.points.size() > 1)
      lines.push_back(fmt::format("steps = {}", group.points.size()));
    if (section == "undeformed_distance" && !group.first.files.empty())
      lines.push_back("file = " + quoted(name + "_distance.csv"));
    if (lines.empty()) return;
    body += fmt::format("\n[{}]\n", section);
    for (const std::string& line : lines) body += line + "\n";
  };
  for (const char* section : sections) write(section, lines_of(group, section, several));
  write("fastsim", lines_of(group, "fastsim", several));
  return text + body + group.first.stresses;
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

Conversion convert_cases(const std::vector<ContactCase>& cases, const std::string& stem,
                         const std::string& source, const std::string& profile_folder) {
  Conversion conversion;
  std::vector<Group> groups;
  bool open = false;    // the last case is in the last group
  bool coarse = false;  // cases from rest up to here have too few elements, nothing else
  for (const ContactCase& given : cases) {
    Equivalent made = equivalent_of(given, profile_folder);
    const bool joined = made.impossible.empty() && open && admits(groups.back(), made);
    const bool begins_late = made.continues && coarse;
    coarse = made.too_coarse && (begins_late || !made.continues);
    if (made.impossible.empty() && begins_late)
      made.notes.push_back(
          "the history begins here: earlier cases have fewer than 4 elements across the patch");
    else if (made.impossible.empty() && made.continues && !joined)
      made.impossible.push_back(open ? "digit P = 0: it continues a case but differs from it in "
                                       "more than load, creepages and forces"
                                     : "digit P = 0: it continues a case that has no equivalent");
    open = made.impossible.empty();
    if (!open) {
      conversion.refused.push_back({given.number, given.line, made.impossible});
      continue;
    }
    if (!joined) groups.push_back({made, {}, {}, {}});
    add(groups.back(), given.number, made);
  }
  const std::size_t digits = std::to_string(cases.size()).size();  // so that files sort
  for (const Group& group : groups) {
    const std::string name = groups.size() == 1 && conversion.refused.empty()
                                 ? stem
                                 : fmt::format("{}_{:0{}}", stem, group.cases.front(), digits);
    CaseFile file{name + ".toml", group.cases, case_text(group, name, source), {}, group.notes};
    for (const auto& [ending, text] : group.first.files) file.beside[name + "_" + ending] = text;
    conversion.files.push_back(file);
  }
  return conversion;
}

}  // namespace rollfem::convert
