// SPDX-License-Identifier: LGPL-2.1-or-later
// Steady rolling of one contact at one creepage after another: the pressure is that of the first,
// the elements are few, and the last tractions are the start.
#pragma once

#include "contact/iteration/friction_newton.hpp"
#include "halfspace/elasticity/few_elements.hpp"
#include "halfspace/elasticity/preconditioned_elasticity.hpp"
#include "scene/scene.hpp"

#include <memory>

namespace rollfem::addon {

class CreepCurve {
 public:
  /// Null where another way is needed: not steady rolling under given creepages with Coulomb's law,
  /// unlike materials, heat, too many elements.
  static std::shared_ptr<CreepCurve> of(const contact::Scene& scene,
                                        const contact::ContactGrid& grid,
                                        const halfspace::Halfspaces& halfspaces,
                                        const contact::PointResult& solved);

  /// At the creepages of a scene that differs in nothing else. Throws contact::SolveError.
  contact::PointResult at(const contact::Scene& scene);

 private:
  CreepCurve(const contact::ContactGrid& grid, halfspace::Halfspaces halfspaces,
             contact::PointResult solved);

  contact::ContactGrid grid_;
  halfspace::Halfspaces halfspaces_;
  contact::PointResult point_;
  halfspace::FewElementsRolling rolling_;
  contact::FrictionNewton newton_;
  bool ready_ = false;  ///< rolling_ has its matrix
};

}  // namespace rollfem::addon
