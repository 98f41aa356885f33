// SPDX-License-Identifier: LGPL-2.1-or-later
// Case files of shifts, transients, prescribed forces, given pressures and points below the
// surface: the resulting cases.
#include "base/errors.hpp"
#include "case/lattice.hpp"
#include "case/reading/case_reader.hpp"
#include "scene/geometry.hpp"
#include "scene/scene.hpp"

#include "support/case_examples.hpp"
#include "support/temporary_folder.hpp"

namespace {

const std::string pressure = R"([friction]
coefficient = 0.3
[given_pressure]
semi_axis_x = 6.0
semi_axis_y = 3.0
)";

TEST(History, ListsBecomeStepsAndNumbersServeAll) {
  const Case input = parse_case(plus("[rolling]\nproblem = \"shift\"\n[history]\n"
                                     "longitudinal_shift = [0.001, -0.002, 0.0]\n"
                                     "spin_shift = 1e-4\n"),
                                "c.toml");
  EXPECT_EQ(input.rolling.problem, Problem::shift);
  ASSERT_EQ(input.history.size(), 3u);
  ASSERT_EQ(input.rolling.creepages.size(), 3u);
  EXPECT_EQ(input.history[1].longitudinal_shift, -0.002);
  EXPECT_EQ(input.history[2].spin_shift, 1e-4);
  EXPECT_FALSE(input.history[0].normal_force);
  EXPECT_TRUE(input.rolling.forces.empty());
}

TEST(History, NumberOfStepsStretchesNumbers) {
  const Case input =
      parse_case(plus("[rolling]\nproblem = \"transient\"\nlateral_creepage = 0.002\n"
                      "longitudinal_force = -1e3\n[history]\nstep_length = 0.5\n"
                      "steps = 4\n"),
                 "c.toml");
  ASSERT_EQ(input.history.size(), 4u);
  ASSERT_EQ(input.rolling.creepages.size(), 4u);
  ASSERT_EQ(input.rolling.forces.size(), 4u);
  EXPECT_EQ(input.history[3].step_length, 0.5);
  EXPECT_FALSE(input.starts_steady);
  EXPECT_EQ(input.rolling.creepages[3].lateral, 0.002);
  EXPECT_EQ(input.rolling.forces[3].longitudinal, -1e3);
}

TEST(History, LoadOfTheStepsSizesTheGridByItsLargest) {
  const Case input =
      parse_case(with("[load]\nnormal_force = 50e3\n", "") +
                     "[rolling]\nproblem = \"shift\"\n[history]\nnormal_force = [10, 30, 20]\n",
                 "c.toml");
  ASSERT_EQ(input.history.size(), 3u);
  EXPECT_EQ(input.history[2].normal_force, 20.0);
  EXPECT_EQ(input.load.normal_force, 30.0);
}

TEST(PrescribedForce, ArrivesForEveryLoadPoint) {
  const Case input = parse_case(
      plus("[rolling]\nlongitudinal_force = [-1e3, -2e3]\nlateral_creepage = 0.001\n"), "c.toml");
  ASSERT_EQ(input.rolling.forces.size(), 2u);
  EXPECT_EQ(input.rolling.forces[1].longitudinal, -2e3);
  EXPECT_FALSE(input.rolling.forces[1].lateral);
  EXPECT_EQ(input.rolling.creepages[1].lateral, 0.001);
  EXPECT_EQ(input.rolling.creepages[1].longitudinal, 0.0);
}

TEST(PrescribedForce, LeavesLoadPointsToTheCreepage) {
  const Case input = parse_case(
      plus("[rolling]\nlongitudinal_force = [-1e3, nan]\nlongitudinal_creepage = [0.7, 0.001]\n"),
      "c.toml");
  EXPECT_EQ(input.rolling.forces.at(0).longitudinal, -1e3);
  EXPECT_FALSE(input.rolling.forces.at(1).longitudinal);
  const contact::Scene scene(input);
  EXPECT_EQ(scene.points.at(0).creepage.longitudinal, 0.0);  // is found
  EXPECT_EQ(scene.points.at(1).creepage.longitudinal, 0.001);
  EXPECT_TRUE(says(contact::describe(input), "[-1000, nan]"));
}

