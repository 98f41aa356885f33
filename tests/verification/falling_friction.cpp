// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction that falls with the slip velocity, its memory, and a layer between wheel and rail: the
// traction curve of a measured locomotive as CONTACT prints it (E. A. H. Vollebregt, user guide,
// section 5.9; open version r2707, cases 31 to 60), full sliding in closed form, a soft layer as
// Winkler's, and a line contact with a layer by collocation.
#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"
#include "contact/scene/scene.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/curvature/curved_compliance.hpp"
#include "halfspace/elasticity/preconditioned_elasticity.hpp"
#include "halfspace/model/halfspace_model.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

#include "support/half_space_models.hpp"
#include "support/recorded.hpp"
#include "support/thesis_cases.hpp"

namespace {

constexpr double locomotive_modulus = 82000.0, poisson = 0.28, force = 106.7e3;

/// Eurosprinter (Polach, Wear 258 (2005)): A is given, 8e-4 per mm, and a/b = 1/2; the load then
/// says how large the ellipse is.
Case locomotive(const std::vector<double>& creepages) {
  Case input;
  input.file = "test.toml";
  input.load.normal_force = force;
  input.wheel.material =
      input.rail.material = {2.0 * locomotive_modulus * (1.0 + poisson), poisson};
  const double modulus = locomotive_modulus / (1.0 - poisson);
  const auto curvatures = [&](double a, double b) {
    return halfspace::hertz_curvatures({a, b, 1.5 * force / (M_PI * a * b), 0.0, force}, modulus);
  };
  const double a = std::cbrt(curvatures(1.0, 2.0).A / 8e-4);
  const contact::Curvatures c = curvatures(a, 2.0 * a);
  input.undeformed_distance.quadratic = {c.A, c.B};
  input.contact_grid.extent = {2.2 * a, 4.4 * a};
  input.contact_grid.cell_size = {2.2 * a / 48, 4.4 * a / 44};
  input.friction_coefficient = 0.33;
  input.rolling.speed = 10e3;
  input.rolling.creepages = along(creepages);
  return input;
}

void add_falling_friction(Case& input) {
  input.friction_fall.shape = contact::FallShape::exponential;
  input.friction_fall.kinetic_coefficient = 0.14;
  input.friction_fall.half_velocity = 1250.0;
  input.friction_fall.memory_distance = 3e-3;
  input.friction_fall.memory_velocity = 1.0;
}

void add_layer(Case& input) {
  input.layer = contact::Layer{1.25, 8200.0};
}

TEST(FallingFriction, TractionCurveOfContactWithLayerAndMemory) {
  const std::vector<double> creepages{1e-5,  0.001, 0.002, 0.003, 0.004, 0.005, 0.006, 0.007,
                                      0.008, 0.009, 0.010, 0.011, 0.012, 0.013, 0.014, 0.015,
                                      0.016, 0.018, 0.020, 0.030, 0.040, 0.050, 0.075, 0.100,
                                      0.125, 0.150, 0.175, 0.200, 0.225, 0.250};
  const std::vector<double> printed{
      0.001869, 0.1825, 0.3495, 0.4928, 0.6101, 0.7029, 0.7739, 0.8268, 0.8652, 0.8928,
      0.9119,   0.9251, 0.9340, 0.9395, 0.9426, 0.9442, 0.9445, 0.9429, 0.9393, 0.9138,
      0.8873,   0.8622, 0.8053, 0.7559, 0.7129, 0.6755, 0.6430, 0.6146, 0.5900, 0.5685};
  Case input = locomotive(creepages);
  add_falling_friction(input);
  add_layer(input);
  input.rolling.upwind_order = contact::UpwindOrder::first;
  const ModelResult result = halfspace::run_halfspace(input, {});
  double worst = 0.0;
  for (std::size_t k = 0; k < printed.size(); ++k) {
    const double ours = -result.points[k].longitudinal_force / (0.33 * force);
    EXPECT_NEAR(ours / printed[k], 1.0, 3e-3) << creepages[k];
    worst = std::max(worst, std::abs(ours / printed[k] - 1.0));
  }
  record("largest_deviation_from_contact", worst);
}

TEST(FallingFriction, FullSlidingHasTheFrictionOfItsVelocity) {
  // Elastic strains are small beside the creepage: mu_s(V xi)/mu_s(0), by the formula of the law.
  Case input = locomotive({0.1, 0.25});
  add_falling_friction(input);
  input.friction_fall.memory_distance = 0.0;
  const ModelResult result = halfspace::run_halfspace(input, {});
  for (const PointResult& point : result.points) {
    const double s = 10e3 * point.creepage.longitudinal;
    const double expected = 0.14 + 0.19 * std::exp2(-s / 1250.0);
    EXPECT_NEAR(-point.longitudinal_force / force, expected, 5e-3 * expected);
    EXPECT_EQ(point.adhesion_area, 0.0);
  }
}

TEST(FallingFriction, WithNothingToFallIsCoulombs) {
  Case input = locomotive({0.002, 0.004});
  const ModelResult coulomb = halfspace::run_halfspace(input, {});
  add_falling_friction(input);
  input.friction_fall.kinetic_coefficient = 0.33;
  const ModelResult falling = halfspace::run_halfspace(input, {});
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_NEAR(falling.points[k].longitudinal_force / coulomb.points[k].longitudinal_force, 1.0,
                1e-6);
}

TEST(FallingFriction, MemoryConvergesWithSecondOrder) {
  std::vector<double> forces;
  for (const int across : {12, 24, 48, 96}) {
    Case input = locomotive({0.008});
    add_falling_friction(input);
    input.friction_fall.half_velocity = 60.0;  // falls by half within the slip area
    input.contact_grid.extent.reset();
    input.contact_grid.cell_size.reset();
    input.contact_grid.elements_across = across;
    forces.push_back(halfspace::run_halfspace(input, {}).points[0].longitudinal_force);
    record("force_at_" + std::to_string(across), forces.back());
  }
  const double order = std::log2((forces[1] - forces[0]) / (forces[2] - forces[1]));
  record("order", order);
  EXPECT_GT(order, 1.5);
  EXPECT_NEAR(forces[2] / forces[3], 1.0, 1e-3);
}

TEST(FallingFriction, TransientRollingSettlesToTheSteadyState) {
  Case input = locomotive({0.008});
  add_falling_friction(input);
  add_layer(input);
  input.contact_grid.extent.reset();
  input.contact_grid.cell_size.reset();
  input.contact_grid.elements_across = 24;
  const double steady = halfspace::run_halfspace(input, {}).points[0].longitudinal_force;
  roll_on(input, 40, 0.5, {0.008, 0.0, 0.0});
  const ModelResult result = halfspace::run_halfspace(input, {});
  record("settled_over_steady", result.points.back().longitudinal_force / steady);
  // The steady difference is fitted to the leading edge, which steps are not.
  EXPECT_NEAR(result.points.back().longitudinal_force / steady, 1.0, 0.01);
}

TEST(FallingFriction, OfCurvedBodiesHoldsTheLawAtEveryElement) {
  // Any elasticity beyond the half-space goes through the correction of its defect.
  Case input = locomotive({0.004, 0.03});
  input.undeformed_distance.quadratic.reset();
  input.contact_grid = {};
  input.contact_grid.elements_across = 20;
  input.wheel.rolling_radius = 625.0;
  input.rail.transverse_radius = 1776.8;
  add_falling_friction(input);
  input.friction_fall.memory_distance = 0.0;
  add_layer(input);
  const ModelResult half = halfspace::run_halfspace(input, {});
  halfspace::GridElasticity curved;
  curved.model = "curved";
  curved.make = [](const contact::Scene& scene, const contact::ChartedGeometry&,
                   const contact::ContactGrid& grid) -> std::unique_ptr<contact::Elasticity> {
    return std::make_unique<halfspace::PreconditionedElasticity>(
        scene, grid, std::make_unique<halfspace::CurvedCompliance>(scene, grid));
  };
  const ModelResult result = halfspace::run_halfspace(input, {}, nullptr, curved);
  for (std::size_t k = 0; k < 2; ++k) {
    const PointResult& point = result.points[k];
    // A shortened wheel shifts the creep curve by some 1e-5 of creepage.
    EXPECT_NEAR(point.longitudinal_force / half.points[k].longitudinal_force, 1.0, 0.01);
    int slipping = 0;
    for (int e = 0; e < result.grid.size(); ++e) {
      const contact::ContactFields& f = point.fields;
      if (f.state[static_cast<std::size_t>(e)] != contact::ElementState::slip) continue;
      ++slipping;
      const double s = 10e3 * std::hypot(f.slip.x[e], f.slip.y[e]);
      const double bound = (0.14 + 0.19 * std::exp2(-s / 1250.0)) * f.traction.n[e];
      EXPECT_NEAR(std::hypot(f.traction.x[e], f.traction.y[e]), bound, 1e-3 * bound);
    }
    EXPECT_GT(slipping, 20);
  }
}

TEST(Layer, SoftIsWinklers) {
  // F_x = (8/3) a^2 b xi G_3/h_3 of the Hertz ellipse, bodies a million times stiffer. In full
  // adhesion tractions are largest at the trailing edge, where elements are in contact or not.
  const auto ratio = [](int across) {
    Case input = locomotive({1e-6});
    input.contact_grid.extent.reset();
    input.contact_grid.cell_size.reset();
    input.contact_grid.elements_across = across;
    input.layer = contact::Layer{1000.0, 8.2};
    const PointResult point = halfspace::run_halfspace(input, {}).points[0];
    const double a = point.semi_axis_x, b = point.semi_axis_y;
    const double part = -point.longitudinal_force / (8.0 / 3.0 * a * a * b * 1e-6 * 8.2 / 1000.0);
    record("force_over_winklers_at_" + std::to_string(across), part);
    EXPECT_NEAR(part, 1.0,
                point.error_estimate.at("longitudinal_force") / std::abs(point.longitudinal_force));
    return part;
  };
  EXPECT_NEAR(ratio(40), 1.0, 0.02);
  EXPECT_NEAR(ratio(160), 1.0, 3e-3);
}

TEST(Layer, AndBodiesAreInSeriesAtSmallCreepage) {
  // CONTACT's first-order numbers; and compliances of both alone, added: an estimate, since their
  // tractions differ in shape.
  const auto run = [](bool layer) {
    Case input = locomotive({1e-5});
    input.rolling.upwind_order = contact::UpwindOrder::first;
    if (layer) add_layer(input);
    return -halfspace::run_halfspace(input, {}).points[0].longitudinal_force;
  };
  EXPECT_NEAR(run(false), 247.0, 0.3);
  EXPECT_NEAR(run(true), 65.81, 0.1);
  EXPECT_NEAR(run(true), 1.0 / (1.0 / 247.0 + 1.0 / 87.6), 0.03 * 64.7);
}

TEST(Fastsim, TakesALayerInSeriesAndFallingFriction) {
  const auto force_of = [](const std::string& model, const Case& input) {
    const ModelResult result =
        rollfem::testing::half_space_models().run(model, contact::Scene(input), {});
    std::vector<double> forces;
    for (const PointResult& point : result.points) forces.push_back(-point.longitudinal_force);
    return forces;
  };
  // Brushes of the bodies and of the layer in series, each with its closed form.
  Case input = locomotive({1e-5});
  const double bodies = force_of("linear", input)[0];
  const PointResult patch =
      rollfem::testing::half_space_models().run("hertz", contact::Scene(input), {}).points[0];
  const double a = patch.semi_axis_x, b = patch.semi_axis_y;
  const double layer = 8.0 / 3.0 * a * a * b * 1e-5 * 8200.0 / 1.25;
  add_layer(input);
  EXPECT_NEAR(force_of("fastsim", input)[0] * (1.0 / bodies + 1.0 / layer), 1.0, 1e-3);
  // Full sliding; the parabola of FASTSIM carries the same force as Hertz's pressure.
  input = locomotive({0.05, 0.1, 0.25});
  add_layer(input);
  add_falling_friction(input);
  const std::vector<double> sliding = force_of("fastsim", input);
  for (std::size_t k = 0; k < sliding.size(); ++k) {
    const double s = 10e3 * input.rolling.creepages[k].longitudinal;
    const double expected = 0.14 + 0.19 * std::exp2(-s / 1250.0);
    EXPECT_NEAR(sliding[k] / force, expected, 0.01 * expected);
  }
  for (const char* name : {"linear", "vermeulen-johnson", "carter", "fastrip", "strip"})
    EXPECT_THROW(rollfem::testing::half_space_models().check(contact::Scene(input), name),
                 contact::InputError);
  input.layer.reset();
  for (const char* name : {"linear", "vermeulen-johnson", "carter", "fastrip", "strip"})
    EXPECT_THROW(rollfem::testing::half_space_models().check(contact::Scene(input), name),
                 contact::InputError);
}

TEST(Fastsim, RemembersFrictionAlongEveryRow) {
  // Slip is the rigid one where everything slides: mu_s + (mu - mu_s) exp(-xi d/d_c), d behind the
  // leading edge, under Hertz's pressure. Half-spaces slide a little less near that edge.
  Case input = locomotive({0.1});
  add_falling_friction(input);
  input.friction_fall.half_velocity = 500.0;
  input.friction_fall.memory_distance = 0.5;
  input.fastsim.bound = contact::BoundShape::elliptic;
  const double there = 0.14 + 0.19 * std::exp2(-10e3 * 0.1 / 500.0);
  for (const char* model : {"fastsim", "halfspace"}) {
    const PointResult point =
        rollfem::testing::half_space_models().run(model, contact::Scene(input), {}).points.front();
    double sum = 0.0, all = 0.0;
    for (double v = -0.995; v < 1.0; v += 0.01)
      for (double u = -0.995; u < 1.0; u += 0.01) {
        const double row = std::sqrt(1.0 - v * v);
        const double pressure = row * std::sqrt(1.0 - u * u) * row;
        const double slid = 0.1 * point.semi_axis_x * row * (1.0 - u);
        sum += pressure * (there + (0.33 - there) * std::exp(-slid / 0.5));
        all += pressure;
      }
    record(std::string("remembered_") + model, -point.longitudinal_force / force);
    EXPECT_NEAR(-point.longitudinal_force / force, sum / all, 0.01 * sum / all) << model;
    EXPECT_GT(sum / all, 1.2 * there);
  }
}

/// CONTACT's modified FASTSIM (tractcurv, 91 to 120), on its elements: -F_x/(mu F_n). 0.003 leaves
/// room for its flexibilities, from Kalker's printed table.
TEST(Fastsim, ReducedSlopeIsThatOfContact) {
  const std::vector<std::pair<double, double>> curve{
      {1e-5, 0.003526}, {0.001, 0.2721}, {0.002, 0.4388}, {0.003, 0.5477}, {0.005, 0.6757},
      {0.007, 0.7441},  {0.010, 0.7979}, {0.014, 0.8298}, {0.018, 0.8420}, {0.022, 0.8451},
      {0.030, 0.8390},  {0.040, 0.8215}, {0.065, 0.7654}, {0.100, 0.6874}, {0.150, 0.5970},
      {0.200, 0.5329},  {0.250, 0.4877}};
  Case input = locomotive({});
  for (const auto& row : curve) input.rolling.creepages.push_back({row.first, 0.0, 0.0});
  input.friction_coefficient = 0.36;
  add_falling_friction(input);
  input.friction_fall.kinetic_coefficient = 0.1368;
  input.friction_fall.half_velocity = 990.0;
  input.fastsim.elements = contact::FastsimElements::grid;
  input.fastsim.strips = 40;
  input.fastsim.strip_elements = 44;
  input.fastsim.slope_reduction = {0.54, 0.02, 0.62};
  const ModelResult result =
      rollfem::testing::half_space_models().run("fastsim", contact::Scene(input), {});
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const double coefficient = result.points[k].traction_coefficient / 0.36;
    EXPECT_NEAR(coefficient, curve[k].second, 0.003) << curve[k].first;
    record(fmt::format("reduced_{:g}", curve[k].first), coefficient);
  }
  EXPECT_NEAR(result.points[0].traction_coefficient / 0.36, 0.003526, 0.01 * 0.003526);
}

