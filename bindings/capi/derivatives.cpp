// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives of the forces on a wheel by its state (WheelRailPair::linearise).
#include "bindings/capi/wheel_rail_pair.hpp"
#include "contact/base/errors.hpp"
#include "track/motion/wheelset_motion.hpp"

#include <array>
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

/// A variable of the state, and the step of its difference.
struct Variable {
  double rollfem_state::*member;
  double step;
};

/// In the order of rollfem.h.
std::array<Variable, ROLLFEM_STATE_VARIABLES> variables_of(const rollfem_state& state,
                                                           const rollfem_result& at,
                                                           double rolling_radius) {
  const double of_velocity = step_of_creepage * state.forward_speed;
  const bool by_force = state.given == ROLLFEM_VERTICAL_FORCE;
  return {{{&rollfem_state::lateral_shift, step_of_shift},
           {&rollfem_state::yaw, step_of_angle},
           {&rollfem_state::roll, step_of_angle},
           {&rollfem_state::forward_speed, of_velocity},
           {&rollfem_state::lateral_velocity, of_velocity},
           {&rollfem_state::yaw_rate, of_velocity / half_gauge},
           {&rollfem_state::rotation_speed, of_velocity / rolling_radius},
           {by_force                        ? &rollfem_state::vertical_force
            : state.given == ROLLFEM_HEIGHT ? &rollfem_state::height
                                            : &rollfem_state::penetration,
            step_of_load * (by_force ? state.vertical_force : at.penetration)}}};
}

}  // namespace

rollfem_result WheelRailPair::linearise(const rollfem_state& state, WheelDerivatives& found) const {
  check(state, input_.wheel.rolling_radius);
  const Lent lent = workspace();
  const rollfem_result at = solve(*lent, state);
  found = {};
  if (at.patch_count == 0) return at;
  const bool responds = lent->solved != nullptr && respond(*lent, state, found);
  // The response takes the friction of every slip relative to the speed as unchanged by the speed.
  const int differences = ROLLFEM_BY_FORWARD_SPEED + (friction_falls() ? 1 : 0);
  const int count = responds ? differences : ROLLFEM_STATE_VARIABLES;
  for (int k = 0; k < count; ++k)
    if (k != ROLLFEM_BY_ROLL || !std::isnan(state.roll))
      found.by.col(k) = difference(*lent, state, at, k);
  if (responds) return at;
  if (state.given != ROLLFEM_VERTICAL_FORCE) {
    found.stiffness = -found.by(2, ROLLFEM_BY_LOAD);
    return at;
  }
  rollfem_state sunk = state;
  sunk.given = ROLLFEM_PENETRATION;
  sunk.penetration = at.penetration;
  found.stiffness = -difference(*lent, sunk, at, ROLLFEM_BY_LOAD)[2];
  return at;
}

/// Columns of the velocities and the load, from the solution in the workspace. False if that fails.
bool WheelRailPair::respond(Workspace& workspace, const rollfem_state& state,
                            WheelDerivatives& found) const {
  QuickWheel& quick = *workspace.solved;
  if (!quick.respond(workspace.load, workspace.responses)) return false;
  const double speed = state.forward_speed;
  const track::Motion motion =
      track::motion_of(workspace.input, workspace.input.wheelset.rotation_change.front());
  Wrench by_sinking = Wrench::Zero();
  // At fixed pressures, relative to the forward speed.
  Eigen::Matrix<double, 6, 3> by_motion = Eigen::Matrix<double, 6, 3>::Zero();
  for (std::size_t k = 0; k < quick.patches().size(); ++k) {
    const QuickContact& contact = quick.patches()[k]->given();
    const PatchResponse& response = workspace.responses[k];
    by_sinking += wrenches_of(*contact.contact) * response.by_sinking;
    by_motion += wrenches_of(*contact.contact) * response.by_creepage * contact.by_motion;
  }
  found.stiffness = -by_sinking[2];
  const bool by_force = state.given == ROLLFEM_VERTICAL_FORCE;
  if (by_force && !(found.stiffness > 0.0)) return false;
  // Under a given vertical force the wheel sinks or rises until the force is restored.
  const auto settled = [&](const Wrench& change) -> Wrench {
    return by_force ? Wrench(change + change[2] / found.stiffness * by_sinking) : change;
  };
  const Eigen::Vector3d moves(motion.rotation, motion.lateral_velocity, motion.yaw_velocity);
  found.by.col(ROLLFEM_BY_FORWARD_SPEED) = settled(-by_motion * moves / speed);
  found.by.col(ROLLFEM_BY_ROTATION_SPEED) = settled(by_motion.col(0) / speed);
  found.by.col(ROLLFEM_BY_LATERAL_VELOCITY) = settled(by_motion.col(1) / speed);
  found.by.col(ROLLFEM_BY_YAW_RATE) = settled(by_motion.col(2) / speed);
  found.by.col(ROLLFEM_BY_LOAD) = by_sinking * (by_force ? 1.0 / found.stiffness : 1.0);
  return true;
}

/// Central difference, or one-sided if one side has no solution.
Wrench WheelRailPair::difference(Workspace& workspace, const rollfem_state& state,
                                 const rollfem_result& at, int variable) const {
  const auto [member, step] =
      variables_of(state, at, input_.wheel.rolling_radius)[static_cast<std::size_t>(variable)];
  const auto sum_at = [&, member = member,
                       step = step](double factor) -> std::optional<rollfem_result> {
    rollfem_state moved = state;
    moved.*member += factor * step;
    try {
      return solve(workspace, moved);
    } catch (const contact::SolveError&) {
      return {};
    }
  };
  const std::optional<rollfem_result> above = sum_at(1.0), below = sum_at(-1.0);
  if (!above && !below)
    throw contact::SolveError(
        "the wheel has no solution on either side of this state, so its forces have no "
        "derivatives; do: "
        "solve without them");
  const double reach = step * ((above ? 1.0 : 0.0) + (below ? 1.0 : 0.0));
  const auto wrench_of = [](const rollfem_result& wheel) {
    Wrench wrench;
    wrench << Eigen::Vector3d(wheel.force), Eigen::Vector3d(wheel.moment);
    return wrench;
  };
  return (wrench_of(above.value_or(at)) - wrench_of(below.value_or(at))) / reach;
}

}  // namespace rollfem::capi
