// SPDX-License-Identifier: LGPL-2.1-or-later
// The names of models allowed in a case file, supplied by the caller.
#pragma once

#include <string>
#include <vector>

namespace rollfem::contact {

struct ModelWords {
  std::vector<std::string> known;       ///< empty: any name is accepted
  std::vector<std::string> by_default;  ///< if the case names none
};

}  // namespace rollfem::contact
