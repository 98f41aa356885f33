// SPDX-License-Identifier: LGPL-2.1-or-later
// Inertia of steady rolling against closed forms: a spinning ring, a pressure wave that moves over
// a half-space, the spinning disc behind the wheel's expansion; and that it vanishes as V^2
// (numbers that are only recorded: the book).
#include "base/errors.hpp"
#include "base/material.hpp"
#include "fem/discretisation/elastic_problem.hpp"
#include "fem/elasticity/run_level.hpp"
#include "fem/linear/factorisation.hpp"
#include "fem/trace/fem_compliance.hpp"
#include "fem/trace/rolling_inertia.hpp"

#include "support/committed_cases.hpp"
#include "support/fem_elastic_block.hpp"
#include "support/fem_quarter_ring.hpp"
#include "support/fem_test_support.hpp"
#include "support/recorded.hpp"

namespace {

const contact::Material steel{210e3, 0.3, 7.85e-9};

/// A ring in plane strain that spins: with k^2 = rho omega^2 / (lambda + 2 mu), u + r obeys
/// Bessel's equation of order 1 in k r (the load acts on the displaced material), and both faces
/// are free.
class SpinningRing {
 public:
  SpinningRing(const contact::Material& material, double omega, double a, double b)
      : lambda_(fem::lame_lambda(material)), mu_(fem::lame_mu(material)) {
    k_ = omega * std::sqrt(material.density / (lambda_ + 2 * mu_));
    // sigma_r = (lambda + 2 mu) u' + lambda u / r = 0 at a and b for u = c0 J1 + c1 Y1 - r.
    const auto stress = [&](double r, bool second) {
      return (lambda_ + 2 * mu_) * slope(r, second) + lambda_ * value(r, second) / r;
    };
    const double right = 2 * lambda_ + 2 * mu_;
    const double determinant =
        stress(a, false) * stress(b, true) - stress(b, false) * stress(a, true);
    c_[0] = right * (stress(b, true) - stress(a, true)) / determinant;
    c_[1] = right * (stress(a, false) - stress(b, false)) / determinant;
  }
  double displacement(double r) const {
    return c_[0] * value(r, false) + c_[1] * value(r, true) - r;
  }
  double hoop_stress(double r) const {
    const double strain = c_[0] * slope(r, false) + c_[1] * slope(r, true) - 1;
    return lambda_ * strain + (lambda_ + 2 * mu_) * displacement(r) / r;
  }

