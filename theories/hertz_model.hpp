// The model "hertz": the closed form put into the result record that all models share.
#pragma once

#include "contact/solve/model.hpp"

namespace rollfem::theories {

/// The model "hertz": patch, pressure and approach; no friction. Tractions are sampled on the
/// case's contact grid.
contact::ModelResult run_hertz(const contact::Scene& scene, const contact::Progress& progress);

}  // namespace rollfem::theories
