// SPDX-License-Identifier: LGPL-2.1-or-later
// Common parts of the theories of an elliptic patch: Hertz's patch from the case, the normal part
// of the result record on the case's contact grid, and the loop over load points.
#pragma once

#include "contact/solve/model.hpp"
#include "contact/solve/prescribed_force.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/closed_forms/kalker.hpp"
#include "scene/geometry.hpp"

#include <functional>
#include <string>

namespace rollfem::theories {

/// Hertz's contact of a case, with the fields and figures that friction does not change.
struct EllipticPatch {
  halfspace::HertzContact hertz;
  contact::CombinedMaterial material;
  contact::ChartedGeometry geometry;
  double friction = 0.0;        ///< at rest
  contact::Friction falling{};  ///< the law if friction falls with slip, otherwise null
  contact::ContactGrid grid;
  contact::PointResult normal;  ///< everything normal filled in, tractions along the surface 0

  /// Forces of the linear theory.
  halfspace::CreepForces linear_forces(const contact::Creepage& creepage) const;
  /// The coefficient at the rigid slip in the middle, without spin.
  double friction_at(const contact::Creepage& creepage) const;
};

/// Patch on the potential contact area of the case. Throws contact::InputError when the case has no
/// elliptic contact.
EllipticPatch elliptic_patch(const contact::Scene& scene);

/// Adds tangential tractions, slip and derived quantities to a load point with its creepage and
/// normal solution.
using FillTangential = std::function<void(contact::PointResult&)>;

/// Result record of the theory `name`: `fill` completes every load point of the case, starting from
/// `normal`.
contact::ModelResult run_theory(const contact::Scene& scene, const contact::ContactGrid& grid,
                                const contact::PointResult& normal, const std::string& name,
                                const contact::Progress& progress, const FillTangential& fill);

/// The scene with creepages at which a theory transmits its prescribed forces. `has_peak`: beyond
/// some creepage the force may fall.
contact::Scene with_creepages_of_forces(
    contact::Scene scene,
    const std::function<contact::TransmittedForce(const contact::Creepage&)>& transmitted,
    bool has_peak = false);

/// Forces and traction coefficient of a load point.
void set_forces(const halfspace::CreepForces& forces, contact::PointResult& point);

/// Largest tractions of a load point from its fields.
void set_largest_tractions(contact::PointResult& point);

/// Sets empty fields to zero on all elements, and the state to adhesion where there is pressure.
contact::ContactFields resting_fields(const contact::ContactGrid& grid,
                                      const contact::Field& pressure, double friction);

// The model "hertz": the closed form in the result record shared by all models.

/// The model "hertz": patch, pressure and approach; no friction. Tractions are sampled on the
/// case's contact grid.
contact::ModelResult run_hertz(const contact::Scene& scene, const contact::Progress& progress);
contact::ModelInfo hertz_model();

}  // namespace rollfem::theories
