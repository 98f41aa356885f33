// SPDX-License-Identifier: LGPL-2.1-or-later
// The choice among models, once for all contacts of a run: the half-space solves all of them, and
// if its errors exceed the accuracy, one other model that is expected to meet it. One sentence
// states which model was chosen, which ones were not, and why.
#pragma once

#include "base/accuracy.hpp"
#include "base/errors.hpp"
#include "base/progress.hpp"
#include "modelling/choice/forecast.hpp"
#include "result/refinement.hpp"
#include "result/result.hpp"

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace rollfem::modelling {

/// Time limit of a run without a requested accuracy, in predicted seconds, so that the same case
/// leads to the same choice.
constexpr double seconds_by_default = 60.0;

/// A contact of the run.
struct Subject {
  std::vector<Forecast> forecasts;  ///< of the same models for every contact
  /// Solves by one of them with `across` elements across the patch. Throws contact::Failure.
  std::function<contact::ModelResult(const Forecast& model, int across)> solve;
  double friction_coefficient = 0.0;
  contact::FailurePlace where = {};  ///< of its failures: {"a.toml", "right wheel, position 2"}
};

struct Wanted {
  contact::AccuracyRequest accuracy;  ///< `relative` is set
  /// Limit of the predicted time. Where it is finite, no accuracy was requested, and missing the
  /// default accuracy is no failure.
  double seconds = std::numeric_limits<double>::infinity();
  /// True: a model that fails is left out. False: its exception ends the choice.
  bool go_on = true;
  /// Receives the expected time of a model that uses all threads before it begins. May be empty.
  contact::Progress progress = {};
  /// Collective: returns the bytes of the first process on every process. May be empty.
  std::function<std::string(const std::string&)> agree = {};
};

struct Chosen {
  /// In the order of the contacts, all of the same model. ModelResult::choice is the sentence about
  /// the choice; `shortfall` is set where a requested accuracy is not reached.
  std::vector<contact::ModelResult> results;
  /// What would meet an accuracy that was missed for want of time; otherwise empty.
  std::string advice;
};

/// Throws contact::InputError if no candidate can take all contacts, otherwise the first failure.
Chosen choose(std::vector<Subject> contacts, const Wanted& wanted);

}  // namespace rollfem::modelling
