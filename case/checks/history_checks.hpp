// SPDX-License-Identifier: LGPL-2.1-or-later
// Positions of a wheel that follow each other, and the length of their steps.
#pragma once

#include "case/checks/case_checks.hpp"

namespace rollfem::contact {

/// Makes the lists over positions and steps of a wheel in a history equally long, and finds steps
/// given by time or place. Throws InputError.
void complete_history(const GivenCase& given, Case& input);

}  // namespace rollfem::contact
