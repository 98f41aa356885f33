#include "halfspace/model/level.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/stopwatch.hpp"
#include "contact/result/patch_size.hpp"
#include "contact/result/record.hpp"
#include "contact/scene/geometry.hpp"
#include "contact/solve/history.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/elasticity/interpolation.hpp"
#include "halfspace/model/contact_problem.hpp"
#include "halfspace/model/curved_patch.hpp"
#include "halfspace/model/derived.hpp"
#include "halfspace/model/expected_patch.hpp"
#include "halfspace/model/force_search.hpp"
#include "halfspace/model/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace rollfem::halfspace {

using contact::Case;
using contact::ContactGrid;
using contact::Creepage;
using contact::ElementState;
using contact::Field;
using contact::HistoryStep;
using contact::Motion;
using contact::PointResult;
using contact::PrescribedForce;
using contact::Problem;
using contact::Stopwatch;
using contact::TangentialField;
using Eigen::Vector2d;

namespace {

/// Elements kept free around the patch; second-order upwind looks two columns upstream.
constexpr int margin = 3;

/// Below this K, materials count as alike.
constexpr double like_materials = 1e-12;

/// Solutions behind a force that is searched for must be sharper than the search.
constexpr ContactAccuracy accuracy_of_force_search{1e-8, 1e-7};

ContactGrid with_margin(const ContactGrid& grid, int columns, int rows) {
  return {grid.nx + 2 * columns,
          grid.ny + 2 * rows,
          grid.dx,
          grid.dy,
          grid.x_first - columns * grid.dx,
          grid.y_first - rows * grid.dy};
}

bool has_history(const Case& input) {
  return input.rolling.problem == Problem::shift || input.rolling.problem == Problem::transient;
}

/// Transient rolling looks up to two steps upstream.
int columns_for_steps(const Case& input, double dx) {
  if (input.rolling.problem != Problem::transient || input.contact_grid.extent ||
      input.undeformed_distance.values)
    return 0;
  double longest = 0.0;
  for (const HistoryStep& step : input.history) longest = std::max(longest, step.step_length);
  const double extent = expected_extent(input).length;
  return static_cast<int>(std::ceil(std::min(2.0 * longest, extent) / dx));
}

/// The scene of a case on a grid, with its elasticity.
struct Stage {
  std::unique_ptr<HalfspaceCompliance> whole;
  std::unique_ptr<HalfspaceCompliance> uncoupled;  ///< null for like materials
  std::unique_ptr<ContactProblem> problem;
};

Stage make_stage(const Case& input, const ContactGrid& grid, const CurvedPatch* curved) {
  contact::CombinedMaterial material = contact::combine(input.wheel.material, input.rail.material);
  const bool coupled = std::abs(material.difference) > like_materials;
  if (!coupled) material.difference = 0.0;
  Stage stage;
  stage.whole = std::make_unique<HalfspaceCompliance>(grid, material);
  if (coupled) {
    material.difference = 0.0;
    stage.uncoupled = std::make_unique<HalfspaceCompliance>(grid, material);
  }
  ContactScene scene;
  if (input.given_pressure) {
    const HertzContact hertz = hertz_of_case(input);
    scene.given_pressure = grid.sample([&](double x, double y) { return hertz.pressure(x, y); });
  } else if (curved != nullptr) {
    scene.undeformed_distance = curved->undeformed_distance(grid);
    scene.cosine = curved->cosine(grid);
  } else {
    scene.undeformed_distance = contact::undeformed_distance(input, grid);
  }
  const bool friction = input.rolling.problem != Problem::frictionless;
  scene.friction = friction ? input.friction_coefficient : 0.0;
  scene.upwind_order = input.rolling.upwind_order;
  scene.fit_leading_edge = input.rolling.leading_edge == contact::LeadingEdge::fitted;
  stage.problem = std::make_unique<ContactProblem>(
      *stage.whole, coupled ? *stage.uncoupled : *stage.whole, std::move(scene));
  return stage;
}

/// For checkpoints.
void exchange(contact::Record& record, ContactState& state) {
  contact::NormalSolution& n = state.normal;
  record.values(n.pressure, n.gap, n.approach, n.normal_force, n.contact_elements, n.iterations,
                n.residual);
  contact::TangentialSolution& t = state.tangential;
  record.values(t.traction, t.slip, t.state, t.newton_steps, t.krylov_iterations, t.residual);
  record.values(state.displacement, state.defect, state.iterations, state.residual);
}

class Level {
 public:
  Level(const Case& input, const LevelResult* coarser, std::string stage_prefix,
        const contact::Progress& progress, contact::Checkpoint* checkpoint)
      : input_(input),
        coarser_(coarser),
        stage_prefix_(std::move(stage_prefix)),
        progress_(progress),
        checkpoint_(checkpoint),
        material_(contact::combine(input.wheel.material, input.rail.material)),
        friction_(input.rolling.problem == Problem::frictionless ? 0.0
                                                                 : input.friction_coefficient) {
    if (input.halfspace.surface == contact::SurfaceForm::curved) curved_.emplace(input);
  }

