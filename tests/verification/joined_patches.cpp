// SPDX-License-Identifier: LGPL-2.1-or-later
// Several patches of one wheel share its load by equilibrium and press on each other through the
// bodies: on one grid, where forces stay continuous while patches appear, join, separate and
// vanish, and in different planes. References: Hertz with a point load at the distance of the other
// patch, the joint solution on one grid, and the curved surface, whose normals are those of every
// place.
#include "base/pi.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/patch/load_sharing.hpp"
#include "result/patch_size.hpp"
#include "track/balance/balance.hpp"
#include "track/balance/position.hpp"

#include "support/patch_case.hpp"
#include "support/profile_patches.hpp"
#include "support/thesis_cases.hpp"
#include "support/two_humps.hpp"
#include "support/worn_wheels.hpp"

namespace {

constexpr double half_distance = 15.0;  // mm

contact::Scene two_humps(double lower, double force) {
  PatchCase input = rollfem::testing::two_humps(lower, force, half_distance);
  input.contact_grid.cell_size = {0.25, 0.1};
  return input;
}

using Approach = std::function<double(double)>;

/// Force on the second of two contacts by Hertz, each sunk by the other as by a point load at its
/// distance: delta_1(N1) + N2 / (pi E* d) = delta_2(N2) + N1 / (pi E* d) + separation.
double force_on_second(const Approach& first, const Approach& second, double modulus,
                       double distance, double separation, double force) {
  const double by_other = 1.0 / (pi * modulus * distance);
  double below = 0.0, above = force;
  for (int step = 0; step < 60; ++step) {
    const double n = 0.5 * (below + above), rest = force - n;
    const bool excess = second(n) + rest * by_other + separation > first(rest) + n * by_other;
    (excess ? above : below) = n;
  }
  return below;
}

/// A contact of known bodies, `way` (mm) beside the first one along the surface.
PatchCase hertzian(double rail_radius, double separation, double way) {
  PatchCase input = thesis_case('b');
  input.load = {};
  input.load.normal_force = 1.0;
  input.rail.transverse_radius = rail_radius;
  input.patch = circles(405.0, contact::infinity, rail_radius);
  input.place.emplace();
  input.place->separation = separation;
  input.place->way_across = way;
  return input;
}

Approach approach_of(double wheel, double rail, double modulus) {
  return [=](double n) {
    return n > 0.0 ? halfspace::hertz_from_force(0.5 / wheel, 0.5 / rail, modulus, n).approach
                   : 0.0;
  };
}

/// Forces of a wheel on the track, N, and their parts.
struct OnTrack {
  std::array<double, 3> force{};  ///< x, towards the middle, upwards
  std::size_t contacts = 0;
  int patches = 0;
  std::vector<double> normal_force;  ///< N, of every patch, the most loaded first
  double max_pressure = 0.0;

  double difference(const OnTrack& other) const {
    double largest = 0.0;
    for (int d = 0; d < 3; ++d) largest = std::max(largest, std::abs(force[d] - other.force[d]));
    return largest;
  }
};

OnTrack on_track(const std::vector<contact::Scene>& scenes) {
  OnTrack sum;
  sum.contacts = scenes.size();
  for (const contact::Scene& scene : scenes) {
    const contact::ModelResult result = halfspace::run_halfspace(scene, {});
    const contact::PointResult& point = result.points.front();
    for (const contact::PatchPart& part : contact::patch_parts(result.grid, point.fields))
      sum.normal_force.push_back(part.normal_force);
    const double angle = scene.place->contact_angle;
    sum.force[0] += point.longitudinal_force;
    sum.force[1] += point.normal_force * std::sin(angle) - point.lateral_force * std::cos(angle);
    sum.force[2] += track::vertical_force(point.normal_force, point.lateral_force, *scene.place);
    sum.patches += point.patch_count;
    sum.max_pressure = std::max(sum.max_pressure, point.max_pressure);
  }
  return sum;
}

/// A wheel in balance.
OnTrack solved(const contact::Case& input, int across) {
  std::vector<contact::Scene> scenes = track::balance(input).scenes;
  for (contact::Scene& scene : scenes) scene.contact_grid.elements_across = across;
  return on_track(scenes);
}

OnTrack shallow_root(double shift, contact::SurfaceForm surface = contact::SurfaceForm::automatic) {
  contact::Case input = rollfem::testing::shallow_root(shift);
  input.surface = surface;
  return solved(input, 24);
}

/// Left wheel S1002 on UIC60, 100 kN: at -4.4 mm it stands on the tread, at -6 mm on the flange
/// root.
contact::Case at_the_root(double shift) {
  contact::Case input = steep_flange(shift);
  input.load.vertical_force = 100e3;
  input.wheel.profile = {};
  input.wheel.profile.name = "S1002";
  input.wheel.rolling_radius = 450.0;
  input.rail.profile.name = "UIC60-manchester";
  return input;
}

/// A wheel moved sideways.
struct Sweep {
  contact::Case (*at)(double shift);
  double load;  ///< N

