// SPDX-License-Identifier: LGPL-2.1-or-later
#include "capi/wheel_rail_pair.hpp"

#include "contact/base/errors.hpp"
#include "contact/result/validity.hpp"
#include "halfspace/model/level.hpp"
#include "halfspace/patch/correction_scene.hpp"
#include "track/balance/position.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::capi {

namespace {

using contact::Case;
using contact::cross;
using contact::Vector3;

/// Checks every number of a state against the bounds of case files.
void check(const WheelState& state, double rolling_radius) {
  const auto within = [](const char* name, double value, double limit) {
    if (std::abs(value) <= limit) return;  // false for NaN
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
  input.load.vertical_force = state.vertical_force;
}

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
  return found;
}

SolvedPatch patch_of(const contact::PointResult& point, double max_pressure_bar,
                     const track::WheelRailContact& contact) {
  SolvedPatch patch{forces_of(point, max_pressure_bar),
                    contact.origin,
                    contact.place.contact_angle,
                    contact.place.rolling_radius,
                    {}};
  for (int d = 0; d < 3; ++d)
    patch.force[d] = point.longitudinal_force * contact.along[d] +
                     point.lateral_force * contact.across[d] +
                     point.normal_force * contact.normal[d];
  return patch;
}

void add_to_sums(const SolvedPatch& patch, const track::WheelRailContact& contact,
                 SolvedWheel& wheel) {
  const Vector3 arm{contact.origin[0] - contact.axle.point[0],
                    contact.origin[1] - contact.axle.point[1],
                    contact.origin[2] - contact.axle.point[2]};
  const Vector3 moment = cross(arm, patch.force);
  for (int d = 0; d < 3; ++d) {
    wheel.force[d] += patch.force[d];
    wheel.moment[d] += moment[d] + patch.forces.spin_moment * contact.normal[d];
  }
  wheel.height = contact.pose.height;
}

/// Margin around the overlap of the bodies, mm: more than a grid on the patch needs.
constexpr double around_overlap = 10.0;

/// Largest separation, mm, of a near miss to describe: none.
constexpr double none = -contact::infinity;

track::SearchOptions search_options() {
  track::SearchOptions options;
  options.with_reserve = true;
  return options;
}

}  // namespace

/// A workspace borrowed for a call and returned at its end.
class WheelRailPair::Borrowed {
 public:
  explicit Borrowed(const WheelRailPair& pair) : pair_(pair) {
    {
      const std::lock_guard<std::mutex> lock(pair_.mutex_);
      if (!pair_.idle_.empty()) {
        workspace_ = std::move(pair_.idle_.back());
        pair_.idle_.pop_back();
      }
    }
    if (workspace_) return;
    workspace_.reset(new Workspace{pair_.input_, {}, {}, {}});
    for (const auto& tables : pair_.tables_)
      workspace_->wheels.push_back(
          std::make_unique<QuickWheel>(*tables, tables == pair_.tables_.back(), pair_.material_));
  }
  ~Borrowed() {
    const std::lock_guard<std::mutex> lock(pair_.mutex_);
    pair_.idle_.push_back(std::move(workspace_));
  }
  Borrowed(const Borrowed&) = delete;
  Borrowed& operator=(const Borrowed&) = delete;

  Workspace& operator*() const { return *workspace_; }

 private:
  const WheelRailPair& pair_;
  std::unique_ptr<Workspace> workspace_;
};

WheelRailPair::WheelRailPair(Case input)
    : input_(std::move(input)),
      search_(track::search_scene_of(input_)),
      material_(contact::combine(input_.wheel.material, input_.rail.material)),
      friction_(contact::coulomb(input_.friction_coefficient)) {
  const int across = input_.contact_grid.elements_across;
  if (material_.couples() || across > QuickWheel::most_across) return;
  for (const int elements : {across, QuickWheel::across_any_patch})
    tables_.push_back(std::make_unique<halfspace::InfluenceTables>(
        across + 2 * QuickPatch::margin, elements + 2 * QuickPatch::margin, material_.uncoupled()));
}

SolvedWheel WheelRailPair::solve(const WheelState& state) const {
  check(state, input_.wheel.rolling_radius);
  const Borrowed workspace(*this);
  set(state, (*workspace).input);
  SolvedWheel wheel;
  if (!tables_.empty() && solve_quickly(*workspace, wheel)) return wheel;
  try {
    solve_with_care((*workspace).input, wheel);
  } catch (const contact::SolveError&) {
    if (!solve_curved((*workspace).input, wheel)) throw;
  }
  return wheel;
}

