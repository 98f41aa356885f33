// SPDX-License-Identifier: LGPL-2.1-or-later
// Rows of cells that are thin at the surface, and meshes of them.
#include "fem/discretisation/elastic_problem.hpp"
#include "fem/mesh/body_mesh.hpp"
#include "fem/trace/far_field.hpp"

#include "support/fem_test_support.hpp"

namespace {

/// A first row as high as a fiftieth of a semi-axis on cells of an eighth, in mm; three levels.
fem::BodyOptions graded_options(double first, int at_once) {
  fem::BodyOptions options = small_options();
  options.cell_size = 0.25;
  options.fine_half_length = options.fine_half_width = 1.0;
  options.rows = fem::GradedDepth(first, options.cell_size, at_once);
  options.fine_depth = options.rows.reach() / options.cell_size;
  return options;
}

}  // namespace

TEST(GradedDepth, RowsGrowSteadilyFromTheFirstOneToTheCell) {
  for (const double first : {0.3, 0.16, 0.1, 0.03})
    for (const int at_once : {1, 2, 4, 8}) {
      const fem::GradedDepth rows(2.0 * first, 2.0, at_once);
      EXPECT_NEAR(rows.depth(2.0), 2.0 * first, 1e-9);
      double height = rows.depth(2.0);
      for (double even = 2.0; even < rows.reach() + 3.0; even += 2.0) {
        const double next = rows.depth(even + 2.0) - rows.depth(even);
        EXPECT_GE(next, height - 1e-12) << first << ' ' << at_once;
        EXPECT_LT(next, 1.75 * height) << first << ' ' << at_once;
        height = next;
        EXPECT_NEAR(rows.even(rows.depth(even + 0.7)), even + 0.7, 1e-12);
        constexpr double step = 1e-6;
        EXPECT_NEAR(rows.stretch(even + 0.7),
                    (rows.depth(even + 0.7 + step) - rows.depth(even + 0.7)) / step, 1e-5);
      }
      EXPECT_NEAR(height, 2.0, 1e-12);
    }
  EXPECT_TRUE(fem::GradedDepth(2.0, 2.0, 8).equal_rows());
}

// So cells of every size represent a linear displacement exactly.
TEST(GradedDepth, HangingNodesLieWhereTheLargerCellHasThem) {
  for (const auto& [first, at_once] : {std::pair{0.04, 8}, {0.02, 4}, {0.008, 2}}) {
    const fem::Body body(rail_shape(contact::infinity), {}, graded_options(first, at_once),
                         MPI_COMM_WORLD);
    EXPECT_EQ(1 << (body.triangulation().n_global_levels() - 1), at_once);
    const auto u = fem::nodal_values(body.problem(), [](const dealii::Point<3>& p) {
      return dealii::Tensor<1, 3>({p[2] + 0.5 * p[0], p[1] - p[2], 2.0 * p[2]});
    });
    auto hanging = u;
    fem::make_constraints(body.dofs(), body.mapping(), {}).distribute(hanging);
    hanging -= u;
    EXPECT_LT(hanging.linfty_norm(), 1e-12 * u.linfty_norm());
  }
}

TEST(GradedDepth, UnknownsAreCountedInThinRows) {
  for (const double first : {0.04, 0.01}) {
    const auto options = graded_options(first, 4);
    const fem::Body body(rail_shape(contact::infinity), {}, options, MPI_COMM_WORLD);
    EXPECT_NEAR(fem::predicted_unknowns(options, 1e9) / static_cast<double>(body.unknowns()), 1.0,
                0.15);
  }
}
