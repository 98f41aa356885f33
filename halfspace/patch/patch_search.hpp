// SPDX-License-Identifier: LGPL-2.1-or-later
// Locates the contact of a scene's bodies under load before any grid or mesh exists, and lays the
// potential contact area around it.
#pragma once

#include "halfspace/patch/expected_patch.hpp"
#include "halfspace/patch/ridge.hpp"
#include "scene/scene.hpp"

#include <memory>

namespace rollfem::halfspace {

/// Expected position of the patch with the places where the bodies nearly touch, around which
/// bodies are laid out.
struct PatchBox {
  double half_length = 0.0;  ///< mm, to both sides of x = 0
  double half_width = 0.0;   ///< mm, to both sides of y = middle
  double middle = 0.0;       ///< mm
  double half_loaded = 0.0;  ///< mm, half of the width with pressure
  double larger() const { return half_length > half_width ? half_length : half_width; }
  /// Determines the size of cells.
  double smaller() const { return half_length > half_loaded ? half_loaded : half_length; }
};

/// Extent in which elements_across are counted: the loaded part of the expected patch, without the
/// gaps between several patches; for bodies given point by point the potential contact area.
struct PatchExtent {
  double length = 0.0;  ///< mm, along x
  double width = 0.0;   ///< mm, along y
};

/// The search for the patch of one scene under its largest load (normal force or approach), used by
/// every model for the patch, the layout of bodies and grids. It runs at the first request, and not
/// at all if the same contact has been searched before.
class PatchSearch {
 public:
  /// The scene must outlive this object.
  explicit PatchSearch(const contact::Scene& scene, SearchDetail detail = SearchDetail::extents)
      : scene_(scene), detail_(detail) {}

  /// Throws contact::InputError when the patch reaches the end of a profile or the radii make no
  /// elliptic contact, contact::SolveError without contact; so do all other members.
  const ExpectedPatch& patch() const;
  /// For true profiles: the ridge on which the patch was found.
  const Ridge& ridge() const;
  /// For radii, Hertz's ellipse around the origin.
  PatchBox box() const;
  PatchExtent extent() const;

  /// Throws contact::InputError where elements of dx by dy over the extent are many times more
  /// numerous in one direction than in the other: the iterations do not converge on them.
  void check_shape_of_cells(double dx, double dy) const;
  /// Potential contact area of elements of dx by dy: the box of the patch and `margin` elements on
  /// each side; or as many elements as fit into contact_grid.extent, or into the points of the
  /// undeformed distance.
  contact::ContactGrid grid(double dx, double dy, int margin) const;
  /// The same with the elements of [contact_grid].
  contact::ContactGrid grid(int margin = 3) const;
  /// Throws contact::InputError where contact_grid.extent cannot hold the patch, or is far too
  /// large.
  void check_extent() const;

 private:
  contact::ContactGrid line_grid(double dx, int margin) const;
  void check_extent_of_profiles() const;

  const contact::Scene& scene_;
  SearchDetail detail_;
  mutable std::shared_ptr<const ExpectedPatch> patch_;
  mutable std::shared_ptr<const Ridge> ridge_;
};

// Surface of a contact grid of half-spaces: the plane of the patch or the common surface.

/// The scene for the position of the model's contact grid. Throws contact::InputError if the common
/// surface is requested but unknown.
contact::ChartedGeometry halfspace_geometry(const contact::Scene& scene);

}  // namespace rollfem::halfspace
