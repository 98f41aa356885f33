// SPDX-License-Identifier: LGPL-2.1-or-later
// A study for the terminal: a table for each series, and one line on all of them.
#include "contact/result/quantities.hpp"
#include "postprocess/study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace rollfem::postprocess {
namespace {

using References = std::map<std::string, StudyReference>;

std::string name_of(const StudyPlace& place, const std::string& key) {
  if (const contact::Quantity* quantity = contact::find_quantity(key)) return quantity->title;
  const std::size_t colon = key.find(':');
  const auto point = static_cast<std::size_t>(std::atoi(key.c_str() + colon + 1));
  if (!is_coefficient(key))
    return fmt::format("{} found at load point {}",
                       contact::quantity_named(key.substr(0, colon)).title, point);
  const double xi =
      point - 1 < place.creepages.size() ? place.creepages[point - 1].longitudinal : 0.0;
  return fmt::format("traction coefficient at xi = {:.4g} %", 100.0 * xi);
}

std::string unit_of(const std::string& key) {
  const contact::Quantity* quantity = contact::find_quantity(key);
  return quantity == nullptr ? "" : fmt::format(" {}", quantity->unit);
}

/// "0.27 %" of the reference's value, "0.27 % of mu".
std::string percent(const std::string& key, double error) {
  return contact::percent_text(
      is_coefficient(key) ? contact::ErrorScale::friction : contact::ErrorScale::value, error);
}

/// Value of the finest level with the key; null if there is none.
const double* finest_value(const StudySeries& series, const std::string& key) {
  const double* last = nullptr;
  for (const StudyLevel& level : series.levels)
    if (const auto found = level.values.find(key); found != level.values.end())
      last = &found->second;
  return last;
}

/// "0.57 % of mu +- 0.02": a difference of its model.
std::string difference_text(const std::string& key, const ModelDifference& difference) {
  return fmt::format("{}{} +- {:.2g}", difference.value < 0.0 ? "-" : "+",
                     percent(key, std::abs(difference.value)), 100.0 * difference.uncertainty);
}

std::string key_table(const StudyRecord& record, const StudyPlace& place, const StudySeries& series,
                      const std::string& key, const StudyReference& reference) {
  std::string text = fmt::format("  {}, reference {:.7g}{} ({})\n", name_of(place, key),
                                 reference.value, unit_of(key), reference.kind);
  // Labels of quantities refined together are long.
  std::size_t width = series.parameter.size();
  for (const StudyLevel& level : series.levels) width = std::max(width, level.label.size());
  text += fmt::format("    {:<{}}{:>10}{:>10}{:>14}{:>12}{:>16}{:>8}\n", series.parameter, width,
                      "unknowns", "seconds", "value", "bar", "error", "order");
  const auto orders = level_orders(record, series, key, reference);
  const double* finest = finest_value(series, key);
  std::size_t k = 0;
  for (const StudyLevel& level : series.levels) {
    const auto value = level.values.find(key);
    if (value == level.values.end()) continue;
    const bool own = &value->second == finest && reference.kind == "finest";
    const auto order = orders.at(k++), bar = bar_of(level, key);
    text += fmt::format(
        "    {:<{}}{:>10}{:>10.3g}{:>14.7g}{:>12}{:>16}{:>8}\n", level.label, width, level.unknowns,
        level.seconds, value->second, bar ? fmt::format("+- {:.2g}", *bar) : "",
        own ? "reference" : percent(key, study_error(record, key, value->second, reference)),
        order ? fmt::format("{:.2f}", *order) : "");
  }
  const auto limit = series_limit(series, key);
  if (limit && limit->fitted)
    text += fmt::format(
        "    limit {:.7g} +- {:.2g}, order {:.2f} fitted to all levels (of the last three {})\n",
        limit->value, limit->uncertainty, *limit->order, limit->reason);
  else if (limit && limit->order)
    text +=
        fmt::format("    limit {:.7g} +- {:.2g}, order {:.2f} from the last three levels{}\n",
                    limit->value, limit->uncertainty, *limit->order,
                    *limit->order > 2.5 ? " (partly coincidence: the method is of order 2)" : "");
  else if (limit && limit->settled)
    text +=
        fmt::format("    converged to rounding: finest value +- {:.2g}\n", limit->grid_uncertainty);
  else if (limit)
    text += fmt::format("    finest value +- {:.2g}; no order can be claimed: {}\n",
                        limit->grid_uncertainty, limit->reason);
  return text;
}

std::string series_name(const StudySeries& series) {
  return series.model + (series.vary.empty() ? "" : fmt::format(" ({})", series.vary));
}

/// The largest errors of finest levels; 0 if there are none.
struct Errors {
  double pressure = 0.0;
  double coefficient = 0.0;
  double creepage = 0.0;  ///< found for forces
  void add(const std::string& key, double error) {
    if (key == "max_pressure") pressure = std::max(pressure, std::abs(error));
    if (is_coefficient(key)) coefficient = std::max(coefficient, std::abs(error));
    if (key.find("_creepage:") != std::string::npos) creepage = std::max(creepage, std::abs(error));
  }
};

struct Orders {
  int sequences = 0;
  int shown = 0;   ///< orders from the last three levels
  int fitted = 0;  ///< to all levels
};

void gather(const StudyRecord& record, const StudySeries& series, const References& refs,
            Errors& errors, Orders& orders) {
  for (const auto& [key, reference] : refs) {
    const double* finest = finest_value(series, key);
    if (finest == nullptr) continue;
    if (const auto limit = series_limit(series, key)) {
      ++orders.sequences;
      if (limit->order) ++(limit->fitted ? orders.fitted : orders.shown);
    }
    if (reference.kind != "finest") errors.add(key, study_error(record, key, *finest, reference));
  }
}

constexpr double smallest = 1e-9;  // smaller errors are rounding

/// "p0 0.27 %, -F_x/F_z 0.5 % of mu".
std::string words_of(const Errors& errors) {
  std::string text;
  if (errors.pressure > smallest) text = "p0 " + percent("max_pressure", errors.pressure);
  if (errors.coefficient > smallest)
    text += fmt::format("{}-F_x/F_z {}", text.empty() ? "" : ", ",
                        percent("traction_coefficient", errors.coefficient));
  if (errors.creepage > smallest)
    text += fmt::format("{}creepage {}", text.empty() ? "" : ", ",
                        percent("longitudinal_creepage", errors.creepage));
  return text;
}

}  // namespace

