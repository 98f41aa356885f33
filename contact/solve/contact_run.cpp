// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/solve/contact_run.hpp"

#include "base/errors.hpp"
#include "base/progress.hpp"
#include "contact/iteration/friction_state.hpp"
#include "contact/iteration/interpolation.hpp"
#include "contact/solve/state_record.hpp"
#include "result/derived.hpp"
#include "result/free_ends.hpp"
#include "result/heat/temperature.hpp"
#include "result/quantities.hpp"
#include "result/validity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::contact {

using Eigen::Vector2d;

namespace {

/// Adds the state of an iteration.
void describe(ProgressEvent& event, const ContactState& state) {
  const std::vector<ElementState>& elements = state.tangential.state;
  event.iteration = state.iterations;
  event.residual = state.residual;
  event.contact_elements = state.normal.contact_elements;
  event.adhesion_elements =
      static_cast<int>(std::count(elements.begin(), elements.end(), ElementState::adhesion));
}

/// Stage name of a load point's solution in progress events.
const char* stage_of(Problem problem) {
  if (problem == Problem::frictionless) return "frictionless";
  if (problem == Problem::shift) return "shift";
  return problem == Problem::transient ? "transient" : "rolling";
}

bool rolls(Problem problem) {
  return problem == Problem::steady || problem == Problem::transient;
}

/// Refuses more than a layer transmits that yields and does not harden.
void refuse_force_beyond_yielding(const PrescribedForce& wanted, const FrictionLaw& law,
                                  const Field& pressure, double element_area) {
  if (!law.plasticity || law.plasticity->hardening > 0.0) return;
  const double stress = law.plasticity->yield_stress;
  const double most = (law.coefficient() * pressure.array()).min(stress).sum() * element_area;
  const double size = std::hypot(wanted.longitudinal.value_or(0.0), wanted.lateral.value_or(0.0));
  if (size < most) return;
  throw SolveError(fmt::format(
      "prescribed force: {:.6g} N is not below {:.6g} N, the most that a layer with a yield stress "
      "of {:g} MPa can transmit; do: prescribe a smaller force, or the creepage instead",
      size, most, stress));
}

}  // namespace

ContactRun::ContactRun(const Scene& scene, const ChartedGeometry& geometry, RunOptions options,
                       const Progress& progress, PointStore* store)
    : scene_(scene),
      geometry_(geometry),
      options_(std::move(options)),
      progress_(progress),
      store_(store),
      friction_(friction_on(scene, geometry)) {}

void ContactRun::tell(ProgressEvent event, const char* stage, bool finished) const {
  event.model = options_.model;
  event.stage = options_.stage_prefix + stage;
  event.points = static_cast<int>(scene_.points.size());
  event.finished = finished;
  report(progress_, event);
}

ProgressEvent ContactRun::event_of(std::size_t k) const {
  ProgressEvent event;
  event.point = static_cast<int>(k) + 1;
  if (rolls(scene_.problem)) event.creepage = scene_.points[k].creepage.longitudinal;
  return event;
}

bool ContactRun::solve(const ContactGrid& grid, const MakeElasticity& make) {
  std::size_t k = 0;
  return begin(grid, make) && solve_each([&]() -> std::optional<std::size_t> {
           if (k == scene_.points.size()) return {};
           return k++;
         });
}

bool ContactRun::begin(const ContactGrid& grid, const MakeElasticity& make) {
  result_.grid = grid;
  result_.pressure = {};
  result_.points.clear();
  result_.relative_traction.clear();
  result_.several = 0;
  result_.unsolved.clear();
  shape_ = geometry_.shape(grid);
  problem_.reset();
  elasticity_.reset();
  const Stopwatch setup;
  elasticity_ = make();
  result_.setup_seconds += setup.seconds();
  motion_.emplace(scene_, geometry_, grid, options_.inherited);
  state_ = {};
  if (!elasticity_->is_halfspace()) return true;
  prepare();
  return press(0);
}

