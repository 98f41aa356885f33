// SPDX-License-Identifier: LGPL-2.1-or-later
// A wheel over its rail where the section of either changes along the way: their surfaces in any
// frame, and the locus along which they are closest, from which the gap over y follows as that of
// bodies that do not change (vertical_gap.hpp).
#pragma once

#include "profiles/section_surface.hpp"
#include "scene/patch_geometry.hpp"
#include "track/placement/placement.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace rollfem::track {

/// Origin and directions of a frame in the side frame; z points up, from the rail into the wheel.
struct SurfaceFrame {
  contact::Vector3 origin{}, x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, -1.0};
};

/// Where wheel and rail are closest along x at one y, side frame.
struct LocusPoint {
  double y = 0.0, x = 0.0;                     ///< mm
  double rail_z = 0.0, wheel_z = 0.0;          ///< mm
  double along = 0.0;                          ///< dz/dx of both
  double rail_slope = 0.0, wheel_slope = 0.0;  ///< dz/dy at this x
  double relative_radius = 0.0;  ///< mm, of the parabola along x that is as wide at 0.1 mm
};

/// Height of a surface in some frame, with its slopes by x and y.
struct SlopedHeight {
  double z = -contact::infinity, along = 0.0, across = 0.0;
};

/// The part of a section seen from above (small z), as a height over y.
contact::HeightCurve seen_from_above(const profiles::ProfileCurve& section);

/// Wheel and rail at one position. Surfaces are in the side frame with the rail's origin at the
/// wheel's place along the track.
class BodiesAlongWay {
 public:
  /// One of the two may be empty: that body does not change along its way.
  struct Sections {
    std::shared_ptr<const profiles::SectionSurface> rail;   ///< placed
    std::shared_ptr<const profiles::SectionSurface> wheel;  ///< profile coordinates
    double rail_way = 0.0;     ///< mm, position of the rail's section under the wheel's centre
    double wheel_angle = 0.0;  ///< rad, of the wheel's section that points down
    /// Radius (mm) and axle of a roller, whose sections follow each other along its circle.
    double rail_rolling_radius = contact::infinity;
    contact::Axle rail_axle{};
  };
  /// `rail`, `wheel`: of a body that does not change; `axle`: at height 0 (place_axle).
  BodiesAlongWay(Sections sections, const profiles::ProfileCurve& rail,
                 const profiles::ProfileCurve& wheel, double rolling_radius,
                 const contact::Axle& axle, double tread_y);

  /// The points of the locus by increasing y. Throws contact::SolveError where the wheel is not
  /// above the rail.
  std::vector<LocusPoint> locus() const;

  const contact::Axle& axle() const { return axle_; }
  bool rail_changes() const { return sections_.rail != nullptr; }
  /// Whether heads of the rail begin or end along the track.
  bool heads_end() const { return rail_changes() && sections_.rail->has_ends(); }
  bool wheel_changes() const { return sections_.wheel != nullptr; }
  /// Heights of the rail in a frame; empty where it does not change.
  contact::RailSurface rail_in(const SurfaceFrame& frame) const;
  /// The section of the rail in the plane x = 0 of a frame that is turned about y, near a place of
  /// the side frame, as a curve of y and of z down from the side frame's z = 0.
  profiles::ProfileCurve rail_section(const AlongRail& along) const;
  /// The radius of the wheel; angles are `angle_there` where the wheel's section has angle_here,
  /// and `sign_y` times the axial coordinate is the profile's y; empty where it does not change.
  contact::WheelSurface wheel_around(double angle_here, double angle_there, double sign_y) const;
  /// The angle about the axle of a place of the side frame, from the direction down.
  double angle_of(const contact::Vector3& place) const;
  /// The wheel's profile at that angle.
  profiles::ProfileCurve wheel_section(double angle) const;

 private:
  struct Rail;
  /// Both bodies in a level frame, with the x at which they are compared and the y at which a
  /// section begins another piece.
  struct Level {
    SurfaceFrame frame;
    contact::PatchGeometry bodies;
    double first = 0.0, last = 0.0;  ///< mm, of the rail seen from above
    std::vector<double> rows, pieces;
  };
  struct GapAlong;
  Level level() const;
  SlopedHeight rail_at(const Level& level, double x, double y) const;
  std::optional<LocusPoint> point_at(const Level& level, double y,
                                     const std::vector<std::size_t>& near,
                                     const LocusPoint* before) const;

  Sections sections_;
  std::shared_ptr<const Rail> rail_;
  profiles::ProfileCurve wheel_;  ///< its section that points down
  double rolling_radius_;
  contact::Axle axle_;
  double tread_y_;
};

}  // namespace rollfem::track
