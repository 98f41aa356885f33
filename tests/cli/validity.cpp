// SPDX-License-Identifier: LGPL-2.1-or-later
// Results that the program refuses, and results with a warning.
#include "support/program.hpp"

namespace {

std::string text_of(const std::string& load, const std::string& rest) {
  return load +
         "[friction]\ncoefficient = 0.3\n"
         "[wheel]\nrolling_radius = 460\ntransverse_radius = inf\n"
         "[rail]\ntransverse_radius = 300\n" +
         rest;
}

const std::string fifty_kilonewtons = "[load]\nnormal_force = 50e3\n";

using Gate = ProgramTest;

TEST_F(Gate, CellsLargerThanThePatchAreRefusedInEveryModel) {
  const std::string file =
      folder.file("cell.toml", text_of(fifty_kilonewtons,
                                       "[rolling]\nlongitudinal_creepage = 0.001\n"
                                       "[contact_grid]\ncell_size = [1000.0, 1000.0]\n"));
  for (const char* model : {"hertz", "linear", "vermeulen-johnson", "polach", "carter", "fastsim",
                            "fastrip", "strip", "halfspace"}) {
    const Outcome outcome = call({"run", "-q", "--no-report", "--model", model, file});
    EXPECT_EQ(outcome.status, 1) << model << outcome.err;
    EXPECT_TRUE(says(
        outcome.err,
        std::string("cell.toml: model ") + model +
            ": load point 1 of 1: the patch has only 1 by 1 contact elements of 1000 by 1000 mm"));
  }
  EXPECT_FALSE(folder.holds("results"));
}

TEST_F(Gate, AStepOfAHistoryThatTheGridDoesNotSeeIsRefused) {
  const Outcome outcome = call(

      {"run", "-q", "--no-report", "--model", "halfspace",
       folder.file("step.toml",
                   text_of("",
                           "[rolling]\nproblem = \"transient\"\nlongitudinal_creepage = 0.001\n"
                           "[history]\nnormal_force = [50e3, 1e-3, 50e3]\nstep_length = 1.0\n"
                           "[contact_grid]\nelements_across = 20\n"))});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_TRUE(says(outcome.err, "load point 2 of 3: the patch has only 2 by 2 contact elements"));
}

TEST_F(Gate, APatchAsLargeAsTheBodiesIsWarnedOfEverywhere) {
  const std::string file = folder.file(
      "huge.toml",
      text_of("[load]\nnormal_force = 1e10\n", "[contact_grid]\nelements_across = 10\n"));
  const Outcome outcome = done({"run", "--model", "hertz", "--model", "halfspace", file});
  const auto summary = folder.json("results/huge/summary.json");
  const std::string report = folder.text("results/huge/report.html");
  for (const auto& model : summary.at("models")) {
    std::string notes;
    for (const auto& note : model.at("notes")) notes += note.get<std::string>() + "\n";
    for (const char* said : {"warning: the patch is not small against the bodies",
                             "warning: the approach is not small against the radii",
                             "warning: the largest pressure, 5."}) {
      EXPECT_TRUE(says(notes, said));
      EXPECT_TRUE(says(outcome.out, model.at("name").get<std::string>() + ": " + said));
      EXPECT_TRUE(says(report, said));
    }
  }
}

TEST_F(Gate, CheckAndRunWarnOfWrongUnits) {
  const std::string kilonewtons =
      folder.file("kn.toml", text_of("[load]\nnormal_force = 80\n",
                                     "[rolling]\nlongitudinal_creepage = 0.6\nspin = 1.0\n"));
  for (const Outcome& outcome :
       {call({"check", kilonewtons}),
        call({"run", "-q", "--no-report", "--model", "hertz", kilonewtons})}) {
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(says(outcome.err, "warning: ", "kn.toml: load.normal_force = 80 N",
                     "rolling.longitudinal_creepage = 0.6", "rolling.spin = 1 rad/mm"));
  }
  // A wheel in m under its load in N: no steel bears that.
  const Outcome metres =
      done({"check", folder.file("m.toml",
                                 "[load]\nnormal_force = 80e3\n[friction]\n"
                                 "coefficient = 0.3\n[wheel]\nrolling_radius = 0.46\n"
                                 "transverse_radius = inf\n[rail]\n"
                                 "transverse_radius = 0.3\n")});
  EXPECT_TRUE(says(metres.err, "wheel.rolling_radius = 0.46 mm", "rail.transverse_radius = 0.3 mm",
                   "MPa, which no rail or wheel steel carries"));
}

}  // namespace
