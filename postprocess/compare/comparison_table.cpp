// SPDX-License-Identifier: LGPL-2.1-or-later
// A comparison for the terminal: a table for each case, and one line on all of them.
#include "contact/case/case_text.hpp"
#include "postprocess/compare/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::postprocess {
namespace {

using contact::joined;

/// Columns of the table; the files contain more quantities.
struct Column {
  const char* quantity;
  const char* name;
  const char* unit;  ///< unit of a difference
};

constexpr Column columns[] = {{"max_pressure", "p0", "%"},
                              {"semi_axis_x", "semi-axis x", "%"},
                              {"semi_axis_y", "semi-axis y", "%"},
                              {"traction_coefficient", "-F_x/F_z", "% of mu"},
                              {"lateral_coefficient", "-F_y/F_z", "% of mu"},
                              {"longitudinal_creepage", "xi", "%"},
                              {"lateral_creepage", "eta", "%"},
                              {"longitudinal_shift", "shift x", "%"},
                              {"lateral_shift", "shift y", "%"},
                              {"max_traction_x", "|p_x|", "% of mu p0"}};

/// Percent with two significant digits.
std::string percent(double value) {
  const double size = std::abs(100.0 * value);
  if (size < 0.0005) return "0";
  const int digits = size >= 9.95 ? 0 : size >= 0.995 ? 1 : size >= 0.0995 ? 2 : 3;
  return fmt::format("{:.{}f}", 100.0 * value, digits);
}

const Standing* find_standing(const std::vector<Standing>& standings, const std::string& model,
                              const Column& column) {
  for (const Standing& standing : standings)
    if (standing.model == model && standing.quantity == column.quantity) return &standing;
  return nullptr;
}

std::vector<Column> compared_columns(const std::vector<Standing>& standings) {
  std::vector<Column> found;
  for (const Column& column : columns)
    if (std::any_of(standings.begin(), standings.end(),
                    [&](const Standing& s) { return s.quantity == column.quantity; }))
      found.push_back(column);
  return found;
}

/// "halfspace", or "hertz, halfspace" if the requested reference has no forces.
std::string references_of(const std::vector<CaseStandings>& cases) {
  std::vector<std::string> names;
  for (const CaseStandings& one : cases)
    for (const Standing& standing : one.standings)
      if (std::find(names.begin(), names.end(), standing.reference) == names.end())
        names.push_back(standing.reference);
  return joined(names);
}

/// "fem (p0 0.83 %, -F_x/F_z 1.7 % of mu)": the largest differences beyond the error bars; only the
/// name if all are within them; empty if nothing of the model was compared.
std::string model_verdict(const std::vector<CaseStandings>& cases, const std::string& model,
                          bool& beyond) {
  std::vector<std::string> parts;
  bool compared = false;
  for (const Column& column : columns) {
    double worst = 0.0;
    bool differs = false;
    for (const CaseStandings& one : cases)
      for (const Standing& standing : one.standings) {
        if (standing.model != model || standing.quantity != column.quantity) continue;
        compared = true;
        if (standing.differ == 0) continue;
        differs = true;
        worst = std::max(worst, std::abs(standing.beyond.difference()));
      }
    if (differs) parts.push_back(fmt::format("{} {} {}", column.name, percent(worst), column.unit));
  }
  beyond = !parts.empty();
  if (!compared) return {};
  return beyond ? fmt::format("{} ({})", model, joined(parts)) : model;
}

}  // namespace

std::string comparison_table(const CaseStandings& one) {
  if (one.seconds.empty()) return {};
  const std::vector<Standing> standings = over_places(one.standings);
  const std::vector<Column> shown = compared_columns(standings);
  std::string names = fmt::format("  {:<18}", "");
  std::string units = names;
  for (const Column& column : shown) {
    names += fmt::format("{:>13}", column.name);
    units += fmt::format("{:>13}", column.unit);
  }
  std::string text = names + fmt::format("{:>10}\n", "seconds") + units + '\n';
  for (const auto& [model, seconds] : one.seconds) {
    text += fmt::format("  {:<18}", model);
    for (const Column& column : shown) {
      const Standing* standing = find_standing(standings, model, column);
      const std::string value = standing == nullptr ? "-" : percent(standing->worst.difference());
      const bool beyond = standing != nullptr && standing->differ > 0;
      text += fmt::format("{:>12}{}", value, beyond ? '*' : ' ');
    }
    text += fmt::format("{:>10.3g}\n", seconds);
  }
  return text;
}

std::string comparison_text(const ComparisonRecord& record) {
  std::string text;
  std::vector<CaseStandings> all;
  for (const ComparedCase& compared : record.cases) {
    all.push_back(case_standings(compared, record.references));
    text += fmt::format("{}: {}\n{}", compared.name, compared.title, comparison_table(all.back()));
    for (const MissingModel& missing : compared.missing)
      text += fmt::format("  {}: {}: {}\n", missing.model, missing.failed ? "failed" : "left out",
                          missing.reason);
    text += '\n';
  }
  const std::string verdict = comparison_verdict(all);
  if (verdict.empty()) return text;
  return text + "largest difference at any load point; *: some are beyond the error bars\n" +
         verdict + '\n';
}

std::string comparison_verdict(const std::vector<CaseStandings>& cases) {
  std::vector<std::string> models;
  for (const CaseStandings& one : cases)
    for (const auto& entry : one.seconds)
      if (std::find(models.begin(), models.end(), entry.first) == models.end())
        models.push_back(entry.first);
  std::vector<std::string> within;
  std::vector<std::string> outside;
  for (const std::string& model : models) {
    bool beyond = false;
    const std::string words = model_verdict(cases, model, beyond);
    if (!words.empty()) (beyond ? outside : within).push_back(words);
  }
  if (within.empty() && outside.empty()) return {};
  return fmt::format("Within the error bars of {}: {}. Beyond them: {}.", references_of(cases),
                     within.empty() ? "none" : joined(within),
                     outside.empty() ? "none" : joined(outside));
}

}  // namespace rollfem::postprocess
