// SPDX-License-Identifier: LGPL-2.1-or-later
// TOML case files: reading with checks, printing how the case is read, a commented template, and
// the reference page, all from one declaration of the keys.
#pragma once

#include "case/keys/case_keys.hpp"

#include <string>
#include <utility>
#include <vector>

namespace rollfem::contact {

/// Reads and checks a case file. Throws InputError with one message: FILE:LINE:COLUMN, key, value,
/// allowed values, remedy. `changes`: as with_changes; the case then holds the changed text.
Case read_case(const std::string& path, const KnownNames& known = {},
               const std::vector<std::string>& changes = {});

/// The same from text; messages use `name` for the file.
Case parse_case(const std::string& text, const std::string& name, const KnownNames& known = {});

/// A value for each "section.key".
using NamedValues = std::vector<std::pair<std::string, KeyValue>>;

/// A case of values, without text, that passes the same checks. Throws std::logic_error for unknown
/// keys.
Case make_case(const NamedValues& values, const std::string& name);

/// The subsurface points of a file with [[subsurface.*]] as in a case file; everything else is
/// ignored. Throws InputError like read_case.
std::vector<SubsurfaceRequest> read_places(const std::string& path);

/// How the case is read: every key with value, unit and whether it is the default, or only those
/// that the case gives. Multi-line text.
std::string describe(const Case& input, const KnownNames& known = {}, bool every_key = true);

/// A commented case file with defaults, which parse_case accepts.
std::string case_template(const KnownNames& known = {});

/// docs/case-file.md: every key with type, unit, bounds, default and one sentence.
std::string case_reference_markdown(const KnownNames& known = {});

// Changes of single keys, as in `--set friction.coefficient=0.3`. The text itself is edited, so
// that the case stored with the results is the one that was solved.

/// The text of a case file after all changes, in order. Each is "KEY=VALUE": the key with its
/// section, the value as in TOML, or a single word without quotes. Missing keys are added. `file`
/// is used in messages. Throws InputError when the text is not a case file, or a change has an
/// unknown key or an invalid value.
std::string with_changes(std::string text, const std::string& file,
                         const std::vector<std::string>& changes, const KnownNames& known = {});

/// The files that a case reads, each once: those that its keys name, and those that lists of
/// sections among them name.
std::vector<std::string> files_read_by(const Case& input);

/// The text of the case for a file in another folder: paths of files, which are relative to the
/// case file, lead from there.
std::string text_in_folder(const Case& input, const std::string& folder);

}  // namespace rollfem::contact
