// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/capi/wheel_rail_pair.hpp"

#include "contact/base/errors.hpp"
#include "contact/result/validity.hpp"
#include "halfspace/model/level.hpp"
#include "halfspace/patch/correction_scene.hpp"
#include "track/balance/position.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

namespace rollfem::capi {

using contact::Case;

Eigen::Matrix<double, 6, PatchSum::count> wrenches_of(const track::WheelRailContact& contact) {
  contact::Vector3 arm{};
  for (std::size_t d = 0; d < 3; ++d) arm[d] = contact.origin[d] - contact.middle[d];
  const auto vector = [](const contact::Vector3& v) { return Eigen::Vector3d(v[0], v[1], v[2]); };
  const auto force = [&](const contact::Vector3& axis) {
    Wrench wrench;
    wrench << vector(axis), vector(contact::cross(arm, axis));
    return wrench;
  };
  Eigen::Matrix<double, 6, PatchSum::count> wrenches;
  wrenches << force(contact.along), force(contact.across), force(contact.normal), Wrench::Zero(),
      Wrench::Zero();
  wrenches.col(PatchSum::spin_moment).tail<3>() = vector(contact.normal);
  return wrenches;
}

void check(const rollfem_state& state, double rolling_radius) {
  const auto within = [](const char* name, double value, double limit, bool above_zero = false) {
    if (std::abs(value) <= limit && (value > 0.0 || !above_zero)) return;  // false for NaN
    throw contact::InputError(
        fmt::format("{} = {:g}: is out of bounds; allowed: {} {:g}; do: correct it", name, value,
                    above_zero ? "above 0, up to" : "magnitudes up to", limit));
  };
  const double speed = state.forward_speed;
  within("forward_speed in mm/s", speed, 1e9, true);
  if (state.given == ROLLFEM_VERTICAL_FORCE)
    within("vertical_force in N", state.vertical_force, 1e12, true);
  else if (state.given == ROLLFEM_HEIGHT)
    within("height in mm", state.height, 1e3);
  else
    within("penetration in mm", state.penetration, 1e3);
  within("lateral_shift in mm", state.lateral_shift, 1e3);
  within("yaw in rad", state.yaw, 0.2);
  if (!std::isnan(state.roll)) within("roll in rad", state.roll, 0.2);
  within("lateral_velocity over forward_speed", state.lateral_velocity / speed, 1.0);
  within("yaw_rate over forward_speed in rad/mm", state.yaw_rate / speed, 1.0);
  within("rotation_speed times rolling_radius over forward_speed, less 1,",
         state.rotation_speed * rolling_radius / speed - 1.0, 1.0);
}

namespace {

/// Writes a state into a case. A given height or penetration goes to the search (SearchOptions).
void set(const rollfem_state& state, Case& input) {
  contact::Wheelset& wheelset = input.wheelset;
  wheelset.lateral_shift.assign(1, state.lateral_shift);
  wheelset.yaw.assign(1, state.yaw);
  wheelset.roll.clear();
  if (!std::isnan(state.roll)) wheelset.roll.push_back(state.roll);
  wheelset.lateral_velocity = state.lateral_velocity / state.forward_speed;
  wheelset.yaw_velocity = state.yaw_rate / state.forward_speed;
  wheelset.rotation_change.assign(
      1, state.rotation_speed * input.wheel.rolling_radius / state.forward_speed - 1.0);
  input.rolling.speed = state.forward_speed;
  input.load = {};
  if (state.given == ROLLFEM_VERTICAL_FORCE)
    input.load.vertical_force = state.vertical_force;
  else
    input.load.approach = 1.0;  // a placeholder: the search overrides it
}

/// Adds a patch to its wheel, where the most loaded ones are listed first.
void add_patch(const contact::PointResult& point, double max_pressure_bar,
               const track::WheelRailContact& contact, rollfem_result& wheel) {
  const Wrench wrench = wrenches_of(contact) * PatchSums(point.longitudinal_force,
                                                         point.lateral_force, point.normal_force,
                                                         point.lateral_pressure, point.spin_moment);
  rollfem_patch patch{};
  for (int d = 0; d < 3; ++d) {
    patch.position[d] = contact.origin[static_cast<std::size_t>(d)];
    patch.force[d] = wrench[d];
    wheel.force[d] += wrench[d];
    wheel.moment[d] += wrench[3 + d];
  }
  patch.contact_angle = contact.place.contact_angle;
  patch.rolling_radius = contact.place.rolling_radius;
  patch.longitudinal_creepage = point.creepage.longitudinal;
  patch.lateral_creepage = point.creepage.lateral;
  patch.spin = point.creepage.spin;
  patch.normal_force = point.normal_force;
  patch.longitudinal_force = point.longitudinal_force;
  patch.lateral_force = point.lateral_force;
  patch.lateral_pressure = point.lateral_pressure;
  patch.spin_moment = point.spin_moment;
  patch.length = point.contact_length;
  patch.width = point.contact_width;
  patch.area = point.contact_area;
  patch.adhesion_area = point.adhesion_area;
  patch.max_pressure = point.max_pressure;
  patch.max_pressure_bar = max_pressure_bar;
  patch.creepage_work = point.creepage_work.value_or(0.0);
  wheel.creepage_work += patch.creepage_work;
  wheel.roll = contact.pose.roll;
  wheel.touching_height = contact.pose.height;
  rollfem_patch* end = wheel.patch + wheel.patch_count;
  rollfem_patch* place = std::find_if(wheel.patch, end, [&](const rollfem_patch& other) {
    return other.normal_force < patch.normal_force;
  });
  if (wheel.patch_count == ROLLFEM_MAX_PATCHES) {
    ++wheel.patches_unlisted;
    if (place == end--) return;
  } else {
    ++wheel.patch_count;
  }
  std::move_backward(place, end, end + 1);
  *place = patch;
}

/// Solves the first load point with the model halfspace on one grid, without the coarser grids
/// needed for error bars, and adds its patch. Throws contact::SolveError and contact::InputError as
/// the model does.
void solve_patch(const contact::Scene& scene, int across, const track::WheelRailContact& contact,
                 rollfem_result& wheel) {
  const halfspace::PatchSearch search(scene);
  const halfspace::PatchExtent extent = search.extent();
  contact::LevelResult level = halfspace::solve_level(scene, search, extent.length / across,
                                                      extent.width / across, nullptr, "", {});
  contact::ModelResult result;
  result.name = "halfspace";
  result.grid = level.grid;
  result.points = std::move(level.points);
  contact::check_validity(scene, result);
  contact::PointResult& point = result.points.front();
  const PeakPressure::Peak peak =
      PeakPressure(scene.material.contact_modulus)
          .of(halfspace::halfspace_geometry(scene), result.grid, point.fields.traction.n);
  point.max_pressure = peak.pressure;
  add_patch(point, peak.bar, contact, wheel);
  wheel.penetration = std::max(wheel.penetration, (point.approach + contact.place.separation) /
                                                      std::cos(contact.place.contact_angle));
}

/// Margin around the overlap of the bodies, mm: more than a grid on the patch needs.
constexpr double around_overlap = 10.0;

/// Largest separation, mm, of a near miss to describe: none.
constexpr double none = -contact::infinity;

track::SearchOptions search_options(const rollfem_state& state) {
  track::SearchOptions options;
  options.with_reserve = true;
  if (state.given == ROLLFEM_HEIGHT) options.height = state.height;
  if (state.given == ROLLFEM_PENETRATION) options.sinking = state.penetration;
  return options;
}

/// Given depth below first touch, mm.
std::optional<double> sinking_of(const rollfem_state& state, double touching_height) {
  if (state.given == ROLLFEM_VERTICAL_FORCE) return {};
  return state.given == ROLLFEM_HEIGHT ? state.height - touching_height : state.penetration;
}

bool touches(const track::WheelRailContact& contact) {
  return contact.place.patch > 0;
}

/// Result of a wheel held above the rail.
rollfem_result apart(const track::WheelsetPose& pose, double sinking) {
  rollfem_result wheel{};
  wheel.roll = pose.roll;
  wheel.touching_height = pose.height;
  wheel.penetration = sinking;
  return wheel;
}

/// Surfaces tried in this order: a patch that reaches into another contact of the wheel forms one
/// conformal contact with it, which no plane can represent.
constexpr contact::SurfaceForm surfaces[] = {contact::SurfaceForm::automatic,
                                             contact::SurfaceForm::curved};

}  // namespace

WheelRailPair::Lent WheelRailPair::workspace() const {
  Lent lent(nullptr, [this](Workspace* used) {
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.emplace_back(used);
  });
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!idle_.empty()) {
      lent.reset(idle_.back().release());
      idle_.pop_back();
      return lent;
    }
  }
  lent.reset(new Workspace);
  lent->input = input_;
  for (const auto& tables : tables_)
    lent->wheels.push_back(
        std::make_unique<QuickWheel>(*tables, tables == tables_.back(), material_));
  return lent;
}

