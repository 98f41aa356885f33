// The model "linear": Kalker's linear theory of rolling contact
// (halfspace/closed_forms/kalker.hpp). No slip, no friction bound.
#pragma once

#include "contact/solve/model.hpp"

namespace rollfem::theories {

/// The model "linear". Its forces are those of the coefficients, without a bound; its tractions are
/// those of the simplified theory without slip, which give the same F_x and F_y. Throws
/// contact::InputError for extra rigid slip.
contact::ModelResult run_linear(const contact::Scene& scene, const contact::Progress& progress);

}  // namespace rollfem::theories
