// SPDX-License-Identifier: LGPL-2.1-or-later
// Reference points and creepages of CONTACT (open version r2707) at given approaches (under the
// load: the book) for the Manchester benchmark, left wheel: S1002 on the benchmark's UIC60,
// radius 460, gauge 1435 at 14 mm, flange backs 1360, rails 1:40, 10 kN, wheelset shifted to the
// right and yawed (shared/reference/manchester_left.csv, some of its rows); and for 100 kN on a
// radius of 450 with 2 mm shift (wheelrail_left_creep.csv, wheelrail_left_patch.csv).
#include "track/motion/wheelset_motion.hpp"

#include <fmt/format.h>

#include "support/wheel_rail_cases.hpp"

namespace {

struct Position {
  double shift, yaw;  // mm, rad
  double y_track, angle, approach;
};

void PrintTo(const Position& of, std::ostream* stream) {
  *stream << of.shift << " mm";
}

// y_ws, yaw, ycp_tr, deltcp, approach.
const Position positions[] = {
    {0.0, 0.0, -751.8726, 0.0290, 1.596e-2},      {1.0, 2.4e-3, -755.2440, 0.0176, 1.946e-2},
    {2.0, 4.8e-3, -756.5056, 0.0134, 2.054e-2},   {5.0, 12.0e-3, -757.8958, 0.0088, 2.232e-2},
    {6.0, 14.4e-3, -758.0210, 0.0084, 2.278e-2},  {7.0, 16.8e-3, -758.6092, 0.0064, 2.412e-2},
    {10.0, 24.0e-3, -757.0975, 0.0115, 2.511e-2},
};

class Manchester : public ::testing::TestWithParam<Position> {};

TEST_P(Manchester, ReferencePointIsExactAtTheApproachThatContactFinds) {
  // Without the estimate of the approach, only the definition of the reference point remains.
  const Position& row = GetParam();
  contact::Case input = manchester_case(row.shift, row.yaw);
  input.load = {};
  input.load.approach = row.approach;
  const auto found = contacts_of(input);
  EXPECT_NEAR(found.at(0).place.y_track, row.y_track, 0.007);
  // Theirs is the mean angle of the patch, with four digits, not the tangent at its mean place.
  EXPECT_NEAR(found[0].place.contact_angle, row.angle, 1.5e-4);
}

INSTANTIATE_TEST_SUITE_P(Rows, Manchester, ::testing::ValuesIn(positions), [](const auto& test) {
  return fmt::format("Shift{:g}", test.param.shift);
});

TEST(ManchesterHeight, IsTheirsLessTheApproach) {
  // Height of the wheelset while the right wheel, which yields a little more, stands on its tread.
  const contact::Case input = manchester_case(0.0, 0.0);
  const auto found = contacts_of(input);
  EXPECT_NEAR(found.at(0).place.height, 0.1981 - 1.596e-2, 1e-4);
}

contact::Case shifted_wheel() {
  contact::Case input = manchester_case(2.0, 0.0);
  input.wheel.rolling_radius = 450.0;
  input.wheel.material = input.rail.material = contact::Material{};
  input.load.vertical_force = 100e3;
  input.wheelset.roll = {0.0};  // with a found roll of -1.16e-4 rad it would be 0.14 mm off
  return input;
}

TEST(LeftWheelAt100kN, ContactIsWhereContactFindsIt) {
  const contact::Case input = shifted_wheel();
  auto found = contacts_of(input);
  ASSERT_EQ(found.at(0).place.patches, 1);
  EXPECT_NEAR(found[0].place.y_track, -755.6210, 0.06);
  EXPECT_NEAR(found[0].place.contact_angle, 0.0164, 2e-4);
  contact::Case sunk = input;
  sunk.load = {};
  sunk.load.approach = 9.331e-2;
  found = contacts_of(sunk);
  EXPECT_NEAR(found.at(0).place.y_track, -755.6208, 0.003);
}

TEST(LeftWheelAt100kN, CreepagesFollowTheRotation) {
  // rel_pitch_change, cksi, cphi: our xi is minus theirs, our phi is theirs.
  const double table[][3] = {{-0.004, -4.401e-3, -3.634e-5},
                             {0.0, -3.933e-4, -3.641e-5},
                             {0.001, 6.062e-4, -3.643e-5},
                             {0.004, 3.599e-3, -3.649e-5}};
  contact::Case input = shifted_wheel();
  input.load = {};
  input.load.approach = 9.331e-2;
  const auto found = contacts_of(input);
  for (const auto& row : table) {
    const auto creepage = track::creepage_of(found.at(0), track::motion_of(input, row[0]));
    EXPECT_NEAR(creepage.longitudinal, -row[1], 1e-5);
    EXPECT_NEAR(creepage.lateral, 0.0, 1e-12);
    EXPECT_NEAR(creepage.spin, row[2], 0.005 * std::abs(row[2]));
  }
}

}  // namespace
