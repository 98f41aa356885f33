// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheels whose positions follow each other: limits that must come out, and what a step hands on.
#include "case/reading/case_reader.hpp"
#include "halfspace/halfspace_models.hpp"
#include "modelling/registry.hpp"
#include "modelling/solving/solving.hpp"

#include <fmt/format.h>

#include "support/case_examples.hpp"
#include <algorithm>
#include <cmath>

namespace {

using Changes = std::vector<std::string>;

class WheelHistory : public ::testing::Test {
 protected:
  WheelHistory() { models_.add(halfspace::models().at("halfspace")); }

  /// `loaded`: by a force, otherwise at the heights among the changes.
  result::RunRecord solve(const Changes& changes, bool loaded = true) {
    Changes all{"wheel.profile=S1002",        "wheel.rolling_radius=460.0",
                "rail.profile=60E1",          "friction.coefficient=0.3",
                "wheelset.roll=0.0",          "contact_grid.cell_size=[1.0, 1.0]",
                "rolling.leading_edge=plain", "halfspace.surface=planar",
                "wheelset.side=left"};
    if (std::none_of(changes.begin(), changes.end(), [](const std::string& change) {
          return change.rfind("wheelset.free_rolling", 0) == 0;
        }))
      all.push_back("wheelset.rotation_change=-0.001");
    all.insert(all.end(), changes.begin(), changes.end());
    result::RunRecord record;
    const std::string track =
        loaded ? wheel_on_rail : wheel_on_rail.substr(wheel_on_rail.find("[friction]"));
    record.input = contact::parse_case(edited("models = [\"halfspace\"]\n" + track, all),
                                       "case.toml", modelling::known_names(models_));
    modelling::Solving how;
    how.models = &models_;
    modelling::solve(record, how);
    return record;
  }

