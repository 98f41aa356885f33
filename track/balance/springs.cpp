// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/balance/springs.hpp"

#include "base/errors.hpp"
#include "base/root.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "track/balance/position.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rollfem::track {

namespace {

/// mm
constexpr double first_step = 0.05, largest = 100.0, tolerance = 1e-6;
constexpr double too_much = 1e9, at_rest = 20.0;  // N
constexpr int elements_across = 24;

/// Zero of the force of the springs, with what else is on the rail, over its place. Where the
/// bodies overlap too much to be solved, they press it away with more than any spring carries:
/// `away` is the sign of the way out.
double settled(const std::function<double(double)>& left, double start, double away,
               const char* what) {
  const auto at = [&](double place) {
    try {
      return left(place);
    } catch (const contact::Failure&) {
      return -away * too_much;
    }
  };
  const double at_start = at(start);
  const auto found =
      contact::root_from(at, start, at_start, start + (at_start > 0.0 ? -first_step : first_step),
                         largest, tolerance, what);
  if (!found)
    throw contact::SolveError(
        fmt::format("{}: the springs do not hold the rail within {:g} mm; do: check "
                    "track.rail_stiffness and track.rail_force",
                    what, largest));
  // Where the force jumps, or beyond what can be solved, nothing balances.
  const double rest = left(*found);
  if (!(std::abs(rest) <= at_rest))
    throw contact::SolveError(fmt::format(
        "{}: at {:.6g} mm the force of the wheel jumps, or the overlap cannot be solved "
        "beyond it; {:.4g} N are left; do: give track.rail_position without springs",
        what, *found, rest));
  return *found;
}

}  // namespace

WheelOnRail on_moved_rail(const contact::Case& here, const SearchScene& search, int position,
                          const RailVector& moved) {
  contact::Case input = here;
  const std::size_t side = input.wheelset.side == contact::WheelSide::left ? 0 : 1;
  input.rail_displacement.lateral[side] += moved[0];
  input.rail_displacement.vertical[side] += moved[1];
  WheelOnRail wheel;
  SearchOptions options;
  options.with_reserve = input.load.vertical_force.has_value();
  wheel.placed = scenes_at(input, make_search_scene(input, search.profiles), position, options);
  wheel.balanced = balanced_position(input, wheel.placed);
  return wheel;
}

RailVector settled_rail(const contact::Case& input, RailVector start,
                        const std::function<RailVector(const RailVector&)>& force) {
  const auto &stiff = *input.track.rail_stiffness, &own = input.track.rail_force;
  const bool carried = input.load.vertical_force.has_value();
  const double outward = side_sign(input.wheelset.side == contact::WheelSide::left);
  RailVector moved = start, found{};
  const auto down = [&](double z) {
    moved[1] = z;
    found = force(moved);
    return stiff[1] * z - found[1] - own[1];
  };
  const auto aside = [&](double y) {
    moved[0] = y;
    if (carried) {
      found = force(moved);
      moved[1] = (found[1] + own[1]) / stiff[1];
    } else {
      moved[1] = settled(down, moved[1], 1.0, "the height of the rail on springs");
    }
    return stiff[0] * y - found[0] - own[0];
  };
  moved[0] = settled(aside, start[0], outward, "the lateral place of the rail on springs");
  return moved;
}

void add_force_on_rail(const contact::ContactPlace& place, double normal, double lateral,
                       RailVector& force) {
  force[0] -= lateral_force(normal, lateral, place);
  force[1] += vertical_force(normal, lateral, place);
}

WheelOnRail on_springs(const contact::Case& here, const SearchScene& search, int position,
                       RailVector& moved) {
  const auto force = [&](const RailVector& at) {
    RailVector sum{};
    for (const contact::Scene& scene : on_moved_rail(here, search, position, at).balanced) {
      const contact::PointResult point =
          halfspace::run_halfspace(halfspace::on_few_elements(scene, elements_across), {})
              .points.front();
      add_force_on_rail(*scene.place, point.normal_force, point.lateral_force, sum);
    }
    return sum;
  };
  moved = settled_rail(here, moved, force);
  return on_moved_rail(here, search, position, moved);
}

std::string springs_text(const RailVector& moved) {
  return fmt::format(
      "the rail on its springs has moved by {:.6g} mm to the right and {:.6g} mm down", moved[0],
      moved[1]);
}

}  // namespace rollfem::track
