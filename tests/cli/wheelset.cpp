// Cases with profiles from the command line: check tells where the wheels touch, run solves every
// patch of a row of positions, and an ended run is taken up patch by patch.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace fs = std::filesystem;
using rollfem::testing::call;
using rollfem::testing::contents;
using rollfem::testing::Folder;
using rollfem::testing::Outcome;

namespace {

const std::string two_positions = R"(
title = "two positions"
models = ["halfspace"]
[load]
vertical_force = 100e3
[friction]
coefficient = 0.55
[wheel]
rolling_radius = 450.0
profile = "S1002"
[rail]
profile = "UIC60-manchester"
[track]
inclination = "1:40"
[wheelset]
side = "both"
lateral_shift = [0.0, 2.0]
roll = 0.0
[rolling]
longitudinal_creepage = 0.001
[contact_grid]
elements_across = 20
[output]
fields = false
)";

}  // namespace

TEST(Wheelset, CheckTellsWhereTheWheelsTouch) {
  const Folder folder;
  const Outcome outcome = call(folder, {"check", folder.file("case.toml", two_positions)});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const char* text : {"where wheel and rail touch", "UIC60-manchester", "y track mm"})
    EXPECT_NE(outcome.out.find(text), std::string::npos) << text << '\n' << outcome.out;
}

TEST(Wheelset, RunSolvesEveryPatchOfTheRow) {
  const Folder folder;
  const Outcome outcome =
      call(folder, {"run", folder.file("case.toml", two_positions), "-o", "out", "--no-report"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto summary = nlohmann::json::parse(contents(folder.work() / "out/summary.json"));
  ASSERT_EQ(summary["models"].size(), 4U);
  const auto& left = summary["models"][2];
  EXPECT_EQ(left["place"]["wheel"], "left");
  EXPECT_EQ(left["place"]["position"], 2);
  // CONTACT on this scene: 1011.2 MPa and 16.2 mm (wheelrail_left_patch.csv).
  EXPECT_NEAR(left["points"][0]["max_pressure"].get<double>(), 1011.2, 0.005 * 1011.2);
  EXPECT_NEAR(left["points"][0]["contact_width"].get<double>(), 16.2, 0.4);
  EXPECT_TRUE(fs::exists(folder.work() / "out/contacts.csv"));
  EXPECT_NE(outcome.out.find("y rail mm"), std::string::npos) << outcome.out;
}

TEST(Wheelset, WheelOffTheRailIsSaidInOneLine) {
  const Folder folder;
  std::string text = two_positions;
  text.replace(text.find("[0.0, 2.0]"), 10, "-60.0");
  const Outcome outcome = call(folder, {"run", folder.file("case.toml", text), "-o", "out"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("wheelset.lateral_shift = -60"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder.work() / "out"));
}
