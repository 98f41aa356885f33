// SPDX-License-Identifier: LGPL-2.1-or-later
// The functions that return results of wheel and rail: places, forces on the track, profiles.
#include "bindings/contact/frames.hpp"
#include "bindings/contact/rows.hpp"
#include "profiles/profile_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace rollfem::addon {

namespace {

using Eigen::Vector3d;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Places in mm as the client counts them: lengths[k] tells which values are lengths.
void append(const Units& units, std::initializer_list<double> lengths, std::vector<double>& to) {
  for (const double value : lengths) to.push_back(units.out(value));
}

Values location_of(Problem& problem, const Patch& patch) {
  if (!patch.placed) throw Refusal(err_icp, "only module 1 has locations");
  const Units& units = problem.units;
  const Markers markers = markers_of(problem, patch);
  const Vector3d at = reference_of(patch), middle = pressure_centre(patch);
  const double angle = angle_of(patch);
  const bool springs = problem.given.digits.F == 3;
  std::vector<double> v;
  append(units, {at.x(), at.y(), at.z()}, v);
  v.push_back(angle);
  for (const Marker* marker : {&markers.rail, &markers.wheel}) {
    const Vector3d seen = marker->seen(at);
    append(units, {seen.x(), seen.y(), seen.z()}, v);
    v.push_back(none);  // SCP
    v.push_back(angle - marker->roll);
  }
  append(units, {middle.x(), middle.y(), none}, v);
  append(units, {springs ? none : 0.0, springs ? none : 0.0, none}, v);
  const Marker &wheel = markers.wheel, &rail = markers.rail, &set = markers.wheelset;
  append(units, {wheel.place.x(), wheel.place.y(), wheel.place.z()}, v);
  v.insert(v.end(), {wheel.roll, wheel.yaw});
  append(units, {rail.place.y(), rail.place.z()}, v);
  v.insert(v.end(), {rail.roll, none});
  const Vector3d seen = set.seen(at), of_wheel = set.seen(wheel.place);
  append(units, {seen.x(), seen.y(), seen.z()}, v);
  v.push_back(angle - set.roll);
  append(units, {of_wheel.x(), of_wheel.y(), of_wheel.z()}, v);
  v.insert(v.end(), {wheel.roll - set.roll, wheel.yaw - set.yaw});
  return v;
}

/// Forces and moments on the output body in four frames.
std::vector<double> global_forces(const Problem& problem,
                                  const std::vector<const Patch*>& patches) {
  std::vector<double> v(24, 0.0);
  const double body = -problem.units.body;  // of forces on the wheel
  for (const Patch* patch : patches) {
    const Markers markers = markers_of(problem, *patch);
    const TrackForce on_wheel = force_of(*patch);
    const auto add = [&](std::size_t first, const Marker& axes, const Marker& about) {
      const Vector3d force = body * (axes.axes.transpose() * on_wheel.force);
      const Vector3d moment = body * (axes.axes.transpose() * on_wheel.about(about.place));
      for (int k = 0; k < 3; ++k) {
        v[first + static_cast<std::size_t>(k)] += force[k];
        v[first + 3 + static_cast<std::size_t>(k)] += problem.units.out(moment[k]);
      }
    };
    add(0, Marker{}, markers.rail);
    add(6, markers.wheelset, markers.wheel);
    add(12, markers.rail, markers.rail);
    add(18, markers.wheel, markers.wheel);
  }
  return v;
}

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
std::vector<double> columns(const std::vector<profiles::ProfilePoint>& points, int task,
                            const profiles::ProfileCurve& curve) {
  std::vector<double> values;
  for (const auto& p : points) {
    if (task == 1 || task == 2) values.push_back(p.y);
    if (task == 4) values.push_back(curve.parameter_at(p.y) - curve.first());
    if (task == 5) values.push_back(std::atan2(p.tangent_z, p.tangent_y));
  }
  for (const auto& p : points)
    if (task == 1 || task == 2) values.push_back(p.z);
  return values;
}

void profile_values(Problem& problem, int task, bool wheel, int sampling, double step,
                    std::vector<double>& values) {
  if (task < -1 || task > 5 || task == 3)
    throw Refusal(err_other, fmt::format("profiles by task {} have no equivalent", task));
  const track::ProfilePair& pair = problem.solver.profiles(problem.whole(), problem.profile_text);
  profiles::ProfileCurve curve = wheel ? pair.wheel : pair.rail;
  if (task == 2) {
    if (wheel) throw Refusal(err_other, "the wheel's profile on the track has no equivalent");
    curve = problem.solver.search().rail(problem.given.digits.config % 4 == 0).curve;
  }
  const auto points = sampled(curve, sampling, step);
  if (task == -1) values = {0.0, 0.0};
  if (task == 0) values = {static_cast<double>(points.size())};
  if (task > 0) values = columns(points, task, curve);
}

std::vector<double> parameters_of(const Problem& problem, const Patch& patch, int task) {
  const convert::ContactCase& given = problem.given;
  const Units& u = problem.units;
  const auto& [nu, g, influence, slope, layer, heat] = given.bodies;
  static_cast<void>(influence);
  static_cast<void>(heat);
  if (task == 1)
    return {u.out(given.rolling[2]), given.rolling[0], u.out(given.rolling[1]), 0.0, 0.0,
            u.out(layer[2], -2)};
  if (task == 2) {
    const contact::CombinedMaterial& m = patch.scene->material;
    return {u.out(g[0], -2),
            u.out(g[1], -2),
            u.out(m.shear_modulus, -2),
            nu[0],
            nu[1],
            m.poisson_ratio,
            m.difference,
            none,
            none,
            none,
            slope[0],
            slope[1],
            slope[2],
            none,
            u.out(layer[0], -2),
            u.out(layer[1]),
            u.out(layer[2], -2),
            u.out(layer[3], -3),
            0.0,
            0.0,
            0.0,
            0.0};
  }
  if (task != 3) throw Refusal(err_other, fmt::format("there is no group {}", task));
  std::vector<double> v{double(given.friction_law), double(given.friction.size()),
                        u.out(given.memory[0]), u.out(given.memory[1])};
  for (const convert::FrictionSet& set : given.friction)
    v.insert(v.end(), {set.place, set.fstat, set.fkin});
  return v;
}

}  // namespace

