// SPDX-License-Identifier: LGPL-2.1-or-later
// The strip model: the normal problem strip by strip after Hertz from the penetration of the
// profiles, and friction by brushes with Kalker's stiffness and a parabolic bound along each strip.
// The method of WheelsetContact in the 2012 study; works for any undeformed distance across the
// patch.
#pragma once

#include "theories/brush.hpp"
#include "theories/elliptic_patch.hpp"

#include <optional>
#include <vector>

namespace rollfem::theories {

struct StripOptions {
  int strips = 100;
  int strip_elements = 100;
  /// Ratio of virtual penetration to approach; unset: Hertz's ellipse.
  std::optional<double> virtual_penetration;
};

/// Two profiles as strips of equal width: undeformed distance h(x, y) = z(y) + A(y) (x - x_m(y))^2.
struct StripProfile {
  double y_first = 0.0;           ///< mm, middle of the first strip
  double width = 0.0;             ///< mm
  std::vector<double> distance;   ///< z, mm, any origin
  std::vector<double> curvature;  ///< A > 0, 1/mm, 1/(2 R_x)
  std::vector<double> middle{};   ///< x_m, mm; empty: 0, without yaw

  int size() const { return static_cast<int>(distance.size()); }
  double y(int j) const { return y_first + j * width; }
};

/// A run of strips in contact and its equivalent ellipse: same depth and volume as the penetration,
/// with the longitudinal curvature of the deepest strip.
struct StripPatch {
  int first = 0;  ///< strips first .. last
  int last = 0;
  int deepest = 0;
  double y_lower = 0.0;       ///< mm, edges interpolated between the strips
  double y_upper = 0.0;       ///< mm
  double semi_axis_x = 0.0;   ///< mm, of the ellipse
  double semi_axis_y = 0.0;   ///< mm
  double max_pressure = 0.0;  ///< MPa
  double approach = 0.0;      ///< mm, of the ellipse alone
};

struct StripNormalSolution {
  std::vector<double> half_length;   ///< a(y) per strip, mm, 0 out of contact
  std::vector<double> max_pressure;  ///< p0(y) per strip, MPa: elliptic along the strip
  std::vector<StripPatch> patches;
  double penetration = 0.0;   ///< mm, deepest penetration of the undeformed profiles
  double normal_force = 0.0;  ///< N
  double approach = 0.0;      ///< mm, of the patch with the deepest penetration
};

/// Relation between the size of a patch and the penetration of the profiles.
struct StripLaw {
  double contact_modulus = 0.0;  ///< E*, MPa
  /// Ratio of virtual penetration to approach; unset: Hertz's ratio for the ellipse of the same
  /// depth and volume.
  std::optional<double> virtual_penetration = {};
};

/// Half length of a strip a(y) = sqrt(g(y)/A'), its pressure p0(y) proportional to A(y) a(y), from
/// the penetration g of the profiles. The penetration, A' and the factor of the pressure are
/// Hertz's for the equivalent ellipse of each patch, so that an elliptic contact agrees with Hertz;
/// treating each strip as a line contact would be too soft. `penetration` mm.
///
/// With a virtual penetration (Kik and Piotrowski 1996; Piotrowski and Chollet 2005) the approach
/// is the penetration divided by its ratio, and the pressure kappa sqrt(a(y)^2 - x^2) displaces the
/// surfaces by the approach at the deepest point: more strips touch than by their own shape. The
/// half lengths are scaled so that the extents have the ratio of Hertz's ellipse of the same width
/// and depth.
StripNormalSolution strips_at_penetration(const StripProfile& profile, const StripLaw& law,
                                          double penetration);

/// The same for a normal force in N. Throws contact::SolveError when the patch reaches the end of
/// the profile or no penetration carries the force.
StripNormalSolution strips_for_force(const StripProfile& profile, const StripLaw& law,
                                     double normal_force);

/// The same for an approach in mm, defined by the patch with the deepest penetration.
StripNormalSolution strips_for_approach(const StripProfile& profile, const StripLaw& law,
                                        double approach);

/// Half length and pressure at any y by interpolation of their squares, which are linear at edges.
struct StripSection {
  double half_length = 0.0;
  double max_pressure = 0.0;
  double middle = 0.0;
};
StripSection strip_section(const StripProfile& profile, const StripNormalSolution& solution,
                           double y);

/// The model "strip": the traction bound of a strip is the parabola with the friction force of its
/// pressure, 3 pi/8 mu p0(y) in the middle. Extra rigid slip is allowed. error_estimate covers the
/// resolution only.
contact::ModelResult run_strip(const contact::Scene& scene, const contact::Progress& progress);
contact::ModelInfo strip_model();

}  // namespace rollfem::theories
