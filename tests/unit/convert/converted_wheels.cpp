// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheels of CONTACT without a gauge or a load, on rollers, and displaced by themselves.
#include "case/reading/case_reader.hpp"

#include <Eigen/Dense>

#include "convert/contact_reader.hpp"
#include "convert/conversion.hpp"
#include "support/contact_inputs.hpp"
#include <cmath>

namespace {

using Eigen::Vector3d;

/// The only case file of the conversion, as read.
Case converted_alone(const std::string& text) {
  const convert::Conversion made = convert::convert_cases(
      convert::read_contact_file(text, "made.inp"), "made", "made.inp", "../profiles");
  EXPECT_EQ(made.files.size(), 1U);
  EXPECT_TRUE(made.refused.empty());
  return contact::parse_case(made.files.at(0).text, "made.toml");
}

TEST(ConvertedWheel, RailIsPlacedWithoutAGauge) {
  // RAILY0 and RAILZ0 stand where GAUGSQ and GAUGWD do.
  const Case made = converted_alone(replaced(left_wheel, " 14.5 0 1435.0", " 0.0 750. 0.2"));
  EXPECT_EQ(made.track.rail_position, (std::array<double, 2>{750.0, 0.2}));
}

TEST(ConvertedWheel, HeightTakesThePlaceOfTheLoad) {
  const Case made = converted_alone(replaced(replaced(left_wheel, " 0203100 ", " 0203000 "),
                                             " 0.0 1.5 45000. ", " 0.0 1.5 0.4 "));
  EXPECT_FALSE(made.load.vertical_force);
  EXPECT_EQ(made.wheelset.height, (std::vector<double>{0.4}));
  EXPECT_EQ(made.wheelset.lateral_shift, (std::vector<double>{1.5}));
}

TEST(ConvertedWheel, RollersTurnWithTheSpeedOfTheirSurface) {
  // The last number of the track is then NOMRAD, and VS the rate of the roller.
  std::string text = replaced(left_wheel, " 0203100 ", " 4203100 ");
  text = replaced(replaced(text, " 1435.0 0.025 ", " 1435.0 750. "), " 9000. 18. ", " 12. 18. ");
  const Case made = converted_alone(text);
  EXPECT_EQ(made.rail.rolling_radius, 750.0);
  EXPECT_EQ(made.track.inclination, 0.0);
  EXPECT_EQ(made.wheelset.side, contact::WheelSide::left);
  EXPECT_EQ(made.wheelset.lateral_velocity, converted_alone(left_wheel).wheelset.lateral_velocity);
}

TEST(ConvertedWheel, EachBodyIsDisplacedByItself) {
  std::string text = replaced(
      replaced(left_wheel, "\n 0.0 0.0 0.0 0.0 0.0 0.0\n", "\n 0.5 0.1 0.02 9.0 0.0 0.0\n"),
      " 0022033 ", " 0022035 ");
  text = replaced(text, "VROLL VYAW VPITCH\n",
                  "VROLL VYAW VPITCH\n 0.0 0.1 -0.2 0.01 0.0 0.0\n 0.0 0.0 0.0 0.0 0.0 -0.9\n");
  const Case made = converted_alone(text);
  const contact::Displacement &rail = made.rail_displacement, &wheel = made.wheel_displacement;
  EXPECT_EQ(rail.lateral[0], 0.5);
  EXPECT_EQ(rail.roll[0], 0.02);
  EXPECT_NEAR(rail.lateral_velocity[0], 1e-3, 1e-15);
  EXPECT_EQ(wheel.vertical[0], -0.2);
  EXPECT_NEAR(wheel.rotation[0], 1e-4, 2e-7);  // about the axle, which is turned by 0.01 rad
  EXPECT_EQ(made.wheelset.vertical_velocity.value(), 0.0);  // VZ, given
}

/// Rigid motion in the track frame over the forward speed: velocity of the place `at`, rotation.
struct Twist {
  Vector3d at, velocity, turning;
  Vector3d of(const Vector3d& place) const { return velocity + turning.cross(place - at); }
};

TEST(ConvertedWheel, MovesAsInContact) {
  // User guide, velocity of a place Q of the wheel: v_ws + omega_ws x (Q - O_ws) + v_w + omega_w x
  // (Q - O_w), of the wheelset about its middle and of the wheel about its profile's origin O_w;
  // here from the keys, about the displaced axle (docs/track.md).
  std::string text = replaced(left_wheel, " 0022033 ", " 0022035 ");
  text = replaced(
      text, "VROLL VYAW VPITCH\n",
      "VROLL VYAW VPITCH\n 2.0 0.1 -0.2 0.001 0.02 0.0\n 90.0 180.0 -9.0 0.009 0.018 -0.9\n");
  // All of it in the axes of the wheelset, yawed by 30 mrad.
  text = replaced(text, " 0.003 0.0 S Y", " 0.03 0.0 S Y");
  const Case made = converted_alone(text);
  const contact::Displacement& wheel = made.wheel_displacement;
  const double speed = 9000.0, radius = 450.0, turning = 20.02 / speed, middle = -749.0;
  const Eigen::Matrix3d yawed = Eigen::AngleAxisd(0.03, Vector3d::UnitZ()).toRotationMatrix();
  const Vector3d moved(2.0, 0.1, -0.2);
  const Vector3d axle = yawed * Vector3d(-std::sin(0.02), std::cos(0.02), std::sin(0.001));
  const Vector3d ahead = yawed * Vector3d(std::cos(0.02), std::sin(0.02), 0.0);
  const Vector3d down = ahead.cross(axle);
  const Vector3d origin = yawed * (Vector3d(0.0, middle, radius) + moved);
  const Twist wheelset{Vector3d::Zero(), Vector3d::UnitX(), -turning * yawed * Vector3d::UnitY()};
  const Twist own{origin, yawed * Vector3d(90.0, 180.0, -9.0) / speed,
                  yawed * Vector3d(0.009, -0.9, 0.018) / speed};
  const Twist about_axle{origin - radius * down, Vector3d::UnitX(),
                         -(turning + wheel.rotation[0]) * axle};
  const Twist by_keys{
      origin,
      {wheel.longitudinal_velocity[0], wheel.lateral_velocity[0], wheel.vertical_velocity[0]},
      wheel.roll_velocity[0] * ahead + Vector3d(0.0, 0.0, wheel.yaw_velocity[0])};
  for (const Vector3d& away :
       {Vector3d(0, 0, 0), Vector3d(5, 0, 0), Vector3d(0, 8, 0), Vector3d(0, 0, -3)}) {
    const Vector3d place = origin + away;
    const Vector3d in_contact = wheelset.of(place) + own.of(place);
    const Vector3d here = about_axle.of(place) + by_keys.of(place);
    // To second order in the turns and in the velocities by them.
    EXPECT_LT((here - in_contact).norm(), 5e-5) << away.transpose();
  }
}

TEST(ConvertedWheel, DisplacedRollersKeepTheirAxle) {
  std::string text = replaced(left_wheel, " 0203100 ", " 4203100 ");
  text = replaced(replaced(text, " 1435.0 0.025 ", " 1435.0 750. "), " 9000. 18. ", " 12. 18. ");
  text = replaced(text, "\n 0.0 0.0 0.0 0.0 0.0 0.0\n", "\n 0.0 0.3 0.02 0.0 0.0 0.0\n");
  const contact::Displacement wheel = converted_alone(text).wheel_displacement;
  // What the roller's surface is slower there (1 - z/R), the wheel is slower here, to second
  // order in the yaw of 3 mrad.
  EXPECT_NEAR(wheel.longitudinal_velocity[0] - 450.0 * wheel.rotation[0], -0.3 / 750.0, 1e-9);
  EXPECT_NEAR(wheel.yaw_velocity[0], std::sin(0.02) / 750.0, 1e-12);
}

TEST(ConvertedWheel, IsNotSmoothedAsByContact) {
  const convert::Conversion made = convert::convert_cases(
      convert::read_contact_file(
          replaced(left_wheel, "'rail.csv' 0 1.0 0.0", "'rail.csv' 0 1.0 0.6"), "made.inp"),
      "made", "made.inp", "../profiles");
  EXPECT_NE(made.files.at(0).text.find("see rail_profile.smoothing"), std::string::npos);
}

TEST(ConvertedWheel, TracksOfOldVersionsHaveThreeNumbers) {
  // GAUGWD, GAUGHT, CANT.
  const Case made =
      converted_alone(replaced(left_wheel, " 14.5 0 1435.0 0.025 ", " 1437.0 14.0 0.03 "));
  EXPECT_EQ(made.track.gauge, 1437.0);
  EXPECT_EQ(made.track.gauge_height, 14.0);
  EXPECT_NEAR(std::atan(made.track.inclination), 0.03, 1e-12);
}

TEST(ConvertedWheel, ResultElementsKeepTheirOwnData) {
  // The second element begins with its own data; the third case goes on with the first one's.
  std::string text = replaced(left_wheel, " 1 module", " 1 1 module");
  std::string right =
      replaced(replaced(left_wheel, " 1 module", " 1 2 module"), " 0203100 ", " 1203100 ");
  right =
      replaced(replaced(right, " 1358.0 -70.0 450.0 ", " 1358.0 -70.0 400.0 "), " 0 module\n", "");
  const std::string again =
      " 1 1 module\n 0203100 \n 0111001 \n 0100321 \n 0.0 2.5 45000. -0.0001 0.003 0.0\n 0 "
      "module\n";
  const auto cases =
      convert::read_contact_file(replaced(text, " 0 module\n", "") + right + again, "two.inp");
  ASSERT_EQ(cases.size(), 3U);
  EXPECT_EQ(cases[1].wheel_rail.wheelset[2], 400.0);
  EXPECT_EQ(cases[2].wheel_rail.wheelset[2], 450.0);
  EXPECT_EQ(cases[2].wheel_rail.position[1], 2.5);
}

}  // namespace
