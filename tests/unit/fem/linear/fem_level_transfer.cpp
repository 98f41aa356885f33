// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacements between two levels of a block with hanging nodes: quadratic fields stay as they
// are, and forces go back by the transpose.
#include "fem/linear/level_transfer.hpp"

#include <deal.II/multigrid/mg_transfer_global_coarsening.h>

#include "support/fem_elastic_block.hpp"
#include "support/mpi_environment.hpp"

namespace {

using dealii::Point;
using fem::FloatVector;

class Levels : public ::testing::TestWithParam<unsigned int> {
 protected:
  Levels()
      : block(options(), boundary()),
        meshes(dealii::MGTransferGlobalCoarseningTools::create_geometric_coarsening_sequence(
            block.dofs().get_triangulation())),
        dofs(*meshes[meshes.size() - 2]) {
    dofs.distribute_dofs(block.dofs().get_fe());
    constraints = fem::make_constraints(dofs, block.problem().mapping, boundary());
    coarse.reinit(dofs.locally_owned_dofs(), MPI_COMM_WORLD);
    fine.reinit(block.dofs().locally_owned_dofs(), MPI_COMM_WORLD);
    transfer = fem::make_level_transfer(
        block.problem(), {dofs, block.problem().mapping, constraints, boundary(), {}});
  }
  static BlockOptions options() {
    BlockOptions result;
    result.degree = GetParam();
    result.local_refinements = 3;
    return result;
  }
  /// The plane x = 0 is one of symmetry.
  static fem::BoundaryConditions boundary() { return {{}, {{0, 0}}}; }
  /// Of the degree of the elements; u_x is 0 in the plane of symmetry.
  static double field(const Point<3>& p, unsigned int component) {
    const double square = GetParam() > 1 ? 1.0 : 0.0;
    const double value = 0.3 + p[1] - 2.0 * p[2] + square * (p[1] * p[2] + 0.5 * p[0] * p[0]);
    return component == 0 ? p[0] * (1.0 + square * p[2]) : (component == 1 ? value : p[0] - value);
  }
  void set(const dealii::DoFHandler<3>& handler, const dealii::AffineConstraints<double>& held,
           FloatVector& values) const {
    std::vector<dealii::types::global_dof_index> indices(handler.get_fe().dofs_per_cell);
    for (const auto& cell : handler.active_cell_iterators()) {
      if (!cell->is_locally_owned()) continue;
      cell->get_dof_indices(indices);
      for (unsigned int i = 0; i < indices.size(); ++i)
        if (values.in_local_range(indices[i]) && !held.is_constrained(indices[i]))
          values(indices[i]) =
              static_cast<float>(field(block.problem().mapping.transform_unit_to_real_cell(
                                           cell, handler.get_fe().unit_support_point(i)),
                                       handler.get_fe().system_to_component_index(i).first));
    }
  }

  Block block;
  std::vector<std::shared_ptr<const dealii::Triangulation<3>>> meshes;
  dealii::DoFHandler<3> dofs;
  dealii::AffineConstraints<double> constraints;
  FloatVector coarse, fine;
  std::unique_ptr<fem::LevelTransfer> transfer;
};

TEST_P(Levels, KeepFieldsOfTheElementsDegree) {
  ASSERT_GT(block.dofs().n_dofs(), dofs.n_dofs());
  set(dofs, constraints, coarse);
  transfer->prolongate_and_add(fine, coarse);
  FloatVector exact = fine;
  set(block.dofs(), block.problem().constraints, exact);
  const float scale = exact.linfty_norm();
  exact -= fine;
  EXPECT_LT(exact.linfty_norm(), 1e-6F * scale);
}

TEST_P(Levels, TakeForcesBackByTheTranspose) {
  for (const auto i : dofs.locally_owned_dofs())
    if (!constraints.is_constrained(i)) coarse(i) = std::sin(0.7F * static_cast<float>(i % 1000));
  for (const auto i : block.dofs().locally_owned_dofs())
    fine(i) = std::cos(0.3F * static_cast<float>(i % 1000));
  FloatVector prolongated = fine, restricted = coarse;
  prolongated = 0.0F;
  restricted = 0.0F;
  transfer->prolongate_and_add(prolongated, coarse);
  transfer->restrict_and_add(restricted, fine);
  const float exact = prolongated * fine;
  EXPECT_NEAR(restricted * coarse, exact, 1e-4F * prolongated.l2_norm() * fine.l2_norm());
  for (const auto i : dofs.locally_owned_dofs())
    if (constraints.is_constrained(i)) {
      EXPECT_EQ(restricted(i), 0.0F);
    }
}

INSTANTIATE_TEST_SUITE_P(Degrees, Levels, ::testing::Values(1u, 2u));

}  // namespace