/// Full adhesion of a line contact with a layer: f of p = -s a f/c satisfies
/// -f' + lambda PV int f(t)/(x - t) dt = 1 on (-1, 1), f(1) = 0, with lambda = 2 (1 - nu) a/(pi G
/// c) and c = h_3/G_3. By collocation: f linear between nodes that crowd at the ends, the equation
/// in the middles. Returns the integral of f: 2 for bodies that are rigid, 1/lambda without a
/// layer.
double adhesion_integral(double lambda, int n) {
  Eigen::VectorXd x(n + 1);
  for (int i = 0; i <= n; ++i) x[i] = -std::cos(M_PI * i / n);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n + 1);
  for (int i = 0; i < n; ++i) {
    const double middle = 0.5 * (x[i] + x[i + 1]);
    matrix(i, i) += 1.0 / (x[i + 1] - x[i]);
    matrix(i, i + 1) -= 1.0 / (x[i + 1] - x[i]);
    for (int j = 0; j < n; ++j) {
      const double h = x[j + 1] - x[j];
      const double zeroth = std::log(std::abs((middle - x[j]) / (middle - x[j + 1])));
      const double first = middle * zeroth - h;
      matrix(i, j) += lambda * (x[j + 1] * zeroth - first) / h;
      matrix(i, j + 1) += lambda * (first - x[j] * zeroth) / h;
    }
  }
  Eigen::VectorXd f = Eigen::VectorXd::Zero(n + 1);
  f.head(n) = matrix.leftCols(n).partialPivLu().solve(Eigen::VectorXd::Ones(n));
  double sum = 0.0;
  for (int i = 0; i < n; ++i) sum += 0.5 * (f[i] + f[i + 1]) * (x[i + 1] - x[i]);
  return sum;
}

