// The potential contact area: the contact grid about the expected patch of a scene.
#pragma once

#include "halfspace/patch/expected_patch.hpp"

#include <optional>

namespace rollfem::halfspace {

/// Extent in which elements_across are counted: what of expected_patch carries load, without the
/// gaps between several patches; for bodies given point by point the potential contact area.
struct PatchExtent {
  double length = 0.0;  ///< mm, along x
  double width = 0.0;   ///< mm, along y
};
PatchExtent expected_extent(const contact::Scene& scene);

/// Lays grids over one scene, for which the expected patch is looked for once.
class AreaOfPatch {
 public:
  /// The scene must outlive this.
  explicit AreaOfPatch(const contact::Scene& scene) : scene_(scene) {}
  PatchExtent extent() const;  ///< expected_extent
  /// Throws contact::InputError where elements of dx by dy are many times more one way over the
  /// extent than the other: solvers are lost in them.
  void check_shape_of_cells(double dx, double dy) const;
  /// potential_area of elements of dx by dy.
  contact::ContactGrid grid(double dx, double dy, int margin) const;

 private:
  contact::ContactGrid line_grid(double dx, int margin) const;
  const ExpectedPatch& patch() const;
  void check_extent() const;
  void check_extent_of_profiles() const;

  const contact::Scene& scene_;
  mutable std::optional<ExpectedPatch> patch_;
};

/// Potential contact area from the case: the box of expected_patch plus a margin, with elements by
/// [contact_grid]; or as many elements as fit into contact_grid.extent, or into the points of the
/// undeformed distance. `margin`: elements beyond the box on each side.
contact::ContactGrid potential_area(const contact::Scene& scene, int margin = 3);

/// The same with square or given elements of dx by dy.
contact::ContactGrid potential_area(const contact::Scene& scene, double dx, double dy, int margin);

}  // namespace rollfem::halfspace
