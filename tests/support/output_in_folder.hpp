// SPDX-License-Identifier: LGPL-2.1-or-later
// A folder of its own for a test of output, and where the figures' Python package is.
#pragma once

#include "support/places.hpp"
#include "support/temporary_folder.hpp"
#include "support/test.hpp"

namespace rollfem::testing {

/// The folder that holds the Python package rollfem.
inline const std::string scripts = std::string(ROLLFEM_SOURCE_DIR) + "/postprocess";

/// `base_` is empty at first and removed at the end.
class InFolder : public ::testing::Test {
 private:
  const TemporaryFolder folder_;

 protected:
  const std::filesystem::path base_ = folder_.path();
};

}  // namespace rollfem::testing
