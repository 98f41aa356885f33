// SPDX-License-Identifier: LGPL-2.1-or-later
// What every call of the library that solves needs; not installed.
#pragma once

#include "models/fem/fem_library.hpp"
#include "models/solving/solving.hpp"

#include <string>
#include <vector>

namespace rollfem {

const contact::ModelRegistry& registry();

/// How to solve with these models; parallel ones wait for each other while it lives.
struct Ready {
  modelling::Solving how;
  modelling::FemLock one_at_a_time;
};

/// Starts MPI where a model needs it. Throws contact::InputError for a model that is not built.
Ready ready_for(const std::vector<std::string>& models, const contact::Progress& progress);

}  // namespace rollfem
