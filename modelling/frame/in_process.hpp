// SPDX-License-Identifier: LGPL-2.1-or-later
// Solving in the process of another program, which may have several threads.
#pragma once

#include "modelling/fem/fem_library.hpp"
#include "modelling/registry.hpp"
#include "modelling/solving/auto_model.hpp"
#include "modelling/solving/solving.hpp"

#include <string>
#include <vector>

namespace rollfem::modelling {

/// How to solve with these models; parallel ones wait for each other while it lives.
struct InProcess {
  Solving how;
  FemLock one_at_a_time;
};

/// Starts MPI where a model needs it. Throws contact::InputError for a model that is not built.
inline InProcess in_process(const contact::ModelRegistry& known,
                            const std::vector<std::string>& models,
                            const contact::Progress& progress) {
  InProcess solving;
  solving.how.models = &known;
  solving.how.progress = progress;
  if (!any_parallel(known, models)) return solving;
  solving.one_at_a_time = lock_fem();
  solving.how.need_session = [] { parallel_session("models"); };
  if (!any_choice(known, models)) solving.how.need_session();
  return solving;
}

}  // namespace rollfem::modelling
