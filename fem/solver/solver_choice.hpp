// Chooses the linear solver of a level by size, number of solves, memory
// and processes, and creates it for both bodies.
#pragma once

#include "fem/body/body.hpp"
#include "fem/solver/memory.hpp"

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

/// Whether algebraic multigrid is taken where the body is not factorised: as the case says, or for
/// a coarse mesh too large for geometric multigrid.
bool takes_algebraic(const contact::Scene& scene, const Body& body);

/// Collective.
Solvers make_solvers(const contact::Scene& scene, const BodyPair& bodies, bool factorisation);

}  // namespace rollfem::fem
