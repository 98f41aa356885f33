// SPDX-License-Identifier: LGPL-2.1-or-later
#include "capi/wheel_rail_pair.hpp"

#include "contact/base/errors.hpp"
#include "contact/result/validity.hpp"
#include "halfspace/model/level.hpp"
#include "halfspace/patch/correction_scene.hpp"
#include "track/balance/position.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace rollfem::capi {

namespace {

using contact::Case;

/// The contact that belongs to a scene from the balance.
const track::WheelRailContact& contact_of(const contact::Scene& scene,
                                          const std::vector<track::PlacedScene>& placed) {
  const auto found = std::find_if(placed.begin(), placed.end(), [&](const auto& one) {
    return one.contact.place.y_track == scene.place->y_track;
  });
  if (found == placed.end()) throw std::logic_error("a patch in balance that was not found before");
  return found->contact;
}

struct CheckedPatch {
  contact::PointResult point;
  double max_pressure_bar = 0.0;  ///< MPa
};

/// Solves the first load point with the model halfspace on one grid, without the coarser grids
/// needed for error bars. Throws contact::SolveError and contact::InputError as the model does.
CheckedPatch solve_patch(const contact::Scene& scene, int across) {
  const halfspace::PatchSearch search(scene);
  const halfspace::PatchExtent extent = search.extent();
  contact::LevelResult level = halfspace::solve_level(scene, search, extent.length / across,
                                                      extent.width / across, nullptr, "", {});
  contact::ModelResult result;
  result.name = "halfspace";
  result.grid = level.grid;
  result.points = std::move(level.points);
  contact::check_validity(scene, result);
  CheckedPatch patch{std::move(result.points.front()), 0.0};
  const PeakPressure::Peak peak =
      PeakPressure(scene.material.contact_modulus)
          .of(halfspace::halfspace_geometry(scene), result.grid, patch.point.fields.traction.n);
  patch.point.max_pressure = peak.pressure;
  patch.max_pressure_bar = peak.bar;
  return patch;
}

PatchForces forces_of(const contact::PointResult& point, double max_pressure_bar) {
  PatchForces found;
  found.creepage = point.creepage;
  found.normal_force = point.normal_force;
  found.longitudinal_force = point.longitudinal_force;
  found.lateral_force = point.lateral_force;
  found.lateral_pressure = point.lateral_pressure;
  found.spin_moment = point.spin_moment;
  found.length = point.contact_length;
  found.width = point.contact_width;
  found.area = point.contact_area;
  found.adhesion_area = point.adhesion_area;
  found.max_pressure = point.max_pressure;
  found.max_pressure_bar = max_pressure_bar;
  found.creepage_work = point.creepage_work.value_or(0.0);
  return found;
}

void set_pose(const track::WheelsetPose& pose, SolvedWheel& wheel) {
  wheel.roll = pose.roll;
  wheel.height = pose.height;
}

/// Adds a patch to the sums of its wheel.
SolvedPatch add_patch(const contact::PointResult& point, double max_pressure_bar,
                      const track::WheelRailContact& contact, SolvedWheel& wheel) {
  const Wrench wrench =
      wrench_of(contact, {point.longitudinal_force, point.lateral_force, point.normal_force,
                          point.lateral_pressure, point.spin_moment});
  add(wrench, 1.0, wheel.sum);
  const SolvedPatch patch{forces_of(point, max_pressure_bar), contact.origin,
                          contact.place.contact_angle, contact.place.rolling_radius, wrench.force};
  wheel.creepage_work += patch.forces.creepage_work;
  set_pose(contact.pose, wheel);
  return patch;
}

/// Margin around the overlap of the bodies, mm: more than a grid on the patch needs.
constexpr double around_overlap = 10.0;

/// Largest separation, mm, of a near miss to describe: none.
constexpr double none = -contact::infinity;

track::SearchOptions search_options(const WheelState& state) {
  track::SearchOptions options;
  options.with_reserve = true;
  if (state.given == WheelState::Given::height) options.height = state.load;
  if (state.given == WheelState::Given::penetration) options.sinking = state.load;
  return options;
}

/// Given depth below first touch, mm.
std::optional<double> sinking_of(const WheelState& state, double touching_height) {
  if (state.given == WheelState::Given::vertical_force) return {};
  return state.given == WheelState::Given::height ? state.load - touching_height : state.load;
}

/// Result of a wheel held above the rail.
SolvedWheel apart(const track::WheelsetPose& pose, double sinking) {
  SolvedWheel wheel;
  set_pose(pose, wheel);
  wheel.penetration = sinking;
  return wheel;
}

/// Derivatives of the creepages by the motion, in which they are linear.
std::array<contact::Creepage, 3> by_motion(const track::WheelRailContact& contact,
                                           const track::Motion& motion,
                                           const contact::Creepage& at) {
  std::array<contact::Creepage, 3> by{};
  const std::array<double track::Motion::*, 3> parts{
      &track::Motion::rotation, &track::Motion::lateral_velocity, &track::Motion::yaw_velocity};
  for (std::size_t k = 0; k < parts.size(); ++k) {
    track::Motion moved = motion;
    moved.*parts[k] += 1.0;
    const contact::Creepage then = track::creepage_of(contact, moved);
    by[k] = {then.longitudinal - at.longitudinal, then.lateral - at.lateral, then.spin - at.spin};
  }
  return by;
}

}  // namespace

