// SPDX-License-Identifier: LGPL-2.1-or-later
// A quarter of a thick ring between two planes that keep plane strain, axis z, for closed forms of
// axisymmetric displacement.
#pragma once

#include "fem/discretisation/elastic_problem.hpp"
#include "fem/linear/linear_solver.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/grid/tria.h>

#include "support/fem_fields.hpp"
#include "support/test.hpp"

namespace rollfem::testing {

struct RingOptions {
  double inner_radius = 10;  ///< mm
  double outer_radius = 20;  ///< mm
  unsigned int cells = 2;    ///< through the thickness, and twice as many along the quarter
  unsigned int degree = 2;
  double shear = 0;  ///< leans the cells: angle by which the middle of the thickness is turned
  contact::Material material = {};
  fem::MaterialMotion motion = {};
  std::optional<bool> project_dilatation = {};
};

class QuarterRing {
 public:
  enum Boundary : dealii::types::boundary_id { inner = 0, outer = 1, plane_x, plane_y, plane_z };

  explicit QuarterRing(const RingOptions& options)
      : options_(options),
        mapping_(options.degree),
        element_(dealii::FE_Q<3>(options.degree), 3),
        dofs_(mesh_) {
    make_mesh();
    boundary_.vanishing_component = {{plane_x, 0}, {plane_y, 1}, {plane_z, 2}};
    dofs_.distribute_dofs(element_);
    constraints_ = fem::make_constraints(dofs_, mapping_, boundary_);
  }

  fem::ElasticProblem problem() const {
    return {dofs_,
            mapping_,
            constraints_,
            boundary_,
            options_.material,
            options_.motion,
            options_.project_dilatation};
  }
  const dealii::DoFHandler<3>& dofs() const { return dofs_; }

  /// Pressure on the inner face.
  fem::Vector inner_pressure(double pressure) const {
    auto b = fem::make_vector(dofs_);
    dealii::FEFaceValues<3> values(
        mapping_, element_, dealii::QGauss<2>(options_.degree + 2),
        dealii::update_values | dealii::update_normal_vectors | dealii::update_JxW_values);
    std::vector<dealii::types::global_dof_index> indices(element_.dofs_per_cell);
    for (const auto& cell : dofs_.active_cell_iterators())
      for (const auto face : cell->face_indices()) {
        if (!cell->face(face)->at_boundary() || cell->face(face)->boundary_id() != inner) continue;
        values.reinit(cell, face);
        cell->get_dof_indices(indices);
        for (const auto q : values.quadrature_point_indices())
          for (unsigned int i = 0; i < indices.size(); ++i)
            b(indices[i]) -= pressure * values.normal_vector(q)[component(i)] *
                             values.shape_value(i, q) * values.JxW(q);
      }
    return b;
  }

  /// Calls f(radius, radial stress, hoop stress) at Gauss points, with the dilatation of `problem`.
  template <class F>
  void for_each_stress(const fem::ElasticProblem& problem, const fem::Vector& u,
                       unsigned int points, const F& f) const {
    fem::CellStress stress(problem);
    std::vector<dealii::Tensor<2, 3>> gradients;
    for_each_cell(problem, points, [&](const auto& cell, const auto& values) {
      stress.reinit(cell, u);
      gradients.resize(values.n_quadrature_points);
      values[dealii::FEValuesExtractors::Vector(0)].get_function_gradients(u, gradients);
      for (const auto q : values.quadrature_point_indices()) {
        const auto p = values.quadrature_point(q);
        const double r = std::hypot(p[0], p[1]), c = p[0] / r, s = p[1] / r;
        const auto sigma = stress.at(gradients[q], p);
        f(r, c * c * sigma[0] + s * s * sigma[1] + 2 * s * c * sigma[3],
          s * s * sigma[0] + c * c * sigma[1] - 2 * s * c * sigma[3]);
      }
    });
  }

  /// L2 error relative to the exact radial displacement u(r).
  double error(const fem::Vector& u, const std::function<double(double)>& exact) const {
    return displacement_error(problem(), u, [&](const dealii::Point<3>& p) {
      const double r = std::hypot(p[0], p[1]);
      return exact(r) / r * dealii::Tensor<1, 3>({p[0], p[1], 0.0});
    });
  }

 private:
  unsigned int component(unsigned int dof) const {
    return element_.system_to_component_index(dof).first;
  }

  void make_mesh() {
    const double a = options_.inner_radius, b = options_.outer_radius;
    const double thickness = (b - a) / options_.cells;
    dealii::GridGenerator::subdivided_hyper_rectangle(
        mesh_, {options_.cells, 2 * options_.cells, 1}, dealii::Point<3>(0, 0, 0),
        dealii::Point<3>(1, 1, thickness));
    for (const auto& cell : mesh_.active_cell_iterators())
      for (const auto& face : cell->face_iterators()) {
        if (!face->at_boundary()) continue;
        const auto p = face->center();
        face->set_boundary_id(p[0] < 1e-9       ? inner
                              : p[0] > 1 - 1e-9 ? outer
                              : p[1] < 1e-9     ? plane_y
                              : p[1] > 1 - 1e-9 ? plane_x
                                                : plane_z);
      }
    dealii::GridTools::transform(
        [&](const dealii::Point<3>& p) {
          const double lean = options_.shear * std::sin(dealii::numbers::PI * p[0]) *
                              std::sin(dealii::numbers::PI * p[1]);
          const double r = a + (b - a) * p[0], angle = 0.5 * dealii::numbers::PI * (p[1] + lean);
          return dealii::Point<3>(r * std::cos(angle), r * std::sin(angle), p[2]);
        },
        mesh_);
    mesh_.set_all_manifold_ids(0);
    mesh_.set_manifold(0, dealii::CylindricalManifold<3>(2));
  }

  RingOptions options_;
  dealii::Triangulation<3> mesh_;
  dealii::MappingQ<3> mapping_;
  dealii::FESystem<3> element_;
  dealii::DoFHandler<3> dofs_;
  fem::BoundaryConditions boundary_;
  dealii::AffineConstraints<double> constraints_;
};

}  // namespace rollfem::testing
