// SPDX-License-Identifier: LGPL-2.1-or-later
// summary.json: the numbers of a run without fields, for scripts and tests. Layout:
// docs/results.md.
#pragma once

#include "postprocess/write/output.hpp"

#include <string>

namespace rollfem::postprocess {

/// The text of summary.json; doubles have enough digits to be recovered exactly. The record must
/// have passed check_record.
std::string summary_json(const RunRecord& run);

}  // namespace rollfem::postprocess
