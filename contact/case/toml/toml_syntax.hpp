// Checks that a text is grammatical TOML; private to contact/case. Only such text is passed to
// toml++ 3.3, which aborts or has undefined behaviour on some malformed input.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rollfem::contact {

struct TomlFault {
  unsigned line = 1;    ///< from 1
  unsigned column = 1;  ///< from 1, in characters
  std::string wrong;    ///< what was expected there, and what was found
};

/// The first place at which the text departs from TOML 1.0; none where it does not. How numbers and
/// dates are spelt, and keys that are given twice, are left to the parser. Refused beyond the
/// standard: more than 64 levels of nesting, and a continued line of a text in three quotes that
/// begins with a letter beyond ASCII, which toml++ cannot read.
std::optional<TomlFault> find_toml_fault(std::string_view text);

}  // namespace rollfem::contact
