// SPDX-License-Identifier: LGPL-2.1-or-later
// The digits V, L and M of CONTACT's input, which say where and how friction varies and what is
// between the bodies, and INISLP: their numbers in the converted case.
#include "base/errors.hpp"
#include "case/reading/case_reader.hpp"
#include "scene/friction_law.hpp"

#include "convert/contact_reader.hpp"
#include "convert/conversion.hpp"
#include "support/contact_inputs.hpp"
#include "support/temporary_folder.hpp"

namespace {

/// rolling_ellipse with these digits, lines of friction and lines after those of the materials.
std::string ellipse_with(int L, const std::string& friction, int M = 0,
                         const std::string& material = "") {
  std::string text =
      replaced(rolling_ellipse, "022020", std::to_string(L) + "22" + std::to_string(M) + "20");
  text = replaced(text, " 0.35 0.35\n", friction);
  return replaced(text, "82000. 82000.\n", "82000. 82000.\n" + material);
}

const std::string constant_line = " 0.35 0.35\n";
/// FKIN F1 SABSH1 F2 SABSH2; MEMDST MEM_S0.
const std::string falling_lines = " 0.10 0.20 1500. 0.05 90.   FKIN ...\n 0.004 2.0\n";

convert::Conversion conversion_of(const std::string& text) {
  return convert::convert_cases(convert::read_contact_file(text, "made.inp"), "made", "made.inp",
                                "../profiles");
}

contact::Case case_with(int L, const std::string& friction, int M = 0,
                        const std::string& material = "") {
  const convert::Conversion made = conversion_of(ellipse_with(L, friction, M, material));
  EXPECT_TRUE(made.refused.empty());
  return contact::parse_case(made.files.at(0).text, "made.toml");
}

TEST(FrictionDigits, LFrom2To4AreTheFallingLaws) {
  for (const auto& [L, shape] :
       {std::pair{2, FallShape::linear}, {3, FallShape::rational}, {4, FallShape::exponential}}) {
    const contact::Case made = case_with(L, falling_lines);
    const contact::FrictionFall& fall = made.friction_fall;
    EXPECT_EQ(fall.shape, shape);
    EXPECT_DOUBLE_EQ(made.friction_coefficient, 0.35);  // FKIN + F1 + F2
    EXPECT_DOUBLE_EQ(*fall.kinetic_coefficient, 0.10);
    EXPECT_DOUBLE_EQ(*fall.half_velocity, 1500.0);
    EXPECT_DOUBLE_EQ(fall.second_part, 0.05);
    EXPECT_DOUBLE_EQ(fall.second_half_velocity, 90.0);
    EXPECT_DOUBLE_EQ(fall.memory_distance, 0.004);
    EXPECT_DOUBLE_EQ(fall.memory_velocity, 2.0);
    EXPECT_DOUBLE_EQ(made.rolling.speed, 20000.0);  // VELOC
  }
}

/// CONTACT's formulas (user guide, L = 2 to 4) at SABS = 600 mm/s.
TEST(FrictionDigits, TheLawsAreContactsInTheirUnits) {
  const double s = 600.0;
  const double values[] = {0.10 + 0.20 * (1.0 - 0.5 * s / 1500.0),
                           0.10 + 0.20 / (1.0 + s / 1500.0) + 0.05 / (1.0 + s * s / (90.0 * 90.0)),
                           0.10 + 0.20 * std::exp(-std::log(2.0) * s / 1500.0) +
                               0.05 * std::exp(-std::log(2.0) * s / 90.0)};
  for (int L = 2; L <= 4; ++L)
    EXPECT_NEAR(contact::friction_of(case_with(L, falling_lines))->at(s / 20000.0).value,
                values[L - 2], 1e-12)
        << L;
}

TEST(FrictionDigits, M4IsTheLayer) {
  const contact::Case made = case_with(0, constant_line, 4, " 8200. 1.25 0.0 0.0\n");
  ASSERT_TRUE(made.layer);
  EXPECT_EQ(made.layer->thickness, 1.25);
  EXPECT_EQ(made.layer->shear_modulus, 8200.0);
  EXPECT_FALSE(case_with(0, constant_line, 4, " 8200. 0.0 0.0 0.0\n").layer);
}

/// The ellipse's cases, of which a fourth continues the third in a step with this INISLP.
std::string rolled_on(int initial_slip) {
  return replaced(ellipse_with(4, falling_lines), " 0\n",
                  " 3 module\n 002100\n 100000\n 0401341\n 200 100 30 1 1e-6\n " +
                      std::to_string(initial_slip) + " 1.1\n 40000. 0.0014 -0.0002 0.0003\n 0\n");
}

TEST(FrictionDigits, AStepAfterASteadyCaseStartsWithIt) {
  const convert::Conversion made = conversion_of(rolled_on(1));
  ASSERT_EQ(made.files.size(), 2U);
  EXPECT_TRUE(made.refused.empty());
  EXPECT_EQ(made.files[0].cases, (std::vector<int>{1, 2}));
  EXPECT_EQ(made.files[1].cases, (std::vector<int>{3, 4}));
  const contact::Case steps = contact::parse_case(made.files[1].text, "made.toml");
  EXPECT_EQ(steps.rolling.problem, contact::Problem::transient);
  EXPECT_TRUE(steps.starts_steady);
  ASSERT_EQ(steps.history.size(), 2U);
  EXPECT_EQ(steps.history[1].normal_force, 40000.0);
  EXPECT_EQ(steps.history[1].step_length, 0.5);
  EXPECT_EQ(steps.rolling.creepages[0].longitudinal, 0.0012);
  EXPECT_EQ(steps.rolling.creepages[1].longitudinal, 0.0014);
  EXPECT_EQ(steps.friction_fall.branch, contact::FrictionBranch::sticking);
  EXPECT_FALSE(contact::parse_case(made.files[0].text, "made.toml").starts_steady);
}

TEST(FrictionDigits, NegativeInislpComesFromFastSliding) {
  const convert::Conversion made = conversion_of(rolled_on(-1));
  ASSERT_EQ(made.files.size(), 2U);
  EXPECT_EQ(contact::parse_case(made.files[1].text, "made.toml").friction_fall.branch,
            contact::FrictionBranch::sliding);
  EXPECT_NE(made.files[1].text.find("INISLP of case 3 is taken"), std::string::npos);
}

TEST(FrictionDigits, FallingFrictionOverTheRailOfAWheel) {
  const std::string text =
      replaced(left_wheel, " 0.25 0.25\n",
               " 2\n -30d 0.10 0.05 900. 0.0 1.0\n 0.0 0.2 0.1 1200. 0.02 80.\n 0.002 0.0\n");
  const contact::Case made = contact::parse_case(
      conversion_of(replaced(text, " 0022033 ", " 1422033 ")).files.at(0).text, "made.toml");
  EXPECT_EQ(made.friction_fall.shape, FallShape::exponential);
  EXPECT_EQ(made.rolling.speed, 9000.0);  // VS
  EXPECT_EQ(made.friction_fall.memory_distance, 0.002);
  const auto& points = made.friction_variation.points;
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(points[0].coefficient, 0.15, 1e-12);
  EXPECT_EQ(points[0].fall.half_velocity, 900.0);
  EXPECT_NEAR(points[1].coefficient, 0.32, 1e-12);
  EXPECT_EQ(points[1].fall.kinetic_coefficient, 0.2);
  EXPECT_EQ(points[1].fall.second_part, 0.02);
  EXPECT_EQ(points[1].fall.second_half_velocity, 80.0);
}

TEST(FrictionDigits, RowsOfElementsKeepTheirFriction) {
  std::string rows = "1.1                MX MY AA BB SCALE\n";
  for (int row = 0; row < 22; ++row)
    rows += " 0." + std::to_string(20 + row) + " 0." + std::to_string(20 + row) + "\n";
  std::string text = replaced(rolling_ellipse, " 0.35 0.35\n", "");
  text = replaced(replaced(text, " 022020 ", " 3022020 "), "1.1                MX MY AA BB SCALE\n",
                  rows);
  const auto at = [](const std::string& given, double y) {
    const auto made = contact::parse_case(conversion_of(given).files.at(0).text, "made.toml");
    return contact::friction_of(made)->of_row(y)->coefficient();
  };
  // Rows of 0.3 mm from -3.3 mm on.
  EXPECT_NEAR(at(text, -3.15), 0.20, 1e-12);
  EXPECT_NEAR(at(text, 2.85), 0.40, 1e-12);
  EXPECT_NEAR(at(replaced(text, " 0.0 0.5 20000.", " 180d 0.5 20000."), -3.15), 0.41, 1e-12);
}

TEST(FrictionDigits, M5IsFaStrip) {
  const convert::Conversion made = conversion_of(
      replaced(ellipse_with(0, constant_line, 5, " 1.0 1.0 1.0\n"), " 203100 ", " 223100 "));
  EXPECT_EQ(contact::parse_case(made.files.at(0).text, "made.toml").models,
            std::vector<std::string>{"fastrip"});
}

TEST(FrictionDigits, D4IsTheCurvedSurface) {
  const std::string planar = conversion_of(left_wheel).files.at(0).text;
  EXPECT_TRUE(says(planar, "surface = \"planar\""));
  EXPECT_TRUE(says(planar, "extra_slip = \"none\""));
  const std::string curved =
      conversion_of(replaced(left_wheel, " 0022033 ", " 0042033 ")).files.at(0).text;
  EXPECT_TRUE(says(curved, "surface = \"curved\""));
  EXPECT_FALSE(says(curved, "extra_slip"));
}

}  // namespace
