// SPDX-License-Identifier: LGPL-2.1-or-later
// Changes single keys of a case file, as in `--set friction.coefficient=0.3`. The text itself is
// edited, so that the case stored with the results is the one that was solved.
#pragma once

#include "contact/case/case.hpp"
#include "contact/case/model_words.hpp"

#include <string>
#include <vector>

namespace rollfem::contact {

/// The text of a case file after all changes, in order. Each is "KEY=VALUE": the key with its
/// section, the value as in TOML, or a single word without quotes. Missing keys are added. `file`
/// is used in messages. Throws InputError when the text is not a case file, or a change has an
/// unknown key or an invalid value.
std::string with_changes(std::string text, const std::string& file,
                         const std::vector<std::string>& changes, const ModelWords& models = {});

/// The text of the case for a file in another folder: paths of files, which are relative to the
/// case file, lead from there.
std::string text_in_folder(const Case& input, const std::string& folder);

}  // namespace rollfem::contact
