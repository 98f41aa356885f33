// SPDX-License-Identifier: LGPL-2.1-or-later
// Lists of equal sections are the plain profile: wheel, rail and both, left and right, by
// themselves and in a wheelset, on rails, rollers and in rings, straight, shifted, rolled and
// yawed.
#include "base/pi.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "track/motion/placed_scenes.hpp"

#include "support/wheel_rail_cases.hpp"

namespace {

using profiles::SectionSurface;

std::shared_ptr<const SectionSurface> equal(const profiles::ProfileCurve& profile,
                                            const std::vector<double>& positions, double turn) {
  std::vector<profiles::PlacedSection> sections;
  for (const double position : positions) sections.push_back({position, profile, {}});
  return std::make_shared<const SectionSurface>(std::move(sections),
                                                profiles::SectionSpline::through, turn);
}

struct Listed {
  const char* name;
  bool rail, wheel;
};

void PrintTo(const Listed& of, std::ostream* stream) {
  *stream << of.name;
}

/// What a run prints of one wheel; signs as on the left.
struct Printed {
  double height, x, y_rail, y_wheel, angle, climb, eta, normal, longitudinal, lateral, pressure,
      length, approach;
};

Printed printed(const track::PlacedScene& placed) {
  const contact::ContactPlace& at = placed.contact.place;
  const contact::PointResult point = halfspace::run_halfspace(placed.scene, {}).points.at(0);
  const double sign = at.left ? 1.0 : -1.0;
  return {at.height,
          at.x_track,
          at.y_rail,
          at.y_wheel,
          at.contact_angle,
          at.climb,
          sign * placed.scene.points.at(0).creepage.lateral,
          point.normal_force,
          point.longitudinal_force,
          sign * point.lateral_force,
          point.max_pressure,
          point.contact_length,
          point.approach};
}

/// `places` in mm; `relative` of forces, pressures and sizes.
void expect_alike(const Printed& a, const Printed& b, double places, double relative) {
  EXPECT_NEAR(a.height, b.height, 1e-6);
  EXPECT_NEAR(a.x, b.x, 5.0 * places);
  EXPECT_NEAR(a.y_rail, b.y_rail, places);
  EXPECT_NEAR(a.y_wheel, b.y_wheel, places);
  EXPECT_NEAR(a.angle, b.angle, 0.3 * places);
  EXPECT_NEAR(a.climb, b.climb, 0.01 * places);
  EXPECT_NEAR(a.eta, b.eta, 0.03 * places);
  EXPECT_NEAR(a.normal, b.normal, relative * b.normal);
  EXPECT_NEAR(a.longitudinal, b.longitudinal, relative * b.normal);
  EXPECT_NEAR(a.lateral, b.lateral, relative * b.normal);
  EXPECT_NEAR(a.pressure, b.pressure, relative * b.pressure);
  EXPECT_NEAR(a.length, b.length, 3.0 * relative * b.length);
  EXPECT_NEAR(a.approach, b.approach, relative * b.approach);
}

class EqualSections : public ::testing::TestWithParam<Listed> {
 protected:
  track::ProfilePair listed() const {
    track::ProfilePair pair = plain_;
    const double turn = 2.0 * contact::pi;
    if (GetParam().wheel) pair.wheel_sections = equal(pair.wheel, {0.0, 2.0, 4.0, turn}, turn);
    if (GetParam().rail) pair.rail_sections = equal(pair.rail, {-50.0, 0.0, 70.0}, 0.0);
    return pair;
  }
  std::vector<track::PlacedScene> scenes(const track::ProfilePair& pair) const {
    return track::make_scenes(input_, track::make_search_scene(input_, pair));
  }
  /// A wheel by itself; signs of lateral position and turns are those of the left one.
  void place(double shift, double yaw, double roll, double rail_radius) {
    input_ = manchester_case(shift, yaw);
    input_.load.vertical_force = 80e3;
    input_.wheelset.on_rail = true;
    input_.wheelset.roll = {roll};
    input_.rail.rolling_radius = rail_radius;
    at_the_way();
  }
  void at_the_way() {
    input_.wheelset.track_position = {3.0};
    input_.wheelset.wheel_angle = {1.0};
    input_.contact_grid.elements_across = 12;
  }
  const track::ProfilePair plain_ = manchester_pair();
  contact::Case input_;
};

TEST_P(EqualSections, AreThePlainProfileOnBothSides) {
  for (const double rail_radius : {contact::infinity, 500.0, -2000.0})
    for (const auto& [shift, yaw, roll] :
         {std::array{-3.0, 0.0, 0.0}, {1.0, 0.0, 0.01}, {2.0, 0.02, -0.01}}) {
      SCOPED_TRACE(::testing::Message() << rail_radius << " " << shift << " " << yaw);
      place(shift, yaw, roll, rail_radius);
      Printed left{};
      for (const contact::WheelSide side : {contact::WheelSide::left, contact::WheelSide::right}) {
        input_.wheelset.side = side;
        const auto family = scenes(listed()), plain = scenes(plain_);
        ASSERT_EQ(family.size(), plain.size());
        const Printed found = printed(family[0]);
        // At yaw the plain outline takes the circle of the wheel for the width of the overlap.
        expect_alike(found, printed(plain[0]), yaw == 0.0 ? 5e-4 : 2e-3, yaw == 0.0 ? 5e-5 : 3e-4);
        if (side == contact::WheelSide::left) left = found;
        expect_alike(found, left, 1e-9, 1e-9);
      }
    }
}

TEST_P(EqualSections, AreThePlainProfileInAWheelset) {
  for (const double shift : {0.0, 1.0, 5.0}) {
    SCOPED_TRACE(shift);
    input_ = manchester_case(shift, 0.0);
    input_.load.vertical_force = 80e3;
    input_.track.inclination = 0.0;
    input_.track.rail_position = {755.0, 0.0};
    at_the_way();
    input_.wheelset.side = contact::WheelSide::both;
    const auto family = scenes(listed()), plain = scenes(plain_);
    ASSERT_EQ(family.size(), plain.size());
    for (std::size_t k = 0; k < plain.size(); ++k)
      expect_alike(printed(family[k]), printed(plain[k]), 1e-3, 1e-4);
    // Its mirror image, moved to the other side.
    input_.wheelset.lateral_shift = {-shift};
    const auto mirrored = scenes(listed());
    for (const track::PlacedScene& here : family)
      for (const track::PlacedScene& there : mirrored)
        if (here.contact.place.left != there.contact.place.left &&
            here.contact.place.patch == there.contact.place.patch)
          expect_alike(printed(here), printed(there), 1e-6, 1e-6);
  }
}

TEST_P(EqualSections, CarryAsThePlainProfileAtAGivenHeight) {
  place(0.0, 0.04, 0.0, 500.0);
  input_.wheelset.side = contact::WheelSide::right;
  input_.load = {};
  input_.wheelset.height = {0.05};
  expect_alike(printed(scenes(listed()).at(0)), printed(scenes(plain_).at(0)), 2e-3, 3e-4);
}

INSTANTIATE_TEST_SUITE_P(Lists, EqualSections,
                         ::testing::Values(Listed{"Rail", true, false},
                                           Listed{"Wheel", false, true},
                                           Listed{"Both", true, true}),
                         [](const auto& list) { return std::string(list.param.name); });

}  // namespace
