// SPDX-License-Identifier: LGPL-2.1-or-later
// How a case becomes a step of the history that a case before it has begun.
#pragma once

#include "convert/equivalent.hpp"
#include <optional>

namespace rollfem::convert {

/// Whether `next`, with the load point of a case of which `first` is the equivalent, differs from
/// it in nothing but load, creepages and forces.
bool follows(const Equivalent& first, const Point& point, const Equivalent& next);

/// In a step of T = 1 of module 1, in axes of the track, the patch moves by the change of S, which
/// `before` tells.
void set_way(double before, Equivalent& next);

/// Turns a steady case with its load point into the first step of the transient that `next`
/// continues; empty: `next` does not.
std::optional<Equivalent> steady_start(Equivalent steady, const Equivalent& next);

}  // namespace rollfem::convert
