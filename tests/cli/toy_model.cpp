// SPDX-License-Identifier: LGPL-2.1-or-later
// A model registered by one line (tests/support/toy_program.cpp) is there in every command, in
// help, messages, tables and reports.
#include "support/case_examples.hpp"
#include "support/csv_rows.hpp"
#include "support/program.hpp"

namespace {

const std::string quick_creep = rolling("[0.0, 0.001]", 10);

Outcome toy(const Folder& folder, const std::vector<std::string>& arguments) {
  return folder.execute(joined({ROLLFEM_TOY_PROGRAM}, arguments));
}

using ToyModel = ProgramTest;

TEST_F(ToyModel, IsInHelpDocsChecksAndMessages) {
  const std::string file = folder.file("q.toml", "models = [\"stiff\"]\n" + quick_creep);
  for (const char* command : {"run", "compare", "study"})
    EXPECT_TRUE(
        says(toy(folder, {command, "--help"}).out, "the half-space, its compliance times 0.9"));
  EXPECT_TRUE(says(toy(folder, {"docs", "models"}).out, "| `stiff` | stiff half-space |"));
  EXPECT_TRUE(says(toy(folder, {"docs", "case-file"}).out, "halfspace, hybrid, fem, stiff |"));
  const Outcome check = checked(toy(folder, {"check", file}));
  EXPECT_TRUE(says(check.out, "stiff                  the half-space, its compliance times 0.9"));
  EXPECT_TRUE(says(toy(folder, {"run", file, "--model", "stif"}).err,
                   "halfspace, hybrid, fem, stiff; do: "));
  // Without it the same file is refused, with line, key, value and allowed values.
  const Outcome without = call({"check", file});
  expect_refused(without, "q.toml:1:");
  expect_refused(without, "models = [\"stiff\"]: is not known");
  expect_refused(without, "strip, halfspace, hybrid, fem");
  // Other models name it for cases that only it can take; it refuses cases that it cannot take.
  const std::string shift = folder.file(
      "s.toml", small_case + "[rolling]\nproblem = \"shift\"\n[history]\nlateral_shift = 0.01\n");
  expect_refused(toy(folder, {"run", shift, "--model", "fastsim"}),
                 "allowed: hertz, halfspace, hybrid, fem, stiff; do: run with --model halfspace");
  const std::string fast =
      folder.file("f.toml", small_case + "[rolling]\nspeed = 5e4\n[fem]\ninertia = true\n");
  expect_refused(toy(folder, {"run", fast, "--model", "stiff"}),
                 "model stiff: fem.inertia: it cannot handle the inertia of moving bodies; "
                 "allowed: fem; do: run with --model fem");
  EXPECT_TRUE(folder.made().empty());
}

TEST_F(ToyModel, ConstantOfALawIsAKeyOfThatLaw) {
  const auto check = [&](const std::string& law, const std::string& number) {
    const std::string keys = "coefficient = 0.4\nlaw = \"" + law +
                             "\"\nkinetic_coefficient = 0.2\nhalf_velocity = 500.0\n" + number;
    const std::string text = with("coefficient = 0.55", keys) + "[rolling]\nspeed = 10e3\n";
    return toy(folder, {"check", folder.file("law.toml", text)});
  };
  EXPECT_TRUE(says(checked(check("power", "power_of_slip = 2.0")).out, "power_of_slip"));
  checked(check("power", ""));
  expect_refused(check("power", "power_of_slip = 0.5"), "friction.power_of_slip = 0.5");
  expect_refused(check("linear", "power_of_slip = 2.0"),
                 "is of the law power, but friction.law is linear; allowed: with law = \"power\"");
  EXPECT_TRUE(says(toy(folder, {"docs", "case-file"}).out, "1 with the law `power`"));
}

TEST_F(ToyModel, RunsBesideTheOthersWithItsReport) {
  const Outcome outcome = checked(toy(
      folder, {"run", folder.file("q.toml", quick_creep), "-m", "hertz", "halfspace", "stiff"}));
  EXPECT_FALSE(says(outcome.err, "warning"));
  EXPECT_TRUE(says(outcome.out, "stiff  "));
  EXPECT_TRUE(says(outcome.err, "stiff      normal"));  // progress
  const auto models = folder.json("results/q/summary.json").at("models");
  ASSERT_EQ(models.size(), 3U);
  EXPECT_EQ(models[2].at("name"), "stiff");
  EXPECT_EQ(models[2].at("label"), "stiff half-space");
  // Pressure goes with the modulus to the power 2/3.
  const double soft = models[1].at("points")[0].at("max_pressure");
  const double stiff = models[2].at("points")[0].at("max_pressure");
  EXPECT_NEAR(stiff / soft, std::pow(0.9, -2.0 / 3.0), 1e-6);
  EXPECT_TRUE(says(folder.text("results/q/report.html"), "stiff half-space"));
}

TEST_F(ToyModel, IsComparedAndMayBeTheReference) {
  const std::string file = folder.file("q.toml", quick_creep);
  const Outcome outcome = checked(toy(folder, {"compare", file, "-m", "hertz", "halfspace", "stiff",
                                               "--reference", "stiff", "-o", "out"}));
  EXPECT_FALSE(says(outcome.err, "warning"));
  EXPECT_TRUE(says(folder.text("out/compare.html"), "stiff half-space"));
  int found = 0;
  for (const auto& number : csv_records(folder.text("out/compare.csv")))
    if (number.at("model") == "halfspace" && number.at("quantity") == "max_pressure" &&
        number.at("point") == "1") {
      ++found;
      EXPECT_EQ(number.at("reference"), "stiff");
      EXPECT_NEAR(std::stod(number.at("difference")), 100.0 * (std::pow(0.9, 2.0 / 3.0) - 1.0),
                  1e-4);
    }
  EXPECT_EQ(found, 1);
}

TEST_F(ToyModel, IsStudiedAsTheHalfSpaceIs) {
  const Outcome outcome =
      checked(toy(folder, {"study", folder.file("q.toml", quick_creep), "-m", "halfspace", "stiff",
                           "--levels", "3", "-o", "out"}));
  EXPECT_TRUE(says(outcome.out, "stiff"));
  const auto series = folder.json("out/study.json").at("places")[0].at("series");
  ASSERT_EQ(series.size(), 2U);
  EXPECT_EQ(series[1].at("model"), "stiff");
  EXPECT_EQ(series[1].at("levels").size(), 3U);
  EXPECT_TRUE(says(folder.text("out/study.html"), "stiff half-space"));
}

TEST_F(ToyModel, GoesOnFromItsCheckpointAndGivesStresses) {
  const std::string file = folder.file("q.toml", quick_creep);
  checked(toy(folder, {"run", file, "-m", "stiff", "--no-report", "--resume"}));
  const Outcome stress = checked(toy(
      folder, {"stress", "results/q", "--places",
               folder.file("at.toml", "[[subsurface.point]]\nat = [0, 0, 2]\n"), "--no-figures"}));
  EXPECT_TRUE(says(stress.out, "stiff"));
}

}  // namespace