 private:
  double value(double r, bool second) const {
    return second ? std::cyl_neumann(1.0, k_ * r) : std::cyl_bessel_j(1.0, k_ * r);
  }
  /// f1' = f0 - f1 / x.
  double slope(double r, bool second) const {
    const double zero = second ? std::cyl_neumann(0.0, k_ * r) : std::cyl_bessel_j(0.0, k_ * r);
    return k_ * zero - value(r, second) / r;
  }
  double lambda_, mu_, k_;
  std::array<double, 2> c_{};
};

struct RingErrors {
  double displacement;  ///< L2, relative
  double hoop_stress;   ///< largest at Gauss points of reduced integration, relative
};

RingErrors ring_errors(double poisson_ratio, unsigned int cells) {
  RingOptions options;
  options.cells = cells;
  options.shear = 0.05;
  options.material = {210e3, poisson_ratio, 7.85e-9};
  // rho omega^2 b^2 = 0.03 E: the displaced material adds some 3 % to the load.
  const double omega = std::sqrt(0.03 * 210e3 / 7.85e-9) / options.outer_radius;
  options.motion.rotation[2] = omega;
  const QuarterRing ring(options);
  const auto problem = ring.problem();
  auto u = fem::make_vector(ring.dofs());
  fem::make_factorisation(problem)->solve(u, fem::centrifugal_load(problem));
  const SpinningRing exact(options.material, omega, options.inner_radius, options.outer_radius);
  RingErrors errors{ring.error(u, [&](double r) { return exact.displacement(r); }), 0};
  ring.for_each_stress(problem, u, options.degree, [&](double r, double, double hoop) {
    errors.hoop_stress = std::max(errors.hoop_stress, std::abs(hoop / exact.hoop_stress(r) - 1));
  });
  return errors;
}

TEST(SpinningRing, HasTheClosedFormsDisplacementAndHoopStress) {
  const auto coarse = ring_errors(0.3, 6), fine = ring_errors(0.3, 12);
  record("displacement_error", fine.displacement);
  record("order", std::log2(coarse.displacement / fine.displacement));
  record("hoop_error", fine.hoop_stress);
}

// The inertia term adds 3 % to the displacement: without it the test above would fail by as much.
TEST(SpinningRing, FeelsThatItsMaterialIsDisplaced) {
  const double slow = 1e-3 * std::sqrt(210e3 / 7.85e-9) / 20, fast = std::sqrt(0.03) * 1e3 * slow;
  const SpinningRing linear(steel, slow, 10, 20), softened(steel, fast, 10, 20);
  const double growth =
      softened.displacement(20) / (linear.displacement(20) * fast * fast / slow / slow);
  EXPECT_GT(growth, 1.01);
  EXPECT_LT(growth, 1.05);
}

TEST(SpinningRing, ThatIsThinCarriesRhoOmegaSquaredRSquared) {
  const double omega = 1e3, load = 7.85e-9 * omega * omega * 1e4;
  const SpinningRing ring({210e3, 0.0, 7.85e-9}, omega, 99.9, 100.1);
  // At the displaced radius R (1 + s/E), s being the stress itself.
  EXPECT_NEAR(ring.hoop_stress(100) / (load / (1 - load / 210e3)), 1, 1e-5);
}

/// Deflection under p0 cos(k x) that moves with V over a half-space, relative to p0 / (mu k): with
/// a_p = sqrt(1 - V^2/c_p^2), a_s = sqrt(1 - V^2/c_s^2) it is
/// a_p (1 - a_s^2) / (4 a_p a_s - (1 + a_s^2)^2) (Cole and Huth, J. Appl. Mech. 25 (1958)).
double moving_wave(double speed, double nu) {
  const contact::Material material{210e3, nu, 7.85e-9};
  const double mu = fem::lame_mu(material), m = material.density * speed * speed / mu;
  const double ap = std::sqrt(1 - m * mu / (fem::lame_lambda(material) + 2 * mu));
  const double as = std::sqrt(1 - m);
  return ap * m / (4 * ap * as - (1 + as * as) * (1 + as * as));
}

/// The same in a block half a wave long: where the wave has its crest and trough, symmetry holds.
double computed_wave(double speed, double nu, unsigned int cells) {
  BlockOptions options;
  options.material = {210e3, nu, 7.85e-9};
  options.size = {1, 0.2, 4};
  options.cells = {cells, 1, 4 * cells};
  options.global_refinements = options.local_refinements = 0;
  options.motion.velocity[0] = -speed;
  options.communicator = MPI_COMM_SELF;
  const Block block(options, {{4}, {{0, 0}, {1, 0}, {2, 1}, {3, 1}}});
  const double k = dealii::numbers::PI, p0 = 100;
  const auto load = block.face_load(5, [=](const dealii::Point<3>& p) {
    return dealii::Tensor<1, 3>({0.0, 0.0, -p0 * std::cos(k * p[0])});
  });
  auto u = fem::make_vector(block.dofs());
  fem::make_factorisation(block.problem())->solve(u, load);
  // Amplitude of the loaded shape: the work of the load per its own square, 0.1 mm^2 p0.
  return u * load / (0.1 * p0) / (p0 / (fem::lame_mu(options.material) * k));
}

TEST(MovingPressure, DeflectsAHalfSpaceAsColeAndHuthSay) {
  for (const double nu : {0.3, 0.4999})
    for (const double fraction : {0.0, 0.6, 0.89}) {
      const double speed = fraction * contact::rayleigh_speed({210e3, nu, 7.85e-9});
      record(fmt::format("deflection_{}_{}", nu, fraction), computed_wave(speed, nu, 8));
    }
}

TEST(MovingPressure, ConvergesWithTheOrderOfTheElement) {
  const double speed = 0.8 * contact::rayleigh_speed(steel), exact = moving_wave(speed, 0.3);
  const double coarse = std::abs(computed_wave(speed, 0.3, 2) / exact - 1);
  const double fine = std::abs(computed_wave(speed, 0.3, 4) / exact - 1);
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.6) << coarse << " -> " << fine;  // of energy
}

TEST(MovingPressure, BeyondTheRayleighSpeedLeavesTheStiffnessIndefinite) {
  const double limit = contact::rayleigh_speed(steel);
  EXPECT_THROW(computed_wave(1.05 * limit, 0.3, 4), contact::SolveError);
}

contact::SurfaceField respond(double speed, const contact::SurfaceField& traction,
                              const contact::ContactGrid& grid) {
  auto options = small_options();
  options.cell_size = 2;
  options.fine_half_length = options.fine_half_width = 4;
  options.speed = speed;
  const fem::Body wheel(wheel_shape(60, 80), steel, options, MPI_COMM_SELF);
  const fem::Body rail(rail_shape(100), steel, options, MPI_COMM_SELF);
  const auto wheel_solver = fem::make_factorisation(wheel.problem());
  const auto rail_solver = fem::make_factorisation(rail.problem());
  return fem::FemCompliance({&wheel, wheel_solver.get()}, {&rail, rail_solver.get()},
                            common_surface(wheel.shape(), rail.shape()), grid)
      .apply(traction);
}

