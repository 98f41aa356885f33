// SPDX-License-Identifier: LGPL-2.1-or-later
// Results of a wheel on its rail: patches and their sums. mm, N, MPa, rad; track frame:
// x along the track, y to the right, z down.
#pragma once

#include "contact/result/result.hpp"
#include "track/search/contact_search.hpp"

#include <array>
#include <cstddef>

namespace rollfem::capi {

/// Resultants of the tractions of a patch on the wheel, in the patch frame, or their derivatives.
struct PatchSums {
  double longitudinal = 0.0, lateral = 0.0, normal = 0.0;  ///< N
  double lateral_pressure = 0.0;                           ///< N
  double spin_moment = 0.0;                                ///< N mm
};

/// Results of a patch; signs and frame as in contact::PointResult.
struct PatchForces {
  contact::Creepage creepage;
  double normal_force = 0.0, longitudinal_force = 0.0, lateral_force = 0.0;  ///< N
  double lateral_pressure = 0.0;                                             ///< N
  double spin_moment = 0.0;                                                  ///< N mm
  double length = 0.0, width = 0.0;                                          ///< mm
  double area = 0.0, adhesion_area = 0.0;                                    ///< mm^2
  double max_pressure = 0.0, max_pressure_bar = 0.0;                         ///< MPa
  double creepage_work = 0.0;                                                ///< N, T-gamma
};

struct SolvedPatch {
  PatchForces forces;
  std::array<double, 3> origin{};  ///< contact point, track frame, mm
  double contact_angle = 0.0;      ///< rad
  double rolling_radius = 0.0;     ///< mm
  std::array<double, 3> force{};   ///< on the wheel, track frame, N
};

/// Force (N) and moment about the middle of the axle (N mm), track frame.
struct Wrench {
  std::array<double, 3> force{};
  std::array<double, 3> moment{};
};

struct SolvedWheel {
  static constexpr std::size_t most_patches = 4;
  std::size_t count = 0;                          ///< of listed patches
  std::size_t unlisted = 0;                       ///< further ones, which count in the sums only
  std::array<SolvedPatch, most_patches> patches;  ///< the most loaded first
  Wrench sum;
  double creepage_work = 0.0;  ///< N
  double roll = 0.0;           ///< rad, given or found
  double height = 0.0;         ///< mm, at which the wheel just touches, unloaded
  double penetration = 0.0;    ///< mm, depth of the wheel below that
};

/// Resultants of a patch in the track frame.
inline Wrench wrench_of(const track::WheelRailContact& contact, const PatchSums& sums) {
  Wrench wrench;
  contact::Vector3 arm{};
  for (int d = 0; d < 3; ++d) {
    wrench.force[d] = sums.longitudinal * contact.along[d] + sums.lateral * contact.across[d] +
                      sums.normal * contact.normal[d];
    arm[d] = contact.origin[d] - contact.axle.point[d];
  }
  wrench.moment = contact::cross(arm, wrench.force);
  for (int d = 0; d < 3; ++d) wrench.moment[d] += sums.spin_moment * contact.normal[d];
  return wrench;
}

inline void add(const Wrench& wrench, double factor, Wrench& sum) {
  for (int d = 0; d < 3; ++d) {
    sum.force[d] += factor * wrench.force[d];
    sum.moment[d] += factor * wrench.moment[d];
  }
}

}  // namespace rollfem::capi
