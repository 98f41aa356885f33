// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections with two heads: which gauge face counts, what the message asks, and that the wheel sees
// both heads and the groove between them.
#include "base/errors.hpp"
#include "profiles/profiles.hpp"
#include "track/motion/placed_scenes.hpp"

#include <fmt/format.h>

#include "support/profile_texts.hpp"
#include "support/temporary_folder.hpp"
#include "support/wheel_rail_cases.hpp"
#include <regex>

namespace {

using track::RailPlace;

constexpr double half_gauge = 717.5;

/// A crowned head whose sides become vertical: 14 mm below its top it is 40 mm wide.
struct SyntheticHead {
  double middle = 0.0;  ///< mm, of y
  double top = 0.0;     ///< mm, z
  double z(double y) const {
    const double u = (y - middle) / 20.0;
    return top + (y - middle) * (y - middle) / 600.0 + (14.0 - 400.0 / 600.0) * std::pow(u, 8);
  }
  double slope(double y) const {
    const double u = (y - middle) / 20.0;
    return (y - middle) / 300.0 + (14.0 - 400.0 / 600.0) * 8.0 * std::pow(u, 7) / 20.0;
  }
};

constexpr double floor_z = 50.0;  ///< mm, of the grooves

/// The heads with floors between them, from `first` to `last`; 25 mm beside the outer ones, where
/// the sides are 40 mm and more below the tops.
profiles::ProfileCurve section(const std::vector<SyntheticHead>& heads, double first, double last) {
  const auto highest = [heads](double y) {
    return *std::min_element(heads.begin(), heads.end(),
                             [&](const auto& a, const auto& b) { return a.z(y) < b.z(y); });
  };
  return profile_of([=](double y) { return std::min(floor_z, highest(y).z(y)); },
                    [=](double y) {
                      const SyntheticHead head = highest(y);
                      return head.z(y) < floor_z ? head.slope(y) : 0.0;
                    },
                    first, last, 0.125);
}

profiles::ProfileCurve section(const std::vector<SyntheticHead>& heads) {
  return section(heads, heads.front().middle - 25.0, heads.back().middle + 25.0);
}

const std::vector<SyntheticHead> nose_and_wing{{0.0, 0.0}, {90.0, -3.0}};

std::string question(const profiles::ProfileCurve& rail, const contact::Track& track) {
  return refusal<contact::InputError>([&] { track::rail_place(rail, track); });
}

/// The values that a message offers for gauge_face.
std::vector<double> offers(const std::string& message) {
  const std::regex offer("`gauge_face = ([-0-9.]+)`");
  std::vector<double> values;
  for (std::sregex_iterator it(message.begin(), message.end(), offer), end; it != end; ++it)
    values.push_back(std::stod((*it)[1]));
  return values;
}

TEST(TwoHeads, TheMessageNamesBothGaugeFacesAndTheKey) {
  const std::string message = question(section(nose_and_wing), {});
  EXPECT_TRUE(says(message, "rail.profile has two heads", "top at y = 0.0 mm, z = 0.0 mm",
                   "top at y = 90.0 mm, z = -3.0 mm", "; allowed: ", "; do: ", "[track]"));
  const std::vector<double> faces = offers(message);
  ASSERT_EQ(faces.size(), 2u);
  EXPECT_NEAR(faces[0], -20.0, 2e-4);
  EXPECT_NEAR(faces[1], 70.0, 2e-4);
  // Seen from the other side.
  const std::vector<double> mirrored = offers(question(section(nose_and_wing).mirrored(), {}));
  ASSERT_EQ(mirrored.size(), 2u);
  EXPECT_NEAR(mirrored[0], -110.0, 2e-4);
  EXPECT_NEAR(mirrored[1], -20.0, 2e-4);
}

TEST(TwoHeads, ThreeHeadsAreThreePlaces) {
  const std::vector<double> faces =
      offers(question(section({{-80.0, 2.0}, {0.0, 0.0}, {90.0, -3.0}}), {}));
  ASSERT_EQ(faces.size(), 3u);
  EXPECT_NEAR(faces[0], -100.0, 2e-4);
}

TEST(TwoHeads, TheKeyChoosesTheHeadAndItsTop) {
  contact::Track track;
  track.gauge_face = -20.0;
  RailPlace place = track::rail_place(section(nose_and_wing), track);
  EXPECT_NEAR(place.shift_y, half_gauge + 20.0, 1e-12);
  EXPECT_NEAR(place.shift_z, 0.0, 1e-12);
  track.gauge_face = 71.5;  // as given, not as found
  place = track::rail_place(section(nose_and_wing), track);
  EXPECT_NEAR(place.shift_y, half_gauge - 71.5, 1e-12);
  EXPECT_NEAR(place.shift_z, 3.0, 1e-12);
}

TEST(TwoHeads, AnsweringWithWhatTheMessageOffersPutsThatFaceAtTheGauge) {
  contact::Track track;
  track.inclination = 1.0 / 20.0;
  const auto rail = section(nose_and_wing);
  const std::vector<double> faces = offers(question(rail, track));
  ASSERT_EQ(faces.size(), 2u);
  for (std::size_t head = 0; head < 2; ++head) {
    track.gauge_face = faces[head];
    const RailPlace place = track::rail_place(rail, track);
    const auto placed = track::place_rail(rail, place);
    double top = 1e3, face = 1e3;
    for (double t = placed.first(); t <= placed.last(); t += 1e-3) {
      if ((rail.at(t).y > 45.0) != (head == 1)) continue;
      top = std::min(top, placed.at(t).z);
      if (placed.at(t).z <= 14.0) face = std::min(face, placed.at(t).y);
    }
    EXPECT_NEAR(top, 0.0, 1e-6) << head;
    EXPECT_NEAR(face, half_gauge, 5e-4) << head;
  }
}

TEST(TwoHeads, GaugeFaceServesAProfileThatEndsAboveTheGaugeHeight) {
  const auto flat = profile_of([](double y) { return y * y / 600.0; },
                               [](double y) { return y / 300.0; }, -30.0, 30.0);
  contact::Track track;
  EXPECT_TRUE(says(question(flat, track), "ends 1.5 mm below its top", "track.gauge_face"));
  track.gauge_face = -36.0;
  EXPECT_NEAR(track::rail_place(flat, track).shift_y, half_gauge + 36.0, 1e-12);
}

TEST(TwoHeads, OrdinaryRailsHaveOneAndAreNotTried) {
  for (const profiles::BuiltInProfile& profile : profiles::built_in_profiles()) {
    if (profile.wheel) continue;
    const auto rail = profile.make();
    const RailPlace place = track::rail_place(rail, {}, [](const RailPlace&) -> bool {
      throw std::logic_error("an ordinary rail was tried");
    });
    EXPECT_EQ(place.tops_and_grooves.size(), 1u) << profile.name;
    const auto heads = track::rail_heights(rail, place.tops_and_grooves).knots(),
               whole = track::rail_heights(rail).knots();
    EXPECT_TRUE(std::equal(heads.begin(), heads.end(), whole.begin(), whole.end(),
                           [](const auto& a, const auto& b) { return a.y == b.y; }));
  }
}

TEST(TwoHeads, TheUnmeasuredBackOfAGuardRailIsNoGaugeFace) {
  const auto alone = section({{0.0, 0.0}});
  const auto guarded = section({{-85.0, -10.0}, {0.0, 0.0}}, -97.0, 25.0);
  const RailPlace place = track::rail_place(guarded, {});
  EXPECT_NEAR(place.shift_y, track::rail_place(alone, {}).shift_y, 1e-9);
  EXPECT_NEAR(place.shift_z, 0.0, 1e-12);  // the top of the rail, not of the guard
}

/// Ledges are no heads; a hollow above the gauge height hides no gauge face.
TEST(TwoHeads, ABarBesideTheRailIsAHeadWhereItsGrooveIsDeepEnough) {
  const auto with_bar = [](double lower, double depth) {
    Points points = points_of("60E1");
    const double y = points.back()[0], z = points.back()[1];
    for (double t = z + 0.5; t < depth; t += 0.5) points.push_back({y, t});
    for (double t = 0.5; t < 40.0; t += 0.5) points.push_back({y + t, depth});
    for (double t = depth; t > lower; t -= 0.5) points.push_back({y + 40.0, t});
    for (double t = 0.5; t < 30.0; t += 0.5) points.push_back({y + 40.0 + t, lower});
    contact::ProfileSource source;
    source.name = "rail.csv";
    source.largest_kink = 100.0;
    return profiles::profile_of_text(columns(points), source, false);
  };
  for (const double lower : {3.0, -1.0, 20.0})
    EXPECT_TRUE(says(question(with_bar(lower, 50.0), {}), "rail.profile has two heads",
                     fmt::format("z = {:.1f} mm)", lower),
                     "points of the head that carries the wheel"));
  EXPECT_EQ(question(with_bar(48.0, 50.0), {}), "");
  const auto waves = profile_of(
      [](double y) {
        return 6.0 - 6.0 * std::cos(y * std::acos(-1.0) / 20.0) + std::abs(y) / 50.0;
      },
      [](double y) {
        return 0.3 * std::acos(-1.0) * std::sin(y * std::acos(-1.0) / 20.0) +
               std::copysign(0.02, y);
      },
      -60.0, 60.0);
  contact::Track track;
  track.gauge_height = 8.0;
  EXPECT_TRUE(says(question(waves, track), "rail.profile has 3 heads"));
  track.gauge_height = 12.5;
  EXPECT_FALSE(says(question(waves, track), "heads"));
}

TEST(TwoHeads, HeightsReachOverSteepWalls) {
  const auto rail = section(nose_and_wing);
  const auto place = track::rail_place(rail, {}, [](const RailPlace& at) {
    return at.shift_y > half_gauge;  // the head at y = 0
  });
  ASSERT_EQ(place.tops_and_grooves.size(), 3u);
  const auto heights = track::rail_heights(track::place_rail(rail, place), place.tops_and_grooves);
  for (double y = -18.0; y < 108.0; y += 0.5) {
    double z = floor_z;
    for (const SyntheticHead& head : nose_and_wing) z = std::min(z, head.z(y));
    const bool steep = z > 20.0 && z < floor_z;
    EXPECT_NEAR(heights.at(y + place.shift_y).value, z, steep ? 4.0 : 1e-3) << y;
  }
}

TEST(TwoHeads, AGrooveInGivenCoordinatesBelongsToTheSurface) {
  // A half circle of radius 10 mm, less deep than the gauge height.
  const auto depth = [](double y) { return std::sqrt(std::max(0.0, 100.0 - y * y)); };
  const auto rail = profile_of([&](double y) { return depth(y) - 10.0; },
                               [&](double y) { return depth(y) > 0.0 ? -y / depth(y) : 0.0; },
                               -20.0, 20.0, 0.125);
  contact::Track track;
  track.rail_position = {3.0, 1.0};
  const auto place = track::rail_place(rail, track);
  const auto heights = track::rail_heights(track::place_rail(rail, place), place.tops_and_grooves);
  for (const double y : {-15.0, -5.0, 0.0, 5.0, 15.0})
    EXPECT_NEAR(heights.at(y + 3.0).value, depth(y) - 9.0, 1e-3) << y;
}

contact::Case wheel_case(double shift) {
  contact::Case input = manchester_case(shift, 0.0);
  input.track.inclination = 0.0;
  return input;
}

/// The stock rail's face cannot be at the gauge: the blade would be where the flange is.
TEST(TwoHeads, TheFlangeDecidesOnASwitch) {
  const contact::Case input = wheel_case(0.0);
  for (const double lower : {0.0, 3.0}) {
    const auto search = track::make_search_scene(
        input,
        {profiles::find_built_in_profile("S1002")->make(), section({{-46.0, lower}, {0.0, 0.0}})});
    EXPECT_NEAR(search.rail(true).place.shift_y, half_gauge + 66.0, 1e-4) << lower;
    EXPECT_NEAR(search.rail(true).place.shift_z, -lower, 1e-9);
  }
  // Wider apart the wheel fits both.
  const auto wide = [&] {
    track::make_search_scene(input, {profiles::find_built_in_profile("S1002")->make(),
                                     section({{-90.0, 0.0}, {0.0, 0.0}})});
  };
  EXPECT_EQ(offers(refusal<contact::InputError>(wide)).size(), 2u);
}

/// A cylinder on two equal heads: one contact whose geometry has both.
TEST(TwoHeads, BothCarryTheWheel) {
  contact::Case input = wheel_case(0.0);
  input.load = {};
  input.load.approach = 0.01;
  input.wheelset.roll = {0.0};
  input.track.gauge_face = -20.0;
  const auto cylinder =
      profile_of([](double) { return 0.0; }, [](double) { return 0.0; }, -30.0, 90.0);
  const auto search =
      track::make_search_scene(input, {cylinder, section({{0.0, 0.0}, {50.0, 0.0}})});
  std::array<double, 2> found_at{};
  for (const bool left : {true, false}) {
    const auto found = contacts_of(input, search, left);
    ASSERT_EQ(found.size(), 1u);
    ASSERT_EQ(found[0].touching.size(), 2u);
    for (const auto& touch : found[0].touching) {
      EXPECT_NEAR(std::abs(touch[0]), 25.0, 1e-3);
      EXPECT_NEAR(found[0].geometry.distance(0.0, touch[0]), 0.0, 1e-9);
    }
    EXPECT_NEAR(found[0].geometry.distance(0.0, 0.0), floor_z, 1e-6);
    found_at[left ? 0 : 1] = found[0].place.y_track;
  }
  EXPECT_NEAR(found_at[0], -(half_gauge + 20.0 + 25.0), 1e-3);
  EXPECT_NEAR(found_at[1], -found_at[0], 1e-9);
}

}  // namespace
