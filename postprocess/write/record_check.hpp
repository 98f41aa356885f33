// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks that every writer relies on: sizes that fit the grid, names usable as paths, no NaN.
#pragma once

#include "postprocess/write/output.hpp"

namespace rollfem::postprocess {

/// Throws std::logic_error naming the field if the record holds a number that is not finite, a
/// field that does not fit its grid, or a model name that is empty, repeated or not a file name.
/// Such a result is a defect of its model and must not reach a file.
void check_record(const RunRecord& run);

}  // namespace rollfem::postprocess