void ContactRun::solve_without_friction(const ContactGrid& grid, const MakeElasticity& make) {
  begin(grid, make);
  if (!problem_) prepare();
}

bool ContactRun::solve_each(const std::function<std::optional<std::size_t>()>& next) {
  bool restoring = store_ != nullptr;
  while (const std::optional<std::size_t> k = next())
    if (!solve_or_restore(*k, restoring)) return false;
  return true;
}

/// `restoring`: where load points start from each other, all behind one that is not stored are
/// solved.
bool ContactRun::solve_or_restore(std::size_t k, bool& restoring) {
  // Also at restored load points, so that numbers stay the same to the last bit.
  if (elasticity_->is_halfspace()) {
    if (k > 0 && !press(k)) return false;
    if (k == 0) warn_if_steep();
  }
  const bool alone = options_.independent && !scene_.is_history() && store_ != nullptr;
  const bool taken = (restoring || alone) && restore(k);
  restoring = restoring && taken;
  if (!taken) {
    try {
      if (!problem_) prepare();
      const Stopwatch watch;
      solve_point(k);
      result_.tangential_seconds += watch.seconds();
    } catch (const UnfitGrid&) {
      return false;
    } catch (const NoSteadyFriction& error) {
      if (!leave_unsolved(k, error)) throw;
      return true;
    }
  }
  return holds_patch(scene_, result_.grid, state_.normal.pressure);
}

void ContactRun::prepare() {
  const Stopwatch setup;
  elasticity_->prepare();
  ContactConditions conditions;
  if (scene_.given_pressure)
    conditions.given_pressure = pressure_field(*scene_.given_pressure, result_.grid);
  else
    conditions.undeformed_distance = geometry_.undeformed_distance(result_.grid);
  const Field extra = elasticity_->extra_distance();
  if (extra.size() != 0 && !scene_.given_pressure) conditions.undeformed_distance += extra;
  conditions.friction = friction_;
  conditions.upwind_order = scene_.upwind_order;
  conditions.shape = shape_;
  conditions.fit_leading_edge = scene_.leading_edge == LeadingEdge::fitted;
  conditions.coupled_halfspace = elasticity_->coupled_halfspace();
  problem_.emplace(elasticity_->compliance(), elasticity_->halfspace(), std::move(conditions));
  motion_->set_extra(elasticity_->extra_slip());
  result_.setup_seconds += setup.seconds();
  if (!elasticity_->is_halfspace() && result_.points.empty()) find_first_defect();
}

/// The frictionless solution: start of the first load point.
void ContactRun::find_first_defect() {
  state_.defect = options_.first_defect;
  if (state_.defect.displacement.n.size() == result_.grid.size()) return;
  const Stopwatch watch;
  tell({}, "normal", false);
  state_ = problem_->solve_frictionless(scene_.points.front().load, options_.accuracy);
  ProgressEvent event;
  describe(event, state_);
  tell(event, "normal", true);
  result_.normal_seconds += watch.seconds();
  if (on_first_defect) on_first_defect(state_.defect, state_.normal.contact_elements);
}

/// Pressure without friction on the grid; false when it reaches the border.
bool ContactRun::press(std::size_t k) {
  const Stopwatch watch;
  const bool first = result_.pressure.size() == 0;
  const bool solved_anew = first || scene_.is_history() || scene_.load_changes();
  ProgressEvent event;
  if (solved_anew && scene_.points.size() > 1 && (scene_.is_history() || scene_.load_changes()))
    event.point = static_cast<int>(k) + 1;
  if (solved_anew) tell(event, "normal", false);
  const LevelResult* coarser = options_.coarser;
  const bool follows = state_.normal.pressure.size() != 0;
  const Field start = follows   ? state_.normal.pressure
                      : coarser ? interpolated(coarser->grid, coarser->pressure, result_.grid)
                                : Field();
  const NormalSolution& normal = problem_->press(scene_.points[k].load, start);
  result_.pressure = normal.pressure;
  event.iteration = normal.iterations;
  event.residual = normal.residual;
  event.contact_elements = normal.contact_elements;
  if (solved_anew) tell(event, "normal", true);
  if (solved_anew) elasticity_->check_patch(patch_size(result_.grid, normal.pressure));
  result_.normal_seconds += watch.seconds();
  return holds_patch(scene_, result_.grid, normal.pressure);
}

