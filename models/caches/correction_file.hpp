// SPDX-License-Identifier: LGPL-2.1-or-later
// The smooth parts of wheel and rail (halfspace/elasticity/smooth_map.hpp) as
// named values, for files and for other processes.
#pragma once

#include "halfspace/elasticity/smooth_map.hpp"
#include "postprocess/hdf5/named_values.hpp"

#include <string>

namespace rollfem::modelling {

postprocess::NamedValues values_of(const halfspace::SmoothParts& parts);
/// Throws std::runtime_error when a value is missing or has the wrong shape.
halfspace::SmoothParts parts_of(const postprocess::NamedValues& values);

/// All values as bytes in this machine's byte order.
std::string packed(postprocess::NamedValues values);
postprocess::NamedValues unpacked(const std::string& bytes);

}  // namespace rollfem::modelling
