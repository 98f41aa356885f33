// SPDX-License-Identifier: LGPL-2.1-or-later
// Reads summary.json back: the record of every model without its fields.
#pragma once

#include "contact/result/result.hpp"

#include <string>
#include <vector>

namespace rollfem::postprocess {

/// Names, which patch of which wheel, seconds, load points with scalars and error estimates; what
/// an earlier version did not write keeps its default. Throws std::exception for a text that is no
/// summary.
std::vector<contact::ModelResult> models_of_summary(const std::string& summary);

}  // namespace rollfem::postprocess
