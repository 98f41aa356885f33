// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives of the forces on a wheel by its state (WheelRailPair::linearise).
#include "capi/wheel_rail_pair.hpp"
#include "contact/base/errors.hpp"
#include "track/motion/wheelset_motion.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rollfem::capi {

namespace {

/// Steps of central differences: smaller than the scale on which forces bend, larger than the noise
/// of the contact grid.
constexpr double step_of_shift = 0.02;     // mm
constexpr double step_of_angle = 2e-5;     // rad
constexpr double step_of_creepage = 2e-5;  // of velocities, by the creepage that they make
constexpr double step_of_load = 0.02;      // relative
constexpr double half_gauge = 750.0;       // mm, arm of yaw and roll

/// Derivatives of the sums over all patches by the sinking of the wheel and, at fixed pressures, by
/// its motion relative to the forward speed.
struct Response {
  Wrench by_sinking;
  std::array<Wrench, 3> by_motion;  ///< rotation, lateral velocity, yaw velocity
};

void add(const QuickContact& contact, const PatchResponse& of_patch, Response& sum) {
  add(wrench_of(*contact.contact, of_patch.by_sinking), 1.0, sum.by_sinking);
  for (std::size_t k = 0; k < sum.by_motion.size(); ++k) {
    const contact::Creepage& by = contact.by_motion[k];
    const std::array<double, 3> change{by.longitudinal, by.lateral, by.spin};
    for (std::size_t c = 0; c < change.size(); ++c)
      add(wrench_of(*contact.contact, of_patch.by_creepage[c]), change[c], sum.by_motion[k]);
  }
}

}  // namespace

SolvedWheel WheelRailPair::linearise(const WheelState& state, WheelDerivatives& found) const {
  check(state, input_.wheel.rolling_radius);
  const Borrowed workspace(*this);
  workspace->linearises = true;
  const SolvedWheel at = solve(*workspace, state);
  workspace->linearises = false;
  found = {};
  if (at.count == 0) return at;
  const bool responds = workspace->solved != nullptr && respond(*workspace, state, found);
  // The response takes the friction of every slip relative to the speed as unchanged by the speed.
  const std::size_t differences = friction_falls() ? first_velocity + 1 : first_velocity;
  const std::size_t count = responds ? differences : state_variables.size();
  for (std::size_t k = 0; k < count; ++k)
    if (!std::isnan(state.*state_variables[k])) found.by[k] = difference(*workspace, state, at, k);
  if (responds) return at;
  if (state.given != WheelState::Given::vertical_force) {
    found.stiffness = -found.by[load_variable].force[2];
    return at;
  }
  WheelState sunk = state;
  sunk.given = WheelState::Given::penetration;
  sunk.load = at.penetration;
  found.stiffness = -difference(*workspace, sunk, at, load_variable).force[2];
  return at;
}

/// Columns of the velocities and the load, from the solution in the workspace. False if that fails.
bool WheelRailPair::respond(Workspace& workspace, const WheelState& state,
                            WheelDerivatives& found) const {
  QuickWheel& quick = *workspace.solved;
  if (!quick.respond(workspace.load, workspace.responses)) return false;
  const double speed = state.forward_speed;
  const track::Motion motion =
      track::motion_of(workspace.input, workspace.input.wheelset.rotation_change.front());
  Response sum;
  for (std::size_t k = 0; k < quick.patches().size(); ++k)
    add(quick.patches()[k]->given(), workspace.responses[k], sum);
  found.stiffness = -sum.by_sinking.force[2];
  const bool by_force = state.given == WheelState::Given::vertical_force;
  if (by_force && !(found.stiffness > 0.0)) return false;
  // Under a given vertical force the wheel sinks or rises until the force is restored.
  const auto settled = [&](Wrench change) {
    if (by_force) add(sum.by_sinking, change.force[2] / found.stiffness, change);
    return change;
  };
  Wrench by_speed;
  const std::array<double, 3> moves{motion.rotation, motion.lateral_velocity, motion.yaw_velocity};
  for (std::size_t k = 0; k < moves.size(); ++k) add(sum.by_motion[k], -moves[k] / speed, by_speed);
  found.by[first_velocity] = settled(by_speed);
  // Order of the motion: rotation first; the state has it last.
  constexpr std::array<std::size_t, 3> variable{6, 4, 5};
  for (std::size_t k = 0; k < variable.size(); ++k) {
    Wrench by_velocity;
    add(sum.by_motion[k], 1.0 / speed, by_velocity);
    found.by[variable[k]] = settled(by_velocity);
  }
  add(sum.by_sinking, by_force ? 1.0 / found.stiffness : 1.0, found.by[load_variable]);
  return true;
}

double WheelRailPair::step_of(const WheelState& state, const SolvedWheel& at,
                              std::size_t variable) const {
  const double speed = state.forward_speed;
  switch (variable) {
    case 0:
      return step_of_shift;
    case 1:
    case 2:
      return step_of_angle;
    case 5:
      return step_of_creepage * speed / half_gauge;
    case 6:
      return step_of_creepage * speed / input_.wheel.rolling_radius;
    case load_variable:
      return step_of_load *
             (state.given == WheelState::Given::vertical_force ? state.load : at.penetration);
    default:
      return step_of_creepage * speed;
  }
}

/// Central difference, or one-sided if one side has no solution.
Wrench WheelRailPair::difference(Workspace& workspace, const WheelState& state,
                                 const SolvedWheel& at, std::size_t variable) const {
  const double step = step_of(state, at, variable);
  const auto sum_at = [&](double factor) -> std::optional<Wrench> {
    WheelState moved = state;
    moved.*state_variables[variable] += factor * step;
    try {
      return solve(workspace, moved).sum;
    } catch (const contact::SolveError&) {
      return {};
    }
  };
  const std::optional<Wrench> above = sum_at(1.0), below = sum_at(-1.0);
  if (!above && !below)
    throw contact::SolveError(
        "the wheel has no solution on either side of this state, so its forces have no "
        "derivatives; do: "
        "solve without them");
  const double reach = step * ((above ? 1.0 : 0.0) + (below ? 1.0 : 0.0));
  Wrench found;
  add(above.value_or(at.sum), 1.0 / reach, found);
  add(below.value_or(at.sum), -1.0 / reach, found);
  return found;
}

}  // namespace rollfem::capi
