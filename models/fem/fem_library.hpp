// The finite-element library, opened at run time: loading deal.II, Trilinos and PETSc takes longer
// than a whole half-space run.
#pragma once

#include "fem/elasticity/model.hpp"

namespace rollfem::modelling {

/// Opens the library; throws contact::InputError in a build without it, or when it is not found
/// beside the program. `asked_by`: what asked for the model, for the message.
const fem::Entry& open_fem_library(const std::string& asked_by);

}  // namespace rollfem::modelling
