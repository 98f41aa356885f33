// SPDX-License-Identifier: LGPL-2.1-or-later
// Cases with profiles from the command line: check prints the contacts of the wheels, run solves
// every patch of a lateral sweep, and an interrupted run resumes patch by patch.
#include "support/case_examples.hpp"
#include "support/csv_rows.hpp"
#include "support/program.hpp"
#include <map>

namespace {

const std::string twenty_across = edited(
    two_positions,
    {"title=\"two positions\"", "models=[\"halfspace\"]", "contact_grid.elements_across=20"});

using Wheelset = ProgramTest;

TEST_F(Wheelset, CheckTellsWhereTheWheelsTouch) {
  const Outcome outcome = done({"check", folder.file("case.toml", twenty_across)});
  EXPECT_TRUE(says(outcome.out, "where wheel and rail touch", "UIC60-manchester", "y track mm"));
}

TEST_F(Wheelset, ReportSaysThatTheHeightIsGivenInPlaceOfALoad) {
  done({"run", std::string(ROLLFEM_SOURCE_DIR) + "/cases/guard_rail.toml", "-o", "out", "--set",
        "contact_grid.elements_across=12", "--set", "placement.lateral_position=85.4"});
  EXPECT_TRUE(says(folder.text("out/report.html"), "the height of the wheel is given"));
}

TEST_F(Wheelset, RunSolvesEveryPatchAndRowHasOneLineAPositionWithBothWheels) {
  const Outcome outcome =
      done({"run", folder.file("case.toml", twenty_across), "-o", "out", "--no-report"});
  const auto summary = folder.json("out/summary.json");
  ASSERT_EQ(summary["models"].size(), 4U);
  const auto& left = summary["models"][2];
  EXPECT_EQ(left["place"]["wheel"], "left");
  EXPECT_EQ(left["place"]["position"], 2);
  // CONTACT on this scene: 1011.2 MPa and 16.2 mm (wheelrail_left_patch.csv).
  EXPECT_NEAR(left["points"][0]["max_pressure"].get<double>(), 1011.2, 0.005 * 1011.2);
  EXPECT_NEAR(left["points"][0]["contact_width"].get<double>(), 16.2, 0.4);
  EXPECT_TRUE(folder.holds("out/contacts.csv"));
  EXPECT_TRUE(says(outcome.out, "y rail mm"));
  // The terminal shows one line per position, one per patch, and notes common to all patches once.
  const auto times = [&](const std::string& words) {
    int count = 0;
    for (std::size_t at = 0; (at = outcome.out.find(words, at)) != std::string::npos; ++at) ++count;
    return count;
  };
  EXPECT_EQ(times("the wheelset, by halfspace at the first load point"), 1) << outcome.out;
  EXPECT_EQ(times("\n   2         2   "), 1) << outcome.out;
  EXPECT_EQ(times("\nleft ") + times("\nright"), 4);
  EXPECT_EQ(times("halfspace: error bars: "), 1);
  EXPECT_EQ(times("(values differ for 2 other patches)"), 1) << outcome.out;
  const auto rows = csv_rows(folder.text("out/wheelset.csv"));
  ASSERT_EQ(rows.size(), 3u);
  const auto number = [&](std::size_t row, const std::string& name) {
    const auto column = std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin();
    return std::stod(rows[row].at(static_cast<std::size_t>(column)));
  };
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  // In the middle of the track the wheels are mirror images: their forces to the side balance.
  EXPECT_NEAR(number(1, "left lateral_force_track [N]"),
              -number(1, "right lateral_force_track [N]"), 0.01);
  EXPECT_NEAR(number(1, "left vertical_force [N]"), 100e3, 1.0);
  // Patch frame and track frame are turned about x: both pairs have one resultant, and the pressure
  // pushes a wheel to where its contact plane falls.
  const auto contacts = csv_records(folder.text("out/contacts.csv"));
  ASSERT_EQ(contacts.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto of = [&](const char* name) { return std::stod(contacts[k].at(name)); };
    const double lateral = of("lateral_force"), track = of("lateral_force_track");
    EXPECT_NEAR(std::hypot(track, of("vertical_force")), std::hypot(lateral, of("normal_force")),
                1e-6);
    const double side = contacts[k].at("wheel") == "left" ? 1.0 : -1.0;
    EXPECT_NEAR(track + lateral, side * of("normal_force") * of("contact_angle"),
                0.01 * of("normal_force") * of("contact_angle"))
        << k;
    const auto& point = summary["models"][k]["points"][0];
    EXPECT_EQ(point["lateral_force"].get<double>(), lateral);
    EXPECT_EQ(point["lateral_force_track"].get<double>(), track);
    const auto bar = [&](const char* name) { return point["error_estimate"][name].get<double>(); };
    EXPECT_NEAR(bar("lateral_force_track"),
                bar("normal_force") * std::abs(std::sin(of("contact_angle"))) +
                    bar("lateral_force") * std::cos(of("contact_angle")),
                1e-9);
    EXPECT_GT(bar("lateral_force_track"), 0.0);
  }
  EXPECT_NEAR(number(2, "radius_difference [mm]"),
              number(2, "right rolling_radius [mm]") - number(2, "left rolling_radius [mm]"), 1e-9);
  EXPECT_EQ(rows[1][4], "1");  // load points count from 1
  EXPECT_NEAR(number(2, "wave_length [mm]"),
              2.0 * M_PI * std::sqrt(1500.0 * 450.0 / (2.0 * number(2, "conicity_wave [-]"))),
              1e-6);
  EXPECT_EQ(folder.text("out/wheelset_rigid.csv").rfind("lateral_shift [mm],", 0), 0u);
  // The patches of 100 kN are near where the rigid bodies touch.
  EXPECT_NEAR(number(2, "radius_difference [mm]"), number(2, "rigid_radius_difference [mm]"), 0.2);
}

TEST_F(Wheelset, StandsLowerUnderLoadByTheApproach) {
  // A cylinder on a rail of radius 300 mm: the approach by Hertz, vertically.
  const std::string cylinder = R"([load]
vertical_force = 80e3
[friction]
coefficient = 0.0
[wheel]
rolling_radius = 460.0
profile = "arcs"
[wheel_profile]
radii = [inf]
ends = [-60.0, 60.0]
[rail]
profile = "arcs"
[rail_profile]
radii = [300.0]
ends = [36.0]
symmetric = true
[placement]
[rolling]
problem = "frictionless"
[contact_grid]
elements_across = 40
)";
  for (const std::string side : {"left", "right"}) {
    done({"run", folder.file("a.toml", edited(cylinder, {"placement.side=" + side})), "-o", "a",
          "-m", "hertz", "halfspace", "--no-report"});
    const auto models = folder.json("a/summary.json")["models"];
    const auto& hertz = models[0]["points"][0];
    const auto& solved = models[1]["points"][0];
    EXPECT_NEAR(hertz["loaded_height"].get<double>(),
                models[0]["place"]["height"].get<double>() + hertz["approach"].get<double>(),
                1e-12);
    const double bar = solved["error_estimate"]["loaded_height"].get<double>();
    EXPECT_EQ(bar, solved["error_estimate"]["approach"].get<double>());
    EXPECT_LT(bar, 1e-3 * hertz["approach"].get<double>());
    EXPECT_NEAR(solved["loaded_height"].get<double>(), hertz["loaded_height"].get<double>(),
                std::max(bar, 1e-4 * hertz["approach"].get<double>()));
  }
}

