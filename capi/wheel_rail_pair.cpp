#include "capi/wheel_rail_pair.hpp"

#include "capi/patch_solution.hpp"
#include "contact/base/errors.hpp"
#include "wheelset/position.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::capi {

namespace {

using contact::Case;
using contact::Vector3;

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Every number of a state, with the bounds of case files.
void check(const WheelState& state, double rolling_radius) {
  const auto within = [](const char* name, double value, double limit) {
    if (std::abs(value) <= limit) return;  // not so of NaN
    throw contact::InputError(
        fmt::format("{} = {:g}: is out of bounds; allowed: magnitudes up to {:g}; do: correct it",
                    name, value, limit));
  };
  const auto positive = [](const char* name, double value, double limit) {
    if (value > 0.0 && value <= limit) return;
    throw contact::InputError(
        fmt::format("{} = {:g}: is out of bounds; allowed: above 0, up to {:g}; do: correct it",
                    name, value, limit));
  };
  const double speed = state.forward_speed;
  positive("forward_speed in mm/s", speed, 1e9);
  positive("vertical_force in N", state.vertical_force, 1e12);
  within("lateral_shift in mm", state.lateral_shift, 1e3);
  within("yaw in rad", state.yaw, 0.2);
  if (!std::isnan(state.roll)) within("roll in rad", state.roll, 0.2);
  within("lateral_velocity over forward_speed", state.lateral_velocity / speed, 1.0);
  within("yaw_rate over forward_speed in rad/mm", state.yaw_rate / speed, 1.0);
  within("rotation_speed times rolling_radius over forward_speed, less 1,",
         state.rotation_speed * rolling_radius / speed - 1.0, 1.0);
}
Case case_of(Case input, const WheelState& state) {
  contact::Wheelset& wheelset = input.wheelset;
  wheelset.lateral_shift.assign(1, state.lateral_shift);
  wheelset.yaw.assign(1, state.yaw);
  wheelset.roll.clear();
  if (!std::isnan(state.roll)) wheelset.roll.push_back(state.roll);
  wheelset.lateral_velocity = state.lateral_velocity / state.forward_speed;
  wheelset.yaw_velocity = state.yaw_rate / state.forward_speed;
  wheelset.rotation_change.assign(
      1, state.rotation_speed * input.wheel.rolling_radius / state.forward_speed - 1.0);
  input.load.vertical_force = state.vertical_force;
  return input;
}

/// The contact of a scene that the balance has given its load.
const meshes::WheelRailContact& contact_of(const contact::Scene& scene,
                                           const std::vector<meshes::PlacedScene>& placed) {
  const auto found = std::find_if(placed.begin(), placed.end(), [&](const auto& one) {
    return one.contact.place.y_track == scene.place->y_track;
  });
  if (found == placed.end()) throw std::logic_error("a patch in balance that was not found before");
  return found->contact;
}

void add(const contact::PointResult& point, const meshes::WheelRailContact& contact,
         SolvedWheel& wheel) {
  SolvedPatch patch{contact, point};
  const Vector3 arm{contact.origin[0] - contact.axle.point[0],
                    contact.origin[1] - contact.axle.point[1],
                    contact.origin[2] - contact.axle.point[2]};
  for (int d = 0; d < 3; ++d)
    patch.force[d] = point.longitudinal_force * contact.along[d] +
                     point.lateral_force * contact.across[d] +
                     point.normal_force * contact.normal[d];
  const Vector3 moment = cross(arm, patch.force);
  for (int d = 0; d < 3; ++d) {
    wheel.force[d] += patch.force[d];
    wheel.moment[d] += moment[d] + point.spin_moment * contact.normal[d];
  }
  wheel.height = contact.pose.height;
  wheel.patches.push_back(std::move(patch));
}

}  // namespace

WheelRailPair::WheelRailPair(Case input)
    : input_(std::move(input)), search_(meshes::search_scene_of(input_)) {}

SolvedWheel WheelRailPair::solve(const WheelState& state) const {
  check(state, input_.wheel.rolling_radius);
  const Case input = case_of(input_, state);
  meshes::SearchOptions options;
  options.with_reserve = true;
  const std::vector<meshes::PlacedScene> placed = meshes::make_scenes(input, search_, options);
  SolvedWheel wheel;
  if (placed.size() == 1) {
    add(solve_patch(placed.front().scene, placed.front().contact,
                    input.contact_grid.elements_across),
        placed.front().contact, wheel);
    return wheel;
  }
  for (const contact::Scene& scene : wheelset::balanced_position(input, placed)) {
    const meshes::WheelRailContact& contact = contact_of(scene, placed);
    add(solve_patch(scene, contact, input.contact_grid.elements_across), contact, wheel);
  }
  std::stable_sort(wheel.patches.begin(), wheel.patches.end(), [](const auto& a, const auto& b) {
    return a.point.normal_force > b.point.normal_force;
  });
  return wheel;
}

}  // namespace rollfem::capi
