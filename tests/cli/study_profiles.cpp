// SPDX-License-Identifier: LGPL-2.1-or-later
// The command study on true profiles: every patch has its own series, with the forces of one
// balance on all levels; options without meaning for patches are refused.
#include "support/case_examples.hpp"
#include "support/csv_rows.hpp"
#include "support/program.hpp"

namespace {

namespace fs = std::filesystem;

std::string wheel_case(const std::string& side, const std::string& shifts,
                       const std::string& across = "20") {
  return edited(wheel_on_rail,
                {"title=\"S1002\"", "models=[\"halfspace\"]", "wheelset.side=" + side,
                 "wheelset.lateral_shift=" + shifts, "wheelset.roll=0.0",
                 "rolling.longitudinal_creepage=0.001", "contact_grid.elements_across=" + across});
}

using StudyProfiles = ProgramTest;

TEST_F(StudyProfiles, ThePressureOfTheLeftWheelConvergesWithOrderTwo) {
  const Outcome outcome = done({"study", folder.file("left.toml", wheel_case("left", "2.0", "40")),
                                "--no-report", "-o", "out"});
  EXPECT_TRUE(says(outcome.out, "left wheel, position 1: halfspace, refined in grid"));
  const auto all = folder.json("out/study.json");
  const auto& place = all.at("places").at(0);
  EXPECT_EQ(place.at("key"), "left_1_1");
  EXPECT_EQ(place.at("lateral_shift"), 2.0);
  EXPECT_FALSE(all.at("notes").empty());
  const auto& levels = place.at("series").at(0).at("levels");
  ASSERT_EQ(levels.size(), 5U);
  // Between neighbouring grids the order jumps, as the kink in curvature lies differently in their
  // elements: all levels together show it.
  const auto& limit = place.at("series").at(0).at("limits").at("max_pressure");
  ASSERT_TRUE(limit.contains("order")) << limit;
  std::map<std::string, std::vector<double>> values;
  for (const auto& row : csv_records(folder.text("out/study.csv")))
    values[row.at("quantity")].push_back(std::stod(row.at("value")));
  const auto error = [&](std::size_t level) {
    return std::abs(values.at("max_pressure").at(level) - limit.at("value").get<double>());
  };
  EXPECT_NEAR(std::log2(error(0) / error(3)) / 3.0, 2.0, 0.3);
  EXPECT_LT(limit.at("uncertainty").get<double>(), 0.3);  // MPa, 3e-4 of the value
  EXPECT_NEAR(limit.at("value").get<double>(), 1011.2, 0.001 * 1011.2);
  // CONTACT: 1011.2 MPa and 16.2 mm.
  EXPECT_NEAR(values.at("max_pressure").at(4), 1011.2, 0.001 * 1011.2);
  EXPECT_NEAR(values.at("contact_width").at(4), 16.2, 0.1);
  EXPECT_EQ(values.count("semi_axis_x"), 0U);
}

TEST_F(StudyProfiles, EveryPatchIsASeriesWithOneBalance) {
  const Outcome outcome =
      done({"study", folder.file("both.toml", wheel_case("both", "[0.0, 2.0]")), "--levels", "3",
            "-o", "out", "--reference", "right_2_1.max_pressure=1510.7"});
  const auto all = folder.json("out/study.json");
  std::vector<std::string> keys;
  for (const auto& place : all.at("places")) {
    keys.push_back(place.at("key"));
    EXPECT_EQ(place.at("series").at(0).at("levels").size(), 3U);
    EXPECT_EQ(place.at("references").at("max_pressure").at("kind") == "given",
              keys.back() == "right_2_1");
    EXPECT_TRUE(folder.holds("out/figures/error_unknowns_" + keys.back() + ".svg"));
  }
  EXPECT_EQ(keys, (std::vector<std::string>{"left_1_1", "right_1_1", "left_2_1", "right_2_1"}));
  // Found once, not for each of the twelve levels.
  const std::size_t balance = outcome.err.find("balance");
  EXPECT_EQ(outcome.err.find("position 1 of 2", outcome.err.find("position 1 of 2") + 1),
            std::string::npos);
  EXPECT_NE(balance, std::string::npos) << outcome.err;
  const std::string page = folder.text("out/study.html");
  EXPECT_TRUE(says(page, "Largest pressure of every patch", "right wheel, position 2"));
  EXPECT_TRUE(says(folder.text("out/study.csv"), "\nright_2_1,halfspace,grid,"));
}

TEST_F(StudyProfiles, RefusesWhatMakesNoSenseForPatches) {
  const std::string file = folder.file("both.toml", wheel_case("both", "2.0"));
  if (ROLLFEM_WITH_FEM)
    refuses({"study", file, "--model", "fem", "--vary", "domain"}, "true sections of rail and rim");
  refuses({"study", file, "-q", "--reference", "exact"}, "no exact value is known");
  refuses({"study", file, "-q", "--reference", "max_pressure=1000"},
          "the case has several patches");
  refuses({"study", file, "-q", "--reference", "left_1_1.semi_axis_x=6"},
          "unknown quantity in this case");
  EXPECT_TRUE(folder.made().empty());
}

}  // namespace
