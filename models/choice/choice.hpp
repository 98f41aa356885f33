// SPDX-License-Identifier: LGPL-2.1-or-later
// The choice among models: finds the cheapest model whose total error meets an accuracy, by solving
// the most promising one, measuring the error reached and updating the forecast. One sentence
// states which model was chosen, which ones were not, and why.
#pragma once

#include "contact/base/accuracy.hpp"
#include "contact/base/progress.hpp"
#include "contact/result/result.hpp"
#include "models/choice/budget.hpp"
#include "models/choice/forecast.hpp"
#include "models/choice/reached.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rollfem::modelling {

/// Default if the case requests no accuracy.
constexpr double default_accuracy = 0.01;

/// A model that may be chosen.
struct Candidate {
  Forecast forecast;
  /// Solves with `across` elements across the patch. Throws contact::InputError,
  /// contact::SolveError.
  std::function<contact::ModelResult(int across)> solve;
  /// True: results carry the model error. False: a model error missing from the results is unknown,
  /// unless `largest_model_error` bounds it.
  bool estimates_model_error = false;
  /// Upper bound where model errors are not estimated, as part of the whole. 0: no bound.
  double largest_model_error = 0.0;
  std::string no_model_error = {};  ///< why its model error cannot be known; otherwise empty
};

struct Wanted {
  contact::AccuracyRequest accuracy;  ///< `relative` is set
  double friction_coefficient = 0.0;
  /// Where it is limited, no accuracy was requested, and missing the default accuracy is no
  /// failure. Null: one of its own without limit.
  Budget* budget = nullptr;
  /// True: a model that fails is left out. False: its exception ends the choice.
  bool go_on = true;
  /// Receives the next model and its expected time before each solution. May be empty.
  contact::Progress progress = {};
  /// Collective: returns the text of the first process on every process. May be empty.
  std::function<std::string(const std::string&)> agree = {};
};

/// The result of the chosen model. Its `choice` is the sentence about the choice, which is also its
/// first note; `shortfall` is set if a requested accuracy is not reached. Throws
/// contact::InputError if no candidate can take the case, otherwise rethrows the failure of the
/// last candidate.
contact::ModelResult choose(std::vector<Candidate> candidates, const Wanted& wanted);

/// Predicted seconds of the first attempt; 0 if no model is expected to suffice.
double seconds_of_first(const std::vector<Forecast>& forecasts, double accuracy);

/// "0.3 s", "4 min", "2 h".
std::string duration(double seconds);

/// "half-space with 24 across, about 0.3 s: discretisation 0.6 %, model 0.2 %", or a sentence that
/// no model is expected to suffice. `others`: adds the models not chosen, with reasons.
std::string verdict(const std::vector<Forecast>& forecasts, double accuracy, bool others);

}  // namespace rollfem::modelling
