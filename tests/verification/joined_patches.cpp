// Several patches in one scene: they share the load by equilibrium on one grid, pressing on each
// other through the bodies, and forces stay continuous while patches come, join, part and go.
#include "contact/result/patch_parts.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/model/model.hpp"
#include "track/balance/balance.hpp"

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

namespace {

constexpr double half_distance = 15.0;  // mm
constexpr double hump_radius = 80.0;
constexpr double wheel_radius = 460.0;

/// A cylindrical wheel over two humps, of which the one at larger y is lower by `lower` (mm).
contact::Scene two_humps(double lower, double force) {
  const double crest = half_distance * half_distance / (2.0 * hump_radius);
  const auto rail = rollfem::testing::sampled_curve(-30.0, 30.0, 0.05, [&](double y) {
    const double across = std::abs(y) - half_distance;
    const double drop = across * across / (2.0 * hump_radius);
    // Half of the drop on each side, so that the rail passes through the origin in the valley.
    const double step = y > 0.0 ? -lower * (1.0 - std::exp(-y * y / 4.0)) : 0.0;
    const double step_slope = y > 0.0 ? -lower * 0.5 * y * std::exp(-y * y / 4.0) : 0.0;
    return rollfem::testing::HeightAndSlope{
        crest - drop + step, -(y > 0.0 ? 1.0 : -1.0) * across / hump_radius + step_slope};
  });
  const auto radius = rollfem::testing::sampled_curve(-30.0, 30.0, 1.0, [](double) {
    return rollfem::testing::HeightAndSlope{wheel_radius, 0.0};
  });
  rollfem::testing::PatchCase input = rollfem::testing::thesis_case('b');
  input.load = {};
  input.load.normal_force = force;
  input.rolling.problem = contact::Problem::frictionless;
  input.contact_grid.cell_size = {0.25, 0.1};
  input.patch = std::make_shared<contact::PatchGeometry>(
      rail, radius, contact::Axle{{0.0, 0.0, wheel_radius + crest}, {0.0, 1.0, 0.0}}, -30.0, 30.0);
  return input;
}

/// Force on the higher hump by Hertz, each patch sunk by the other as by a point load at its
/// distance: delta(N1) + N2 / (pi E* d) = delta(N2) + N1 / (pi E* d) + lower.
double force_on_higher(double lower, double force, double modulus, double distance) {
  const auto approach = [&](double n) {
    return n > 0.0 ? halfspace::hertz_from_force(0.5 / wheel_radius, 0.5 / hump_radius, modulus, n)
                         .approach
                   : 0.0;
  };
  const double by_other = 1.0 / (std::acos(-1.0) * modulus * distance);
  double below = 0.5 * force, above = force;
  for (int step = 0; step < 60; ++step) {
    const double n = 0.5 * (below + above), rest = force - n;
    const bool too_much = approach(n) + rest * by_other > approach(rest) + n * by_other + lower;
    (too_much ? above : below) = n;
  }
  return below;
}

struct JoinedWheel {
  std::array<double, 3> force{};  ///< N
  int patches = 0;
};

/// Left wheel S1002 on UIC60, 100 kN: at -4.4 mm it stands on the tread, at -6 mm on the flange
/// root.
contact::Case at_the_root(double shift) {
  contact::Case input = rollfem::testing::steep_flange(shift);
  input.load.vertical_force = 100e3;
  input.wheel.profile = {};
  input.wheel.profile.name = "S1002";
  input.wheel.rolling_radius = 450.0;
  input.rail.profile.name = "UIC60-manchester";
  return input;
}

JoinedWheel solved(const contact::Case& input) {
  JoinedWheel wheel;
  for (contact::Scene scene : track::balance(input).scenes) {
    scene.contact_grid.elements_across = 20;
    const contact::ModelResult result = halfspace::run_halfspace(scene, {});
    const contact::PointResult& point = result.points.front();
    wheel.force[0] += point.longitudinal_force;
    wheel.force[1] += point.lateral_force;
    wheel.force[2] += point.normal_force;
    wheel.patches += point.patch_count;
  }
  return wheel;
}

/// A wheel moved sideways.
struct Sweep {
  contact::Case (*at)(double shift);
  double load;  ///< N

