// SPDX-License-Identifier: LGPL-2.1-or-later
// The keys that a case must give because of what else it gives.
#pragma once

#include "case/checks/case_checks.hpp"

namespace rollfem::contact {

/// Throws InputError.
void check_needs(const GivenCase& given);

}  // namespace rollfem::contact
