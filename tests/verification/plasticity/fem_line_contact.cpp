// SPDX-License-Identifier: LGPL-2.1-or-later
// A line contact on perfectly plastic steel in plane strain: first yield, shakedown and ratchetting
// against Johnson's theory (Contact mechanics, 1985, sections 4.2, 9.2), and how far clamped ends
// hold flow back.
#include "fem/discretisation/body_points.hpp"
#include "fem/plasticity/pass_results.hpp"

#include "support/fem_plane_strain.hpp"

namespace {

/// MPa, yield stress in shear.
constexpr double k = 300.0;

/// Friction and p0/k of shakedown by Johnson's map (postprocess/rollfem/shakedown.py).
constexpr std::pair<double, double> map_of_lines[] = {
    {0.0, 4.0}, {0.1, 3.564}, {0.2, 3.203}, {0.3, 2.900}};

/// Along, across and normal to the surface and xz, over p0, under Hertz's pressure; lengths in
/// half-widths, Poisson's ratio 0.3 (McEwen 1949).
std::array<double, 4> hertz_line(double x, double depth) {
  const double z = depth, q = 1.0 - x * x + z * z, root = std::hypot(q, 2.0 * x * z);
  const double m = std::sqrt(0.5 * (root + q)), n = std::sqrt(0.5 * (root - q));
  const double share = (z * z + n * n) / (m * m + n * n);
  const double along = 2.0 * z - m * (1.0 + share), normal = -m * (1.0 - share);
  return {along, 0.3 * (along + normal), normal, n * (m * m - z * z) / (m * m + n * n)};
}

/// p0/k and depth of first yield: below the middle.
std::pair<double, double> first_yield() {
  std::pair<double, double> largest{0.0, 0.0};
  for (double depth = 0.5; depth < 1.0; depth += 1e-3) {
    const auto s = hertz_line(0.0, depth);
    const double mises = std::sqrt(
        0.5 * (std::pow(s[0] - s[1], 2) + std::pow(s[1] - s[2], 2) + std::pow(s[2] - s[0], 2)));
    largest = std::max(largest, {mises, depth});
  }
  return {std::sqrt(3.0) / largest.first, largest.second};
}

/// p0/k of shakedown on the cells of a slab.
double melan_limit(const RolledBody& slab, double friction) {
  const fem::PlasticLaw law(plain_steel(1.0), fem::lame_mu(slab.body->material()));
  return 1.0 / fem::shakedown_load(law, slab.lines, slab.elastic_strain(1.0, friction));
}

/// To 1e-5: what the residual stresses of these tests need.
Passes passes_over(const RolledBody& slab, double load, double friction = 0.0) {
  Passes passes(slab, plain_steel(k), load * k, friction);
  passes.accuracy.residual = 1e-5;
  return passes;
}

/// With a first row of this height, half-widths; 0: equal rows.
std::unique_ptr<RolledBody> slab_with_rows(int per_half_width, double first_row,
                                           double extent = 10.0) {
  SlabOptions options;
  options.extent = extent;
  options.per_half_width = per_half_width;
  options.first_row = first_row;
  return rolled_slab(options);
}

/// What a load of 4.5 k with a friction of 0.3 does to steel with Prager's hardening E/20.
struct SurfaceFlow {
  double first_pass, third_pass;  ///< accumulated plastic strain of the first points
  double forward;                 ///< mm, displacement of the surface after three passes
  double unknowns;
};

SurfaceFlow surface_flow(int per_half_width, double first_row) {
  const auto slab = slab_with_rows(per_half_width, first_row);
  Passes passes(*slab, plain_steel(k, 210e3 / 20.0), 4.5 * k, 0.3);
  passes.accuracy.residual = 1e-4;
  SurfaceFlow flow{};
  flow.unknowns = static_cast<double>(slab->body->unknowns());
  passes.next();
  flow.first_pass = passes.state.leaving.front().accumulated;
  passes.next();
  flow.third_pass = -passes.state.leaving.front().accumulated;
  passes.next();
  flow.third_pass += passes.state.leaving.front().accumulated;
  const auto place = fem::BodyLocator(*slab->body).find({{-1.5, 0.05, 0.0}}, 0.1);
  flow.forward = place.values(passes.state.displacement, {1, 1, 1}).front()[0];
  return flow;
}

/// Forward displacement of the surface behind a load of 4.2 k with a friction of 0.2 after one
/// pass, mm, with ends this far away.
double flow_of_surface(double extent) {
  const RolledBody& slab = slab_of(4, extent);
  Passes passes(slab, plain_steel(k, 10e3), 4.2 * k, 0.2);
  passes.next();
  const auto place = fem::BodyLocator(*slab.body).find({{-1.5, 0.1, 0.0}}, 0.1);
  return place.values(passes.state.displacement, {1, 1, 1}).front()[0];
}

}  // namespace

// Clamped ends at a distance L change the stress by the order of a/L (a line load decays no
// faster): extrapolated from 40 and 80 half-widths. What remains, 0.2 %, is that of cells of a/8.
TEST(PlasticLineContact, YieldsFirstWhereTheElasticFieldSays) {
  std::array<double, 2> load{};
  double depth = 0.0;
  for (int n = 0; n < 2; ++n) {
    const RolledBody& slab = slab_of(8, 40.0 * (n + 1));
    const auto [largest, at] = Passes(slab, plain_steel(k), k).utilisation();
    load[n] = 1.0 / largest;
    depth = slab.lines.section(at / slab.lines.stations())[1];
    EXPECT_NEAR(slab.lines.s(at % slab.lines.stations()), 0.0, 0.5 / 8);
  }
  const auto [expected, deep] = first_yield();
  EXPECT_NEAR(2.0 * load[1] - load[0], expected, 0.005 * expected);
  EXPECT_NEAR(depth, deep, 0.5 / 8);  // half a cell
}

