// Line contact of half-planes against closed forms and CONTACT: Carter, Bentall and Johnson, Spence
// (reference/benchmarks.md, 2, 4 and 5), and against quadrature: Nowell and Hills's rollers.
#include "contact/result/patch_size.hpp"
#include "contact/scene/geometry.hpp"
#include "contact/solve/contact_problem.hpp"
#include "contact/solve/history.hpp"
#include "contact/solve/prescribed_force.hpp"
#include "halfspace/elasticity/compliance.hpp"
#include "theories/carter.hpp"

#include <gtest/gtest.h>

#include "support/recorded.hpp"
#include "support/thesis_cases.hpp"
#include <cmath>
#include <memory>

namespace rollfem {
namespace {

using contact::ContactConditions;
using contact::ContactGrid;
using contact::ContactProblem;
using contact::ContactState;
using contact::ElementState;
using contact::Field;
using contact::Motion;
using contact::TangentialField;
using contact::UpwindOrder;
using Eigen::Vector2d;
using halfspace::HalfspaceCompliance;

/// A roller whose Hertz contact has half width a, n elements across it, forces in N/mm.
class Roller {
 public:
  Roller(double a, double radius, const contact::CombinedMaterial& material, double mu, int n,
         UpwindOrder order = UpwindOrder::second)
      : grid(line_of(n + 2 * (n / 5 + 4), 2.0 * a / n)),
        friction(mu),
        load(M_PI * a * a * material.contact_modulus / (4.0 * radius)),
        hertz_pressure(2.0 * load / (M_PI * a)),
        whole_(grid, material) {
    if (material.couples())
      uncoupled_ = std::make_unique<HalfspaceCompliance>(grid, material.uncoupled());
    contact::ContactConditions scene;
    scene.undeformed_distance =
        grid.sample([&](double x, double) { return x * x / (2.0 * radius); });
    scene.friction = contact::coulomb(mu);
    scene.upwind_order = order;
    problem = std::make_unique<ContactProblem>(whole_, uncoupled_ ? *uncoupled_ : whole_, scene);
    stiffness_ = 2.0 * load * radius / a;
  }

  ContactState roll(double xi, const ContactState* start = nullptr) const {
    const TangentialField slip{Field::Constant(grid.size(), xi), Field::Zero(grid.size())};
    return problem->solve({load, {}}, {slip}, start, {1e-8, 1e-7});
  }

  double force(const ContactState& state) const {
    return state.tangential.traction.x.sum() * grid.element_area();
  }

  /// Creepage at F_x = ratio mu P, and the state there.
  double creepage_of(double ratio, ContactState* found = nullptr) const {
    ContactState state;
    const contact::ForceLaw law = [&](const Vector2d& c) {
      state = roll(c.x(), state.normal.pressure.size() > 0 ? &state : nullptr);
      return contact::TransmittedForce{{force(state), 0.0}, friction * load};
    };
    const contact::ForceSearch search{{0.0, 0.0}, Vector2d::Constant(stiffness_), 1e-6, 100};
    const double xi =
        contact::find_creepage(law, {ratio * friction * load, {}}, search).creepage.x();
    if (found) *found = state;
    return xi;
  }

  ContactGrid grid;
  double friction;
  double load;  ///< N/mm
  double hertz_pressure;
  std::unique_ptr<ContactProblem> problem;

 private:
  /// What displacements are relative to, far away, changes neither forces nor pressure.
  static ContactGrid line_of(int elements, double cell) {
    ContactGrid line = ContactGrid::centred(elements, 1, cell, 1.0);
    line.line_reference = 10.0 * elements * cell;
    return line;
  }

