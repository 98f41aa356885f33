// What a case file must satisfy beyond the bounds of each key, and how its errors are worded.
#pragma once

#include "contact/case_keys.hpp"

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

/// The whole file after each key passed its own check.
struct GivenCase {
  std::string file;
  std::map<const Key*, GivenValue> values;
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

/// Throws InputError with the message.
[[noreturn]] void fail(const std::string& file, const CaseProblem& problem);

/// Missing and contradictory keys, lists of different lengths. Throws InputError.
void check_together(const GivenCase& given);

/// Geometry that has no concentrated contact. Throws InputError.
void check_geometry(const GivenCase& given, const Case& input);

}  // namespace rollfem::contact
