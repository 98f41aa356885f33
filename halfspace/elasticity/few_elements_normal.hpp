// SPDX-License-Identifier: LGPL-2.1-or-later
// The normal blocks of one or several patches of few elements that share a load.
#pragma once

#include "contact/base/grid.hpp"
#include "contact/scene/patch_geometry.hpp"
#include "halfspace/elasticity/influence_tables.hpp"

#include <vector>

namespace rollfem::halfspace {

/// One of the patches of FewElementsNormal.
struct NormalBlock {
  const InfluenceTable* table = nullptr;
  contact::ContactGrid grid;
  /// Per row of the grid: component of a pressure along the load.
  const double* carried = nullptr;
  const contact::ContactPlace* place = nullptr;  ///< needed beside other blocks
};

/// For contact::BoundConstrainedCg: displacements along the load, mm, under the forces of the
/// elements along it, N. Fields hold one patch after the other. Patches displace each other by
/// their normal forces (neighbours.hpp) from points at every other element, between which forces
/// and displacements are linear.
class FewElementsNormal {
 public:
  explicit FewElementsNormal(const contact::CombinedMaterial& material) : material_(material) {}

  /// Objects referenced by the blocks must outlive this object.
  void set(const std::vector<NormalBlock>& blocks);

  void apply(const contact::Field& forces, contact::Field& displacement) const;
  /// Self-displacement of an element; element sizes differ between patches.
  void precondition(const contact::Field& residual, contact::Field& result) const;

 private:
  void set_influence(std::size_t to, std::size_t from);
  void add_own(const NormalBlock& block, const double* forces, double* displacement) const;
  static void gather(const NormalBlock& block, const double* forces, std::vector<double>& loads);
  static void spread(const NormalBlock& block, const std::vector<double>& at_points,
                     double* displacement);
  std::size_t pair_of(std::size_t to, std::size_t from) const { return to * blocks_.size() + from; }

  contact::CombinedMaterial material_;
  std::vector<NormalBlock> blocks_;
  std::vector<std::vector<double>> influences_;  ///< per pair of blocks, mm/N between their points
  // Memory of apply().
  mutable std::vector<Source> sources_;
  mutable std::vector<std::vector<double>> loads_;  ///< per block, N at its points
  mutable std::vector<double> at_points_, added_;
};

}  // namespace rollfem::halfspace
