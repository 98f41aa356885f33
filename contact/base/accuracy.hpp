// SPDX-License-Identifier: LGPL-2.1-or-later
// The accuracy requested of a result.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rollfem::contact {

struct AccuracyRequest {
  std::optional<double> relative;  ///< largest estimated error; none: whatever the cells give
  std::vector<std::string> of;     ///< quantities by their names in summary.json
};

/// What may be asked: the quantities that are declared so (contact/result/quantities.cpp).
std::vector<std::string> accuracy_words();

}  // namespace rollfem::contact