// The limit of shakedown is where the largest |xz| reaches k; second order in the cells, 0.84 % at
// a/8, while below the surface; at the surface (friction 0.4) the first material point is 0.2 cells
// down: 5.2 %, first order.
TEST(PlasticLineContact, ShearThatNoResidualStressChangesFollowsTheShakedownMap) {
  const RolledBody &coarse = slab_of(8, 20.0), &fine = slab_of(12, 20.0);
  for (const auto& [friction, theory] : map_of_lines) {
    EXPECT_NEAR(melan_limit(coarse, friction), theory, 0.01 * theory) << friction;
    EXPECT_NEAR(melan_limit(fine, friction), theory, 0.005 * theory) << friction;
  }
  EXPECT_NEAR(melan_limit(coarse, 0.4), 2.5, 0.06 * 2.5);
  EXPECT_NEAR(melan_limit(fine, 0.4), 2.5, 0.04 * 2.5);
}

// A first row of a/50 puts the first point 0.0031 a deep, where the shear is 0.6 % less.
TEST(PlasticLineContact, ThinRowsFollowTheMapAtTheSurface) {
  const auto slab = slab_with_rows(8, 0.02, 20.0);
  EXPECT_NEAR(melan_limit(*slab, 0.4), 2.5, 0.01 * 2.5);
  EXPECT_NEAR(melan_limit(*slab, 0.0), 4.0, 0.01 * 4.0);
}

// On cells of a/8 the strain at the first points is 8 % less than on cells of a/16 in the first
// pass, and 24 % in the third; with thin rows as on a/16, for 15 % more unknowns. The forward flow
// is within 1 % on all of them.
TEST(PlasticLineContact, ThinRowsSeeTheStrainOfTheSurface) {
  const SurfaceFlow thin = surface_flow(8, 0.02), coarse = surface_flow(8, 0.0),
                    fine = surface_flow(16, 0.0);
  EXPECT_NEAR(thin.first_pass, fine.first_pass, 0.015 * fine.first_pass);
  EXPECT_NEAR(thin.third_pass, fine.third_pass, 0.03 * fine.third_pass);
  EXPECT_LT(coarse.first_pass, 0.95 * fine.first_pass);
  EXPECT_LT(coarse.third_pass, 0.8 * fine.third_pass);
  EXPECT_LT(thin.unknowns, 1.16 * coarse.unknowns);
  EXPECT_NEAR(thin.forward, fine.forward, 0.02 * fine.forward);
}

TEST(PlasticLineContact, ShakesDownBelowFourK) {
  const RolledBody& slab = slab_of(6, 20.0);
  for (const double load : {3.9, 4.0}) {
    auto passes = passes_over(slab, load);
    const auto increases = passes.next(3);
    EXPECT_GT(increases[0], 1e-3) << load;
    EXPECT_LT(increases[2], 1e-8) << load;
    EXPECT_LT(passes.report.plastic_work, 1e-8 * load * k) << load;
  }
}

TEST(PlasticLineContact, RatchetsSteadilyAboveFourK) {
  const RolledBody& slab = slab_of(6, 20.0);
  expect_ratchetting(passes_over(slab, 4.24).next(4));  // 1.7e-3 in the end
}

// 6 % to both sides of the limit with friction 0.2: increases that fall by half with every pass, or
// stay at 1.5e-3.
TEST(PlasticLineContact, FrictionLowersTheLimitAsTheMapSays) {
  const RolledBody& slab = slab_of(6, 20.0);
  const double limit = map_of_lines[2].second;
  expect_shakedown(passes_over(slab, 0.94 * limit, 0.2).next(5), 1e-4);
  expect_ratchetting(passes_over(slab, 1.06 * limit, 0.2).next(4));
}

// Where |xz| is largest the limit leaves no other stress but it: residual stresses along and across
// make the three normal ones equal. At the limit of these cells, after passes that fall ever
// slower, along within 0.03 p0, across within 0.02 p0.
TEST(PlasticLineContact, ResidualStressAtTheLimitIsTheOnlyOnePossible) {
  const RolledBody& slab = slab_of(8, 80.0);
  auto passes = passes_over(slab, 1.0065 * melan_limit(slab, 0.0));
  passes.next(10);
  const auto residual = residual_at(passes, 0.5, -1.6, -1.4);
  const auto elastic = hertz_line(std::sqrt(0.75), 0.5);
  EXPECT_NEAR(elastic[3], 0.25, 1e-12);
  EXPECT_NEAR(residual[0] / passes.load_factor, elastic[2] - elastic[0], 0.03);
  EXPECT_NEAR(residual[1] / passes.load_factor, elastic[2] - elastic[1], 0.01);
}

// In plane strain, where what ends do decays slowest: 2.1 % at eight half-widths, the usual extent.
TEST(PlasticLineContact, FlowsForwardsBetweenNearEndsAsBetweenFarOnes) {
  const double far = flow_of_surface(80.0);
  EXPECT_GT(far, 0.0);
  EXPECT_NEAR(flow_of_surface(8.0), far, 0.03 * far);
}
