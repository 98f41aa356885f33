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

/// Points found in a body. Same on every process; all functions but the short ones are collective.
class BodyPoints {
 public:
  std::size_t size() const { return place_.size(); }
  /// Where the values are: the point asked for, or where it was moved to.
  const Place& place(std::size_t k) const { return place_[k]; }
  /// How far that is from the point asked for, mm; infinite when there is no cell within reach.
  double moved(std::size_t k) const { return moved_[k]; }
  /// The three components of a nodal field with ghost values at every point. `mirror` are the signs
  /// of the components in the unmeshed half y < 0 of a half body; 0 where there is no cell.
  std::vector<std::array<double, 3>> values(const Vector& field,
                                            const std::array<int, 3>& mirror) const;

 private:
  friend class BodyLocator;
  struct Cell {
    std::vector<dealii::types::global_dof_index> dofs;  ///< empty: another process has the point
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
  /// The body outlives the locator.
  explicit BodyLocator(const Body& body);
  ~BodyLocator();
  /// Points outside by up to `reach` (mm) are moved to the surface of the body: to the nearest
  /// place of a cell along its axes. A half body stands for its mirror image, too. Collective.
  BodyPoints find(const std::vector<Place>& places, double reach) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace rollfem::fem
