// SPDX-License-Identifier: LGPL-2.1-or-later
// Units of rollfem.h.
#pragma once

#include "contact/base/errors.hpp"

#include <fmt/format.h>

#include "rollfem/rollfem.h"

namespace rollfem::capi {

/// The caller's units in mm and N.
struct Units {
  double length = 1.0;
  double force = 1.0;
  double stress() const { return force / (length * length); }
};

inline Units units_of(rollfem_units units) {
  switch (units) {
    case ROLLFEM_MM_N:
      return {1.0, 1.0};
    case ROLLFEM_M_N:
      return {1e3, 1.0};
    case ROLLFEM_MM_KN:
      return {1.0, 1e3};
  }
  throw contact::InputError(fmt::format(
      "units = {}: is not known; allowed: ROLLFEM_MM_N, ROLLFEM_M_N, ROLLFEM_MM_KN; do: set it to "
      "one of these",
      static_cast<int>(units)));
}

}  // namespace rollfem::capi
