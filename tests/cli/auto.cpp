// SPDX-License-Identifier: LGPL-2.1-or-later
// The model auto through the program: its choice at 5, 1 and 0.2 %, and where the choice is
// reported.
#include "support/case_examples.hpp"
#include "support/csv_rows.hpp"
#include "support/resume.hpp"

namespace {

/// A nearly circular patch, one load point: the model error of the half-space is 0.6 % of mu.
const std::string quick = with("2000.0", "500.0") + "[rolling]\nlongitudinal_creepage = 0.001\n";

nlohmann::json model_of(const Folder& folder, const std::string& text, int status = 0) {
  const Outcome outcome =
      folder.call({"run", folder.file("case.toml", text), "-o", "out", "--no-report", "-q"});
  EXPECT_EQ(outcome.status, status) << outcome.err;
  return folder.json("out/summary.json")["models"][0];
}

void expect_within(const nlohmann::json& model, double accuracy) {
  const auto& point = model["points"][0];
  const nlohmann::json none = nlohmann::json::object();
  const nlohmann::json left_out = point.contains("model_error") ? point["model_error"] : none;
  for (const auto& [name, whole] :
       {std::pair<const char*, double>{"max_pressure", point["max_pressure"]},
        {"semi_axis_x", point["semi_axis_x"]},
        {"semi_axis_y", point["semi_axis_y"]},
        {"traction_coefficient", 0.55}})
    EXPECT_LE(point["error_estimate"][name].get<double>() + left_out.value(name, 0.0),
              accuracy * whole)
        << name;
}

using Auto = ProgramTest;

TEST_F(Auto, IsTheDefaultAndTakesAHalfSpaceWhereThatDoes) {
  int elements = 0;
  for (const double accuracy : {0.05, 0.01}) {
    const std::string asked =
        accuracy == 0.01 ? std::string() : "accuracy = " + std::to_string(accuracy) + "\n";
    const nlohmann::json model = model_of(folder, asked + quick);
    EXPECT_EQ(model["name"], "halfspace");
    EXPECT_EQ(model["label"], "half-space");
    EXPECT_EQ(model["chosen_by"], "auto");
    EXPECT_EQ(model["choice"].get<std::string>().rfind("half-space, ", 0), 0U) << model["choice"];
    EXPECT_TRUE(says(model["choice"], "model 0."));
    EXPECT_TRUE(model["points"][0].contains("model_error"));
    EXPECT_TRUE(says(model["notes"][0], model["choice"].get<std::string>()));
    expect_within(model, accuracy);
    EXPECT_GT(model["contact_elements"].get<int>(), elements);
    elements = model["contact_elements"].get<int>();
  }
}

TEST_F(Auto, TakesTheHalfSpaceForALineContact) {
  const nlohmann::json model = model_of(
      folder,
      "[load]\nnormal_force = 500.0\n[friction]\ncoefficient = 0.3\n[wheel]\nrolling_radius = "
      "460.0\n[rail]\n[geometry]\nshape = \"line\"\n[rolling]\nlongitudinal_creepage = 0.001\n");
  EXPECT_EQ(model["name"], "halfspace");
  EXPECT_EQ(model["chosen_by"], "auto");
  EXPECT_TRUE(says(model["choice"], "line contact is not estimated"));
  // Hertz: p0 = sqrt(F E* / (pi R)) per mm of width.
  const double pressure = std::sqrt(500.0 * 115384.615 / (3.14159265 * 460.0));
  EXPECT_NEAR(model["points"][0]["max_pressure"].get<double>(), pressure, 0.01 * pressure);
}

TEST_F(Auto, SaysWhatItTookOnTheScreen) {
  const Outcome outcome =
      done({"run", folder.file("case.toml", quick), "--model", "auto", "--no-report"});
  EXPECT_TRUE(says(outcome.out, "halfspace: auto, for 1 %: half-space, ", "finite elements"));
}

TEST_F(Auto, GoesOnToTheHybridWhereTheHalfSpaceLeavesOutTooMuch) {
  const std::string strict = "accuracy = 0.003\n" + quick;
#if ROLLFEM_WITH_FEM
  const nlohmann::json model = model_of(folder, strict);
  EXPECT_EQ(model["name"], "hybrid");
  expect_within(model, 0.003);
  EXPECT_TRUE(says(model["choice"], "; half-space, "));
#else
  // The best available result and a failure; without a requested accuracy a warning.
  const nlohmann::json model = model_of(folder, strict, 1);
  EXPECT_EQ(model["name"], "halfspace");
  EXPECT_TRUE(says(model["choice"], "hybrid: not in this build"));
#endif
}

TEST_F(Auto, TellsLastWhatMissesTheAccuracyAndHasOneModelInAllContacts) {
  // In 60 s, no other model solves six contacts.
  const Outcome run =
      done({"run", folder.file("case.toml", two_positions), "--set", "friction.coefficient=0.2",
            "--set", "wheelset.lateral_shift=[0.0,2.0,3.0]", "-o", "out"});
  const nlohmann::json summary = folder.json("out/summary.json");
  int missed = 0;
  ASSERT_EQ(summary["models"].size(), 6U);
  for (const nlohmann::json& model : summary["models"]) {
    EXPECT_EQ(model["name"], "halfspace");
    const nlohmann::json& point = model["points"][0];
    const auto part = [&](const char* name, double whole) {
      return (point["error_estimate"].value(name, 0.0) + point["model_error"].value(name, 0.0)) /
             whole;
    };
    missed +=
        std::max(
            {part("max_pressure", point["max_pressure"]), part("semi_axis_x", point["semi_axis_x"]),
             part("semi_axis_y", point["semi_axis_y"]), part("traction_coefficient", 0.2)}) > 0.01;
  }
  ASSERT_GT(missed, 1);
  const std::string verdict = summary["verdict"];
  EXPECT_TRUE(says(verdict, std::to_string(missed) + " of 6 contacts miss 1 %: worst ",
                   "% of mu (-F_x/F_z)"));
  EXPECT_EQ(run.out.substr(run.out.size() - verdict.size() - 10), "warning: " + verdict + "\n");
#if ROLLFEM_WITH_FEM
  EXPECT_TRUE(says(verdict, "`--set accuracy=0.01` allows more time: "));
#endif
  const auto rows = csv_rows(folder.text("out/wheelset.csv"));
  for (std::size_t k = 0; k < rows[0].size(); ++k) {
    const bool of_wheel = rows[0][k].rfind("left ", 0) == 0 || rows[0][k].rfind("right ", 0) == 0;
    for (const auto& row : rows) EXPECT_TRUE(!of_wheel || !row.at(k).empty()) << rows[0][k];
  }
  // In the report it stands below the title, before any table.
  const std::string page = folder.text("out/report.html");
  const std::size_t said = page.find(" of 6 contacts miss 1 %");
  ASSERT_NE(said, std::string::npos);
  EXPECT_LT(page.find("<h1"), said);
  EXPECT_LT(said, page.find("<table"));
}

TEST_F(Auto, StandsAloneAndIsNothingToCompare) {
  const std::string file = folder.file("case.toml", quick);
  refuses({"run", file, "--model", "auto", "hertz"}, "auto cannot be combined");
  refuses({"compare", file, "--model", "auto"}, "rollfem run --model auto");
  refuses({"study", file, "--model", "auto"}, "rollfem run --model auto");
  const std::string both = folder.file("both.toml", "models = [\"auto\", \"hertz\"]\n" + quick);
  refuses({"run", both}, "both.toml: models: auto cannot be combined");
}

TEST_F(Auto, CheckWarnsWithTheSentenceOfTheRunThatRefuses) {
  const std::string yields =
      folder.file("yields.toml", quick + "[rail_plasticity]\nyield_stress = 400.0\n");
  const std::string both = folder.file("both.toml", "models = [\"auto\", \"hertz\"]\n" + quick);
  const std::string profiles =
      std::string(ROLLFEM_SOURCE_DIR) + "/cases/verification/twin_disc_ends.toml";
  for (const auto& [words, sentence] :
       std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{yields}, "model auto: wheel_plasticity or rail_plasticity: it cannot handle bodies"},
           {{both}, "models: auto cannot be combined"},
           {{profiles, "--set", "models=[\"carter\"]"}, "model carter: "}}) {
    const Outcome run = call(joined({"run", "--no-report"}, words));
    EXPECT_EQ(run.status, 2);
    EXPECT_TRUE(says(run.err, sentence));
    const std::string refusal = run.err.substr(std::string("rollfem: ").size());
    const Outcome check = done(joined({"check"}, words));
    EXPECT_TRUE(says(check.err, "warning: " + refusal));
    const auto json = nlohmann::json::parse(done(joined({"check", "--json"}, words)).out);
    EXPECT_EQ(json["warnings"].back().get<std::string>() + "\n", refusal);
  }
  EXPECT_TRUE(says(done({"check", yields}).out, "  auto                   no: wheel_plasticity"));
  EXPECT_TRUE(says(done({"check", profiles}).out, "\n  carter                 no: "));
}

