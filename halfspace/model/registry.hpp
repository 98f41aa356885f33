// The models of this folder by name, with the options that the case gives them.
#pragma once

#include "contact/base/checkpoint.hpp"
#include "contact/solve/model.hpp"

#include <string>
#include <vector>

namespace rollfem::halfspace {

/// From the simplest: hertz, linear, vermeulen-johnson, carter, fastsim, strip, halfspace.
const std::vector<std::string>& model_names();

/// Runs a model by name with the options of the case; the model halfspace also gives the points
/// below the surface that the case asks for. Throws contact::InputError for an unknown name and for
/// a case that the model cannot take. `checkpoint` (may be null) serves the model halfspace; the
/// others take no time.
contact::ModelResult run_model(const std::string& name, const contact::Case& input,
                               const contact::Progress& progress,
                               contact::Checkpoint* checkpoint = nullptr);

}  // namespace rollfem::halfspace