std::string study_verdict(const StudyRecord& record) {
  std::vector<std::string> names;  // of the series, in their order
  std::map<std::string, Errors> errors, differences;
  std::string base;
  Orders orders;
  for (const StudyPlace& place : record.places) {
    if (base.empty()) base = place.series.at(reference_series(place)).model;
    for (const StudySeries& series : place.series) {
      const std::string name = series_name(series);
      if (errors.count(name) == 0) names.push_back(name);
      gather(record, series, references(place, series, record.rule), errors[name], orders);
      for (const auto& [key, difference] : model_differences(record, place, series))
        differences[name].add(key, difference.value);
    }
  }
  const auto listed = [&](const std::string& beginning, std::map<std::string, Errors>& of) {
    std::string text;
    for (const std::string& name : names)
      if (const std::string words = words_of(of[name]); !words.empty())
        text += (text.empty() ? beginning : "; ") + name + " " + words;
    return text.empty() ? text : text + ". ";
  };
  return listed("Finest levels against their references: ", errors) +
         listed("Model differences from " + base + ": ", differences) +
         fmt::format("Of {} sequences of levels {} show an order{}.", orders.sequences,
                     orders.shown,
                     orders.fitted > 0 ? fmt::format(" and {} a fitted one", orders.fitted)
                                       : std::string());
}

std::string study_table(const StudyRecord& record) {
  std::string text;
  for (const StudyPlace& place : record.places) {
    const std::string name = place_name(place);
    const std::string& base = place.series.at(reference_series(place)).model;
    for (const StudySeries& series : place.series) {
      const auto differences = model_differences(record, place, series);
      text += fmt::format("{}{}{}{}{}\n", name, name.empty() ? "" : ": ", series.model,
                          series.vary.empty() ? "" : ", refined in ", series.vary);
      if (!series.left_out.empty()) text += "  too coarse: " + series.left_out + "\n";
      if (!series.failure.empty()) text += "  levels without a result: " + series.failure + "\n";
      for (const auto& [key, reference] : references(place, series, record.rule)) {
        text += key_table(record, place, series, key, reference);
        if (const auto found = differences.find(key); found != differences.end())
          text += fmt::format("    model difference from {}: {}\n", base,
                              difference_text(key, found->second));
      }
    }
  }
  return text + '\n' + study_verdict(record) + '\n';
}

}  // namespace rollfem::postprocess
