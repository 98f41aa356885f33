// SPDX-License-Identifier: LGPL-2.1-or-later
// The keys of a case file as a JSON schema (draft 7), for completion and checks of TOML in editors.
#pragma once

#include "case/reading/case_reader.hpp"

#include <string>

namespace rollfem::result {

/// Derived from the table of keys: types, bounds, words, defaults and sentences. Unknown keys are
/// errors, as for the reader of cases. Only the reader checks rules that involve several keys (one
/// of normal_force and approach, lists of equal length).
std::string case_schema(const contact::KnownNames& known);

}  // namespace rollfem::result
