// SPDX-License-Identifier: LGPL-2.1-or-later
// Markers of CONTACT on the track: rail and wheel profile, wheelset. Axes x forward, y to the
// right, z down. The track's origin moves with the wheelset.
#pragma once

#include "bindings/contact/problem.hpp"

#include <Eigen/Geometry>

namespace rollfem::addon {

struct Marker {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();     ///< mm, on the track
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns, on the track
  double roll = 0.0, yaw = 0.0;                        ///< rad
  Eigen::Vector3d seen(const Eigen::Vector3d& point) const {
    return axes.transpose() * (point - place);
  }
};

struct Markers {
  Marker rail, wheel, wheelset;
};
Markers markers_of(const Problem& problem, const Patch& patch);

/// The contact reference point on the track, and the angle from z to the contact's normal (down).
Eigen::Vector3d reference_of(const Patch& patch);
double angle_of(const Patch& patch);

/// Force on the wheel, N, and moment about the track's origin, N mm.
struct TrackForce {
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
  Eigen::Vector3d about(const Eigen::Vector3d& place) const { return moment - place.cross(force); }
};
TrackForce force_of(const Patch& patch);

/// mm, centre of the pressure on the track.
Eigen::Vector3d pressure_centre(const Patch& patch);

}  // namespace rollfem::addon
