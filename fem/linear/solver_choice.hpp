// SPDX-License-Identifier: LGPL-2.1-or-later
// Chooses the linear solver of a level by size, number of solves, memory
// and processes, and creates it for both bodies; refuses levels that do not fit into memory.
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

/// Whether the bodies are factorised: as the case says, else where that is expected to be quicker
/// for its number of solves and fits into memory. Throws contact::InputError when the case asks for
/// it on several processes. Collective.
bool takes_factorisation(const contact::Scene& scene, MemoryDemand demand);

/// About as many unknowns as the body has before it is refined towards the patch.
double coarse_unknowns(const Body& body);

/// Whether algebraic multigrid is taken where the body is not factorised: as the case says, or for
/// a coarse mesh too large for geometric multigrid.
bool takes_algebraic(const contact::Scene& scene, const Body& body);

/// Collective.
Solvers make_solvers(const contact::Scene& scene, const BodyPair& bodies, bool factorisation);

/// Number of load points that keep displacement and stress of the bodies.
int points_that_keep_bodies(const contact::Scene& scene);

/// Of bodies with so many unknowns (0: rigid) and half of each or all modelled, by a solver that is
/// not chosen yet. `body_fields`: load points that keep those of the bodies.
MemoryDemand memory_demand(double wheel, double rail, const BodyOptions& bodies, int body_fields);

/// Throws contact::SolveError when the level will not fit into memory, without making a mesh.
/// Collective.
void refuse_beyond_memory(const contact::Scene& scene, double cell_size);

}  // namespace rollfem::fem
