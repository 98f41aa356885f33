// SPDX-License-Identifier: LGPL-2.1-or-later
// Fields of a patch by rows of CONTACT's elements, in the client's units and signs.
#pragma once

#include "bindings/contact/problem.hpp"
#include "bindings/contact/words.hpp"

#include <vector>

namespace rollfem::addon {

/// Throws Refusal for an unknown code and for a field that is not known in this case.
std::vector<double> field_values(int code, const Problem& problem, const Patch& patch);

}  // namespace rollfem::addon