WheelRailPair::WheelRailPair(Case input)
    : input_(std::move(input)),
      search_(track::search_scene_of(input_)),
      material_(contact::combine(input_.wheel.material, input_.rail.material)),
      friction_(contact::friction_of(input_)) {
  if (input_.layer) material_.layer = input_.layer->compliance();
  const int across = input_.contact_grid.elements_across;
  const bool softens = input_.layer && input_.layer->hardening.value_or(0.0) < 0.0;
  if (material_.couples() || softens || across > QuickWheel::most_across) return;
  for (const int elements : {across, QuickWheel::across_any_patch})
    tables_.push_back(std::make_unique<halfspace::InfluenceTables>(
        across + 2 * QuickPatch::margin, elements + 2 * QuickPatch::margin, material_.uncoupled()));
}

rollfem_result WheelRailPair::solve(const rollfem_state& state) const {
  check(state, input_.wheel.rolling_radius);
  return solve(*workspace(), state);
}

rollfem_result WheelRailPair::solve(Workspace& workspace, const rollfem_state& state) const {
  set(state, workspace.input);
  workspace.solved = nullptr;
  contact::SurfaceForm& surface = workspace.input.halfspace.surface;
  for (auto form = std::begin(surfaces); !tables_.empty() && form != std::end(surfaces); ++form) {
    surface = *form;
    rollfem_result wheel{};
    const QuickOutcome outcome = solve_quickly(workspace, state, wheel);
    if (outcome == QuickOutcome::solved) return wheel;
    if (outcome == QuickOutcome::unfit) break;
  }
  std::exception_ptr first;
  for (const contact::SurfaceForm form : surfaces) {
    surface = form;
    try {
      return solve_with_care(workspace.input, state);
    } catch (const contact::SolveError&) {
      if (!first) first = std::current_exception();
    }
  }
  std::rethrow_exception(first);
}

