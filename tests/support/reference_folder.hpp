// SPDX-License-Identifier: LGPL-2.1-or-later
// The folder of reference files outside the repository, for tests that read them if available.
#pragma once

#include "support/places.hpp"
#include "support/test.hpp"

namespace rollfem::testing {

/// $ROLLFEM_REFERENCE, else ../shared/reference beside the sources; it need not exist.
inline std::filesystem::path reference_folder() {
  const char* named = std::getenv("ROLLFEM_REFERENCE");
  if (named != nullptr) return named;
  return std::filesystem::path(ROLLFEM_SOURCE_DIR).parent_path() / "shared" / "reference";
}

}  // namespace rollfem::testing
