// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/contact/problem.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "scene/friction_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::addon {

namespace {

bool yields(const contact::ContactFields& fields, Eigen::Index k) {
  return !fields.state.empty() &&
         fields.state[static_cast<std::size_t>(k)] == contact::ElementState::plastic;
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

const contact::SurfaceField& displacement_of(const Patch& patch) {
  const auto& fields = patch.point.fields;
  if (fields.traction.x.size() == 0 || fields.displacement.x.size() > 0) return fields.displacement;
  if (!patch.displacement)
    patch.displacement =
        halfspace::Halfspaces(patch.scene->material, patch.grid).like->apply(fields.traction);
  return *patch.displacement;
}

/// Where the bodies slide: where the layer between them yields they do not.
contact::Field sliding(const contact::Field& slip, const Patch& patch) {
  const auto& fields = patch.point.fields;
  contact::Field found = contact::Field::Zero(patch.grid.size());
  for (Eigen::Index k = 0; k < slip.size(); ++k)
    if (fields.traction.n[k] > 0.0 && !yields(fields, k)) found[k] = slip[k];
  return found;
}

/// What a layer has yielded when a particle is at an element, mm, along the traction; the way, and
/// its yield stress there. Empty but in steady rolling.
struct Yielded {
  contact::Field x, y, stress;
};

Yielded yielded(const Problem& problem, const Patch& patch) {
  const auto& [modulus, thickness, stress, hardening] = problem.given.bodies.layer;
  const auto& fields = patch.point.fields;
  const contact::ContactGrid& grid = patch.grid;
  const contact::Field zero = contact::Field::Zero(grid.size());
  if (problem.given.digits.M != 4 || !(stress > 0.0)) return {zero, zero, zero};
  if (patch.scene->problem != contact::Problem::steady) return {};
  Yielded found{zero, zero, zero};
  for (int j = 0; j < grid.ny; ++j) {
    double x = 0.0, y = 0.0, way = 0.0;
    for (int i = grid.nx; i-- > 0;) {  // from the leading edge
      const int k = grid.index(i, j);
      const bool in_contact = fields.traction.n[k] > 0.0;
      if (!in_contact) x = y = way = 0.0;
      if (in_contact && yields(fields, k)) {
        x -= fields.slip.x[k] * grid.dx;
        y -= fields.slip.y[k] * grid.dx;
        way += std::hypot(fields.slip.x[k], fields.slip.y[k]) * grid.dx;
      }
      found.x[k] = x;
      found.y[k] = y;
      found.stress[k] = in_contact && yields(fields, k) ? fields.traction_bound[k]
                                                        : std::max(0.0, stress + hardening * way);
    }
  }
  return found;
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
  const bool wheel_first = problem.given.module == 3;  // else body 1 is the rail
  const contact::Field zero = contact::Field::Zero(patch.grid.size());
  if (code == fld_h) return {undeformed_distance(patch.point), 1.0, 1};
  if (code == fld_mu) return {friction_of(patch)};
  if (code == fld_px) return {f.traction.x.size() > 0 ? f.traction.x : zero, x, -2};
  if (code == fld_py) return {f.traction.y.size() > 0 ? f.traction.y : zero, y, -2};
  if (code == fld_pn) return {f.traction.n, 1.0, -2};
  if (code == fld_ux) return {displacement_of(patch).x, x, 1};
  if (code == fld_uy) return {displacement_of(patch).y, y, 1};
  if (code == fld_un) return {f.displacement.n, 1.0, 1};
  if (code == fld_taucrt) return {yielded(problem, patch).stress, 1.0, -2};
  if (code == fld_uplsx) return {yielded(problem, patch).x, x, 1};
  if (code == fld_uplsy) return {yielded(problem, patch).y, y, 1};
  if (code == fld_sx) return {sliding(f.slip.x, patch), x};
  if (code == fld_sy) return {sliding(f.slip.y, patch), y};
  if (code == fld_temp1) return {wheel_first ? f.temperature_wheel : f.temperature_rail};
  if (code == fld_temp2) return {wheel_first ? f.temperature_rail : f.temperature_wheel};
  if (code == fld_wx) return {rigid_slip(patch).x, x};
  if (code == fld_wy) return {rigid_slip(patch).y, y};
  throw Refusal(err_other, fmt::format("there is no field {}", code));
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
