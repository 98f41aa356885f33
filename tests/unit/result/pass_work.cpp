// SPDX-License-Identifier: LGPL-2.1-or-later
// Frictional work over the rows of a grid: the sum over tractions and slip by hand, its integral
// against the frictional work, and the place of the rows on the profiles.
#include "base/errors.hpp"
#include "base/pi.hpp"
#include "result/derived.hpp"
#include "track/motion/placed_scenes.hpp"

#include "support/test.hpp"

namespace {

using contact::Field;

/// Two rows of three elements of 0.5 by 0.2 mm.
const ContactGrid small{3, 2, 0.5, 0.2, -0.5, -0.1};

Field field(std::initializer_list<double> values) {
  Field found(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), found.begin());
  return found;
}

const contact::SurfaceField traction{field({-10, -20, 0, 0, -30, -40}), field({0, 5, 0, 0, 0, -10}),
                                     field({100, 100, 100, 100, 100, 100})};
const contact::TangentialField slip{field({1e-3, 2e-3, 0, 0, 1e-3, 2e-3}),
                                    field({0, -1e-3, 0, 0, 0, 1e-3})};

TEST(PassWork, IsTheSumAlongRollingOfTractionTimesSlip) {
  const Field work = contact::pass_work(small, traction, slip);
  ASSERT_EQ(work.size(), 2);
  EXPECT_NEAR(work[0], 0.5 * (10e-3 + 40e-3 + 5e-3), 1e-15);
  EXPECT_NEAR(work[1], 0.5 * (30e-3 + 80e-3 + 10e-3), 1e-15);
  EXPECT_THROW(contact::pass_work(small, traction, {field({0.0}), field({0.0})}),
               contact::InputError);
}

/// Row 0 slips in its first two elements, row 1 in its last two; then none slips.
TEST(PassWork, ThatElementsLackBelongsToThoseThatSlipOrToTheLastInContact) {
  contact::PointResult point;
  point.fields.traction = traction;
  point.fields.slip = slip;
  const Field own = contact::pass_work(small, traction, slip);
  contact::set_pass_work(small, field({own[0] + 0.3, 0.5 * own[1]}), point);
  EXPECT_NEAR(point.max_pass_work.value(), own[0] + 0.3, 1e-15);
  const double sizes[] = {10.0, std::hypot(20.0, 5.0)};
  EXPECT_NEAR(point.fields.work[0], 10e-3 + 0.6 * sizes[0] / (sizes[0] + sizes[1]), 1e-15);
  EXPECT_NEAR(point.fields.work[1], 45e-3 + 0.6 * sizes[1] / (sizes[0] + sizes[1]), 1e-15);
  EXPECT_EQ(point.fields.work[2], 0.0);
  EXPECT_NEAR(point.fields.work[4], 15e-3, 1e-15);
  EXPECT_NEAR(point.fields.work[5], 45e-3, 1e-15);
  point.fields.slip = {Field::Zero(6), Field::Zero(6)};
  contact::set_pass_work(small, field({0.2, 0.4}), point);
  EXPECT_NEAR((point.fields.work - field({0.4, 0, 0, 0, 0.8, 0})).norm(), 0.0, 1e-15);
  EXPECT_NEAR((contact::pass_work(small, point) - field({0.2, 0.4})).norm(), 0.0, 1e-15);
}

/// Any even kernel: it does no work on its own displacement.
TEST(PassWork, CentralDifferencesOfASymmetricOperatorGiveNoWork) {
  const ContactGrid line{12, 1, 0.25, 1.0, 0.0, 0.0};
  Field pressure = Field::Zero(12), displacement(12);
  for (int i = 1; i < 11; ++i) pressure[i] = std::sin(0.3 * i) + 0.1 * (i % 3);
  for (int i = 0; i < 12; ++i) {
    displacement[i] = 0.0;
    for (int k = 0; k < 12; ++k) displacement[i] += pressure[k] / (1.0 + std::abs(i - k));
  }
  EXPECT_NEAR(pressure.dot(contact::slope_along(line, displacement)), 0.0, 1e-13);
  const Field slope =
      contact::slope_along(line, line.sample([](double x, double) { return 2.0 * x; }));
  EXPECT_NEAR(slope[5], -2.0, 1e-14);
}

TEST(PassWork, OverTheWidthsIsThePowerOfFrictionOnASurfaceThatClimbsToo) {
  const contact::PatchShape shape{field({1, 1, 1, 1.25, 1.25, 1.25}),
                                  field({0, 0, 0, 0.75, 0.75, 0.75})};
  const Field work = contact::pass_work(small, traction, slip);
  const double friction =
      contact::power_balance(small, contact::times_stretch(traction, shape), slip, {}, 1.0)
          .friction;
  EXPECT_NEAR(friction, 0.2 * (work[0] + 1.25 * work[1]), 1e-15);
}

