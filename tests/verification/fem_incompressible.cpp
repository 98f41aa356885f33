// SPDX-License-Identifier: LGPL-2.1-or-later
// Nearly incompressible bodies: orders at nu = 0.4999 where plain elements lock, a thick cylinder
// and its stresses, contact of rubber-like bodies against the half-space.
#include "case/reading/case_reader.hpp"
#include "fem/discretisation/elastic_problem.hpp"
#include "fem/elasticity/run_level.hpp"
#include "fem/linear/factorisation.hpp"
#include "fem/trace/fem_compliance.hpp"

#include "support/fem_elastic_block.hpp"
#include "support/fem_fields.hpp"
#include "support/fem_quarter_ring.hpp"
#include "support/fem_test_support.hpp"
#include "support/half_space_models.hpp"
#include "support/model_keys.hpp"
#include "support/recorded.hpp"

namespace {

constexpr double nearly = 0.4999;

/// u = curl(0, 0, psi), psi = 1e-3 prod sin^2(pi x_d): no dilatation, zero on the unit cube's
/// faces.
struct Swirl {
  static dealii::Tensor<1, 3> displacement(const dealii::Point<3>& p) {
    const auto s = squares(p), d = slopes(p);
    return dealii::Tensor<1, 3>({1e-3 * s[0] * d[1] * s[2], -1e-3 * d[0] * s[1] * s[2], 0.0});
  }
  static dealii::Tensor<2, 3> gradient(const dealii::Point<3>& p) {
    const auto s = squares(p), d = slopes(p);
    std::array<double, 3> c{};
    for (unsigned int i = 0; i < 3; ++i) c[i] = 2 * pi * pi * std::cos(2 * pi * p[i]);
    dealii::Tensor<2, 3> g;
    g[0] =
        1e-3 * dealii::Tensor<1, 3>({d[0] * d[1] * s[2], s[0] * c[1] * s[2], s[0] * d[1] * d[2]});
    g[1] =
        -1e-3 * dealii::Tensor<1, 3>({c[0] * s[1] * s[2], d[0] * d[1] * s[2], d[0] * s[1] * d[2]});
    return g;
  }

 private:
  static constexpr double pi = dealii::numbers::PI;
  static std::array<double, 3> squares(const dealii::Point<3>& p) {
    std::array<double, 3> s{};
    for (unsigned int i = 0; i < 3; ++i) s[i] = std::pow(std::sin(pi * p[i]), 2);
    return s;
  }
  static std::array<double, 3> slopes(const dealii::Point<3>& p) {
    std::array<double, 3> d{};
    for (unsigned int i = 0; i < 3; ++i) d[i] = pi * std::sin(2 * pi * p[i]);
    return d;
  }
};

/// L2 error of the displacement on skew cells, relative.
double swirl_error(unsigned int degree, int refinements, double nu, bool projected) {
  BlockOptions options;
  options.degree = degree;
  options.cells = {2, 2, 2};
  options.size = {1, 1, 1};
  options.global_refinements = refinements;
  options.local_refinements = 0;
  options.bend = 0.12;
  options.material = {1.0, nu};
  options.project_dilatation = projected;
  options.communicator = MPI_COMM_SELF;
  const Block block(options, {{0, 1, 2, 3, 4, 5}, {}});
  const auto problem = block.problem();
  auto u = fem::make_vector(block.dofs());
  fem::make_factorisation(problem)->solve(
      u, load_of_stress(problem, [&](const auto& place) {
        // No dilatation: the same at any Poisson's ratio.
        return stress_of(Swirl::gradient(place), {options.material.young_modulus / (1 + nu), 0.0});
      }));
  return displacement_error(problem, u, Swirl::displacement);
}

TEST(NearlyIncompressible, QuadraticElementsKeepTheirOrderWherePlainOnesLock) {
  const double coarse = swirl_error(2, 1, nearly, true), fine = swirl_error(2, 2, nearly, true);
  const double locked = swirl_error(2, 2, nearly, false);
  EXPECT_NEAR(std::log2(coarse / fine), 3.0, 0.4) << coarse << " -> " << fine;
  EXPECT_LT(fine, 0.01);
  EXPECT_GT(locked, 0.01);
}

TEST(NearlyIncompressible, LinearElementsKeepTheirOrderWherePlainOnesLock) {
  const double coarse = swirl_error(1, 2, nearly, true), fine = swirl_error(1, 3, nearly, true);
  const double locked = swirl_error(1, 3, nearly, false);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.4) << coarse << " -> " << fine;
  EXPECT_LT(fine, 0.1);
  EXPECT_GT(locked, 0.1);
}

