// SPDX-License-Identifier: LGPL-2.1-or-later
// The outline of a wheel seen along the rail.
//
// A straight rail is the same at every x, so wheel and rail touch where the rail touches the
// outline of the wheel seen along x: for every point of the wheel's profile, the point of its
// circle whose normal has no x component. With yaw that point lies ahead of or behind the axle;
// without yaw the outline is the profile itself. Along a roller, its circles take the place of x:
// the normal has no component along them, and heights are radial, from the roller's radius at z =
// 0.
//
// The vertical gap between the outline of a wheel and the rail under it, and its minima. Sinking of
// the wheelset changes this gap by a constant, so its minima are the points of first contact for
// any height: their tangents are parallel.
#pragma once

#include "profiles/profile_curve.hpp"
#include "scene/patch_geometry.hpp"
#include "track/placement/along_way.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace rollfem::track {

/// A point of the outline in the side frame.
struct OutlinePoint {
  AlongRail along;         ///< from the top of the rail
  double y = 0.0;          ///< mm
  double z = 0.0;          ///< mm, over a roller radial
  double profile_y = 0.0;  ///< mm, wheel profile coordinate
  double radius = 0.0;     ///< mm, of its circle
  /// mm, of the undeformed distance along x (LocusPoint): that of both circles.
  double relative_radius = 0.0;
};

/// Points of a wheel's profile, dense enough for an outline at any pose.
struct WheelPoints {
  std::vector<profiles::ProfilePoint> points;
  std::size_t start = 0;  ///< the first one from the place on the tread on
};
/// `tread_y`: of a place on the tread, from where the outline is followed to both sides.
WheelPoints wheel_points(const profiles::ProfileCurve& wheel, double tread_y);

class Silhouette {
 public:
  /// `wheel` in profile coordinates; `axle` with axial coordinate = profile y (placement.hpp).
  /// Throws std::invalid_argument when no part of the profile is visible.
  Silhouette(const WheelPoints& wheel, double rolling_radius, const contact::Axle& axle,
             double roller_axle_z);
  /// The wheel over its locus, for bodies that change along the way.
  Silhouette(const std::vector<LocusPoint>& locus, const contact::Axle& axle);

  /// z over y; covers the part not steeper than a height curve allows.
  const contact::HeightCurve& curve() const { return curve_; }
  /// The point of the outline at this y of the side frame.
  OutlinePoint at(double y) const;

 private:
  contact::HeightCurve curve_;
  std::vector<double> x_;          ///< mm, at the knots of the curve
  std::vector<double> profile_y_;  ///< mm, of the wheel's profile
  std::vector<LocusPoint> locus_;  ///< of bodies that change along the way
  contact::Axle axle_;
  double roller_axle_z_;
};

/// A local minimum of the gap.
struct GapMinimum {
  double y = 0.0;                  ///< mm, side frame
  double gap = contact::infinity;  ///< mm, vertical
  double slope = 0.0;  ///< dz/dy of both tangents, < 0 where they fall towards the middle
  double along = 0.0;  ///< dz/dx of both: on a roller, or where the rail changes along the track
  /// Cosine of the angle between normal and vertical.
  double cosine() const { return 1.0 / std::sqrt(1.0 + slope * slope + along * along); }
  /// Contact angle, rad: positive where the surfaces fall towards the middle of the track.
  double angle() const;
};

/// An end of the known profiles of wheel and rail at which the gap still decreases.
enum class GapEnd { none, inner, outer };

class VerticalGap {
 public:
  /// `rail`: its head in the side frame (rail_heights). Throws contact::SolveError when the wheel
  /// is not above it.
  VerticalGap(const WheelPoints& wheel, double rolling_radius, const contact::Axle& axle,
              const contact::HeightCurve& rail, double roller_axle_z = contact::infinity);

  /// The gap over the locus of bodies that change along the way.
  explicit VerticalGap(std::shared_ptr<const BodiesAlongWay> bodies);
  /// These bodies; none of bodies that do not change.
  const std::shared_ptr<const BodiesAlongWay>& bodies() const { return bodies_; }

  /// Lowers the wheel by `way` mm. Heights from wheel() keep their previous values.
  void lower_wheel(double way);

  /// Rail z less wheel z, with derivatives by y; positive where the wheel is above the rail.
  contact::CurveValue at(double y) const;
  /// The same, and dz/dy of the common surface, the mean of both.
  struct WithSurface {
    contact::CurveValue gap;
    double slope = 0.0;
  };
  WithSurface with_surface(double y) const;
  double first() const { return first_; }  ///< mm, start of the y range of both
  double last() const { return last_; }    ///< mm, end of the y range of both

  /// All local minima, in order of y.
  const std::vector<GapMinimum>& minima() const { return minima_; }
  /// The lowest of them, the first if there are several; infinitely high if the gap is infinite.
  GapMinimum lowest() const;
  /// Smallest gap, minima and ends taken together, mm.
  double smallest() const;
  /// Whether the smallest gap is at an end.
  GapEnd end() const;
  /// Largest gap between two y and its position, mm.
  std::array<double, 2> largest_between(double lower, double upper) const;
  /// The interval about `y` in which the gap is below `limit`, kept to [lower, upper].
  std::array<double, 2> below(double limit, double y, double lower, double upper) const;

  /// From the first to the last y in [lower, upper] with a gap below `limit`, regardless of the gap
  /// between them; {y, y} if there is no such y. `y`: a point below the limit, or the closest to
  /// it.
  std::array<double, 2> span_below(double limit, double y, double lower, double upper) const;

  const contact::HeightCurve& rail() const { return rail_; }
  const Silhouette& wheel() const { return wheel_; }

 private:
  VerticalGap(std::shared_ptr<const BodiesAlongWay> bodies, const std::vector<LocusPoint>& locus);
  void find_minima();

  std::shared_ptr<const BodiesAlongWay> bodies_;
  contact::HeightCurve gap_, climb_;  ///< over the locus: the gap, and climb_over_y
  Silhouette wheel_;
  contact::HeightCurve rail_;
  double first_ = 0.0;
  double last_ = 0.0;
  double lowered_ = 0.0;
  std::vector<double> places_;               ///< knots of both, mm
  std::vector<contact::CurveValue> values_;  ///< gap there
  std::vector<GapMinimum> minima_;
};

/// The head of a placed rail as z over y: the part about its highest point.
contact::HeightCurve rail_heights(const profiles::ProfileCurve& rail);

/// A rail with several heads as z over y: the parts about these places (RailPlace), joined by steep
/// walls. A higher part hides what it overhangs.
contact::HeightCurve rail_heights(const profiles::ProfileCurve& rail,
                                  const std::vector<double>& tops_and_grooves);

}  // namespace rollfem::track
