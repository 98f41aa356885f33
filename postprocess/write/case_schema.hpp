// SPDX-License-Identifier: LGPL-2.1-or-later
// The keys of a case file as a JSON schema (draft 7), for completion and checks of TOML in editors.
#pragma once

#include "contact/case/model_words.hpp"

#include <string>

namespace rollfem::postprocess {

/// Derived from the table of keys: types, bounds, words, defaults and sentences; keys that are not
/// in it are errors, as they are when a case is read. What concerns several keys at once (one of
/// normal_force and approach, lists of one length) is left to the reader.
std::string case_schema(const contact::ModelWords& models);

}  // namespace rollfem::postprocess
