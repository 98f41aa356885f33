// SPDX-License-Identifier: LGPL-2.1-or-later
// The cases of the folder cases/.
#pragma once

#include "case/reading/case_reader.hpp"

#include "support/model_keys.hpp"
#include "support/places.hpp"
#include "support/test.hpp"
#include "support/thesis_cases.hpp"

namespace rollfem::testing {

inline contact::Case committed_case(const std::string& name) {
  return contact::read_case(std::string(ROLLFEM_SOURCE_DIR) + "/cases/" + name + ".toml");
}

/// Case a to f of the thesis, rolling with these longitudinal creepages.
inline contact::Case committed_case(char name, const std::vector<double>& creepages) {
  contact::Case input = committed_case(std::string("thesis_") + name);
  input.rolling.creepages = along(creepages);
  return input;
}

}  // namespace rollfem::testing
