// SPDX-License-Identifier: LGPL-2.1-or-later
// Arbitrary points of a finite-element body: the cell that contains each, and nodal fields there.
#pragma once

#include "fem/discretisation/body.hpp"

#include <array>
#include <memory>
#include <vector>

namespace rollfem::fem {

using Place = std::array<double, 3>;  ///< x, y, z in mm, global frame

class BodyLocator;

/// Points located in a body. Same on every process; all functions except the inline ones are
/// collective.
class BodyPoints {
 public:
  std::size_t size() const { return place_.size(); }
  /// Position of the values: the requested point, or the one to which it was moved.
  const Place& place(std::size_t k) const { return place_[k]; }
  /// Distance from the requested point, mm; infinite without a cell within reach.
  double moved(std::size_t k) const { return moved_[k]; }
  /// The three components of a nodal field with ghost values at every point. `mirror` are the signs
  /// of the components in the unmeshed half y < 0 of a half body; 0 without a cell.
  std::vector<std::array<double, 3>> values(const Vector& field,
                                            const std::array<int, 3>& mirror) const;

 private:
  friend class BodyLocator;
  struct Cell {
    std::vector<dealii::types::global_dof_index> dofs;  ///< empty: point of another process
    std::vector<double> shape;                          ///< of the nodes
    bool mirrored = false;
  };
  const Body* body_ = nullptr;
  std::vector<Place> place_;
  std::vector<double> moved_;
  std::vector<Cell> cells_;
};

class BodyLocator {
 public:
  /// The body must outlive the locator.
  explicit BodyLocator(const Body& body);
  ~BodyLocator();
  /// Points outside by up to `reach` (mm) are moved to the surface of the body: to the nearest
  /// point of a cell along its axes. A half body also represents its mirror image. Collective.
  BodyPoints find(const std::vector<Place>& places, double reach) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace rollfem::fem
