// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/elasticity/fem_elasticity.hpp"

#include "contact/base/progress.hpp"
#include "fem/discretisation/case_bodies.hpp"
#include "fem/linear/factorisation.hpp"
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

#include <optional>

namespace rollfem::fem {

namespace {

using contact::PatchSize;
using contact::PointResult;
using contact::Scene;
using contact::Stopwatch;

/// Finite elements and the layer between them.
class LayeredCompliance : public contact::Compliance {
 public:
  LayeredCompliance(const FemCompliance& bodies, double layer) : bodies_(bodies), layer_(layer) {}
  const contact::ContactGrid& grid() const override { return bodies_.grid(); }
  contact::SurfaceField apply(const contact::SurfaceField& traction) const override {
    return respond(traction).displacement;
  }
  contact::Response respond(const contact::SurfaceField& traction) const override {
    contact::Response response = bodies_.respond(traction);
    contact::SurfaceField& u = response.displacement;
    if (layer_ == 0.0 || u.x.size() != traction.x.size()) return response;  // another process
    u.x += layer_ * traction.x;
    u.y += layer_ * traction.y;
    return response;
  }

 private:
  const FemCompliance& bodies_;
  double layer_;
};

class FemElasticity : public contact::Elasticity {
 public:
  FemElasticity(const Scene& scene, const contact::ChartedGeometry& geometry,
                const RunLayout& layout, const LevelOptions& options,
                const contact::Progress& progress, LevelStart& start, contact::ModelResult& result);

  void prepare() override;
  const contact::Compliance& compliance() const override { return *layered_; }
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
  void complete(std::size_t k, PointResult& point) override;

 private:
  void tell(contact::ProgressEvent event, const std::string& stage, bool finished = false) const;
  void make_meshes();
  void make_compliance();
  void spin_wheel();

