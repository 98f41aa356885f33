#include "fem/model/contact_run.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/stopwatch.hpp"
#include "contact/result/patch_size.hpp"
#include "contact/scene/contact_surface.hpp"
#include "contact/scene/geometry.hpp"
#include "contact/solve/defect_correction.hpp"
#include "fem/body/case_bodies.hpp"
#include "fem/coupling/compliance.hpp"
#include "fem/coupling/far_error.hpp"
#include "fem/model/level_checkpoint.hpp"
#include "fem/model/run_layout.hpp"
#include "fem/solver/memory.hpp"
#include "fem/solver/rolling_inertia.hpp"
#include "fem/solver/solver_choice.hpp"
#include "fem/stress/stress_output.hpp"
#include "halfspace/elasticity/compliance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::fem {

namespace {

using contact::Case;
using contact::ContactGrid;
using contact::PointResult;
using contact::Stopwatch;

/// What one load point needs and what is kept between points.
class LevelRun {
 public:
  LevelRun(const Case& input, const LevelOptions& options, const contact::Progress& progress)
      : input_(input),
        options_(options),
        progress_(progress),
        layout_(run_layout(input, options.cell_size)),
        grid_(layout_.grid),
        surface_(contact::contact_surface(input)),
        shape_(contact::patch_shape(surface_, grid_)),
        body_options_(layout_.bodies),
        checkpoint_(options.checkpoint, options.cell_size, MPI_COMM_WORLD) {}

  contact::ModelResult run();

 private:
  int points_with_bodies() const;
  void tell(contact::ProgressEvent event, const std::string& stage, bool finished = false) const;
  /// Takes up what an earlier run has solved of this level; true when that is all there is to
  /// solve.
  bool take_up(contact::ModelResult& result);
  void solve(contact::ModelResult& result);
  void solve_normal(const FemCompliance& compliance, const contact::Preconditioner& halfspace,
                    contact::ModelResult& result);
  void add_notes(contact::ModelResult& result) const;
  contact::CoupledProblem problem(std::size_t k, bool friction) const;
  PointResult solve_point(std::size_t k, const FemCompliance& compliance,
                          const contact::Preconditioner& halfspace, const StressOutput& stresses,
                          contact::ModelResult& result);
  contact::ContactFields fields(const contact::CoupledSolution& solution) const;
  void add_stresses(std::size_t k, const StressOutput& stresses, const FemCompliance& compliance,
                    PointResult& point, contact::ModelResult& result) const;
  void add_no_tractions(contact::ContactFields& fields) const;
  void refuse_patch_at_border(const contact::NormalSolution& solution) const;

