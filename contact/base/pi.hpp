// The circle's constant, which C++17 does not have.
#pragma once

namespace rollfem::contact {

inline constexpr double pi = 3.14159265358979323846;

}  // namespace rollfem::contact
