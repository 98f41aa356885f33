// The model "hybrid" as the registry has it. What it needs finite elements for is found by the
// library that is opened when it runs.
#pragma once

#include "contact/solve/model.hpp"

namespace rollfem::app {

contact::ModelInfo hybrid_model();

}  // namespace rollfem::app
