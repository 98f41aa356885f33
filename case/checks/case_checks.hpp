// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks of a case file beyond the bounds of each key, and the wording of its errors.
#pragma once

#include "base/errors.hpp"
#include "case/keys/case_keys.hpp"

#include <map>
#include <string>

namespace rollfem::contact {

/// A value as written in the file.
struct GivenValue {
  KeyValue value;
  std::string text;  ///< as the user typed it, shortened
  unsigned line = 0;
  unsigned column = 0;
};

/// One entry of a repeatable section.
struct GivenEntry {
  std::string section;
  unsigned line = 0;
  std::map<const Key*, GivenValue> values;
};

/// The whole file after each key has passed its check.
struct GivenCase {
  std::string file;
  std::map<const Key*, GivenValue> values;
  std::vector<GivenEntry> entries;                ///< of repeated sections, in order
  std::map<std::string, unsigned> section_lines;  ///< first line of each section

  const GivenValue* find(const std::string& section, const std::string& name) const;
};

/// A key or value of a case is wrong; its place is FILE:LINE:COLUMN.
class CaseError : public InputError {
 public:
  using InputError::InputError;
};

/// One message: FILE:LINE:COLUMN: key = value: wrong; allowed: ...; do: ...
struct CaseProblem {
  unsigned line = 0;  ///< 0: the file as a whole
  unsigned column = 0;
  std::string key;    ///< may be empty
  std::string value;  ///< may be empty
  std::string wrong;
  std::string allowed;  ///< may be empty
  std::string action;
};

/// Throws CaseError with the message.
[[noreturn]] void fail(const std::string& file, const CaseProblem& problem);

/// The value of a word, or its default.
std::string word_of(const GivenCase& given, const char* section, const char* name);

/// Of a list; or the number itself, which counts.
std::size_t length_of(const KeyValue& value);

/// Missing and contradictory keys, lists of different lengths. Throws InputError.
void check_together(const GivenCase& given);

/// Missing keys of repeated sections. Throws InputError.
void check_entries(const GivenCase& given);

/// Checks the number of subsurface points and, where the `bodies` of the case are known, that the
/// points lie in them. Throws InputError.
void check_places(const GivenCase& given, const Case& input, bool bodies = true);

/// Fills in derived values: the load of a history or a given pressure, radii that are not needed
/// (inf), the length of the history, which creepages are given, lists over positions of the
/// wheelset extended to one length, what follows from options of models.
void complete(const GivenCase& given, Case& input);

/// Checks the consistency of values: forces below the friction limit, at most one rigid body,
/// subsurface points in their body. Throws InputError.
void check_values(const GivenCase& given, const Case& input);

/// Throws InputError about a key, "section.name": its value is wrong, or it is missing.
[[noreturn]] void fail_at(const GivenCase& given, const std::string& path, const std::string& wrong,
                          const std::string& allowed, const std::string& action);

/// Rejects geometry without concentrated contact. Throws InputError.
void check_geometry(const GivenCase& given, const Case& input);

}  // namespace rollfem::contact
