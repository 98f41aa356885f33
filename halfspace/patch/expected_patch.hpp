// SPDX-License-Identifier: LGPL-2.1-or-later
// Where half-spaces in the shape of a scene's bodies touch under load: Hertz's ellipse for radii,
// coarse solutions of a few milliseconds for true profiles and bodies given point by point.
#pragma once

#include "halfspace/patch/ridge.hpp"
#include "result/patch_size.hpp"
#include "scene/scene.hpp"

#include <array>
#include <vector>

namespace rollfem::halfspace {

/// Bounding box of the patch in the patch frame; it need not be an ellipse nor centred at the
/// origin, and may hold several regions. Approximate: extents to 1 %, area to 2 %, pressure and
/// approach to 0.5 %.
struct ExpectedPatch : contact::PatchSize {
  double x_centre = 0.0, y_centre = 0.0;  ///< mm, of the pressure
  double approach = 0.0;                  ///< mm
  double max_pressure = 0.0;              ///< MPa
  double normal_force = 0.0;              ///< N
  /// Ranges of y with pressure, mm: the first begins at y_lower, the last ends at y_upper.
  std::vector<std::array<double, 2>> loaded;
  double gaps = 0.0;  ///< mm, of the width: unloaded rows between regions
  Box near;           ///< mm, with the places where the bodies nearly touch (ridge.hpp)
  /// mm, loaded extents along x and y: 6/5 (integral f)^2 / integral f^2 of the load f per mm, the
  /// axes of an ellipse under Hertz's pressure. Unlike the box, they change continuously while
  /// patches appear, join and vanish.
  double carrying_length = 0.0, carrying_width = 0.0;

  double covered_width() const { return width - gaps; }  ///< mm, of all regions together
};

/// Depth of the search of true profiles. The sizes that determine elements or bodies must change
/// continuously with the bodies: the last solution is on a fine lattice that moves with them. A
/// grid of given elements needs only a box, which it checks itself: that takes half the time.
enum class SearchDetail { box, extents };

/// Under the largest load of the scene. Throws contact::InputError when the patch reaches the end
/// of a profile or the radii make no elliptic contact, contact::SolveError without contact.
ExpectedPatch patch_of_profiles(const contact::Scene& scene, const Ridge& ridge,
                                SearchDetail detail);
ExpectedPatch patch_of_points(const contact::Scene& scene);
ExpectedPatch patch_of_ellipse(const contact::Scene& scene);

/// Throws contact::InputError "profile too short for the contact" when one of the profiles of the
/// patch ends between y_lower and y_upper, mm.
void check_profiles_reach(const contact::Scene& scene, double y_lower, double y_upper);

}  // namespace rollfem::halfspace
