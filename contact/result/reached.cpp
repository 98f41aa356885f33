// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/result/reached.hpp"

#include "contact/result/bars.hpp"
#include "contact/result/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace rollfem::contact {

namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

/// The error bar; 0 for quantities that need none.
double bar_of(const PointResult& point, const std::string& name) {
  const auto bar = point.error_estimate.find(name);
  if (bar != point.error_estimate.end()) return bar->second;
  const auto word = point.no_bar.find(name);
  if (word == point.no_bar.end()) return unknown;
  for (const char* sound : {no_bar::exact, no_bar::given, no_bar::counted, no_bar::measured})
    if (word->second == sound) return 0.0;
  return unknown;
}

double model_error_of(const PointResult& point, const std::string& name, bool known) {
  const auto error = point.model_error.find(name);
  if (error != point.model_error.end()) return error->second;
  return known ? 0.0 : unknown;
}

/// Errors of a requested quantity at a load point, as parts of its whole.
struct Error {
  const Quantity* quantity = nullptr;
  int point = 0;  ///< counted from 1
  double discretisation = 0.0, model = 0.0;
  double together() const { return discretisation + model; }
};

template <class Visit>
void each_error(const ModelResult& result, const AccuracyRequest& asked,
                double friction_coefficient, bool model_error_known, const Visit& visit) {
  for (std::size_t k = 0; k < result.points.size(); ++k)
    for (const std::string& name : asked.of) {
      const PointResult& point = result.points[k];
      const Quantity& quantity = quantity_named(name);
      const double whole = whole_of(quantity, point, friction_coefficient);
      if (whole == 0.0 || !quantity.value(point)) continue;
      visit(Error{&quantity, static_cast<int>(k) + 1, bar_of(point, name) / whole,
                  model_error_of(point, name, model_error_known) / whole});
    }
}

/// The estimate of its model error has failed.
bool without_model_error(const ModelResult& result) {
  return result.model_error_source.rfind("not estimated: no result", 0) == 0;
}

}  // namespace

std::string percent(double part) {
  if (!std::isfinite(part)) return "unknown";
  return fmt::format("{:.2g} %", 100.0 * part);
}

std::string Reached::text(const std::string& why_unknown) const {
  if (quantity.empty()) return "no error";
  const ErrorScale scale = quantity_named(quantity).scale;
  const bool of_value = scale == ErrorScale::value;
  const std::string of = fmt::format("{}{} ({} at load point {})", of_value ? "" : " of ",
                                     of_value ? "" : text_of(scale), quantity, point);
  const std::string grid = "discretisation " + percent(discretisation);
  if (!why_unknown.empty()) return fmt::format("{}{}, model unknown: {}", grid, of, why_unknown);
  return fmt::format("{}, model {}{}", grid, percent(model), of);
}

Reached reached_by(const ModelResult& result, const AccuracyRequest& asked,
                   double friction_coefficient, bool model_error_known) {
  Reached worst;
  each_error(result, asked, friction_coefficient, model_error_known, [&](const Error& error) {
    worst.most_discretisation = std::max(worst.most_discretisation, error.discretisation);
    worst.most_model = std::max(worst.most_model, error.model);
    if (!worst.quantity.empty() && error.together() <= worst.together()) return;
    worst.discretisation = error.discretisation;
    worst.model = error.model;
    worst.quantity = error.quantity->name;
    worst.point = error.point;
  });
  return worst;
}

std::string missed_text(const std::vector<ModelResult>& results, const AccuracyRequest& asked,
                        double friction_coefficient) {
  const double accuracy = asked.relative.value_or(default_accuracy);
  std::size_t missed = 0;
  std::map<ErrorScale, std::pair<double, const Quantity*>> worst;
  for (const ModelResult& result : results) {
    const bool chosen = !result.choice.empty();
    if (!chosen && result.shortfall.empty()) continue;
    bool misses = false;
    each_error(result, asked, friction_coefficient, !without_model_error(result),
               [&](const Error& error) {
                 const double part = chosen ? error.together() : error.discretisation;
                 if (part <= accuracy) return;
                 misses = true;
                 auto& [most, quantity] = worst[error.quantity->scale];
                 if (part > most) std::tie(most, quantity) = std::pair{part, error.quantity};
               });
    missed += misses ? 1 : 0;
  }
  if (missed == 0) return {};
  std::string text = results.size() == 1 ? "The result misses "
                     : missed == 1       ? fmt::format("1 of {} contacts misses ", results.size())
                                   : fmt::format("{} of {} contacts miss ", missed, results.size());
  text += percent(accuracy);
  for (const auto& [scale, most] : worst)
    text += fmt::format("{} {} ({})", &most == &worst.begin()->second ? ": worst" : ",",
                        std::isfinite(most.first) ? percent_text(scale, most.first) : "unknown",
                        *most.second->symbol != 0 ? most.second->symbol : most.second->title);
  return text + ".";
}

}  // namespace rollfem::contact
