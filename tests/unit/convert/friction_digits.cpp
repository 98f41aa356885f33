// SPDX-License-Identifier: LGPL-2.1-or-later
// The digits L and M of CONTACT's input, which say how friction falls and what is between the
// bodies: their numbers in the converted case, and what the digits without an equivalent answer.
#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"
#include "contact/scene/friction_law.hpp"

#include <gtest/gtest.h>

#include "convert/contact_reader.hpp"
#include "convert/conversion.hpp"
#include "support/contact_inputs.hpp"
#include "support/temporary_folder.hpp"
#include <cmath>

namespace {

using namespace rollfem;
using namespace rollfem::testing;
using contact::FallShape;

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

std::string reason_against(const std::string& text) {
  const convert::Conversion made = conversion_of(text);
  return made.refused.empty() ? "none" : made.refused[0].reasons.at(0);
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

TEST(FrictionDigits, WrongNumbersNameTheLineAndWhatIsWanted) {
  const auto message = [](const std::string& text) {
    return rollfem::testing::refusal<contact::InputError>(
        [&] { convert::read_contact_file(text, "made.inp"); });
  };
  for (int L = 2; L <= 4; ++L) {
    const std::string text = message(ellipse_with(L, " 0.10 0.20\n words\n"));
    EXPECT_NE(text.find("made.inp"), std::string::npos) << text;
    EXPECT_NE(text.find("SABSH1"), std::string::npos) << text;
  }
  EXPECT_NE(message(ellipse_with(0, constant_line, 4, " 8200. layer\n")).find("LAYTHK"),
            std::string::npos);
  EXPECT_NE(message(ellipse_with(5, constant_line)).find("digit L = 5; allowed: 0 to 4 and 6"),
            std::string::npos);
}

TEST(FrictionDigits, WithoutAnEquivalentAreRefusedByTheirMeaning) {
  EXPECT_EQ(reason_against(ellipse_with(6, " 0.35 0.0 -0.1 300.\n 0.004 2.0\n")),
            "digit L = 6: temperature-dependent friction");
  EXPECT_EQ(reason_against(ellipse_with(0, constant_line, 1, " 300. 300. 0.1 0.1\n")),
            "digit M = 1: viscoelastic bodies");
  EXPECT_EQ(reason_against(ellipse_with(0, constant_line, 2, " 1e-4 1.0 1.0 1.0\n")),
            "digit M = 2: the simplified theory with a user-defined flexibility");
}

}  // namespace
