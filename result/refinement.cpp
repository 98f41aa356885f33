// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/refinement.hpp"

#include "result/bars.hpp"
#include "result/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace rollfem::contact {

namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

/// The error bar; 0 for quantities that need none.
double bar_of(const PointResult& point, const std::string& name) {
  if (const auto bar = point.bar_of(name)) return *bar;
  const auto word = point.no_bar.find(name);
  if (word == point.no_bar.end()) return unknown;
  for (const NoBar sound : {NoBar::exact, NoBar::given, NoBar::counted, NoBar::measured})
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
void each_error(const std::vector<PointResult>& points, const AccuracyRequest& asked,
                double friction_coefficient, bool model_error_known, const Visit& visit) {
  for (std::size_t k = 0; k < points.size(); ++k)
    for (const std::string& name : asked.of) {
      const PointResult& point = points[k];
      const Quantity& quantity = quantity_named(name);
      const double whole = whole_of(quantity, point, friction_coefficient);
      if (whole == 0.0 || !quantity.value(point)) continue;
      visit(Error{&quantity, static_cast<int>(k) + 1, bar_of(point, name) / whole,
                  model_error_of(point, name, model_error_known) / whole});
    }
}

/// The estimate of its model error has failed.
bool without_model_error(const ModelResult& result) {
  const Note* note = result.note_about(about_model_error);
  return note != nullptr && note->severity == Note::warning;
}

}  // namespace

double estimated_error(const std::vector<double>& values, double assumed_order,
                       double least_order) {
  constexpr double best_order = 2.0;
  constexpr double believed_fall = 16.0;  // of an error that changes its sign
  const std::size_t n = values.size();
  if (n < 2) throw std::logic_error("an error estimate needs two levels");
  const double now = values[n - 1] - values[n - 2];
  if (n == 2) return std::abs(now) / (std::exp2(assumed_order) - 1.0);
  const double before = values[n - 2] - values[n - 3];
  if (before * now > 0.0) {
    const double order = std::clamp(std::log2(before / now), least_order, best_order);
    return std::max(std::abs(now), std::abs(before) / std::exp2(best_order)) /
           (std::exp2(order) - 1.0);
  }
  return std::max(std::abs(now), std::abs(before) / believed_fall) /
         (std::exp2(assumed_order) - 1.0);
}

WorstError worst_error(const AccuracyRequest& asked, double friction_coefficient,
                       const std::vector<PointResult>& points) {
  WorstError worst;
  each_error(points, asked, friction_coefficient, true, [&](const Error& error) {
    const double part = error.discretisation;
    if (std::isfinite(part) && part > worst.error)
      worst = {error.quantity->name, error.point, part};
  });
  return worst;
}

std::string WorstError::text() const {
  if (quantity.empty()) return "0";
  return fmt::format("{} ({} at load point {})",
                     percent_text(quantity_named(quantity).scale, error), quantity, point);
}

std::string shortfall_text(const AccuracyRequest& asked, const WorstError& worst,
                           const std::string& reason) {
  return fmt::format("accuracy = {:g} was not reached: the largest estimated error is {}; {}",
                     *asked.relative, worst.text(), reason);
}

bool refine_further(const AccuracyRequest& asked, double friction_coefficient, const Rung& rung,
                    const std::vector<PointResult>& points, ModelResult& result) {
  if (!asked.relative) return false;
  const WorstError worst = worst_error(asked, friction_coefficient, points);
  const bool reached = rung.enough_levels && worst.error <= *asked.relative;
  if (!reached && rung.no_finer.empty()) return true;
  add_note(result.notes, "accuracy", "accuracy {:g} requested: {}; largest estimated error {}",
           *asked.relative, rung.cells, worst.text());
  if (!reached) result.shortfall = shortfall_text(asked, worst, rung.no_finer);
  return false;
}

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
  each_error(
      result.points, asked, friction_coefficient, model_error_known, [&](const Error& error) {
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
    each_error(result.points, asked, friction_coefficient, !without_model_error(result),
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
