// SPDX-License-Identifier: LGPL-2.1-or-later
// The nodes of a body as points of hexahedra for output: collected once, so that displacement and
// stress of every load point only need to be gathered.
#pragma once

#include "fem/discretisation/body.hpp"
#include "fem/stress/stress_recovery.hpp"
#include "result/result.hpp"

#include <string>
#include <vector>

namespace rollfem::fem {

class BodyNodes {
 public:
  /// The body must outlive this object. Collective.
  BodyNodes(const Body& body, const std::string& name);
  /// The whole body on process 0, mirrored when half of it is modelled; every cell becomes degree^3
  /// hexahedra. Points and cells are in the same order on any number of processes. On other
  /// processes it has only a name.
  const contact::BodyField& mesh() const { return mesh_; }
  /// Values at the points of mesh(); empty except on process 0. All arguments with ghost values;
  /// `yielded` may be null. Collective.
  contact::BodyValues values(const Vector& displacement, const NodalStress& stress,
                             const YieldedFields* yielded = nullptr) const;

 private:
  struct Cells;
  Cells collect_cells();
  void number(const std::vector<Cells>& processes);
  void mirror();
  /// Vectors or symmetric tensors at the points of mesh().
  template <std::size_t N>
  std::vector<std::array<float, N>> gathered(const std::array<const Vector*, N / 3>& fields) const;

  using NodeIndex = std::array<dealii::types::global_dof_index, 3>;
  const Body& body_;
  contact::BodyField mesh_;
  std::vector<NodeIndex> nodes_;  ///< of this process: the unknowns u_x, u_y, u_z of each
  /// On process 0: points of the nodes of every process.
  std::vector<std::vector<int>> point_of_;
  std::vector<int> mirrored_;  ///< points whose mirror images follow all modelled ones
};

}  // namespace rollfem::fem
