// SPDX-License-Identifier: LGPL-2.1-or-later
// Reported gap, slip and tractions against the conditions of contact, with distance and
// displacement recomputed: influence coefficients summed element by element, without the
// transforms, differences and solvers that found the solution.
#include "halfspace/elasticity/influence.hpp"
#include "result/validity.hpp"

#include "support/half_space_models.hpp"
#include "support/patch_case.hpp"
#include "support/thesis_cases.hpp"

namespace {

PatchCase case_b(int across) {
  PatchCase input =
      thesis_case('b', across, {{0.0, 0.0, 0.0}, {1e-3, -5e-4, 2e-4}, {5e-3, 0.0, 0.0}});
  return input;
}

ModelResult solve(const PatchCase& input) {
  return half_space_models().run("halfspace", input, {});
}

/// Love's displacement under a uniform pressure of 1 MPa on a rectangle, of both bodies: the
/// integral of (1 - nu) / (pi G r), Johnson 1985, eq. 3.25.
double love(double x, double y, double dx, double dy, const contact::CombinedMaterial& material) {
  const double a = x + 0.5 * dx, b = x - 0.5 * dx, c = y + 0.5 * dy, d = y - 0.5 * dy;
  const auto corner = [](double one, double other) {
    return one * std::log(other + std::hypot(one, other));
  };
  const double integral = corner(a, c) - corner(a, d) + corner(c, a) - corner(c, b) + corner(b, d) -
                          corner(b, c) + corner(d, b) - corner(d, a);
  return (1.0 - material.poisson_ratio) / (M_PI * material.shear_modulus) * integral;
}

/// Displacement difference by the sum over all elements.
SurfaceField summed(const ContactGrid& grid, const SurfaceField& traction,
                    const contact::CombinedMaterial& material) {
  SurfaceField u{Field::Zero(grid.size()), Field::Zero(grid.size()), Field::Zero(grid.size())};
  for (int from = 0; from < grid.size(); ++from) {
    const double px = traction.x[from], py = traction.y[from], pn = traction.n[from];
    if (pn == 0.0) continue;
    for (int to = 0; to < grid.size(); ++to) {
      const double x = grid.x(to % grid.nx) - grid.x(from % grid.nx);
      const double y = grid.y(to / grid.nx) - grid.y(from / grid.nx);
      const halfspace::Influence a =
          halfspace::rectangle_influence(x, y, grid.dx, grid.dy, material);
      u.x[to] += a.xx * px + a.xy * py + a.xn * pn;
      u.y[to] += a.xy * px + a.yy * py + a.yn * pn;
      u.n[to] += love(x, y, grid.dx, grid.dy, material) * pn - a.xn * px - a.yn * py;
    }
  }
  return u;
}

/// Violation of p >= 0, gap >= 0 and p gap = 0 by that sum, relative to the approach.
double gap_left(const PatchCase& input, const ModelResult& result, const PointResult& point,
                const SurfaceField& u) {
  double left = 0.0;
  for (int k = 0; k < result.grid.size(); ++k) {
    const double x = result.grid.x(k % result.grid.nx), y = result.grid.y(k / result.grid.nx);
    const double distance =
        x * x / (2.0 * input.wheel.rolling_radius) + y * y / (2.0 * input.rail.transverse_radius);
    const double gap = distance + u.n[k] - point.approach;
    EXPECT_NEAR(point.fields.gap[k], gap, 1e-9 * point.approach);
    EXPECT_GE(point.fields.traction.n[k], 0.0);
    left = std::max(left, point.fields.traction.n[k] > 0.0 ? std::abs(gap) : -gap);
  }
  return left / point.approach;
}

/// Violation of Coulomb's law with the slip of first-order differences of that sum: slip in
/// adhesion and slip that the traction does not oppose, relative to the largest slip; tractions
/// beyond or below the bound, relative to the largest bound.
struct CoulombLeft {
  double adhesion = 0.0, direction = 0.0, bound = 0.0;
};
CoulombLeft coulomb_left(const ModelResult& result, const PointResult& point,
                         const SurfaceField& u) {
  const ContactGrid& grid = result.grid;
  const contact::ContactFields& f = point.fields;
  const double largest_bound = f.traction_bound.maxCoeff();
  // Where CONTACT has the spin with differences of first order.
  const double ahead = grid.dx / 6.0;
  CoulombLeft left;
  double largest_slip = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i + 1 < grid.nx; ++i) {
      const int k = grid.index(i, j);
      if (f.state[static_cast<std::size_t>(k)] == ElementState::exterior) continue;
      const contact::Creepage& c = point.creepage;
      const double wx = c.longitudinal - c.spin * grid.y(j) + (u.x[k] - u.x[k + 1]) / grid.dx;
      const double wy = c.lateral + c.spin * (grid.x(i) + ahead) + (u.y[k] - u.y[k + 1]) / grid.dx;
      const double w = std::hypot(wx, wy);
      const double p = std::hypot(f.traction.x[k], f.traction.y[k]);
      const double g = 0.55 * f.traction.n[k];
      largest_slip = std::max(largest_slip, w);
      left.bound = std::max(left.bound, (p - g) / largest_bound);
      if (f.state[static_cast<std::size_t>(k)] == ElementState::adhesion) {
        left.adhesion = std::max(left.adhesion, w);
        continue;
      }
      left.bound = std::max(left.bound, (g - p) / largest_bound);
      left.direction = std::max({left.direction, std::abs(wx + w * f.traction.x[k] / g),
                                 std::abs(wy + w * f.traction.y[k] / g)});
    }
  left.adhesion /= largest_slip;
  left.direction /= largest_slip;
  return left;
}