  HalfspaceCompliance whole_;
  std::unique_ptr<HalfspaceCompliance> uncoupled_;
  double stiffness_;
};

/// Largest error of Carter's force over the creep curve, relative to mu P.
double carter_error(int n) {
  const Roller roller(1.0, 500.0, rollfem::testing::alike(82000.0, 0.28), 0.3, n);
  const theories::CarterContact carter{1.0, roller.hertz_pressure, 0.3, 82000.0 / 0.72};
  double error = 0.0;
  for (const double part : {0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 0.95, 1.1}) {
    const double xi = part * carter.saturation_creepage();
    const double exact = theories::CarterSolution(carter, xi).force();
    error = std::max(error, std::abs(roller.force(roller.roll(xi)) - exact));
  }
  return error / (0.3 * roller.load);
}

TEST(Carter, ForceWithinATenthOfAPercentAt40ElementsOfSecondOrder) {
  const double at_40 = carter_error(40);
  EXPECT_LT(at_40, 0.001);
  EXPECT_LT(carter_error(80), 2.5e-4);
  EXPECT_GT(std::log2(at_40 / carter_error(80)), 1.7);
  EXPECT_GT(std::log2(carter_error(10) / at_40) / 2.0, 1.4);
  for (const int n : {10, 20, 40, 80, 160})
    rollfem::testing::record("error_at_" + std::to_string(n), carter_error(n));
}

TEST(Carter, TractionsAndSlipOfTheUsersGuide) {
  // a' = 0.6: |xi| = 2.4e-4, |F_x| = 0.64 mu P.
  const Roller roller(1.0, 500.0, rollfem::testing::alike(82000.0, 0.28), 0.3, 100);
  const ContactState state = roller.roll(2.4e-4);
  EXPECT_NEAR(roller.force(state) / (0.3 * roller.load), -0.64, 0.64 * 0.001);
  EXPECT_NEAR(roller.load, 178.90, 0.01);
  const theories::CarterContact carter{1.0, roller.hertz_pressure, 0.3, 82000.0 / 0.72};
  const theories::CarterSolution exact(carter, 2.4e-4);
  for (int i = 0; i < roller.grid.nx; ++i) {
    const double x = roller.grid.x(i);
    if (std::abs(x) > 0.97 || std::abs(x + 0.2) < 0.03) continue;  // square roots begin there
    EXPECT_NEAR(state.tangential.traction.x[i], exact.traction(x), 0.01 * 0.3 * 113.89) << x;
    EXPECT_NEAR(state.tangential.slip.x[i], exact.slip(x), 0.02 * 2.4e-4) << x;
  }
}

contact::CombinedMaterial aluminium_on_steel() {
  return contact::combine({2.0 * 23000.0 * 1.31, 0.31}, {2.0 * 82000.0 * 1.28, 0.28});
}

/// Rollers of 50 mm, a = 0.1 mm.
Roller bentall_johnson(double friction, int n, UpwindOrder order = UpwindOrder::second) {
  return {0.1, 25.0, aluminium_on_steel(), friction, n, order};
}

TEST(BentallJohnson, MaterialOfTheBenchmark) {
  const contact::CombinedMaterial m = aluminium_on_steel();
  EXPECT_NEAR(m.shear_modulus, 35923.8, 0.05);
  EXPECT_NEAR(m.poisson_ratio, 0.30343, 5e-6);
  EXPECT_NEAR(m.difference, 0.10019, 5e-6);
  EXPECT_NEAR(bentall_johnson(0.1, 20).load, 16.2019, 1e-3);
}

TEST(BentallJohnson, CreepageOfFreeRollingWithHardlyAnyFriction) {
  // The sign: CONTACT's creepage is minus ours. 0.457 kappa a/R = 5.2586e-4 is rounded to three
  // digits; where everything slips, force balance gives asin c + c sqrt(1 - c^2) = pi/4 for the
  // point of no slip and sqrt(1 - c^2)/2 = 0.457384 for the factor: 5.2631e-4.
  const double xi = -bentall_johnson(1e-4, 400).creepage_of(0.0);
  EXPECT_NEAR(xi / 5.2586e-4, 1.0, 0.002);
  EXPECT_NEAR(xi / 5.2631e-4, 1.0, 0.001);
  EXPECT_NEAR(xi / 5.260e-4, 1.0, 0.002);  // CONTACT, 200 elements
  rollfem::testing::record("creepage", xi);
}

TEST(BentallJohnson, FrictionLowersTheCreepageAndRaisesThePressure) {
  // CONTACT at 200 elements, first order: digit by digit with its own operator.
  ContactState state;
  const double some = -bentall_johnson(0.05, 200, UpwindOrder::first).creepage_of(0.0);
  EXPECT_NEAR(some, 4.29e-4, 0.005e-4);
  const Roller rough = bentall_johnson(10.0, 200, UpwindOrder::first);
  EXPECT_NEAR(-rough.creepage_of(0.0, &state), 3.59e-4, 0.005e-4);
  EXPECT_NEAR(state.normal.pressure.maxCoeff(), 103.81, 0.02);
  EXPECT_NEAR(rough.hertz_pressure, 103.145, 0.005);
  // Second order ends where the first order tends to.
  const double first_100 = -bentall_johnson(10.0, 100, UpwindOrder::first).creepage_of(0.0);
  const double first_200 = -rough.creepage_of(0.0);
  const double second = -bentall_johnson(10.0, 200).creepage_of(0.0);
  EXPECT_NEAR(second / (2.0 * first_200 - first_100), 1.0, 0.003);
  rollfem::testing::record("creepage_at_0.05", some);
  rollfem::testing::record("creepage_at_10", first_200);
  rollfem::testing::record("pressure_at_10", state.normal.pressure.maxCoeff());
}

TEST(BentallJohnson, TractiveAndBrakedRolling) {
  const Roller roller = bentall_johnson(0.05, 200);
  ContactState state;
  const double driven = -roller.creepage_of(0.75, &state);
  EXPECT_NEAR(driven / 5.392e-4, 1.0, 0.002);
  EXPECT_NEAR(state.normal.pressure.maxCoeff(), 103.3, 0.05);
  const double braked = -roller.creepage_of(-0.75, &state);
  EXPECT_NEAR(braked / 2.108e-4, 1.0, 0.002);
  rollfem::testing::record("creepage_driven", driven);
  rollfem::testing::record("creepage_braked", braked);
  EXPECT_NEAR(state.normal.pressure.maxCoeff(), 103.2, 0.05);
}

/// xi and p_max of aluminium on steel by Gauss-Chebyshev quadrature (benchmarks/book/
/// unlike_cylinders.py, 300 nodes), which has nothing in common with the program's elements.
struct UnlikeRolling {
  double friction, ratio;  // F_x over mu P, below 0 braked
  double creepage, pressure;
  double allowed;  // of mu a/R, at which like cylinders slide
};

const UnlikeRolling unlike_rolling[] = {
    {0.05, 0.5, 4.9802e-4, 103.417, 5e-4},  {0.05, 0.0, 4.2946e-4, 103.627, 5e-4},
    {0.05, -0.5, 3.1489e-4, 103.426, 5e-4}, {0.1, 0.75, 5.7666e-4, 103.148, 1e-3},
    {0.1, 0.0, 3.8942e-4, 103.733, 1e-3},   {0.1, -0.5, 2.2727e-4, 104.305, 1e-3},
    {0.3, 0.5, 6.9800e-4, 102.788, 4e-3},   {0.3, -0.75, -3.0786e-4, 104.105, 4e-3},
    {0.3, -0.9, -5.8876e-4, 103.315, 4e-3}};

TEST(NowellHills, TractiveRollingOfUnlikeCylindersAsByQuadrature) {
  for (std::size_t k = 0; k < std::size(unlike_rolling); ++k) {
    const UnlikeRolling& row = unlike_rolling[k];
    SCOPED_TRACE(::testing::Message() << "mu " << row.friction << ", F_x " << row.ratio << " mu P");
    const Roller roller = bentall_johnson(row.friction, 200);
    ContactState state;
    const double xi = -roller.creepage_of(row.ratio, &state);
    EXPECT_NEAR(xi, row.creepage, row.allowed * row.friction * 0.1 / 25.0);
    EXPECT_NEAR(state.normal.pressure.maxCoeff(), row.pressure, 2e-4 * row.pressure);
    rollfem::testing::record("creepage_" + std::to_string(k), xi);
    rollfem::testing::record("pressure_" + std::to_string(k), state.normal.pressure.maxCoeff());
  }
}

TEST(NowellHills, FreeRollingOfUnlikeCylindersThatAdhereEverywhere) {
  // p + i q is the jump of z - i xi - (z - 1)^(1/2 + i e) (z + 1)^(1/2 - i e) across the patch,
  // with 2 pi e = ln((1 + beta)/(1 - beta)); no force at infinity asks for xi R/b = 2 e, and P
  // gives b = a/sqrt(1 + 4 e^2). The patch is 0.4 % narrower than Hertz's, that is by half an
  // element of 200 at either end, which is what the difference comes from: elements touch or not.
  const double beta = 0.10019 / (1.0 - 0.30343);
  const double e = std::log((1.0 + beta) / (1.0 - beta)) / (2.0 * M_PI);
  const double exact = 2.0 * e / std::sqrt(1.0 + 4.0 * e * e) * 0.1 / 25.0;
  EXPECT_NEAR(exact, 3.6727e-4, 1e-8);  // by quadrature
  ContactState state;
  const double xi = -bentall_johnson(10.0, 200).creepage_of(0.0, &state);
  EXPECT_NEAR(xi / exact, 1.0, 0.016);
  EXPECT_NEAR(state.normal.pressure.maxCoeff() / 103.145,
              std::cosh(M_PI * e) / std::sqrt(1.0 + 4.0 * e * e), 2e-4);
  rollfem::testing::record("creepage", xi);
  rollfem::testing::record("pressure", state.normal.pressure.maxCoeff());
}

TEST(Spence, StickRatioOfWeaklyCoupledLineContact) {
  // K'(k)/K(k) = beta/mu for k = c/a (Spence 1975, Johnson 1985), exact while the shear does not
  // act back on the pressure: beta = 0.025. Pressed in small steps, for it depends on the history.
  for (const double beta_over_mu : {1.0, 0.5}) {
    contact::CombinedMaterial material = rollfem::testing::alike(1.0, 0.0);
    material.difference = 0.025;
    const Roller roller(1.0, 100.0, material, 0.025 / beta_over_mu, 200);
    contact::History history(roller.grid, UpwindOrder::second);
    const TangentialField none{Field::Zero(roller.grid.size()), Field::Zero(roller.grid.size())};
    ContactState state;
    constexpr int steps = 60;
    for (int k = 3; k <= steps; ++k) {
      const double force = roller.load * k * k / (steps * steps);
      const TangentialField slip = history.shift_step(none).rigid_slip;
      state = roller.problem->solve({force, {}}, {slip, Motion::shift});
      history.advance({state.displacement.x, state.displacement.y}, 0.0);
    }
    double k = 0.5;
    double low = 0.0;
    double high = 1.0;
    for (int halving = 0; halving < 60; ++halving, k = 0.5 * (low + high)) {
      const double ratio = std::comp_ellint_1(std::sqrt(1.0 - k * k)) / std::comp_ellint_1(k);
      (ratio > beta_over_mu ? low : high) = k;
    }
    int adhesion = 0;
    for (const ElementState s : state.tangential.state) adhesion += s == ElementState::adhesion;
    // One element of 200 is half a percent.
    EXPECT_NEAR(adhesion / 200.0, k, 0.01) << beta_over_mu;
    EXPECT_NEAR(state.tangential.traction.x.sum(), 0.0, 1e-6 * state.normal.pressure.sum());
  }
}

}  // namespace
}  // namespace rollfem
