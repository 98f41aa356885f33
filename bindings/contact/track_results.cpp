// SPDX-License-Identifier: LGPL-2.1-or-later
// The functions that return results of wheel and rail: places, forces on the track, profiles.
#include "bindings/contact/frames.hpp"
#include "bindings/contact/rows.hpp"
#include "profiles/profile_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rollfem::addon {

namespace {

/// Points of a profile by CONTACT's ways of sampling, y to the right of the right-hand side.
std::vector<profiles::ProfilePoint> sampled(const profiles::ProfileCurve& curve, int sampling,
                                            double step) {
  std::vector<profiles::ProfilePoint> points;
  if (sampling == 1) {
    const double pieces = std::floor((curve.last() - curve.first()) / std::max(step, 1e-3));
    for (int k = 0; k <= static_cast<int>(std::min(pieces, 1e6)); ++k)
      points.push_back(curve.at(curve.first() + k * step));
    return points;
  }
  for (const profiles::ProfileKnot& knot : curve.knots())
    points.push_back(curve.at(knot.parameter));
  return points;
}

/// Columns of the points, one after the other.
Values columns(const std::vector<profiles::ProfilePoint>& points, int task,
               const profiles::ProfileCurve& curve) {
  Values values;
  for (const auto& p : points)
    values.push_back(task == 4   ? curve.parameter_at(p.y) - curve.first()
                     : task == 5 ? std::atan2(p.tangent_z, p.tangent_y)
                                 : p.y);
  if (task < 4)
    for (const auto& p : points) values.push_back(p.z);
  return values;
}

Values profile_values(Problem& problem, int task, bool wheel, int sampling, double step) {
  if (task < -1 || task > 5 || task == 3)
    throw Refusal(err_other, fmt::format("profiles by task {} have no equivalent", task));
  const track::ProfilePair& pair = problem.solver.profiles(problem.whole(), problem.profile_text);
  profiles::ProfileCurve curve = wheel ? pair.wheel : pair.rail;
  if (task == 2) {
    if (wheel) throw Refusal(err_other, "the wheel's profile on the track has no equivalent");
    curve = problem.solver.search().rail(problem.given.digits.config % 4 == 0).curve;
  }
  const auto points = sampled(curve, sampling, step);
  if (task == -1) return {0.0, 0.0};
  if (task == 0) return {static_cast<double>(points.size())};
  return columns(points, task, curve);
}

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

void cntc_getprofilevalues(Int ire, Int itask, Int nints, Int iparam, Int nreals, Real rparam,
                           Int lenarr, double* val) {
  fill("cntc_getprofilevalues", {ire, itask, nints, nreals}, lenarr, val, [&](Values& v) {
    demand_arrays(nints, iparam, nreals, rparam);
    if (*lenarr > 0 && *itask <= 0) val[0] = err_profil;  // until the profile is read
    for_pair(*ire, [&](Problem& problem) {
      v = profile_values(problem, *itask, *nints > 0 && iparam[0] == 1, *nints > 1 ? iparam[1] : 0,
                         *nreals > 0 && rparam[0] > 0.0 ? rparam[0] : 1.0);
    });
  });
}

void cntc_getprofilevalues_new(Int ire, Int itask, Int nints, Int iparam, Int nreals, Real rparam,
                               Int lenarr, double* val) {
  cntc_getprofilevalues(ire, itask, nints, iparam, nreals, rparam, lenarr, val);
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
