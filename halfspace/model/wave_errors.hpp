// SPDX-License-Identifier: LGPL-2.1-or-later
// Waves of rough profiles that are too short for the elements of a grid: what they cost, found on
// elements a quarter as wide, and a sentence for the reader.
#pragma once

#include "contact/result/result.hpp"

#include <optional>
#include <string>

namespace rollfem::halfspace {

/// How much numbers change without friction where elements are a quarter as wide, absolute.
struct WaveErrors {
  double max_pressure = 0.0;    ///< MPa
  double approach = 0.0;        ///< mm
  double normal_force = 0.0;    ///< N; under a given approach
  double contact_area = 0.0;    ///< mm^2
  double length = 0.0;          ///< mm, of the patch
  double width = 0.0;           ///< mm
  double elastic_energy = 0.0;  ///< N mm
};

/// Of load point k, solved on `grid` as `point`. Nothing where the elements follow the profiles, or
/// where there are none.
std::optional<WaveErrors> wave_errors(const contact::Scene& scene, std::size_t k,
                                      const contact::ContactGrid& grid,
                                      const contact::PointResult& point);

/// A warning with the cells that would do; empty where these do.
std::string wave_warning(const contact::ContactGrid& grid, const contact::PointResult& point,
                         const WaveErrors& errors);

}  // namespace rollfem::halfspace