/// A first guess from the coarser level: its p_t / g times the bound here.
ContactState ContactRun::start_for(std::size_t k) {
  ContactState start;
  start.normal = problem_->press(scene_.points[k].load);
  start.defect =
      scene_.is_history() || !options_.independent ? state_.defect : options_.first_defect;
  if (scene_.is_history()) start.tangential.traction = state_.tangential.traction;
  const LevelResult* coarser = options_.coarser;
  if (!coarser || k >= coarser->relative_traction.size() ||
      coarser->relative_traction[k].x.size() == 0)
    return start;
  start.tangential.traction =
      finer_tractions(coarser->grid, coarser->pressure, coarser->relative_traction[k], result_.grid,
                      traction_bound(friction_, result_.grid, start.normal.pressure));
  // The defect of these tractions, not from another load point.
  if (elasticity_->is_halfspace()) start.defect = {};
  return start;
}

OuterCallback ContactRun::each_iteration(std::size_t k) {
  return [this, k](const ContactState& state) {
    const auto count = [](int& most, int here) { most = std::max(most, here); };
    count(result_.newton_steps, state.tangential.newton_steps);
    count(result_.krylov_iterations, state.tangential.krylov_iterations);
    count(result_.iterations, state.iterations);
    if (elasticity_->is_halfspace()) return;
    ProgressEvent event = event_of(k);
    describe(event, state);
    tell(event, stage_of(scene_.problem_of(k)), false);
  };
}

ForceSearch ContactRun::search_for(std::size_t k) {
  const LoadPoint& point = scene_.points[k];
  const NormalSolution& normal = problem_->press(point.load);
  const PatchSize patch = patch_size(result_.grid, normal.pressure);
  ForceSearch search;
  search.tolerance = options_.force_tolerance;
  const auto start_from = [&](const Creepage& found) {
    if (point.force.longitudinal) search.start.x() = found.longitudinal;
    if (point.force.lateral) search.start.y() = found.lateral;
  };
  const Problem problem = scene_.problem_of(k);
  if (problem == Problem::steady) {
    search.has_peak = friction_->feels_slip();
    search.stiffness = elasticity_->rolling_stiffness(patch);
    search.start = first_creepage(
        point.force, motion_->given_unknowns(k), search.stiffness,
        mean_coefficient(friction_, result_.grid, normal.pressure) * normal.normal_force);
  } else {
    search.stiffness = elasticity_->shift_stiffness(patch);
    if (problem == Problem::transient) search.stiffness *= point.step_length;
    search.start = motion_->given_unknowns(k);
    if (problem == Problem::transient && !result_.points.empty())
      start_from(result_.points.back().creepage);
  }
  if (options_.coarser && problem != Problem::shift)
    start_from(options_.coarser->points[k].creepage);
  return search;
}

void ContactRun::solve_given(std::size_t k, const Vector2d& unknowns) {
  const ContactState start = start_for(k);
  try {
    state_ = problem_->solve(scene_.points[k].load, motion_->at(k, unknowns), &start,
                             options_.accuracy, each_iteration(k));
  } catch (const NoSteadyFriction& error) {
    throw NoSteadyFriction(fmt::format("{} {} of {}: {}",
                                       scene_.is_history() ? "step" : "load point", k + 1,
                                       scene_.points.size(), error.what()));
  }
}