TEST_F(Wheelset, AtItsLoadedHeightCarriesItsLoad) {
  // The load is a result where the height is given: on the root of S1002, left and right.
  for (const std::string side : {"left", "right"}) {
    const std::string shift = side == "left" ? "-5.0" : "5.0";
    const std::string at =
        edited(wheel_on_rail, {"wheelset.side=" + side, "wheelset.lateral_shift=" + shift,
                               "wheelset.roll=0.0", "friction.coefficient=0.0",
                               "rolling.problem=frictionless", "contact_grid.elements_across=12"});
    done({"run", folder.file("a.toml", at), "-o", "a", "-m", "halfspace", "--no-report"});
    const auto contacts = csv_records(folder.text("a/contacts.csv"));
    ASSERT_EQ(contacts.size(), 1U);
    const std::string height = contacts[0].at("loaded_height");
    EXPECT_GT(std::stod(contacts[0].at("contact_angle")), 0.05);
    EXPECT_GT(std::stod(height), std::stod(contacts[0].at("height")));
    std::string pressed = at;
    pressed.erase(pressed.find("vertical_force"), std::string("vertical_force = 100e3").size());
    done({"run", folder.file("b.toml", edited(pressed, {"wheelset.height=" + height})), "-o", "b",
          "-m", "halfspace", "--no-report"});
    const auto point = folder.json("b/summary.json")["models"][0]["points"][0];
    EXPECT_NEAR(point["vertical_force"].get<double>(), 100e3, 1e2) << side;
    EXPECT_NEAR(point["loaded_height"].get<double>(), std::stod(height), 1e-4);
    EXPECT_EQ(point["no_bar"]["loaded_height"], "given");
  }
}

