// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/contact/fields.hpp"

#include "halfspace/patch/patch_search.hpp"
#include "scene/friction_law.hpp"

#include <fmt/format.h>

namespace rollfem::addon {

namespace {

/// Of the bodies in CONTACT's words: 1 is the wheel in module 3, the rail in module 1.
bool first_is_wheel(const Problem& problem) {
  return problem.given.module == 3;
}

contact::Field undeformed_distance(const contact::PointResult& point) {
  const auto& fields = point.fields;
  if (fields.gap.size() == 0 || fields.displacement.n.size() != fields.gap.size()) return {};
  return (fields.gap - fields.displacement.n).array() + point.approach;
}

contact::Field friction_of(const Patch& patch) {
  const auto& fields = patch.point.fields;
  contact::Field mu = contact::coefficients_of(patch.scene->friction(), patch.grid);
  for (Eigen::Index k = 0; k < fields.traction_bound.size(); ++k)
    if (fields.traction.n[k] > 0.0) mu[k] = fields.traction_bound[k] / fields.traction.n[k];
  return mu;
}

contact::TangentialField rigid_slip(const Patch& patch) {
  return halfspace::halfspace_geometry(*patch.scene).rigid_slip(patch.point.creepage, patch.grid);
}

contact::SurfaceField displacement_of(const Patch& patch) {
  const auto& fields = patch.point.fields;
  if (fields.traction.x.size() == 0 || fields.displacement.x.size() > 0) return fields.displacement;
  return halfspace::Halfspaces(patch.scene->material, patch.grid).like->apply(fields.traction);
}

/// Zero where there is no pressure, and everywhere if the field is empty.
contact::Field in_contact(const contact::Field& field, const contact::Field& pressure) {
  if (field.size() == 0) return contact::Field::Zero(pressure.size());
  return (pressure.array() > 0.0).select(field, 0.0);
}

/// A field in mm and MPa with its factor and its power of length in the client's units; empty: not
/// known.
struct Known {
  contact::Field values;
  double sign = 1.0;
  int power = 0;
};

Known field_of(int code, const Problem& problem, const Patch& patch) {
  const auto& f = patch.point.fields;
  const double x = patch.along * problem.units.body, y = patch.across * problem.units.body;
  const bool yields = problem.given.digits.M == 4 && problem.given.bodies.layer[2] > 0.0;
  const contact::Field zero = contact::Field::Zero(patch.grid.size());
  switch (code) {
    case fld_h:
      return {undeformed_distance(patch.point), 1.0, 1};
    case fld_mu:
      return {friction_of(patch)};
    case fld_px:
      return {f.traction.x.size() > 0 ? f.traction.x : zero, x, -2};
    case fld_py:
      return {f.traction.y.size() > 0 ? f.traction.y : zero, y, -2};
    case fld_pn:
      return {f.traction.n, 1.0, -2};
    case fld_ux:
      return {displacement_of(patch).x, x, 1};
    case fld_uy:
      return {displacement_of(patch).y, y, 1};
    case fld_un:
      return {f.displacement.n, 1.0, 1};
    case fld_taucrt:
      return {yields ? contact::Field() : zero, 1.0, -2};
    case fld_uplsx:
    case fld_uplsy:
      return {yields ? contact::Field() : zero, 1.0, 1};
    case fld_sx:
      return {in_contact(f.slip.x, f.traction.n), x};
    case fld_sy:
      return {in_contact(f.slip.y, f.traction.n), y};
    case fld_temp1:
      return {first_is_wheel(problem) ? f.temperature_wheel : f.temperature_rail};
    case fld_temp2:
      return {first_is_wheel(problem) ? f.temperature_rail : f.temperature_wheel};
    case fld_wx:
      return {rigid_slip(patch).x, x};
    case fld_wy:
      return {rigid_slip(patch).y, y};
    default:
      throw Refusal(err_other, fmt::format("there is no field {}", code));
  }
}

}  // namespace

std::vector<double> field_values(int code, const Problem& problem, const Patch& patch) {
  const Known known = field_of(code, problem, patch);
  if (known.values.size() == 0)
    throw Refusal(err_other, fmt::format("field {} is not known for this case", code));
  const double factor = known.sign * problem.units.out(1.0, known.power);
  std::vector<double> values;
  for (int j = 0; j < patch.ny; ++j)
    for (int i = 0; i < patch.nx; ++i) values.push_back(factor * known.values[patch.index(i, j)]);
  return values;
}

}  // namespace rollfem::addon
