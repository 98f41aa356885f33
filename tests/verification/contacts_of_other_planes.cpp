// Contacts of one wheel in different planes share its load and displace each other as patches of
// one contact do. References: Hertz with a point load at the distance of the other contact, the
// joint solution on one grid, and the curved surface, whose normals are those of every place.
#include "contact/base/pi.hpp"
#include "contact/result/patch_parts.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/model.hpp"
#include "halfspace/patch/load_sharing.hpp"
#include "track/balance/balance.hpp"
#include "track/balance/position.hpp"
#include "track/motion/wheelset_motion.hpp"

#include <gtest/gtest.h>

#include "support/patch_case.hpp"
#include "support/profile_patches.hpp"
#include "support/thesis_cases.hpp"
#include "support/worn_wheels.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace rollfem;
using contact::pi;

namespace {

/// A contact of known bodies, `way` (mm) beside the first one along the surface.
rollfem::testing::PatchCase hertzian(double rail_radius, double separation, double way) {
  rollfem::testing::PatchCase input = rollfem::testing::thesis_case('b');
  input.load = {};
  input.load.normal_force = 1.0;
  input.rail.transverse_radius = rail_radius;
  input.patch = rollfem::testing::circles(405.0, contact::infinity, rail_radius);
  input.place.emplace();
  input.place->separation = separation;
  input.place->way_across = way;
  return input;
}

/// Force on the second contact by Hertz, each sunk by the other as by a point load.
double force_on_second(const contact::Scene& first, const contact::Scene& second, double way,
                       double force) {
  const auto approach = [](const contact::Scene& scene, double n) {
    contact::Scene loaded = scene;
    loaded.points.front().load = {n, {}};
    return n > 0.0 ? halfspace::hertz_of_scene(loaded).approach : 0.0;
  };
  const double by_other = 1.0 / (pi * first.material.contact_modulus * way);
  double below = 0.0, above = force;
  for (int step = 0; step < 60; ++step) {
    const double n = 0.5 * (below + above), rest = force - n;
    const bool too_much = approach(second, n) + rest * by_other + second.place->separation >
                          approach(first, rest) + n * by_other;
    (too_much ? above : below) = n;
  }
  return below;
}

/// Forces of a wheel on the track, N: along it, to the side, and how many contacts make them.
struct OnTrack {
  std::array<double, 3> force{};  ///< x, towards the middle, upwards
  std::size_t contacts = 0;
  std::vector<double> normal_force;  ///< N, of every patch, the most loaded first

  double difference(const OnTrack& other) const {
    double largest = 0.0;
    for (int d = 0; d < 3; ++d) largest = std::max(largest, std::abs(force[d] - other.force[d]));
    return largest;
  }
};

OnTrack on_track(std::vector<contact::Scene> scenes) {
  OnTrack sum;
  sum.contacts = scenes.size();
  for (contact::Scene& scene : scenes) {
    scene.contact_grid.elements_across = 24;
    const contact::ModelResult result = halfspace::run_halfspace(scene, {});
    const contact::PointResult& point = result.points.front();
    for (const contact::PatchPart& part : contact::patch_parts(result.grid, point.fields))
      sum.normal_force.push_back(part.normal_force);
    const double angle = scene.place->contact_angle;
    sum.force[0] += point.longitudinal_force;
    sum.force[1] += point.normal_force * std::sin(angle) - point.lateral_force * std::cos(angle);
    sum.force[2] += track::vertical_force(point.normal_force, point.lateral_force, *scene.place);
  }
  return sum;
}

OnTrack shallow_root(double shift, contact::SurfaceForm surface = contact::SurfaceForm::automatic) {
  contact::Case input = rollfem::testing::shallow_root(shift);
  input.halfspace.surface = surface;
  return on_track(track::balance(input).scenes);
}

}  // namespace

TEST(ContactsOfOtherPlanes, FeelEachOtherAsPointLoads) {
  constexpr double force = 60e3, way = 40.0;
  for (const double separation : {0.0, 0.01, 0.03}) {
    SCOPED_TRACE(separation);
    const contact::Scene first = hertzian(300.0, 0.0, 0.0),
                         second = hertzian(80.0, separation, way);
    const auto shared = halfspace::share_load({first, second}, force);
    const double exact = force_on_second(first, second, way, force);
    // Each by itself: 0.4, 0.8 and 1.5 % of the load more on the second.
    EXPECT_NEAR(shared.shares[1].normal_force, exact, 1.5e-3 * force);
    EXPECT_NEAR(shared.shares[0].normal_force + shared.shares[1].normal_force, force, 1e-6 * force);
  }
}

TEST(ContactsOfOtherPlanes, AreTheJointSolutionInNearlyOnePlane) {
  // The rims of a hollow tread as one contact, and as two that displace each other.
  contact::Case input = rollfem::testing::hollow_tread(-0.2);
  track::SearchOptions apart;
  apart.merge_angle = 0.0;
  const auto two = track::make_scenes(input, apart);
  ASSERT_EQ(two.size(), 2U);
  const OnTrack two_grids = on_track(track::balanced_position(input, two));
  EXPECT_EQ(two_grids.contacts, 2U);
  EXPECT_NEAR(two_grids.force[2], 80e3, 1e-6 * 80e3);
  input.halfspace.surface = contact::SurfaceForm::curved;
  const auto joint = track::make_scenes(input);
  ASSERT_EQ(joint.size(), 1U);
  const OnTrack one_grid = on_track({joint[0].scene});
  EXPECT_LT(two_grids.difference(one_grid), 1e-3 * 80e3);
  // Each by itself: 1.4 % of the load more on the higher rim.
  EXPECT_NEAR(two_grids.normal_force[1], one_grid.normal_force[1], 1e-3 * 80e3);
}

TEST(ContactsOfOtherPlanes, ForcesPassTwentyDegreesSteadily) {
  double from = -13.9, to = -13.895;
  OnTrack apart = shallow_root(from), joint = shallow_root(to);
  ASSERT_EQ(apart.contacts, 2U);
  ASSERT_EQ(joint.contacts, 1U);
  while (to - from > 0.4e-3) {
    const double middle = 0.5 * (from + to);
    const OnTrack there = shallow_root(middle);
    (there.contacts == 2 ? from : to) = middle;
    (there.contacts == 2 ? apart : joint) = there;
  }
  constexpr double load = 80e3;
  EXPECT_NEAR(apart.force[2], load, 1e-6 * load);
  EXPECT_NEAR(joint.force[2], load, 1e-6 * load);
  // The wheel's own change is 0.07 % over a micrometre here. A plane for both has 6 % of the load
  // less to the side, planes that do not displace each other have 1 % more.
  EXPECT_LT(apart.difference(joint), 1e-3 * load);
  const OnTrack surface = shallow_root(from, contact::SurfaceForm::curved);
  EXPECT_EQ(surface.contacts, 1U);
  EXPECT_LT(apart.difference(surface), 1e-3 * load);
}
