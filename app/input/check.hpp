// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `check`: how a case is read, which models take it, and what they are expected to
// cost.
#pragma once

#include "contact/solve/model.hpp"

#include <string>
#include <vector>

namespace rollfem::app {

struct CheckRequest {
  std::string case_file;
  std::vector<std::string> changes;  ///< of keys, from --set
  bool json = false;
};

/// Prints the case and warns of doubtful values; solves nothing. Throws contact::InputError.
void check_case(const CheckRequest& request, const contact::ModelRegistry& models);

}  // namespace rollfem::app
