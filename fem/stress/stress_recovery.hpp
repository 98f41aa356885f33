// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress of a finite-element body as a continuous nodal field, of higher order than the stress of
// the elements themselves: a polynomial through the superconvergent points of each cell and its
// neighbours, averaged at the nodes (docs/subsurface.md).
#pragma once

#include "fem/discretisation/body.hpp"
#include "result/stress_measures.hpp"

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace rollfem::fem {

/// Stress at the nodes of the displacement, MPa, global frame, tension positive. Both vectors have
/// the layout and shape functions of the displacement and their ghost values.
struct NodalStress {
  Vector direct;  ///< components xx yy zz
  Vector shear;   ///< components xy yz xz
};

/// What plastic strain does to a body, at its nodes, with ghost values; plastic strain in the
/// global frame.
struct YieldedFields {
  /// 2 G eps_p less the residual stress before the first pass, MPa, subtracted from the stress of
  /// the total displacement.
  NodalStress excess;
  NodalStress strain;    ///< plastic
  NodalStress residual;  ///< stress by plastic strain alone
  Vector displacement;   ///< by plastic strain, mm
  Vector accumulated;    ///< plastic strain, as the first component
};

/// `stress` plus a multiple of `part`, with ghost values.
void add(double factor, const NodalStress& part, NodalStress& stress);

/// Stores the data that depend only on the mesh, so that every load point costs little.
class StressRecovery {
 public:
  /// The body must outlive the recovery. Collective.
  explicit StressRecovery(const Body& body);
  ~StressRecovery();
  /// Collective. Displacement of an elastic body in mm, constraints distributed. On a symmetry
  /// plane xy and yz are 0. Continuous over the whole body, also across hanging nodes.
  NodalStress recover(const Vector& displacement) const;
  /// A node of this process: where it is, and its unknowns.
  struct Node {
    std::array<double, 3> place;
    std::array<dealii::types::global_dof_index, 3> unknowns;
  };
  /// The nodes whose unknowns this process owns and whose place `chosen` accepts, each once.
  std::vector<Node> nodes(const std::function<bool(const std::array<double, 3>&)>& chosen) const;
  /// Puts known stresses, xx yy zz xy yz xz in MPa, in place of the recovered ones. Collective.
  void replace(const std::vector<Node>& nodes, const std::vector<contact::SymmetricTensor>& known,
               NodalStress& stress) const;
  /// Calls f(point, stress xx yy zz xy yz xz, size of the cell in mm) for the nodes of every cell
  /// of this process; shared nodes occur several times.
  void for_each_node(const NodalStress& stress,
                     const std::function<void(const std::array<double, 3>&,
                                              const contact::SymmetricTensor&, double)>& f) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Error of a finite-element body in the energy norm, estimated from the difference between the
/// recovered stress and the element stress (Zienkiewicz and Zhu 1992, "The superconvergent patch
/// recovery and a posteriori error estimates").
struct EnergyError {
  double error = 0.0;  ///< ||u - u_h||_E estimated, sqrt(N mm), ||u||_E^2 = int sigma : eps
  double norm = 0.0;   ///< ||u_h||_E
  double relative() const { return norm > 0.0 ? error / norm : 0.0; }
};

/// Collective. `stress`: StressRecovery::recover of the same displacement.
EnergyError energy_error(const Body& body, const Vector& displacement, const NodalStress& stress);

}  // namespace rollfem::fem
