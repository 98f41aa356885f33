// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/elasticity/fem_elasticity.hpp"

#include "contact/base/progress.hpp"
#include "contact/result/record.hpp"
#include "fem/discretisation/case_bodies.hpp"
#include "fem/linear/memory.hpp"
#include "fem/linear/solver_choice.hpp"
#include "fem/stress/stress_output.hpp"
#include "fem/trace/compliance.hpp"
#include "fem/trace/far_error.hpp"
#include "fem/trace/rolling_inertia.hpp"
#include "halfspace/elasticity/compliance.hpp"
#include "halfspace/elasticity/preconditioned_elasticity.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

namespace rollfem::fem {

namespace {

using contact::PatchSize;
using contact::PointResult;
using contact::Scene;
using contact::Stopwatch;

/// Collective work, ordered by the first process, with its data.
enum class Action { prepare, respond, complete };
struct Task {
  Action action = Action::prepare;
  contact::SurfaceField traction;
  // Data for completing a load point.
  long number = 0;
  double normal_force = 0.0;

  FirstProcess::Order order() const {
    return contact::record_of(action, traction, number, normal_force);
  }
};

void add_notes(const Scene& scene, const contact::ChartedGeometry& geometry,
               const RunLayout& layout, const CaseBodies& bodies, const std::string& solver,
               std::vector<std::string>& notes) {
  notes.push_back(far_boundary_note(scene, bodies.reach));
  if (!bodies.notes.empty()) notes.push_back(fmt::format("{}", fmt::join(bodies.notes, "\n")));
  const double steepest = geometry.shape(layout.grid).climb.cwiseAbs().maxCoeff();
  if (steepest > 0.05)
    notes.push_back(fmt::format(
        "the patch is curved (slope {:.2g} at the edge of the grid): tractions, slip and gap are "
        "along the local normal and tangents, y is the lateral coordinate, forces are along x, y, "
        "z",
        steepest));
  if (scene.has_profiles()) {
    const double yaw = std::asin(scene.geometry.surface.profiles->axle().direction[0]);
    if (std::abs(yaw) > 1e-9)
      notes.push_back(
          fmt::format("the wheel is yawed by {:.3g} mrad: undeformed distance and slip include "
                      "this; its finite-element body is revolved about the axle without yaw",
                      1e3 * yaw));
  }
  if (bodies.half()) notes.push_back("half of each body is modelled: y = 0 is a symmetry plane");
  notes.push_back(fmt::format("cells of {:.4g} mm in the patch, degree {}; {}",
                              layout.bodies.cell_size, layout.bodies.degree, solver));
}

class LevelElasticity : public FemElasticity {
 public:
  LevelElasticity(const Scene& scene, const contact::ChartedGeometry& geometry,
                  const RunLayout& layout, const LevelOptions& options,
                  const contact::Progress& progress, FirstProcess& first,
                  contact::ModelResult& result)
      : scene_(scene),
        geometry_(geometry),
        layout_(layout),
        options_(options),
        progress_(progress),
        first_(first),
        result_(result) {}

  void obey(const FirstProcess::Order& order) override;
  void prepare() override {
    first_.call(Task{}.order(), [&] { make_bodies_and_solvers(); });
  }
  const contact::Compliance& compliance() const override { return together_; }
  const contact::SolvableCompliance& standin() const override { return *half_; }
  const contact::Compliance* coupled_standin() const override { return coupled_half_.get(); }
  contact::Field extra_distance() const override {
    return expansion_ ? expansion_->distance : contact::Field();
  }
  contact::TangentialField extra_slip() const override {
    return expansion_ ? expansion_->slip : contact::TangentialField();
  }
  Eigen::Vector2d rolling_stiffness(const PatchSize& patch) const override {
    return halfspace::rolling_stiffness(patch, scene_.material);
  }
  Eigen::Vector2d shift_stiffness(const PatchSize& patch) const override {
    return halfspace::shift_stiffness(patch, scene_.material);
  }
  void complete(std::size_t k, PointResult& point) override {
    Task task{Action::complete, point.fields.traction, static_cast<long>(k), point.normal_force};
    first_.call(task.order(), [&] { add_stresses(k, point); });
  }

 private:
  /// Finite elements of all processes, and the layer between the bodies.
  class Together : public contact::Compliance {
   public:
    explicit Together(const LevelElasticity& level) : level_(level) {}
    const contact::ContactGrid& grid() const override { return level_.layout_.grid; }
    contact::SurfaceField apply(const contact::SurfaceField& traction) const override {
      return respond(traction).displacement;
    }
    contact::Response respond(const contact::SurfaceField& traction) const override {
      contact::Response response;
      level_.first_.call(Task{Action::respond, traction}.order(),
                         [&] { response = level_.compliance_->respond(traction); });
      response.displacement.x += level_.scene_.material.layer * traction.x;
      response.displacement.y += level_.scene_.material.layer * traction.y;
      return response;
    }

   private:
    const LevelElasticity& level_;
  };

  void tell(contact::ProgressEvent event, const std::string& stage, bool finished = false) const;
  void make_bodies_and_solvers();
  void make_meshes();
  void make_compliance();
  void spin_wheel();
  void add_stresses(std::size_t k, PointResult& point);