extern "C" {

ADDON_ARRAY(cntc_getcontactlocation, location_of)

void cntc_getglobalforces(const int* ire, const int* icp, const int* lenarr, double* rvalues) {
  fill("cntc_getglobalforces", {ire, icp}, lenarr, rvalues, [&] {
    Values v;
    for_problem(*ire, *icp, [&](Problem& problem) {
      if (problem.given.module != 1) throw Refusal(err_icp, "only module 1 has a track");
      if (problem.cases == 0) throw Refusal(err_icp, "it is not solved");
      std::vector<const Patch*> patches;
      for (const Patch& patch : problem.patches) patches.push_back(&patch);
      const auto number = static_cast<std::size_t>(std::max(*icp, 0));
      if (number > patches.size()) throw Refusal(err_icp, "there is no such patch");
      if (number > 0) patches = {patches[number - 1]};
      v = global_forces(problem, patches);
    });
    return v;
  });
}

void cntc_getwheelsetposition(const int* ire, const int* lenarr, double* rvalues) {
  fill("cntc_getwheelsetposition", {ire}, lenarr, rvalues, [&] {
    Values v;
    for_pair(*ire, [&](Problem& p) {
      const auto& [s, y, z, roll, yaw, pitch] = p.given.wheel_rail.position;
      const bool found = p.given.digits.N == 1 && !p.patches.empty();
      append(p.units, {s, y, found ? p.patches.front().placed->height() : z}, v);
      v.insert(v.end(), {roll, yaw, pitch});
    });
    return v;
  });
}

void cntc_getwheelsetvelocity(const int* ire, const int* lenarr, double* rvalues) {
  fill("cntc_getwheelsetvelocity", {ire}, lenarr, rvalues, [&] {
    Values v;
    for_pair(*ire, [&](Problem& p) {
      const auto& [vs, vy, vz, roll, yaw, pitch] = p.given.wheel_rail.velocity;
      v = {p.given.digits.config >= 4 ? vs : p.units.out(vs),
           p.units.out(vy),
           p.units.out(vz),
           roll,
           yaw,
           pitch};
    });
    return v;
  });
}

void cntc_getprofilevalues(const int* ire, const int* itask, const int* nints, const int* iparam,
                           const int* nreals, const double* rparam, const int* lenarr,
                           double* val) {
  fill("cntc_getprofilevalues", {ire, itask, nints, nreals}, lenarr, val, [&] {
    demand_arrays(nints, iparam, nreals, rparam);
    if (*lenarr > 0 && *itask <= 0) val[0] = err_profil;  // until the profile is read
    Values values;
    for_pair(*ire, [&](Problem& problem) {
      profile_values(problem, *itask, *nints > 0 && iparam[0] == 1, *nints > 1 ? iparam[1] : 0,
                     *nreals > 0 && rparam[0] > 0.0 ? rparam[0] : 1.0, values);
    });
    return values;
  });
}

void cntc_getprofilevalues_new(const int* ire, const int* itask, const int* nints,
                               const int* iparam, const int* nreals, const double* rparam,
                               const int* lenarr, double* val) {
  cntc_getprofilevalues(ire, itask, nints, iparam, nreals, rparam, lenarr, val);
}

void cntc_getparameters(const int* ire, const int* icp, const int* itask, const int* lenarr,
                        double* values) {
  fill("cntc_getparameters", {ire, icp, itask}, lenarr, values, [&] {
    Values v;
    for_patch(*ire, *icp, [&](Problem& problem, const Patch& patch) {
      v = parameters_of(problem, patch, *itask);
    });
    return v;
  });
}

}  // extern "C"

}  // namespace rollfem::addon
