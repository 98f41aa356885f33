// SPDX-License-Identifier: LGPL-2.1-or-later
// Missing compliance of a lattice of finite elements relative to the half-space, and the resulting
// displacement at the middles of contact elements.
#include "base/pi.hpp"
#include "fem/fem_options.hpp"
#include "fem/trace/middle_displacement.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"

#include "support/fem_body_pair.hpp"

namespace {

/// Sum over all elements: missing compliance under uniform tractions.
fem::ElementResponse total(const std::vector<fem::ElementResponse>& deficit) {
  fem::ElementResponse sum;
  const int side = fem::lattice_reach + 1;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const double times = (i > 0 ? 2.0 : 1.0) * (j > 0 ? 2.0 : 1.0);
      const auto& at = deficit[static_cast<std::size_t>(j * side + i)];
      sum.xx += times * at.xx;
      sum.yy += times * at.yy;
      sum.nn += times * at.nn;
    }
  return sum;
}

double largest(const fem::ElementResponse& of) {
  return std::max({std::abs(of.xx), std::abs(of.yy), std::abs(of.nn)});
}

}  // namespace

TEST(Lattice, LongWavesOfEveryElementAreThoseOfTheHalfSpace) {
  for (const auto& [degree, cells] : {std::pair{1, 2}, {2, 1}, {3, 1}})
    for (const double poisson_ratio : {0.0, 0.3, 0.45, 0.4999}) {
      const auto deficit =
          fem::lattice_deficit({{210e3, poisson_ratio}, degree, cells, {0.5, 0.5, 0.5}});
      EXPECT_GT(deficit[0].xx, 0.0) << degree;  // fewer displacements to choose from: stiffer
      EXPECT_GT(deficit[0].nn, 0.0) << degree;
      EXPECT_LT(largest(total(deficit)), (degree == 1 ? 0.1 : 0.02) * deficit[0].xx)
          << degree << " " << poisson_ratio;
      EXPECT_LT(largest(deficit.back()), (degree == 1 ? 3e-4 : 1e-4) * deficit[0].xx)
          << degree << " " << poisson_ratio;
    }
}

TEST(Lattice, IsAtHomeInAnyUnitAndTurnsWithItsCells) {
  const auto of = [](double young_modulus, std::array<double, 3> size) {
    return fem::lattice_deficit({{young_modulus, 0.3}, 2, 1, size});
  };
  const auto reference = of(210e3, {0.5, 0.5, 0.5});
  const auto scaled = of(70e3, {1.0, 1.0, 1.0});
  EXPECT_NEAR(scaled[1].xx / reference[1].xx, 6.0, 1e-9);
  const auto wide = of(210e3, {0.5, 0.7, 0.6});
  const auto turned = of(210e3, {0.7, 0.5, 0.6});
  const int side = fem::lattice_reach + 1;
  for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {0, 2}, {3, 1}}) {
    const auto& a = wide[static_cast<std::size_t>(j * side + i)];
    const auto& b = turned[static_cast<std::size_t>(i * side + j)];
    EXPECT_NEAR(a.xx, b.yy, 1e-12 + 1e-9 * std::abs(a.xx));
    EXPECT_NEAR(a.xy, b.xy, 1e-12 + 1e-9 * std::abs(a.xy));
  }
}

/// A real mesh against both: the displacement of one loaded element on a flat body.
TEST(Lattice, IsWhatAMeshDoesUnderOneLoadedElement) {
  fem::BodyOptions options = small_options();
  options.fine_depth = 2.0;
  const auto grid = contact::ContactGrid::centred(6, 6, 1.0, 1.0);
  for (const auto& shape : {rail_shape(contact::infinity)}) {
    const fem::Body body(shape, steel, options, MPI_COMM_SELF);
    const auto solver = fem::make_factorisation(body.problem());
    const fem::FemCompliance whole({nullptr, nullptr}, {&body, solver.get()}, {}, grid,
                                   fem::FarBoundary::point_load);
    constexpr contact::Material rigid{contact::infinity};
    const halfspace::HalfspaceCompliance half(grid, contact::combine(rigid, steel));
    const contact::Field none = contact::Field::Zero(grid.size());
    contact::Field one = none;
    one[grid.index(3, 2)] = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      contact::SurfaceField load{none, none, none};
      (axis == 0 ? load.x : axis == 1 ? load.y : load.n) = one;
      const auto fe = whole.apply(load);
      const auto exact = half.apply(load);
      const double scale = std::max({exact.x.maxCoeff(), exact.y.maxCoeff(), exact.n.maxCoeff()});
      const double worst = axis == 2 ? (fe.n - exact.n).cwiseAbs().maxCoeff()
                                     : std::max((fe.x - exact.x).cwiseAbs().maxCoeff(),
                                                (fe.y - exact.y).cwiseAbs().maxCoeff());
      std::printf("axis %d worst %.5f\n", axis, worst / scale);
      // The element means alone would have an error of 0.21.
      EXPECT_LT(worst, 0.01 * scale) << axis;
    }
  }
}
