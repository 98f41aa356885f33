// SPDX-License-Identifier: LGPL-2.1-or-later
// The choice among models: finds the cheapest whose total error meets an accuracy, by
// solving the most promising, measuring the error reached and updating the forecast. States
// in one sentence what was chosen, what was not, and why.
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

/// Where a case does not say.
constexpr double default_accuracy = 0.01;

/// A model that may be taken.
struct Candidate {
  Forecast forecast;
  /// Solves on so many elements across. Throws contact::InputError, contact::SolveError.
  std::function<contact::ModelResult(int across)> solve;
  /// Model errors that its results do not carry are unknown, unless it says that there are none.
  bool estimates_model_error = false;
  /// Where they are not estimated: none is larger, as part of its whole. 0: there is none.
  double largest_model_error = 0.0;
  std::string no_model_error = {};  ///< why its model error cannot be known; empty: it can
};

struct Wanted {
  contact::AccuracyRequest accuracy;  ///< `relative` is set
  double friction_coefficient = 0.0;
  /// Nobody named an accuracy: this is the time there is, and that it is not reached is no failure.
  Budget* budget = nullptr;
  double times = 1.0;  ///< this machine's seconds for a predicted one
  /// A model that fails is left out and the others go on; else what it throws ends the choice.
  bool go_on = true;
  /// Told what is tried and how long that takes before it begins. May be empty.
  contact::Progress progress = {};
  /// Among processes: the text of the first on all of them. May be empty.
  std::function<std::string(const std::string&)> agree = {};
};

/// The result of the model that was taken. Its `choice` is the sentence, which is its first note as
/// well; `shortfall` is set where the accuracy was asked for and is not reached. Throws
/// contact::InputError where no candidate is in question, or what the last of them threw.
contact::ModelResult choose(std::vector<Candidate> candidates, const Wanted& wanted);

/// Predicted seconds of what is tried first; 0 where nothing is expected to do.
double seconds_of_first(const std::vector<Forecast>& forecasts, double accuracy);

/// "0.3 s", "4 min", "2 h".
std::string duration(double seconds);

/// "half-space with 24 across, about 0.3 s: discretisation 0.6 %, model 0.2 %", or that nothing is
/// expected to do. `others`: with what is not taken, and why.
std::string verdict(const std::vector<Forecast>& forecasts, double accuracy, bool others);

}  // namespace rollfem::modelling
