// SPDX-License-Identifier: LGPL-2.1-or-later
// Flats, polygons, corrugation and dips in closed form: heights over the way, exact at their edges
// (docs/profiles.md).
#pragma once

#include "case/case.hpp"
#include "scene/height_curve.hpp"

#include <functional>

namespace rollfem::profiles {

/// What is added to z of every point of a profile over the way, which is in mm along the track or
/// in rad about the axle.
struct Irregularity {
  /// mm, with its derivative by the way, at an edge that of one side; empty: none.
  std::function<contact::CurveValue(double way)> height;
  double shortest = contact::infinity;  ///< way: of its shortest wave, flat or dip
};

/// Of the wheel over the angle, negative at a flat.
Irregularity irregularity_of(const contact::Wheel& wheel);
/// Of the rail along the track, positive in a dip.
Irregularity irregularity_of(const contact::Rail& rail);

}  // namespace rollfem::profiles
