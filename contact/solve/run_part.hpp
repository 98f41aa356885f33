// SPDX-License-Identifier: LGPL-2.1-or-later
// One of several parts of a long run that independent calls share.
#pragma once

#include <cstddef>

namespace rollfem::contact {

/// Part `part` (from 0) of `of`: every `of`-th item, so that neighbours, which have similar cost,
/// are distributed.
struct RunPart {
  int part = 0;
  int of = 1;
  bool whole() const { return of == 1; }
  bool holds(std::size_t item) const {
    return item % static_cast<std::size_t>(of) == static_cast<std::size_t>(part);
  }
};

}  // namespace rollfem::contact