WheelRailPair::Borrowed::Borrowed(const WheelRailPair& pair) : pair_(pair) {
  {
    const std::lock_guard<std::mutex> lock(pair_.mutex_);
    if (!pair_.idle_.empty()) {
      workspace_ = std::move(pair_.idle_.back());
      pair_.idle_.pop_back();
    }
  }
  if (workspace_) return;
  workspace_ = std::make_unique<Workspace>();
  workspace_->input = pair_.input_;
  for (const auto& tables : pair_.tables_)
    workspace_->wheels.push_back(
        std::make_unique<QuickWheel>(*tables, tables == pair_.tables_.back(), pair_.material_));
}

WheelRailPair::Borrowed::~Borrowed() {
  workspace_->linearises = false;
  const std::lock_guard<std::mutex> lock(pair_.mutex_);
  pair_.idle_.push_back(std::move(workspace_));
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

SolvedWheel WheelRailPair::solve(const WheelState& state) const {
  check(state, input_.wheel.rolling_radius);
  const Borrowed workspace(*this);
  return solve(*workspace, state);
}

SolvedWheel WheelRailPair::solve(Workspace& workspace, const WheelState& state) const {
  set(state, workspace.input);
  workspace.solved = nullptr;
  SolvedWheel wheel;
  if (!tables_.empty() && solve_quickly(workspace, state, wheel)) return wheel;
  try {
    solve_with_care(workspace.input, state, wheel);
  } catch (const contact::SolveError&) {
    if (!solve_curved(workspace.input, state, wheel)) throw;
  }
  return wheel;
}

/// Solves a patch that reaches into another contact of the wheel: both form one conformal contact,
/// which no plane can represent.
bool WheelRailPair::solve_curved(Case input, const WheelState& state, SolvedWheel& wheel) const {
  input.halfspace.surface = contact::SurfaceForm::curved;
  try {
    solve_with_care(input, state, wheel);
  } catch (const contact::SolveError&) {
    return false;
  }
  return true;
}

/// False if QuickWheel cannot solve the contacts.
bool WheelRailPair::solve_quickly(Workspace& workspace, const WheelState& state,
                                  SolvedWheel& wheel) const {
  contact::SurfaceForm& form = workspace.input.halfspace.surface;
  for (const auto tried : {contact::SurfaceForm::automatic, contact::SurfaceForm::curved}) {
    form = tried;
    const QuickOutcome outcome = solve_quickly_on(workspace, state, wheel);
    form = contact::SurfaceForm::automatic;
    if (outcome != QuickOutcome::conformal) return outcome == QuickOutcome::solved;
  }
  return false;
}

QuickOutcome WheelRailPair::solve_quickly_on(Workspace& workspace, const WheelState& state,
                                             SolvedWheel& wheel) const {
  const Case& input = workspace.input;
  track::SearchOptions options = search_options(state);
  options.around_overlap = around_overlap;
  options.near_miss = none;
  workspace.found = track::find_contacts(input, search_, 1, options);
  const track::WheelsetPose& pose = workspace.found.front().pose;
  workspace.load = {input.load.vertical_force.value_or(0.0), sinking_of(state, pose.height),
                    friction_falls() ? contact::friction_of(input) : friction_};
  const bool touches =
      std::any_of(workspace.found.begin(), workspace.found.end(),
                  [](const track::WheelRailContact& contact) { return contact.place.patch > 0; });
  if (const auto& sinking = workspace.load.sinking; sinking && !(*sinking > 0.0 && touches)) {
    wheel = apart(pose, *sinking);
    return QuickOutcome::solved;
  }
  const track::Motion motion = track::motion_of(input, input.wheelset.rotation_change.front());
  std::vector<QuickContact>& contacts = workspace.contacts;
  contacts.clear();
  for (track::WheelRailContact& contact : workspace.found) {
    if (!(contact.place.patch > 0 || contact.reserve)) continue;
    QuickContact one;
    one.contact = &contact;
    one.creepage = track::creepage_of(contact, motion);
    if (workspace.linearises) one.by_motion = by_motion(contact, motion, one.creepage);
    one.geometry.surface = contact::ContactSurface::of(
        std::make_shared<const contact::PatchGeometry>(std::move(contact.geometry)));
    if (input.halfspace.surface == contact::SurfaceForm::automatic)
      one.geometry.surface.follows = track::follows_surface(contact.spread_of_normals);
    contacts.push_back(std::move(one));
  }
  QuickOutcome outcome = QuickOutcome::unfit;
  for (const auto& quick : workspace.wheels) {
    outcome = quick->solve(contacts, workspace.load);
    if (outcome == QuickOutcome::unfit) continue;
    if (outcome == QuickOutcome::solved) {
      workspace.solved = quick.get();
      take(*quick, wheel);
    }
    break;
  }
  return outcome;
}

void WheelRailPair::take(const QuickWheel& quick, SolvedWheel& wheel) {
  std::array<const QuickPatch*, QuickWheel::most_patches> order{};
  wheel.count = quick.patches().size();
  wheel.penetration = quick.sinking();
  const auto end = std::copy(quick.patches().begin(), quick.patches().end(), order.begin());
  for (auto at = order.begin(); at != end; ++at)
    std::iter_swap(at, std::max_element(at, end, [](const QuickPatch* a, const QuickPatch* b) {
                     return a->point().normal_force < b->point().normal_force;
                   }));
  for (std::size_t k = 0; k < wheel.count; ++k)
    wheel.patches[k] =
        add_patch(order[k]->point(), order[k]->max_pressure_bar(), order[k]->contact(), wheel);
}

void WheelRailPair::solve_with_care(const Case& input, const WheelState& state,
                                    SolvedWheel& wheel) const {
  wheel = {};
  std::vector<track::PlacedScene> placed =
      track::make_scenes(input, search_, search_options(state));
  const track::WheelsetPose& pose = placed.front().contact.pose;
  if (const auto sinking = sinking_of(state, pose.height)) {
    const bool touches =
        std::any_of(placed.begin(), placed.end(),
                    [](const track::PlacedScene& scene) { return scene.contact.place.patch > 0; });
    if (!(*sinking > 0.0 && touches)) {
      wheel = apart(pose, *sinking);
      return;
    }
    for (track::PlacedScene& one : placed)
      one.scene.points.front().load.approach =
          *sinking * std::cos(one.contact.place.contact_angle) - one.contact.place.separation;
  }
  std::vector<SolvedPatch> patches;
  const auto solve_one = [&](const contact::Scene& scene, const track::WheelRailContact& contact) {
    const CheckedPatch patch = solve_patch(scene, input.contact_grid.elements_across);
    patches.push_back(add_patch(patch.point, patch.max_pressure_bar, contact, wheel));
    wheel.penetration =
        std::max(wheel.penetration, (patch.point.approach + contact.place.separation) /
                                        std::cos(contact.place.contact_angle));
  };
  if (placed.size() == 1)
    solve_one(placed.front().scene, placed.front().contact);
  else
    for (const contact::Scene& scene : track::balanced_position(input, placed))
      solve_one(scene, contact_of(scene, placed));
  std::stable_sort(patches.begin(), patches.end(), [](const auto& a, const auto& b) {
    return a.forces.normal_force > b.forces.normal_force;
  });
  wheel.count = std::min(patches.size(), SolvedWheel::most_patches);
  wheel.unlisted = patches.size() - wheel.count;
  std::copy_n(patches.begin(), wheel.count, wheel.patches.begin());
}

}  // namespace rollfem::capi
