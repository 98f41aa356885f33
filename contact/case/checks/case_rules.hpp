// SPDX-License-Identifier: LGPL-2.1-or-later
// Dependencies between the keys of a case, declared in tables: keys without meaning in some cases,
// mutually exclusive alternatives, and groups with one required key.
#pragma once

#include "contact/case/checks/case_checks.hpp"

#include <vector>

namespace rollfem::contact {

/// Condition under which a rule applies to a case.
using Condition = bool (*)(const GivenCase&);

/// Keys that are not allowed if the condition holds: "section.name", with at most one *. In the
/// texts, {problem} stands for the problem, {slip} for extra_slip, {law} for the friction law.
struct Exclusion {
  Condition where;
  std::vector<const char*> keys;
  const char* wrong;
  const char* allowed;
  const char* action;
  bool defaults_too = false;  ///< also rejected with a value that has no effect
};

/// Keys excluded by the shape of the bodies.
const std::vector<Exclusion>& exclusions_of_shapes();

/// Keys excluded by the problem, or by data given instead of a part of it.
const std::vector<Exclusion>& exclusions_of_problems();

/// Keys excluded by a constant coefficient of friction, or by another law.
const std::vector<Exclusion>& exclusions_of_friction();

/// Alternative keys: at most one of them is allowed.
struct Rivals {
  std::vector<const char*> keys;
  const char* why;  ///< added to "contradicts ..."; may be empty
  const char* allowed;
  bool by_point = false;  ///< a list with nan leaves these load points to the other key
};

const std::vector<Rivals>& rivals();

/// One of these keys is required where the condition holds.
struct Need {
  Condition where;
  std::vector<const char*> one_of;
  const char* wrong;
  const char* allowed;
  const char* action;
};

const std::vector<Need>& needs();
/// Of falling friction and of a layer.
const std::vector<Need>& needs_of_friction();

/// Applies the rules to the given keys. Throws InputError.
void check_rules(const GivenCase& given);

}  // namespace rollfem::contact
