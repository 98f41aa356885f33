// The models of this folder with their names, capabilities and options.
#pragma once

#include "contact/solve/models.hpp"

#include <string>

namespace rollfem::halfspace {

/// From the simplest: hertz, linear, vermeulen-johnson, carter, fastsim, strip, halfspace.
const contact::ModelRegistry& models();

/// models().run: a model by name with the options of the case; the model halfspace also gives the
/// points below the surface that the case asks for.
contact::ModelResult run_model(const std::string& name, const contact::ModelInput& input,
                               const contact::Progress& progress,
                               contact::Checkpoint* checkpoint = nullptr);

}  // namespace rollfem::halfspace
