// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/pair/wheel_rail_pair.hpp"

#include "base/errors.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/patch/load_sharing.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "result/validity.hpp"
#include "track/balance/position.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

namespace rollfem::track {

using contact::Case;
using halfspace::PatchSum;
using halfspace::QuickContact;
using halfspace::QuickOutcome;

namespace {

/// The wrenches of unit resultants of a patch: this matrix times PatchSums is their wrench.
Eigen::Matrix<double, 6, PatchSum::count> wrenches_of(const WheelRailContact& contact) {
  const contact::Vector3 arm = contact::plus(contact.origin, contact.middle, -1.0);
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

/// Checks every number of a state against the bounds of case files.
void check(const WheelState& state, double rolling_radius) {
  const auto within = [](const char* name, double value, double limit, bool above_zero = false) {
    if (std::abs(value) <= limit && (value > 0.0 || !above_zero)) return;  // false for NaN
    throw contact::InputError(
        fmt::format("{} = {:g}: is out of bounds; allowed: {} {:g}; do: correct it", name, value,
                    above_zero ? "above 0, up to" : "magnitudes up to", limit));
  };
  const double speed = state.forward_speed;
  within("forward_speed in mm/s", speed, 1e9, true);
  if (state.given == GivenLoad::vertical_force)
    within("vertical_force in N", state.load, 1e12, true);
  else
    within(state.given == GivenLoad::height ? "height in mm" : "penetration in mm", state.load,
           1e3);
  within("lateral_shift in mm", state.lateral_shift, 1e3);
  within("yaw in rad", state.yaw, 0.2);
  if (!std::isnan(state.roll)) within("roll in rad", state.roll, 0.2);
  within("lateral_velocity over forward_speed", state.lateral_velocity / speed, 1.0);
  within("yaw_rate over forward_speed in rad/mm", state.yaw_rate / speed, 1.0);
  within("rotation_speed times rolling_radius over forward_speed, less 1,",
         state.rotation_speed * rolling_radius / speed - 1.0, 1.0);
}

/// Writes a state into a case. A given height or penetration goes to the search (SearchOptions).
void set(const WheelState& state, Case& input) {
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
  if (state.given == GivenLoad::vertical_force)
    input.load.vertical_force = state.load;
  else
    input.load.approach = 1.0;  // a placeholder: the search overrides it
}

/// Adds a patch to its wheel, where the most loaded ones are listed first.
void add_patch(contact::PointResult point, const WheelRailContact& contact, WheelOnRail& wheel) {
  point.fields = {};
  WheelPatch patch{contact.place, contact.origin, Wrench::Zero(), std::move(point)};
  const contact::PointResult& of = patch.point;
  patch.wrench = wrenches_of(contact) * halfspace::PatchSums(of.longitudinal_force,
                                                             of.lateral_force, of.normal_force,
                                                             of.lateral_pressure, of.spin_moment);
  wheel.wrench += patch.wrench;
  wheel.roll = contact.pose.roll;
  wheel.touching_height = contact.pose.height;
  const auto place = std::find_if(
      wheel.patches.begin(), wheel.patches.end(),
      [&](const WheelPatch& other) { return other.point.normal_force < of.normal_force; });
  wheel.patches.insert(place, std::move(patch));
}

/// Solves the first load point with the model halfspace on one grid, without the coarser grids
/// needed for error bars, and adds its patch. Throws contact::SolveError and contact::InputError as
/// the model does.
void solve_patch(const contact::Scene& scene, int across, const WheelRailContact& contact,
                 WheelOnRail& wheel) {
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
  const halfspace::PeakPressure::Peak peak =
      halfspace::PeakPressure(scene.material.contact_modulus)
          .of(halfspace::halfspace_geometry(scene), result.grid, point.fields.traction.n);
  point.max_pressure = peak.pressure;
  point.error_estimate["max_pressure"] = peak.bar;
  wheel.penetration = std::max(wheel.penetration, (point.approach + contact.place.separation) /
                                                      std::cos(contact.place.contact_angle));
  add_patch(std::move(point), contact, wheel);
}

/// Margin around the overlap of the bodies, mm: more than a grid on the patch needs.
constexpr double around_overlap = 10.0;

/// Largest separation, mm, of a near miss to describe: none.
constexpr double none = -contact::infinity;

SearchOptions search_options(const WheelState& state) {
  SearchOptions options;
  options.with_reserve = true;
  if (state.given == GivenLoad::height) options.height = state.load;
  if (state.given == GivenLoad::penetration) options.sinking = state.load;
  return options;
}

/// Given depth below first touch, mm.
std::optional<double> sinking_of(const WheelState& state, double touching_height) {
  if (state.given == GivenLoad::vertical_force) return {};
  return state.given == GivenLoad::height ? state.load - touching_height : state.load;
}

bool touches(const WheelRailContact& contact) {
  return contact.place.patch > 0;
}

/// Result of a wheel held above the rail.
WheelOnRail apart(const WheelsetPose& pose, double sinking) {
  WheelOnRail wheel{};
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
        std::make_unique<halfspace::QuickWheel>(*tables, tables == tables_.back(), material_));
  return lent;
}

WheelRailPair::WheelRailPair(Case input)
    : input_(std::move(input)),
      search_(search_scene_of(input_)),
      material_(contact::combine(input_.wheel.material, input_.rail.material)),
      friction_(contact::friction_of(input_)) {
  if (input_.layer) material_.layer = input_.layer->compliance();
  const int across = input_.contact_grid.elements_across;
  const bool softens = input_.layer && input_.layer->hardening.value_or(0.0) < 0.0;
  if (material_.couples() || softens || across > halfspace::QuickWheel::most_across) return;
  for (const int elements : {across, halfspace::QuickWheel::across_any_patch})
    tables_.push_back(std::make_unique<halfspace::InfluenceTables>(
        across + 2 * halfspace::QuickPatch::margin, elements + 2 * halfspace::QuickPatch::margin,
        material_.uncoupled()));
}

WheelOnRail WheelRailPair::solve(const WheelState& state) const {
  check(state, input_.wheel.rolling_radius);
  return solve(*workspace(), state);
}

WheelOnRail WheelRailPair::solve(Workspace& workspace, const WheelState& state) const {
  set(state, workspace.input);
  workspace.solved = nullptr;
  contact::SurfaceForm& surface = workspace.input.surface;
  for (auto form = std::begin(surfaces); !tables_.empty() && form != std::end(surfaces); ++form) {
    surface = *form;
    WheelOnRail wheel{};
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

QuickOutcome WheelRailPair::solve_quickly(Workspace& workspace, const WheelState& state,
                                          WheelOnRail& wheel) const {
  const Case& input = workspace.input;
  SearchOptions options = search_options(state);
  options.around_overlap = around_overlap;
  options.near_miss = none;
  workspace.found = find_contacts(input, search_, 1, options);
  const WheelsetPose& pose = workspace.found.front().pose;
  workspace.load = {input.load.vertical_force.value_or(0.0), sinking_of(state, pose.height),
                    friction_falls() ? contact::friction_of(input) : friction_,
                    contact::surface_heat(input)};
  const bool touch = std::any_of(workspace.found.begin(), workspace.found.end(), touches);
  if (const auto& sinking = workspace.load.sinking; sinking && !(*sinking > 0.0 && touch)) {
    wheel = apart(pose, *sinking);
    return QuickOutcome::solved;
  }
  const Motion motion = motion_of(input, input.wheelset.rotation_change.front());
  std::vector<QuickContact>& contacts = workspace.contacts;
  contacts.clear();
  workspace.by_motion.assign(workspace.found.size(), Eigen::Matrix3d::Zero());
  for (std::size_t k = 0; k < workspace.found.size(); ++k) {
    WheelRailContact& contact = workspace.found[k];
    if (!(touches(contact) || contact.reserve)) continue;
    workspace.by_motion[k] = creepage_by_motion(contact);
    QuickContact one{k,
                     contact.place,
                     {},
                     creepage_of(contact, motion),
                     contact.approach,
                     contact.reach,
                     contact.reserve};
    one.geometry.surface = contact::ContactSurface::of(
        std::make_shared<const contact::PatchGeometry>(std::move(contact.geometry)));
    if (input.surface == contact::SurfaceForm::automatic)
      one.geometry.surface.follows = follows_surface(contact.spread_of_normals);
    contacts.push_back(std::move(one));
  }
  QuickOutcome outcome = QuickOutcome::unfit;
  for (auto quick = workspace.wheels.begin();
       outcome == QuickOutcome::unfit && quick != workspace.wheels.end(); ++quick) {
    outcome = (*quick)->solve(contacts, workspace.load);
    if (outcome == QuickOutcome::solved) workspace.solved = quick->get();
  }
  if (outcome != QuickOutcome::solved) return outcome;
  for (const halfspace::QuickPatch* patch : workspace.solved->patches())
    add_patch(patch->point(), workspace.found[patch->given().number], wheel);
  wheel.penetration = workspace.solved->sinking();
  return outcome;
}

WheelOnRail WheelRailPair::solve_with_care(const Case& input, const WheelState& state) const {
  WheelOnRail wheel{};
  std::vector<PlacedScene> placed = make_scenes(input, search_, search_options(state));
  const WheelsetPose& pose = placed.front().contact.pose;
  if (const auto sinking = sinking_of(state, pose.height)) {
    const bool touch = std::any_of(placed.begin(), placed.end(),
                                   [](const auto& one) { return touches(one.contact); });
    if (!(*sinking > 0.0 && touch)) return apart(pose, *sinking);
    for (PlacedScene& one : placed)
      one.scene.points.front().load.approach =
          *sinking * std::cos(one.contact.place.contact_angle) - one.contact.place.separation;
  }
  const int across = input.contact_grid.elements_across;
  if (placed.size() == 1)
    solve_patch(placed.front().scene, across, placed.front().contact, wheel);
  else
    for (const contact::Scene& scene : balanced_position(input, placed))
      solve_patch(scene, across, contact_of(scene, placed), wheel);
  return wheel;
}

// Derivatives of the forces on a wheel by its state.

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
  double WheelState::*member;
  double step;
};

/// In the order of StateVariable.
std::array<Variable, StateVariable::count> variables_of(const WheelState& state,
                                                        const WheelOnRail& at,
                                                        double rolling_radius) {
  const double of_velocity = step_of_creepage * state.forward_speed;
  const bool by_force = state.given == GivenLoad::vertical_force;
  return {{{&WheelState::lateral_shift, step_of_shift},
           {&WheelState::yaw, step_of_angle},
           {&WheelState::roll, step_of_angle},
           {&WheelState::forward_speed, of_velocity},
           {&WheelState::lateral_velocity, of_velocity},
           {&WheelState::yaw_rate, of_velocity / half_gauge},
           {&WheelState::rotation_speed, of_velocity / rolling_radius},
           {&WheelState::load, step_of_load * (by_force ? state.load : at.penetration)}}};
}

}  // namespace

WheelOnRail WheelRailPair::linearise(const WheelState& state, WheelDerivatives& found) const {
  check(state, input_.wheel.rolling_radius);
  const Lent lent = workspace();
  const WheelOnRail at = solve(*lent, state);
  found = {};
  if (at.patches.empty()) return at;
  const bool responds = lent->solved != nullptr && respond(*lent, state, found);
  // The response takes the friction of every slip relative to the speed as unchanged by the speed.
  const int differences = StateVariable::forward_speed + (friction_falls() ? 1 : 0);
  const int count = responds ? differences : StateVariable::count;
  for (int k = 0; k < count; ++k)
    if (k != StateVariable::roll || !std::isnan(state.roll))
      found.by.col(k) = difference(*lent, state, at, k);
  if (responds) return at;
  if (state.given != GivenLoad::vertical_force) {
    found.stiffness = -found.by(2, StateVariable::load);
    return at;
  }
  WheelState sunk = state;
  sunk.given = GivenLoad::penetration;
  sunk.load = at.penetration;
  found.stiffness = -difference(*lent, sunk, at, StateVariable::load)[2];
  return at;
}

/// Columns of the velocities and the load, from the solution in the workspace. False if that fails.
bool WheelRailPair::respond(Workspace& workspace, const WheelState& state,
                            WheelDerivatives& found) const {
  halfspace::QuickWheel& quick = *workspace.solved;
  if (!quick.respond(workspace.load, workspace.responses)) return false;
  const double speed = state.forward_speed;
  const Motion motion =
      motion_of(workspace.input, workspace.input.wheelset.rotation_change.front());
  Wrench by_sinking = Wrench::Zero();
  // At fixed pressures, relative to the forward speed.
  Eigen::Matrix<double, 6, 3> by_motion = Eigen::Matrix<double, 6, 3>::Zero();
  for (std::size_t k = 0; k < quick.patches().size(); ++k) {
    const std::size_t number = quick.patches()[k]->given().number;
    const auto wrenches = wrenches_of(workspace.found[number]);
    by_sinking += wrenches * workspace.responses[k].by_sinking;
    by_motion += wrenches * workspace.responses[k].by_creepage * workspace.by_motion[number];
  }
  found.stiffness = -by_sinking[2];
  const bool by_force = state.given == GivenLoad::vertical_force;
  if (by_force && !(found.stiffness > 0.0)) return false;
  // Under a given vertical force the wheel sinks or rises until the force is restored.
  const auto settled = [&](const Wrench& change) -> Wrench {
    return by_force ? Wrench(change + change[2] / found.stiffness * by_sinking) : change;
  };
  const Eigen::Vector3d moves(motion.rotation, motion.lateral_velocity, motion.yaw_velocity);
  found.by.col(StateVariable::forward_speed) = settled(-by_motion * moves / speed);
  found.by.col(StateVariable::rotation_speed) = settled(by_motion.col(0) / speed);
  found.by.col(StateVariable::lateral_velocity) = settled(by_motion.col(1) / speed);
  found.by.col(StateVariable::yaw_rate) = settled(by_motion.col(2) / speed);
  found.by.col(StateVariable::load) = by_sinking * (by_force ? 1.0 / found.stiffness : 1.0);
  return true;
}

/// Central difference, or one-sided if one side has no solution.
Wrench WheelRailPair::difference(Workspace& workspace, const WheelState& state,
                                 const WheelOnRail& at, int variable) const {
  const auto [member, step] =
      variables_of(state, at, input_.wheel.rolling_radius)[static_cast<std::size_t>(variable)];
  const auto sum_at = [&, member = member,
                       step = step](double factor) -> std::optional<WheelOnRail> {
    WheelState moved = state;
    moved.*member += factor * step;
    try {
      return solve(workspace, moved);
    } catch (const contact::SolveError&) {
      return {};
    }
  };
  const std::optional<WheelOnRail> above = sum_at(1.0), below = sum_at(-1.0);
  if (!above && !below)
    throw contact::SolveError(
        "the wheel has no solution on either side of this state, so its forces have no "
        "derivatives; do: "
        "solve without them");
  const double reach = step * ((above ? 1.0 : 0.0) + (below ? 1.0 : 0.0));
  return (above.value_or(at).wrench - below.value_or(at).wrench) / reach;
}

}  // namespace rollfem::track
