// SPDX-License-Identifier: LGPL-2.1-or-later
// Persson's conformal contact, benchmark 10: a disc in the hole of a large plate, plane strain
// between two planes. Own meshes of both bodies go through the library's elasticity, factorisation
// and normal contact solver; the book judges angle and pressure.
#include "contact/iteration/normal.hpp"
#include "fem/linear/factorisation.hpp"
#include "result/patch_size.hpp"

#include <Eigen/Cholesky>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include "support/mpi_environment.hpp"
#include "support/persson.hpp"
#include "support/recorded.hpp"

namespace {

constexpr double degree = M_PI / 180;
constexpr double radius = 50.0;    // mm, of disc and hole: their difference is a gap, not a shape
constexpr double thickness = 2.0;  // mm, between the two planes
constexpr double core = 0.02;      // radius held inside the disc, of `radius`
constexpr double plate = 40.0;     // radius at which the plate is held, of `radius`
constexpr double line_load = 1e3;  // N/mm
const contact::Material steel{210e3, 0.3};

enum Boundary : dealii::types::boundary_id { held = 0, touching = 1, middle_plane = 2, planes = 3 };

/// Steps of ln r away from the contact: squares there, then growing.
std::vector<double> radial_steps(double first, double whole) {
  std::vector<double> steps{first, first};
  double sum = 2 * first;
  for (double step = 1.3 * first; sum < whole; step *= 1.3) {
    steps.push_back(step);
    sum += step;
  }
  for (double& step : steps) step *= whole / sum;
  return steps;
}

/// Half a ring (y >= 0) about the x axis that touches at its outer radius (the disc) or its inner
/// one (the plate), theta = 0 at the lowest point; one cell between the planes x = 0 and thickness.
class Ring {
 public:
  Ring(bool is_disc, int angular_cells)
      : sign_(is_disc ? -1.0 : 1.0), mesh_(MPI_COMM_SELF), mapping_(2), dofs_(mesh_) {
    const double whole = std::log(is_disc ? 1 / core : plate);
    auto radial = radial_steps(M_PI / angular_cells, whole);
    if (is_disc) std::reverse(radial.begin(), radial.end());
    const std::vector<std::vector<double>> steps{
        {thickness}, radial, std::vector<double>(angular_cells, M_PI / angular_cells)};
    const double lower = is_disc ? -whole : 0.0;
    dealii::GridGenerator::subdivided_hyper_rectangle(
        mesh_, steps, dealii::Point<3>(0, lower, 0),
        dealii::Point<3>(thickness, lower + whole, M_PI));
    mark(lower, lower + whole, is_disc);
    dealii::GridTools::transform(
        [](const dealii::Point<3>& p) {
          const double r = radius * std::exp(p[1]);
          return dealii::Point<3>(p[0], r * std::sin(p[2]), -r * std::cos(p[2]));
        },
        mesh_);
    mesh_.set_all_manifold_ids(0);
    mesh_.set_manifold(0, dealii::CylindricalManifold<3>(0));
    dofs_.distribute_dofs(dealii::FESystem<3>(dealii::FE_Q<3>(2), 3));
    boundary_ = {{held}, {{middle_plane, 1}, {planes, 0}}};
    constraints_ = fem::make_constraints(dofs_, mapping_, boundary_);
  }

  /// Mean radial displacement of every element (outwards positive times the sign with which it
  /// opens the gap) under unit pressure on each of the `count` elements from theta = 0.
  Eigen::MatrixXd compliance(int count, int angular_cells) const {
    const auto loads = unit_loads(count, angular_cells);
    const auto solver = fem::make_factorisation({dofs_, mapping_, constraints_, boundary_, steel});
    const double area = thickness * radius * M_PI / angular_cells;
    Eigen::MatrixXd result(count, count);
    auto u = fem::make_vector(dofs_);
    for (int k = 0; k < count; ++k) {
      solver->solve(u, loads[k]);
      for (int e = 0; e < count; ++e) result(e, k) = (loads[e] * u) / area;
    }
    return result;
  }

 private:
  void mark(double lower, double upper, bool is_disc) {
    for (const auto& cell : mesh_.active_cell_iterators())
      for (const auto& face : cell->face_iterators()) {
        if (!face->at_boundary()) continue;
        const auto p = face->center();
        if (std::abs(p[0]) < 1e-9 || std::abs(p[0] - thickness) < 1e-9)
          face->set_boundary_id(planes);
        else if (std::abs(p[1] - lower) < 1e-9)
          face->set_boundary_id(is_disc ? held : touching);
        else if (std::abs(p[1] - upper) < 1e-9)
          face->set_boundary_id(is_disc ? touching : held);
        else
          face->set_boundary_id(middle_plane);
      }
  }

