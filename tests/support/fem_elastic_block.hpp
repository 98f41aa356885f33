// SPDX-License-Identifier: LGPL-2.1-or-later
// A block of elastic material on an octree mesh with hanging nodes, for tests of the linear
// solvers.
#pragma once

#include "fem/linear/linear_solver.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include "support/test.hpp"

namespace rollfem::testing {

struct BlockOptions {
  std::array<unsigned int, 3> cells{3, 2, 2};  ///< coarse ones
  std::array<double, 3> size{3, 2, 2};         ///< mm
  int global_refinements = 1;
  int local_refinements = 2;  ///< towards the middle of the upper face
  unsigned int degree = 2;
  double bend = 0;  ///< makes cells skew: the coarse vertices move by a smooth field of this size
  MPI_Comm communicator = MPI_COMM_WORLD;
  contact::Material material = {};
  fem::MaterialMotion motion = {};
  std::optional<bool> project_dilatation = {};
};

/// Boundary ids as deal.II colours them: 2 d for the lower, 2 d + 1 for the upper face of
/// direction d.
class Block {
 public:
  using Load = std::function<dealii::Tensor<1, 3>(const dealii::Point<3>&)>;

  Block(const BlockOptions& options, const fem::BoundaryConditions& boundary)
      : mesh_(options.communicator),
        mapping_(options.degree),
        element_(dealii::FE_Q<3>(options.degree), 3),
        dofs_(mesh_),
        boundary_(boundary),
        options_(options) {
    const dealii::Point<3> upper(options.size[0], options.size[1], options.size[2]);
    dealii::GridGenerator::subdivided_hyper_rectangle(
        mesh_, {options.cells[0], options.cells[1], options.cells[2]}, dealii::Point<3>(), upper,
        true);
    if (options.bend != 0) bend(options);
    mesh_.refine_global(options.global_refinements);
    const dealii::Point<3> middle(upper[0] / 2, upper[1] / 2, upper[2]);
    for (int step = 0; step < options.local_refinements; ++step) {
      for (const auto& cell : mesh_.active_cell_iterators())
        if (cell->is_locally_owned() &&
            cell->center().distance(middle) < 0.75 * upper.norm() / std::exp2(step + 2))
          cell->set_refine_flag();
      mesh_.execute_coarsening_and_refinement();
    }
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

  /// int f . v over the body, or over the faces of one boundary id; constraints ignored.
  fem::Vector body_load(const Load& f) const { return assemble(f, -1); }
  fem::Vector face_load(int boundary_id, const Load& f) const { return assemble(f, boundary_id); }

  /// Calls f(place, component, global dof) for every dof of the cells of this process.
  void for_each_dof(const std::function<void(const dealii::Point<3>&, unsigned int,
                                             dealii::types::global_dof_index)>& f) const {
    std::vector<dealii::types::global_dof_index> indices(element_.dofs_per_cell);
    for (const auto& cell : dofs_.active_cell_iterators()) {
      if (!cell->is_locally_owned()) continue;
      cell->get_dof_indices(indices);
      for (unsigned int i = 0; i < indices.size(); ++i)
        f(mapping_.transform_unit_to_real_cell(cell, element_.unit_support_point(i)),
          element_.system_to_component_index(i).first, indices[i]);
    }
  }

  /// Displacement by place and component, for comparing different numberings.
  std::map<std::array<long, 4>, double> by_place(const fem::Vector& u) const {
    std::map<std::array<long, 4>, double> values;
    for_each_dof([&](const dealii::Point<3>& p, unsigned int component, auto dof) {
      values[{std::lround(p[0] * 1e6), std::lround(p[1] * 1e6), std::lround(p[2] * 1e6),
              static_cast<long>(component)}] = u(dof);
    });
    return values;
  }

 private:
  /// Interior vertices move, boundary planes stay planes.
  void bend(const BlockOptions& options) {
    const auto& size = options.size;
    dealii::GridTools::transform(
        [&](const dealii::Point<3>& p) {
          double bump = options.bend;
          for (unsigned int d = 0; d < 3; ++d)
            bump *= std::sin(dealii::numbers::PI * p[d] / size[d]);
          return p + bump * dealii::Point<3>(1, -0.7, 0.5);
        },
        mesh_);
  }

  fem::Vector assemble(const Load& f, int boundary_id) const {
    auto b = fem::make_vector(dofs_);
    const unsigned int points = element_.degree + 2;
    const auto flags =
        dealii::update_values | dealii::update_quadrature_points | dealii::update_JxW_values;
    dealii::FEValues<3> in_cell(mapping_, element_, dealii::QGauss<3>(points), flags);
    dealii::FEFaceValues<3> on_face(mapping_, element_, dealii::QGauss<2>(points), flags);
    std::vector<dealii::types::global_dof_index> indices(element_.dofs_per_cell);
    const auto add = [&](const auto& values) {
      for (const auto q : values.quadrature_point_indices()) {
        const auto density = f(values.quadrature_point(q));
        for (unsigned int i = 0; i < indices.size(); ++i) {
          const auto component = element_.system_to_component_index(i).first;
          b(indices[i]) += density[component] * values.shape_value(i, q) * values.JxW(q);
        }
      }
    };
    for (const auto& cell : dofs_.active_cell_iterators()) {
      if (!cell->is_locally_owned()) continue;
      cell->get_dof_indices(indices);
      if (boundary_id < 0) {
        in_cell.reinit(cell);
        add(in_cell);
        continue;
      }
      for (const auto face : cell->face_indices())
        if (cell->face(face)->at_boundary() &&
            static_cast<int>(cell->face(face)->boundary_id()) == boundary_id) {
          on_face.reinit(cell, face);
          add(on_face);
        }
    }
    b.compress(dealii::VectorOperation::add);
    return b;
  }

  dealii::parallel::distributed::Triangulation<3> mesh_;
  dealii::MappingQ<3> mapping_;
  dealii::FESystem<3> element_;
  dealii::DoFHandler<3> dofs_;
  fem::BoundaryConditions boundary_;
  BlockOptions options_;
  dealii::AffineConstraints<double> constraints_;
};

/// Lower face clamped, symmetry plane y = 0.
inline fem::BoundaryConditions clamped_below() {
  return {{4}, {{2, 1}}};
}

}  // namespace rollfem::testing
