// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/elasticity/run_level.hpp"

#include "base/errors.hpp"
#include "base/progress.hpp"
#include "base/threads.hpp"
#include "contact/solve/contact_run.hpp"
#include "contact/solve/side_by_side.hpp"
#include "contact/solve/state_record.hpp"
#include "fem/discretisation/case_bodies.hpp"
#include "fem/linear/memory.hpp"
#include "fem/linear/root_process.hpp"
#include "fem/linear/solver_choice.hpp"
#include "fem/mesh/run_layout.hpp"
#include "fem/plasticity/pass_results.hpp"
#include "fem/plasticity/yielding_bodies.hpp"
#include "fem/stress/stress_output.hpp"
#include "fem/trace/far_field.hpp"
#include "fem/trace/fem_compliance.hpp"
#include "fem/trace/rolling_inertia.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "halfspace/elasticity/preconditioned_elasticity.hpp"
#include "halfspace/patch/coverage.hpp"
#include "result/derived.hpp"
#include "result/heat/temperature.hpp"
#include "result/record.hpp"
#include "scene/geometry.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace rollfem::fem {

namespace {

using contact::PatchSize;
using contact::PointResult;
using contact::Scene;
using contact::Stopwatch;

/// Collective work, commanded by the root process, with its data.
enum class Action { prepare, respond, complete };
struct Task {
  Action action = Action::prepare;
  contact::SurfaceField traction;
  long number = 0;                                         ///< of the load point that is completed
  contact::Field temperature_wheel{}, temperature_rail{};  ///< of its surfaces

  RootProcess::Command command() const {
    return contact::record_of(action, traction, number, temperature_wheel, temperature_rail);
  }
};

void add_notes(const Scene& scene, const contact::ChartedGeometry& geometry,
               const RunLayout& layout, const CaseBodies& bodies, const std::string& solver,
               std::vector<contact::Note>& notes) {
  notes.push_back({"far_boundary", far_boundary_note(scene, bodies.reach)});
  notes.insert(notes.end(), bodies.notes.begin(), bodies.notes.end());
  const double steepest = geometry.shape(layout.grid).climb.cwiseAbs().maxCoeff();
  if (steepest > 0.05)
    contact::add_note(notes, "curved",
                      "the patch is curved (slope {:.2g} at the edge of the grid): tractions, slip "
                      "and gap are along the local normal and tangents, y is the lateral "
                      "coordinate, forces are along x, y, z",
                      steepest);
  if (scene.has_profiles()) {
    const double yaw = std::asin(scene.geometry.surface.profiles->axle().direction[0]);
    if (std::abs(yaw) > 1e-9)
      contact::add_note(notes, "yaw",
                        "the wheel is yawed by {:.3g} mrad: undeformed distance and slip include "
                        "this; its finite-element body is revolved about the axle without yaw",
                        1e3 * yaw);
  }
  if (bodies.half())
    notes.push_back({"symmetry", "half of each body is modelled: y = 0 is a symmetry plane"});
  contact::add_note(notes, "cells", "cells of {:.4g} mm in the patch, degree {}; {}",
                    layout.bodies.cell_size, layout.bodies.degree, solver);
}

/// What the load points of a level share: bodies, linear solvers and compliance on the contact
/// grid, with the half-space that preconditions them, and the stresses of load points. Fills
/// unknowns, bodies, seconds and notes of `result`; all arguments must outlive it.
class SharedLevel {
 public:
  SharedLevel(const Scene& the_scene, const contact::ChartedGeometry& geometry,
              const RunLayout& the_layout, const LevelOptions& options,
              const contact::Progress& progress, RootProcess& the_root,
              contact::ModelResult& result)
      : scene(the_scene),
        layout(the_layout),
        root(the_root),
        geometry_(geometry),
        options_(options),
        progress_(progress),
        result_(result) {}

  SharedLevel(const SharedLevel&) = delete;
  SharedLevel& operator=(const SharedLevel&) = delete;
  ~SharedLevel() {
    one_at_a_time([&] {
      compliance.reset();
      yielding_.reset();
      stresses_.reset();
      solvers_ = {};
      bodies_ = {};
    });
  }

