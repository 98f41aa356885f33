// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/result/refinement.hpp"

#include "contact/result/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rollfem::contact {

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
  for (std::size_t k = 0; k < points.size(); ++k)
    for (const std::string& name : asked.of) {
      const auto estimate = points[k].error_estimate.find(name);
      if (estimate == points[k].error_estimate.end()) continue;
      const double whole = whole_of(quantity_named(name), points[k], friction_coefficient);
      if (whole == 0.0) continue;
      const double error = estimate->second / whole;
      if (error > worst.error) worst = {name, static_cast<int>(k) + 1, error};
    }
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
  result.notes.push_back(fmt::format("accuracy {:g} requested: {}; largest estimated error {}",
                                     *asked.relative, rung.cells, worst.text()));
  if (!reached) result.shortfall = shortfall_text(asked, worst, rung.no_finer);
  return false;
}

}  // namespace rollfem::contact
