// The accuracy that is asked of a result.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rollfem::contact {

struct AccuracyRequest {
  std::optional<double> relative;  ///< largest estimated error; none: whatever the cells give
  std::vector<std::string> of;     ///< quantities by their names in summary.json
};

}  // namespace rollfem::contact
