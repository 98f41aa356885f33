// SPDX-License-Identifier: LGPL-2.1-or-later
// Forecasts error and cost of models on successively finer grids and picks, for all contacts of a
// run, the cheapest model that suffices. Pure functions of values, independent of any model.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::modelling {

/// One grid of a model.
struct Level {
  int across = 0;               ///< elements across the smaller extent of the patch
  double discretisation = 0.0;  ///< error, as part of the whole of the worst quantity
  double seconds = 0.0;
  bool solved = false;  ///< discretisation and time are measured, not expected
  /// Total error of a solution that the run has; its grid costs nothing more.
  std::optional<double> reached = {};
  double cost() const { return reached ? 0.0 : seconds; }
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
  double once = 0.0;                   ///< s, spent only on the first grid
  bool on_one_thread = false;          ///< contacts may be solved side by side
  bool estimates_model_error = false;  ///< in its results; one that is missing is then unknown
  std::string no_model_error = {};     ///< why its model error cannot be known; otherwise empty

  /// Discretisation and model error together.
  double error(const Level& level) const {
    return level.reached.value_or(level.discretisation + model_error);
  }
};

/// [contact][model], with the same models for every contact.
using Contacts = std::vector<std::vector<Forecast>>;

/// Number of models.
inline std::size_t models_of(const Contacts& contacts) {
  return contacts.empty() ? 0 : contacts.front().size();
}

/// One model with one grid for each contact.
struct Plan {
  std::size_t model = 0;
  std::vector<std::size_t> levels;
  double error = 0.0;        ///< largest of a contact
  double seconds = 0.0;      ///< expected, of the grids that are not solved yet
  std::size_t unsolved = 0;  ///< number of these
};

/// Assumed order of convergence: cells n times smaller reduce the error at least by n to this
/// power. Half-spaces show 1.5 to 1.9 (verification.LeadingEdge.*).
constexpr double assumed_order = 1.5;

/// The cheapest grid of every contact whose total error is at most `accuracy`, otherwise one with
/// nearly the smallest error. Solved grids cost nothing. Empty if the model cannot take a contact.
std::optional<Plan> plan_of(const Contacts& contacts, std::size_t model, double accuracy);

/// The cheapest model that meets the accuracy within the time; empty if there is none.
std::optional<Plan> cheapest(const Contacts& contacts, double accuracy,
                             double seconds = std::numeric_limits<double>::infinity());

/// The solution with the smallest error; null if there is none.
const Level* best_solved(const Forecast& forecast);

/// The contact whose best solution by the model has the largest error; empty if one is not solved.
std::optional<std::size_t> worst_contact(const Contacts& contacts, std::size_t model);

/// The model whose worst contact has the smallest error, of those that have solved all; empty if
/// there is none.
std::optional<std::size_t> answer(const Contacts& contacts);

/// What a run solves next; empty if nothing would improve on its solutions. The first model that
/// can take all contacts solves them first. After that, one model solves all contacts if it is
/// expected to meet the accuracy within `seconds`; otherwise finer grids follow where they help.
/// Without limit, so does a model that is only expected to come closer.
std::optional<Plan> next_plan(const Contacts& contacts, double accuracy, double seconds);

/// Records that level `at` was solved: updates the expected errors of unsolved levels and removes
/// the one-time cost from them.
void learn(Forecast& forecast, std::size_t at, double discretisation, double seconds);

/// A model that corrects another one keeps `uncertain_part` of its model error, if that is known.
void inherit_error(Forecast& forecast, const Forecast& corrected);

/// Records that level `at` of another model was solved. If `forecast` corrects that model, it
/// inherits the discretisation errors and a part of the model error; otherwise its grids are
/// assumed no better with the same number of elements.
void learn_from(Forecast& forecast, const Forecast& solved, std::size_t at);

}  // namespace rollfem::modelling
