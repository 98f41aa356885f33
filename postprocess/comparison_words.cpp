// The comparison in words.
#include "postprocess/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace rollfem::postprocess {
namespace {

struct Spoken {
  const char* quantity;
  const char* name;
  const char* unit;  ///< of a difference
};

/// What the sentences are about, in their order; the files have more.
const std::vector<Spoken>& spoken() {
  static const std::vector<Spoken> all{{"max_pressure", "largest pressure", " %"},
                                       {"semi_axis_x", "semi-axis along x", " %"},
                                       {"semi_axis_y", "semi-axis along y", " %"},
                                       {"traction_coefficient", "traction coefficient", " % of mu"},
                                       {"lateral_coefficient", "lateral coefficient", " % of mu"},
                                       {"max_traction_x", "largest |p_x|", " % of mu p0"}};
  return all;
}

/// Seconds for reading, without an exponent.
std::string seconds_words(double seconds) {
  return seconds >= 10.0 ? fmt::format("{:.0f}", seconds) : fmt::format("{:.2g}", seconds);
}

/// Percent with two digits that mean something.
std::string percent(double value) {
  const double size = std::abs(100.0 * value);
  return fmt::format("{:.{}f}", size,
                     size >= 9.95     ? 0
                     : size >= 0.995  ? 1
                     : size >= 0.0995 ? 2
                                      : 3);
}

/// Where on the creep curve; empty with one load point.
std::string place(const Standing& standing) {
  const ComparedNumber& worst = standing.beyond;
  if (standing.compared < 2) return {};
  std::string text = worst.patch.empty() ? "" : worst.patch + ", ";
  return fmt::format("{}load point {}, xi = {:.4g} %", text, worst.point,
                     100.0 * worst.longitudinal_creepage);
}

std::vector<std::string> models_of(const std::vector<Standing>& standings) {
  std::vector<std::string> names;
  for (const Standing& standing : standings)
    if (std::find(names.begin(), names.end(), standing.model) == names.end())
      names.push_back(standing.model);
  return names;
}

const Standing* find(const std::vector<Standing>& standings, const std::string& model,
                     const std::string& quantity) {
  for (const Standing& standing : standings)
    if (standing.model == model && standing.quantity == quantity) return &standing;
  return nullptr;
}

std::string list(const std::vector<std::string>& parts, const char* separator) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : separator) + part;
  return text;
}

std::string difference_words(const Standing& standing, const Spoken& about) {
  const ComparedNumber& worst = standing.beyond;
  std::string text =
      fmt::format("the {} is {} by {}{}", about.name, worst.difference() > 0.0 ? "higher" : "lower",
                  percent(worst.difference()), about.unit);
  const std::string at = place(standing);
  if (!at.empty()) text += fmt::format(" ({})", at);
  text += fmt::format(", where the error bars allow {}{}", percent(worst.allowed()), about.unit);
  if (standing.compared > 1)
    text +=
        fmt::format("; beyond them at {} of {} load points", standing.differ, standing.compared);
  if (std::abs(standing.worst.difference()) > std::abs(worst.difference()))
    text +=
        fmt::format(" (the largest difference is {}{}, {})", percent(standing.worst.difference()),
                    about.unit, standing.worst.differs() ? "with larger bars" : "within them");
  return text;
}

/// "0.9 % of mu (thesis_b) to 3.1 % of mu (thesis_c)".
std::string range_words(const std::vector<std::pair<std::string, const Standing*>>& cases,
                        const Spoken& about) {
  const auto size = [](const auto& entry) { return std::abs(entry.second->worst.difference()); };
  const auto [low, high] = std::minmax_element(
      cases.begin(), cases.end(), [&](const auto& a, const auto& b) { return size(a) < size(b); });
  std::vector<std::string> beyond;
  for (const auto& [name, standing] : cases)
    if (standing->differ > 0) beyond.push_back(name);
  std::string text = fmt::format("{} {}{}", about.name, percent(size(*low)), about.unit);
  if (cases.size() > 1)
    text += fmt::format(" ({}) to {}{} ({})", low->first, percent(size(*high)), about.unit,
                        high->first);
  if (beyond.empty()) return text + ", within the error bars";
  if (beyond.size() == cases.size())
    return text +
           (cases.size() > 1 ? ", beyond the error bars in every case" : ", beyond the error bars");
  return text + ", beyond the error bars in " + list(beyond, ", ");
}

}  // namespace

std::vector<std::string> comparison_words(const std::vector<Standing>& standings) {
  std::vector<std::string> sentences;
  for (const std::string& model : models_of(standings)) {
    std::vector<std::string> agree;
    std::vector<std::string> differ;
    std::string reference;
    for (const Spoken& about : spoken()) {
      const Standing* standing = find(standings, model, about.quantity);
      if (standing == nullptr) continue;
      reference = standing->reference;
      if (standing->differ == 0)
        agree.push_back(fmt::format("{} ({}{})", about.name, percent(standing->worst.difference()),
                                    about.unit));
      else
        differ.push_back(difference_words(*standing, about));
    }
    std::string text = fmt::format("{} against {}: ", model, reference);
    if (!agree.empty()) text += "within the error bars " + list(agree, ", ");
    if (!agree.empty() && !differ.empty()) text += "; ";
    sentences.push_back(text + list(differ, "; ") + ".");
  }
  return sentences;
}

std::vector<std::string> summary_words(const std::vector<CaseStandings>& cases) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<double>> seconds;
  for (const CaseStandings& one : cases)
    for (const auto& [model, time] : one.seconds) {
      if (seconds.count(model) == 0) order.push_back(model);
      seconds[model].push_back(time);
    }
  std::vector<std::string> sentences;
  for (const std::string& model : order) {
    std::vector<std::string> parts;
    std::string reference;
    for (const Spoken& about : spoken()) {
      if (std::string(about.quantity).rfind("semi_axis", 0) == 0) continue;
      std::vector<std::pair<std::string, const Standing*>> found;
      for (const CaseStandings& one : cases)
        if (const Standing* standing = find(one.standings, model, about.quantity))
          found.emplace_back(one.name, standing);
      if (found.empty()) continue;
      if (reference.empty()) reference = found.front().second->reference;
      parts.push_back(range_words(found, about));
    }
    const auto [least, most] = std::minmax_element(seconds[model].begin(), seconds[model].end());
    std::string cost = seconds_words(*most) + " s";
    if (seconds[model].size() > 1)
      cost = fmt::format("{} to {} s a case", seconds_words(*least), seconds_words(*most));
    sentences.push_back(parts.empty() ? fmt::format("{} ({}): the reference.", model, cost)
                                      : fmt::format("{} ({}), largest differences to {}: {}.",
                                                    model, cost, reference, list(parts, "; ")));
  }
  return sentences;
}

}  // namespace rollfem::postprocess
