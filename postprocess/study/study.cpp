// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/study/study.hpp"

#include "contact/result/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <stdexcept>

namespace rollfem::postprocess {
namespace {

std::vector<double> values_of(const StudySeries& series, const std::string& key) {
  std::vector<double> values;
  for (const StudyLevel& level : series.levels)
    if (const auto found = level.values.find(key); found != level.values.end())
      values.push_back(found->second);
  return values;
}

/// Own limit; of a single level its value.
StudyReference own_limit(const StudySeries& series, const std::string& key, bool finest) {
  const auto limit = series_limit(series, key);
  if (limit && limit->order && !finest) return {limit->value, limit->uncertainty, "extrapolated"};
  return {values_of(series, key).back(), limit ? limit->grid_uncertainty : 0.0, "finest"};
}

std::set<std::string> keys_of(const StudySeries& series) {
  std::set<std::string> keys;
  for (const StudyLevel& level : series.levels)
    for (const auto& entry : level.values) keys.insert(entry.first);
  return keys;
}

}  // namespace

bool is_coefficient(const std::string& key) {
  return key.rfind("traction_coefficient", 0) == 0;
}

const char* percent_of(const std::string& key) {
  return contact::text_of(is_coefficient(key) ? contact::ErrorScale::friction
                                              : contact::ErrorScale::value);
}

std::string place_name(const StudyPlace& place) {
  return place.place ? place.place->label(" wheel") : "";
}

std::string place_key(const StudyPlace& place) {
  return place.place ? place.place->key() : "";
}

std::size_t reference_series(const StudyPlace& place) {
  if (place.series.empty()) throw std::logic_error("a study without series");
  std::size_t best = 0;
  int best_rank = -1;
  for (std::size_t k = 0; k < place.series.size(); ++k) {
    const StudySeries& series = place.series[k];
    if (series.levels.empty()) continue;
    int rank = series.levels.size() >= 3 ? 1 : 0;
    if (series.measures_others && rank == 1) rank = 2;
    if (rank > best_rank) {
      best = k;
      best_rank = rank;
    }
  }
  return best;
}

std::map<std::string, StudyReference> references(const StudyPlace& place, const StudySeries& series,
                                                 ReferenceRule rule) {
  std::map<std::string, StudyReference> all;
  const bool take_exact = rule == ReferenceRule::exact ||
                          (rule == ReferenceRule::automatic && !series.limit_of_its_own);
  for (const std::string& key : keys_of(series)) {
    if (const auto given = place.given.find(key); given != place.given.end())
      all[key] = {given->second, 0.0, "given"};
    else if (const auto exact = place.exact.find(key); take_exact && exact != place.exact.end())
      all[key] = {exact->second, 0.0, "exact"};
    else if (rule != ReferenceRule::exact)
      all[key] = own_limit(series, key, rule == ReferenceRule::finest);
  }
  return all;
}

std::map<std::string, ModelDifference> model_differences(const StudyRecord& record,
                                                         const StudyPlace& place,
                                                         const StudySeries& series) {
  std::map<std::string, ModelDifference> all;
  const StudySeries& base = place.series.at(reference_series(place));
  if (series.model == base.model) return all;
  const auto of_base = references(place, base, record.rule);
  for (const std::string& key : keys_of(series)) {
    const auto found = of_base.find(key);
    // Without creepage half-spaces have no force, and so no entry.
    const bool none =
        is_coefficient(key) && std::any_of(of_base.begin(), of_base.end(),
                                           [](auto& one) { return is_coefficient(one.first); });
    if (found == of_base.end() && !none) continue;
    const StudyReference from = found == of_base.end() ? StudyReference{} : found->second;
    const StudyReference own = own_limit(series, key, record.rule == ReferenceRule::finest);
    const double scale = is_coefficient(key) ? record.friction : std::abs(from.value);
    if (scale > 0.0)
      all[key] = {(own.value - from.value) / scale, (own.uncertainty + from.uncertainty) / scale};
  }
  return all;
}

double study_error(const StudyRecord& record, const std::string& key, double value,
                   const StudyReference& reference) {
  const double scale = is_coefficient(key) ? record.friction : std::abs(reference.value);
  return scale > 0.0 ? std::abs(value - reference.value) / scale : std::abs(value);
}

std::optional<double> bar_of(const StudyLevel& level, const std::string& key) {
  const auto bar = level.bars.find(key);
  return bar == level.bars.end() ? std::nullopt : std::optional<double>(bar->second);
}

std::optional<Limit> series_limit(const StudySeries& series, const std::string& key) {
  const std::vector<double> values = values_of(series, key);
  if (values.size() < 2 || !(series.ratio > 1.0)) return {};
  const StudyLevel& finest = series.levels.back();
  return limit_of(values, series.ratio, finest.noise * std::abs(values.back()));
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

}  // namespace rollfem::postprocess
