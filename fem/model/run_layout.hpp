// The layout of one level of the model fem before anything is meshed: expected
// patch, contact grid, options of the bodies, memory.
#pragma once

#include "contact/base/grid.hpp"
#include "contact/scene/scene.hpp"
#include "fem/body/body.hpp"
#include "fem/solver/memory.hpp"
#include "halfspace/patch/patch_search.hpp"

namespace rollfem::fem {

using halfspace::PatchBox;
using halfspace::PatchSearch;

/// FE cell size of the case: [fem] cell_size, or an eighth of the smaller semi-axis.
double default_cell_size(const contact::Scene& scene);

/// The case has a patch of true profiles and the bodies are the true sections of wheel and rail,
/// not boxes laid on the surface: as [fem] mesh says, else where a box would not reach far enough.
bool has_true_sections(const contact::Scene& scene);

struct RunLayout {
  PatchBox patch;
  contact::ContactGrid grid;  ///< square elements on the lattice of the FE faces: one face each,
                              ///< of degree 1 two by two
  BodyOptions bodies;
};
/// Throws contact::InputError when the profiles cannot be meshed so far.
RunLayout run_layout(const contact::Scene& scene, double cell);

/// Number of load points that keep displacement and stress of the bodies.
int points_that_keep_bodies(const contact::Scene& scene);

/// Of bodies with so many unknowns (0: rigid) and half of each or all modelled, by a solver that is
/// not chosen yet. `body_fields`: load points that keep those of the bodies.
MemoryDemand memory_demand(double wheel, double rail, const BodyOptions& bodies, int body_fields);

/// Throws contact::SolveError when the level will not fit into memory, without making a mesh.
/// Collective.
void refuse_beyond_memory(const contact::Scene& scene, double cell_size);

}  // namespace rollfem::fem