  const Case& input_;
  const LevelOptions& options_;
  const contact::Progress& progress_;
  RunLayout layout_;
  ContactGrid grid_;
  contact::ContactSurface surface_;
  contact::PatchShape shape_;
  BodyOptions body_options_;
  LevelCheckpoint checkpoint_;
  LevelStart start_;
  bool start_known_ = false;  ///< the frictionless problem need not be solved
  contact::Response defect_;  ///< of the load point before: a start for the next
  contact::SurfaceField last_traction_;
  std::optional<WheelExpansion> expansion_;  ///< of a wheel that turns fast
};

int LevelRun::points_with_bodies() const {
  return options_.body_fields ? points_that_keep_bodies(input_) : 0;
}

void LevelRun::tell(contact::ProgressEvent event, const std::string& stage, bool finished) const {
  event.model = "fem";
  event.stage = options_.stage_prefix + stage;
  event.points = static_cast<int>(input_.rolling.creepages.size());
  event.finished = finished;
  contact::report(progress_, event);
}

contact::CoupledProblem LevelRun::problem(std::size_t k, bool friction) const {
  contact::CoupledProblem result;
  result.undeformed_distance = grid_.sample(
      [&](double x, double y) { return contact::undeformed_distance(surface_, x, y); });
  result.shape = shape_;
  result.normal_force = input_.load.normal_force_of(k);
  result.approach = input_.load.approach;
  if (expansion_) result.undeformed_distance += expansion_->distance;
  if (friction) {
    result.friction_coefficient = input_.friction_coefficient;
    result.rigid_slip = contact::rigid_slip(surface_, input_.rolling.creepages[k], grid_);
    if (expansion_) {
      result.rigid_slip.x += expansion_->slip.x;
      result.rigid_slip.y += expansion_->slip.y;
    }
  }
  return result;
}

contact::ContactFields LevelRun::fields(const contact::CoupledSolution& solution) const {
  contact::ContactFields result;
  result.traction = {solution.tangential.traction.x, solution.tangential.traction.y,
                     solution.normal.pressure};
  result.slip = solution.tangential.slip;
  result.traction_bound = input_.friction_coefficient * solution.normal.pressure;
  result.gap = solution.normal.gap;
  result.displacement = solution.displacement;
  result.state = solution.tangential.state;
  if (result.traction.x.size() == 0) add_no_tractions(result);
  return result;
}

/// Without friction there are no tangential tractions, and nothing adheres.
void LevelRun::add_no_tractions(contact::ContactFields& fields) const {
  const contact::Field zero = contact::Field::Zero(grid_.size());
  fields.traction.x = fields.traction.y = fields.traction_bound = zero;
  fields.slip = {zero, zero};
  for (const double p : fields.traction.n)
    fields.state.push_back(p > 0.0 ? contact::ElementState::slip : contact::ElementState::exterior);
}

void LevelRun::refuse_patch_at_border(const contact::NormalSolution& solution) const {
  if (contact::touches_border(grid_, solution.pressure))
    throw contact::SolveError(fmt::format(
        "the contact patch reaches the border of the potential contact area ({:.3g} x {:.3g} mm): "
        "the segments are too compliant for their size; give a larger [fem] extent",
        grid_.nx * grid_.dx, grid_.ny * grid_.dy));
}

void LevelRun::solve_normal(const FemCompliance& compliance,
                            const contact::Preconditioner& halfspace,
                            contact::ModelResult& result) {
  tell({}, "normal");
  const contact::CoupledSolution frictionless =
      contact::solve_coupled(compliance, halfspace, problem(0, false));
  refuse_patch_at_border(frictionless.normal);
  contact::ProgressEvent event;
  event.iteration = frictionless.outer_iterations;
  event.residual = frictionless.residual;
  event.contact_elements = frictionless.normal.contact_elements;
  tell(event, "normal", true);
  result.contact_elements = frictionless.normal.contact_elements;
  defect_ = frictionless.defect;
  start_.defect = frictionless.defect;
  start_.contact_elements = result.contact_elements;
  checkpoint_.keep(start_);
}

bool LevelRun::take_up(contact::ModelResult& result) {
  start_known_ = checkpoint_.find(start_);
  if (!start_known_) return false;
  defect_ = start_.defect;
  result.unknowns = start_.unknowns;
  result.contact_elements = start_.contact_elements;
  const std::size_t count = input_.rolling.creepages.size();
  PointResult point;
  while (result.points.size() < count && checkpoint_.find(result.points.size(), point, defect_))
    result.points.push_back(std::move(point));
  contact::ProgressEvent event;
  event.note = fmt::format("{} of {} load points of an earlier run", result.points.size(), count);
  tell(event, "taken up", true);
  if (!result.points.empty()) last_traction_ = result.points.back().fields.traction;
  result.bodies = start_.bodies;
  return result.points.size() == count;
}

PointResult LevelRun::solve_point(std::size_t k, const FemCompliance& compliance,
                                  const contact::Preconditioner& halfspace,
                                  const StressOutput& stresses, contact::ModelResult& result) {
  const Stopwatch watch;
  const contact::Creepage& creepage = input_.rolling.creepages[k];
  contact::ProgressEvent event;
  event.point = static_cast<int>(k) + 1;
  event.creepage = creepage.longitudinal;
  const auto each_iteration = [&](const contact::CoupledSolution& state) {
    event.iteration = state.outer_iterations;
    event.residual = state.residual;
    event.contact_elements = state.normal.contact_elements;
    event.adhesion_elements =
        static_cast<int>(std::count(state.tangential.state.begin(), state.tangential.state.end(),
                                    contact::ElementState::adhesion));
    tell(event, "rolling");
  };
  const contact::CoupledSolution solution = contact::solve_coupled(
      compliance, halfspace, problem(k, input_.rolling.problem != contact::Problem::frictionless),
      {}, defect_, each_iteration);
  refuse_patch_at_border(solution.normal);
  defect_ = solution.defect;

  PointResult point;
  point.creepage = creepage;
  point.approach = solution.normal.approach;
  point.iterations = solution.outer_iterations;
  point.residual = solution.residual;
  point.converged = true;
  point.fields = fields(solution);
  contact::integrate_tractions(grid_, point, shape_);
  last_traction_ = point.fields.traction;
  point.seconds = watch.seconds();
  point.error_estimate["approach"] =
      approach_left_out(input_, point.normal_force, start_.reach) / point.approach;
  if (stresses.wanted(k)) add_stresses(k, stresses, compliance, point, result);
  checkpoint_.keep(k, point, defect_);
  tell(event, "rolling", true);
  return point;
}

void LevelRun::add_stresses(std::size_t k, const StressOutput& stresses,
                            const FemCompliance& compliance, PointResult& point,
                            contact::ModelResult& result) const {
  const Stopwatch watch;
  tell({}, "stresses");
  stresses.fill(k, point, compliance.body_displacements(last_traction_),
                expansion_ ? &expansion_->displacement : nullptr);
  tell({}, "stresses", true);
  result.seconds["stresses"] += watch.seconds();
}

contact::ModelResult LevelRun::run() {
  contact::ModelResult result;
  result.name = "fem";
  result.grid = grid_;
  if (!take_up(result)) solve(result);
  add_notes(result);
  return result;
}

void LevelRun::solve(contact::ModelResult& result) {
  const Stopwatch mesh_watch;
  tell({}, "mesh");
  const BodyOptions& options = body_options_;
  const CaseBodies bodies = make_bodies(input_, options, MPI_COMM_WORLD);
  const Body& wheel = *bodies.wheel;
  const Body& rail = *bodies.rail;
  start_.reach = bodies.reach;
  start_.half = wheel.options().half && rail.options().half;
  start_.notes.clear();
  for (const std::string& note : bodies.notes)
    start_.notes += (start_.notes.empty() ? "" : "\n") + note;
  result.unknowns = static_cast<long>(wheel.unknowns() + rail.unknowns());
  contact::ProgressEvent event;
  MemoryDemand demand =
      memory_demand(static_cast<double>(wheel.unknowns()), static_cast<double>(rail.unknowns()),
                    options, points_with_bodies());
  demand.algebraic = takes_algebraic(input_, wheel) || takes_algebraic(input_, rail);
  demand.factorisation = takes_factorisation(input_, demand);
  event.note = fmt::format("wheel {} + rail {} unknowns, {}", wheel.unknowns(), rail.unknowns(),
                           memory_note(demand, MPI_COMM_WORLD));
  tell(event, "mesh", true);
  refuse_beyond_memory(demand, options.cell_size, MPI_COMM_WORLD);
  result.seconds["mesh"] = mesh_watch.seconds();

  const Stopwatch solver_watch;
  tell({}, "linear solvers");
  const Solvers solvers = make_solvers(input_, wheel, rail, demand.factorisation);
  const StressOutput stresses(input_, wheel, rail, grid_, default_cell_size(input_),
                              options_.body_fields);
  start_.bodies = result.bodies = stresses.bodies();
  const FemCompliance compliance({&wheel, solvers.wheel.get()}, {&rail, solvers.rail.get()}, grid_,
                                 far_boundary_of(input_));
  start_.unknowns = result.unknowns;
  start_.solver = solvers.wheel->description();
  event.note = start_.solver;
  tell(event, "linear solvers", true);
  if (contact::feels_inertia(input_)) {
    expansion_ =
        wheel_expansion(wheel, *solvers.wheel, surface_, grid_, input_.rolling.upwind_order);
    result.notes.push_back(fmt::format(
        "rolling at {:.4g} mm/s: inertia of wheel and rail; spinning moves the wheel's surface out "
        "by {:.3g} mm, so that the axle stands higher: taken off the approach",
        input_.rolling.speed, -expansion_->distance.mean()));
  }
  result.seconds["factorisation"] = solver_watch.seconds();

  // The coupling of unlike materials is left to the defect: the preconditioner need not know it.
  contact::CombinedMaterial material =
      contact::combine(input_.wheel.material, input_.rail.material);
  material.difference = 0.0;
  const halfspace::HalfspaceCompliance half(grid_, material);
  const contact::UpwindOrder order = input_.rolling.upwind_order;
  const bool fitted = input_.rolling.leading_edge == contact::LeadingEdge::fitted;
  const contact::Preconditioner halfspace{
      half,
      half.normal(),
      half.rolling(order),
      order,
      contact::Motion::rolling,
      fitted ? &half.rolling(contact::UpwindOrder::first) : nullptr};

  const Stopwatch normal_watch;
  if (!start_known_) solve_normal(compliance, halfspace, result);
  result.seconds["normal"] = normal_watch.seconds();

  const Stopwatch rolling_watch;
  for (std::size_t k = result.points.size(); k < input_.rolling.creepages.size(); ++k)
    result.points.push_back(solve_point(k, compliance, halfspace, stresses, result));
  result.seconds["tangential"] = rolling_watch.seconds();
}

void LevelRun::add_notes(contact::ModelResult& result) const {
  result.notes.push_back(far_boundary_note(input_, start_.reach));
  if (!start_.notes.empty()) result.notes.push_back(start_.notes);
  const double steepest = shape_.climb.cwiseAbs().maxCoeff();
  if (steepest > 0.05)
    result.notes.push_back(fmt::format(
        "the patch is curved (slope {:.2g} at the edge of the grid): tractions, slip and gap are "
        "along the local normal and tangents, y is the lateral coordinate, forces are along x, y, "
        "z",
        steepest));
  if (input_.rolling.extra_slip != contact::ExtraSlip::none)
    result.notes.push_back(
        "extra_slip is not added: the rolling radius of every point comes from the wheel's "
        "profile");
  if (input_.patch && std::abs(input_.patch->axle().direction[0]) > 1e-9)
    result.notes.push_back(fmt::format(
        "the wheel is yawed by {:.3g} mrad: that is in undeformed distance and slip; its "
        "finite-element body is turned about the axle without yaw",
        1e3 * std::asin(input_.patch->axle().direction[0])));
  if (start_.half)
    result.notes.push_back("half of each body is modelled: the plane y = 0 is a symmetry plane");
  result.notes.push_back(fmt::format("cells of {:.4g} mm in the patch, degree {}; {}",
                                     body_options_.cell_size, body_options_.degree, start_.solver));
}

}  // namespace

contact::ModelResult run_level(const Case& input, const LevelOptions& options,
                               const contact::Progress& progress) {
  return LevelRun(input, options, progress).run();
}

}  // namespace rollfem::fem
