// SPDX-License-Identifier: LGPL-2.1-or-later
// The ends of a segment, through which plastic strain enters and leaves: far from the load nothing
// changes along the streamlines, so that an end moves like the section between it and the load.
#pragma once

#include "fem/discretisation/body_points.hpp"
#include "fem/linear/linear_solver.hpp"

#include <vector>

namespace rollfem::fem {

class EndFlow {
 public:
  /// Arguments must outlive this object. Collective.
  EndFlow(const Body& body, const LinearSolver& solver);
  /// The displacement by which the clamped ends yield to `plastic`, the displacement by plastic
  /// strain found so far, ends included; with ghost values. Collective.
  Vector released(const Vector& plastic) const;

 private:
  struct Node {
    std::array<dealii::types::global_dof_index, 3> dofs;
    SurfaceFrame here, there;  ///< at the end, and in the section
  };
  const Body& body_;
  const LinearSolver& solver_;
  std::vector<Node> nodes_;  ///< of all processes
  BodyPoints sections_;      ///< the places that they follow
};

}  // namespace rollfem::fem