  contact::ModelRegistry models_;
};

/// `count` numbers from `first` to `last`.
std::string list_of(double first, double last, int count) {
  std::string text = "[";
  for (int k = 0; k < count; ++k)
    text +=
        (k > 0 ? ", " : "") + std::to_string(first + (last - first) * k / std::max(1, count - 1));
  return text + "]";
}

Changes steps(int count, const std::string& length, const Changes& more = {}) {
  Changes all{"rolling.problem=transient", "history.step_length=" + length,
              "wheelset.yaw=" + list_of(0.0, 0.0, count)};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

void expect_forces(const contact::PointResult& a, const contact::PointResult& b, double tolerance) {
  const double scale = 0.3 * b.normal_force;
  EXPECT_NEAR(a.normal_force, b.normal_force, tolerance * b.normal_force);
  EXPECT_NEAR(a.longitudinal_force, b.longitudinal_force, tolerance * scale);
  EXPECT_NEAR(a.lateral_force, b.lateral_force, tolerance * scale);
}

TEST_F(WheelHistory, ConstantConditionsLeadToSteadyRolling) {
  for (const std::string order : {"first", "second"}) {
    const Changes rule{"rolling.upwind_order=" + order};
    const auto steady = solve(rule), rolled = solve(steps(120, "1.0", rule));
    ASSERT_EQ(rolled.models.size(), 120U);
    const contact::PointResult& last = rolled.models.back().points.front();
    expect_forces(last, steady.models.front().points.front(), 1e-6);
    EXPECT_EQ(last.step, 120);
    EXPECT_DOUBLE_EQ(last.distance, 120.0);
    EXPECT_EQ(rolled.models.back().place->position, 120);
    // The first step is at rest: it carries less.
    EXPECT_LT(std::abs(rolled.models.front().points.front().longitudinal_force),
              0.5 * std::abs(last.longitudinal_force));
  }
}

TEST_F(WheelHistory, EqualsTheHistoryAtOnePlace) {
  const Changes rule{"history.start=steady",
                     "wheelset.rotation_change=[-0.001, 0.0, 0.0005, 0.0005, 0.0005, 0.0]"};
  Changes at_once = steps(1, "2.0", rule);
  const auto one = solve(at_once), many = solve(steps(6, "2.0", rule));
  ASSERT_EQ(one.models.size(), 1U);
  ASSERT_EQ(many.models.size(), 6U);
  for (std::size_t k = 0; k < 6; ++k)
    expect_forces(many.models[k].points.front(), one.models.front().points[k], 1e-6);
}

/// The numbers of the steps of one wheel that carry.
const contact::PointResult& step_of(const result::RunRecord& record, std::size_t k) {
  return record.models.at(k).points.front();
}

TEST_F(WheelHistory, DoesNotDependOnHowStepsAndElementsDivide) {
  const auto whole = solve(steps(30, "1.5", {"contact_grid.cell_size=[0.5, 1.0]"}));
  const auto parts = solve(steps(30, "1.5", {"contact_grid.cell_size=[0.53, 1.0]"}));
  for (const std::size_t k : {3U, 10U, 29U})
    expect_forces(step_of(parts, k), step_of(whole, k), 6e-3);
}

TEST_F(WheelHistory, MirrorImagesAreEqual) {
  const Changes moving{"wheelset.lateral_shift=" + list_of(0.0, 1.5, 8),
                       "history.motion=positions"};
  Changes other{"wheelset.lateral_shift=" + list_of(0.0, -1.5, 8), "history.motion=positions",
                "wheelset.side=right"};
  const auto left = solve(steps(8, "1.0", moving)), right = solve(steps(8, "1.0", other));
  for (std::size_t k = 0; k < 8; ++k) {
    contact::PointResult mirrored = step_of(right, k);
    mirrored.lateral_force = -mirrored.lateral_force;
    expect_forces(step_of(left, k), mirrored, 1e-7);
  }
}

TEST_F(WheelHistory, LoadAndHeightAgree) {
  const Changes moving{"wheelset.lateral_shift=" + list_of(0.0, 1.0, 5)};
  const auto loaded = solve(steps(5, "1.0", moving));
  std::string heights;
  for (const contact::ModelResult& step : loaded.models)
    heights +=
        (heights.empty() ? "[" : ", ") + fmt::format("{:.12g}", *step.points[0].loaded_height);
  const auto sunk = solve(steps(5, "1.0", {moving[0], "wheelset.height=" + heights + "]"}), false);
  for (std::size_t k = 0; k < 5; ++k) expect_forces(step_of(sunk, k), step_of(loaded, k), 2e-4);
}

/// A round wheel that has been shifted on a flat rail, and is then placed 1 mm to the right of
/// where it stood: what sticks stays with the rail, on the left wheel at larger y.
TEST_F(WheelHistory, TractionsStayWithTheRail) {
  const auto shifted = solve(
      {"rolling.problem=shift", "history.longitudinal_shift=[-0.005, 0.0]",
       "wheelset.lateral_shift=[0.0, 1.0]", "wheel.profile=arcs", "wheel_profile.radii=[300.0]",
       "wheel_profile.ends=[40.0]", "wheel_profile.symmetric=true", "rail.profile=arcs",
       "rail_profile.radii=[inf]", "rail_profile.ends=[-60.0, 60.0]", "track.inclination=none",
       "track.rail_position=[750.0, 0.0]", "contact_grid.cell_size=[0.5, 0.5]"});
  ASSERT_EQ(shifted.models.size(), 2U);
  const auto middle = [](const contact::ModelResult& result) {
    const contact::Field& along = result.points[0].fields.traction.x;
    double sum = 0.0, moment = 0.0;
    for (int k = 0; k < result.grid.size(); ++k) {
      sum += along[k];
      moment += result.grid.y(k / result.grid.nx) * along[k];
    }
    return moment / sum;
  };
  EXPECT_NEAR(middle(shifted.models[0]), 0.0, 1e-6);
  EXPECT_GT(middle(shifted.models[1]), 0.3);
  EXPECT_LT(middle(shifted.models[1]), 1.0);
}

/// A wheel that is braked from rest, after 12 mm: what the length of the steps changes falls with
/// it, and is within the bars.
TEST_F(WheelHistory, ErrorOfStepsFallsWithTheirLength) {
  std::vector<contact::PointResult> after;
  for (const int count : {6, 12, 24})
    after.push_back(
        solve(steps(count, std::to_string(12.0 / count), {"rolling.upwind_order=first"}))
            .models.back()
            .points.front());
  const auto force = [&](std::size_t k) { return after[k].longitudinal_force; };
  const double ratio = (force(0) - force(1)) / (force(1) - force(2));
  EXPECT_GT(ratio, 1.7);
  EXPECT_LT(ratio, 2.4);
  for (const std::size_t k : {0U, 1U})
    EXPECT_LT(std::abs(force(k) - (2.0 * force(2) - force(1))),
              *after[k].bar_of("longitudinal_force"));
}

/// From a shift under the force to the creepage of steady rolling: from Cattaneo to Carter.
TEST_F(WheelHistory, TransmitsTheForceThatIsAsked) {
  const Changes driven{"wheelset.free_rolling=force", "wheelset.longitudinal_force=-12e3"};
  const auto steady = solve(driven), rolled = solve(steps(90, "1.0", driven));
  for (const std::size_t k : {0U, 1U, 10U, 89U})
    EXPECT_NEAR(step_of(rolled, k).longitudinal_force, -12e3, 1.0);
  const double wanted = step_of(steady, 0).creepage.longitudinal;
  EXPECT_NEAR(step_of(rolled, 89).creepage.longitudinal, wanted, 0.02 * wanted);
  EXPECT_GT(step_of(rolled, 0).creepage.longitudinal, 3.0 * wanted);
}

/// Wheels whose sum of moments about the axle is given, in each step; a centred wheelset shares it.
TEST_F(WheelHistory, TransmitsTheTorqueThatIsAsked) {
  constexpr double torque = 4e6, radius = 460.0;
  const Changes driven{"wheelset.free_rolling=torque", "wheelset.axle_torque=4e6",
                       "wheelset.side=both"};
  const auto steady = solve(driven), rolled = solve(steps(60, "1.0", driven));
  ASSERT_EQ(rolled.models.size(), 120U);
  for (const contact::ModelResult& wheel : rolled.models)
    EXPECT_NEAR(wheel.points.front().longitudinal_force, -0.5 * torque / radius,
                2e-3 * torque / radius);
  for (const std::size_t last : {118U, 119U})
    EXPECT_NEAR(step_of(rolled, last).creepage.longitudinal,
                step_of(steady, last - 118).creepage.longitudinal,
                0.02 * std::abs(step_of(steady, 0).creepage.longitudinal));
}

/// What a wheel is shifted by follows from where it stands and how far it has turned: as if its
/// shift were given, with y of the contact to the left.
TEST_F(WheelHistory, PositionsShiftTheWheel) {
  constexpr double aside = 4e-3, turned = 1e-5;
  const Changes shift{"rolling.problem=shift", "contact_grid.cell_size=[0.5, 0.5]"};
  Changes placed = shift, given = shift;
  for (const std::string& key : {fmt::format("wheelset.lateral_shift=[0.0, {}]", aside),
                                 fmt::format("wheelset.wheel_angle=[0.0, {}]", turned),
                                 std::string("history.motion=positions")})
    placed.push_back(key);
  for (const std::string& key :
       {fmt::format("history.lateral_shift=[0.0, {}]", -aside),
        fmt::format("history.longitudinal_shift=[0.0, {}]", -turned * 460.0),
        std::string("wheelset.lateral_shift=[0.0, 0.0]")})
    given.push_back(key);
  for (const std::string side : {"left", "right"}) {
    placed.push_back("wheelset.side=" + side);
    given.push_back("wheelset.side=" + side);
    const auto a = solve(placed), b = solve(given);
    EXPECT_GT(std::abs(step_of(b, 1).longitudinal_force), 0.05 * step_of(b, 1).normal_force);
    EXPECT_GT(std::abs(step_of(b, 1).lateral_force), 0.05 * step_of(b, 1).normal_force);
    expect_forces(step_of(a, 1), step_of(b, 1), 0.01);
  }
}

/// k d = F + F_0, with the friction of each step; a steady wheel on the same springs carries the
/// same.
TEST_F(WheelHistory, SpringsCarryTheRail) {
  const Changes springs{"track.rail_stiffness=[2e4, 5e4]", "track.rail_force=[3e3, 0.0]"};
  for (const auto& found : {solve(springs), solve(steps(3, "1.0", springs))}) {
    const contact::ModelResult& last = found.models.back();
    const auto note = std::find_if(last.notes.begin(), last.notes.end(),
                                   [](const auto& one) { return one.about == "rail_springs"; });
    ASSERT_NE(note, last.notes.end());
    const std::string text = note->text;
    const double aside = std::stod(text.substr(text.find("moved by ") + 9));
    const double down = std::stod(text.substr(text.find("right and ") + 10));
    const contact::PointResult& point = last.points.front();
    EXPECT_NEAR(5e4 * down, *point.vertical_force, 20.0);
    // In steady rolling with friction on 24 elements across.
    EXPECT_NEAR(2e4 * aside - 3e3, -*point.lateral_force_track,
                found.models.size() > 1 ? 20.0 : 300.0);
  }
}

TEST_F(WheelHistory, TimeAndPlaceSayHowFarItRolls) {
  const Changes placed{"rolling.problem=transient", "wheelset.track_position=[5.0, 6.0, 8.0]"};
  const Changes timed{"rolling.problem=transient", "wheelset.yaw=[0.0, 0.0, 0.0]",
                      "history.time=[0.0, 0.001, 0.003]", "rolling.speed=1000.0"};
  for (const Changes& given : {placed, timed})
    EXPECT_DOUBLE_EQ(step_of(solve(given), 2).distance, 4.0);
}

TEST_F(WheelHistory, RefusesOtherModelsAndUnequalLists) {
  EXPECT_TRUE(says(refusal<contact::InputError>([&] { solve(steps(3, "[1.0, 1.0]")); }),
                   "3 positions, but the history has 2 steps"));
  EXPECT_TRUE(says(refusal<contact::InputError>([&] { solve(steps(3, "1.0", {"accuracy=0.01"})); }),
                   "one lattice"));
}

}  // namespace
