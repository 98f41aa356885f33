#include "postprocess/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <stdexcept>

namespace rollfem::postprocess {
namespace {

bool is_coefficient(const std::string& key) {
  return key.rfind("traction_coefficient", 0) == 0;
}

std::string name_of(const StudyRecord& record, const std::string& key) {
  if (key == "max_pressure") return "largest pressure";
  if (key == "semi_axis_x") return "semi-axis along x";
  if (key == "semi_axis_y") return "semi-axis along y";
  if (!is_coefficient(key)) return key;
  const auto point = static_cast<std::size_t>(std::atoi(key.c_str() + key.find(':') + 1));
  const double xi =
      point - 1 < record.creepages.size() ? record.creepages[point - 1].longitudinal : 0.0;
  return fmt::format("traction coefficient at xi = {:.4g} %", 100.0 * xi);
}

std::vector<double> values_of(const StudySeries& series, const std::string& key) {
  std::vector<double> values;
  for (const StudyLevel& level : series.levels)
    if (const auto found = level.values.find(key); found != level.values.end())
      values.push_back(found->second);
  return values;
}

std::string percent(double error) {
  return fmt::format("{:.2g} %", 100.0 * error);
}

}  // namespace

std::size_t reference_series(const StudyRecord& record) {
  if (record.series.empty()) throw std::logic_error("a study without series");
  std::size_t best = 0;
  int best_rank = -1;
  for (std::size_t k = 0; k < record.series.size(); ++k) {
    const StudySeries& series = record.series[k];
    int rank = series.levels.size() >= 3 ? 1 : 0;
    if (series.model == "halfspace" && rank == 1) rank = 2;
    if (rank > best_rank) {
      best = k;
      best_rank = rank;
    }
  }
  return best;
}

std::map<std::string, StudyReference> references(const StudyRecord& record) {
  std::map<std::string, StudyReference> all;
  const StudySeries& base = record.series.at(reference_series(record));
  // Finite bodies have a limit of their own.
  const bool take_exact = record.rule == ReferenceRule::exact ||
                          (record.rule == ReferenceRule::automatic && base.model != "fem");
  std::set<std::string> keys;
  for (const StudySeries& series : record.series)
    for (const StudyLevel& level : series.levels)
      for (const auto& entry : level.values) keys.insert(entry.first);
  for (const std::string& key : keys) {
    if (const auto given = record.given.find(key); given != record.given.end()) {
      all[key] = {given->second, 0.0, "given"};
      continue;
    }
    if (const auto exact = record.exact.find(key); take_exact && exact != record.exact.end()) {
      all[key] = {exact->second, 0.0, "exact"};
      continue;
    }
    if (record.rule == ReferenceRule::exact) continue;
    const std::vector<double> values = values_of(base, key);
    if (values.empty()) continue;
    const auto limit = series_limit(base, key);
    if (limit && limit->order && record.rule != ReferenceRule::finest)
      all[key] = {limit->value, limit->uncertainty, "extrapolated"};
    else
      all[key] = {values.back(), limit ? limit->grid_uncertainty : 0.0, "finest"};
  }
  return all;
}

double study_error(const StudyRecord& record, const std::string& key, double value,
                   const StudyReference& reference) {
  const double scale = is_coefficient(key) ? record.friction : std::abs(reference.value);
  return scale > 0.0 ? std::abs(value - reference.value) / scale : std::abs(value);
}

std::optional<Limit> series_limit(const StudySeries& series, const std::string& key) {
  const std::vector<double> values = values_of(series, key);
  if (values.size() < 2 || !(series.ratio > 1.0)) return {};
  return limit_of(values, series.ratio);
}

std::vector<std::optional<double>> level_orders(const StudyRecord& record,
                                                const StudySeries& series, const std::string& key,
                                                const StudyReference& reference) {
  const std::vector<double> values = values_of(series, key);
  std::vector<std::optional<double>> orders(values.size());
  if (!(series.ratio > 1.0)) return orders;
  const bool known = reference.kind == "exact" || reference.kind == "given";
  for (std::size_t k = 1; k < values.size(); ++k)
    if (known)
      orders[k] = order_of_errors(study_error(record, key, values[k - 1], reference),
                                  study_error(record, key, values[k], reference), series.ratio);
    else if (k >= 2)
      orders[k] = limit_of({values[k - 2], values[k - 1], values[k]}, series.ratio).order;
  return orders;
}

std::vector<std::string> study_words(const StudyRecord& record) {
  std::vector<std::string> sentences;
  const auto refs = references(record);
  for (const StudySeries& series : record.series) {
    if (series.levels.empty()) continue;
    for (const auto& [key, reference] : refs) {
      const auto values = values_of(series, key);
      if (values.empty()) continue;
      const auto limit = series_limit(series, key);
      std::string text =
          fmt::format("{}{}{}: the {} is ", series.model, series.vary.empty() ? "" : ", ",
                      series.vary, name_of(record, key));
      if (limit && limit->order)
        text += fmt::format(
            "{:.6g} on the finest level and {:.6g} +- {:.2g} extrapolated, with "
            "order {:.2f}",
            values.back(), limit->value, limit->uncertainty, *limit->order);
      else if (limit)
        text += fmt::format("{:.6g} +- {:.2g} on the finest level; no order can be claimed: {}",
                            values.back(), limit->grid_uncertainty, limit->reason);
      else
        text += fmt::format("{:.6g}", values.back());
      const double error = study_error(record, key, values.back(), reference);
      text += fmt::format("; {}{} off the reference {:.6g} ({})", percent(error),
                          is_coefficient(key) ? " of mu" : "", reference.value, reference.kind);
      sentences.push_back(text + ".");
    }
    if (!series.failure.empty())
      sentences.push_back(fmt::format("{}, {}: ended after {} levels: {}", series.model,
                                      series.vary, series.levels.size(), series.failure));
  }
  return sentences;
}

std::string study_table(const StudyRecord& record) {
  const auto refs = references(record);
  std::string text;
  for (const StudySeries& series : record.series) {
    text += fmt::format("{}{}{}\n", series.model, series.vary.empty() ? "" : ", refined in ",
                        series.vary);
    if (!series.failure.empty()) text += "  ended early: " + series.failure + "\n";
    for (const auto& [key, reference] : refs) {
      if (values_of(series, key).empty()) continue;
      text += fmt::format("  {}, reference {:.7g} ({})\n", name_of(record, key), reference.value,
                          reference.kind);
      text += fmt::format("    {:<18}{:>10}{:>10}{:>14}{:>12}{:>8}\n", series.parameter, "unknowns",
                          "seconds", "value", "error", "order");
      const auto orders = level_orders(record, series, key, reference);
      std::size_t k = 0;
      for (const StudyLevel& level : series.levels) {
        const auto value = level.values.find(key);
        if (value == level.values.end()) continue;
        const double error = study_error(record, key, value->second, reference);
        const auto order = orders.at(k++);
        text += fmt::format("    {:<18}{:>10}{:>10.3g}{:>14.7g}{:>12}{:>8}\n", level.label,
                            level.unknowns, level.seconds, value->second, percent(error),
                            order ? fmt::format("{:.2f}", *order) : "");
      }
      if (const auto limit = series_limit(series, key); limit && limit->order)
        text +=
            fmt::format("    limit {:.7g} +- {:.2g}, order {:.2f} from the last three levels{}\n",
                        limit->value, limit->uncertainty, *limit->order,
                        *limit->order > 2.5 ? " (partly chance: the method has 2)" : "");
      else if (limit)
        text += fmt::format("    no order can be claimed: {}\n", limit->reason);
    }
  }
  return text;
}

}  // namespace rollfem::postprocess
