// SPDX-License-Identifier: LGPL-2.1-or-later
// Plastic flow far above the limits of shakedown: what hardens settles and does not lock, what
// cannot be in balance is refused.
#include "base/errors.hpp"

#include "support/fem_plane_strain.hpp"

namespace {

constexpr double heavy_shear_yield = 300.0, heavy_load = 8.0, heavy_friction = 0.5;

std::unique_ptr<RolledBody> deep_slab() {
  SlabOptions options;
  options.per_half_width = 6;
  options.ahead = options.behind = options.deep = 3;
  return rolled_slab(options);
}

/// Mean stress of the plastic displacement in the column of cells below the middle, MPa, at the
/// Gauss points from the surface down.
std::vector<double> mean_stress_below(const RolledBody& of, const fem::Vector& displacement) {
  const auto problem = of.problem();
  fem::CellStress law(problem);
  dealii::FEValues<3> values(problem.mapping, problem.dofs.get_fe(), dealii::QGauss<3>(2),
                             dealii::update_gradients | dealii::update_quadrature_points);
  std::vector<dealii::Tensor<2, 3>> gradients(values.n_quadrature_points);
  std::map<double, double> at_depth;
  for (const auto& cell : problem.dofs.active_cell_iterators()) {
    const auto centre = cell->center();
    if (centre[0] < 0.0 || centre[0] > 1.0 / 6 || centre[2] < -2.5) continue;
    values.reinit(cell);
    law.reinit(cell, displacement);
    values[dealii::FEValuesExtractors::Vector(0)].get_function_gradients(displacement, gradients);
    const auto stress = law.at(gradients[0], values.quadrature_point(0));
    const auto other = law.at(gradients[7], values.quadrature_point(7));
    at_depth[-values.quadrature_point(0)[2]] = (stress[0] + stress[1] + stress[2]) / 3.0;
    at_depth[-values.quadrature_point(7)[2]] = (other[0] + other[1] + other[2]) / 3.0;
  }
  std::vector<double> mean;
  for (const auto& [depth, value] : at_depth) mean.push_back(value);
  return mean;
}

// 8 k with a friction of 0.5: 0.36 of plastic strain in a pass, at which no elastic strain changes
// the volume noticeably. A mesh that locks has a pressure that alternates from point to point by
// more than the load.
TEST(HeavyPlasticFlow, OfSteelThatHardensSettlesAndDoesNotLock) {
  const auto slab = deep_slab();
  Passes passes(*slab, plain_steel(heavy_shear_yield, 1.5 * 210e3 / 20),
                heavy_load * heavy_shear_yield, heavy_friction);
  EXPECT_GT(passes.next(), 0.05);
  EXPECT_LE(passes.report.residual, 1e-6);
  EXPECT_LT(passes.report.iterations, 150);
  const auto mean = mean_stress_below(*slab, passes.state.displacement);
  ASSERT_GT(mean.size(), 20U);
  for (std::size_t k = 2; k + 2 < mean.size(); ++k)
    EXPECT_LT(std::abs(mean[k - 1] - 2.0 * mean[k] + mean[k + 1]),
              0.2 * heavy_load * heavy_shear_yield)
        << k;
}

// A traction of 4 k on steel that bears k has no balance: the pass ends with a message, and the
// body is as before.
TEST(HeavyPlasticFlow, OfPerfectlyPlasticSteelBeyondWhatItBearsIsRefused) {
  const auto slab = deep_slab();
  Passes passes(*slab, plain_steel(heavy_shear_yield), heavy_load * heavy_shear_yield,
                heavy_friction);
  passes.accuracy.most_iterations = 60;
  try {
    passes.next();
    FAIL() << "a pass in balance";
  } catch (const contact::SolveError& error) {
    EXPECT_NE(std::string(error.what()).find("did not settle"), std::string::npos) << error.what();
  }
  EXPECT_EQ(passes.state.displacement.l2_norm(), 0.0);
  for (const fem::PlasticState& state : passes.state.leaving) EXPECT_EQ(state.accumulated, 0.0);
}

}  // namespace