  const Scene& scene_;
  const contact::ChartedGeometry& geometry_;
  const RunLayout& layout_;
  const LevelOptions& options_;
  const contact::Progress& progress_;
  LevelStart& start_;
  contact::ModelResult& result_;
  CaseBodies bodies_;
  bool factorisation_ = false;
  Solvers solvers_;
  std::unique_ptr<StressOutput> stresses_;
  std::unique_ptr<FemCompliance> compliance_;
  std::optional<LayeredCompliance> layered_;
  std::unique_ptr<halfspace::HalfspaceCompliance> half_;
  std::unique_ptr<halfspace::HalfspaceCompliance> coupled_half_;  ///< null: like materials
  std::optional<WheelExpansion> expansion_;                       ///< of a fast rotating wheel
};

FemElasticity::FemElasticity(const Scene& scene, const contact::ChartedGeometry& geometry,
                             const RunLayout& layout, const LevelOptions& options,
                             const contact::Progress& progress, LevelStart& start,
                             contact::ModelResult& result)
    : scene_(scene),
      geometry_(geometry),
      layout_(layout),
      options_(options),
      progress_(progress),
      start_(start),
      result_(result) {}

void FemElasticity::prepare() {
  const Stopwatch mesh_watch;
  make_meshes();
  result_.seconds["mesh"] = mesh_watch.seconds();
  const Stopwatch solver_watch;
  make_compliance();
  result_.seconds["factorisation"] = solver_watch.seconds();
}

void FemElasticity::tell(contact::ProgressEvent event, const std::string& stage,
                         bool finished) const {
  event.model = "fem";
  event.stage = options_.stage_prefix + stage;
  event.points = static_cast<int>(scene_.points.size());
  event.finished = finished;
  contact::report(progress_, event);
}

void FemElasticity::make_meshes() {
  tell({}, "mesh");
  bodies_ = make_bodies(scene_, layout_.bodies, MPI_COMM_WORLD);
  start_.reach = bodies_.reach;
  start_.notes = fmt::format("{}", fmt::join(bodies_.notes, "\n"));
  std::array<long, 2> unknowns{};
  bool algebraic = false;
  double coarse_factors = 0.0;
  start_.half = true;
  for (std::size_t k = 0; k < 2; ++k) {
    const Body* body = bodies_.both()[k];
    if (body == nullptr) continue;
    unknowns[k] = static_cast<long>(body->unknowns());
    start_.half = start_.half && body->options().half;
    algebraic = algebraic || takes_algebraic(scene_, *body);
    const bool given = k == 0 ? !scene_.wheel.mesh.empty() : !scene_.rail.mesh.empty();
    if (given || has_true_sections(scene_))
      coarse_factors += predicted_factor_bytes(coarse_unknowns(*body));
  }
  start_.unknowns = unknowns[0] + unknowns[1];
  MemoryDemand demand =
      memory_demand(static_cast<double>(unknowns[0]), static_cast<double>(unknowns[1]),
                    layout_.bodies, options_.body_fields ? points_that_keep_bodies(scene_) : 0);
  demand.algebraic = algebraic;
  demand.coarse_factors = coarse_factors;
  demand.factorisation = factorisation_ = takes_factorisation(scene_, demand);
  contact::ProgressEvent event;
  event.note = fmt::format("wheel {} + rail {} unknowns, {}", unknowns[0], unknowns[1],
                           memory_note(demand, MPI_COMM_WORLD));
  tell(event, "mesh", true);
  refuse_beyond_memory(demand, layout_.bodies.cell_size, MPI_COMM_WORLD);
}

void FemElasticity::make_compliance() {
  tell({}, "linear solvers");
  solvers_ = make_solvers(scene_, bodies_.both(), factorisation_);
  stresses_ = std::make_unique<StressOutput>(scene_, bodies_.both(), layout_.grid,
                                             default_cell_size(scene_), options_.body_fields);
  start_.bodies = stresses_->bodies();
  compliance_ = std::make_unique<FemCompliance>(
      FemCompliance::Part{bodies_.wheel.get(), solvers_.wheel.get()},
      FemCompliance::Part{bodies_.rail.get(), solvers_.rail.get()}, scene_.geometry.surface,
      layout_.grid, far_boundary_of(scene_));
  layered_.emplace(*compliance_, scene_.material.layer);
  start_.solver = (solvers_.wheel ? solvers_.wheel : solvers_.rail)->description();
  contact::ProgressEvent event;
  event.note = start_.solver;
  tell(event, "linear solvers", true);
  if (scene_.feels_inertia() && bodies_.wheel) spin_wheel();
  // Processes that do not solve the contact problem need no stand-in.
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0) return;
  // The defect includes the coupling of unlike materials; the stand-in need not.
  half_ =
      std::make_unique<halfspace::HalfspaceCompliance>(layout_.grid, scene_.material.uncoupled());
  if (scene_.material.couples())
    coupled_half_ = std::make_unique<halfspace::HalfspaceCompliance>(layout_.grid, scene_.material);
}

void FemElasticity::spin_wheel() {
  expansion_ = wheel_expansion(*bodies_.wheel, *solvers_.wheel, geometry_.geometry().surface,
                               layout_.grid, scene_.upwind_order);
  result_.notes.push_back(
      fmt::format("rolling at {:.4g} mm/s: inertia of wheel and rail; rotation expands the wheel "
                  "by {:.3g} mm, which raises the axle and is subtracted from the approach",
                  scene_.speed, -expansion_->distance.mean()));
}

void FemElasticity::complete(std::size_t k, PointResult& point) {
  point.error_estimate["approach"] = approach_left_out(scene_, point.normal_force, start_.reach);
  if (!stresses_->wanted(k)) return;
  const Stopwatch watch;
  tell({}, "stresses");
  stresses_->fill(k, point, compliance_->body_displacements(point.fields.traction),
                  expansion_ ? &expansion_->displacement : nullptr);
  tell({}, "stresses", true);
  result_.seconds["stresses"] += watch.seconds();
}

}  // namespace

std::unique_ptr<contact::Elasticity> make_fem_elasticity(
    const Scene& scene, const contact::ChartedGeometry& geometry, const RunLayout& layout,
    const LevelOptions& options, const contact::Progress& progress, LevelStart& start,
    contact::ModelResult& result) {
  return std::make_unique<FemElasticity>(scene, geometry, layout, options, progress, start, result);
}

}  // namespace rollfem::fem