/// Solves the point with the prescribed force; returns the creepages (shifts) found.
Vector2d ContactRun::find_force(std::size_t k) {
  const PrescribedForce& wanted = scene_.points[k].force;
  if (!friction_)
    throw SolveError(
        "prescribed force: without friction there is no tangential force; do: prescribe the "
        "creepage, or a friction coefficient above 0");
  const NormalSolution& pressed = problem_->press(scene_.points[k].load);
  refuse_force_beyond_friction(
      wanted, mean_coefficient(friction_, result_.grid, pressed.pressure) * pressed.normal_force);
  refuse_force_beyond_yielding(wanted, *friction_, pressed.pressure, result_.grid.element_area());
  const ForcedMotion forced{[&](const Vector2d& unknowns) { return motion_->at(k, unknowns); },
                            wanted, search_for(k)};
  state_ = problem_->solve_for_force(scene_.points[k].load, forced, start_for(k),
                                     options_.force_accuracy, each_iteration(k));
  return state_.unknowns;
}

/// A load point solved by an earlier run, with the state from which the next one starts.
bool ContactRun::restore(std::size_t k) {
  PointResult point;
  std::string memory;
  if (!store_->find(k, result_.grid, point, state_, memory)) return false;
  motion_->warm(k, point);
  remember(k);
  motion_->restore(point);
  elasticity_->restore(memory);
  result_.pressure = state_.normal.pressure;
  result_.contact_elements = state_.normal.contact_elements;
  ProgressEvent event = event_of(k);
  if (rolls(scene_.problem)) event.creepage = point.creepage.longitudinal;
  event.note = fmt::format("{} of {} restored", k + 1, scene_.points.size());
  tell(event, "taken up", true);
  result_.points.push_back(std::move(point));
  return true;
}

void ContactRun::solve_point(std::size_t k) {
  const Stopwatch watch;
  const char* stage = stage_of(scene_.problem_of(k));
  ProgressEvent event = event_of(k);
  if (elasticity_->is_halfspace()) {
    event.contact_elements = problem_->press(scene_.points[k].load).contact_elements;
    tell(event, stage, false);
  }
  Vector2d unknowns = motion_->given_unknowns(k);
  if (scene_.points[k].force.any())
    unknowns = find_force(k);
  else
    solve_given(k, unknowns);
  state_.tangential.states = problem_->count_states(state_, motion_->at(k, unknowns));
  PointResult point = point_result(k, unknowns);
  motion_->warm(k, point);
  remember(k);
  if (holds_patch(scene_, result_.grid, state_.normal.pressure)) elasticity_->complete(k, point);
  point.seconds = watch.seconds();
  if (store_) store_->keep(k, point, state_, elasticity_->memory());

  if (rolls(scene_.problem)) event.creepage = point.creepage.longitudinal;
  describe(event, state_);
  if (state_.tangential.krylov_iterations > 0 && elasticity_->is_halfspace())
    event.note = fmt::format("{} Krylov iterations", state_.tangential.krylov_iterations);
  tell(event, stage, true);
  result_.contact_elements = state_.normal.contact_elements;
  result_.points.push_back(std::move(point));
}

/// Start of the next step or the next finer level.
void ContactRun::remember(std::size_t k) {
  motion_->advance(k, state_);
  result_.steepness = std::max(result_.steepness, state_.tangential.steepness);
  if (state_.tangential.states > 1) ++result_.several;
  if (scene_.past && friction_ && (friction_->memory() || friction_->plasticity))
    result_.after = friction_after(friction_, result_.grid, state_);
  if (scene_.past && scene_.heat) result_.heat = motion_->heat().front();
  if (scene_.is_history()) return;
  result_.relative_traction.push_back(relative_to_bound(
      state_.tangential.traction, traction_bound(friction_, result_.grid, state_.normal.pressure)));
}

