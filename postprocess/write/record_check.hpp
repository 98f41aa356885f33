// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks that writers rely on beyond those of every load point (contact/result/validity.hpp): names
// usable as paths, values that fit their bodies.
#pragma once

#include "postprocess/write/output.hpp"

namespace rollfem::postprocess {

/// Throws std::logic_error for a model name that is empty, repeated or not a file name, and for
/// values that do not fit their body: defects of a model that must not reach a file.
void check_record(const RunRecord& run);

}  // namespace rollfem::postprocess
