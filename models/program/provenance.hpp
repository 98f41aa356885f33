// Provenance of a result: who made it, where and when.
#pragma once

#include "contact/solve/models.hpp"
#include "postprocess/write/output.hpp"

#include <string>

namespace rollfem::modelling {

/// Of what is computed now by this process. `command`: the whole call.
postprocess::Provenance provenance_of(const contact::ModelRegistry& models,
                                      const std::string& command);

}  // namespace rollfem::modelling
