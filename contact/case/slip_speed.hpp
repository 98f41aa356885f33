// SPDX-License-Identifier: LGPL-2.1-or-later
// The velocity by which slip becomes the slip velocity that a friction law takes.
#pragma once

#include "contact/case/case.hpp"

namespace rollfem::contact {

/// Slip velocity over slip as results give it, mm/s: the rolling speed. A shift has none: its slip
/// in mm is taken as that of one second.
inline double slip_speed(const Rolling& rolling) {
  return rolling.problem == Problem::shift ? 1.0 : rolling.speed;
}

}  // namespace rollfem::contact
