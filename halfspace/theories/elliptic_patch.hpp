// What the theories of an elliptic patch share: Hertz's patch from the case, the normal part of the
// result record on the case's contact grid, and the loop over load points.
#pragma once

#include "contact/scene/geometry.hpp"
#include "contact/solve/model.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/theories/linear_theory.hpp"

#include <functional>
#include <string>

namespace rollfem::halfspace {

/// Hertz's contact of a case, with the fields and figures that friction does not change.
struct EllipticPatch {
  HertzContact hertz;
  contact::CombinedMaterial material;
  double friction = 0.0;
  contact::ContactGrid grid;
  contact::PointResult normal;  ///< everything normal filled in, tractions along the surface 0
};

/// Patch on the potential contact area of the case. Throws contact::InputError when the case has no
/// elliptic contact.
EllipticPatch elliptic_patch(const contact::Case& input);

/// Adds tangential tractions, slip and whatever follows to a load point that has its creepage and
/// its normal part.
using FillTangential = std::function<void(contact::PointResult&)>;

/// Result record of a theory: every load point of the case, from `normal`, by `fill`.
contact::ModelResult run_theory(const contact::Case& input, const contact::ContactGrid& grid,
                                const contact::PointResult& normal, const std::string& name,
                                const contact::Progress& progress, const FillTangential& fill);

/// Forces and traction coefficient of a load point.
void set_forces(const CreepForces& forces, contact::PointResult& point);

/// Largest tractions of a load point from its fields.
void set_largest_tractions(contact::PointResult& point);

/// Fields of size zero set to zero on all elements, state adhesion where there is pressure.
contact::ContactFields resting_fields(const contact::ContactGrid& grid,
                                      const contact::Field& pressure, double friction);

/// Throw contact::InputError naming `model` and models that can when the case asks for what the
/// theory leaves out.
void refuse_extra_slip(const contact::Case& input, const std::string& model);
void refuse_spin(const contact::Case& input, const std::string& model);
void refuse_lateral_creepage(const contact::Case& input, const std::string& model);

}  // namespace rollfem::halfspace