/// S1002 on 60E1: the left and the right wheel, shifted to the right.
Case wheelset(double shift) {
  Case input;
  input.load.vertical_force = 60e3;
  input.friction_coefficient = 0.3;
  input.wheel.rolling_radius = 460.0;
  input.wheel.profile.name = "S1002";
  input.rail.profile.name = "60E1";
  input.track.inclination = 1.0 / 40.0;
  input.wheelset.side = contact::WheelSide::both;
  input.wheelset.lateral_shift = {shift};
  return input;
}

struct Rows {
  contact::ModelResult result;
  contact::PatchGeometry geometry;
  contact::ContactPlace place;
};

/// Rows through the reference point, in a plane.
Rows rows_of(const track::PlacedScene& placed) {
  Rows rows{{}, placed.contact.geometry, placed.contact.place};
  rows.result.grid = ContactGrid::centred(1, 21, 0.5, 0.3);
  contact::place_pass_work({placed.scene.geometry, contact::Chart::plane}, placed.scene.place,
                           rows.result);
  return rows;
}

/// z of a profile, mm, where the curve runs from the flange or the gauge face to the field side.
double height(const profiles::ProfileCurve& curve, double y) {
  double low = curve.first(), high = curve.last();
  while (high - low > 1e-12) {
    const double middle = 0.5 * (low + high);
    (curve.at(middle).y < y ? low : high) = middle;
  }
  return curve.at(low).z;
}

/// Moving the bodies into their places changes no distance between points of their sections.
TEST(PassWork, RowsLieOnTheProfilesOfBothWheels) {
  for (const double shift : {0.0, 3.0}) {
    const Case input = wheelset(shift);
    const track::SearchScene search = track::search_scene_of(input);
    for (const track::PlacedScene& placed : track::make_scenes(input, search)) {
      const Rows rows = rows_of(placed);
      const Field &wheel = rows.result.rows.y_wheel, &rail = rows.result.rows.y_rail;
      const ContactGrid& grid = rows.result.grid;
      EXPECT_NEAR(wheel[10], rows.place.y_wheel, 1e-3);
      EXPECT_NEAR(rail[10], rows.place.y_rail, 1e-9);
      for (const int j : {0, 5, 20}) {
        const double y = grid.y(j), drop = rows.geometry.rail().at(y).value;
        const auto apart = [&](const profiles::ProfileCurve& curve, const Field& at) {
          return std::hypot(at[j] - at[10], height(curve, at[j]) - height(curve, at[10]));
        };
        EXPECT_NEAR(apart(search.profiles.rail, rail), std::hypot(y, drop), 1e-6) << shift << j;
        // The section of a rolled wheel is that of its plane to the square of the roll.
        const double climb =
            rows.geometry.wheel().at(y).value - rows.geometry.wheel().at(0.0).value;
        EXPECT_NEAR(apart(search.profiles.wheel, wheel), std::hypot(y, climb), 1e-5) << shift << j;
        EXPECT_GT((wheel[20] - wheel[0]) * rows.place.outward(), 5.9);
        EXPECT_GT((rail[20] - rail[0]) * rows.place.outward(), 5.9);
      }
      EXPECT_EQ(rows.result.rows.width.minCoeff(), 0.3);
    }
  }
}

TEST(PassWork, SaysWhereTheLargestIsAndWhatARevolutionTakes) {
  contact::Geometry geometry;
  geometry.surface.rolling_radius = 500.0;
  contact::ModelResult result;
  result.grid = small;
  result.points.resize(2);
  contact::PointResult& point = result.points[0];
  point.fields.traction = traction;
  point.fields.slip = slip;
  point.frictional_work = 20.0;
  contact::set_pass_work(small, contact::pass_work(small, traction, slip), point);
  EXPECT_NEAR(point.max_pass_work.value(), 0.06, 1e-15);
  contact::place_pass_work({geometry, contact::Chart::plane}, {}, result);
  EXPECT_NEAR(point.pass_work_y_wheel.value(), 0.1, 1e-15);
  EXPECT_NEAR(point.pass_work_y_rail.value(), 0.1, 1e-15);
  EXPECT_NEAR(point.revolution_work.value(), 0.02 * 2.0 * contact::pi * 500.0, 1e-9);
  EXPECT_FALSE(result.points[1].pass_work_y_wheel.has_value());
}

}  // namespace
