// SPDX-License-Identifier: LGPL-2.1-or-later
// Shape functions of one cell at arbitrary points, and its map to space: what deal.II's FEValues
// does for points that are the same in every cell. Internal to fem/plasticity.
#pragma once

#include "fem/discretisation/body.hpp"

#include <deal.II/fe/fe_values.h>

#include <memory>
#include <optional>
#include <vector>

namespace rollfem::fem {

/// Cells of degree 1 or 2; their map is quadratic, as that of every body.
class CellShape {
 public:
  explicit CellShape(const Body& body);
  void reinit(const dealii::DoFHandler<3>::active_cell_iterator& cell);
  /// Nodes of the displacement.
  unsigned int nodes() const { return static_cast<unsigned int>(order_.size()); }
  /// The unit coordinates of a place; empty outside of the cell.
  std::optional<dealii::Point<3>> inside(const dealii::Point<3>& place) const;
  /// Gradient in space of every node's function at a point in unit coordinates; returns the
  /// determinant of the map.
  double gradients(const dealii::Point<3>& unit, dealii::Tensor<1, 3>* of_node) const;

 private:
  dealii::Tensor<2, 3> jacobian(const dealii::Point<3>& unit, dealii::Point<3>& place) const;

  std::vector<std::array<int, 3>> order_;  ///< of each node of the displacement
  int degree_;
  std::unique_ptr<dealii::FEValues<3>> values_;
  std::array<dealii::Point<3>, 27> places_;
};

}  // namespace rollfem::fem
