// SPDX-License-Identifier: LGPL-2.1-or-later
// The command study: levels, orders, references and refusals.
#include "postprocess/files/seal.hpp"

#include "support/case_examples.hpp"
#include "support/csv_rows.hpp"
#include "support/program.hpp"

namespace {

const std::string quick_study = rolling("[0.0, 0.001]", 20);

/// Rows of the largest pressure.
std::vector<std::map<std::string, std::string>> pressures_of(const std::string& table) {
  std::vector<std::map<std::string, std::string>> found;
  for (const auto& row : csv_records(table))
    if (row.at("quantity") == "max_pressure") found.push_back(row);
  return found;
}

using Study = ProgramTest;

TEST_F(Study, ShowsTheOrderOfTheHalfSpacePressure) {
  const Outcome outcome = done({"study", folder.file("quick.toml", quick_study)});
  EXPECT_FALSE(says(outcome.err, "warning"));
  for (const std::string name : {"study.csv", "study.html", "figures/speed_error.svg"})
    EXPECT_TRUE(folder.holds("results/quick_study/" + name)) << name;
  const auto all = folder.json("results/quick_study/study.json");
  EXPECT_EQ(all.at("places")[0].at("references").at("max_pressure").at("kind"), "exact");
  const auto& levels = all.at("places")[0].at("series")[0].at("levels");
  ASSERT_EQ(levels.size(), 5U);
  EXPECT_EQ(levels[0].at("label"), "5 across");
  EXPECT_EQ(levels[4].at("label"), "80 across");
  // docs/counts.md: p0 converges with order 2; the error at 80 across is 1.4e-4.
  const auto pressures = pressures_of(folder.text("results/quick_study/study.csv"));
  for (std::size_t k = 2; k < 5; ++k)
    EXPECT_NEAR(std::stod(pressures.at(k).at("order")), 2.0, 0.35) << k;
  EXPECT_NEAR(std::stod(pressures.at(4).at("error")), 1.4e-4, 0.4e-4);
  EXPECT_TRUE(says(outcome.out, "80 across"));
  // Without a checksum its numbers may be damaged.
  const std::string sealed = folder.text("results/quick_study/study.json");
  folder.file("work/results/quick_study/study.json", sealed.substr(0, sealed.rfind(',')) + "\n}\n");
  EXPECT_TRUE(says(call({"report", "results/quick_study"}).err, "its checksum"));
  // No text of the file becomes a part of the page.
  nlohmann::json forged = nlohmann::json::parse(sealed);
  const std::string script = "<script>";
  forged.erase("checksum");
  forged["labels"]["halfspace"] = script;
  for (auto& quantity : forged["quantities"]) quantity["unit"] = script;
  for (auto& reference : forged["places"][0]["series"][0]["references"]) reference["kind"] = script;
  folder.file("work/results/quick_study/study.json", postprocess::sealed_json(forged.dump(1)));
  done({"report", "results/quick_study"});
  const std::string page = folder.text("results/quick_study/study.html");
  EXPECT_TRUE(says(page, "&lt;script&gt;"));
  EXPECT_FALSE(says(page, script));
}

/// For a small force on a circle with nu = 0.25: Kalker's C11 = 4.12 (1967, table of the thesis),
/// with the part of Vermeulen and Johnson's law that is beyond linear.
TEST_F(Study, FollowsTheCreepageFoundForAForce) {
  const std::string file = folder.file(
      "force.toml",
      "[load]\nnormal_force = 50e3\n[friction]\ncoefficient = 0.55\n[wheel]\n"
      "rolling_radius = 405.0\ntransverse_radius = inf\npoisson_ratio = 0.25\n[rail]\n"
      "transverse_radius = 405.0\npoisson_ratio = 0.25\n[rolling]\nlongitudinal_force = -275.0\n");
  const Outcome outcome = done({"study", file, "--levels", "3"});
  EXPECT_TRUE(says(outcome.out, "longitudinal creepage found at load point 1", "creepage "));
  const auto place = folder.json("results/force_study/study.json").at("places")[0];
  EXPECT_FALSE(place.at("references").contains("traction_coefficient:1"));
  const double a = std::cbrt(0.75 * 50e3 * 405.0 / (210e3 / (2.0 * (1.0 - 0.0625))));
  const double bound = 0.55 * 50e3;
  const double creepage =
      3.0 * bound / (84e3 * a * a * 4.12) * (1.0 - std::cbrt(1.0 - 275.0 / bound));
  EXPECT_NEAR(place.at("series")[0].at("limits").at("longitudinal_creepage:1").at("value"),
              creepage, 0.02 * creepage);
  EXPECT_TRUE(folder.holds("results/force_study/figures/values.svg"));
}

TEST_F(Study, AllModelsAndGivenReferences) {
  const std::vector<std::string> several{"hertz", "linear", "fastsim", "strip", "halfspace"};
  // With finite elements all models take minutes.
  const std::vector<std::string> asked =
      ROLLFEM_WITH_FEM ? several : std::vector<std::string>{"all"};
  const std::string file = folder.file("quick.toml", quick_study);
  done(joined({"study", file, "--levels", "2", "--no-report", "-o", "out", "--reference",
               "max_pressure=1000", "traction_coefficient:2=0.1", "--models"},
              asked));
  const auto all = folder.json("out/study.json");
  EXPECT_EQ(all.at("places")[0].at("references").at("max_pressure").at("kind"), "given");
  std::vector<std::string> models;
  for (const auto& series : all.at("places")[0].at("series")) models.push_back(series.at("model"));
  for (const auto& row : pressures_of(folder.text("out/study.csv")))
    EXPECT_NEAR(std::stod(row.at("error")), std::abs(std::stod(row.at("value")) / 1000.0 - 1.0),
                1e-9);
  for (const std::string& name : several)
    EXPECT_EQ(std::count(models.begin(), models.end(), name), 1) << name;
}

TEST_F(Study, RefusesWhatMakesNoSense) {
  const std::string file = folder.file("quick.toml", quick_study);
  refuses({"study"}, "no case file is named");
  refuses({"study", file, "--vary", "degrees"}, "cannot be refined");
  refuses({"study", file, "--vary", "domain"}, "no model of this study");
  refuses({"study", file, "--levels", "1"}, "allowed: 2 to 8");
  refuses({"study", file, "--reference", "best"}, "not a reference");
  refuses({"study", file, "--reference", "max_pressure=abc"}, "not a number");
  refuses({"study", file, "--reference", "traction_coefficient:3=0.1"},
          "unknown quantity in this case");
  refuses({"study", file, "--model", "nope"}, "no such model");
  EXPECT_TRUE(folder.made().empty());
}

}  // namespace
