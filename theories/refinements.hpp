// How a study refines the theories.
#pragma once

#include "contact/solve/model.hpp"

namespace rollfem::theories {

/// Strips and their elements: those of the case are the third of five levels.
contact::Refinement carter_strips();
contact::Refinement fastsim_strips();
contact::Refinement strip_strips();

}  // namespace rollfem::theories