  void execute(const RootProcess::Command& command);
  void solve_contact();
  /// By the first load point that needs them.
  void prepare() {
    std::call_once(prepared_, [&] {
      contact::isolated([&] { root.call(Task{}.command(), [&] { make_bodies_and_solvers(); }); });
    });
  }
  void complete(const FemCompliance& of_point, std::size_t k, PointResult& point);
  std::string memory() const { return yielding_ ? yielding_->memory() : std::string(); }
  void restore(const std::string& memory) { last_pass_ = memory; }
  std::size_t most_beside() const;
  double imbalance() const { return yielding_ ? yielding_->imbalance() : 0.0; }
  /// Adds the displacement by plastic flow to the responses of a compliance.
  void let_yield(FemCompliance& of_point) const {
    if (yielding_ && options_of(scene).pass_pressure == PassPressure::yielding)
      of_point.set_beyond_elastic(
          [this](const std::vector<Vector>& elastic) { return yielding_->respond(elastic); });
  }

  const Scene& scene;
  const RunLayout& layout;
  RootProcess& root;
  std::unique_ptr<FemCompliance> compliance;
  // On the root process.
  std::unique_ptr<halfspace::HalfspaceCompliance> half;
  std::unique_ptr<halfspace::HalfspaceCompliance> coupled_half;  ///< null: like materials
  std::optional<WheelExpansion> expansion;                       ///< of a fast rotating wheel

 private:
  void report_progress(contact::ProgressEvent event, const std::string& stage,
                       bool finished = false) const;
  void make_bodies_and_solvers();
  void make_meshes();
  void make_compliance();
  void spin_wheel();
  void add_stresses(const FemCompliance& of_point, std::size_t k, PointResult& point);

  const contact::ChartedGeometry& geometry_;
  const LevelOptions& options_;
  const contact::Progress& progress_;
  contact::ModelResult& result_;
  std::once_flag prepared_;
  CaseBodies bodies_;
  bool factorisation_ = false;
  Solvers solvers_;
  std::unique_ptr<YieldingBodies> yielding_;  ///< null: elastic
  std::string last_pass_;                     ///< memory of an earlier run that is resumed
  std::unique_ptr<StressOutput> stresses_;
};

/// Finite elements of all processes and the layer between the bodies, for the contact problem of
/// the root process; all take part in prepare(), respond() and complete().
class LevelElasticity : public contact::Elasticity, private contact::Compliance {
 public:
  explicit LevelElasticity(SharedLevel& level) : level_(level) {}

  void prepare() override {
    level_.prepare();
    own_ = std::make_unique<FemCompliance>(*level_.compliance);
    level_.let_yield(*own_);
  }
  const contact::Compliance& compliance() const override { return *this; }
  const contact::SolvableCompliance& halfspace() const override { return *level_.half; }
  const contact::Compliance* coupled_halfspace() const override {
    return level_.coupled_half.get();
  }
  contact::Field extra_distance() const override {
    return level_.expansion ? level_.expansion->distance : contact::Field();
  }
  contact::TangentialField extra_slip() const override {
    return level_.expansion ? level_.expansion->slip : contact::TangentialField();
  }
  Eigen::Vector2d rolling_stiffness(const PatchSize& patch) const override {
    return halfspace::rolling_stiffness(patch, level_.scene.material);
  }
  Eigen::Vector2d shift_stiffness(const PatchSize& patch) const override {
    return halfspace::shift_stiffness(patch, level_.scene.material);
  }
  std::string memory() const override { return level_.memory(); }
  void restore(const std::string& memory) override { level_.restore(memory); }
  void complete(std::size_t k, PointResult& point) override { level_.complete(*own_, k, point); }

 private:
  const contact::ContactGrid& grid() const override { return level_.layout.grid; }
  contact::SurfaceField apply(const contact::SurfaceField& traction) const override {
    return respond(traction).displacement;
  }
  contact::Response respond(const contact::SurfaceField& traction) const override {
    contact::Response response;
    level_.root.call(Task{Action::respond, traction}.command(),
                     [&] { response = own_->respond(traction); });
    response.displacement.x += level_.scene.material.layer * traction.x;
    response.displacement.y += level_.scene.material.layer * traction.y;
    return response;
  }

  double imbalance() const override { return level_.imbalance(); }

