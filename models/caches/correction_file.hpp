// SPDX-License-Identifier: LGPL-2.1-or-later
// The smooth parts of wheel and rail (halfspace/elasticity/smooth_map.hpp) as bytes in this
// machine's byte order, for the cache and for other processes.
#pragma once

#include "halfspace/elasticity/smooth_map.hpp"

#include <string>

namespace rollfem::modelling {

std::string packed(halfspace::SmoothParts parts);
/// Throws std::runtime_error when the bytes are those of something else.
halfspace::SmoothParts unpacked(const std::string& bytes);

}  // namespace rollfem::modelling