TEST(Layer, OfALineContactInFullAdhesion) {
  EXPECT_NEAR(adhesion_integral(1e-6, 200), 2.0, 1e-5);
  EXPECT_NEAR(1e3 * adhesion_integral(1e3, 400), 1.0, 2e-3);  // Carter's slope
  for (const double lambda : {0.1, 1.0, 10.0}) {
    // a = 1 mm (line_contact.cpp).
    const double compliance = 2.0 * (1.0 - poisson) / (M_PI * locomotive_modulus * lambda);
    const double creepage = 1e-7;
    const auto at = [&](int across) {
      const std::string text = fmt::format(
          "[load]\nnormal_force = 178.89625\n[friction]\ncoefficient = 0.3\n[layer]\n"
          "thickness = {:.15g}\nshear_modulus = 82e3\n"
          "[wheel]\nrolling_radius = 500.0\nyoung_modulus = 209920.0\npoisson_ratio = 0.28\n"
          "[rail]\nyoung_modulus = 209920.0\npoisson_ratio = 0.28\n[geometry]\nshape = \"line\"\n"
          "[rolling]\nlongitudinal_creepage = {}\n[contact_grid]\nelements_across = {}\n",
          82e3 * compliance, creepage, across);
      const contact::Scene scene(contact::parse_case(text, "line.toml"));
      return -rollfem::testing::half_space_models()
                  .run("halfspace", scene, {})
                  .points.at(0)
                  .longitudinal_force;
    };
    const double exact = creepage / compliance * adhesion_integral(lambda, 400);
    record(fmt::format("error_of_lambda_{}_at_40", lambda), at(40) / exact - 1.0);
    record(fmt::format("error_of_lambda_{}_at_80", lambda), at(80) / exact - 1.0);
    EXPECT_NEAR(at(40) / exact, 1.0, 5e-3);
    EXPECT_NEAR(at(80) / exact, 1.0, 2e-3);
  }
}

}  // namespace
