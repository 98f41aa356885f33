// SPDX-License-Identifier: LGPL-2.1-or-later
// Patch test: a linear displacement is in equilibrium on skew cells with hanging nodes, its strain
// energy is exact, and recovered stress is the constant one.
#include "fem/discretisation/elasticity_assembly.hpp"
#include "fem/stress/body_nodes.hpp"

#include <deal.II/dofs/dof_tools.h>

#include "support/fem_elastic_block.hpp"
#include "support/fem_fields.hpp"
#include "support/fem_test_support.hpp"

namespace {

const dealii::Tensor<2, 3> gradient({{1e-3, 4e-4, -2e-4},
                                     {-3e-4, 7e-4, 5e-4},
                                     {6e-4, 1e-4, -9e-4}});

TEST(PatchTest, LinearDisplacementIsInEquilibriumOnSkewCellsWithHangingNodes) {
  for (const unsigned int degree : {1U, 2U, 3U}) {
    BlockOptions options;
    options.bend = 0.2;
    options.degree = degree;
    options.local_refinements = 2;
    options.communicator = MPI_COMM_SELF;
    const Block block(options, {});  // held nowhere: only hanging nodes are constrained
    const auto problem = block.problem();
    ASSERT_GT(problem.constraints.n_constraints(), 0U);
    const auto unknowns = fem::number_free_unknowns(problem.dofs, problem.constraints);
    const auto matrix = fem::assemble(problem, {&unknowns}).front();
    const auto on_boundary = dealii::DoFTools::extract_boundary_dofs(
        problem.dofs, dealii::ComponentMask(), std::set<dealii::types::boundary_id>());
    std::vector<double> u(unknowns.count), force;
    std::vector<bool> inside(unknowns.count, false);
    block.for_each_dof([&](const dealii::Point<3>& p, unsigned int component, auto dof) {
      if (problem.constraints.is_constrained(dof)) return;
      const int free = unknowns.column[unknowns.row_start[dof]];
      u[free] = (gradient * p)[component];
      inside[free] = !on_boundary.is_element(dof);
    });
    matrix.multiply(u, force);
    double largest = 0, largest_inside = 0, energy = 0;
    int checked = 0;
    for (int i = 0; i < unknowns.count; ++i) {
      energy += u[i] * force[i];
      largest = std::max(largest, std::abs(force[i]));
      if (!inside[i]) continue;
      ++checked;
      largest_inside = std::max(largest_inside, std::abs(force[i]));
    }
    EXPECT_GT(checked, 50);
    EXPECT_LT(largest_inside, 1e-11 * largest);
    const double volume = options.size[0] * options.size[1] * options.size[2];
    const double density = dealii::scalar_product(stress_of(gradient, problem.material), gradient);
    EXPECT_NEAR(energy / (density * volume), 1.0, 1e-11);
  }
}

void expect_right_handed(const contact::BodyField& field) {
  for (const auto& cell : field.cells) {
    const auto edge = [&](int k) {
      dealii::Tensor<1, 3> e;
      for (int d = 0; d < 3; ++d) e[d] = field.points[cell[k]][d] - field.points[cell[0]][d];
      return e;
    };
    ASSERT_GT(dealii::cross_product_3d(edge(1), edge(3)) * edge(4), 0.0);
  }
}

TEST(BodyField, RecoversAConstantStressOnRightHandedCells) {
  const contact::Material material{210e3, 0.3};
  for (const auto& shape : {wheel_shape(100, -60), rail_shape(contact::infinity)}) {
    const fem::Body body(shape, material, small_options(), MPI_COMM_SELF);
    const auto& element = body.dofs().get_fe();
    auto u = fem::make_vector(body.dofs());
    dealii::FEValues<3> nodes(body.mapping(), element,
                              dealii::Quadrature<3>(element.get_unit_support_points()),
                              dealii::update_quadrature_points);
    std::vector<dealii::types::global_dof_index> indices(element.dofs_per_cell);
    for (const auto& cell : body.dofs().active_cell_iterators()) {
      nodes.reinit(cell);
      cell->get_dof_indices(indices);
      for (unsigned int i = 0; i < indices.size(); ++i)
        u(indices[i]) =
            (gradient * nodes.quadrature_point(i))[element.system_to_component_index(i).first];
    }
    u.update_ghost_values();
    const fem::BodyNodes body_nodes(body, "body");
    const contact::BodyField& field = body_nodes.mesh();
    const fem::StressRecovery recovery(body);
    const fem::NodalStress stress = recovery.recover(u);
    ASSERT_EQ(field.points.size(), body.unknowns() / 3);
    ASSERT_EQ(field.cells.size(), 8 * body.dofs().get_triangulation().n_active_cells());
    const auto exact = components_of(stress_of(gradient, material));
    recovery.for_each_node(stress, [&](const auto&, const auto& at_node, double) {
      for (int k = 0; k < 6; ++k) ASSERT_NEAR(at_node[k], exact[k], 1e-8);
    });
    for (const auto& at_point : body_nodes.values(u, stress).stress)
      for (int k = 0; k < 6; ++k)
        ASSERT_NEAR(at_point[k], exact[k],
                    1e-8 + 1e-7 * std::abs(exact[k]));  // in single precision
    expect_right_handed(field);
  }
}

TEST(BodyField, HalfBodyIsMirrored) {
  auto options = small_options();
  options.half = true;
  const fem::Body body(rail_shape(20), {}, options, MPI_COMM_SELF);
  auto u = fem::make_vector(body.dofs());
  for (unsigned int i = 0; i < u.locally_owned_size(); ++i) u.local_element(i) = 1e-3;
  u.update_ghost_values();
  const fem::BodyNodes body_nodes(body, "rail");
  const contact::BodyField& field = body_nodes.mesh();
  const auto displacement = body_nodes.values(u, fem::StressRecovery(body).recover(u)).displacement;
  EXPECT_EQ(field.cells.size(), 16 * body.dofs().get_triangulation().n_active_cells());
  double lowest = 0, highest = 0;
  for (std::size_t p = 0; p < field.points.size(); ++p) {
    lowest = std::min(lowest, field.points[p][1]);
    highest = std::max(highest, field.points[p][1]);
    if (field.points[p][1] < -1e-9) {
      EXPECT_EQ(displacement[p][1], -1e-3F);
    }
  }
  EXPECT_NEAR(lowest, -16.0, 1e-9);
  EXPECT_NEAR(highest, 16.0, 1e-9);
  expect_right_handed(field);
}

}  // namespace