TEST_F(Wheelset, WithoutAFreeRotationTheKeyIsNamed) {
  const std::string in_metres =
      edited(wheel_on_rail,
             {"wheel.rolling_radius=0.46", "wheelset.side=both", "wheelset.free_rolling=torque"});
  const Outcome outcome =
      folder.call({"run", folder.file("case.toml", in_metres), "-o", "out", "-m", "halfspace"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(says(outcome.err, "case.toml: wheelset.free_rolling = \"torque\": no rotation_change",
                   "do: check wheel.rolling_radius = 0.46 mm"));
}

TEST_F(Wheelset, AWheelAboveItsRailCarriesNothing) {
  const std::string given =
      "models = [\"halfspace\"]\n[friction]\ncoefficient = 0.3\n[wheel]\nrolling_radius = 460.0\n"
      "profile = \"S1002\"\n[rail]\nprofile = \"60E1\"\n[placement]\nside = \"right\"\n"
      "[contact_grid]\nelements_across = 10\n";
  const auto at = [&](const std::string& heights) {
    const std::string text = given + "[output]\nfields = false\n";
    return edited(text, {"placement.height=" + heights});
  };
  const Outcome both =
      done({"run", folder.file("case.toml", at("[-0.4, -0.6]")), "-o", "out", "--no-report"});
  EXPECT_TRUE(says(both.out, "warning: position 2: the right wheel is 0.1009 mm above its rail"));

  const auto summary = folder.json("out/summary.json");
  const auto& point = summary["models"][0]["points"][0];
  EXPECT_GT(point["vertical_force"].get<double>(), 1e3);
  EXPECT_GT(point["error_estimate"]["vertical_force"].get<double>(), 0.0);
  const Outcome none = done({"run", folder.file("none.toml", at("-0.6")), "-o", "none"});
  EXPECT_TRUE(says(none.out, "carries no load"));
  EXPECT_EQ(folder.json("none/summary.json")["models"].size(), 0U);
}

TEST_F(Wheelset, TheLoadMovesFromTheWingToTheNoseOfACrossing) {
  const std::string crossing = std::string(ROLLFEM_SOURCE_DIR) + "/cases/crossing.toml";
  const Outcome check = done({"check", crossing});
  EXPECT_TRUE(says(check.out, "where wheel and rail touch"));
  EXPECT_EQ(check.err, "");
  done({"run", crossing, "-o", "out", "--set", "contact_grid.elements_across=8", "--set",
        "placement.track_position=[50.0, 80.0, 110.0]"});
  const auto contacts = csv_records(folder.text("out/contacts.csv"));
  ASSERT_EQ(contacts.size(), 4U);
  std::map<double, double> on_wing, on_nose;  // vertical force by position
  for (const auto& contact : contacts) {
    const auto of = [&](const char* name) { return std::stod(contact.at(name)); };
    (of("y_rail") > 40.0 ? on_wing : on_nose)[of("track_position")] = of("vertical_force");
    // The nose rises by 1:120 and is met ahead of the axle, the wing is met behind it.
    if (of("y_rail") > 40.0) continue;
    EXPECT_NEAR(of("climb"), 1.0 / 120.0, 1e-4);
    EXPECT_NEAR(of("x_track"), 461.3 / 120.0, 0.1);
  }
  EXPECT_NEAR(on_wing.at(50.0), 80e3, 80.0);
  EXPECT_NEAR(on_wing.at(80.0) + on_nose.at(80.0), 80e3, 80.0);
  EXPECT_GT(std::min(on_wing.at(80.0), on_nose.at(80.0)), 15e3);
  EXPECT_NEAR(on_nose.at(110.0), 80e3, 80.0);

  const auto rows = csv_records(folder.text("out/wheelset.csv"), false);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[1].at("track_position [mm]"), "80");
  EXPECT_EQ(rows[1].at("right patches [-]"), "2");
  const std::string report = folder.text("out/report.html");
  EXPECT_TRUE(says(report, "position along the track [mm]", "followed from position to position",
                   "contact at y = 64 to 65 mm on the rail"));
  EXPECT_TRUE(says(folder.text("out/figures/positions.svg"), "height of the wheel"));
}

TEST_F(Wheelset, AWheelOffTheRailIsReportedInOneLine) {
  const std::string text = edited(twenty_across, {"wheelset.lateral_shift=-60.0"});
  const Outcome outcome = call({"run", folder.file("case.toml", text), "-o", "out"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(says(outcome.err, "wheelset.lateral_shift = -60"));
  EXPECT_FALSE(folder.holds("out"));
}

}  // namespace
