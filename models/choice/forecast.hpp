// SPDX-License-Identifier: LGPL-2.1-or-later
// Forecasts error and cost of models on successively finer grids and picks the cheapest that
// suffices. Pure functions of values; no model is known here.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::modelling {

/// One grid of a model.
struct Level {
  int across = 0;               ///< elements across the smaller extent of the patch
  double discretisation = 0.0;  ///< error, as part of the whole of the worst quantity
  double seconds = 0.0;
  bool solved = false;  ///< both were found, not expected
};

/// A model with what its grids are expected to cost and to miss.
struct Forecast {
  std::string model;               ///< "halfspace"
  std::string label;               ///< "half-space", as sentences have it
  std::string cannot = {};         ///< why it is out of the question; empty: it is not
  double model_error = 0.0;        ///< what no grid takes away, a part like discretisation
  bool model_error_found = false;  ///< and not expected
  std::vector<Level> levels = {};  ///< coarsest first
  /// The model that this one corrects, on the same grids; `uncertain_part` of that model's error is
  /// left. Empty: none.
  std::string corrects = {};
  double uncertain_part = 0.0;
  double once = 0.0;  ///< s of the first grid that the others need not spend again

  /// Of both errors.
  double error(const Level& level) const { return level.discretisation + model_error; }
};

/// A grid of one of several forecasts.
struct Plan {
  std::size_t model = 0;
  std::size_t level = 0;
};

/// With cells of 1/n errors fall at least by n to this power; what a half-space shows is 1.5 to 1.9
/// (verification.LeadingEdge.*).
constexpr double assumed_order = 1.5;

/// The cheapest grid whose errors together are no more than `accuracy`; none where there is none.
/// `unsolved`: of those alone that were not solved.
std::optional<Plan> cheapest(const std::vector<Forecast>& forecasts, double accuracy,
                             bool unsolved = false);

/// The least error that any grid is expected to have; infinity where no model is in question.
double least_error(const std::vector<Forecast>& forecasts, bool unsolved = false);

/// Level `at` was solved: the errors of those that were not follow from it, and they need not spend
/// what is spent once.
void learn(Forecast& forecast, std::size_t at, double discretisation, double seconds);

/// Level `at` of another model was solved: the one that `forecast` corrects has its grids and a
/// part of its model error; of any other the grids are no better on as many elements.
void learn_from(Forecast& forecast, const Forecast& solved, std::size_t at);

}  // namespace rollfem::modelling
