// SPDX-License-Identifier: LGPL-2.1-or-later
// Rows of cells below the surface of a body that yields: thin at the surface, where friction makes
// steel flow in a thin layer, and growing inwards up to the size of the other cells.
#pragma once

#include <vector>

namespace rollfem::fem {

/// The depth of cells as a function of their even depth, where they would be if all rows were
/// equally high. Within a coarse cell it is a parabola, which quadratic cells of every level follow
/// exactly, so that hanging nodes lie where the larger cell has them.
class GradedDepth {
 public:
  /// Equal rows: depth and even depth are the same.
  GradedDepth() = default;
  /// Rows grow by about 1.4 from the height `first` to `cell` (mm); `at_once`: rows that the
  /// largest cells cover.
  GradedDepth(double first, double cell, int at_once);

  /// mm, and its inverse; the same above the surface.
  double depth(double even) const;
  double even(double depth) const;
  /// Height of a row there relative to that of equal rows.
  double stretch(double even) const;

  bool equal_rows() const { return pieces_.empty(); }
  /// Even depth (mm) below which rows are equal.
  double reach() const { return equal_rows() ? 0.0 : step_ * (pieces_.size() - 1.0); }
  /// Even height (mm) of the largest cells.
  double step() const { return step_; }

 private:
  /// From one multiple of step_ to the next, the last without end.
  struct Piece {
    double depth, stretch;  ///< at its beginning
    double rise;            ///< of the stretch, per mm of even depth
  };
  std::vector<Piece> pieces_;
  double step_ = 0.0;
};

}  // namespace rollfem::fem
