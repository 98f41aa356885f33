// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/balance/pressed_wheel.hpp"

#include "base/errors.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "track/balance/position.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::track {

using contact::Case;
using contact::Creepage;
using contact::cross;
using contact::dot;
using contact::PointResult;
using contact::Scene;
using contact::Vector3;

namespace {

/// One load point without friction, motion or output.
Case frictionless(Case input) {
  input.friction_coefficient = 0.0;
  input.wheelset.free_rolling = contact::FreeRolling::none;
  input.wheelset.rotation_change.clear();
  input.rolling.creepages = {Creepage{}};
  input.rolling.forces.clear();
  input.subsurface.clear();
  input.output.stress_maxima = false;
  input.accuracy.reset();
  return input;
}

double bar_of(const PointResult& point, const char* quantity, double none) {
  const auto bar = point.error_estimate.find(quantity);
  return bar == point.error_estimate.end() ? none : bar->second;
}

}  // namespace

PressedWheel::PressedWheel(const Case& input, const SearchScene& search)
    : extra_slip_(input.rolling.extra_slip != contact::ExtraSlip::none),
      rolling_radius_(input.wheel.rolling_radius) {
  const Case without = frictionless(input);
  SearchOptions options;
  options.with_reserve = input.load.vertical_force.has_value();
  const std::vector<PlacedScene> placed = make_scenes(without, search, options);
  std::vector<Scene> scenes = balanced_position(without, placed);
  if (scenes.empty()) throw contact::SolveError("no contact carries load");
  state_.contacts = static_cast<int>(scenes.size());
  for (Scene& scene : scenes) {
    const WheelRailContact& where = contact_of(scene, placed);
    press(std::move(scene), where);
  }
}

void PressedWheel::press(Scene scene, const WheelRailContact& where) {
  const PointResult pressed = halfspace::run_halfspace(scene, {}).points.front();
  contact::NormalLoad& load = scene.points.front().load;
  const bool along_normal = load.force && load.direction[0] == 0.0;
  const double force = along_normal ? *load.force : pressed.normal_force;
  load = {force, {}};
  if (contacts_.empty()) {
    const halfspace::PatchExtent extent = halfspace::PatchSearch(scene).extent();
    state_.place = *scene.place;
    state_.semi_axis_x = 0.5 * extent.length;
    state_.semi_axis_y = 0.5 * extent.width;
    state_.lateral_pressure = pressed.lateral_force;
  }
  state_.normal_force += force;
  state_.max_pressure = std::max(state_.max_pressure, pressed.max_pressure);
  state_.contact_area += pressed.contact_area;
  contacts_.push_back(
      {std::move(scene), where, pressed.lateral_force, pressed.normal_force, pressed.spin_moment});
}

std::vector<Creepage> PressedWheel::creepages_of(const Contact& contact,
                                                 const std::vector<Creepage>& creepages) const {
  if (&contact == &contacts_.front()) return creepages;
  const auto rolling = [&](const WheelRailContact& where) {
    const Motion motion{1.0 / rolling_radius_, 0.0, 0.0};
    const Creepage at = extra_slip_ ? creepage_of(where, motion) : creepage_on_rail(where, motion);
    return Eigen::Vector3d(at.longitudinal, at.lateral, at.spin);
  };
  const WheelRailContact &main = contacts_.front().where, &own = contact.where;
  const Eigen::Vector3d main_rolling = rolling(main), own_rolling = rolling(own);
  const Eigen::Matrix3d own_by_main =
      creepage_by_motion(own, !extra_slip_) * creepage_by_motion(main, !extra_slip_).inverse();
  std::vector<Creepage> found;
  for (const Creepage& wanted : creepages) {
    const Eigen::Vector3d given(wanted.longitudinal, wanted.lateral, wanted.spin);
    const Eigen::Vector3d here = own_rolling + own_by_main * (given - main_rolling);
    found.push_back({here[0], here[1], here[2]});
  }
  return found;
}

void PressedWheel::add(const Contact& contact, double coefficient, const PointResult& point,
                       FrictionForce& sum) const {
  const double bound = coefficient * contact.normal;
  const double force_bar =
      std::hypot(bar_of(point, "longitudinal_force", bound), bar_of(point, "lateral_force", bound));
  const double size = std::sqrt(state_.semi_axis_x * state_.semi_axis_y);
  const double moment_bar = bar_of(point, "spin_moment", bound * size);
  const double along = point.longitudinal_force, across = point.lateral_force - contact.lateral,
               normal = point.normal_force - contact.normal,
               spin_moment = point.spin_moment - contact.spin_moment;
  sum.force_bar += force_bar;
  if (&contact == &contacts_.front()) {
    sum.longitudinal += along;
    sum.lateral += across;
    sum.normal += normal;
    sum.spin_moment += spin_moment;
    sum.moment_bar += moment_bar;
    return;
  }
  const WheelRailContact &main = contacts_.front().where, &own = contact.where;
  Vector3 force{}, arm{};
  for (std::size_t d = 0; d < 3; ++d) {
    force[d] = along * own.along[d] + across * own.across[d] + normal * own.normal[d];
    arm[d] = own.origin[d] - main.origin[d];
  }
  sum.longitudinal += dot(force, main.along);
  sum.lateral += dot(force, main.across);
  sum.normal += dot(force, main.normal);
  sum.spin_moment +=
      dot(cross(arm, force), main.normal) + spin_moment * dot(own.normal, main.normal);
  sum.moment_bar += moment_bar + std::sqrt(dot(arm, arm)) * force_bar;
}

std::vector<FrictionForce> PressedWheel::forces(
    const std::vector<Creepage>& creepages, const contact::Friction& friction,
    const std::optional<contact::SurfaceHeat>& heat) const {
  std::vector<FrictionForce> sums(creepages.size());
  for (const Contact& contact : contacts_) {
    Scene scene = contact.scene;
    scene.friction_law = friction;
    scene.heat = heat;
    const std::vector<Creepage> own = creepages_of(contact, creepages);
    scene.points.assign(own.size(), scene.points.front());
    for (std::size_t k = 0; k < own.size(); ++k) scene.points[k].creepage = own[k];
    const contact::ModelResult result = halfspace::run_halfspace(scene, {});
    for (std::size_t k = 0; k < own.size(); ++k) {
      add(contact, friction->coefficient(), result.points[k], sums[k]);
      if (heat && result.points[k].max_temperature)
        sums[k].rise =
            std::max(sums[k].rise, *result.points[k].max_temperature - heat->contact_temperature());
    }
  }
  return sums;
}

}  // namespace rollfem::track
