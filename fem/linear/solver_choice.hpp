// SPDX-License-Identifier: LGPL-2.1-or-later
// Chooses the linear solver of a level by size, number of solves, memory and processes, and creates
// it for both bodies; rejects levels that do not fit into memory.
#pragma once

#include "fem/discretisation/body.hpp"
#include "fem/linear/linear_solver.hpp"
#include "fem/linear/memory.hpp"

#include <memory>

namespace rollfem::fem {

struct Solvers {
  std::unique_ptr<LinearSolver> wheel;  ///< null: rigid
  std::unique_ptr<LinearSolver> rail;
};

/// Whether the bodies are factorised: as given in the case, otherwise if expected to be faster for
/// the number of solves and within memory. Throws contact::InputError when the case requests it on
/// several processes. Collective.
bool takes_factorisation(const contact::Scene& scene, MemoryDemand demand);

/// Estimated number of unknowns of the body before refinement towards the patch.
double coarse_unknowns(const Body& body);

/// Whether algebraic multigrid is used when the body is not factorised: as given in the case, or
/// for a coarse mesh too large for geometric multigrid.
bool takes_algebraic(const contact::Scene& scene, const Body& body);

/// Collective.
Solvers make_solvers(const contact::Scene& scene, const BodyPair& bodies, bool factorisation);

/// Number of load points that store displacement and stress of the bodies.
int points_that_keep_bodies(const contact::Scene& scene);

/// Memory of bodies with the given numbers of unknowns (0: rigid), half or whole, before the solver
/// is chosen. `body_fields`: load points that store fields of the bodies.
MemoryDemand memory_demand(double wheel, double rail, const BodyOptions& bodies, int body_fields);

/// Throws contact::SolveError when the level does not fit into memory, without creating a mesh.
/// Collective.
void refuse_beyond_memory(const contact::Scene& scene, double cell_size);

}  // namespace rollfem::fem
