// SPDX-License-Identifier: LGPL-2.1-or-later
// Registration of the model "fem", whose library is opened when it runs.
#pragma once

#include "contact/solve/model.hpp"

namespace rollfem::modelling {

contact::ModelInfo fem_model();

}  // namespace rollfem::modelling
