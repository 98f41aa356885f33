// SPDX-License-Identifier: LGPL-2.1-or-later
// The accuracy requested of a result.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rollfem::contact {

struct AccuracyRequest {
  std::optional<double> relative;  ///< largest estimated error; none: no refinement
  std::vector<std::string> of;     ///< quantities by their names in summary.json
};

}  // namespace rollfem::contact