contact::SurfaceField operator-(const contact::SurfaceField& a, const contact::SurfaceField& b) {
  return {a.x - b.x, a.y - b.y, a.n - b.n};
}

TEST(RollingInertia, VanishesAsTheSquareOfTheSpeed) {
  const auto grid = contact::ContactGrid::centred(4, 4, 2, 2);
  const auto p = random_field(grid, 1);
  const auto rest = respond(0, p, grid);
  const auto slow = respond(1e5, p, grid) - rest, fast = respond(2e5, p, grid) - rest;
  const double size = std::sqrt(dot(slow, slow));
  record("ratio", std::sqrt(dot(fast, fast)) / size);
  const double relative = size / std::sqrt(dot(rest, rest));
  // rho V^2 / G = 1e-3 times something of the order of one.
  EXPECT_GT(relative, 1e-4);
  EXPECT_LT(relative, 1e-2);
}

TEST(RollingInertia, LeavesTheComplianceSymmetricAndPositive) {
  const auto grid = contact::ContactGrid::centred(4, 4, 2, 2);
  const auto p = random_field(grid, 1), q = random_field(grid, 2);
  const double speed = 0.6 * contact::rayleigh_speed(steel);
  const auto ap = respond(speed, p, grid), aq = respond(speed, q, grid);
  // Areas of curved elements differ by 1e-3: weight as the compliance's inner product does.
  const contact::ContactSurface surface = common_surface(wheel_shape(60, 80), rail_shape(100));
  const auto stretch = contact::patch_shape(surface, grid).stretch;
  const auto product = [&](const contact::SurfaceField& a, const contact::SurfaceField& b) {
    return (stretch.array() *
            (a.x.array() * b.x.array() + a.y.array() * b.y.array() + a.n.array() * b.n.array()))
        .sum();
  };
  EXPECT_NEAR(product(p, aq), product(q, ap), 1e-10 * product(p, ap));
  EXPECT_GT(product(p, ap), 0);
}

TEST(WheelExpansion, IsThatOfASpinningDiscWhateverTheSegment) {
  const double radius = 405, speed = 5e4;
  const double exact =
      steel.density * speed * speed * radius * (1 - 0.3) / (4 * steel.young_modulus);
  const auto grid = contact::ContactGrid::centred(4, 4, 4, 4);
  for (const double extent : {40.0, 80.0}) {
    fem::BodyOptions options;
    options.cell_size = 4;
    options.fine_half_length = options.fine_half_width = 8;
    options.extent = extent;
    options.speed = speed;
    options.half = true;
    const auto shape = wheel_shape(radius, contact::infinity);
    const fem::Body wheel(shape, steel, options, MPI_COMM_SELF);
    const auto solver = fem::make_factorisation(wheel.problem());
    const auto expansion =
        fem::wheel_expansion(wheel, *solver, common_surface(shape, rail_shape(contact::infinity)),
                             grid, contact::UpwindOrder::second);
    // The disc has stresses of this order on its rim, off the middle plane.
    const double neglected = std::pow(extent / radius, 2);
    EXPECT_NEAR(-expansion.distance.mean() / exact, 1, neglected) << extent;
    EXPECT_NEAR(expansion.slip.x.mean() * radius / -exact, 1, neglected) << extent;
    EXPECT_LT(expansion.slip.y.cwiseAbs().maxCoeff(), neglected * exact / radius) << extent;
  }
}

std::vector<contact::PointResult> case_a(double speed, const std::vector<double>& creepages) {
  contact::Case input = committed_case('a', creepages);
  input.rolling.speed = speed;
  input.inertia = true;
  input.body_extent = 60;
  return fem::run_level(input, {1.88, "", false}, {}).points;
}

// At 50 m/s the wheel's growth is what is felt: the axle stands higher by it, and the force at
// given creepage is that of a wheel with a longer circumference.
TEST(RollingInertia, InContactIsMostlyTheGrowthOfTheWheel) {
  const double speed = 5e4, radius = 405, xi = 0.001;
  const double growth = steel.density * speed * speed * radius * 0.7 / (4 * steel.young_modulus);
  const auto rest = case_a(0, {xi, xi - growth / radius});
  const auto moving = case_a(speed, {xi}).front();
  EXPECT_NEAR((rest[0].approach - moving.approach) / growth, 1, 0.02);
  EXPECT_NEAR((moving.traction_coefficient - rest[0].traction_coefficient) /
                  (rest[1].traction_coefficient - rest[0].traction_coefficient),
              1, 0.1);
  EXPECT_NEAR(moving.max_pressure / rest[0].max_pressure, 1, 5e-4);
}

}  // namespace
