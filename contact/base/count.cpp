// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/base/count.hpp"

#include "contact/base/errors.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rollfem::contact {

int count_of(double number, const char* what) {
  // Written so that NaN is rejected, too.
  if (number >= -largest_count && number <= largest_count) return static_cast<int>(number);
  if (!std::isfinite(number))
    throw InputError(
        fmt::format("{}: their number is not finite; allowed: finite lengths of all bodies; do: "
                    "check the units "
                    "of radii, profiles and loads, and sections along the way for jumps",
                    what));
  throw InputError(
      fmt::format("{}: {:.4g} would be needed; allowed: at most {:.0e}; do: give larger steps or "
                  "cells, or a smaller extent",
                  what, number, largest_count));
}

}  // namespace rollfem::contact
