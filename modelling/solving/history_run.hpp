// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheels whose positions follow each other (Case::is_wheel_history): every step inherits the state
// of the material from the steps before, on one lattice of elements for each wheel and its rail.
#pragma once

#include "modelling/solving/case_scenes.hpp"
#include "modelling/solving/solving.hpp"

#include <vector>

namespace rollfem::modelling {

/// Solves all contacts of all steps by the half-space. `scenes`: balanced without friction, in the
/// order of the positions; the results have the same order, without those of contacts that friction
/// has unloaded. A step whose load is carried by several contacts shares it anew with the friction
/// that it finds. Throws contact::InputError for another model, and as solve_scene.
std::vector<contact::ModelResult> solve_history(const contact::Case& input,
                                                const track::PlacedWheels& placed,
                                                const std::string& model, const Scenes& scenes,
                                                const Solving& how);

}  // namespace rollfem::modelling