  const Scene& scene_;
  const contact::ChartedGeometry& geometry_;
  const RunLayout& layout_;
  const LevelOptions& options_;
  const contact::Progress& progress_;
  FirstProcess& first_;
  contact::ModelResult& result_;
  CaseBodies bodies_;
  bool factorisation_ = false;
  Solvers solvers_;
  std::unique_ptr<StressOutput> stresses_;
  std::unique_ptr<FemCompliance> compliance_;
  Together together_{*this};
  std::unique_ptr<halfspace::HalfspaceCompliance> half_;
  std::unique_ptr<halfspace::HalfspaceCompliance> coupled_half_;  ///< null: like materials
  std::optional<WheelExpansion> expansion_;                       ///< of a fast rotating wheel
};

void LevelElasticity::obey(const FirstProcess::Order& order) {
  Task task;
  contact::Record(order).values(task.action, task.traction, task.number, task.normal_force);
  if (task.action == Action::prepare) make_bodies_and_solvers();
  if (task.action == Action::respond) compliance_->respond(task.traction);
  if (task.action != Action::complete) return;
  PointResult point;
  point.normal_force = task.normal_force;
  point.fields.traction = std::move(task.traction);
  add_stresses(static_cast<std::size_t>(task.number), point);
}

void LevelElasticity::make_bodies_and_solvers() {
  result_.notes.clear();  // of an earlier run that is resumed
  const Stopwatch mesh_watch;
  make_meshes();
  result_.seconds["mesh"] = mesh_watch.seconds();
  const Stopwatch solver_watch;
  make_compliance();
  result_.seconds["factorisation"] = solver_watch.seconds();
}

void LevelElasticity::tell(contact::ProgressEvent event, const std::string& stage,
                           bool finished) const {
  event.model = "fem";
  event.stage = options_.stage_prefix + stage;
  event.points = static_cast<int>(scene_.points.size());
  event.finished = finished;
  contact::report(progress_, event);
}

void LevelElasticity::make_meshes() {
  tell({}, "mesh");
  bodies_ = make_bodies(scene_, layout_.bodies, MPI_COMM_WORLD);
  const MemoryDemand demand =
      memory_demand(scene_, layout_.bodies, bodies_.both(), options_.body_fields);
  factorisation_ = demand.factorisation;
  result_.unknowns = static_cast<long>(demand.unknowns[0] + demand.unknowns[1]);
  contact::ProgressEvent event;
  event.note = fmt::format("wheel {:.0f} + rail {:.0f} unknowns, {}", demand.unknowns[0],
                           demand.unknowns[1], memory_note(demand, MPI_COMM_WORLD));
  tell(event, "mesh", true);
  refuse_beyond_memory(demand, layout_.bodies.cell_size, MPI_COMM_WORLD);
}

void LevelElasticity::make_compliance() {
  tell({}, "linear solvers");
  solvers_ = make_solvers(scene_, bodies_.both(), factorisation_);
  stresses_ = std::make_unique<StressOutput>(scene_, bodies_.both(), layout_.grid,
                                             default_cell_size(scene_), options_.body_fields);
  result_.bodies = stresses_->bodies();
  compliance_ = std::make_unique<FemCompliance>(
      FemCompliance::Part{bodies_.wheel.get(), solvers_[0].get()},
      FemCompliance::Part{bodies_.rail.get(), solvers_[1].get()}, scene_.geometry.surface,
      layout_.grid, far_boundary_of(scene_));
  contact::ProgressEvent event;
  event.note = (solvers_[0] ? solvers_[0] : solvers_[1])->description();
  tell(event, "linear solvers", true);
  if (scene_.feels_inertia() && bodies_.wheel) spin_wheel();
  add_notes(scene_, geometry_, layout_, bodies_, event.note, result_.notes);
  // Processes that do not solve the contact problem need no stand-in.
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0) return;
  // The defect includes the coupling of unlike materials; the stand-in need not.
  half_ =
      std::make_unique<halfspace::HalfspaceCompliance>(layout_.grid, scene_.material.uncoupled());
  if (scene_.material.couples())
    coupled_half_ = std::make_unique<halfspace::HalfspaceCompliance>(layout_.grid, scene_.material);
}

void LevelElasticity::spin_wheel() {
  expansion_ = wheel_expansion(*bodies_.wheel, *solvers_[0], geometry_.geometry().surface,
                               layout_.grid, scene_.upwind_order);
  result_.notes.push_back(
      fmt::format("rolling at {:.4g} mm/s: inertia of wheel and rail; rotation expands the wheel "
                  "by {:.3g} mm, which raises the axle and is subtracted from the approach",
                  scene_.speed, -expansion_->distance.mean()));
}

void LevelElasticity::add_stresses(std::size_t k, PointResult& point) {
  point.error_estimate["approach"] = approach_left_out(scene_, point.normal_force, bodies_.reach);
  if (!stresses_->wanted(k)) return;
  const Stopwatch watch;
  tell({}, "stresses");
  stresses_->fill(k, point, compliance_->body_displacements(point.fields.traction),
                  expansion_ ? &expansion_->displacement : nullptr);
  tell({}, "stresses", true);
  result_.seconds["stresses"] += watch.seconds();
}

}  // namespace

std::unique_ptr<FemElasticity> make_fem_elasticity(
    const Scene& scene, const contact::ChartedGeometry& geometry, const RunLayout& layout,
    const LevelOptions& options, const contact::Progress& progress, FirstProcess& first,
    contact::ModelResult& result) {
  return std::make_unique<LevelElasticity>(scene, geometry, layout, options, progress, first,
                                           result);
}

}  // namespace rollfem::fem