TEST(TrueGap, OfLikeMaterialsIsClosedUnderPressureByLovesSum) {
  const PatchCase input = case_b(16);
  const ModelResult result = solve(input);
  for (const PointResult& point : result.points)
    EXPECT_LT(gap_left(input, result, point,
                       summed(result.grid, point.fields.traction, rollfem::testing::steel())),
              2e-8);
}

TEST(TrueGap, OfUnlikeMaterialsIsClosedUnderAllTractions) {
  PatchCase input = case_b(12);
  input.wheel.material = {70e3, 0.33};
  const auto material = contact::combine(input.wheel.material, input.rail.material);
  const ModelResult result = solve(input);
  for (const PointResult& point : result.points) {
    const SurfaceField u = summed(result.grid, point.fields.traction, material);
    EXPECT_LT(gap_left(input, result, point, u), 1e-6);
    // Friction moves the surfaces apart and together: without it the gap is not closed.
    SurfaceField alone = point.fields.traction;
    alone.x.setZero();
    alone.y.setZero();
    if (point.max_traction == 0.0) continue;
    const SurfaceField without = summed(result.grid, alone, material);
    EXPECT_GT((without.n - u.n).cwiseAbs().maxCoeff(), 1e-3 * point.approach);
  }
}

TEST(TrueGap, OfACurvedPatchIsClosedAndOpensBesideIt) {
  PatchCase input = case_b(24);
  input.rail.transverse_radius = 50.0;
  input.wheel.transverse_radius = -51.282;
  input.halfspace.surface = contact::SurfaceForm::curved;
  const ModelResult result = solve(input);
  for (const PointResult& point : result.points) {
    EXPECT_LT(contact::contact_residual(point.fields).gap, 1e-7);
    EXPECT_GT(point.fields.gap.maxCoeff(), 0.05 * point.approach);
  }
}

TEST(TrueGap, SlipOfTheSumKeepsCoulombsLaw) {
  PatchCase input = case_b(16);
  input.rolling.upwind_order = contact::UpwindOrder::first;
  const ModelResult result = solve(input);
  for (std::size_t k = 1; k < result.points.size(); ++k) {
    const PointResult& point = result.points[k];
    const CoulombLeft left = coulomb_left(
        result, point, summed(result.grid, point.fields.traction, rollfem::testing::steel()));
    EXPECT_LT(left.adhesion, 1e-5) << k;
    EXPECT_LT(left.direction, 1e-5) << k;
    EXPECT_LT(left.bound, 1e-5) << k;
  }
  // Both states occur.
  EXPECT_GT(result.points[1].adhesion_area, 0.2 * result.points[1].contact_area);
  EXPECT_LT(result.points[1].adhesion_area, 0.9 * result.points[1].contact_area);
}

}  // namespace
