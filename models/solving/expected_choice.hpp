// SPDX-License-Identifier: LGPL-2.1-or-later
// The expected choice of `auto`: for `check` from geometry
// alone, for `study` from the levels solved.
#pragma once

#include "contact/case/case.hpp"
#include "contact/solve/model.hpp"
#include "models/solving/solving.hpp"
#include "postprocess/study/study.hpp"

#include <string>

namespace rollfem::modelling {

/// One line for each contact of the first position. Nothing is solved except the contact points of
/// true profiles.
std::string expected_choice(const contact::Case& input, const contact::ModelRegistry& models);

/// Sets StudyPlace::choice for 5, 1 and 0.2 %. The model error of half-spaces is computed if the
/// place has a series of half-spaces; otherwise it is the expected one.
void add_choice(const contact::Scene& scene, const Solving& how, double friction,
                postprocess::StudyPlace& place);

}  // namespace rollfem::modelling
