// SPDX-License-Identifier: LGPL-2.1-or-later
// Sums over the contact grid: FFT against direct, wheel against rail, the surface against the
// influence coefficients of the contact solvers.
#include "halfspace/stress/subsurface.hpp"

#include "base/errors.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "halfspace/stress/cell_stress.hpp"
#include "scene/geometry.hpp"

#include "support/cell_state.hpp"

namespace {

using namespace contact::component;

using halfspace::Body;
using halfspace::LoadedBody;
using halfspace::SubsurfaceState;
using halfspace::Summation;

/// Tractions without any symmetry on a patch that leaves part of the grid unloaded.
LoadedBody example(Body body) {
  LoadedBody loaded;
  loaded.body = body;
  loaded.material = {200e3, body == Body::wheel ? 0.3 : 0.22};
  loaded.grid = contact::ContactGrid::centred(9, 6, 0.4, 0.7, 0.3, -0.2);
  const auto inside = [](double x, double y) { return x * x / 2.6 + y * y / 3.4 < 1.0; };
  loaded.traction.n = loaded.grid.sample(
      [&](double x, double y) { return inside(x, y) ? 900.0 - 120.0 * x * x + 60.0 * y : 0.0; });
  loaded.traction.x = loaded.grid.sample(
      [&](double x, double y) { return inside(x, y) ? -200.0 + 80.0 * x - 50.0 * x * y : 0.0; });
  loaded.traction.y = loaded.grid.sample(
      [&](double x, double y) { return inside(x, y) ? 100.0 * x - 30.0 * y : 0.0; });
  return loaded;
}

void expect_same(const SubsurfaceState& found, const SubsurfaceState& expected, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(found.displacement[i], expected.displacement[i], tolerance * 0.01);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(found.stress[i], expected.stress[i], tolerance * 900.0);
}

halfspace::SubsurfaceLayer plane(const LoadedBody& body, const contact::ContactGrid& points,
                                 double depth, Summation summation = Summation::automatic) {
  return halfspace::subsurface_box(body, points, {depth}, summation).front();
}

TEST(Subsurface, SumIsThatOfItsElements) {
  const LoadedBody body = example(Body::wheel);
  const double G = contact::shear_modulus(body.material);
  for (const auto& point : {halfspace::SubsurfacePoint{0.37, -0.81, 0.45},
                            {0.3, -0.2, 0.0},
                            {40.0, -3.0, 9.0},
                            {500.0, -300.0, 200.0}}) {
    halfspace::LocalState sum{};
    for (int j = 0; j < body.grid.ny; ++j)
      for (int i = 0; i < body.grid.nx; ++i) {
        const int k = body.grid.index(i, j);
        const halfspace::LocalState one = rectangle_state(
            point.x - body.grid.x(i), point.y - body.grid.y(j), point.depth, body.grid.dx,
            body.grid.dy, {body.traction.x[k], body.traction.y[k], body.traction.n[k]}, G, 0.3);
        for (std::size_t c = 0; c < halfspace::component_count; ++c) sum[c] += one[c];
      }
    const SubsurfaceState state = halfspace::subsurface_at(body, {point}).front();
    const double u = 1e-9 * std::abs(sum[halfspace::u_z]);
    EXPECT_NEAR(state.displacement[0], sum[halfspace::u_x], u);
    EXPECT_NEAR(state.displacement[1], sum[halfspace::u_y], u);
    EXPECT_NEAR(state.displacement[2], sum[halfspace::u_z], u);
    const double s = 1e-11;  // MPa
    EXPECT_NEAR(state.stress[xx], sum[halfspace::s_xx], s);
    EXPECT_NEAR(state.stress[yy], sum[halfspace::s_yy], s);
    EXPECT_NEAR(state.stress[zz], sum[halfspace::s_zz], s);
    EXPECT_NEAR(state.stress[xy], sum[halfspace::s_xy], s);
    EXPECT_NEAR(state.stress[yz], sum[halfspace::s_yz], s);
    EXPECT_NEAR(state.stress[xz], sum[halfspace::s_xz], s);
  }
}

TEST(Subsurface, FourierSumEqualsDirectSum) {
  // Lattices that are larger, smaller, aside, shifted by a fraction of an element, and a section.
  const std::vector<contact::ContactGrid> lattices{
      contact::ContactGrid::centred(9, 6, 0.4, 0.7, 0.3, -0.2),
      contact::ContactGrid::centred(31, 24, 0.4, 0.7, 1.1, 0.05),
      contact::ContactGrid::centred(3, 2, 0.4, 0.7, -0.11, 0.4),
      contact::ContactGrid::centred(12, 5, 0.4, 0.7, 20.0, -9.0),
      contact::ContactGrid::centred(15, 1, 0.4, 123.0, 0.07, 0.21)};
  for (const Body side : {Body::wheel, Body::rail}) {
    const LoadedBody body = example(side);
    for (const contact::ContactGrid& lattice : lattices) {
      const std::vector<double> depths{0.0, 0.13, 1.7, 25.0};
      const auto direct = halfspace::subsurface_box(body, lattice, depths, Summation::direct);
      const auto fft = halfspace::subsurface_box(body, lattice, depths, Summation::fft);
      for (std::size_t d = 0; d < depths.size(); ++d) {
        EXPECT_EQ(fft[d].depth, depths[d]);
        ASSERT_EQ(fft[d].states.size(), static_cast<std::size_t>(lattice.size()));
        for (std::size_t k = 0; k < fft[d].states.size(); ++k)
          expect_same(fft[d].states[k], direct[d].states[k], 1e-12);
      }
    }
  }
}

TEST(Subsurface, TractionsPassFromOneBodyToTheOther) {
  // On the surface both bodies have the stress -p on the common plane, in the global frame.
  const LoadedBody wheel = example(Body::wheel);
  const LoadedBody rail = example(Body::rail);
  for (const LoadedBody& body : {wheel, rail}) {
    const auto layer = plane(body, body.grid, 0.0);
    for (int k = 0; k < body.grid.size(); ++k) {
      const contact::SymmetricTensor& stress = layer.states[static_cast<std::size_t>(k)].stress;
      EXPECT_NEAR(stress[zz], -body.traction.n[k], 1e-10);
      EXPECT_NEAR(stress[xz], -body.traction.x[k], 1e-10);
      EXPECT_NEAR(stress[yz], -body.traction.y[k], 1e-10);
    }
  }
}

TEST(Subsurface, SurfaceDisplacementDifferenceIsTheCompliance) {
  // Independent code: the influence coefficients with the combined constants and the coupling K.
  const LoadedBody wheel = example(Body::wheel);
  const LoadedBody rail = example(Body::rail);
  const auto upper = plane(wheel, wheel.grid, 0.0).states;
  const auto lower = plane(rail, rail.grid, 0.0).states;
  const halfspace::HalfspaceCompliance compliance(wheel.grid,
                                                  contact::combine(wheel.material, rail.material));
  const contact::SurfaceField u = compliance.apply(wheel.traction);
  const double scale = u.n.cwiseAbs().maxCoeff();
  for (std::size_t k = 0; k < upper.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      const contact::Field& expected = c == 0 ? u.x : c == 1 ? u.y : u.n;
      EXPECT_NEAR(upper[k].displacement[c] - lower[k].displacement[c],
                  expected[static_cast<Eigen::Index>(k)], 1e-11 * scale);
    }
}

TEST(Subsurface, NoTractionNoStress) {
  LoadedBody body = example(Body::wheel);
  body.traction = {};
  expect_same(halfspace::subsurface_at(body, {{0.1, 0.2, 0.3}}).front(), {}, 0.0);
}

TEST(Subsurface, WrongInputIsRefused) {
  LoadedBody body = example(Body::wheel);
  EXPECT_THROW(halfspace::subsurface_at(body, {{0.0, 0.0, -1.0}}), contact::InputError);
  const auto other = contact::ContactGrid::centred(5, 5, 0.2, 0.7);
  EXPECT_THROW(plane(body, other, 1.0, Summation::fft), contact::InputError);
  EXPECT_NO_THROW(plane(body, other, 1.0));
  body.traction.x.conservativeResize(3);
  EXPECT_THROW(halfspace::subsurface_at(body, {{0.0, 0.0, 1.0}}), contact::InputError);
  body = example(Body::wheel);
  body.traction.n[4] = std::nan("");
  EXPECT_THROW(halfspace::subsurface_at(body, {{0.0, 0.0, 1.0}}), contact::InputError);
}

}  // namespace
