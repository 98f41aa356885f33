// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/study/convergence.hpp"

#include <Eigen/Core>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace rollfem::postprocess {
namespace {

constexpr double safety = 1.25;       // Roache's factor for three levels
constexpr double safety_blind = 3.0;  // Eca and Hoekstra's factor without an order
constexpr double formal_order = 2.0;
constexpr double rounding = 1e-12;  // relative; smaller changes are rounding
constexpr std::size_t fewest_to_fit = 4;
constexpr double largest_fitted_order = formal_order + 0.5;
constexpr double spread_safety = 1.5;  // factor of the spread of a few extrapolated values
constexpr double most_scatter = 0.2;   // relative to the mean change between levels

struct Three {
  std::optional<double> order;
  std::string reason;
  double richardson = 0.0;
};

Three three_levels(double coarse, double middle, double fine, double ratio) {
  Three result;
  const double before = middle - coarse;
  const double now = fine - middle;
  const double noise = rounding * std::max(std::abs(fine), std::abs(coarse));
  if (std::abs(now) <= noise) {
    result.reason = "the last two values are the same";
  } else if (before * now <= 0.0) {
    result.reason = "the sequence is not monotone";
  } else if (std::abs(now) >= std::abs(before)) {
    result.reason = "its changes do not decrease";
  } else {
    const double order = std::log(before / now) / std::log(ratio);
    if (order < least_order)
      result.reason = fmt::format("its changes decrease too slowly (order {:.2f})", order);
    else if (order > largest_order)
      result.reason = fmt::format(
          "its changes decrease too fast for the method (order {:.1f}), which is coincidence",
          order);
    else
      result.order = order;
  }
  if (result.order) result.richardson = fine + now / (std::pow(ratio, *result.order) - 1.0);
  return result;
}

struct Fit {
  double order = 0.0;
  double limit = 0.0;
  double squares = std::numeric_limits<double>::infinity();  ///< weighted mean of squared residuals
  double last_residual = 0.0;
};

/// Least-squares fit of limit + C ratio^(-order k) for a given order; finer levels have weights
/// 1/h.
Fit fit_at(const std::vector<double>& values, double ratio, double order) {
  using Array = Eigen::ArrayXd;
  const auto n = static_cast<Eigen::Index>(values.size());
  const Array level = Array::LinSpaced(n, 0.0, static_cast<double>(n - 1));
  const Array f = Eigen::Map<const Array>(values.data(), n);
  const Array weight = Eigen::pow(ratio, level) / Eigen::pow(ratio, level).sum();
  const Array x = Eigen::pow(ratio, -order * level);
  const double mean_x = (weight * x).sum(), mean_f = (weight * f).sum();
  const double slope = (weight * (x - mean_x) * f).sum() / (weight * (x - mean_x) * x).sum();
  Fit fit{order, mean_f - slope * mean_x};
  const Array residual = f - fit.limit - slope * x;
  fit.squares = (weight * residual.square()).sum();
  fit.last_residual = residual[n - 1];
  return fit;
}

/// Sets order, value and uncertainties from all values if a curve with a plausible order fits them
/// with little scatter.
void fit_all(const std::vector<double>& values, double ratio, Limit& limit) {
  const std::size_t n = values.size();
  if (n < fewest_to_fit) return;
  Fit best;
  for (double order = least_order; order <= largest_fitted_order + 1e-9; order += 0.01)
    if (const Fit fit = fit_at(values, ratio, order); fit.squares < best.squares) best = fit;
  // At a border, the best order lies beyond the range.
  if (best.order < least_order + 0.005 || best.order > largest_fitted_order - 0.005) return;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const auto count = static_cast<double>(n);
  const double scatter = std::sqrt(count * best.squares / (count - 3.0));
  if (scatter > most_scatter * (*high - *low) / (count - 1.0)) return;
  limit.order = best.order;
  limit.fitted = true;
  limit.value = best.limit;
  limit.uncertainty = limit.grid_uncertainty =
      safety * std::abs(values.back() - best.limit) + scatter + std::abs(best.last_residual);
}

/// Largest change, at least of the last two values.
double largest_change(const std::vector<double>& values) {
  const std::size_t n = values.size();
  double change = std::abs(values[n - 1] - values[n - 2]);
  if (n > 2) change = std::max(change, std::abs(values[n - 2] - values[n - 3]));
  return change;
}

double blind_uncertainty(const std::vector<double>& values) {
  return safety_blind * largest_change(values);
}

double noise_of_rounding(const std::vector<double>& values) {
  return rounding * std::max(std::abs(values.back()), std::abs(values.front()));
}

/// Extrapolates from the last three values, which show an order.
void extrapolate(const std::vector<double>& values, double ratio, const Three& last, Limit& limit) {
  const std::size_t n = values.size();
  const double finest = values[n - 1];
  const double now = finest - values[n - 2];
  limit.value = last.richardson;
  // Convergence faster than the method's order is coincidence, and so is its extrapolation.
  if (*last.order > largest_fitted_order) {
    const double believed =
        std::max(std::abs(now), std::abs(values[n - 2] - values[n - 3]) / ratio);
    limit.uncertainty = limit.grid_uncertainty = safety * believed / (ratio - 1.0);
    return;
  }
  const auto to_limit = [&](double order) {
    return now / (std::pow(ratio, std::min(order, formal_order)) - 1.0);
  };
  limit.uncertainty = limit.grid_uncertainty = safety * std::abs(to_limit(*last.order));
  if (n == 3) return;
  const Three earlier = three_levels(values[n - 4], values[n - 3], values[n - 2], ratio);
  if (!earlier.order || *earlier.order > largest_fitted_order) return;
  double spread = 0.0;
  for (const double other :
       {earlier.richardson, finest + to_limit(*earlier.order), finest + to_limit(*last.order)})
    spread = std::max(spread, std::abs(other - limit.value));
  limit.uncertainty = std::max(spread_safety * spread, 0.25 * std::abs(limit.value - finest));
}

}  // namespace

Limit limit_of(const std::vector<double>& values, double ratio, double noise) {
  const std::size_t n = values.size();
  if (n < 2 || !(ratio > 1.0)) throw std::logic_error("a limit needs two levels and a ratio > 1");
  const double floor = std::max(noise, noise_of_rounding(values));
  Limit limit;
  limit.value = values[n - 1];
  limit.uncertainty = limit.grid_uncertainty = std::max(floor, blind_uncertainty(values));
  limit.settled = largest_change(values) <= floor;
  if (limit.settled) {
    limit.reason = "converged to rounding";
  } else if (n == 2) {
    limit.reason = "two levels cannot show an order";
  } else {
    const Three last = three_levels(values[n - 3], values[n - 2], values[n - 1], ratio);
    limit.order = last.order;
    limit.reason = last.reason;
    if (last.order)
      extrapolate(values, ratio, last, limit);
    else
      fit_all(values, ratio, limit);
    limit.uncertainty = std::max(limit.uncertainty, floor);
    limit.grid_uncertainty = std::max(limit.grid_uncertainty, floor);
  }
  return limit;
}

std::optional<double> order_of_errors(double coarse, double fine, double ratio) {
  if (coarse == 0.0 || fine == 0.0) return {};
  return std::log(std::abs(coarse / fine)) / std::log(ratio);
}

}  // namespace rollfem::postprocess
