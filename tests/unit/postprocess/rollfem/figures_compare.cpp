// SPDX-License-Identifier: LGPL-2.1-or-later
// The pages of compare and study, made by Debian's Python from written data: self-contained, with
// every case, model and figure.
#include "postprocess/compare/comparison.hpp"
#include "postprocess/files/result_folder.hpp"
#include "postprocess/files/seal.hpp"
#include "postprocess/study/study.hpp"

#include "support/drawn_pages.hpp"
#include "support/output_placed_run.hpp"

namespace fs = std::filesystem;

namespace rollfem::postprocess {
namespace {

class PagesTest : public DrawnPages {
 protected:
  ComparedCase written(const std::string& name, const RunRecord& run) {
    write_results((base_ / name).string(), run);
    ComparedCase compared;
    compared.name = name;
    compared.title = run.input.title;
    compared.case_file = name + ".toml";
    compared.friction = run.input.friction_coefficient;
    compared.models = scalars_of(run.models);
    return compared;
  }
};

TEST_F(PagesTest, AComparisonHasEveryCaseAndNamesMissingOnes) {
  RunRecord run = synthetic_run();
  ComparisonRecord record;
  record.provenance.labels = labels;
  record.models = {"hertz", "halfspace", "fem", "strip"};
  record.references = {"halfspace", "fem"};
  record.cases.push_back(written("one", run));
  run.input.title = "second <case>";
  run.models.erase(run.models.begin());
  record.cases.push_back(written("two", run));
  record.cases[1].missing = {{"strip", "it cannot handle this & that", false}};
  ComparedCase failed;
  failed.name = "three";
  failed.title = "third";
  failed.missing = {{"every model", "no contact", true}};
  record.cases.push_back(failed);
  replace_file(base_ / "compare.json", comparison_json(record));
  ASSERT_EQ(make_report(base_.string(), scripts), "");
  const std::string page = contents(base_ / "compare.html");
  expect_self_contained(page);
  EXPECT_TRUE(
      says(page, "Comparison of models on 3 cases", "second &lt;case&gt;",
           "it cannot handle this &amp; that", "is left out", "no contact", "failed",
           "Within the error bars of half-space: ", "Cost", "Force per strip", "Lateral traction",
           "id=\"one\"",
           "largest longitudinal traction |p<sub>x</sub>|<br><span class=d>% of μ p<sub>0</sub>"));
  // Ten figures in the first case, one less in the second without Hertz, and differences against
  // cost.
  EXPECT_EQ(count(page, "<figure>"), 20U);
  // Names of the page, not of the program, and no symbols of a terminal.
  EXPECT_FALSE(says(page, "bars of halfspace"));
  EXPECT_FALSE(says(page, " of mu"));
  EXPECT_TRUE(fs::exists(base_ / "one" / "report.html"));
}

TEST_F(PagesTest, AComparisonOnProfilesShowsWhereTheyTouchAndDifferencesPlaceByPlace) {
  RunRecord run = placed_run(1);  // two patches
  for (contact::ModelResult& model : run.models) {
    model.points.resize(2);
    if (model.name == "fem" && model.place->patch == 2)
      for (contact::PointResult& point : model.points) point.max_pressure *= 1.3;
  }
  ComparisonRecord record;
  record.provenance.labels = labels;
  record.models = {"halfspace", "fem"};
  record.references = {"halfspace", "fem"};
  record.cases.push_back(written("wheels", run));
  replace_file(base_ / "compare.json", comparison_json(record));
  ASSERT_EQ(make_report(base_.string(), scripts), "");
  const std::string page = contents(base_ / "compare.html");
  expect_self_contained(page);
  EXPECT_TRUE(says(page, "Where wheel and rail touch", "y track [mm]", "with the contact points",
                   "left wheel,<br>position 1,<br>patch 2 of 2",
                   "Left wheel, position 1, patch 1 of 2", "Beyond them: FEM (p<sub>0</sub> 30 %"));
}

TEST_F(PagesTest, AStudyHasFiguresAndTablesOfEverySeries) {
  StudyRecord study;
  study.provenance.labels = labels;
  study.title = "a <study>";
  study.friction = 0.5;
  StudyPlace place;
  place.creepages = {{0.0, 0.0, 0.0}, {0.002, 0.0, 0.0}};
  place.exact = {{"max_pressure", 100.0}};
  StudySeries fine{"halfspace", "grid", "contact grid", 2.0, {}, ""};
  StudySeries jumpy{"fem", "cell", "FE cell", 2.0, {}, "ran out of memory"};
  for (int k = 0; k < 4; ++k) {
    StudyLevel level;
    level.label = std::to_string(10 << k);
    level.unknowns = 100L << (2 * k);
    level.seconds = 0.1 * std::exp2(2 * k);
    level.values = {{"max_pressure", 100.0 + std::exp2(-2 * k)},
                    {"traction_coefficient:2", 0.3 - 0.01 * std::exp2(-k)}};
    fine.levels.push_back(level);
    level.values["traction_coefficient:2"] = 0.31 + (k % 2 == 0 ? 0.002 : -0.001);
    jumpy.levels.push_back(level);
  }
  StudySeries theory{"hertz", "", "", 0.0, {fine.levels[0]}, ""};
  theory.levels[0].values = {{"max_pressure", 100.0}};
  place.series = {fine, jumpy, theory};
  study.places = {place};
  replace_file(base_ / "study.json", study_json(study));
  replace_file(base_ / "study.csv", study_csv(study));
  ASSERT_EQ(make_report(base_.string(), scripts), "");
  const std::string page = contents(base_ / "study.html");
  expect_self_contained(page);
  EXPECT_TRUE(says(
      page, "a &lt;study&gt;", "half-space, refined in grid", "FEM, refined in cell",
      "ran out of memory", "Finest levels against their references: half-space (grid) ", "order 2",
      "no order", "exact", "extrapolated", "<th scope=col>largest pressure p<sub>0</sub> [MPa]"));
  EXPECT_TRUE(
      says(page, "model difference from half-space", "+1.80 % of μ"));  // 0.309 and 0.3 at mu = 0.5
  EXPECT_EQ(count(page, "<figure>"), 3U);
  for (const char* name : {"values.svg", "speed_error.svg", "error_unknowns.svg"})
    EXPECT_TRUE(says(contents(base_ / "figures" / name), "</svg>")) << name;
}

/// Prints what rollfem/reader.py gives for a result, name by name.
const char* const published = R"(
from rollfem.reader import read_result
from rollfem.figures.published import published
known = [published(s) for _, s in read_result(sys.argv[1]).scenes()]
print(*[row['name'] for each in known for row in each['patch'] + each['creep_curve']], sep='; ')
)";

TEST_F(PagesTest, PublishedValuesStandBesideTheCaseTheyBelongToOnly) {
  RunRecord run = synthetic_run();
  run.input.load.normal_force = 50e3;
  run.input.friction_coefficient = 0.55;
  run.input.wheel.rolling_radius = 405.0;
  run.input.wheel.transverse_radius = contact::infinity;
  const auto names = [&](const char* name, double rail, double wheel) {
    run.input.rail.transverse_radius = rail;
    run.input.wheel.transverse_radius = wheel;
    write_results((base_ / name).string(), run);
    return said(published, base_ / name);
  };
  EXPECT_TRUE(says(names("a", 2000.0, contact::infinity), "thesis: Hertz, from a diagram"));
  EXPECT_EQ(names("b", 500.0, contact::infinity), "Hertz, exact\n");
  EXPECT_EQ(names("d", 2000.0, 105.263), "Hertz, exact\n");
  EXPECT_EQ(names("f", 50.0, -51.282), "Hertz, exact\n");
  EXPECT_EQ(names("none", 501.0, contact::infinity), "\n");
  run.input.load.normal_force = 60e3;
  EXPECT_EQ(names("other", 2000.0, contact::infinity), "\n");
}

TEST_F(PagesTest, PublishedValuesOfProfilesBelongToAPlace) {
  RunRecord run = placed_run(1);
  run.models.resize(2);
  run.input.load.vertical_force = 100e3;
  run.input.friction_coefficient = 0.55;
  run.input.wheel.rolling_radius = 450.0;
  run.input.rail.profile.name = "UIC60-manchester";
  for (contact::ModelResult& model : run.models) {
    model.place->patches = 1;
    model.place->lateral_shift = 2.0;
    model.place->y_track = -755.7;
  }
  const auto names = [&](const char* name) {
    write_results((base_ / name).string(), run);
    return said(published, base_ / name);
  };
  EXPECT_TRUE(says(names("left"), "thesis: SRS (FE)"));
  for (contact::ModelResult& model : run.models) model.place->lateral_shift = 3.0;
  EXPECT_EQ(names("shifted"), "\n");
  for (contact::ModelResult& model : run.models) {
    model.place->lateral_shift = 2.0;
    model.place->y_track = -750.0;  // another gauge or inclination
  }
  EXPECT_EQ(names("elsewhere"), "\n");
}

TEST_F(PagesTest, DataOfAnotherKindIsRefusedInALine) {
  std::ofstream(base_ / "compare.json")
      << sealed_json("{\n  \"format\": 1,\n  \"kind\": \"compare\"\n}\n");
  const std::string message = make_report(base_.string(), scripts);
  EXPECT_TRUE(says(message, "not a comparison that this program reads"));
  EXPECT_FALSE(says(message, "\n"));
}

}  // namespace
}  // namespace rollfem::postprocess
