// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/choice/reached.hpp"

#include "contact/result/bars.hpp"
#include "contact/result/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollfem::modelling {

namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

/// The error bar; 0 for quantities that need none.
double bar_of(const contact::PointResult& point, const std::string& name) {
  const auto bar = point.error_estimate.find(name);
  if (bar != point.error_estimate.end()) return bar->second;
  const auto word = point.no_bar.find(name);
  if (word == point.no_bar.end()) return unknown;
  for (const char* sound : {contact::no_bar::exact, contact::no_bar::given,
                            contact::no_bar::counted, contact::no_bar::measured})
    if (word->second == sound) return 0.0;
  return unknown;
}

double model_error_of(const contact::PointResult& point, const std::string& name, bool known) {
  const auto error = point.model_error.find(name);
  if (error != point.model_error.end()) return error->second;
  return known ? 0.0 : unknown;
}

}  // namespace

std::string percent(double part) {
  if (!std::isfinite(part)) return "unknown";
  return fmt::format("{:.2g} %", 100.0 * part);
}

std::string Reached::text(const std::string& why_unknown) const {
  if (quantity.empty()) return "no error";
  const contact::ErrorScale scale = contact::quantity_named(quantity).scale;
  const bool of_value = scale == contact::ErrorScale::value;
  const std::string of = fmt::format("{}{} ({} at load point {})", of_value ? "" : " of ",
                                     of_value ? "" : contact::text_of(scale), quantity, point);
  const std::string grid = "discretisation " + percent(discretisation);
  if (!why_unknown.empty()) return fmt::format("{}{}, model unknown: {}", grid, of, why_unknown);
  return fmt::format("{}, model {}{}{}", grid, model_at_most ? "at most " : "", percent(model), of);
}

Reached reached_by(const contact::ModelResult& result, const contact::AccuracyRequest& asked,
                   double friction_coefficient, bool model_error_known) {
  Reached worst;
  for (std::size_t k = 0; k < result.points.size(); ++k)
    for (const std::string& name : asked.of) {
      const contact::PointResult& point = result.points[k];
      const contact::Quantity& quantity = contact::quantity_named(name);
      const double whole = contact::whole_of(quantity, point, friction_coefficient);
      if (whole == 0.0 || !quantity.value(point)) continue;
      const double discretisation = bar_of(point, name) / whole;
      const double model = model_error_of(point, name, model_error_known) / whole;
      worst.most_discretisation = std::max(worst.most_discretisation, discretisation);
      worst.most_model = std::max(worst.most_model, model);
      if (!worst.quantity.empty() && discretisation + model <= worst.together()) continue;
      worst.discretisation = discretisation;
      worst.model = model;
      worst.quantity = name;
      worst.point = static_cast<int>(k) + 1;
    }
  return worst;
}

}  // namespace rollfem::modelling