  SharedLevel& level_;
  std::unique_ptr<FemCompliance> own_;
};

void SharedLevel::execute(const RootProcess::Command& command) {
  Task task;
  contact::Record(command).values(task.action, task.traction, task.number, task.temperature_wheel,
                                  task.temperature_rail);
  if (task.action == Action::prepare) make_bodies_and_solvers();
  if (task.action == Action::respond) compliance->respond(task.traction);
  if (task.action != Action::complete) return;
  PointResult point;
  point.fields.traction = std::move(task.traction);
  point.fields.temperature_wheel = std::move(task.temperature_wheel);
  point.fields.temperature_rail = std::move(task.temperature_rail);
  add_stresses(*compliance, static_cast<std::size_t>(task.number), point);
}

void SharedLevel::complete(const FemCompliance& of_point, std::size_t k, PointResult& point) {
  point.error_estimate["approach"] = approach_left_out(scene, point.normal_force, bodies_.reach);
  if (!stresses_->wanted(k) && !yielding_) return;
  const Task task{Action::complete, point.fields.traction, static_cast<long>(k),
                  point.fields.temperature_wheel, point.fields.temperature_rail};
  one_at_a_time([&] { root.call(task.command(), [&] { add_stresses(of_point, k, point); }); });
}

/// Several processes take part in one solve after the other.
std::size_t SharedLevel::most_beside() const {
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1) return 1;
  if (compliance && !compliance->copies_run_beside_each_other()) return 1;
  return solves_in_memory(static_cast<double>(result_.unknowns));
}

void SharedLevel::make_bodies_and_solvers() {
  result_.notes.clear();  // of an earlier run that is resumed
  const Stopwatch mesh_watch;
  make_meshes();
  result_.seconds["mesh"] = mesh_watch.seconds();
  const Stopwatch solver_watch;
  make_compliance();
  result_.seconds["factorisation"] = solver_watch.seconds();
}

void SharedLevel::report_progress(contact::ProgressEvent event, const std::string& stage,
                                  bool finished) const {
  event.model = "fem";
  event.stage = options_.stage_prefix + stage;
  event.points = static_cast<int>(scene.points.size());
  event.finished = finished;
  contact::report(progress_, event);
}

void SharedLevel::make_meshes() {
  report_progress({}, "mesh");
  one_at_a_time([&] { bodies_ = make_bodies(scene, layout.bodies, MPI_COMM_WORLD); });
  const MemoryDemand demand =
      memory_demand(scene, layout.bodies, bodies_.both(), options_.body_fields);
  factorisation_ = demand.factorisation;
  result_.unknowns = static_cast<long>(demand.unknowns[0] + demand.unknowns[1]);
  contact::ProgressEvent event;
  event.note = fmt::format("wheel {:.0f} + rail {:.0f} unknowns, {}", demand.unknowns[0],
                           demand.unknowns[1], memory_note(demand, MPI_COMM_WORLD));
  report_progress(event, "mesh", true);
  refuse_beyond_memory(demand, layout.bodies.cell_size, MPI_COMM_WORLD);
}

void SharedLevel::make_compliance() {
  report_progress({}, "linear solvers");
  solvers_ = make_solvers(scene, bodies_.both(), factorisation_);
  one_at_a_time([&] {
    stresses_ = std::make_unique<StressOutput>(scene, bodies_.both(), layout.grid,
                                               default_cell_size(scene), options_.body_fields);
  });
  result_.bodies = stresses_->bodies();
  compliance =
      std::make_unique<FemCompliance>(FemCompliance::Part{bodies_.wheel.get(), solvers_[0].get()},
                                      FemCompliance::Part{bodies_.rail.get(), solvers_[1].get()},
                                      scene.geometry.surface, layout.grid, far_boundary_of(scene));
  if (scene.yields()) {
    one_at_a_time([&] {
      yielding_ = std::make_unique<YieldingBodies>(scene, bodies_.both(), solvers_, layout.grid);
    });
    yielding_->recall(last_pass_);
    let_yield(*compliance);
  }
  contact::ProgressEvent event;
  event.note = (solvers_[0] ? solvers_[0] : solvers_[1])->description();
  report_progress(event, "linear solvers", true);
  if (scene.feels_inertia() && bodies_.wheel) spin_wheel();
  add_notes(scene, geometry_, layout, bodies_, event.note, result_.notes);
  if (!root.here()) return;
  // The defect includes the coupling of unlike materials; the half-space need not.
  half = std::make_unique<halfspace::HalfspaceCompliance>(layout.grid, scene.material.uncoupled());
  if (scene.material.couples())
    coupled_half = std::make_unique<halfspace::HalfspaceCompliance>(layout.grid, scene.material);
}

