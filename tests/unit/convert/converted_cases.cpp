// SPDX-License-Identifier: LGPL-2.1-or-later
// Converted cases of CONTACT: load points, signs, grids, bodies.
#include "case/reading/case_reader.hpp"
#include "halfspace/closed_forms/hertz.hpp"

#include <fmt/format.h>

#include "convert/contact_reader.hpp"
#include "convert/conversion.hpp"
#include "support/contact_inputs.hpp"
#include "support/temporary_folder.hpp"

namespace {

using convert::Conversion;

Conversion converted(const std::string& text) {
  return convert::convert_cases(convert::read_contact_file(text, "made.inp"), "made", "made.inp",
                                "../profiles");
}

/// The only case file of the conversion, as read.
Case only(const std::string& text) {
  const Conversion made = converted(text);
  EXPECT_EQ(made.files.size(), 1U);
  EXPECT_TRUE(made.refused.empty());
  return contact::parse_case(made.files.at(0).text, "made.toml");
}

TEST(ConvertedCase, PushedBallHasForcesInNewtonsAndTheGridOfItsFile) {
  const Case made = only(pushed_ball);
  EXPECT_EQ(made.rolling.problem, contact::Problem::shift);
  ASSERT_EQ(made.rolling.forces.size(), 1U);
  EXPECT_DOUBLE_EQ(*made.rolling.forces[0].longitudinal, -0.5 * 0.3 * 20.0);
  EXPECT_DOUBLE_EQ(*made.rolling.forces[0].lateral, 0.0);
  EXPECT_DOUBLE_EQ(*made.history.at(0).normal_force, 20.0);
  EXPECT_DOUBLE_EQ(made.wheel.material.young_modulus, 750.0);  // 2 G (1 + nu)
  EXPECT_DOUBLE_EQ((*made.contact_grid.cell_size)[0], 0.075);
  EXPECT_DOUBLE_EQ((*made.contact_grid.extent)[1], 2.7);
  EXPECT_DOUBLE_EQ(made.contact_grid.middle[0], 0.0);
  EXPECT_DOUBLE_EQ((*made.undeformed_distance.quadratic)[1], 0.02);
}

TEST(ConvertedCase, ModifiedFastsimKeepsItsLawAndItsReducedSlope) {
  const Case made = only(R"( 3 module
 233100   P-B-T-N-F-S
 422320   L-D-C-M-Z-E
 0100341  H-G-I-A-O-W-R
 100e3 0.001 0.0 0.0              FN CKSI CETA CPHI
 0.13 0.22 900. 0.0 0.0           FKIN FEXP1 SABSH1 FEXP2 SABSH2
 0.002 1.5                        MEMDST MEM_S0
 0.0 0.5 10000.                   CHI DQ VELOC
 0.28 0.28 82000. 82000.
 0.5 0.02 0.6                     K0_MF ALFAMF BETAMF
  -2
 44 22 0.0008 0.5 1.1             MX MY A1 AOB SCALE
 0
)");
  EXPECT_EQ(made.models, std::vector<std::string>{"fastsim"});
  EXPECT_EQ(made.fastsim.slope_reduction, (std::array<double, 3>{0.5, 0.02, 0.6}));
  EXPECT_EQ(made.fastsim.strip_elements, 40);
  EXPECT_NEAR(made.friction_coefficient, 0.35, 1e-12);
  EXPECT_EQ(made.friction_fall.half_velocity, 900.0);
  EXPECT_EQ(made.friction_fall.memory_distance, 0.002);
}

TEST(ConvertedCase, CasesThatDifferInCreepageAreLoadPoints) {
  const Conversion made = converted(rolling_ellipse);
  ASSERT_EQ(made.files.size(), 1U);
  EXPECT_EQ(made.files[0].cases, (std::vector<int>{1, 2, 3}));
  const Case input = contact::parse_case(made.files[0].text, "made.toml");
  ASSERT_EQ(input.rolling.creepages.size(), 3U);
  EXPECT_DOUBLE_EQ(input.rolling.creepages[2].longitudinal, 0.0012);
  EXPECT_DOUBLE_EQ(input.rolling.creepages[2].lateral, -0.0002);
  EXPECT_DOUBLE_EQ(input.rolling.creepages[2].spin, 0.0003);
  EXPECT_EQ(input.rolling.upwind_order, contact::UpwindOrder::first);
  // The curvatures make Hertz's ellipse of 5 by 3 mm under 40 kN: E* = G / (1 - nu).
  const auto [A, B] = *input.undeformed_distance.quadratic;
  const auto hertz = halfspace::hertz_from_force(A, B, 82000.0 / 0.72, 40e3);
  EXPECT_NEAR(hertz.semi_axis_x, 5.0, 1e-9);
  EXPECT_NEAR(hertz.semi_axis_y, 3.0, 1e-9);
  EXPECT_NEAR((*input.contact_grid.cell_size)[0], 0.5, 1e-12);  // 2 SCALE AA / MX
}

TEST(ConvertedCase, EqualCasesAreLoadPointsToo) {
  const Case input = only(rolled_twice);
  ASSERT_EQ(input.rolling.creepages.size(), 3U);
  EXPECT_EQ(input.rolling.creepages[0].longitudinal, input.rolling.creepages[1].longitudinal);
  // Nothing of the file varies.
  const Case same = only(replaced(rolled_twice, "40000. 0.0012", "40000. 0.0004"));
  EXPECT_EQ(same.rolling.problem, contact::Problem::steady);
  EXPECT_EQ(same.rolling.creepages.size(), 3U);
  // Pressed alone, a file has one load point.
  std::string pressed = rolled_twice;
  for (int k = 0; k < 3; ++k) pressed = replaced(pressed, " 203100", " 200100");
  const Conversion made =
      converted(replaced(pressed, " 0.0 0.5 20000.                   CHI DQ VELOC\n", ""));
  EXPECT_EQ(made.files.size(), 3U);
}

TEST(ConvertedCase, HertzsPressureHoldsInAShift) {
  const Case made = only(pushed_ellipse);
  EXPECT_EQ(made.rolling.problem, contact::Problem::shift);
  EXPECT_EQ(made.given_pressure->semi_axis_x, 5.0);
  EXPECT_EQ(*made.load.normal_force, 40000.0);
  EXPECT_DOUBLE_EQ(*made.rolling.forces.at(0).longitudinal, 0.5 * 0.35 * 40000.0);
}

TEST(ConvertedCase, ForceIsFollowedByACreepage) {
  const Case made = only(pushed_then_rolled);
  EXPECT_EQ(made.rolling.problem, contact::Problem::transient);
  ASSERT_EQ(made.rolling.forces.size(), 2U);
  EXPECT_DOUBLE_EQ(*made.rolling.forces[0].longitudinal, -0.5 * 0.3 * 20.0);
  EXPECT_FALSE(made.rolling.forces[1].longitudinal);
  EXPECT_DOUBLE_EQ(made.rolling.creepages[1].longitudinal, 1e-4);
}

TEST(ConvertedCase, LayersMayYield) {
  const auto with_layer = [](const char* numbers) {
    std::string text =
        replaced(replaced(rolling_ellipse, " 022020 ", " 022420 "), "82000. 82000.\n",
                 std::string("82000. 82000.\n ") + numbers + "\n");
    // The later cases keep the layer, with its numbers.
    for (int later = 0; later < 2; ++later) text = replaced(text, " 100000\n", " 100400\n");
    return only(text);
  };
  const auto elastic = with_layer("176.63 0.02 0. 0.").layer;
  EXPECT_EQ(elastic->thickness, 0.02);
  EXPECT_EQ(elastic->shear_modulus, 176.63);
  EXPECT_FALSE(elastic->yield_stress);  // TAU_C0 = 0: CONTACT's layer does not yield
  const auto plastic = with_layer("0. 0. 400. -195.").layer;
  EXPECT_FALSE(plastic->thickness);
  EXPECT_EQ(plastic->yield_stress, 400.0);
  EXPECT_EQ(plastic->hardening, -195.0);
}

TEST(ConvertedCase, OneRowOfLongElementsIsALineContact) {
  const Case made = only(driven_roller);
  EXPECT_EQ(made.geometry.shape, contact::ContactShape::line);
  EXPECT_DOUBLE_EQ(made.geometry.width, 250.0);
  EXPECT_NEAR(*made.geometry.relative_radius, 300.0, 1e-9);
  EXPECT_TRUE(std::isinf(*made.geometry.reference_distance));
  EXPECT_DOUBLE_EQ((*made.contact_grid.cell_size)[0], 0.04);
  EXPECT_DOUBLE_EQ((*made.contact_grid.extent)[1], 250.0);
  EXPECT_DOUBLE_EQ(made.contact_grid.middle[0], 0.0);
  ASSERT_EQ(made.rolling.forces.size(), 1U);
  EXPECT_NEAR(*made.rolling.forces[0].longitudinal, -0.4 * 0.25 * 30000.0, 1e-9);  // CHI = 180
  // The same roller as a circle without height across: NN, XM, RX1, Y1, DY1 and two heights.
  const std::string circle = " 2 1\n 2 0.0 300.0 -125. 250.\n";
  const std::string parabola = " 1 1\n 0.0016666666666667 0.0 0.0 0.0 0.0 0.0";
  EXPECT_NEAR(
      *only(replaced(driven_roller, parabola, circle + " 0.0 0.0")).geometry.relative_radius, 300.0,
      1e-9);
}

TEST(ConvertedCase, EllipsesAreTheSameHoweverTheyAreGiven) {
  const Case by_axes = only(rolling_ellipse);
  const auto [A, B] = *by_axes.undeformed_distance.quadratic;
  for (const std::string& given :
       {std::string("  -1\n 22 22 ") + std::to_string(A) + " " + std::to_string(B),
        std::string("  -2\n 22 22 ") + std::to_string(A) + " 1.6666666667"}) {
    const Case made = only(replaced(rolling_ellipse, "  -3\n 22 22 5.0 3.0", given));
    EXPECT_NEAR((*made.undeformed_distance.quadratic)[1], B, 1e-3 * B) << given;
    EXPECT_NEAR((*made.contact_grid.extent)[0], 11.0, 0.01) << given;
  }
}

TEST(ConvertedCase, PotentialContactsAreTheSameHoweverTheyAreGiven) {
  const std::string first =
      "   1                              IPOTCN\n 36 36  -1.35 -1.35 0.075 0.075";
  for (const char* given :
       {"   2\n 36 36 -1.35 -1.35 1.35 1.35", "   3\n 36 36 -1.3125 -1.3125 0.075 0.075",
        "   4\n 36 36 -1.3125 -1.3125 1.3125 1.3125"}) {
    const Case made = only(replaced(pushed_ball, first, given));
    EXPECT_NEAR((*made.contact_grid.cell_size)[0], 0.075, 1e-12) << given;
    EXPECT_NEAR(made.contact_grid.middle[1], 0.0, 1e-12) << given;
  }
}

TEST(ConvertedCase, RollingBackwardsIsTurnedByHalfATurn) {
  const Case made = only(replaced(rolling_ellipse, " 0.0 0.5 20000.", " 180.0d 0.5 20000."));
  EXPECT_DOUBLE_EQ(made.rolling.creepages[0].longitudinal, -0.0004);
  EXPECT_DOUBLE_EQ(made.rolling.creepages[0].lateral, 0.0002);
  EXPECT_DOUBLE_EQ(made.rolling.creepages[0].spin, 0.0003);
}

TEST(ConvertedCase, ShiftThatRollsOnIsATransient) {
  const std::string onset = replaced(pushed_ball, " 0 module", R"( 3 module
 002120
 102000
 0111341
 20.0 -0.5 0.0 0.0
 0.0 0.1 1000.
 0.25 0.25 300. 300.
 3 module
 002120
 100000
 0111341
 20.0 -0.6 0.0 0.0
 0 module)");
  const Case made = only(onset);
  EXPECT_EQ(made.rolling.problem, contact::Problem::transient);
  ASSERT_EQ(made.history.size(), 3U);
  EXPECT_DOUBLE_EQ(made.history[0].step_length, 0.1);
  EXPECT_DOUBLE_EQ(*made.rolling.forces[2].longitudinal, -0.6 * 0.3 * 20.0);
}

TEST(ConvertedCase, DistanceOfEveryElementGoesIntoAFile) {
  const Conversion made =
      converted(replaced(pushed_ball, "0.02 0.0 0.02\n 0.0 0.0", "0.02 0.001 0.02\n 0.0 0.0"));
  ASSERT_EQ(made.files.size(), 1U);
  const std::string& lattice = made.files[0].attached_files.at("made_distance.csv");
  // The first element is at (-1.3125, -1.3125): 0.041 * 1.3125^2.
  EXPECT_EQ(lattice.substr(0, 40), "x, y, h\n-1.3125, -1.3125, 0.07062890625\n");
}

TEST(ConvertedCase, CirclesAndSinesGoIntoAFile) {
  const std::string plain =
      " 1 1                            IBASE IPLAN\n 0.02 0.0 0.02\n 0.0 0.0 0.0";
  const auto first_line = [&](const std::string& distance) {
    const Conversion made = converted(replaced(pushed_ball, plain, distance));
    EXPECT_EQ(made.files.size(), 1U);
    const std::string& lattice = made.files[0].attached_files.at("made_distance.csv");
    return lattice.substr(8, lattice.find('\n', 8) - 8);
  };
  // The first element is at (-1.3125, -1.3125). A circle of 25 mm about x = 0.2, 1 mm more height
  // for each mm across, whose pieces go on beyond their ends: 1.5125^2 / 50 - 0.3125.
  EXPECT_EQ(first_line(" 2 1\n 3 0.2 25. -1. 1.\n 0. 1. 3."), "-1.3125, -1.3125, -0.266746875");
  EXPECT_EQ(first_line(" 2 1\n 3 0.2 25. -2. 1.\n 0. 1. 3."), "-1.3125, -1.3125, 0.733253125");
  // 2 sin(0.5 (x - 0.1)) - 0.3 sin(4 (x + 0.2)) + x^2 / 50 + y^2 / 40
  const double x = -1.3125;
  EXPECT_EQ(first_line(" 3 1\n 2. 0.5 0.1 0.3 4. -0.2 50. 40."),
            fmt::format("-1.3125, -1.3125, {:.12g}", 2.0 * std::sin(0.5 * (x - 0.1)) -
                                                         0.3 * std::sin(4.0 * (x + 0.2)) +
                                                         x * x / 50.0 + x * x / 40.0));
}

TEST(ConvertedCase, WheelAndRailHaveTheirOrderAndMotion) {
  const Case made = only(left_wheel);
  // Body 1 of module 1 is the rail.
  EXPECT_DOUBLE_EQ(made.rail.material.young_modulus, 2.0 * 70000.0 * 1.3);
  EXPECT_DOUBLE_EQ(made.wheel.material.young_modulus, 2.0 * 80000.0 * 1.28);
  EXPECT_DOUBLE_EQ(*made.load.vertical_force, 45000.0);
  EXPECT_DOUBLE_EQ(made.wheel.rolling_radius, 450.0);
  const std::string text = converted(left_wheel).files.at(0).text;
  EXPECT_TRUE(says(text, "side = \"left\"", "lateral_shift = 1.5", "yaw = 0.003", "roll = -0.0001",
                   "rotation_change = 0.001 ", "lateral_velocity = 0.002 ", "yaw_velocity = 1e-05 ",
                   "inclination = 0.025", "profile = \"../profiles/wheel.csv\"",
                   "[wheel_profile]\nmirror = true\nflip = true\n", "cell_size = [0.25, 0.2]"));
}

TEST(ConvertedCase, ProfilesOfWindowsAreFound) {
  const std::string text =
      converted(replaced(left_wheel, "'wheel.csv'", "'worn\\wheel.csv'")).files.at(0).text;
  EXPECT_TRUE(says(text, "profile = \"../profiles/worn/wheel.csv\""));
}

TEST(ConvertedCase, FrictionOverTheRailHasPoints) {
  const std::string points = " 2\n -30d 0.15 0.15\n 0.0 0.30 0.30\n";
  std::string text =
      replaced(replaced(left_wheel, " 0.25 0.25\n", points), " 0022033 ", " 1022033 ");
  const Case over = only(text);
  ASSERT_EQ(over.friction_variation.inclination.size(), 2U);
  EXPECT_NEAR(over.friction_variation.inclination[0], -M_PI / 6.0, 1e-11);
  EXPECT_EQ(over.friction_variation.points.at(0).coefficient, 0.15);
  EXPECT_EQ(over.friction_coefficient, 0.3);
  text = replaced(replaced(text, " -30d 0.15", " -200. 0.15"), " 1022033 ", " 2022033 ");
  const Case along = only(replaced(text, " 0.0 1.5 45000.", " 125.0 1.5 45000."));
  EXPECT_EQ(along.friction_variation.track_position, (std::vector<double>{-200.0, 0.0}));
  EXPECT_EQ(along.wheelset.track_position, (std::vector<double>{125.0}));
  text = replaced(replaced(left_wheel, " 0.25 0.25\n", " 1\n 0.0 0.25 0.25\n"), " 0022033 ",
                  " 1022033 ");
  EXPECT_TRUE(only(text).friction_variation.points.empty());
}

TEST(ConvertedCase, PointsBelowTheSurfaceAreLinesAndPoints) {
  std::string text = replaced(rolling_ellipse, " 203100 ", " 203103 ");
  // Below elements 11 and 12 of row 11, at two depths; three depths at one place.
  text = replaced(text, "1.1                MX MY AA BB SCALE\n",
                  "1.1\n 1 1\n 6\n 11 1 12\n 11 1 11\n 2\n 0.5 1.5\n 9\n 1 1 3\n 0.\n 0.25\n"
                  " -0.1 -0.2 -0.4\n 0\n");
  const Conversion made = converted(text);
  ASSERT_EQ(made.files.size(), 1U);
  const Case input = contact::parse_case(made.files[0].text, "made.toml");
  EXPECT_EQ(made.files[0].cases.size(), 3U);
  const std::string& written = made.files[0].text;
  EXPECT_TRUE(says(written,
                   "[[subsurface.line]]\nbody = \"wheel\"\nfrom = [-0.25, -0.15, 0.5]\n"
                   "to = [0.25, -0.15, 0.5]\npoints = 2\n",
                   "[[subsurface.point]]\nbody = \"rail\"\nat = [0, 0.25, -0.4]\n"));
}

TEST(ConvertedCase, FewElementsAreNoted) {
  // 0.02 N: a diameter of 0.20 mm on cells of 0.075 mm.
  const Conversion made = converted(replaced(pushed_ball, "20.0  -0.5", "0.02  0.0 "));
  ASSERT_EQ(made.files.size(), 1U);
  EXPECT_TRUE(says(made.files[0].text, "# note: the patch is only 3 by 3 elements"));
}

TEST(ConvertedCase, ForcesUnderAGivenApproachAreFractionsOfTheForceOfHertz) {
  // Approach of 20 N by Hertz: E* = G / (1 - nu).
  const double approach = halfspace::hertz_from_force(0.02, 0.02, 300.0 / 0.75, 20.0).approach;
  const Case made = only(replaced(replaced(pushed_ball, " 201120 ", " 201020 "), " 20.0  -0.5",
                                  fmt::format("{:.15g} -0.5", approach)));
  EXPECT_NEAR(*made.history.at(0).approach, approach, 1e-12);
  EXPECT_NEAR(*made.rolling.forces[0].longitudinal, -0.5 * 0.3 * 20.0, 1e-9);
}

TEST(ConvertedCase, APatchThatMovesOverFixedAxesRolls) {
  // h = 0.02 (x - s)^2 + 0.02 y^2 with s = 0.075 and 0.15 mm, the approach of 20 N.
  const double approach = halfspace::hertz_from_force(0.02, 0.02, 300.0 / 0.75, 20.0).approach;
  std::string steps;
  for (const double s : {0.075, 0.15})
    steps += fmt::format(
        " 3\n 001010\n 100020\n 0101341\n {:.5g} -0.6 0. 0.\n 1 1\n 0.02 0. 0.02 {:.7g} 0. "
        "{:.7g}\n",
        approach, -0.04 * s, 0.02 * s * s);
  const Case made = only(replaced(pushed_ball, " 0 module", steps + " 0 module"));
  EXPECT_EQ(made.rolling.problem, contact::Problem::transient);
  ASSERT_EQ(made.history.size(), 3U);
  for (const contact::HistoryStep& step : made.history) {
    EXPECT_NEAR(step.step_length, 0.075, 1e-9);
    EXPECT_NEAR(*step.approach, approach, 1e-4 * approach);
  }
  EXPECT_EQ(*made.undeformed_distance.quadratic, (std::array<double, 2>{0.02, 0.02}));
  EXPECT_NEAR(*made.rolling.forces[2].longitudinal, -0.6 * 0.3 * 20.0, 1e-3);
  EXPECT_DOUBLE_EQ(made.rolling.creepages[2].lateral, 0.0);
}

TEST(ConvertedCase, WhatContinuesARefusedCaseIsRefused) {
  const Conversion made = converted(replaced(
      replaced(pushed_ball, "0.30  0.30", "0.30  0.20"), " 0 module",
      " 3 module\n 001120\n 100000\n 0001341\n 200 100 30 1 1e-6\n 20. -0.6 0. 0.\n 0 module"));
  ASSERT_EQ(made.refused.size(), 2U);
  EXPECT_TRUE(made.files.empty());
  EXPECT_EQ(made.refused[1].number, 2);
}

TEST(Numbers, AreWrittenAsRanges) {
  EXPECT_EQ(convert::numbers_text({1}), "1");
  EXPECT_EQ(convert::numbers_text({1, 2, 4, 5, 6, 9}), "1, 2, 4 to 6, 9");
}

}  // namespace
