// SPDX-License-Identifier: LGPL-2.1-or-later
// The surface of a body whose profile changes along its way: a rail over the position along the
// track (crossing, switch), a wheel over the angle about its axle (flat, polygon). Sections
// correspond to each other by features at which parts begin and end; within a part by the fraction
// of its arc length. From section to section every point runs along a cubic spline, so that a
// linear change is exact; beyond the first and the last section nothing changes. A part that only
// some neighbouring sections have, as a nose that begins, exists from the first to the last of
// them.
#pragma once

#include "profiles/irregularity.hpp"
#include "profiles/profile_curve.hpp"

#include <array>
#include <stdexcept>
#include <vector>

namespace rollfem::profiles {

/// A section and where it is.
struct PlacedSection {
  double position = 0.0;  ///< mm along the track, or rad about the axle
  ProfileCurve curve;
  /// Parameters of the curve at which parts end, without its own ends; the same number for each
  /// section, NaN for missing ones. A part exists if both of its ends do; an end of the section
  /// takes the place of the nearest missing feature.
  std::vector<double> features;
};

/// Parameters at which the parts of a section begin and end, NaN of a part that it lacks. Throws
/// std::invalid_argument unless they increase.
std::vector<double> ends_of_parts(const PlacedSection& section);

/// How points run from section to section.
enum class SectionSpline {
  through,  ///< through the sections, natural at both ends
  smooth,   ///< a spline with the sections as coefficients: kinks along the way are rounded
};

/// A point of the surface with its derivatives by the way u (mm or rad) and the parameter v.
struct SurfacePoint {
  double y = 0.0, z = 0.0;                ///< mm, coordinates of the profile
  double y_way = 0.0, z_way = 0.0;        ///< by u
  double y_across = 0.0, z_across = 0.0;  ///< by v
};

/// The surface as a height over the way and y: z, dz/du and dz/dy, and the parameter.
struct SurfaceHeight {
  double z = 0.0, by_way = 0.0, by_y = 0.0;
  double parameter = 0.0;
};

/// Thrown where the way between two sections is too short for their difference; the text names a
/// remedy.
struct SectionsTooClose : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

class SectionSurface {
 public:
  /// At least two sections with increasing positions. `turn`: the way after which a wheel repeats,
  /// 2 pi, otherwise 0; sections over all of it end with the first one. Throws
  /// std::invalid_argument.
  SectionSurface(std::vector<PlacedSection> sections, SectionSpline spline, double turn = 0.0);

  SurfacePoint at(double way, double parameter) const;
  /// The parts of the section that exist there, with the parameters of this surface.
  ProfileCurve section(double way) const;
  /// The surface at this y near the parameter `start`, by Newton's method; false where the section
  /// is steeper than a height curve allows or there is none.
  bool height(double way, double y, double start, SurfaceHeight& found) const;
  /// Rotated and shifted in the plane of the sections, as ProfileCurve::moved.
  SectionSurface moved(double angle, double y, double z) const;
  /// With this height added to z of every point, before later moves; instead of another one.
  SectionSurface with(Irregularity irregularity) const;
  const Irregularity& irregularity() const { return irregularity_; }

  bool has_parameter(double parameter) const {
    return parameter >= parameter_.front() && parameter <= parameter_.back();
  }
  /// Whether the part of this parameter does so there.
  bool exists(double way, double parameter) const;
  bool has_ends() const { return !presence_.empty(); }  ///< some part does not exist everywhere
  double first() const { return given_[0]; }            ///< of the given sections
  double last() const { return given_[1]; }
  std::size_t sections() const { return count_; }

 private:
  /// Values at the nodes, section by section: a coordinate and its derivative by the parameter,
  /// and the derivatives of both by the way.
  struct Nodes {
    std::vector<double> value, across, value_way, across_way;
  };
  /// `having`: the first and the last section that have each node.
  void run_along_way(SectionSpline spline, const std::vector<std::array<std::size_t, 2>>& having,
                     Nodes& nodes) const;
  /// Throws SectionsTooClose.
  void check_way(const std::vector<std::array<std::size_t, 2>>& having, const Nodes& nodes) const;
  bool closed() const { return way_.front() < given_[0]; }  ///< a wheel described all around
  double within_turn(double way) const;
  double known_way(double way) const;

  std::vector<double> way_, parameter_;
  std::array<double, 2> given_{};
  std::size_t count_ = 0;
  double turn_ = 0.0;
  Nodes y_, z_;
  /// From which way to which the part of each node exists; empty where all do everywhere.
  std::vector<std::array<double, 2>> presence_;
  Irregularity irregularity_;
  std::array<double, 2> outwards_{0.0, 1.0};  ///< y and z of the direction in which it is added
};

}  // namespace rollfem::profiles
