// SPDX-License-Identifier: LGPL-2.1-or-later
// Rotates displacement and stress from x, y, z to three unit vectors and back.
#pragma once

#include "contact/result/stress_measures.hpp"

#include <array>

namespace rollfem::contact {

/// Three orthogonal unit vectors.
using Axes = std::array<std::array<double, 3>, 3>;

/// Components along the axes from components in x, y, z.
std::array<double, 3> into_axes(const Axes& axes, const std::array<double, 3>& vector);
Stress into_axes(const Axes& axes, const Stress& stress);

/// Components in x, y, z from components along the axes.
std::array<double, 3> out_of_axes(const Axes& axes, const std::array<double, 3>& vector);
Stress out_of_axes(const Axes& axes, const Stress& stress);

}  // namespace rollfem::contact
