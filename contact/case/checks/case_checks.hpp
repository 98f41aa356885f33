// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks of a case file beyond the bounds of each key, and the wording of its errors.
#pragma once

#include "contact/case/keys/case_keys.hpp"

#include <map>
#include <string>

namespace rollfem::contact {

/// A value as it stands in the file.
struct GivenValue {
  KeyValue value;
  std::string text;  ///< as the user typed it, shortened
  unsigned line = 0;
  unsigned column = 0;
};

/// One section of which there may be several.
struct GivenEntry {
  std::string section;
  unsigned line = 0;
  std::map<const Key*, GivenValue> values;
};

/// The whole file after each key passed its own check.
struct GivenCase {
  std::string file;
  std::map<const Key*, GivenValue> values;
  std::vector<GivenEntry> entries;                ///< of repeated sections, in order
  std::map<std::string, unsigned> section_lines;  ///< where each section begins

  const GivenValue* find(const std::string& section, const std::string& name) const;
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

/// `file` is a change by --set as typed: it names key and value itself and has no lines.
bool is_option(const std::string& file);

/// Throws InputError with the message.
[[noreturn]] void fail(const std::string& file, const CaseProblem& problem);

/// The value of a word, or its default.
std::string word_of(const GivenCase& given, const char* section, const char* name,
                    const char* otherwise);

/// Missing and contradictory keys, lists of different lengths. Throws InputError.
void check_together(const GivenCase& given);

/// Missing keys of repeated sections. Throws InputError.
void check_entries(const GivenCase& given);

/// Numbers of points below the surface and, where the `bodies` of the case are known, that they lie
/// in them. Throws InputError.
void check_places(const GivenCase& given, const Case& input, bool bodies = true);

/// Only keys of [wheel_profile] and [rail_profile] that are read.
/// Throws InputError.
void check_profiles(const GivenCase& given);

/// Wheel or rail is given by a profile.
bool has_profiles(const GivenCase& given);

/// The contact is one of endless rollers.
bool is_line(const GivenCase& given);

/// Fills in what follows from what was given: the load of a history or a given pressure, radii that
/// are not needed (inf), the length of the history, which creepages are given, positions of the
/// wheelset at one length.
void complete(const GivenCase& given, Case& input);

/// Values that must fit each other: forces below the friction limit, at most one rigid body, points
/// below the surface in their body. Throws InputError.
void check_values(const GivenCase& given, const Case& input);

/// Problem at a given value; the caller adds what is wrong.
CaseProblem problem_at(const std::string& path, const GivenValue& given);

/// Throws InputError: the value at `path` is wrong.
[[noreturn]] void fail_at(const GivenCase& given, const std::string& path, const GivenValue& value,
                          const std::string& wrong, const std::string& allowed,
                          const std::string& action);

/// Line on which a section begins, 0 when it is not there.
unsigned section_line(const GivenCase& given, const std::string& section);

/// Geometry that has no concentrated contact. Throws InputError.
void check_geometry(const GivenCase& given, const Case& input);

}  // namespace rollfem::contact