/// Solves a patch that reaches into another contact of the wheel: both form one conformal contact,
/// which no plane can represent.
bool WheelRailPair::solve_curved(Case input, SolvedWheel& wheel) const {
  input.halfspace.surface = contact::SurfaceForm::curved;
  wheel = {};
  try {
    solve_with_care(input, wheel);
  } catch (const contact::SolveError&) {
    return false;
  }
  return true;
}

/// False if QuickWheel cannot solve the contacts.
bool WheelRailPair::solve_quickly(Workspace& workspace, SolvedWheel& wheel) const {
  contact::SurfaceForm& form = workspace.input.halfspace.surface;
  for (const auto tried : {contact::SurfaceForm::automatic, contact::SurfaceForm::curved}) {
    form = tried;
    const QuickOutcome outcome = solve_quickly_on(workspace, wheel);
    form = contact::SurfaceForm::automatic;
    if (outcome != QuickOutcome::conformal) return outcome == QuickOutcome::solved;
  }
  return false;
}

QuickOutcome WheelRailPair::solve_quickly_on(Workspace& workspace, SolvedWheel& wheel) const {
  const Case& input = workspace.input;
  track::SearchOptions options = search_options();
  options.around_overlap = around_overlap;
  options.near_miss = none;
  workspace.found = track::find_contacts(input, search_, 1, options);
  const track::Motion motion = track::motion_of(input, input.wheelset.rotation_change.front());
  std::vector<QuickContact>& contacts = workspace.contacts;
  contacts.clear();
  for (track::WheelRailContact& contact : workspace.found) {
    if (!(contact.place.patch > 0 || contact.reserve)) continue;
    QuickContact one;
    one.contact = &contact;
    one.creepage = track::creepage_of(contact, motion);
    one.geometry.surface = contact::ContactSurface::of(
        std::make_shared<const contact::PatchGeometry>(std::move(contact.geometry)));
    if (input.halfspace.surface == contact::SurfaceForm::automatic)
      one.geometry.surface.follows = track::follows_surface(contact.spread_of_normals);
    contacts.push_back(std::move(one));
  }
  const QuickLoad load{*input.load.vertical_force, friction_};
  QuickOutcome outcome = QuickOutcome::unfit;
  for (const auto& quick : workspace.wheels) {
    outcome = quick->solve(contacts, load);
    if (outcome == QuickOutcome::unfit) continue;
    if (outcome == QuickOutcome::solved) take(*quick, wheel);
    break;
  }
  return outcome;
}

void WheelRailPair::take(const QuickWheel& quick, SolvedWheel& wheel) {
  std::array<const QuickPatch*, QuickWheel::most_patches> order{};
  wheel.count = quick.patches().size();
  const auto end = std::copy(quick.patches().begin(), quick.patches().end(), order.begin());
  for (auto at = order.begin(); at != end; ++at)
    std::iter_swap(at, std::max_element(at, end, [](const QuickPatch* a, const QuickPatch* b) {
                     return a->point().normal_force < b->point().normal_force;
                   }));
  for (std::size_t k = 0; k < wheel.count; ++k) {
    wheel.patches[k] =
        patch_of(order[k]->point(), order[k]->max_pressure_bar(), order[k]->contact());
    add_to_sums(wheel.patches[k], order[k]->contact(), wheel);
  }
}

void WheelRailPair::solve_with_care(const Case& input, SolvedWheel& wheel) const {
  const std::vector<track::PlacedScene> placed =
      track::make_scenes(input, search_, search_options());
  std::vector<SolvedPatch> patches;
  const auto add = [&](const contact::Scene& scene, const track::WheelRailContact& contact) {
    const CheckedPatch patch = solve_patch(scene, input.contact_grid.elements_across);
    patches.push_back(patch_of(patch.point, patch.max_pressure_bar, contact));
    add_to_sums(patches.back(), contact, wheel);
  };
  if (placed.size() == 1)
    add(placed.front().scene, placed.front().contact);
  else
    for (const contact::Scene& scene : track::balanced_position(input, placed))
      add(scene, contact_of(scene, placed));
  std::stable_sort(patches.begin(), patches.end(), [](const auto& a, const auto& b) {
    return a.forces.normal_force > b.forces.normal_force;
  });
  wheel.count = std::min(patches.size(), SolvedWheel::most_patches);
  std::copy_n(patches.begin(), wheel.count, wheel.patches.begin());
}

}  // namespace rollfem::capi