PointResult ContactRun::point_result(std::size_t k, const Vector2d& unknowns) {
  PointResult point;
  motion_->describe(k, unknowns, point);
  point.fields.traction = state_.traction();
  point.fields.slip = state_.tangential.slip;
  point.fields.traction_bound = state_.tangential.bound;
  point.fields.gap = state_.normal.gap;
  point.fields.displacement = state_.displacement;
  point.fields.state = state_.tangential.state;
  integrate_tractions(result_.grid, point, shape_);
  add_energies(motion_->at(k, unknowns).rigid_slip, point);
  place_patch(scene_, result_.grid, point);
  point.approach =
      scene_.given_pressure ? approach_of_ellipsoid(point.fields) : state_.normal.approach;
  point.iterations = state_.iterations;
  point.residual = state_.residual;
  const ContactResidual left = contact_residual(point.fields);
  point.converged = left.gap <= largest_residual.gap && left.excess <= largest_residual.excess;
  return point;
}

/// Shifts and transient steps have no works per mm rolled.
void ContactRun::add_energies(TangentialField rigid_slip, PointResult& point) const {
  point.elastic_energy = elastic_energy(result_.grid, times_stretch(point.fields.traction, shape_),
                                        point.fields.displacement);
  if (scene_.problem != Problem::steady) return;
  if (state_.curvature_slip.x.size() != 0) {
    rigid_slip.x += state_.curvature_slip.x;
    rigid_slip.y += state_.curvature_slip.y;
  }
  set_works(result_.grid, shape_, rigid_slip, geometry_.extra_slip(point.creepage, result_.grid),
            elasticity_->is_halfspace(), point);
  if (scene_.heat) set_temperatures(result_.grid, *scene_.heat, point);
}

// Where friction falls so steeply that load points have several states or none.

void warn_of_steep_friction(const LevelResult& level, const Friction& friction,
                            std::vector<Note>& notes) {
  if (level.steepness <= 1.0 && level.several == 0) return;
  const std::string found = level.several == 0
                                ? std::string("several states are possible")
                                : fmt::format("there are several states at {} of {} load points",
                                              level.several, level.points.size());
  const bool steps = !level.points.empty() && level.points.front().step > 0;
  const SteepCause reason = steep_cause(*friction, level.steepness, steps ? 0.0 : level.grid.dx);
  add_warning(
      notes, "steep_friction",
      "{} ({:.2g} times what one element withstands) that {}, which depend on the grid: "
      "the result is the one chosen by friction.branch; for one alone: {} (docs/friction.md)",
      reason.cause, level.steepness, found, reason.cure);
}

/// Before load points are solved that may take minutes each.
void ContactRun::warn_if_steep() const {
  if (!friction_ || !friction_->feels_slip() || scene_.problem != Problem::steady) return;
  const double way = result_.grid.dx;
  const double gain =
      steepness(*friction_, result_.pressure.maxCoeff(),
                elasticity_->halfspace().rolling(scene_.upwind_order).diagonal(), way);
  if (gain <= 1.0) return;
  const SteepCause reason = steep_cause(*friction_, gain, way);
  ProgressEvent event;
  event.note = fmt::format(
      "{} ({:.2g} times what one element withstands) that there may be several states or "
      "none, and a load point may take minutes; do: {}",
      reason.cause, gain, reason.cure);
  event.warns = true;
  tell(event, "friction", true);
}

/// False if no load point is left that has a solution.
bool ContactRun::leave_unsolved(std::size_t k, const NoSteadyFriction& error) {
  result_.unsolved.emplace(k, error.what());
  if (!options_.leaves_unsolved || scene_.is_history() ||
      result_.unsolved.size() == scene_.points.size())
    return false;
  PointResult point;
  motion_->describe(k, motion_->given_unknowns(k), point);
  leave_empty(point);
  result_.points.push_back(std::move(point));
  result_.relative_traction.emplace_back();
  return true;
}

}  // namespace rollfem::contact
