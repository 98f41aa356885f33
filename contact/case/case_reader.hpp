// SPDX-License-Identifier: LGPL-2.1-or-later
// TOML case files: reading with checks, printing how the case is read, a commented template, and
// the reference page, all from one declaration of the keys.
#pragma once

#include "contact/case/case.hpp"
#include "contact/case/model_words.hpp"

#include <string>
#include <vector>

namespace rollfem::contact {

/// Reads and checks a case file. Throws InputError with one message: FILE:LINE:COLUMN, key, value,
/// allowed values, remedy. `changes`: as in case_edit.hpp; the case then holds the changed text.
Case read_case(const std::string& path, const ModelWords& models = {},
               const std::vector<std::string>& changes = {});

/// The same from text; messages use `name` for the file.
Case parse_case(const std::string& text, const std::string& name, const ModelWords& models = {});

/// The subsurface points of a file with [[subsurface.*]] as in a case file; everything else is
/// ignored. Throws InputError like read_case.
std::vector<SubsurfaceRequest> read_places(const std::string& path);

/// How the case is read: every key with value, unit and whether it is the default. Multi-line text.
std::string describe(const Case& input, const ModelWords& models = {});

/// A commented case file with defaults, which parse_case accepts.
std::string case_template(const ModelWords& models = {});

/// docs/case-file.md: every key with type, unit, bounds, default and one sentence.
std::string case_reference_markdown(const ModelWords& models = {});

}  // namespace rollfem::contact
