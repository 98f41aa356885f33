// SPDX-License-Identifier: LGPL-2.1-or-later
// The half-space on few elements, for which sums over the elements are faster than transforms: the
// blocks for the contact solvers without memory allocation, from influence coefficients computed
// once (influence_tables.hpp).
#pragma once

#include "base/grid.hpp"
#include "contact/iteration/compliance.hpp"
#include "contact/iteration/linearisation.hpp"
#include "halfspace/elasticity/influence_tables.hpp"
#include "scene/patch_geometry.hpp"

#include <Eigen/Core>

#include <vector>

namespace rollfem::halfspace {

/// T = D A_tt between the elements in contact as a matrix, preconditioned by the exact inverse of
/// the Jacobian of each row of elements along rolling.
class FewElementsRolling : public contact::ElementOperator {
 public:
  /// For grids of nx by ny elements.
  FewElementsRolling(int nx, int ny, int most_elements);

  /// Sets the elements under pressure. `weights`: contact::upwind_weights; `layer`: compliance of a
  /// layer between the bodies over dx, 1/MPa. False when there are none, more than `most_elements`
  /// or too many in a row.
  bool set(const InfluenceTable& table, const contact::Field& pressure,
           const contact::Field& weights, double layer = 0.0);
  /// Their indices on the grid.
  const std::vector<Eigen::Index>& grid_indices() const { return places_; }

  double diagonal() const override { return diagonal_; }
  void apply(const Given& p, Vector result) override;
  /// -du/dx by central differences, without a layer.
  void central_slip(const InfluenceTable& table, const Given& p, Vector result) const;
  void linearise(const contact::Linearisation& at, double r, double drag) override;
  void precondition(const Given& p, Vector result) override;

 private:
  static constexpr int most_in_row = ElementSums::most_rows / 2;
  using Index = Eigen::Index;

  using Block = Eigen::Matrix<double, 2 * most_in_row, 2 * most_in_row, Eigen::RowMajor>;

  /// Elements of one row of the grid, and the inverse of their Jacobian; that of a row that adheres
  /// is kept.
  struct Row {
    Index first = 0;
    Index length = 0;
    bool adheres = false;
    double kept_for = 0.0;  ///< r of `adhering`
    Block inverse, adhering;
    const Block& used() const { return adheres ? adhering : inverse; }
  };

  bool gather(const contact::Field& pressure);
  void fill_matrix(const InfluenceTable& table, const contact::Field& weights);
  void add_layer(double layer, const contact::Field& weights);
  void fill_jacobian(const Row& row, Block& to, const contact::Linearisation& at, double r,
                     double drag) const;

  int nx_, ny_;
  Index most_;
  Index count_ = 0;
  double diagonal_ = 1.0;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> matrix_;
  std::vector<Index> places_;
  std::vector<Row> rows_;  ///< the first rows_in_use_ are in use
  std::size_t rows_in_use_ = 0;
};

// The normal blocks of one or several patches of few elements that share a load.

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
class FewElementsNormal : public contact::NormalMap {
 public:
  explicit FewElementsNormal(const contact::CombinedMaterial& material) : material_(material) {}

  /// Objects referenced by the blocks must outlive this object.
  void set(const std::vector<NormalBlock>& blocks);

  void apply(const contact::Field& forces, contact::Field& displacement) const override;
  /// Self-displacement of an element; element sizes differ between patches.
  void precondition(const contact::Field& residual, contact::Field& result) const override;

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