  LevelResult run(ContactGrid grid) {
    constexpr int most_enlargements = 4;
    for (int attempt = 0; !solved_within(grid); ++attempt) {
      if (attempt == most_enlargements || input_.contact_grid.extent)
        throw contact::SolveError(fmt::format(
            "model halfspace: the contact patch reaches the border of the potential contact area "
            "({} by {} elements): the surfaces conform over more than their curvatures tell; do: "
            "prescribe a larger contact_grid.extent",
            grid.nx, grid.ny));
      grid = with_margin(grid, grid.nx / 4 + margin, grid.ny / 4 + margin);
    }
    return std::move(result_);
  }

 private:
  /// What a step inherits and adds up.
  struct Sum {
    double longitudinal = 0.0, lateral = 0.0, spin = 0.0, distance = 0.0;
  };

  void tell(contact::ProgressEvent event, const char* stage, bool finished) const {
    event.model = "halfspace";
    event.stage = stage_prefix_ + stage;
    event.finished = finished;
    contact::report(progress_, event);
  }

  ContactProblem& problem() { return *stage_.problem; }

  /// False when the patch reaches the border of the grid.
  bool solved_within(const ContactGrid& grid) {
    const Stopwatch setup;
    tell({}, "influence coefficients", false);
    result_.grid = grid;
    result_.points.clear();
    result_.relative_traction.clear();
    stage_ = make_stage(input_, grid, curved_ ? &*curved_ : nullptr);
    history_.emplace(grid, input_.rolling.upwind_order);
    state_ = {};
    sum_ = {};
    result_.setup_seconds += setup.seconds();
    bool taking_up = checkpoint_ != nullptr;
    for (std::size_t k = 0; k < input_.rolling.creepages.size(); ++k) {
      if (!pressed(load_of(k))) return false;
      const Stopwatch watch;
      taking_up = taking_up && taken_up(k);
      if (!taking_up) solve_point(k);
      result_.tangential_seconds += watch.seconds();
      if (touches_border(grid, state_.normal.pressure)) return false;
    }
    return true;
  }

  NormalLoad load_of(std::size_t k) const {
    if (has_history(input_) && k < input_.history.size()) {
      const HistoryStep& step = input_.history[k];
      if (step.normal_force || step.approach) return {step.normal_force, step.approach};
    }
    return {input_.load.normal_force_of(k), input_.load.approach};
  }

  bool pressed(const NormalLoad& load) {
    const Stopwatch watch;
    const bool first = state_.normal.pressure.size() == 0;
    const bool solved_anew = first || has_history(input_) || !input_.load.normal_forces.empty();
    if (solved_anew) tell({}, "normal", false);
    const Field start = !first     ? state_.normal.pressure
                        : coarser_ ? interpolated(coarser_->grid, coarser_->pressure, result_.grid)
                                   : Field();
    const contact::NormalSolution& normal = problem().press(load, start);
    result_.pressure = normal.pressure;
    contact::ProgressEvent event;
    event.iteration = normal.iterations;
    event.residual = normal.residual;
    event.contact_elements = normal.contact_elements;
    if (solved_anew) tell(event, "normal", true);
    if (input_.patch && solved_anew) {
      const contact::PatchSize size = contact::patch_size(result_.grid, normal.pressure);
      const auto place = [&](double s) { return curved_ ? curved_->y(s) : s; };
      check_profiles_reach(input_, place(size.y_lower), place(size.y_upper));
    }
    result_.normal_seconds += watch.seconds();
    return !touches_border(result_.grid, normal.pressure);
  }

