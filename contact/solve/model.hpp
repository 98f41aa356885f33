// The one signature all models have, from Hertz to finite elements.
#pragma once

#include "contact/base/progress.hpp"
#include "contact/case/case.hpp"
#include "contact/result/result.hpp"

#include <functional>

namespace rollfem::contact {

/// Runs all load points of a case. Throws InputError when the model cannot take the case (and says
/// which model can), SolveError when the solution failed.
using Model = std::function<ModelResult(const Case&, const Progress&)>;

}  // namespace rollfem::contact