  OnTrack operator()(double shift) const { return solved(at(shift), 20); }

  /// The largest change of a force between two positions, relative to the load.
  double change(const OnTrack& a, const OnTrack& b) const { return a.difference(b) / load; }

  /// From -> to between two positions, within a micrometre: where the number of patches changes.
  std::array<OnTrack, 2> across_event(double from, double to) const {
    std::array<OnTrack, 2> ends{(*this)(from), (*this)(to)};
    while (to - from > micrometre) {
      const double middle = 0.5 * (from + to);
      const OnTrack there = (*this)(middle);
      const bool as_before = there.patches == ends[0].patches;
      (as_before ? from : to) = middle;
      ends[as_before ? 0 : 1] = there;
    }
    return ends;
  }

  static constexpr double micrometre = 1e-3;  // mm
};

TEST(JoinedPatches, ShareAsHertzAndTheirDistanceSay) {
  constexpr double force = 40e3;
  for (const double lower : {0.0, 0.01, 0.03}) {
    SCOPED_TRACE(lower);
    const contact::Scene scene = two_humps(lower, force);
    const contact::ModelResult result = halfspace::run_halfspace(scene, {});
    const auto parts = contact::patch_parts(result.grid, result.points[0].fields);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(result.points[0].patch_count, 2);
    EXPECT_NEAR(parts[0].normal_force + parts[1].normal_force, force, 1e-6 * force);
    const double modulus = scene.material.contact_modulus;
    const Approach hump = approach_of(wheel_over_humps, hump_radius, modulus);
    const double exact = force_on_second(hump, hump, modulus, 2.0 * half_distance, -lower, force);
    // Each by itself: 1.7 % more on the higher hump at 0.01 mm, 5 % at 0.03 mm.
    EXPECT_NEAR(parts[0].normal_force, exact, 2e-3 * force);
    EXPECT_NEAR(std::abs(parts[0].y), half_distance, 0.01);
    EXPECT_NEAR(parts[0].y + parts[1].y, 0.0, 0.01);
  }
}

TEST(JoinedPatches, ForcesAreContinuousAsPatchesComeAndGo) {
  const Sweep sweep{hollow_tread, 80e3};
  constexpr double step = 0.2;
  int events = 0;
  double at = -1.2;
  OnTrack last = sweep(at);
  for (int k = 0; k < 12; ++k) {
    const double next_at = at + step;
    const OnTrack next = sweep(next_at);
    EXPECT_LT(sweep.change(next, sweep(next_at + Sweep::micrometre)), 1e-3) << next_at;
    if (next.patches != last.patches) {
      const auto [before, after] = sweep.across_event(at, next_at);
      EXPECT_LT(sweep.change(before, after), 1e-3) << at;
      ++events;
    }
    at = next_at;
    last = next;
  }
  EXPECT_GE(events, 2);  // the second patch comes, the first goes
}

TEST(JoinedPatches, ForcesAreContinuousAsPatchesJoinAndPart) {
  // From the flange root to the tread: a second patch appears, joins the first, separates from it,
  // and the first vanishes.
  const Sweep sweep{at_the_root, 100e3};
  const std::array<double, 5> places{-6.0, -5.5, -5.2, -4.9, -4.4};
  const std::array<int, 5> patches{1, 2, 1, 2, 1};
  for (int k = 0; k < 4; ++k) {
    SCOPED_TRACE(places[k]);
    EXPECT_EQ(sweep(places[k]).patches, patches[k]);
    const auto [before, after] = sweep.across_event(places[k], places[k + 1]);
    EXPECT_EQ(after.patches, patches[k + 1]);
    EXPECT_LT(sweep.change(before, after), 1e-3);
  }
}

TEST(JoinedPatches, ReferenceMovesSteadilyWhereAnotherPatchBecomesTheDeepest) {
  std::vector<double> angle, place, root_deepest;
  for (int k = 0; k <= 40; ++k) {
    const track::PlacedScene placed = track::make_scenes(at_the_root(-5.4 + 0.01 * k)).at(0);
    angle.push_back(placed.contact.place.contact_angle);
    place.push_back(placed.contact.place.y_track);
    const auto& humps = placed.contact.touching;
    const auto deepest =
        std::min_element(humps.begin(), humps.end(), [](auto& a, auto& b) { return a[1] < b[1]; });
    root_deepest.push_back(deepest == humps.begin() ? 1.0 : 0.0);
  }
  ASSERT_EQ(root_deepest.front(), 1.0);
  ASSERT_EQ(root_deepest.back(), 0.0);
  // 0.003 rad and 0.2 mm over 0.01 mm here; they once changed as much at one place.
  for (std::size_t k = 2; k < angle.size(); ++k) {
    EXPECT_NEAR(angle[k] - angle[k - 1], angle[k - 1] - angle[k - 2], 2e-4) << k;
    EXPECT_NEAR(place[k] - place[k - 1], place[k - 1] - place[k - 2], 0.015) << k;
  }
}

TEST(JoinedPatches, OfOtherPlanesShareTheLoadOfTheWheel) {
  contact::Case input = steep_flange(-4.29);
  input.load.vertical_force = 60e3;
  std::vector<contact::ModelResult> results;
  double vertical = 0.0;
  for (contact::Scene scene : track::balance(input).scenes) {
    contact::ModelResult result = halfspace::run_halfspace(scene, {});
    result.place = scene.place;
    for (contact::PointResult& point : result.points)
      point.vertical_force =
          track::vertical_force(point.normal_force, point.lateral_force, *scene.place);
    vertical += *result.points[0].vertical_force;
    results.push_back(std::move(result));
  }
  ASSERT_EQ(results.size(), 2U);
  EXPECT_GT(results[0].points[0].normal_force, results[1].points[0].normal_force);
  EXPECT_GT(std::abs(results[0].place->contact_angle - results[1].place->contact_angle), 1.0);
  EXPECT_NEAR(vertical, 60e3, 1e-6 * 60e3);
  EXPECT_NO_THROW(track::check_results(input, results));
}

TEST(JoinedPatches, ReferenceDoesNotChangeForcesWhereNormalsAreTrue) {
  // On the common surface with its own normals the reference is a matter of description: forces on
  // the track are the same 1 mm beside it, where plane and spin are others.
  contact::Case input = hollow_tread(-0.6);
  input.surface = contact::SurfaceForm::curved;
  const auto with_reference = [&](double offset) {
    track::SearchOptions options;
    options.reference_offset = offset;
    contact::Scene scene = track::make_scenes(input, options).at(0).scene;
    scene.contact_grid.cell_size = {0.25, 0.2};
    return on_track({scene});
  };
  const OnTrack middle = with_reference(0.0);
  EXPECT_NEAR(middle.force[2], 80e3, 1e-6 * 80e3);
  for (const double offset : {-1.0, 1.0}) {
    SCOPED_TRACE(offset);
    const OnTrack beside = with_reference(offset);
    EXPECT_LT(beside.difference(middle), 1e-4 * 80e3);
    EXPECT_NEAR(beside.max_pressure, middle.max_pressure, 1e-3 * middle.max_pressure);
  }
}

TEST(ContactsOfOtherPlanes, FeelEachOtherAsPointLoads) {
  constexpr double force = 60e3, way = 40.0;
  for (const double separation : {0.0, 0.01, 0.03}) {
    SCOPED_TRACE(separation);
    const contact::Scene first = hertzian(300.0, 0.0, 0.0),
                         second = hertzian(80.0, separation, way);
    const auto shared = halfspace::share_load({first, second}, force);
    const double modulus = first.material.contact_modulus;
    const double exact =
        force_on_second(approach_of(405.0, 300.0, modulus), approach_of(405.0, 80.0, modulus),
                        modulus, way, separation, force);
    // Each by itself: 0.4, 0.8 and 1.5 % of the load more on the second.
    EXPECT_NEAR(shared.shares[1].normal_force, exact, 1.5e-3 * force);
    EXPECT_NEAR(shared.shares[0].normal_force + shared.shares[1].normal_force, force, 1e-6 * force);
  }
}

TEST(ContactsOfOtherPlanes, AreTheJointSolutionInNearlyOnePlane) {
  // The rims of a hollow tread as one contact, and as two that displace each other.
  contact::Case input = hollow_tread(-0.2);
  track::SearchOptions apart;
  apart.merge_angle = 0.0;
  const auto two = track::make_scenes(input, apart);
  ASSERT_EQ(two.size(), 2U);
  const auto on_24_across = [](std::vector<contact::Scene> scenes) {
    for (contact::Scene& scene : scenes) scene.contact_grid.elements_across = 24;
    return on_track(scenes);
  };
  const OnTrack two_grids = on_24_across(track::balanced_position(input, two));
  EXPECT_EQ(two_grids.contacts, 2U);
  EXPECT_NEAR(two_grids.force[2], 80e3, 1e-6 * 80e3);
  input.surface = contact::SurfaceForm::curved;
  const auto joint = track::make_scenes(input);
  ASSERT_EQ(joint.size(), 1U);
  const OnTrack one_grid = on_24_across({joint[0].scene});
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

}  // namespace