TEST(RigidBody, OneIsAllowedTwoAreNot) {
  const Case input = parse_case(with("[rail]\n", "[rail]\nyoung_modulus = inf\n"), "c.toml");
  EXPECT_TRUE(std::isinf(input.rail.material.young_modulus));
  const contact::CombinedMaterial material =
      contact::combine(input.wheel.material, input.rail.material);
  // Twice as stiff as two like bodies; K = (1 - 2 nu)/2, negative: the rail is the stiff one.
  EXPECT_DOUBLE_EQ(material.contact_modulus, 210e3 / 0.91);
  EXPECT_DOUBLE_EQ(material.shear_modulus, 2.0 * 210e3 / 2.6);
  EXPECT_DOUBLE_EQ(material.difference, 0.5 * (1.0 - 0.6));
}

TEST(GivenPressure, TakesForceOrPressureAndNeedsNoRadii) {
  const Case by_force = parse_case(pressure + "[load]\nnormal_force = 82e3\n", "c.toml");
  ASSERT_TRUE(by_force.given_pressure);
  EXPECT_NEAR(by_force.given_pressure->max_pressure, 1.5 * 82e3 / (M_PI * 18.0), 1e-9);
  const Case by_pressure = parse_case(
      "[friction]\ncoefficient = 0.3\n[given_pressure]\nsemi_axis_x = 6\nsemi_axis_y = 3\n"
      "max_pressure = 1000\n",
      "c.toml");
  EXPECT_NEAR(*by_pressure.load.normal_force, 2.0 / 3.0 * M_PI * 18.0 * 1000.0, 1e-8);
  EXPECT_TRUE(says(contact::describe(by_force), "[given_pressure]"));
}

TEST(UndeformedDistance, QuadraticTakesThePlaceOfTheRadii) {
  const Case input = parse_case(
      "[load]\nnormal_force = 1\n[friction]\ncoefficient = 0.3\n"
      "[undeformed_distance]\nquadratic = [0.01, 0.02]\n",
      "c.toml");
  const contact::ContactGrid grid = contact::ContactGrid::centred(3, 3, 1.0, 2.0);
  const contact::Field distance =
      contact::ChartedGeometry(input, contact::Chart::plane).undeformed_distance(grid);
  EXPECT_DOUBLE_EQ(distance[grid.index(2, 0)], 0.01 + 0.02 * 4.0);
  EXPECT_EQ(distance[grid.index(1, 1)], 0.0);
}

class PointFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    std::ofstream distance(folder_.path("h.csv"));
    std::ofstream slip(folder_.path("slip.csv"));
    for (int j = -4; j <= 4; ++j)
      for (int i = -4; i <= 4; ++i) {
        distance << i << "," << j << "," << 0.01 * i * i + 0.02 * j * j << "\n";
        slip << i << "," << j << "," << 1e-4 * j << "," << -1e-4 * i << "\n";
      }
  }
  std::string name() const { return folder_.path("case.toml"); }
  const TemporaryFolder folder_;
};

TEST_F(PointFiles, AreFoundBesideTheCaseFileAndEvaluated) {
  const Case input = parse_case(
      "[load]\nnormal_force = 1\n[friction]\ncoefficient = 0.3\n[undeformed_distance]\nfile = "
      "\"h.csv\"\n[rolling]\nlongitudinal_creepage = 0.001\nextra_slip = \"file\"\nextra_slip_file "
      "= "
      "\"slip.csv\"\n",
      name());
  const contact::ContactGrid grid = contact::ContactGrid::centred(4, 4, 1.5, 1.5);
  const contact::Field distance =
      contact::ChartedGeometry(input, contact::Chart::plane).undeformed_distance(grid);
  const int corner = grid.index(3, 0);  // x = 2.25, y = -2.25
  EXPECT_NEAR(distance[corner], 0.03 * 2.25 * 2.25, 1e-13);
  const contact::TangentialField slip = contact::ChartedGeometry(input, contact::Chart::plane)
                                            .rigid_slip(input.rolling.creepages[0], grid);
  EXPECT_NEAR(slip.x[corner], 0.001 - 2.25e-4, 1e-15);
  EXPECT_NEAR(slip.y[corner], -2.25e-4, 1e-15);
  const contact::ContactGrid beyond = contact::ContactGrid::centred(9, 9, 1.1, 1.1);
  EXPECT_THROW(contact::ChartedGeometry(input, contact::Chart::plane).undeformed_distance(beyond),
               contact::InputError);
}

