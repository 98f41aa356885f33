// SPDX-License-Identifier: LGPL-2.1-or-later
// The functions that return points of profiles. y of rails ascends from point to point, that of
// wheels descends; on the left side both are mirrored when they are on the track.
#include "bindings/contact/frames.hpp"
#include "bindings/contact/rows.hpp"
#include "profiles/profile_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rollfem::addon {

namespace {

/// What a client asks for: iparam and rparam, with their defaults.
struct Asked {
  int task = 0;
  bool wheel = false;
  int sampling = 0;    ///< 1: every `step`; from 2 on: points from knot to knot; else the knots
  double step = 1.0;   ///< mm, or rad around a wheel
  double place = 0.0;  ///< of the section of a body that changes along its way; y of task 8
  double from = none, to = none;
};

/// From `first` to `last`.
Values evenly(double first, double last, double step) {
  constexpr double most = 1e6, least = 1e-4;
  if (!(step >= least) || (last - first) / step > most)
    throw Refusal(err_other, fmt::format("DS_OUT = {:g}: allowed: at least {:g}", step, least));
  Values places;
  for (int k = 0; k <= static_cast<int>((last - first) / step + 1e-9); ++k)
    places.push_back(first + k * step);
  return places;
}

/// Parameters of the points, in CONTACT's order.
Values sampled(const profiles::ProfileCurve& curve, const Asked& asked) {
  Values places;
  const auto& knots = curve.knots();
  const int between = std::clamp(asked.sampling, 1, 100);
  if (asked.sampling == 1) {
    places = evenly(0.0, curve.last() - curve.first(), asked.step);
    for (double& s : places) s = asked.wheel ? curve.last() - s : curve.first() + s;
    return places;
  }
  for (std::size_t k = 0; k + 1 < knots.size(); ++k)
    for (int part = 0; part < between; ++part)
      places.push_back(knots[k].parameter +
                       (knots[k + 1].parameter - knots[k].parameter) * part / between);
  places.push_back(curve.last());
  if (asked.wheel) std::reverse(places.begin(), places.end());
  return places;
}

/// Columns one after the other: y and z, the arc length or the inclination.
Values columns(const profiles::ProfileCurve& curve, const Values& places, const Asked& asked) {
  const double order = asked.wheel ? -1.0 : 1.0;
  const double middle = asked.task == 4 ? curve.parameter_at(0.0) : 0.0;
  Values first, second;
  for (const double place : places) {
    const profiles::ProfilePoint p = curve.at(place);
    if (asked.task == 4)
      first.push_back(order * (place - middle));
    else if (asked.task == 5)
      first.push_back(std::atan2(order * p.tangent_z, order * p.tangent_y));
    else
      first.push_back(p.y), second.push_back(p.z);
  }
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// On the track, where the last call has placed the wheel.
void place_on_track(Problem& problem, bool wheel, Values& points) {
  const bool left = problem.given.digits.config % 4 == 0;
  const std::size_t count = points.size() / 2;
  if (wheel && problem.patches.empty())
    throw Refusal(err_icp, "the wheel is on the track when it is solved and in contact");
  const track::RailPlace& rail = problem.solver.search().rail(left).place;
  for (std::size_t k = 0; k < count; ++k) {
    double &y = points[k], &z = points[count + k];
    if (wheel) {
      const auto placed = on_track(problem, problem.patches.front(), y, z);
      y = placed[0], z = placed[1];
    } else {
      const double c = std::cos(rail.angle), s = std::sin(rail.angle);
      const double turned = c * y - s * z + rail.shift_y;
      z = s * y + c * z + rail.shift_z;
      y = track::side_sign(left) * turned;
    }
  }
}

/// The left-most point within the gauge height, the shifts to the track, the point at that height.
Values gauge_points(Problem& problem, const profiles::ProfileCurve& rail) {
  const contact::Track& track = problem.solver.input().track;
  if (track.rail_position) throw Refusal(err_other, "a rail that no gauge places");
  const bool left = problem.given.digits.config % 4 == 0;
  const track::RailPlace& place = problem.solver.search().rail(left).place;
  const profiles::ProfileCurve turned = rail.moved(place.angle, 0.0, 0.0);
  const double height = track.gauge_height - place.shift_z;  // of the turned profile
  profiles::ProfilePoint inner, at_height;
  inner.y = at_height.y = contact::infinity;
  double before = contact::infinity;
  for (const double s : dense_parameters(turned, 0.05)) {
    const profiles::ProfilePoint p = turned.at(s);
    if (p.z <= height && p.y < inner.y) inner = p;
    if (std::isinf(at_height.y) && before > height && p.z <= height) at_height = p;
    before = p.z;
  }
  const double side = track::side_sign(left);
  return problem.units.out(
      {inner.y, inner.z, side * place.shift_y, place.shift_z, at_height.y, height}, {1});
}

/// Along the way at one y: x, y and z.
Values along_way(const profiles::SectionSurface& surface, const Asked& asked, bool count_alone) {
  const auto or_else = [](double given, double other) { return std::isnan(given) ? other : given; };
  Values x =
      evenly(or_else(asked.from, surface.first()), or_else(asked.to, surface.last()), asked.step);
  if (count_alone) return {static_cast<double>(x.size())};
  Values y(x.size(), asked.place), z;
  for (const double way : x) {
    const profiles::ProfileCurve section = surface.section(way);
    z.push_back(section.at(section.parameter_at(asked.place)).z);
  }
  x.insert(x.end(), y.begin(), y.end());
  x.insert(x.end(), z.begin(), z.end());
  return x;
}

Values profile_values(Problem& problem, const Asked& asked, bool count_alone) {
  if (asked.task < -1 || (asked.task > 5 && asked.task != 8))
    throw Refusal(err_other, fmt::format("profiles by task {} have no equivalent", asked.task));
  const track::ProfilePair& pair = problem.solver.profiles(problem.whole(), problem.profile_text);
  const auto& sections = asked.wheel ? pair.wheel_sections : pair.rail_sections;
  if (asked.task == 8) {
    if (!sections) throw Refusal(err_profil, "the profile does not change along its way");
    return along_way(*sections, asked, count_alone);
  }
  if (asked.task == -1) return {0.0, 0.0};
  const bool from_wheelset = asked.task == 2 && !asked.wheel;
  const double ahead = from_wheelset ? problem.given.wheel_rail.position[0] : 0.0;
  const profiles::ProfileCurve curve = sections      ? sections->section(asked.place + ahead)
                                       : asked.wheel ? pair.wheel
                                                     : pair.rail;
  if (asked.task == 3) {
    if (asked.wheel) throw Refusal(err_profil, "a wheel has no gauge point");
    return gauge_points(problem, curve);
  }
  const Values places = sampled(curve, asked);
  if (asked.task == 0) return {static_cast<double>(places.size())};
  Values values = columns(curve, places, asked);
  if (asked.task == 2) place_on_track(problem, asked.wheel, values);
  return values;
}

}  // namespace

extern "C" {

void cntc_getprofilevalues(Int ire, Int itask, Int nints, Int iparam, Int nreals, Real rparam,
                           Int lenarr, double* val) {
  fill("cntc_getprofilevalues", {ire, itask, nints, nreals}, lenarr, val, [&](Values& v) {
    demand_arrays(nints, iparam, nreals, rparam);
    if (*lenarr > 0 && *itask <= 0) val[0] = err_profil;  // until the profile is read
    Asked asked;
    asked.task = *itask;
    asked.wheel = *nints > 0 && iparam[0] == 1;
    asked.sampling = *nints > 1 ? iparam[1] : 0;
    const Values given = finite_values(rparam, std::min(*nreals, 4));
    double* const taken[]{&asked.step, &asked.place, &asked.from, &asked.to};
    for (std::size_t k = 0; k < given.size(); ++k) *taken[k] = given[k];
    for_pair(*ire, [&](Problem& problem) { v = profile_values(problem, asked, *lenarr == 1); });
  });
}

void cntc_getprofilevalues_new(Int ire, Int itask, Int nints, Int iparam, Int nreals, Real rparam,
                               Int lenarr, double* val) {
  cntc_getprofilevalues(ire, itask, nints, iparam, nreals, rparam, lenarr, val);
}

}  // extern "C"

}  // namespace rollfem::addon