void SharedLevel::spin_wheel() {
  expansion = wheel_expansion(*bodies_.wheel, *solvers_[0], geometry_.geometry().surface,
                              layout.grid, scene.upwind_order);
  contact::add_note(result_.notes, "inertia",
                    "rolling at {:.4g} mm/s: inertia of wheel and rail; rotation expands the wheel "
                    "by {:.3g} mm, which raises the axle and is subtracted from the approach",
                    scene.speed, -expansion->distance.mean());
}

void SharedLevel::add_stresses(const FemCompliance& of_point, std::size_t k, PointResult& point) {
  const Stopwatch watch;
  report_progress({}, yielding_ ? "plastic flow" : "stresses");
  std::vector<Vector> displacement = of_point.body_displacements(point.fields.traction);
  std::array<const YieldedFields*, 2> yielded{};
  if (yielding_) {
    yielding_->finish_pass(displacement, point);
    point.step = static_cast<int>(k) + 1;
    for (std::size_t b = 0; b < 2; ++b) {
      yielded[b] = yielding_->fields(b);
      if (yielded[b] == nullptr) continue;
      displacement[b] += yielded[b]->displacement;
      displacement[b].update_ghost_values();
    }
  }
  if (stresses_->wanted(k))
    stresses_->fill(k, point, displacement, expansion ? &expansion->displacement : nullptr,
                    yielded);
  report_progress({}, yielding_ ? "plastic flow" : "stresses", true);
  result_.seconds["stresses"] += watch.seconds();
}

/// Every outer iteration solves each body, so the tolerance matches the accuracy of the elements.
constexpr contact::ContactAccuracy fem_accuracy{1e-6, {1e-4, 40, 3}};
/// Steel that is pressed comes into balance together with the contact.
constexpr contact::ContactAccuracy pressed_accuracy{1e-6, {2e-5, 300, 0}};
/// Tolerance of a prescribed force, relative to mu F_z.
constexpr double force_tolerance = 1e-5;

[[noreturn]] void refuse_border(const Scene& scene, const contact::ChartedGeometry& geometry,
                                const contact::ContactGrid& grid) {
  const double border = geometry.lateral_place(grid.y(grid.ny - 1));
  const std::string why = contact::why_flanks_touch(scene.geometry, border);
  if (!why.empty()) throw contact::SolveError(why);
  throw contact::SolveError(fmt::format(
      "the contact patch reaches the border of the potential contact area ({:.3g} x {:.3g} mm): {}",
      grid.nx * grid.dx, grid.ny * grid.dy,
      scene.contact_grid.extent ? "give a larger contact_grid.extent"
                                : "the segments are too compliant for their size; give a larger "
                                  "[fem] extent"));
}

void refuse_further_patches(const Scene& scene, const contact::ChartedGeometry& geometry,
                            const contact::ContactGrid& grid,
                            const std::vector<PointResult>& points) {
  const halfspace::PatchSearch area(scene);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto beyond =
        halfspace::touched_beyond(scene, geometry, area, grid, points[k], scene.points[k].load);
    if (!beyond) continue;
    const double lower = std::min((*beyond)[0], grid.y(0)) - grid.dy;
    const double upper = std::max((*beyond)[1], grid.y(grid.ny - 1)) + grid.dy;
    throw contact::SolveError(
        scene.where(),
        "wheel and rail also touch between y = {:.4g} and {:.4g} mm, beyond the potential "
        "contact area from {:.4g} to {:.4g} mm; do: give contact_grid.extent = [{:.3g}, "
        "{:.3g}] "
        "and middle = [0, {:.3g}]",
        (*beyond)[0], (*beyond)[1], grid.y(0) - 0.5 * grid.dy, grid.y(grid.ny - 1) + 0.5 * grid.dy,
        grid.nx * grid.dx, 1.1 * (upper - lower), 0.5 * (lower + upper));
  }
}

