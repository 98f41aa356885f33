// The model "halfspace": Kalker's problem on the case's contact grid for every load point.
#pragma once

#include "contact/base/checkpoint.hpp"
#include "contact/solve/contact_run.hpp"
#include "contact/solve/model.hpp"
#include "halfspace/model/expected_patch.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>

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

/// The half-space on a grid, with its stand-in for unlike materials.
std::unique_ptr<contact::Elasticity> halfspace_elasticity(const contact::Scene& scene,
                                                          const contact::ChartedGeometry& geometry,
                                                          const contact::ContactGrid& grid);

/// What elasticity the grids of a model have: the half-space's, or one that a half-space
/// preconditions.
struct GridElasticity {
  std::string model = "halfspace";  ///< in progress events and names of records
  bool same_normal_block = true;    ///< contact::RunOptions
  std::function<std::unique_ptr<contact::Elasticity>(
      const contact::Scene&, const contact::ChartedGeometry&, const contact::ContactGrid&)>
      make = halfspace_elasticity;
  /// Adds stresses below the surface to a load point solved on the grid; empty: those that the
  /// scene asks for, of half-spaces.
  std::function<void(const contact::ContactGrid&, contact::PointResult&)> add_stresses = {};
};

/// Solves every load point; enlarges the grid when the patch touches its border; runs at a half and
/// a quarter of the resolution give the error bars, the former also the first guess. Stresses below
/// the surface as the case asks for them. Load points of the finest grid are kept in the
/// `checkpoint` and taken up from there (null: none).
contact::ModelResult run_halfspace(const contact::Scene& scene, const contact::Progress& progress,
                                   contact::Checkpoint* checkpoint = nullptr,
                                   const GridElasticity& elasticity = {});

}  // namespace rollfem::halfspace
