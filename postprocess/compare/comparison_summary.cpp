// All cases of a comparison in words: which models agree where, by how much, at what cost.
#include "postprocess/compare/comparison.hpp"
#include "postprocess/compare/comparison_spoken.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace rollfem::postprocess {
namespace {

/// A case by name, and how one model stands in it in one quantity, all places together.
using InCases = std::vector<std::pair<std::string, const Standing*>>;

/// The same cases with their places taken together.
std::vector<CaseStandings> together(std::vector<CaseStandings> cases) {
  for (CaseStandings& one : cases) one.standings = over_places(one.standings);
  return cases;
}

std::vector<std::string> models_of(const std::vector<CaseStandings>& cases) {
  std::vector<std::string> names;
  for (const CaseStandings& one : cases)
    for (const auto& [model, seconds] : one.seconds)
      if (std::find(names.begin(), names.end(), model) == names.end()) names.push_back(model);
  return names;
}

InCases in_cases(const std::vector<CaseStandings>& cases, const std::string& model,
                 const Spoken& about) {
  InCases found;
  for (const CaseStandings& one : cases)
    if (const Standing* standing = find_standing(one.standings, model, about.quantity))
      found.emplace_back(one.name, standing);
  return found;
}

double size_of(const InCases::value_type& entry) {
  return std::abs(entry.second->worst.difference());
}

double largest(const InCases& cases) {
  double value = 0.0;
  for (const auto& entry : cases) value = std::max(value, size_of(entry));
  return value;
}

/// Of more cases than this their range is told, not each.
constexpr std::size_t most_listed = 2;

/// The difference that is farthest beyond the bars.
double beyond_of(const InCases::value_type& entry) {
  return std::abs(entry.second->beyond.difference());
}

/// "0.62 % in thesis_f to 8.5 % in thesis_d", or each with what the bars allow.
std::string beyond_values(const InCases& beyond, bool of_several) {
  if (beyond.size() > most_listed) {
    const auto [low, high] = std::minmax_element(
        beyond.begin(), beyond.end(),
        [](const auto& a, const auto& b) { return beyond_of(a) < beyond_of(b); });
    return fmt::format("{} % in {} to {} % in {}", percent(beyond_of(*low)), low->first,
                       percent(beyond_of(*high)), high->first);
  }
  std::vector<std::string> parts;
  for (const auto& entry : beyond)
    parts.push_back(fmt::format("{} %{}, where they allow {} %", percent(beyond_of(entry)),
                                of_several ? " in " + entry.first : "",
                                percent(entry.second->beyond.allowed())));
  return list(parts, "; ");
}

/// "fem (0.56 % in thesis_a, where they allow 0.36 %; at 4 of 7 load points; in the others at most
/// 0.2 %)".
std::string beyond_words(const std::string& model, const InCases& beyond, const InCases& within) {
  int differ = 0;
  int compared = 0;
  for (const auto& [name, standing] : beyond) {
    differ += standing->differ;
    compared += standing->compared;
  }
  std::string text =
      fmt::format("{} ({}", model, beyond_values(beyond, beyond.size() + within.size() > 1));
  if (differ < compared) text += fmt::format("; at {} of {} load points there", differ, compared);
  if (!within.empty())
    text += fmt::format("; in the other{} at most {} %", within.size() > 1 ? "s" : "",
                        percent(largest(within)));
  return text + ")";
}

/// One sentence on a quantity; empty when nothing of it was compared.
std::string quantity_words(const std::vector<CaseStandings>& cases, const Spoken& about) {
  std::vector<std::string> agree;
  std::vector<std::string> always;
  std::vector<std::string> sometimes;
  std::string reference;
  for (const std::string& model : models_of(cases)) {
    const InCases found = in_cases(cases, model, about);
    if (found.empty()) continue;
    if (reference.empty()) reference = found.front().second->reference;
    InCases within;
    InCases beyond;
    for (const auto& entry : found) (entry.second->differ > 0 ? beyond : within).push_back(entry);
    if (beyond.empty())
      agree.push_back(fmt::format("{} ({}{} %)", model, found.size() > 1 ? "at most " : "",
                                  percent(largest(within))));
    else
      (within.empty() ? always : sometimes).push_back(beyond_words(model, beyond, within));
  }
  const char* everywhere = cases.size() > 1 ? " in every case" : "";
  std::vector<std::string> parts;
  const auto add = [&](const char* how, const std::vector<std::string>& models,
                       const char* cases_of) {
    if (!models.empty())
      parts.push_back(fmt::format("{} {}{}: {}", how, parts.empty() ? "the error bars" : "them",
                                  cases_of, list(models, ", ")));
  };
  add("within", agree, everywhere);
  add("beyond", sometimes, " in some");
  add("beyond", always, everywhere);
  if (parts.empty()) return {};
  const std::string unit = about.unit;
  return fmt::format("The {} against {}{}: {}.", about.name, reference,
                     unit == " %" ? "" : ", in" + unit, list(parts, "; "));
}

/// Seconds for reading, without an exponent.
std::string seconds_words(double seconds) {
  return seconds >= 10.0 ? fmt::format("{:.0f}", seconds) : fmt::format("{:.2g}", seconds);
}

std::string cost_words(const std::vector<CaseStandings>& cases) {
  std::vector<std::string> parts;
  for (const std::string& model : models_of(cases)) {
    std::vector<double> seconds;
    for (const CaseStandings& one : cases)
      for (const auto& [name, time] : one.seconds)
        if (name == model) seconds.push_back(time);
    const auto [least, most] = std::minmax_element(seconds.begin(), seconds.end());
    const std::string low = seconds_words(*least);
    const std::string high = seconds_words(*most);
    parts.push_back(fmt::format("{} {}{} s", model, low == high ? "" : low + " to ", high));
  }
  return parts.empty() ? "" : fmt::format("Cost a case: {}.", list(parts, ", "));
}

/// Finite bodies are not half-spaces: said where the two differ in forces or pressure by more than
/// their bars.
std::string elasticity_words(const std::vector<CaseStandings>& cases) {
  const std::set<std::string> known{"max_pressure", "traction_coefficient", "lateral_coefficient"};
  for (const CaseStandings& one : cases)
    for (const Standing& s : one.standings)
      if (s.differ > 0 && known.count(s.quantity) == 1 &&
          std::set<std::string>{s.model, s.reference} == std::set<std::string>{"fem", "halfspace"})
        return "Where fem and halfspace differ by more than the bars, not all of it is error: a "
               "half-space leaves out how a loaded wheel is strained along its circle, which gives "
               "a force even at xi = 0, and that a curved patch is not flat; docs/verification.md "
               "has both, measured part by part.";
  return {};
}

}  // namespace

std::vector<std::string> summary_words(const std::vector<CaseStandings>& cases) {
  const std::vector<CaseStandings> all = together(cases);
  std::vector<std::string> sentences;
  for (const Spoken& about : spoken())
    if (std::string(about.quantity).rfind("semi_axis", 0) != 0)
      sentences.push_back(quantity_words(all, about));
  sentences.push_back(elasticity_words(all));
  sentences.push_back(cost_words(all));
  sentences.erase(std::remove(sentences.begin(), sentences.end(), std::string()), sentences.end());
  return sentences;
}

}  // namespace rollfem::postprocess
