// SPDX-License-Identifier: LGPL-2.1-or-later
// Balance of work of a rolling contact whose rail yields, by the whole model: what the rigid motion
// does goes into friction and plastic flow.
#include "base/threads.hpp"
#include "fem/elasticity/run_level.hpp"

#include "support/equal_balls.hpp"
#include <algorithm>
#include <cmath>

namespace {

using contact::Case;
using contact::PointResult;

constexpr double radius = 200.0;

/// A wheel on a rail of hardening steel, alike in shape, under Hertz's p0 = 1500 MPa, a = 2 mm.
Case rolling_case(double friction, double creepage) {
  Case input = equal_balls(radius, 1500.0, creepage);
  input.friction_coefficient = friction;
  if (friction == 0.0) input.rolling.problem = contact::Problem::frictionless;
  input.rail.plasticity.emplace();
  input.rail.plasticity->yield_stress = 420.0;
  input.rail.plasticity->back_stresses[0].modulus = 3e3;
  input.body_extent = 32.0;
  return input;
}

/// Elastic energy of residual stress per mm of the rail, N: -1/2 int s : eps_p over the section,
/// because it does no work on the total strain. Streamlines are those of 2 x 2 Gauss points of a
/// cell, which may be less high than wide.
double stored_energy(const contact::YieldedSection& rail, double cell) {
  double sum = 0.0;
  const auto width = static_cast<std::size_t>(rail.across);
  for (std::size_t k = 0; k < rail.y.size(); ++k) {
    const std::size_t upper = k / (2 * width) * 2 * width;  // of the row of cells
    const double height = std::sqrt(3.0) * (rail.depth[upper + width] - rail.depth[upper]);
    for (int c = 0; c < 6; ++c)
      sum -=
          0.5 * (c < 3 ? 1.0 : 2.0) * rail.stress[k][c] * rail.strain[k][c] * 0.25 * cell * height;
  }
  const bool half = *std::min_element(rail.y.begin(), rail.y.end()) > 0.0;
  return half ? 2.0 * sum : sum;
}

/// Of the first pass per mm of track, N: work of the rigid motion, and what it goes into.
struct Works {
  double rigid, friction, plastic, stored;
  /// Relative to the work of the rigid motion.
  double missing() const { return 1.0 - (friction + plastic + stored) / rigid; }
};

Works works(double friction, double creepage, double cell) {
  const contact::Threads one(1);
  const contact::ModelResult result =
      fem::run_level(rolling_case(friction, creepage), {cell, "", false}, {});
  const PointResult& point = result.points.front();
  const contact::ContactGrid& grid = result.grid;
  Works of{point.creepage_work.value_or(0.0), point.frictional_work.value_or(0.0),
           point.plastic_work.value(), stored_energy(point.yielded.front(), cell)};
  // The undeformed distance x^2/R shrinks by 2 x/R per mm at a place ahead of the middle: rolling
  // resistance, because the pressure moves forward.
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      of.rigid += point.fields.traction.n[grid.index(i, j)] * 2.0 * grid.x(i) / radius *
                  grid.element_area();
  return of;
}

}  // namespace

// 0.2 % are missing on cells of a/3.4 (0.8 % too much with clamped ends at 16 mm, not 32).
TEST(RollingWork, WithoutFrictionGoesIntoFlowAndResidualStress) {
  const Works of = works(0.0, 0.0, 0.6);
  EXPECT_GT(of.plastic, 30.0);
  EXPECT_GT(of.stored, 0.1 * of.plastic);
  EXPECT_LT(std::abs(of.missing()), 0.015);
}

// 1.5 % too much on cells of a/2.5, 0.4 % missing on a/3.4, 1.2 % too much on a/4.5: not yet of an
// order.
TEST(RollingWork, InFullSlidingIsSharedByFrictionAndFlow) {
  const Works of = works(0.2, 0.02, 0.6);
  EXPECT_GT(of.friction, 0.35 * of.rigid);
  EXPECT_GT(of.plastic, 0.35 * of.rigid);
  EXPECT_LT(std::abs(of.missing()), 0.015);
}

// 3.8 % too much on cells of a/2.5, 0.2 % on a/3.4.
TEST(RollingWork, InPartialSlipIsSharedByFrictionAndFlow) {
  const Works of = works(0.2, 1e-3, 0.6);
  EXPECT_LT(std::abs(of.missing()), 0.01);
}
