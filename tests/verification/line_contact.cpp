// SPDX-License-Identifier: LGPL-2.1-or-later
// Line contact as a shape of the models halfspace, hertz and carter, from case file to result:
// Hertz and Carter in closed form, antiplane shear, Spence's unlike bodies
// (reference/benchmarks.md, 2, 4 and 5), and the quantities relative to the reference distance.
// Forces of Carter's, of Bentall and Johnson's and of Nowell and Hills's rollers: the book.
#include "case/reading/case_reader.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "result/bars.hpp"
#include "scene/scene.hpp"
#include "theories/carter.hpp"

#include <fmt/format.h>

#include "support/half_space_models.hpp"
#include "support/temporary_folder.hpp"

namespace {

constexpr double modulus = 82000.0 / 0.72;  // E* of steel on steel, MPa
constexpr double friction = 0.3;

/// Steel, R = 500 mm, a = 1 mm.
std::string steel(const std::string& rolling, const std::string& more = "") {
  return "[load]\nnormal_force = 178.89625\n[friction]\ncoefficient = 0.3\n"
         "[wheel]\nrolling_radius = 500.0\nyoung_modulus = 209920.0\npoisson_ratio = 0.28\n"
         "[rail]\nyoung_modulus = 209920.0\npoisson_ratio = 0.28\n"
         "[geometry]\nshape = \"line\"\n[rolling]\n" +
         rolling + more;
}

ModelResult run(const std::string& text, const std::string& model = "halfspace") {
  return rollfem::testing::half_space_models().run(
      model, contact::Scene(contact::parse_case(text, "line.toml")), {});
}

const std::vector<double> parts{0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 0.95, 1.1};  // of saturation

std::string creepages(const char* direction) {
  std::string list;
  for (const double part : parts)
    list += fmt::format("{}{:.12g}", list.empty() ? "" : ", ", part * friction / 500.0);
  return fmt::format("{}_creepage = [{}]\n", direction, list);
}

std::string across(int elements) {
  return fmt::format("[contact_grid]\nelements_across = {}\n", elements);
}

theories::CarterContact carter_contact(double stiffness) {
  return {1.0, stiffness / 1000.0, friction, stiffness};
}

TEST(LineContact, IsHertzsWithinItsBars) {
  const halfspace::LineHertz exact = halfspace::line_hertz(500.0, modulus, 178.89625, 500.0);
  EXPECT_NEAR(exact.half_width, 1.0, 1e-6);
  EXPECT_NEAR(exact.max_pressure, 113.889, 1e-3);
  const PointResult point = run(steel("longitudinal_creepage = 0.0\n")).points.at(0);
  EXPECT_NEAR(point.max_pressure, exact.max_pressure, point.error_estimate.at("max_pressure"));
  EXPECT_NEAR(point.max_pressure / exact.max_pressure, 1.0, 5e-4);
  EXPECT_NEAR(point.semi_axis_x, exact.half_width, point.error_estimate.at("semi_axis_x"));
  EXPECT_NEAR(point.approach / exact.approach, 1.0, 1e-4);
  EXPECT_DOUBLE_EQ(point.contact_width, 1.0);
  EXPECT_NEAR(point.contact_area, 2.0, 1e-3);
}

TEST(Carter, TractionsAndSlipOfTheUsersGuide) {
  // a' = 0.6: |xi| = 2.4e-4, |F_x| = 0.64 mu P.
  const ModelResult result = run(steel("longitudinal_creepage = 2.4e-4\n", across(100)));
  const PointResult& point = result.points.at(0);
  EXPECT_NEAR(point.longitudinal_force / (friction * 178.89625), -0.64, 0.64 * 0.001);
  const theories::CarterSolution exact(carter_contact(modulus), 2.4e-4);
  for (int i = 0; i < result.grid.nx; ++i) {
    const double x = result.grid.x(i);
    if (std::abs(x) > 0.97 || std::abs(x + 0.2) < 0.031) continue;  // square roots begin there
    EXPECT_NEAR(point.fields.traction.x[i], exact.traction(x), 0.01 * friction * 113.89) << x;
    EXPECT_NEAR(point.fields.slip.x[i], exact.slip(x), 0.02 * 2.4e-4) << x;
  }
}

TEST(LineContact, ModelCarterIsItsClosedForm) {
  const ModelResult result = run(steel(creepages("longitudinal")), "carter");
  for (const PointResult& point : result.points) {
    const theories::CarterSolution exact(carter_contact(modulus), point.creepage.longitudinal);
    EXPECT_NEAR(point.longitudinal_force, exact.force(), 1e-6 * friction * 178.89625);
    EXPECT_NEAR(point.adhesion_area, 2.0 * exact.stick_half_width(), 1e-6);
    EXPECT_EQ(point.no_bar.at("longitudinal_force"), contact::NoBar::exact);
  }
}

TEST(LineContact, LateralCreepageIsCartersOfAntiplaneShear) {
  // u_y under p_y is 1/(1 - nu) of u_x under p_x: the same curve, steeper by it in the creepage.
  const ModelResult result = run(steel(creepages("lateral")));
  for (const PointResult& point : result.points) {
    const double xi = point.creepage.lateral * (1.0 - 0.28);
    const theories::CarterSolution exact(carter_contact(modulus), xi);
    EXPECT_NEAR(point.lateral_force / 178.89625, exact.force() / 178.89625, 1e-3 * friction);
    EXPECT_NEAR(point.longitudinal_force, 0.0, 1e-9);
  }
}

TEST(LineContact, ForcesAreThoseOfTheWidthAndTheReferenceMovesTheApproachAlone) {
  const std::string usual = steel("longitudinal_creepage = 2.4e-4\n");
  std::string wide = usual;
  wide.replace(wide.find("178.89625"), 9, "3577.925");
  wide.replace(wide.find("\"line\"\n"), 7, "\"line\"\nwidth = 20.0\nreference_distance = 2000.0\n");
  const ModelResult a = run(usual), b = run(wide);
  EXPECT_NEAR(b.points[0].longitudinal_force / a.points[0].longitudinal_force, 20.0, 1e-4);
  EXPECT_NEAR(b.points[0].contact_area / a.points[0].contact_area, 20.0, 1e-4);
  EXPECT_NEAR(b.points[0].max_pressure / a.points[0].max_pressure, 1.0, 1e-6);
  const double moved = 2.0 * 178.89625 / (M_PI * modulus) * std::log(4.0);
  EXPECT_NEAR(b.points[0].approach - a.points[0].approach, moved, 1e-6 * moved);
  EXPECT_EQ(a.points[0].no_bar.at("approach"), contact::NoBar::relative);
  EXPECT_EQ(a.points[0].no_bar.at("elastic_energy"), contact::NoBar::relative);
  EXPECT_EQ(a.points[0].no_bar.at("contact_width"), contact::NoBar::given);
}

/// Steel rollers 20 mm wide that are pushed by half of what friction bears.
std::string pushed(const char* direction, const char* reference) {
  std::string text = steel(fmt::format("problem = \"shift\"\n{}_force = {:.12g}\n", direction,
                                       0.5 * friction * 3577.925),
                           across(200));
  text.replace(text.find("178.89625"), 9, "3577.925");
  return text.replace(text.find("\"line\"\n"), 7,
                      fmt::format("\"line\"\nwidth = 20.0\n{}\n", reference));
}

TEST(LineContact, OfFiniteWidthShiftsAsTheMiddleOfALineLoad) {
  // Cattaneo: mu times Hertz's pressure, less mu times that of the width c with c^2/a^2 = 1/2. The
  // middle of Hertz's pressure moves by 2 P/(pi E*) (ln(2 d/a) + 1/2); d of a load of length L is
  // L exp(nu/(1 - nu)) along x, L exp(-nu) along y, where 1/(1 - nu) more gives way.
  constexpr double nu = 0.28, length = 20.0, load = 178.89625;
  const auto shift = [&](double distance) {
    const auto middle = [&](double force, double half_width) {
      return 2.0 * force / (M_PI * modulus) * (std::log(2.0 * distance / half_width) + 0.5);
    };
    return friction * (middle(load, 1.0) - middle(0.5 * load, std::sqrt(0.5)));
  };
  const double along = shift(length * std::exp(nu / (1.0 - nu)));
  const double across_it = shift(length * std::exp(-nu)) / (1.0 - nu);
  const PointResult x = run(pushed("longitudinal", "reference_distance = inf")).points.at(0);
  const PointResult y = run(pushed("lateral", "reference_distance = inf")).points.at(0);
  EXPECT_NEAR(x.longitudinal_shift / along, -1.0, 1e-3);
  EXPECT_NEAR(y.lateral_shift / across_it, -1.0, 1e-3);
  // The same relative to the surface at 20 mm: all of the patch moves alike, by 2 nu F/(pi G L).
  const PointResult near = run(pushed("longitudinal", "reference_distance = 20.0")).points.at(0);
  const double force = 0.5 * friction * load * length;
  const double moved = 2.0 * nu * force / (M_PI * 82000.0 * length);
  EXPECT_NEAR((near.longitudinal_shift - x.longitudinal_shift) / moved, 1.0, 1e-4);
  EXPECT_NEAR((*x.elastic_energy - *near.elastic_energy) / (0.5 * force * moved), 1.0, 1e-4);
  EXPECT_EQ(x.no_bar.count("approach"), 0U);
  EXPECT_EQ(x.no_bar.count("elastic_energy"), 0U);
}

constexpr double unlike_load = 16.2019;  // N/mm

TEST(BentallJohnson, MaterialOfTheBenchmark) {
  const auto m = contact::combine({2.0 * 23000.0 * 1.31, 0.31}, {2.0 * 82000.0 * 1.28, 0.28});
  EXPECT_NEAR(m.shear_modulus, 35923.8, 0.05);
  EXPECT_NEAR(m.poisson_ratio, 0.30343, 5e-6);
  EXPECT_NEAR(m.difference, 0.10019, 5e-6);
  EXPECT_NEAR(M_PI * 0.1 * 0.1 * m.contact_modulus / (4.0 * 25.0), unlike_load, 1e-3);
  EXPECT_NEAR(2.0 * unlike_load / (M_PI * 0.1), 103.145, 0.005);
}

TEST(Spence, StickRatioOfWeaklyCoupledLineContact) {
  // K'(k)/K(k) = beta/mu for k = c/a (Spence 1975, Johnson 1985), exact while the shear does not
  // act back on the pressure: beta = 0.025. Pressed in small steps, for it depends on the history.
  for (const double beta_over_mu : {1.0, 0.5}) {
    constexpr int steps = 60;
    const double force = M_PI / 400.0;  // a = 1 mm, E* = 1 MPa, R = 100 mm
    std::string forces;
    for (int k = 3; k <= steps; ++k)
      forces += fmt::format("{}{:.12g}", k > 3 ? ", " : "", force * k * k / (steps * steps));
    contact::Scene scene(contact::parse_case(
        fmt::format("[friction]\ncoefficient = {:.12g}\n[wheel]\n"
                    "young_modulus = 2.0\npoisson_ratio = 0.0\n[rail]\nyoung_modulus = 2.0\n"
                    "poisson_ratio = 0.0\n[geometry]\nshape = \"line\"\nrelative_radius = 100.0\n"
                    "[rolling]\nproblem = \"shift\"\n[history]\nnormal_force = [{}]\n",
                    0.025 / beta_over_mu, forces) +
            across(200),
        "spence.toml"));
    scene.material.difference = 0.025;
    const PointResult last =
        rollfem::testing::half_space_models().run("halfspace", scene, {}).points.back();
    double k = 0.5, low = 0.0, high = 1.0;
    for (int halving = 0; halving < 60; ++halving, k = 0.5 * (low + high)) {
      const double ratio = std::comp_ellint_1(std::sqrt(1.0 - k * k)) / std::comp_ellint_1(k);
      (ratio > beta_over_mu ? low : high) = k;
    }
    const auto adhesion = std::count(last.fields.state.begin(), last.fields.state.end(),
                                     contact::ElementState::adhesion);
    // One element of 200 is half a percent.
    EXPECT_NEAR(static_cast<double>(adhesion) / 200.0, k, 0.01) << beta_over_mu;
    EXPECT_NEAR(last.longitudinal_force, 0.0, 1e-6 * force);
  }
}

TEST(LineContact, RollsFromCattaneosShiftToCartersSteadyState) {
  // The nearer the reference the stiffer the shift, and the shorter the way to the steady state.
  const PointResult steady = run(steel("longitudinal_creepage = 2.4e-4\n")).points.at(0);
  std::string text = steel("problem = \"transient\"\nlongitudinal_creepage = 2.4e-4\n",
                           "[history]\nsteps = 40\nstep_length = 0.5\n" + across(20));
  text.replace(text.find("\"line\"\n"), 7, "\"line\"\nreference_distance = 5.0\n");
  const ModelResult history = run(text);
  const PointResult& last = history.points.back();
  EXPECT_NEAR(last.distance, 20.0, 1e-9);
  EXPECT_NEAR(last.longitudinal_force / steady.longitudinal_force, 1.0, 0.02);
  EXPECT_LT(std::abs(history.points[0].longitudinal_force),
            0.5 * std::abs(steady.longitudinal_force));
}

TEST(LineContact, OtherModelsSayThatTheyCannotTakeIt) {
  for (const char* model : {"linear", "vermeulen-johnson", "fastsim", "strip"})
    EXPECT_TRUE(says(
        refusal<std::runtime_error>([&] { run(steel("longitudinal_creepage = 1e-4\n"), model); }),
        "geometry.shape: it cannot handle a line contact"))
        << model;
}

}  // namespace
