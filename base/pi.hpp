// SPDX-License-Identifier: LGPL-2.1-or-later
// The constant pi, which is not in C++17.
#pragma once

namespace rollfem::contact {

inline constexpr double pi = 3.14159265358979323846;

}  // namespace rollfem::contact