QuickOutcome WheelRailPair::solve_quickly(Workspace& workspace, const rollfem_state& state,
                                          rollfem_result& wheel) const {
  const Case& input = workspace.input;
  track::SearchOptions options = search_options(state);
  options.around_overlap = around_overlap;
  options.near_miss = none;
  workspace.found = track::find_contacts(input, search_, 1, options);
  const track::WheelsetPose& pose = workspace.found.front().pose;
  workspace.load = {input.load.vertical_force.value_or(0.0), sinking_of(state, pose.height),
                    friction_falls() ? contact::friction_of(input) : friction_};
  const bool touch = std::any_of(workspace.found.begin(), workspace.found.end(), touches);
  if (const auto& sinking = workspace.load.sinking; sinking && !(*sinking > 0.0 && touch)) {
    wheel = apart(pose, *sinking);
    return QuickOutcome::solved;
  }
  const track::Motion motion = track::motion_of(input, input.wheelset.rotation_change.front());
  std::vector<QuickContact>& contacts = workspace.contacts;
  contacts.clear();
  for (track::WheelRailContact& contact : workspace.found) {
    if (!(touches(contact) || contact.reserve)) continue;
    QuickContact one;
    one.contact = &contact;
    one.creepage = track::creepage_of(contact, motion);
    one.by_motion = track::creepage_by_motion(contact);
    one.geometry.surface = contact::ContactSurface::of(
        std::make_shared<const contact::PatchGeometry>(std::move(contact.geometry)));
    if (input.halfspace.surface == contact::SurfaceForm::automatic)
      one.geometry.surface.follows = track::follows_surface(contact.spread_of_normals);
    contacts.push_back(std::move(one));
  }
  QuickOutcome outcome = QuickOutcome::unfit;
  for (auto quick = workspace.wheels.begin();
       outcome == QuickOutcome::unfit && quick != workspace.wheels.end(); ++quick) {
    outcome = (*quick)->solve(contacts, workspace.load);
    if (outcome == QuickOutcome::solved) workspace.solved = quick->get();
  }
  if (outcome != QuickOutcome::solved) return outcome;
  for (const QuickPatch* patch : workspace.solved->patches())
    add_patch(patch->point(), patch->max_pressure_bar(), patch->contact(), wheel);
  wheel.penetration = workspace.solved->sinking();
  return outcome;
}

rollfem_result WheelRailPair::solve_with_care(const Case& input, const rollfem_state& state) const {
  rollfem_result wheel{};
  std::vector<track::PlacedScene> placed =
      track::make_scenes(input, search_, search_options(state));
  const track::WheelsetPose& pose = placed.front().contact.pose;
  if (const auto sinking = sinking_of(state, pose.height)) {
    const bool touch = std::any_of(placed.begin(), placed.end(),
                                   [](const auto& one) { return touches(one.contact); });
    if (!(*sinking > 0.0 && touch)) return apart(pose, *sinking);
    for (track::PlacedScene& one : placed)
      one.scene.points.front().load.approach =
          *sinking * std::cos(one.contact.place.contact_angle) - one.contact.place.separation;
  }
  const int across = input.contact_grid.elements_across;
  if (placed.size() == 1)
    solve_patch(placed.front().scene, across, placed.front().contact, wheel);
  else
    for (const contact::Scene& scene : track::balanced_position(input, placed))
      solve_patch(scene, across, track::contact_of(scene, placed), wheel);
  return wheel;
}

}  // namespace rollfem::capi
