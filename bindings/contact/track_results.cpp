// SPDX-License-Identifier: LGPL-2.1-or-later
// The functions that return results of wheel and rail, places and forces on the track, and what has
// been set.
#include "bindings/contact/frames.hpp"
#include "bindings/contact/rows.hpp"

#include <fmt/format.h>

#include <vector>

namespace rollfem::addon {

namespace {

Values parameters_of(const Problem& problem, const Patch& patch, int task) {
  const convert::ContactCase& given = problem.given;
  const Units& u = problem.units;
  const auto& [nu, g, influence, slope, layer, heat] = given.bodies;
  static_cast<void>(influence);
  static_cast<void>(heat);
  const contact::CombinedMaterial& m = patch.scene->material;
  if (task == 1)
    return u.out({given.rolling[2], given.rolling[0], given.rolling[1], 0.0, 0.0, layer[2]},
                 {1, 0, 1, 0, 0, -2});
  Values v;
  if (task == 2) {
    v = {g[0], g[1], m.shear_modulus, nu[0], nu[1], m.poisson_ratio, m.difference};
    v.insert(v.end(), {none, none, none, slope[0], slope[1], slope[2], none});
    v.insert(v.end(), layer.begin(), layer.end());
    v.resize(22, 0.0);
    return u.out(v, {-2, -2, -2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -2, 1, -2, -3});
  }
  if (task != 3) throw Refusal(err_other, fmt::format("there is no group {}", task));
  v = u.out(
      {double(given.friction_law), double(given.friction.size()), given.memory[0], given.memory[1]},
      {0, 0, 1});
  for (const convert::FrictionSet& set : given.friction)
    v.insert(v.end(), {set.place, set.fstat, set.fkin});
  return v;
}

}  // namespace

extern "C" {

ADDON_ARRAY(cntc_getcontactlocation, location_of)

void cntc_getglobalforces(Int ire, Int icp, Int lenarr, double* rvalues) {
  fill("cntc_getglobalforces", {ire, icp}, lenarr, rvalues, [&](Values& v) {
    for_problem(*ire, *icp, [&](Problem& problem) {
      if (problem.given.module != 1) throw Refusal(err_icp, "only module 1 has a track");
      v = global_forces(problem, patches_of(problem, *icp));
    });
  });
}

void cntc_getwheelsetposition(Int ire, Int lenarr, double* rvalues) {
  fill("cntc_getwheelsetposition", {ire}, lenarr, rvalues, [&](Values& v) {
    for_pair(*ire, [&](Problem& p) {
      const auto& position = p.given.wheel_rail.position;
      v.assign(position.begin(), position.end());
      if (p.given.digits.N == 1 && !p.patches.empty()) v[2] = p.patches.front().placed->height();
      v = p.units.out(v, {1, 1, 1, 0});
    });
  });
}

void cntc_getwheelsetvelocity(Int ire, Int lenarr, double* rvalues) {
  fill("cntc_getwheelsetvelocity", {ire}, lenarr, rvalues, [&](Values& v) {
    for_pair(*ire, [&](Problem& p) {
      const auto& velocity = p.given.wheel_rail.velocity;
      v.assign(velocity.begin(), velocity.end());
      v = p.units.out(v, {p.given.digits.config >= 4 ? 0 : 1, 1, 1, 0});
    });
  });
}

void cntc_getparameters(Int ire, Int icp, Int itask, Int lenarr, double* values) {
  fill("cntc_getparameters", {ire, icp, itask}, lenarr, values, [&](Values& v) {
    for_patch(*ire, *icp, [&](Problem& problem, const Patch& patch) {
      v = parameters_of(problem, patch, *itask);
    });
  });
}

}  // extern "C"

}  // namespace rollfem::addon
