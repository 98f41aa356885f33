// SPDX-License-Identifier: LGPL-2.1-or-later
// Balances of a pass over steel that yields: residual stress against equilibrium, work of the load
// against plastic work, wheel against rail.
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include "support/fem_plane_strain.hpp"

namespace {

constexpr double shear_yield = 300.0;

/// Calls f(point, stress) with the whole residual stress, MPa, by the elements' own law with the
/// plastic strain subtracted, at the material points: the Gauss points of fine cells.
template <class F>
void for_each_residual_stress(const Passes& passes, const F& f) {
  const RolledBody& of = passes.of;
  const fem::Streamlines& lines = of.lines;
  std::map<std::array<long, 2>, std::size_t> point_at;  // along and down, in thousandths of a mm
  const auto key = [](double s, double depth) {
    return std::array<long, 2>{std::lround(1e3 * s), std::lround(1e3 * depth)};
  };
  for (std::size_t k = 0; k < lines.points(); ++k)
    point_at[key(lines.s(k % lines.stations()), lines.section(k / lines.stations())[1])] = k;
  const auto problem = of.problem();
  fem::CellStress law(problem);
  dealii::FEValues<3> values(problem.mapping, problem.dofs.get_fe(), dealii::QGauss<3>(2),
                             dealii::update_gradients | dealii::update_quadrature_points);
  std::vector<dealii::Tensor<2, 3>> gradients(values.n_quadrature_points);
  for (const auto& cell : problem.dofs.active_cell_iterators()) {
    values.reinit(cell);
    law.reinit(cell, passes.state.displacement);
    values[dealii::FEValuesExtractors::Vector(0)].get_function_gradients(passes.state.displacement,
                                                                         gradients);
    for (const unsigned int q : values.quadrature_point_indices()) {
      const auto& place = values.quadrature_point(q);
      const auto found = point_at.find(key(place[0], std::abs(place[2])));
      if (found == point_at.end()) continue;
      auto stress = law.at(gradients[q], place);
      for (int c = 0; c < 6; ++c)
        stress[c] -= 2.0 * passes.law.shear_modulus() * passes.state.plastic[found->second][c];
      f(found->second, stress);
    }
  }
}

/// Work of the load per mm of track, N, and the plastic work of the last pass. In the steady state
/// the load moves over the displacement -du/ds; its elastic part returns what it takes.
std::array<double, 2> works(const Passes& passes) {
  const RolledBody& of = passes.of;
  const auto u = of.coupling.sample(passes.state.displacement);
  const double h = 1.0 / std::lround(1.0 / (of.lines.s(0) - of.lines.s(2)));
  const int nx = static_cast<int>(u.n.size()) / 2;
  double work = 0.0;
  for (int i = 1; i + 1 < nx; ++i) {
    const int e = nx + i;  // the row at y > 0, which is the body's
    const double normal = of.pressed.traction.n[e], along = of.sheared.traction.x[e];
    work -=
        passes.load_factor * h *
        (normal * (u.n[e + 1] - u.n[e - 1]) + passes.friction * along * (u.x[e + 1] - u.x[e - 1])) /
        2.0;
  }
  return {work, passes.report.plastic_work};
}

}  // namespace

// Behind the load nothing changes along the slab any more: equilibrium with the free surface leaves
// no stress zz and xz at any depth.
TEST(PlasticPassBalance, ResidualStressLeavesTheSurfaceAndEveryDepthFree) {
  const RolledBody& slab = slab_of(6, 20.0);
  Passes passes(slab, plain_steel(shear_yield), 3.9 * shear_yield);
  passes.next(2);
  double free = 0.0, along = 0.0;
  std::size_t points = 0;
  for_each_residual_stress(passes, [&](std::size_t k, const std::array<double, 6>& stress) {
    if (std::abs(slab.lines.s(k % slab.lines.stations()) + 1.5) > 0.3) return;
    ++points;
    free = std::max({free, std::abs(stress[2]), std::abs(stress[5]), std::abs(stress[3])});
    along = std::max(along, std::abs(stress[0]));
  });
  EXPECT_GT(points, 100u);
  // 2.2e-3 with clamped ends at 20 half-widths, 2.5e-4 at 40
  EXPECT_LT(free, 4e-3 * along);
}

// After five passes at 4.4 k what is stored changes little more: 7.5 % are missing at cells of a/4
// and clamped ends at 20 half-widths, 4.7 % with ends at 40, 1.7 % with cells of a/8 as well. The
// first pass stores a tenth of its work.
TEST(PlasticPassBalance, WorkOfTheLoadIsPlasticWorkInSteadyRatchetting) {
  std::array<double, 2> missing{};
  for (int n = 0; n < 2; ++n) {
    const RolledBody& slab = slab_of(n == 0 ? 4 : 6, 20.0);
    Passes passes(slab, plain_steel(shear_yield), 4.4 * shear_yield);
    passes.accuracy.residual = 1e-5;
    passes.next();
    const auto [first, of_first] = works(passes);
    EXPECT_GT(first, 1.05 * of_first);
    passes.next(4);
    const auto [load, plastic] = works(passes);
    missing[n] = 1.0 - load / plastic;
    EXPECT_GT(plastic, 0.1 * of_first);
  }
  EXPECT_LT(std::abs(missing[0]), 0.09);
  EXPECT_LT(std::abs(missing[1]), 0.8 * std::abs(missing[0]));
}

// Mirrored at the plane of contact, a wheel is a rail whose friction has the other sign.
TEST(PlasticPassBalance, AFlatWheelIsAMirroredRail) {
  const RolledBody &rail = slab_of(4, 20.0), &wheel = slab_of(4, 20.0, true);
  Passes of_rail(rail, plain_steel(shear_yield, 5e3), 3.8 * shear_yield, 0.2),
      of_wheel(wheel, plain_steel(shear_yield, 5e3), 3.8 * shear_yield, -0.2);
  for (Passes* passes : {&of_rail, &of_wheel}) passes->next(2);
  ASSERT_EQ(rail.lines.points(), wheel.lines.points());
  double largest = 0.0, difference = 0.0;
  for (std::size_t k = 0; k < rail.lines.points(); ++k) {
    const auto &one = of_rail.state.plastic[k], &other = of_wheel.state.plastic[k];
    for (int c = 0; c < 6; ++c) {
      largest = std::max(largest, std::abs(one[c]));
      difference = std::max(difference, std::abs(one[c] - (c > 3 ? -other[c] : other[c])));
    }
  }
  EXPECT_GT(largest, 1e-3);
  EXPECT_LT(difference, 1e-4 * largest);
}
