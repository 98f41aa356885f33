// SPDX-License-Identifier: LGPL-2.1-or-later
// Reading CONTACT's input files: the layout of lines, data kept from previous cases.
#include "base/errors.hpp"

#include "convert/contact_reader.hpp"
#include "convert/input_lines.hpp"
#include "support/contact_inputs.hpp"

namespace {

using namespace rollfem::convert;

TEST(InputLines, TakesNumbersFortranWaysAndLeavesTheWords) {
  InputLines lines("% all of it\n\n 1d-5 2. +3.5E2 -90d  A, B, 4 % 5\n7,8,\n 9\n", "x.inp");
  const auto first = lines.numbers({"a", "b", "c", "d"});
  EXPECT_DOUBLE_EQ(first[0], 1e-5);
  EXPECT_DOUBLE_EQ(first[1], 2.0);
  EXPECT_DOUBLE_EQ(first[2], 350.0);
  EXPECT_DOUBLE_EQ(first[3], -M_PI / 2.0);
  EXPECT_EQ(lines.line(), 3U);
  EXPECT_EQ(lines.numbers({"e", "f", "g"}), (std::vector<double>{7.0, 8.0, 9.0}));
  EXPECT_TRUE(lines.at_end());
}

TEST(InputLines, TakesExponentsWithoutALetterAndAnglesWithOne) {
  InputLines lines(".1-07 -2.5+3 1-5 90d 1.5r -0.5R 1.0D-1 'coefficients.txt' CFNAME\n4\n",
                   "x.inp");
  EXPECT_EQ(lines.numbers({"a", "b", "c", "d", "e", "f", "g"}),
            (std::vector<double>{0.1e-7, -2500.0, 1e-5, M_PI / 2.0, 1.5, -0.5, 0.1}));
  InputLines file("'coefficients.txt' CFNAME\n4\n", "x.inp");
  EXPECT_EQ(file.named("a file", {}, 0).text, "coefficients.txt");
  EXPECT_EQ(file.numbers({"what follows"}), (std::vector<double>{4.0}));
}

TEST(InputLines, TakesWhatMayFollowFromTheSameLineOnly) {
  InputLines lines("1 2\n3 word 4\n'a b.prr' 0 1.0\n", "x.inp");
  EXPECT_EQ(lines.numbers({"a"}, 3).size(), 2U);
  EXPECT_EQ(lines.numbers({"b"}, 3).size(), 1U);
  const auto named = lines.named("a file", {"mirror", "scale"}, 0);
  EXPECT_EQ(named.text, "a b.prr");
  EXPECT_EQ(named.numbers, (std::vector<double>{0.0, 1.0}));
}

TEST(ContactInput, ReadsDigitsAndValuesOfACase) {
  const auto cases = read_contact_file(pushed_ball, "made.inp");
  ASSERT_EQ(cases.size(), 1U);
  const ContactCase& only = cases[0];
  EXPECT_EQ(only.line, 2U);
  EXPECT_EQ(only.digits.P * 1000 + only.digits.T * 100 + only.digits.N * 10 + only.digits.F, 2112);
  EXPECT_EQ(only.digits.L * 100 + only.digits.D * 10 + only.digits.Z, 22);
  EXPECT_EQ(only.kinematics[1], -0.5);
  EXPECT_EQ(only.potential.ipotcn, 1);
  EXPECT_EQ(only.potential.size[2], 0.075);
  EXPECT_EQ(only.distance.values, (std::vector<double>{0.02, 0.0, 0.02, 0.0, 0.0, 0.0}));
}

TEST(ContactInput, KeepsOfTheCaseBeforeWhatDigitsSay) {
  const auto cases = read_contact_file(rolling_ellipse, "made.inp");
  ASSERT_EQ(cases.size(), 3U);
  EXPECT_EQ(cases[2].kinematics[1], 0.0012);
  EXPECT_EQ(cases[2].friction_law, 0);
  EXPECT_EQ(cases[2].friction.at(0).fstat, 0.35);
  EXPECT_EQ(cases[2].potential.size[0], 5.0);
  EXPECT_EQ(cases[2].bodies.shear_modulus[1], 82000.0);
}

TEST(ContactInput, HasNoModuleLineWhereTheCaseBeforeStaysInItsModule) {
  std::string text = replaced(rolling_ellipse, " 0001341 ", " 0001340 ");
  text = replaced(text, "AA BB SCALE\n 3 module\n", "AA BB SCALE\n");
  text = replaced(text, " 0101341\n 40000. 0.0008 -0.0002 0.0003\n 3 module\n",
                  " 0101342\n 40000. 0.0008 -0.0002 0.0003\n");
  const auto cases = read_contact_file(text, "made.inp");
  ASSERT_EQ(cases.size(), 3U);
  EXPECT_EQ(cases[2].kinematics[1], 0.0012);
}

TEST(ContactInput, SkipsUnsupportedBlocksAndFindsTheNextCase) {
  // Debugging digits (X = 1), settings of GDsteady, stresses in two blocks of points.
  std::string text = replaced(rolling_ellipse, " 203100 ", " 203103 ");
  text = replaced(text, " 0001341  H-G-I-A-O-W-R", "10501341\n 1000005 P-S-F-L-R-I-N");
  text = replaced(text, " 200 100 30 1 1e-6", " 200 100 30 1 1e-6\n 1 0.5 1 1.0 0.0 1.0 1.0 1.0");
  text = replaced(text, "1.1                MX MY AA BB SCALE\n",
                  "1.1\n 1 1\n 2\n 1 1 45\n 23 1 23\n 1 1e-6 1e-6\n 9\n 1 2 3\n 0.\n 0. 1.\n"
                  " 0. 0.5\n 1.\n 0\n");
  const auto cases = read_contact_file(text, "made.inp");
  ASSERT_EQ(cases.size(), 3U);
  EXPECT_EQ(cases[0].potential.mx, 22);
  EXPECT_EQ(cases[1].kinematics[1], 0.0008);
}

TEST(ContactInput, ReadsWheelAndRail) {
  const auto cases = read_contact_file(left_wheel, "made.inp");
  ASSERT_EQ(cases.size(), 1U);
  const WheelRail& pair = cases[0].wheel_rail;
  EXPECT_EQ(pair.rail.name, "rail.csv");
  EXPECT_EQ(pair.wheel.mirror_y, 1);
  EXPECT_EQ(pair.wheel.mirror_z, 1);
  EXPECT_EQ(pair.track[2], 1435.0);
  EXPECT_EQ(pair.position[1], 1.5);
  EXPECT_EQ(pair.velocity[5], -20.02);
}

}  // namespace
