// Line contact as a shape of the models halfspace, hertz and carter, from case file to result:
// Hertz and Carter in closed form, antiplane shear, Bentall and Johnson's unlike rollers
// (reference/benchmarks.md, 5), and what of it is relative to the reference distance.
#include "contact/case/case_reader.hpp"
#include "contact/result/bars.hpp"
#include "contact/scene/scene.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "theories/carter.hpp"
#include "theories/registry.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/recorded.hpp"
#include "support/temporary_folder.hpp"
#include <cmath>
#include <string>
#include <vector>

namespace rollfem {
namespace {

using contact::ModelResult;
using contact::PointResult;

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
  return theories::models().run(model, contact::Scene(contact::parse_case(text, "line.toml")), {});
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

/// How many bars held of how many.
struct Held {
  int held = 0, all = 0;
  void add(double error, double bar) {
    ++all;
    if (error <= bar) ++held;
  }
};

/// Largest error of the force over Carter's curve, of mu P.
double carter_error(int elements, Held& force, Held& adhesion) {
  const ModelResult result = run(steel(creepages("longitudinal"), across(elements)));
  double largest = 0.0;
  for (const PointResult& point : result.points) {
    const theories::CarterSolution exact(carter_contact(modulus), point.creepage.longitudinal);
    const double error = std::abs(point.longitudinal_force - exact.force());
    force.add(error, point.error_estimate.at("longitudinal_force"));
    adhesion.add(std::abs(point.adhesion_area - 2.0 * exact.stick_half_width()),
                 point.error_estimate.at("adhesion_area"));
    largest = std::max(largest, error / (friction * 178.89625));
  }
  return largest;
}

TEST(LineContact, CartersCurveWithOrderOneAndAHalfAtLeast) {
  Held force, adhesion;
  const double at_20 = carter_error(20, force, adhesion);
  const double at_40 = carter_error(40, force, adhesion);
  const double at_80 = carter_error(80, force, adhesion);
  EXPECT_LT(at_40, 1e-3);
  EXPECT_GT(std::log2(at_20 / at_80) / 2.0, 1.5);
  EXPECT_GE(force.held, 0.9 * force.all);
  EXPECT_GE(adhesion.held, 0.9 * adhesion.all);
  testing::record("carter_at_40", at_40);
  testing::record("carter_order", std::log2(at_20 / at_80) / 2.0);
}

TEST(LineContact, ModelCarterIsItsClosedForm) {
  const ModelResult result = run(steel(creepages("longitudinal")), "carter");
  for (const PointResult& point : result.points) {
    const theories::CarterSolution exact(carter_contact(modulus), point.creepage.longitudinal);
    EXPECT_NEAR(point.longitudinal_force, exact.force(), 1e-6 * friction * 178.89625);
    EXPECT_NEAR(point.adhesion_area, 2.0 * exact.stick_half_width(), 1e-6);
    EXPECT_EQ(point.no_bar.at("longitudinal_force"), contact::no_bar::exact);
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
  EXPECT_EQ(a.points[0].no_bar.at("approach"), contact::no_bar::relative);
  EXPECT_EQ(a.points[0].no_bar.at("elastic_energy"), contact::no_bar::relative);
  EXPECT_EQ(a.points[0].no_bar.at("contact_width"), contact::no_bar::given);
}

/// Aluminium on steel, R = 25 mm, a = 0.1 mm; F_x of the wheel over mu P.
PointResult unlike(double mu, double ratio, int elements) {
  const double load = 16.2019;
  return run(fmt::format("[load]\nnormal_force = {}\n[friction]\ncoefficient = {}\n"
                         "[wheel]\nyoung_modulus = 60260.0\npoisson_ratio = 0.31\n"
                         "[rail]\nyoung_modulus = 209920.0\npoisson_ratio = 0.28\n"
                         "[geometry]\nshape = \"line\"\nrelative_radius = 25.0\n"
                         "[rolling]\nlongitudinal_force = {:.12g}\n",
                         load, mu, ratio * mu * load) +
             across(elements))
      .points.at(0);
}

TEST(LineContact, UnlikeRollersRollFreelyAsBentallAndJohnsonFound) {
  // 0.457 kappa a/R of hardly any friction, with more digits where all slips (halfspace_line.cpp);
  // with friction by quadrature (benchmarks/book/unlike_cylinders.py).
  const PointResult smooth = unlike(1e-4, 0.0, 100);
  EXPECT_NEAR(-smooth.creepage.longitudinal / 5.2631e-4, 1.0, 2e-3);
  EXPECT_NEAR(smooth.max_pressure / 103.145, 1.0, 5e-4);
  const PointResult rough = unlike(0.05, 0.0, 100);
  EXPECT_NEAR(-rough.creepage.longitudinal / 4.2946e-4, 1.0, 2e-3);
  EXPECT_NEAR(rough.max_pressure / 103.627, 1.0, 5e-4);
  testing::record("free_rolling", -smooth.creepage.longitudinal);
}

TEST(LineContact, UnlikeRollersThatDriveAndBrakeAsByQuadrature) {
  const PointResult driven = unlike(0.05, 0.5, 100), braked = unlike(0.05, -0.5, 100);
  EXPECT_NEAR(-driven.creepage.longitudinal / 4.9802e-4, 1.0, 2e-3);
  EXPECT_NEAR(-braked.creepage.longitudinal / 3.1489e-4, 1.0, 2e-3);
  EXPECT_NEAR(driven.max_pressure / 103.417, 1.0, 5e-4);
  EXPECT_NEAR(braked.max_pressure / 103.426, 1.0, 5e-4);
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
    EXPECT_TRUE(testing::says(testing::refusal<std::runtime_error>(
                                  [&] { run(steel("longitudinal_creepage = 1e-4\n"), model); }),
                              "geometry.shape: it cannot handle a line contact"))
        << model;
}

}  // namespace
}  // namespace rollfem
