#include "halfspace/level.hpp"

#include "contact/errors.hpp"
#include "contact/geometry.hpp"
#include "halfspace/interpolation.hpp"
#include "halfspace/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace rollfem::halfspace {

using contact::Case;
using contact::ContactGrid;
using contact::Creepage;
using contact::ElementState;
using contact::Field;
using contact::PointResult;
using contact::TangentialField;
using contact::TangentialSolution;

namespace {

/// Elements kept free around the patch; second-order upwind looks two columns upstream.
constexpr int margin = 3;

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

bool touches_border(const ContactGrid& grid, const Field& pressure) {
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const bool border = i == 0 || j == 0 || i == grid.nx - 1 || j == grid.ny - 1;
      if (border && pressure[grid.index(i, j)] > 0.0) return true;
    }
  return false;
}

ContactGrid enlarged(const ContactGrid& grid) {
  return ContactGrid::centred(grid.nx + grid.nx / 2 + 2 * margin,
                              grid.ny + grid.ny / 2 + 2 * margin, grid.dx, grid.dy);
}

contact::NormalProblem normal_problem(const Case& input, const ContactGrid& grid) {
  return {contact::undeformed_distance(input, grid), input.load.normal_force, input.load.approach};
}

class Level {
 public:
  Level(const Case& input, const LevelResult* coarser, std::string stage_prefix,
        const contact::Progress& progress)
      : input_(input),
        coarser_(coarser),
        stage_prefix_(std::move(stage_prefix)),
        progress_(progress),
        material_(contact::combine(input.wheel.material, input.rail.material)) {}

  LevelResult run(ContactGrid grid) {
    constexpr int most_enlargements = 4;
    for (int attempt = 0;; ++attempt) {
      solve_normal_problem(grid);
      if (!touches_border(grid, result_.normal.pressure)) break;
      if (attempt == most_enlargements)
        throw contact::SolveError(
            fmt::format("model halfspace: the contact patch reaches the border of the potential "
                        "contact area even at {} by {} elements: the surfaces conform over more "
                        "than their curvatures tell",
                        grid.nx, grid.ny));
      grid = enlarged(grid);
    }
    const Stopwatch watch;
    for (std::size_t k = 0; k < input_.rolling.creepages.size(); ++k) solve_point(k);
    result_.tangential_seconds = watch.seconds();
    return std::move(result_);
  }

 private:
  void tell(contact::ProgressEvent event, const char* stage, bool finished) const {
    event.model = "halfspace";
    event.stage = stage_prefix_ + stage;
    event.finished = finished;
    contact::report(progress_, event);
  }

  void solve_normal_problem(const ContactGrid& grid) {
    const Stopwatch setup;
    tell({}, "influence coefficients", false);
    result_.grid = grid;
    compliance_ = std::make_unique<HalfspaceCompliance>(grid, material_);
    const contact::NormalOperator& normal = compliance_->normal();
    result_.setup_seconds += setup.seconds();
    const Stopwatch watch;
    tell({}, "normal", false);
    const Field start =
        coarser_ ? interpolated(coarser_->grid, coarser_->normal.pressure, grid) : Field();
    result_.normal = contact::solve_normal(normal, normal_problem(input_, grid), {}, start);
    displacement_n_ = normal.apply(result_.normal.pressure);
    contact::ProgressEvent event;
    event.iteration = result_.normal.iterations;
    event.residual = result_.normal.residual;
    event.contact_elements = result_.normal.contact_elements;
    tell(event, "normal", true);
    result_.normal_seconds += watch.seconds();
  }

  TangentialField start_for(std::size_t k, const Field& bound) const {
    if (!coarser_ || k >= coarser_->relative_traction.size()) return {};
    const TangentialField& relative = coarser_->relative_traction[k];
    const Field inside = (coarser_->normal.pressure.array() > 0.0).cast<double>();
    return {interpolated(coarser_->grid, relative.x, result_.grid, inside).cwiseProduct(bound),
            interpolated(coarser_->grid, relative.y, result_.grid, inside).cwiseProduct(bound)};
  }

  /// Without friction nothing adheres; slip is then the rigid slip and tractions vanish.
  TangentialSolution frictionless(const TangentialField& rigid_slip) const {
    TangentialSolution solution;
    const Field zero = Field::Zero(result_.grid.size());
    solution.traction = {zero, zero};
    solution.slip = rigid_slip;
    for (const double p : result_.normal.pressure)
      solution.state.push_back(p > 0.0 ? ElementState::slip : ElementState::exterior);
    return solution;
  }

  void solve_point(std::size_t k) {
    const Stopwatch watch;
    const Creepage& creepage = input_.rolling.creepages[k];
    contact::ProgressEvent event;
    event.point = static_cast<int>(k) + 1;
    event.points = static_cast<int>(input_.rolling.creepages.size());
    event.creepage = creepage.longitudinal;
    event.contact_elements = result_.normal.contact_elements;
    tell(event, "rolling", false);

    const Field bound = input_.friction_coefficient * result_.normal.pressure;
    const TangentialField rigid_slip = contact::rigid_slip(input_, creepage, result_.grid);
    const TangentialSolution tangential =
        input_.friction_coefficient == 0.0
            ? frictionless(rigid_slip)
            : contact::solve_tangential(compliance_->rolling(input_.rolling.upwind_order),
                                        {bound, rigid_slip}, {}, start_for(k, bound));
    PointResult point = point_result(creepage, bound, tangential);
    point.seconds = watch.seconds();

    const Field inverse_bound = bound.unaryExpr([](double g) { return g > 0.0 ? 1.0 / g : 0.0; });
    result_.relative_traction.push_back({tangential.traction.x.cwiseProduct(inverse_bound),
                                         tangential.traction.y.cwiseProduct(inverse_bound)});
    event.iteration = tangential.newton_steps;
    event.residual = tangential.residual;
    event.adhesion_elements = static_cast<int>(
        std::count(tangential.state.begin(), tangential.state.end(), ElementState::adhesion));
    event.note = fmt::format("{} Krylov iterations", tangential.krylov_iterations);
    tell(event, "rolling", true);
    result_.points.push_back(std::move(point));
  }

  PointResult point_result(const Creepage& creepage, const Field& bound,
                           const TangentialSolution& tangential) const {
    PointResult point;
    point.creepage = creepage;
    const TangentialField displacement = compliance_->shift().apply(tangential.traction);
    point.fields.traction = {tangential.traction.x, tangential.traction.y, result_.normal.pressure};
    point.fields.slip = tangential.slip;
    point.fields.traction_bound = bound;
    point.fields.gap = result_.normal.gap;
    point.fields.displacement = {displacement.x, displacement.y, displacement_n_};
    point.fields.state = tangential.state;
    contact::integrate_tractions(result_.grid, point);
    point.approach = result_.normal.approach;
    point.iterations = tangential.newton_steps;
    point.residual = std::max(tangential.residual, result_.normal.residual);
    point.converged = true;
    return point;
  }

  const Case& input_;
  const LevelResult* coarser_;
  std::string stage_prefix_;
  const contact::Progress& progress_;
  contact::CombinedMaterial material_;
  std::unique_ptr<HalfspaceCompliance> compliance_;
  Field displacement_n_;
  LevelResult result_;
};

}  // namespace

LevelResult solve_level(const Case& input, double dx, double dy, const LevelResult* coarser,
                        const std::string& stage_prefix, const contact::Progress& progress) {
  return Level(input, coarser, stage_prefix, progress).run(potential_area(input, dx, dy, margin));
}

}  // namespace rollfem::halfspace
