// SPDX-License-Identifier: LGPL-2.1-or-later
// Reads summary.json back into the record of every model, without fields.
#pragma once

#include "contact/result/result.hpp"

#include <string>
#include <vector>

namespace rollfem::postprocess {

/// Reads names, wheel and patch, seconds, load points with scalars and error estimates; members
/// unknown to an earlier version keep their defaults. Throws std::exception for a text that is not
/// a summary.
std::vector<contact::ModelResult> models_of_summary(const std::string& summary);

}  // namespace rollfem::postprocess
