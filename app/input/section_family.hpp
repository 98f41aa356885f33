// SPDX-License-Identifier: LGPL-2.1-or-later
// What `rollfem profile` says and writes about sections along the way.
#pragma once

#include "profiles/section_list.hpp"

#include <string>

namespace rollfem::app {

/// Number and positions of the sections, and where their features run.
std::string sections_text(const profiles::ListedSections& family, const std::string& title,
                          bool wheel);

/// A table (CSV) of all sections: position, number of the part between features, y and z. A part
/// has as many points in each section, so that equal rows of sections correspond;
/// empty cells where a section lacks it.
std::string sections_table(const profiles::ListedSections& family, const std::string& title,
                           bool wheel);

}  // namespace rollfem::app
