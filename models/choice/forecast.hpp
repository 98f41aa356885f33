// SPDX-License-Identifier: LGPL-2.1-or-later
// Forecasts error and cost of models on successively finer grids and picks the cheapest that
// suffices. Pure functions of values, independent of any model.
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
  bool solved = false;  ///< error and time are measured, not expected
};

/// A model with the expected cost and error of its grids.
struct Forecast {
  std::string model;               ///< "halfspace"
  std::string label;               ///< "half-space", for sentences
  std::string cannot = {};         ///< why it cannot take the case; otherwise empty
  double model_error = 0.0;        ///< remains on any grid; relative like discretisation
  bool model_error_found = false;  ///< computed, not expected
  std::vector<Level> levels = {};  ///< coarsest first
  /// The model that this one corrects on the same grids; `uncertain_part` of that model's error
  /// remains. Empty: corrects none.
  std::string corrects = {};
  double uncertain_part = 0.0;
  double once = 0.0;  ///< s, spent only on the first grid

  /// Discretisation and model error together.
  double error(const Level& level) const { return level.discretisation + model_error; }
};

/// A grid of one of several forecasts.
struct Plan {
  std::size_t model = 0;
  std::size_t level = 0;
};

/// Assumed order of convergence: cells n times smaller reduce the error at least by n to this
/// power. Half-spaces show 1.5 to 1.9 (verification.LeadingEdge.*).
constexpr double assumed_order = 1.5;

/// The cheapest grid whose total error is at most `accuracy`; empty if there is none. `unsolved`:
/// considers only grids that were not solved yet.
std::optional<Plan> cheapest(const std::vector<Forecast>& forecasts, double accuracy,
                             bool unsolved = false);

/// Smallest expected error of any grid; infinity if no model can take the case.
double least_error(const std::vector<Forecast>& forecasts, bool unsolved = false);

/// Records that level `at` was solved: updates the expected errors of unsolved levels and removes
/// the one-time cost from them.
void learn(Forecast& forecast, std::size_t at, double discretisation, double seconds);

/// Records that level `at` of another model was solved. If `forecast` corrects that model, it
/// inherits the discretisation errors and a part of the model error; otherwise its grids are
/// assumed no better with the same number of elements.
void learn_from(Forecast& forecast, const Forecast& solved, std::size_t at);

}  // namespace rollfem::modelling
