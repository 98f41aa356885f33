// SPDX-License-Identifier: LGPL-2.1-or-later
// What the keys of a case need and exclude, declared in tables: which keys have no meaning where,
// which decide the same thing, and of which one must be there.
#pragma once

#include "contact/case/checks/case_checks.hpp"

#include <vector>

namespace rollfem::contact {

/// What a rule asks of the case.
using Condition = bool (*)(const GivenCase&);

/// Keys that must not stand where the condition holds: "section.name", with at most one *. In what
/// is wrong, {problem} stands for the problem, {slip} for extra_slip.
struct Exclusion {
  Condition where;
  std::vector<const char*> keys;
  const char* wrong;
  const char* allowed;
  const char* action;
  bool defaults_too = false;  ///< also refused where it asks for nothing
};

/// What bodies of a shape exclude.
const std::vector<Exclusion>& exclusions_of_shapes();

/// What the problem, or what is given in place of a part of it, excludes.
const std::vector<Exclusion>& exclusions_of_problems();

/// Keys that decide the same thing: at most one of them may stand.
struct Rivals {
  std::vector<const char*> keys;
  const char* why;  ///< added to "contradicts ..."; may be empty
  const char* allowed;
};

const std::vector<Rivals>& rivals();

/// One of these keys must stand where the condition holds.
struct Need {
  Condition where;
  std::vector<const char*> one_of;
  const char* wrong;
  const char* allowed;
  const char* action;
};

const std::vector<Need>& needs();

/// The rules hold for what is given. Throws InputError.
void check_rules(const GivenCase& given);

}  // namespace rollfem::contact
