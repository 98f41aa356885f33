// SPDX-License-Identifier: LGPL-2.1-or-later
// Chooses the linear solver of a level by size, number of solves, memory and processes, and creates
// it for both bodies; rejects levels that do not fit into memory.
#pragma once

#include "fem/discretisation/body.hpp"
#include "fem/linear/linear_solver.hpp"
#include "fem/linear/memory.hpp"
#include "result/note.hpp"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace rollfem::fem {

/// Of wheel and rail; null: rigid.
using Solvers = std::array<std::unique_ptr<LinearSolver>, 2>;

/// What bodies with these options need with the linear solver chosen for them: factorised as given
/// in the case, otherwise if expected to be faster for the number of solves and within memory.
/// `body_fields`: load points store displacement and stress of the bodies as the case asks. Throws
/// contact::InputError when the case requests a factorisation on several processes. Collective.
MemoryDemand memory_demand(const contact::Scene& scene, const BodyOptions& options,
                           const BodyPair& bodies, bool body_fields);

/// Collective.
Solvers make_solvers(const contact::Scene& scene, const BodyPair& bodies, bool factorisation);

/// Throws contact::SolveError when the level does not fit into memory, without creating a mesh.
/// Collective.
void refuse_beyond_memory(const contact::Scene& scene, double cell_size);

/// Gives a scene that yields thicker first rows than chosen for it until memory takes its cells;
/// the note says so. None: they fit.
std::optional<contact::Note> fit_surface_rows(contact::Scene& scene, double cell_size);

/// Whether memory takes levels with cells of these sizes at the same time.
bool fit_together(const contact::Scene& scene, const std::vector<double>& cell_sizes);

}  // namespace rollfem::fem