TEST_F(Auto, TakesAGivenPressureOfBodiesWithoutRadii) {
  const nlohmann::json model =
      model_of(folder,
               "[load]\nnormal_force = 82e3\n[friction]\ncoefficient = 0.3\n[wheel]\n[rail]\n"
               "[given_pressure]\nsemi_axis_x = 6.0\nsemi_axis_y = 6.0\n[rolling]\nspin = 1e-4\n");
  EXPECT_EQ(model["name"], "halfspace");
  // p0 = 3 F / (2 pi a b)
  EXPECT_NEAR(model["points"][0]["max_pressure"].get<double>(), 1.5 * 82e3 / (3.14159265 * 36.0),
              10.0);
}

TEST_F(Auto, TakesUpWhatAnInterruptedRunHasSolved) {
  // The model error of half-spaces is 0.65 %, so that several grids are needed.
  const std::string curve = "accuracy = 0.007\n" + with("2000.0", "500.0") +
                            "[rolling]\nlongitudinal_creepage = [0.0005, 0.001, 0.002, 0.004]\n";
  const std::string file = folder.file("case.toml", curve);
  const nlohmann::json whole = model_of(folder, curve);
  const auto unfinished = folder.work() / "killed.unfinished";
  const std::vector<std::string> run{"run", file, "-o", "killed", "--no-report"};
  kill_when(folder, command_of(run), [&] { return records(unfinished, "halfspace") > 2; });
  const Outcome outcome = done(joined(run, {"--resume"}));
  EXPECT_TRUE(says(outcome.err, "solutions of an earlier run"));
  const nlohmann::json resumed = folder.json("killed/summary.json")["models"][0];
  EXPECT_EQ(resumed["name"], whole["name"]);
  for (std::size_t k = 0; k < 4; ++k)
    for (const char* name : {"max_pressure", "traction_coefficient"})
      EXPECT_EQ(resumed["points"][k][name], whole["points"][k][name]) << k << name;
}

TEST_F(Auto, TakesBodiesThatAreNotKnownAsHalfSpaces) {
  const std::string plain =
      "[load]\nnormal_force = 1e3\n[friction]\ncoefficient = 0.3\n[wheel]\n[rail]\n"
      "[undeformed_distance]\nquadratic = [0.001, 0.002]\n[rolling]\nproblem = \"frictionless\"\n";
  const nlohmann::json model = model_of(folder, plain);
  EXPECT_TRUE(says(model["choice"].get<std::string>(),
                   "model unknown: only the undeformed distance of the bodies is known"));
}

}  // namespace
