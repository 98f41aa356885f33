// The model "fem" as the registry has it. Its library is opened when it runs.
#pragma once

#include "contact/solve/model.hpp"

namespace rollfem::app {

contact::ModelInfo fem_model();

}  // namespace rollfem::app
