// SPDX-License-Identifier: LGPL-2.1-or-later
// The expected choice of `auto`: for `check` from geometry alone, for `study` from the levels
// solved.
#pragma once

#include "contact/case/case.hpp"
#include "contact/solve/model.hpp"
#include "models/choice/forecast.hpp"
#include "models/solving/solving.hpp"
#include "postprocess/study/study.hpp"

#include <string>
#include <vector>

namespace rollfem::modelling {

/// One contact of a run of `auto`.
struct ExpectedContact {
  std::optional<contact::ContactPlace> place;
  std::vector<Forecast> forecasts;  ///< in seconds of this machine
  std::string sentence;             ///< the grid of the model that the run is expected to choose
  double seconds = 0.0;             ///< of all its solutions
};

/// The same run as `solve` expects it, except that the balance of a wheelset is missing.
struct ExpectedChoice {
  double accuracy = 0.0;
  std::vector<ExpectedContact> contacts;
  std::string sentence;  ///< on all contacts: models, time, the models not chosen
  double seconds = 0.0;  ///< of all contacts
};

/// Nothing is solved except the contact points of true profiles. Throws contact::InputError and
/// contact::SolveError.
ExpectedChoice expected_choice(const contact::Case& input, const contact::ModelRegistry& models);

/// A line for each contact and one for all; empty if the case has no contact.
std::string expected_choice_text(const contact::Case& input, const contact::ModelRegistry& models);

/// Sets StudyPlace::choice for 5, 1 and 0.2 %. The model error of half-spaces is computed if the
/// place has a series of half-spaces; otherwise it is the expected one.
void add_choice(const contact::Scene& scene, const Solving& how, double friction,
                postprocess::StudyPlace& place);

}  // namespace rollfem::modelling
