// SPDX-License-Identifier: LGPL-2.1-or-later
// Module 3: contacts given by their undeformed distance or their ellipse.
#pragma once

#include "convert/equivalent.hpp"

namespace rollfem::convert {

/// The part of equivalent_of for these cases.
void fill_single_contact(const ContactCase& given, Equivalent& made);

}  // namespace rollfem::convert
