// How a study refines the models of this folder.
#pragma once

#include "contact/solve/model.hpp"

namespace rollfem::halfspace {

/// Contact elements: the grid of the case is the third of five levels.
contact::Refinement contact_grid();

/// Strips and their elements: those of the case are the third of five levels.
contact::Refinement carter_strips();
contact::Refinement fastsim_strips();
contact::Refinement strip_strips();

}  // namespace rollfem::halfspace
