// SPDX-License-Identifier: LGPL-2.1-or-later
// Steady rolling where half-space codes tend to fail, each case with a known answer.
#include "base/errors.hpp"
#include "contact/iteration/tangential.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "halfspace/model/halfspace_model.hpp"

#include "support/temporary_folder.hpp"
#include "support/thesis_cases.hpp"

namespace {

using halfspace::HalfspaceCompliance;

/// Forces under Hertz's pressure with semi-axes a, b and n elements across both.
struct Patch {
  double a = 6.0;
  double b = 6.0;
  int nx = 24;
  int ny = 24;
  double p0 = 1.5 * 82000.0 / (M_PI * 36.0);
  double friction = 0.3;
  double nu = 0.28;
  double G = 82000.0;

  double normal_force() const { return 2.0 / 3.0 * M_PI * a * b * p0; }
  ContactGrid grid() const { return ContactGrid::centred(nx + 6, ny + 6, 2 * a / nx, 2 * b / ny); }
  contact::CombinedMaterial material() const { return alike(G, nu); }
  TangentialProblem problem(const contact::Creepage& creepage) const {
    return {
        hertz_pressure(grid(), a, b, p0), {slip_of(grid(), creepage)}, contact::coulomb(friction)};
  }
  TangentialSolution solve(const contact::Creepage& creepage) const {
    const HalfspaceCompliance compliance(grid(), material());
    return contact::solve_tangential(compliance.rolling(UpwindOrder::second), problem(creepage));
  }
  Forces forces(const contact::Creepage& creepage) const {
    return rollfem::testing::forces(grid(), solve(creepage).traction);
  }
  /// mu F_z as the elements have it.
  double sliding_force() const {
    return friction * problem({}).pressure.sum() * grid().element_area();
  }
};

TEST(HardRolling, LowFrictionSlidesAndHighFrictionAdheres) {
  Patch low;
  low.friction = 1e-4;
  EXPECT_NEAR(low.forces({1e-3, 0, 0}).x / -low.sliding_force(), 1.0, 1e-4);
  // Nearly no creepage either: Carter-like partial slip, similar to mu 0.3 at 3000 times the
  // creepage, for only xi / mu counts.
  Patch usual;
  const double ratio = usual.forces({1e-3, 0, 0}).x / usual.sliding_force();
  EXPECT_NEAR(low.forces({1e-3 * 1e-4 / 0.3, 0, 0}).x / low.sliding_force() / ratio, 1.0, 1e-4);
  Patch high;
  high.friction = 500.0;
  const double force = high.forces({1e-3, 0, 0}).x;
  EXPECT_NEAR(-force / (high.G * high.a * high.b * 1e-3) / 4.20, 1.0, 0.03);  // C11 at nu 0.28
  EXPECT_NEAR(high.forces({2e-3, 0, 0}).x / force, 2.0, 1e-3);
}

TEST(HardRolling, TinyCreepageIsLinearAndHugeCreepageSlides) {
  const Patch patch;
  const double tiny = patch.forces({1e-9, 0, 0}).x / 1e-9;
  EXPECT_NEAR(patch.forces({1e-7, 0, 0}).x / 1e-7 / tiny, 1.0, 0.002);
  EXPECT_NEAR(-tiny / (patch.G * patch.a * patch.b) / 4.20, 1.0, 0.03);
  for (const contact::Creepage& c :
       {contact::Creepage{0.5, 0, 0}, {-0.5, 0, 0}, {0.3, 0.4, 0}, {0.0, 0.5, 0.0}}) {
    const Forces f = patch.forces(c);
    const double size = std::hypot(c.longitudinal, c.lateral);
    EXPECT_NEAR(f.x, -patch.sliding_force() * c.longitudinal / size, 1e-3 * patch.sliding_force());
    EXPECT_NEAR(f.y, -patch.sliding_force() * c.lateral / size, 1e-3 * patch.sliding_force());
  }
}

TEST(HardRolling, PureSpinFromLinearToFullSlip) {
  const Patch patch;
  const double c = patch.a;
  // Kalker, circle, nu = 0.28 between the tabulated 1.47 (0.25) and 1.63 (0.5).
  const Forces small = patch.forces({0, 0, 1e-6});
  EXPECT_NEAR(-small.y / (patch.G * c * c * c * 1e-6) / 1.49, 1.0, 0.05);
  double moment = 0.0;
  for (double spin = 1e-6; spin < 20.0; spin *= 10.0) {
    const Forces f = patch.forces({0, 0, spin});
    EXPECT_LE(f.y, 0.0) << spin;
    EXPECT_NEAR(f.x, 0.0, 1e-3 * patch.sliding_force()) << spin;
    EXPECT_GT(-f.moment, moment) << spin;
    moment = -f.moment;
  }
  // Sliding about the middle: M_z = mu integral of p r = 3 pi/16 mu F a.
  EXPECT_NEAR(moment / (3.0 * M_PI / 16.0 * patch.sliding_force() * c), 1.0, 0.01);
}

TEST(HardRolling, NarrowPatchesFollowCarterStripByStrip) {
  // a/b = 0.02: plane strain in every strip along rolling, Carter (benchmarks.md, 2).
  Patch patch;
  patch.a = 1.0;
  patch.b = 50.0;
  patch.nx = 40;
  patch.ny = 40;
  const double modulus = patch.material().contact_modulus;
  const double radius = modulus * patch.a / (2.0 * patch.p0);
  for (const double slipping : {0.2, 0.5, 0.8}) {  // (a - a')/a in the middle
    const double xi = patch.friction * slipping * patch.a / radius;
    double strips = 0.0;
    double whole = 0.0;
    for (int j = 0; j < 2000; ++j) {
      const double half = std::sqrt(1.0 - std::pow((j + 0.5) / 2000, 2.0));
      const double stick = std::max(0.0, 1.0 - slipping / half);
      strips += half * half * (1.0 - stick * stick);
      whole += half * half;
    }
    EXPECT_NEAR(-patch.forces({xi, 0, 0}).x / patch.sliding_force(), strips / whole, 0.02)
        << slipping;
  }
}

TEST(HardRolling, LongPatchesHaveKalkersAsymptote) {
  // a/b = 50: C11 = 2 pi / ((L - 2 nu) g) (1 + (3 - ln 4)/(L - 2 nu)), L = ln(16/g^2).
  Patch patch;
  patch.a = 50.0;
  patch.b = 1.0;
  patch.nx = 80;
  patch.ny = 20;
  patch.friction = 1e3;
  const double g = 1.0 / 50.0;
  const double l = std::log(16.0 / (g * g)) - 2.0 * patch.nu;
  const double c11 = 2.0 * M_PI / (l * g) * (1.0 + (3.0 - std::log(4.0)) / l);
  EXPECT_NEAR(-patch.forces({1e-5, 0, 0}).x / (patch.G * 50.0 * 1e-5) / c11, 1.0, 0.06);
  // And slides as a whole at large creepage.
  patch.friction = 0.3;
  EXPECT_NEAR(patch.forces({0.5, 0, 0}).x / -patch.sliding_force(), 1.0, 1e-3);
}

TEST(HardRolling, FewElementsAndStretchedCells) {
  const Patch fine{6.0, 6.0, 48, 48};
  const contact::Creepage creepage{1e-3, -5e-4, 1e-5};
  const Forces right = fine.forces(creepage);
  Patch coarse;
  coarse.nx = coarse.ny = 4;
  EXPECT_NEAR(coarse.forces(creepage).x / right.x, 1.0, 0.1);
  Patch stretched;
  stretched.nx = 12;
  stretched.ny = 96;
  EXPECT_NEAR(stretched.forces(creepage).x / right.x, 1.0, 0.03);
  std::swap(stretched.nx, stretched.ny);
  EXPECT_NEAR(stretched.forces(creepage).x / right.x, 1.0, 0.03);
}

TEST(HardRolling, AnyStartGivesTheSameTractions) {
  const Patch patch;
  const contact::Creepage creepage{-1e-3, 5e-4, 1e-4};
  const TangentialSolution right = patch.solve(creepage);
  const HalfspaceCompliance compliance(patch.grid(), patch.material());
  std::mt19937 engine(1);
  std::normal_distribution<double> normal(0.0, 1e6);
  TangentialField noise{Field::Zero(patch.grid().size()), Field::Zero(patch.grid().size())};
  for (double& value : noise.x) value = normal(engine);
  for (double& value : noise.y) value = normal(engine);
  const TangentialField reversed{-right.traction.x, -right.traction.y};
  const double scale = right.traction.x.cwiseAbs().maxCoeff();
  for (const TangentialField& start : {noise, reversed, right.traction, TangentialField{}}) {
    const TangentialSolution other = contact::solve_tangential(
        compliance.rolling(UpwindOrder::second), patch.problem(creepage), {}, start);
    EXPECT_LT((other.traction.x - right.traction.x).cwiseAbs().maxCoeff(), 1e-4 * scale);
    EXPECT_LT((other.traction.y - right.traction.y).cwiseAbs().maxCoeff(), 1e-4 * scale);
  }
}

TEST(HardRolling, ForcesOfOneNewtonAndTenMeganewtonAreSimilar) {
  // Lengths go as F^(1/3): the same traction coefficient at creepages in that proportion.
  const auto coefficient = [](double force) {
    Case input = thesis_case('b', 16);
    input.load.normal_force = force;
    input.rolling.creepages = {{1e-3 * std::cbrt(force / 50e3), 0.0, 0.0}};
    return halfspace::run_halfspace(input, {}).points[0].traction_coefficient;
  };
  const double usual = coefficient(50e3);
  EXPECT_NEAR(coefficient(1.0) / usual, 1.0, 1e-5);
  EXPECT_NEAR(coefficient(1e7) / usual, 1.0, 1e-5);
}

TEST(HardRolling, TheModelTakesAnyNumberOfElements) {
  Case input = thesis_case('a', 40, {{1e-3, 0.0, 0.0}});
  for (const int across : {1, 2, 3, 4, 5, 7, 19}) {
    input.contact_grid.elements_across = across;
    const contact::PointResult point = halfspace::run_halfspace(input, {}).points[0];
    EXPECT_NEAR(point.normal_force / 50e3, 1.0, 1e-8) << across;
    const double error = std::abs(point.traction_coefficient - 0.21565);
    if (across >= 3) {  // one or two elements carry the force and can promise no more
      EXPECT_LE(error, 0.21565 * std::max(0.01, 0.5 / across)) << across;
      EXPECT_LE(error, point.error_estimate.at("traction_coefficient") + 0.01 * 0.21565) << across;
    }
  }
  input.contact_grid.cell_size = {{0.3, 0.8}};
  const contact::PointResult given = halfspace::run_halfspace(input, {}).points[0];
  EXPECT_NEAR(given.traction_coefficient, 0.21565, 0.005 * 0.55);
  EXPECT_NEAR(given.semi_axis_y, 10.87295, 0.1);
}

TEST(HardRolling, FineGridsTakeFewSteps) {
  struct Row {
    Patch patch;
    contact::Creepage creepage;
    int most;
  };
  // The last: spin and lateral creepage whose pole lies in the patch; rows slip, adhere and slip.
  for (Row row : {Row{{}, {2e-3, 0, 0}, 20},
                  {{}, {0, 2e-3, 0}, 20},
                  {{}, {0, 0, 3e-4}, 20},
                  {{}, {-2e-3, 3e-3, -1e-3}, 20},
                  {{3.5, 5.0}, {1e-3, 1e-3, 3e-4}, 12},
                  {{3.5, 5.0}, {1e-3, -2e-4, 3e-4}, 12},
                  {{7.0, 4.0, 24, 24, 1200.0}, {0.0, -6e-4, 7e-4}, 15}})
    for (const int n : {40, 80, 120}) {
      row.patch.nx = row.patch.ny = n;
      const TangentialSolution s = row.patch.solve(row.creepage);
      EXPECT_LE(s.residual, 1e-6) << row.patch.a << ", " << n;
      EXPECT_LE(s.newton_steps, row.most) << row.patch.a << ", " << n;
    }
}

TEST(HardRolling, DragLeadsToTheSameSolution) {
  Patch patch;
  patch.a = 7.0;
  patch.b = 4.0;
  const HalfspaceCompliance compliance(patch.grid(), patch.material());
  const contact::TangentialOperator& rolling = compliance.rolling(UpwindOrder::second);
  contact::TangentialOptions hasty;
  hasty.patience = 3;  // steps before drag is tried
  for (const contact::Creepage& creepage :
       {contact::Creepage{0.0, -6e-4, 7e-4}, {1e-3, 1e-3, 3e-4}, {2e-3, 0.0, 0.0}}) {
    const TangentialSolution usual = solve_tangential(rolling, patch.problem(creepage));
    const TangentialSolution s = solve_tangential(rolling, patch.problem(creepage), hasty);
    const double largest =
        usual.traction.y.cwiseAbs().maxCoeff() + usual.traction.x.cwiseAbs().maxCoeff();
    EXPECT_LT((s.traction.x - usual.traction.x).cwiseAbs().maxCoeff(), 1e-4 * largest);
    EXPECT_LT((s.traction.y - usual.traction.y).cwiseAbs().maxCoeff(), 1e-4 * largest);
    EXPECT_GT(s.newton_steps, usual.newton_steps);
  }
}

TEST(HardRolling, FailureIsAnErrorThatSaysHowFarItCame) {
  const Patch patch;
  const HalfspaceCompliance compliance(patch.grid(), patch.material());
  contact::TangentialOptions options;
  options.max_newton_steps = 1;
  EXPECT_TRUE(says(refusal<contact::SolveError>([&] {
                     contact::solve_tangential(compliance.rolling(UpwindOrder::second),
                                               patch.problem({1e-3, 0, 1e-4}), options);
                   }),
                   "did not converge", "1 Newton"));
  TangentialProblem wrong = patch.problem({1e-3, 0, 0});
  wrong.pressure[5] = -1.0;
  EXPECT_THROW(contact::solve_tangential(compliance.rolling(UpwindOrder::second), wrong),
               contact::SolveError);
}

}  // namespace
