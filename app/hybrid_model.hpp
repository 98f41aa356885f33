// The model "hybrid" as the registry has it. What it needs finite elements for is found by the
// library that is opened when it runs.
#pragma once

#include "contact/solve/model.hpp"
#include "hybrid/model.hpp"

namespace rollfem::app {

/// Finds what the bodies of a scene add to half-spaces. The library is opened when it is called;
/// throws contact::InputError as open_fem_library does.
hybrid::FindParts smooth_parts_finder();

contact::ModelInfo hybrid_model();

}  // namespace rollfem::app