  /// A first guess from the coarser level: its p_t / g times the bound here.
  ContactState start_for(std::size_t k, const NormalLoad& load) {
    ContactState start;
    start.normal = problem().press(load);
    start.defect = state_.defect;
    if (has_history(input_)) start.tangential.traction = state_.tangential.traction;
    if (!coarser_ || k >= coarser_->relative_traction.size()) return start;
    const TangentialField& relative = coarser_->relative_traction[k];
    const Field inside = (coarser_->pressure.array() > 0.0).cast<double>();
    const Field bound = friction_ * start.normal.pressure;
    const auto scaled = [&](const Field& values) -> Field {
      const Field here = interpolated(coarser_->grid, values, result_.grid, inside);
      return here.cwiseProduct(bound);
    };
    start.tangential.traction = {scaled(relative.x), scaled(relative.y)};
    return start;
  }

  /// Tangential problem of a load point at creepages (shifts) of which some may be sought.
  struct Attempt {
    TangentialField rigid_slip;
    double slip_factor = 1.0;
    Motion motion = Motion::rolling;
  };

  Attempt attempt(std::size_t k, const Vector2d& unknowns) const {
    Creepage creepage = input_.rolling.creepages[k];
    if (input_.rolling.problem == Problem::shift) {
      HistoryStep step = input_.history[k];
      step.longitudinal_shift = unknowns.x();
      step.lateral_shift = unknowns.y();
      const contact::StepProblem given =
          history_->shift_step(contact::rigid_shift(step, result_.grid));
      return {given.rigid_slip, given.slip_factor, Motion::shift};
    }
    creepage.longitudinal = unknowns.x();
    creepage.lateral = unknowns.y();
    const TangentialField rigid_slip = rigid_slip_of(creepage);
    if (input_.rolling.problem != Problem::transient) return {rigid_slip, 1.0, Motion::rolling};
    const contact::StepProblem given =
        history_->rolling_step(rigid_slip, input_.history[k].step_length);
    return {given.rigid_slip, given.slip_factor, Motion::shift};
  }

  TangentialField rigid_slip_of(const Creepage& creepage) const {
    return curved_ ? curved_->rigid_slip(creepage, result_.grid)
                   : contact::rigid_slip(input_, creepage, result_.grid);
  }

  Vector2d given_unknowns(std::size_t k) const {
    if (input_.rolling.problem == Problem::shift)
      return {input_.history[k].longitudinal_shift, input_.history[k].lateral_shift};
    const Creepage& c = input_.rolling.creepages[k];
    return {c.longitudinal, c.lateral};
  }

  ContactState solved(std::size_t k, const NormalLoad& load, const Vector2d& unknowns,
                      const ContactState& start, const ContactAccuracy& accuracy) {
    const Attempt given = attempt(k, unknowns);
    ContactState state = problem().solve(load, given.rigid_slip, given.motion, &start, accuracy);
    state.tangential.slip.x *= given.slip_factor;
    state.tangential.slip.y *= given.slip_factor;
    return state;
  }

  contact::ForceSearch search_for(std::size_t k, const NormalLoad& load,
                                  const PrescribedForce& wanted) {
    const contact::NormalSolution& normal = problem().press(load);
    const contact::PatchSize patch = contact::patch_size(result_.grid, normal.pressure);
    const double bound = friction_ * normal.normal_force;
    const Problem kind = input_.rolling.problem;
    contact::ForceSearch search;
    if (kind == Problem::steady) {
      search.stiffness = rolling_stiffness(patch, material_);
      search.start = first_creepage(wanted, given_unknowns(k), search.stiffness, bound);
    } else {
      search.stiffness = shift_stiffness(patch, material_);
      if (kind == Problem::transient) search.stiffness *= input_.history[k].step_length;
      search.start = given_unknowns(k);
      if (kind == Problem::transient && !result_.points.empty()) {
        const Creepage& before = result_.points.back().creepage;
        if (wanted.longitudinal) search.start.x() = before.longitudinal;
        if (wanted.lateral) search.start.y() = before.lateral;
      }
    }
    if (coarser_ && kind != Problem::shift) {
      const Creepage& found = coarser_->points[k].creepage;
      if (wanted.longitudinal) search.start.x() = found.longitudinal;
      if (wanted.lateral) search.start.y() = found.lateral;
    }
    return search;
  }

