// SPDX-License-Identifier: LGPL-2.1-or-later
// Waves of rough profiles that are too short for the elements of a grid: the resulting error, from
// elements a quarter as wide, and a warning for the reader.
#pragma once

#include "result/result.hpp"
#include "scene/scene.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace rollfem::halfspace {

/// Absolute change of frictionless results with elements a quarter as wide, by name of quantity.
using WaveErrors = std::map<std::string, double>;

/// For load point k, solved on `grid` as `point`. Empty where the elements follow the profiles, or
/// without profiles.
std::optional<WaveErrors> wave_errors(const contact::Scene& scene, std::size_t k,
                                      const contact::ContactGrid& grid,
                                      const contact::PointResult& point);

/// Effect of the points' rounding (ProfileCurve::rounding) on frictionless results, by name of
/// quantity; empty without. Fitted to circles of 80 and 300 mm written with four decimals, their
/// points 0.005 to 0.5 mm apart.
WaveErrors rounding_errors(const contact::Scene& scene, const contact::ContactGrid& grid,
                           const contact::PointResult& point);

/// A warning with sufficiently small cells; empty if the cells are sufficient.
std::string wave_warning(const contact::ContactGrid& grid, const contact::PointResult& point,
                         const WaveErrors& errors);

}  // namespace rollfem::halfspace