  /// Each load is int e_r . N over one element, the column of B^T and the row of B alike.
  std::vector<fem::Vector> unit_loads(int count, int angular_cells) const {
    std::vector<fem::Vector> loads(count, fem::make_vector(dofs_));
    const auto& element = dofs_.get_fe();
    dealii::FEFaceValues<3> values(
        mapping_, element, dealii::QGauss<2>(4),
        dealii::update_values | dealii::update_quadrature_points | dealii::update_JxW_values);
    std::vector<dealii::types::global_dof_index> indices(element.dofs_per_cell);
    for (const auto& cell : dofs_.active_cell_iterators())
      for (const auto face : cell->face_indices()) {
        if (!cell->face(face)->at_boundary() || cell->face(face)->boundary_id() != touching)
          continue;
        const auto middle = cell->face(face)->center();
        const double theta = std::atan2(middle[1], -middle[2]);
        const int k = static_cast<int>(theta / (M_PI / angular_cells));
        if (k >= count) continue;
        values.reinit(cell, face);
        cell->get_dof_indices(indices);
        for (const auto q : values.quadrature_point_indices()) {
          const auto p = values.quadrature_point(q);
          const double r = std::hypot(p[1], p[2]);
          const dealii::Tensor<1, 3> outwards({0, sign_ * p[1] / r, sign_ * p[2] / r});
          for (unsigned int i = 0; i < indices.size(); ++i)
            loads[k](indices[i]) += outwards[element.system_to_component_index(i).first] *
                                    values.shape_value(i, q) * values.JxW(q);
        }
      }
    return loads;
  }

  double sign_;  ///< pressure pushes the disc inwards, the plate outwards
  dealii::parallel::distributed::Triangulation<3> mesh_;
  dealii::MappingQ<3> mapping_;
  dealii::DoFHandler<3> dofs_;
  fem::BoundaryConditions boundary_;
  dealii::AffineConstraints<double> constraints_;
};

/// Dense compliance of the vertical parts: P = p cos(theta) and gap / cos(theta), so that the
/// approach is the same for every element and the sum of P is the vertical force.
class DenseNormal : public contact::NormalOperator {
 public:
  DenseNormal(const contact::ContactGrid& grid, const Eigen::MatrixXd& matrix)
      : grid_(grid), matrix_(matrix), inverse_(matrix) {}
  const contact::ContactGrid& grid() const override { return grid_; }
  void apply(const contact::Field& pressure, contact::Field& displacement) const override {
    displacement = matrix_ * pressure;
  }
  void precondition(const contact::Field& residual, contact::Field& result) const override {
    result = inverse_.solve(residual);
  }

 private:
  contact::ContactGrid grid_;
  Eigen::MatrixXd matrix_;
  Eigen::LDLT<Eigen::MatrixXd> inverse_;
};

struct Reached {
  double half_angle;  ///< rad
  double pressure;    ///< p(0) R / Q
};

Reached solve_persson(double half_angle, long elements) {
  const int angular = static_cast<int>(std::lround(M_PI / half_angle * elements));
  const int count = static_cast<int>(std::min(1.4 * elements, 0.47 * angular));
  const double step = M_PI / angular;
  Eigen::MatrixXd a = Ring(true, angular).compliance(count, angular) +
                      Ring(false, angular).compliance(count, angular);
  EXPECT_LT((a - a.transpose()).cwiseAbs().maxCoeff(), 1e-10 * a.cwiseAbs().maxCoeff());
  a = 0.5 * (a + a.transpose()).eval();
  Eigen::VectorXd cosine(count);
  for (int k = 0; k < count; ++k) cosine[k] = std::cos((k + 0.5) * step);
  const Eigen::MatrixXd vertical =
      cosine.cwiseInverse().asDiagonal() * a * cosine.cwiseInverse().asDiagonal();

  const double clearance = PerssonContact{half_angle}.clearance_number() * line_load *
                           (1 - steel.poisson_ratio * steel.poisson_ratio) / steel.young_modulus;
  const DenseNormal compliance({1, count, thickness, radius * step, 0.0, 0.5 * radius * step},
                               vertical);
  const auto solution = contact::solve_normal(
      compliance, {clearance * cosine.cwiseInverse(), 0.5 * line_load * thickness, {}});
  const Eigen::VectorXd p = solution.pressure.cwiseQuotient(cosine);

  Eigen::VectorXd whole(2 * count);
  whole << p.reverse(), p;
  const auto grid = contact::ContactGrid::centred(2 * count, 1, step, 1.0);
  return {0.5 * contact::patch_size(grid, whole).length,
          (9 * p[0] - p[1]) / 8 * radius / line_load};
}

}  // namespace

TEST(PerssonPin, TouchesOverTheAngleAndWithThePressureOfTheClosedForm) {
  for (const double angle : {20.0, 40.0, 60.0}) {
    const Reached coarse = solve_persson(angle * degree, std::lround(angle / 3));
    const Reached fine = solve_persson(angle * degree, std::lround(angle / 1.5));
    const std::string at = std::to_string(std::lround(angle));
    record("pressure_at_" + at, fine.pressure);
    record("half_angle_at_" + at, fine.half_angle / degree);
    record("coarse_half_angle_at_" + at, coarse.half_angle / degree);
  }
}