  /// Solves the point with the prescribed force; returns the creepages (shifts) found.
  Vector2d find_force(std::size_t k, const NormalLoad& load, const PrescribedForce& wanted) {
    if (friction_ == 0.0)
      throw contact::SolveError(
          "prescribed force: without friction there is no tangential force; do: prescribe the "
          "creepage, or a friction coefficient above 0");
    contact::refuse_force_beyond_friction(wanted, friction_ * problem().press(load).normal_force);
    ContactState start = start_for(k, load);
    int iterations = 0;
    const contact::ForceLaw law = [&](const Vector2d& unknowns) {
      state_ = solved(k, load, unknowns, start, accuracy_of_force_search);
      iterations += state_.iterations;
      start = state_;
      const double area = result_.grid.element_area();
      return contact::TransmittedForce{
          {area * state_.tangential.traction.x.sum(), area * state_.tangential.traction.y.sum()},
          friction_ * state_.normal.normal_force};
    };
    const contact::FoundCreepage found =
        contact::find_creepage(law, wanted, search_for(k, load, wanted));
    state_.iterations = iterations;
    return found.creepage;
  }

  std::string record_name(std::size_t k) const {
    const ContactGrid& grid = result_.grid;
    return fmt::format("halfspace-{}x{}-{:04}", grid.nx, grid.ny, k + 1);
  }

  std::string record_of(PointResult point) {
    contact::Record record;
    record.value(point);
    exchange(record, state_);
    return record.bytes();
  }

  /// A load point that an earlier run has solved, with the state from which the next one begins.
  bool taken_up(std::size_t k) {
    const std::optional<std::string> bytes = checkpoint_->find(record_name(k));
    if (!bytes) return false;
    contact::Record record(*bytes);
    PointResult point;
    record.value(point);
    exchange(record, state_);
    remember(k);
    sum_ = {point.longitudinal_shift, point.lateral_shift, point.spin_shift, point.distance};
    result_.contact_elements = state_.normal.contact_elements;
    contact::ProgressEvent event;
    event.point = static_cast<int>(k) + 1;
    event.points = static_cast<int>(input_.rolling.creepages.size());
    event.creepage = point.creepage.longitudinal;
    event.note = fmt::format("{} of {} taken up", k + 1, event.points);
    tell(event, "taken up", true);
    result_.points.push_back(std::move(point));
    return true;
  }

  void solve_point(std::size_t k) {
    const Stopwatch watch;
    const char* stage = input_.rolling.problem == Problem::shift ? "shift" : "rolling";
    contact::ProgressEvent event;
    event.point = static_cast<int>(k) + 1;
    event.points = static_cast<int>(input_.rolling.creepages.size());
    event.creepage = input_.rolling.creepages[k].longitudinal;
    event.contact_elements = problem().press(load_of(k)).contact_elements;
    tell(event, stage, false);

    const NormalLoad load = load_of(k);
    const PrescribedForce wanted =
        k < input_.rolling.forces.size() ? input_.rolling.forces[k] : PrescribedForce{};
    Vector2d unknowns = given_unknowns(k);
    if (wanted.any())
      unknowns = find_force(k, load, wanted);
    else
      state_ = solved(k, load, unknowns, start_for(k, load), {});
    PointResult point = point_result(k, unknowns);
    point.seconds = watch.seconds();
    remember(k);

    if (checkpoint_ != nullptr) checkpoint_->keep(record_name(k), record_of(point));
    event.creepage = point.creepage.longitudinal;
    event.iteration = state_.iterations;
    event.residual = state_.residual;
    event.contact_elements = state_.normal.contact_elements;
    event.adhesion_elements = static_cast<int>(std::count(
        state_.tangential.state.begin(), state_.tangential.state.end(), ElementState::adhesion));
    event.note = fmt::format("{} Krylov iterations", state_.tangential.krylov_iterations);
    tell(event, stage, true);
    result_.contact_elements = state_.normal.contact_elements;
    result_.points.push_back(std::move(point));
  }