/// Lame's thick cylinder under inner pressure p, plane strain: sigma_r = A - B/r^2,
/// u = (1 + nu)/E ((1 - 2 nu) A r + B/r), A = p a^2/(b^2 - a^2), B = A b^2.
struct ThickCylinder {
  double displacement;  ///< L2 error, relative
  double stress;        ///< largest error of the radial stress at Gauss points over p
  double plain_stress;  ///< the same with the dilatation of the displacement itself
};

ThickCylinder thick_cylinder(unsigned int degree, unsigned int cells, bool projected) {
  RingOptions options;
  options.degree = degree;
  options.cells = cells;
  options.shear = 0.06;
  options.material = {10.0, nearly};
  options.project_dilatation = projected;
  const QuarterRing ring(options);
  const double p = 1, a = options.inner_radius, b = options.outer_radius;
  const double A = p * a * a / (b * b - a * a), B = A * b * b;
  auto u = fem::make_vector(ring.dofs());
  fem::make_factorisation(ring.problem())->solve(u, ring.inner_pressure(p));
  ThickCylinder result{
      ring.error(
          u, [&](double r) { return (1 + nearly) / 10.0 * ((1 - 2 * nearly) * A * r + B / r); }),
      0, 0};
  auto unprojected = ring.problem();
  unprojected.project_dilatation = false;
  const auto worst = [&](const fem::ElasticProblem& problem) {
    double most = 0;
    ring.for_each_stress(problem, u, degree, [&](double r, double radial, double) {
      most = std::max(most, std::abs(radial - (A - B / (r * r))) / p);
    });
    return most;
  };
  result.stress = worst(ring.problem());
  result.plain_stress = worst(unprojected);
  return result;
}

TEST(NearlyIncompressible, ThickCylinderHasLamesDisplacementAndStress) {
  for (const unsigned int degree : {1U, 2U}) {
    const unsigned int cells = degree == 1 ? 8 : 4;
    const auto projected = thick_cylinder(degree, cells, true);
    const auto plain = thick_cylinder(degree, cells, false);
    const double displacement = degree == 1 ? 0.01 : 1e-3, stress = degree == 1 ? 0.05 : 0.01;
    EXPECT_LT(projected.displacement, displacement) << "degree " << degree;
    EXPECT_LT(projected.stress, stress) << "degree " << degree;
    EXPECT_GT(plain.displacement, displacement) << "degree " << degree;
    record(fmt::format("projected_degree_{}", degree), projected.displacement);
    record(fmt::format("plain_degree_{}", degree), plain.displacement);
    EXPECT_GT(plain.stress, stress) << "degree " << degree;
    // At the one Gauss point of degree 1 the dilatation is its mean already.
    if (degree == 2) {
      EXPECT_GT(projected.plain_stress, stress);
    }
  }
}

/// A ball of 50 mm whose patch has a radius of 0.5 mm: strains are small.
contact::Case rubber_ball() {
  return contact::parse_case(R"(
[load]
normal_force = 0.0222
[friction]
coefficient = 0.5
[wheel]
rolling_radius = 50.0
transverse_radius = 50.0
young_modulus = 10.0
poisson_ratio = 0.4999
[rail]
transverse_radius = inf
young_modulus = 10.0
poisson_ratio = 0.4999
[rolling]
longitudinal_creepage = [0.0025, 0.0]
[contact_grid]
elements_across = 40
[fem]
extent = 3.0
)",
                             "rubber.toml");
}

// Five quadratic cells to the radius of the patch.
TEST(NearlyIncompressible, RubberBallPressesAndRollsAsTheHalfSpaceSays) {
  auto input = rubber_ball();
  input.output.body_fields = contact::BodyFields::last;
  const auto level = fem::run_level(input, {0.1, "", true}, {});
  const auto half = rollfem::testing::half_space_models().run("halfspace", input, {});
  const double p0 = half.points[0].max_pressure;
  EXPECT_NEAR(level.points[0].max_pressure / p0, 1, 0.01);
  for (int k = 0; k < 2; ++k)
    EXPECT_NEAR(level.points[k].traction_coefficient, half.points[k].traction_coefficient,
                0.01 * 0.5);
  // Under the middle of the patch an incompressible body is in hydrostatic compression p0.
  const contact::BodyField rail = level.body_at(1, 1);
  int found = 0;
  for (std::size_t i = 0; i < rail.points.size(); ++i) {
    const auto& x = rail.points[i];
    if (std::hypot(x[0], x[1], x[2]) > 1e-9) continue;
    ++found;
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(-rail.stress[i][k] / p0, 1, 0.05) << "component " << k;
  }
  EXPECT_EQ(found, 1);
}

}  // namespace
