// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/count.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rollfem::contact {

int count_of(double number, const char* what) {
  // Written so that NaN is rejected, too.
  if (number >= -largest_count && number <= largest_count) return static_cast<int>(number);
  throw InputError(fmt::format(
      "{}: {} would be needed; allowed: at most {:.0e}; do: give larger steps or cells, or a "
      "smaller extent, and check the units and sections along the way for jumps",
      what, std::isfinite(number) ? fmt::format("{:.4g}", number) : "a number that is not finite",
      largest_count));
}

}  // namespace rollfem::contact