/// The small case as a line contact, with lines under [geometry] and sections behind.
std::string line_case(const std::string& under, const std::string& sections = "") {
  return "[load]\nnormal_force = 50e3\n[friction]\ncoefficient = 0.3\n[geometry]\nshape = "
         "\"line\"\n" +
         under + sections;
}

TEST(LineContact, NeedsARadiusAlongRollingAndNoneAcross) {
  const Case input = parse_case(line_case("relative_radius = 25.0\nwidth = 1000.0\n"), "c.toml");
  EXPECT_EQ(input.geometry.shape, contact::ContactShape::line);
  EXPECT_EQ(input.geometry.width, 1000.0);
  EXPECT_EQ(input.geometry.relative_radius, 25.0);
  const Case by_wheel = parse_case(line_case("", "[wheel]\nrolling_radius = 460.0\n"), "c.toml");
  EXPECT_EQ(by_wheel.wheel.rolling_radius, 460.0);
  EXPECT_EQ(by_wheel.geometry.width, 1.0);
}

TEST(LargestPressure, IsOfHertzsContactsAlone) {
  const std::string stated = "max_pressure = 1e3";
  // 2/3 pi a^2 p0 with a = pi p0 R/(2 E*), R = 100 mm.
  const Scene circle = parse_case("[load]\n" + stated +
                                      "\n[friction]\ncoefficient = 0.3\n[undeformed_distance]\n"
                                      "quadratic = [0.005, 0.005]\n",
                                  "c.toml");
  const double a = 0.5 * M_PI * 1e5 / circle.material.contact_modulus;
  EXPECT_NEAR(*circle.points.front().load.force / (2e3 / 3.0 * M_PI * a * a), 1.0, 1e-12);
  EXPECT_TRUE(
      says(contact::derived_values(parse_case(with("normal_force = 50e3", stated), "c.toml")),
           "load.max_pressure by Hertz"));
}

TEST(Subsurface, SectionsAreReadInTheOrderOfTheFile) {
  const Case input = parse_case(plus("[[subsurface.line]]\nfrom = [0, 0, 0.1]\nto = [0, 0, 5]\n"
                                     "points = 50\n"
                                     "[[subsurface.point]]\nbody = \"rail\"\nat = [1, 2, -3]\n"
                                     "[[subsurface.line]]\nbody = \"rail\"\nfrom = [0, 0, 0]\n"
                                     "to = [1, 0, -1]\npoints = 3\n"
                                     "[[subsurface.plane]]\nfrom = [0, 0, 1]\nto = [2, 0, 1]\n"
                                     "across = [0, 2, 1]\npoints = [3, 4]\n"),
                                "c.toml");
  using Kind = contact::SubsurfaceRequest::Kind;
  ASSERT_EQ(input.subsurface.size(), 4u);
  EXPECT_EQ(input.subsurface[0].kind, Kind::line);
  EXPECT_TRUE(input.subsurface[0].wheel);
  EXPECT_EQ(input.subsurface[0].points[0], 50);
  EXPECT_EQ(input.subsurface[1].kind, Kind::point);
  EXPECT_FALSE(input.subsurface[1].wheel);
  EXPECT_EQ(input.subsurface[1].from[2], -3.0);
  EXPECT_EQ(input.subsurface[2].to[2], -1.0);
  EXPECT_EQ(input.subsurface[3].points[1], 4);
  const std::string text = contact::describe(input);
  EXPECT_TRUE(says(text, "[[subsurface.plane]]"));
}

TEST(Subsurface, PointsOfAConcaveBodyMayLieBeyondTheMiddleButNotInTheHalfSpace) {
  // Wheel of -40 mm across: its surface is 40 - sqrt(40^2 - 6^2) = 0.453 mm below z = 0 at y = 6.
  const auto concave = [](const std::string& place) {
    std::string text = with("transverse_radius = inf", "transverse_radius = -40.0");
    text.replace(text.find("2000.0"), 6, "35.0");
    return text + "[[subsurface.point]]\nat = " + place + "\n";
  };
  const Case input = parse_case(concave("[0, 6, -0.4]"), "case.toml");
  EXPECT_EQ(input.subsurface.at(0).from[2], -0.4);
}

}  // namespace