/// The part of the root process: everything except the collective work.
void SharedLevel::solve_contact() {
  contact::ModelResult& result = result_;
  // Load points with the states from which the next ones start, so that numbers of a resumed run
  // are the same to the last bit.
  const std::string name = fmt::format("fem-{:.9g}mm", options_.cell_size);
  contact::Response first_defect;
  /// Writes or reads the frictionless solution and the data of the level as a whole.
  const auto start = [&](contact::Record& record) {
    record.values(first_defect, result.contact_elements, result.unknowns, result.notes,
                  result.bodies);
    record.demand(first_defect.displacement.x.size() == first_defect.displacement.n.size());
  };
  const contact::ModelResult before = result;
  // Bodies that yield begin the first load point from where this solution has left their iteration,
  // which is not stored: without that point it is found anew.
  const bool stored =
      options_.checkpoint != nullptr &&
      (!scene.yields() || options_.checkpoint->find(name + "-0001")) &&
      contact::found(*options_.checkpoint, name + "-normal", start, layout.grid.size());
  if (!stored) {
    result = before;
    first_defect = {};
  }
  contact::RunOptions run_options;
  run_options.model = "fem";
  run_options.stage_prefix = options_.stage_prefix;
  run_options.accuracy = run_options.force_accuracy =
      scene.yields() && scene.is_history() ? pressed_accuracy : fem_accuracy;
  run_options.force_tolerance = force_tolerance;
  run_options.independent = !scene.is_history() && !scene.load_changes() && !scene.yields();
  const auto make = [&] { return std::make_unique<LevelElasticity>(*this); };
  std::optional<contact::PointStore> store;
  // What several processes know of bodies that yield is not collected.
  const bool collected =
      !scene.yields() || dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
  if (options_.checkpoint != nullptr && collected)
    store.emplace(*options_.checkpoint, name, stored);
  if (!stored) {
    contact::ContactRun run(scene, geometry_, run_options, progress_, nullptr);
    run.on_first_defect = [&](const contact::Response& defect, int contact_elements) {
      first_defect = defect;
      result.contact_elements = contact_elements;
      if (options_.checkpoint == nullptr) return;
      contact::Record record;
      start(record);
      options_.checkpoint->keep(name + "-normal", record.bytes());
    };
    run.solve_without_friction(layout.grid, make);
    result.seconds["normal"] = run.take_result().normal_seconds;
  }
  run_options.first_defect = first_defect;
  run_options.most_beside = most_beside();
  auto solved = contact::solve_points(scene, geometry_, run_options, progress_,
                                      store ? &*store : nullptr, layout.grid, make);
  if (!solved) refuse_border(scene, geometry_, layout.grid);
  contact::LevelResult level = *std::move(solved);
  refuse_further_patches(scene, geometry_, layout.grid, level.points);
  contact::warn_of_steep_friction(level, scene.friction(), result.notes);
  result.points = std::move(level.points);
  for (std::size_t k = 0; k < result.points.size(); ++k)
    for (contact::YieldedSection& section : result.points[k].yielded)
      section.finding = finding(section, nullptr, static_cast<int>(k) + 1);
  result.seconds["normal"] += level.normal_seconds;
  result.seconds["tangential"] = level.tangential_seconds;
}

}  // namespace

contact::ModelResult run_level(const Scene& scene, const LevelOptions& options,
                               const contact::Progress& progress) {
  const RunLayout layout = run_layout(scene, options.cell_size);
  const contact::ChartedGeometry geometry(scene.geometry, contact::Chart::projected);
  contact::ModelResult result;
  result.name = "fem";
  result.grid = layout.grid;
  RootProcess root(MPI_COMM_WORLD);
  {
    SharedLevel shared(scene, geometry, layout, options, progress, root, result);
    root.run([&] { shared.solve_contact(); },
             [&](const RootProcess::Command& command) { shared.execute(command); });
  }
  contact::place_pass_work(geometry, scene.place, result);
  const auto yields_cold = [&](bool is_wheel) {
    const BodyOptions own = options_of(scene, is_wheel, layout.bodies);
    return own.yields && !resolves_heat(scene, is_wheel, own);
  };
  contact::tell_of_heat(scene, result, {yields_cold(true), yields_cold(false)});
  return result;
}

}  // namespace rollfem::fem