  /// What the next step or the next finer level begins with.
  void remember(std::size_t k) {
    if (has_history(input_)) {
      const double rolled =
          input_.rolling.problem == Problem::transient ? input_.history[k].step_length : 0.0;
      history_->advance({state_.displacement.x, state_.displacement.y}, rolled);
      return;
    }
    const Field inverse_bound = state_.normal.pressure.unaryExpr(
        [this](double p) { return p > 0.0 && friction_ > 0.0 ? 1.0 / (friction_ * p) : 0.0; });
    result_.relative_traction.push_back({state_.tangential.traction.x.cwiseProduct(inverse_bound),
                                         state_.tangential.traction.y.cwiseProduct(inverse_bound)});
  }

  PointResult point_result(std::size_t k, const Vector2d& unknowns) {
    PointResult point;
    describe_motion(k, unknowns, point);
    point.fields.traction = state_.traction();
    point.fields.slip = state_.tangential.slip;
    point.fields.traction_bound = friction_ * state_.normal.pressure;
    point.fields.gap = state_.normal.gap;
    point.fields.displacement = state_.displacement;
    point.fields.state = state_.tangential.state;
    contact::integrate_tractions(result_.grid, point,
                                 curved_ ? curved_->shape(result_.grid) : contact::PatchShape{});
    derive(point);
    if (input_.patch) {
      const contact::PatchSize size = contact::patch_size(result_.grid, state_.normal.pressure);
      point.patch_x_middle = 0.5 * (size.x_lower + size.x_upper);
      point.patch_y_middle = 0.5 * (size.y_lower + size.y_upper);
    }
    point.approach = state_.normal.approach;
    point.iterations = state_.iterations;
    point.residual = state_.residual;
    point.converged = true;
    return point;
  }

  /// Works per mm rolled are the powers at V = 1; shifts and transient steps have none.
  void derive(PointResult& point) const {
    point.elastic_energy =
        elastic_energy(result_.grid, point.fields.traction, point.fields.displacement);
    const bool slips = point.fields.slip.x.size() == result_.grid.size();
    if (input_.rolling.problem != Problem::steady || !slips) return;
    // What is beyond the creepages in the rigid slip is extra slip.
    Case plain = input_;
    plain.rolling.extra_slip = contact::ExtraSlip::none;
    const TangentialField all = rigid_slip_of(point.creepage);
    const TangentialField uniform = contact::rigid_slip(plain, point.creepage, result_.grid);
    const PowerBalance balance =
        power_balance(result_.grid, point, 1.0, {all.x - uniform.x, all.y - uniform.y});
    point.frictional_work = balance.friction;
    point.creepage_work = balance.creepage;
  }

  void describe_motion(std::size_t k, const Vector2d& unknowns, PointResult& point) {
    point.creepage = input_.rolling.creepages[k];
    if (input_.rolling.problem == Problem::shift) {
      sum_.longitudinal += unknowns.x();
      sum_.lateral += unknowns.y();
      sum_.spin += input_.history[k].spin_shift;
    } else {
      point.creepage.longitudinal = unknowns.x();
      point.creepage.lateral = unknowns.y();
    }
    if (!has_history(input_)) return;
    point.step = static_cast<int>(k) + 1;
    if (input_.rolling.problem == Problem::transient)
      sum_.distance += input_.history[k].step_length;
    point.longitudinal_shift = sum_.longitudinal;
    point.lateral_shift = sum_.lateral;
    point.spin_shift = sum_.spin;
    point.distance = sum_.distance;
  }

  const Case& input_;
  const LevelResult* coarser_;
  std::string stage_prefix_;
  const contact::Progress& progress_;
  contact::Checkpoint* checkpoint_;
  contact::CombinedMaterial material_;
  double friction_;
  Stage stage_;
  std::optional<CurvedPatch> curved_;
  std::optional<contact::History> history_;
  ContactState state_;  ///< of the last load point
  Sum sum_;
  LevelResult result_;
};

}  // namespace

LevelResult solve_level(const Case& input, double dx, double dy, const LevelResult* coarser,
                        const std::string& stage_prefix, const contact::Progress& progress,
                        contact::Checkpoint* checkpoint) {
  const ContactGrid grid = potential_area(input, dx, dy, margin);
  return Level(input, coarser, stage_prefix, progress, checkpoint)
      .run(with_margin(grid, columns_for_steps(input, dx), 0));
}

}  // namespace rollfem::halfspace
