// SPDX-License-Identifier: LGPL-2.1-or-later
// Dependencies between the keys of a case, declared in tables: keys without meaning in some cases,
// mutually exclusive alternatives, and groups with one required key.
#pragma once

#include "contact/case/checks/conditions.hpp"

#include <vector>

namespace rollfem::contact {

/// Keys that are not allowed if the condition holds: "section.name", with at most one *. In the
/// texts, {problem} stands for the problem, {slip} for extra_slip, {law} for the friction law and
/// {laws} for those that fall.
struct Exclusion {
  Condition where;
  std::vector<const char*> keys;
  const char* wrong;
  const char* allowed;
  const char* action;
  bool defaults_too = false;  ///< also rejected with a value that has no effect
};

extern const std::vector<Exclusion> exclusions;

/// Alternative keys: at most one of them is allowed.
struct Rivals {
  std::vector<const char*> keys;
  const char* why;  ///< added to "contradicts ..."; may be empty
  const char* allowed;
  bool by_point = false;  ///< a list with nan leaves these load points to the other key
};

extern const std::vector<Rivals> rivals;

/// One of these keys is required where the condition holds.
struct Need {
  Condition where;
  std::vector<const char*> one_of;
  const char* wrong;
  const char* allowed;
  const char* action;
};

extern const std::vector<Need> needs;

/// Applies the rules to the given keys. Throws InputError.
void check_rules(const GivenCase& given);

}  // namespace rollfem::contact
