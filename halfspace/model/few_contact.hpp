// SPDX-License-Identifier: LGPL-2.1-or-later
// A contact in steady rolling on few elements, for which sums over the elements are faster than
// transforms. The pressure is kept while only the motion changes, and the last tractions are the
// start.
#pragma once

#include "contact/iteration/bound_constrained_cg.hpp"
#include "contact/iteration/friction_newton.hpp"
#include "halfspace/elasticity/few_elements.hpp"
#include "scene/scene.hpp"

#include <optional>

namespace rollfem::halfspace {

class FewContact {
 public:
  /// Empty where another way is needed: not steady rolling under given creepages with Coulomb's
  /// law, unlike materials, heat, too many elements, a patch that reaches the end of the grid, an
  /// iteration that does not converge. Displacements along the surface are not computed.
  std::optional<contact::PointResult> solve(const contact::Scene& scene,
                                            const contact::ContactGrid& grid);

 private:
  bool press(const contact::Scene& scene, const contact::ContactGrid& grid,
             const contact::Field& distance);
  void roll(const contact::Scene& scene, const contact::ChartedGeometry& geometry);

  contact::ContactGrid grid_;
  contact::CombinedMaterial material_;
  contact::NormalLoad load_;
  contact::Field distance_;  ///< by which the pressure was found; empty: none
  InfluenceTable table_;
  contact::BoundConstrainedCg normal_;
  std::optional<FewElementsRolling> rolling_;
  contact::FrictionNewton newton_;
  contact::PointResult point_;
};

}  // namespace rollfem::halfspace