  JoinedWheel operator()(double shift) const { return solved(at(shift)); }

  /// The largest change of a force between two positions, relative to the load.
  double change(const JoinedWheel& a, const JoinedWheel& b) const {
    double largest = 0.0;
    for (int d = 0; d < 3; ++d) largest = std::max(largest, std::abs(a.force[d] - b.force[d]));
    return largest / load;
  }

  /// From -> to between two positions, within a micrometre: where the number of patches changes.
  std::array<JoinedWheel, 2> across_event(double from, double to) const {
    std::array<JoinedWheel, 2> ends{(*this)(from), (*this)(to)};
    while (to - from > micrometre) {
      const double middle = 0.5 * (from + to);
      const JoinedWheel there = (*this)(middle);
      const bool as_before = there.patches == ends[0].patches;
      (as_before ? from : to) = middle;
      ends[as_before ? 0 : 1] = there;
    }
    return ends;
  }

  static constexpr double micrometre = 1e-3;  // mm
};

}  // namespace

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
    const double exact =
        force_on_higher(lower, force, scene.material.contact_modulus, 2.0 * half_distance);
    // Each by itself: 1.7 % more on the higher hump at 0.01 mm, 5 % at 0.03 mm.
    EXPECT_NEAR(parts[0].normal_force, exact, 2e-3 * force);
    EXPECT_NEAR(std::abs(parts[0].y), half_distance, 0.01);
    EXPECT_NEAR(parts[0].y + parts[1].y, 0.0, 0.01);
  }
}

TEST(JoinedPatches, ForcesAreContinuousAsPatchesComeAndGo) {
  const Sweep sweep{rollfem::testing::hollow_tread, 80e3};
  constexpr double step = 0.2;
  int events = 0;
  double at = -1.2;
  JoinedWheel last = sweep(at);
  for (int k = 0; k < 12; ++k) {
    const double next_at = at + step;
    const JoinedWheel next = sweep(next_at);
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
  // From the flange root to the tread: a second patch comes, joins the first, parts from it, and
  // the first goes.
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
  contact::Case input = rollfem::testing::steep_flange(-4.29);
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
  EXPECT_GT(std::abs(results[0].place->contact_angle - results[1].place->contact_angle), 1.0);
  EXPECT_NEAR(vertical, 60e3, 1e-6 * 60e3);
  EXPECT_NO_THROW(track::check_results(input, results));
}

TEST(JoinedPatches, ReferenceDoesNotChangeForcesWhereNormalsAreTrue) {
  // On the common surface with its own normals the reference is a matter of description: forces on
  // the track are the same 1 mm beside it, where plane and spin are others.
  contact::Case input = rollfem::testing::hollow_tread(-0.6);
  input.halfspace.surface = contact::SurfaceForm::curved;
  const auto on_track = [&](double offset) {
    track::SearchOptions options;
    options.reference_offset = offset;
    contact::Scene scene = track::make_scenes(input, options).at(0).scene;
    scene.contact_grid.cell_size = {0.25, 0.2};
    const auto point = halfspace::run_halfspace(scene, {}).points.at(0);
    const double angle = scene.place->contact_angle;
    // Left wheel: y of the patch points to the field.
    return std::array<double, 4>{
        point.longitudinal_force,
        point.lateral_force * std::cos(angle) - point.normal_force * std::sin(angle),
        track::vertical_force(point.normal_force, point.lateral_force, *scene.place),
        point.max_pressure};
  };
  const auto middle = on_track(0.0);
  EXPECT_NEAR(middle[2], 80e3, 1e-6 * 80e3);
  for (const double offset : {-1.0, 1.0}) {
    SCOPED_TRACE(offset);
    const auto beside = on_track(offset);
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(beside[d], middle[d], 1e-4 * 80e3) << d;
    EXPECT_NEAR(beside[3], middle[3], 1e-3 * middle[3]);
  }
}
