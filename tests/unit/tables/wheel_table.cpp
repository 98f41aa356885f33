// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables over the lateral shift of a wheelset: points against single solutions and against the
// table of the ellipse, jumps of the contact, taken up after an end, and refusals.
#include "base/errors.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "tables/files/table_reader.hpp"
#include "tables/filling/table_filling.hpp"
#include "tables/filling/table_grid.hpp"
#include "track/motion/placed_scenes.hpp"

#include "support/records_in_memory.hpp"
#include "support/temporary_folder.hpp"
#include "support/worn_wheels.hpp"

namespace {

using tables::CreepTable;
using tables::CreepTableReader;
using tables::Scaled;

contact::Case with_table(contact::Case input, std::vector<double> shifts, std::array<int, 3> points,
                         int check_points) {
  input.contact_grid.elements_across = 16;
  input.table.lateral_shift = std::move(shifts);
  input.table.points = points;
  input.table.check_points = check_points;
  return input;
}

CreepTable filled_wheel(const contact::Case& input, contact::Checkpoint* checkpoint = nullptr) {
  CreepTable table = tables::empty_table(input);
  tables::fill_table(table, input, {}, checkpoint);
  return table;
}

contact::Case rim_case() {
  contact::Case input = with_table(hollow_tread(0.0), {0.8, 1.0, 1.2}, {2, 2, 3}, 20);
  input.load = {};
  input.load.normal_force = 80e3;
  return input;
}

const CreepTable& rim_table() {
  static const CreepTable table = filled_wheel(rim_case());
  return table;
}

TEST(WheelTable, KeysThatDoNotApplyAreNamed) {
  contact::Case input = rim_case();
  EXPECT_EQ(tables::ignored_keys(input), "");
  input.wheelset.lateral_shift = {3.0};
  input.wheelset.free_rolling = contact::FreeRolling::force;
  input.wheelset.yaw = {0.002};  // a table is of one yaw
  EXPECT_TRUE(says(tables::ignored_keys(input),
                   "does not use wheelset.lateral_shift, wheelset.free_rolling"));
  EXPECT_FALSE(says(tables::ignored_keys(input), "yaw"));
}

TEST(WheelTable, PointsAreSingleSolutions) {
  const CreepTable& table = rim_table();
  ASSERT_EQ(table.size(), 3U * 3U * 3U * 3U);
  for (std::size_t n = 2; n < table.size(); n += 11) {
    const std::size_t k = n % 3, j = n / 3 % 3, i = n / 9 % 3, r = n / 27;
    const tables::TableWheel& wheel = table.wheels[r];
    const double c2 = wheel.semi_axis_x * wheel.semi_axis_y, c = std::sqrt(c2), bound = 0.3 * 80e3,
                 unit = bound / (table.shear_modulus * c2);
    contact::Case input = rim_case();
    input.wheelset.lateral_shift = {table.lateral_shift[r]};
    input.rolling.given = {true, true, true};
    input.rolling.creepages = {{table.creepage[0][i] * unit / table.scale[r][0],
                                table.creepage[1][j] * unit / table.scale[r][1],
                                table.creepage[2][k] * unit / (c * table.scale[r][2])}};
    const auto scenes = track::make_scenes(input);
    ASSERT_EQ(scenes.size(), 1U);
    const auto point = halfspace::run_halfspace(scenes[0].scene, {}).points.front();
    EXPECT_NEAR(table.forces[n][0], point.longitudinal_force / bound, 1e-10) << n;
    EXPECT_NEAR(table.forces[n][1], point.lateral_force / bound, 1e-10) << n;
    EXPECT_NEAR(table.forces[n][2], point.spin_moment / (bound * c), 1e-10) << n;
    EXPECT_NEAR(table.along_normal[n], 0.0, 1e-10) << n;
    EXPECT_NEAR(table.bars[n][0] * bound,
                std::hypot(point.error_estimate.at("longitudinal_force"),
                           point.error_estimate.at("lateral_force")),
                1e-8 * bound);
    // Physical creepages find it again.
    const contact::Creepage& creepage = input.rolling.creepages[0];
    const auto found = CreepTableReader(table).of_wheel(
        table.lateral_shift[r], bound, {creepage.longitudinal, creepage.lateral, creepage.spin});
    EXPECT_NEAR(found.forces[0], point.longitudinal_force, 1e-9 * bound) << n;
    EXPECT_NEAR(found.forces[2], point.spin_moment, 1e-9 * bound * c) << n;
    EXPECT_EQ(wheel.contact_angle, scenes[0].contact.place.contact_angle);
    EXPECT_EQ(wheel.rolling_radius, scenes[0].contact.place.rolling_radius);
  }
}

TEST(WheelTable, TakenUpItIsTheSameToTheLastBit) {
  RecordsInMemory memory;
  const CreepTable whole = filled_wheel(rim_case(), &memory);
  EXPECT_EQ(whole.forces, rim_table().forces);
  const std::size_t all = memory.records.size();
  EXPECT_EQ(all, 3U + 2U + 4U);  // a part for each shift, place between them and axis
  memory.forget_every_second();
  const CreepTable again = filled_wheel(rim_case(), &memory);
  EXPECT_EQ(again.forces, whole.forces);
  EXPECT_EQ(again.interpolation.force_max, whole.interpolation.force_max);
  EXPECT_EQ(memory.records.size(), all);
}

TEST(WheelTable, InterpolationIsJudgedAtShiftsBetween) {
  const CreepTable& table = rim_table();
  ASSERT_EQ(table.checked.size(), 20U);
  EXPECT_NE(table.checked.front().place.first, table.checked.back().place.first);
  for (const tables::InterpolatedPoint& point : table.checked) {
    EXPECT_GE(point.place.first, 0.8);
    EXPECT_LE(point.place.first, 1.2);
  }
  EXPECT_GT(table.interpolation.force_rms, 0.0);
  EXPECT_LT(table.interpolation.force_rms, 1.0);
}

/// A cylinder on a rail of radius 200 mm: Hertz's ellipse.
TEST(WheelTable, OfCircularProfilesIsTheTableOfTheEllipse) {
  contact::Case input = with_table(hollow_tread(0.0), {0.0}, {3, 3, 5}, 0);
  input.wheel.profile.radii = {contact::infinity};
  input.wheel.profile.ends = {-60.0, 60.0};
  input.wheelset.flange_back_position = -70.0;
  input.rail.profile.ends = {28.0, 45.0};
  input.track.gauge_height = 8.0;
  input.contact_grid.elements_across = 24;
  input.load = {};
  input.load.normal_force = 80e3;
  const CreepTableReader wheel(filled_wheel(input));
  contact::Case radii;
  radii.load.normal_force = 80e3;
  radii.friction_coefficient = 0.3;
  radii.wheel.rolling_radius = wheel.table().wheels[0].rolling_radius;
  radii.wheel.transverse_radius = contact::infinity;
  radii.rail.transverse_radius = 200.0;
  const halfspace::HertzContact hertz = halfspace::hertz_of_scene(contact::Scene(radii));
  const double a = hertz.semi_axis_x, b = hertz.semi_axis_y, c = std::sqrt(a * b),
               bound = 0.3 * 80e3;
  EXPECT_NEAR(wheel.table().wheels[0].semi_axis_x / a, 1.0, 0.01);
  EXPECT_NEAR(wheel.table().wheels[0].semi_axis_y / b, 1.0, 0.01);
  EXPECT_NEAR(wheel.table().wheels[0].contact_angle, 0.0, 1e-6);
  radii.table.points = {3, 3, 5};
  radii.table.check_points = 0;
  const CreepTableReader ellipse(filled_wheel(radii));
  // The same nodes but for the 1 % of the axes; a cylinder's rolling radius is the same everywhere.
  const double x = wheel.table().creepage[0][3], z = wheel.table().creepage[2][3];
  for (const Scaled& node :
       {Scaled{3, 0, 0}, Scaled{0, -3, 0}, Scaled{0, 0, 5}, Scaled{-x, x, 0}, Scaled{0, -x, z}}) {
    const Scaled scale = wheel.scale_at(0.0);
    const double unit = bound / (wheel.table().shear_modulus * a * b);
    const Scaled creepage{node[0] * unit / scale[0], node[1] * unit / scale[1],
                          node[2] * unit / (c * scale[2])};
    const auto found = wheel.of_wheel(0.0, bound, creepage);
    const auto expected = ellipse.physical(a, b, wheel.table().shear_modulus, bound, creepage);
    for (std::size_t q = 0; q < 2; ++q)
      EXPECT_NEAR(found.forces[q], expected.forces[q], 0.008 * bound) << node[0] << node[1];
    EXPECT_NEAR(found.forces[2], expected.forces[2], 0.015 * bound * c) << node[0] << node[1];
  }
}

/// The largest difference of forces, scaled; `turned`: of the mirror image.
double difference(const CreepTable& a, const CreepTable& b, bool turned) {
  double largest = 0.0;
  const auto& [xi, eta, phi] = a.creepage;
  const double sign = turned ? -1.0 : 1.0;
  for (std::size_t i = 0; i < xi.size(); ++i)
    for (std::size_t j = 0; j < eta.size(); ++j)
      for (std::size_t k = 0; k < phi.size(); ++k) {
        const Scaled& f = a.forces[a.place(0, i, j, k)];
        const Scaled& g = turned ? b.forces[b.place(0, i, eta.size() - 1 - j, phi.size() - 1 - k)]
                                 : b.forces[b.place(0, i, j, k)];
        largest = std::max({largest, std::abs(f[0] - g[0]), std::abs(f[1] - sign * g[1]),
                            std::abs(f[2] - sign * g[2])});
      }
  return largest;
}

TEST(WheelTable, OfTheOtherWheelIsTheMirrorImage) {
  contact::Case input = rim_case();
  input.table.lateral_shift = {1.0};
  input.table.check_points = 0;
  contact::Case right = input;
  right.wheelset.side = contact::WheelSide::right;
  right.table.lateral_shift = {-1.0};
  const CreepTable a = filled_wheel(input), b = filled_wheel(right);
  EXPECT_NEAR(a.wheels[0].contact_angle, b.wheels[0].contact_angle, 1e-9);
  EXPECT_GT(difference(a, b, false), 0.1);
  EXPECT_LT(difference(a, b, true), 2e-4);  // the mirrored grid has its corner elsewhere
}

TEST(WheelTable, WithoutSlipOfItsSurfaceHoldsForAnyFriction) {
  contact::Case input = rim_case();
  input.table.lateral_shift = {1.0};
  input.table.check_points = 0;
  contact::Case slippery = input;
  slippery.friction_coefficient = 0.1;
  EXPECT_GT(difference(filled_wheel(input), filled_wheel(slippery), false), 1e-3);
  input.rolling.extra_slip = slippery.rolling.extra_slip = contact::ExtraSlip::none;
  EXPECT_LT(difference(filled_wheel(input), filled_wheel(slippery), false), 1e-6);
}

TEST(WheelTable, KnowsWhereAnotherContactComes) {
  // At -13.9 mm tread and root are two contacts, 0.01 mm further one.
  const contact::Case input = with_table(shallow_root(0.0), {-13.9, -13.89}, {2, 2, 2}, 10);
  const CreepTableReader reader(filled_wheel(input));
  const CreepTable& table = reader.table();
  ASSERT_EQ(table.wheels[0].contacts, 2.0);
  ASSERT_EQ(table.wheels[1].contacts, 1.0);
  EXPECT_EQ(table.wheels[0].jump_after, 1.0);
  EXPECT_EQ(table.wheels[1].jump_after, 0.0);
  for (const tables::InterpolatedPoint& point : table.checked)
    EXPECT_TRUE(point.place.first == -13.9 || point.place.first == -13.89) << point.place.first;
  const Scaled creepage{0.002, 0.001, 0.0};
  const double bound = 0.3 * table.wheels[0].normal_force;
  const auto left = reader.of_wheel(-13.9, bound, creepage),
             right = reader.of_wheel(-13.89, bound, creepage),
             between = reader.of_wheel(-13.897, bound, creepage);
  EXPECT_EQ(between.forces, left.forces);
  const double difference =
      std::hypot(left.forces[0] - right.forces[0], left.forces[1] - right.forces[1]);
  EXPECT_GE(between.force_bar, difference);
  EXPECT_GT(difference, 0.01 * bound);
}

void expect_refused(contact::Case input, const std::string& said) {
  input.file = "c.toml";
  const std::string message = refusal<contact::InputError>([&] { tables::empty_table(input); });
  EXPECT_TRUE(says(message, said));
}

TEST(WheelTable, WrongInputIsReported) {
  const contact::Case input = rim_case();
  const auto changed = [&](const auto& change) {
    contact::Case other = input;
    change(other);
    return other;
  };
  expect_refused(changed([](auto& c) { c.table.axis_ratio = {1.0}; }), "over axis ratios or");
  expect_refused(changed([](auto& c) { c.rail.plasticity.emplace(); }), "of elastic bodies");
  expect_refused(changed([](auto& c) { c.table.lateral_shift_step = 0.1; }), "has 3 values");
  expect_refused(changed([](auto& c) {
                   c.table.lateral_shift = {0.0, 1.0};
                   c.table.lateral_shift_step = 0.3;
                 }),
                 "3.33333 steps");
  expect_refused(changed([](auto& c) { c.table.lateral_shift.clear(); }), "lateral_shift = [");
  expect_refused(changed([](auto& c) { c.wheelset.side = contact::WheelSide::both; }),
                 "wheelset.side");
  expect_refused(changed([](auto& c) { c.wheelset.yaw = {0.0, 0.01}; }), "wheelset.yaw");
  expect_refused(changed([](auto& c) {
                   c.wheelset.lateral_shift = {0.0, 1.0};
                 }),
                 "shifts under [table]");
  expect_refused(changed([](auto& c) { c.friction_coefficient = 0.0; }), "friction.coefficient");
  expect_refused(changed([](auto& c) { c.rolling.problem = contact::Problem::frictionless; }),
                 "rolling.problem");
  expect_refused(changed([](auto& c) { c.wheel.profile = c.rail.profile = {}; }), "by radii");
}

TEST(WheelTable, AStepStandsForTheShiftsBetween) {
  contact::Case input = rim_case();
  input.table.lateral_shift = {-1.0, 1.0};
  input.table.lateral_shift_step = 0.5;
  const CreepTable table = tables::empty_table(input);
  EXPECT_EQ(table.lateral_shift, (std::vector<double>{-1.0, -0.5, 0.0, 0.5, 1.0}));
  EXPECT_EQ(table.creepage[0], (std::vector<double>{-3.0, 0.0, 3.0}));
}

TEST(WheelTable, AWheelThatDoesNotTouchSaysAtWhichShift) {
  contact::Case input = rim_case();
  input.table.lateral_shift = {1.0, 90.0};
  CreepTable table = tables::empty_table(input);
  const std::string said =
      refusal<std::exception>([&] { tables::fill_table(table, input, {}, nullptr); });
  EXPECT_TRUE(says(said, "lateral shift of 90 mm"));
}

}  // namespace
