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

/// A line for each contact of the first position; nothing is solved but where true profiles touch.
std::string expected_choice(const contact::Case& input, const contact::ModelRegistry& models);

/// Sets StudyPlace::choice for 5, 1 and 0.2 %. What half-spaces leave out is solved for, where a
/// series of theirs is among those of the place; else it is expected.
void add_choice(const contact::Scene& scene, const Solving& how, double friction,
                postprocess::StudyPlace& place);

}  // namespace rollfem::modelling
