// A model registered by one line (tests/support/toy_program.cpp) is there in every command, in
// help, messages, tables and reports.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/case_examples.hpp"
#include "support/json_files.hpp"
#include "support/places.hpp"
#include "support/program.hpp"
#include <cmath>

namespace {

using namespace rollfem::testing;

const std::string quick_creep = small_case +
                                "[rolling]\nlongitudinal_creepage = [0.0, 0.001]\n"
                                "[contact_grid]\nelements_across = 10\n";

Outcome toy(const Folder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), ROLLFEM_TOY_PROGRAM);
  return execute(folder, arguments);
}

void expect_in(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
}

TEST(ToyModel, IsInHelpDocsChecksAndMessages) {
  const Folder folder;
  const std::string file = folder.file("q.toml", "models = [\"stiff\"]\n" + quick_creep);
  for (const char* command : {"run", "compare", "study"})
    expect_in(toy(folder, {command, "--help"}).out, "the half-space, its compliance times 0.9");
  expect_in(toy(folder, {"docs", "models"}).out, "| `stiff` | stiff half-space |");
  expect_in(toy(folder, {"docs", "case-file"}).out, "halfspace, hybrid, fem, stiff |");
  const Outcome checked = toy(folder, {"check", file});
  EXPECT_EQ(checked.status, 0) << checked.err;
  expect_in(checked.out, "stiff                  the half-space, its compliance times 0.9");
  expect_in(toy(folder, {"run", file, "--model", "stif"}).err,
            "halfspace, hybrid, fem, stiff; do: ");
  // Without it the same file is refused, with line, key, value and what is allowed.
  const Outcome without = call(folder, {"check", file});
  expect_refused(without, "q.toml:1:");
  expect_refused(without, "models = [\"stiff\"]: is not known");
  expect_refused(without, "strip, halfspace, hybrid, fem");
  // Others name it where it can and they cannot; it is refused where it cannot.
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

TEST(ToyModel, RunsBesideTheOthersWithItsReport) {
  const Folder folder;
  const Outcome outcome =
      toy(folder, {"run", folder.file("q.toml", quick_creep), "-m", "hertz", "halfspace", "stiff"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err.find("warning"), std::string::npos) << outcome.err;
  expect_in(outcome.out, "stiff  ");
  expect_in(outcome.err, "stiff      normal");  // progress
  const auto models = read(folder.work() / "results" / "q" / "summary.json").at("models");
  ASSERT_EQ(models.size(), 3U);
  EXPECT_EQ(models[2].at("name"), "stiff");
  EXPECT_EQ(models[2].at("label"), "stiff half-space");
  // Pressure goes with the modulus to the power 2/3.
  const double soft = models[1].at("points")[0].at("max_pressure");
  const double stiff = models[2].at("points")[0].at("max_pressure");
  EXPECT_NEAR(stiff / soft, std::pow(0.9, -2.0 / 3.0), 1e-6);
  expect_in(contents(folder.work() / "results" / "q" / "report.html"), "stiff half-space");
}

TEST(ToyModel, IsComparedAndMayBeTheReference) {
  const Folder folder;
  const std::string file = folder.file("q.toml", quick_creep);
  const Outcome outcome = toy(folder, {"compare", file, "-m", "hertz", "halfspace", "stiff",
                                       "--reference", "stiff", "-o", "out"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err.find("warning"), std::string::npos) << outcome.err;
  expect_in(contents(folder.work() / "out" / "compare.html"), "stiff half-space");
  const auto all = read(folder.work() / "out" / "compare.json");
  int found = 0;
  for (const auto& number : all.at("cases")[0].at("numbers"))
    if (number.at("model") == "halfspace" && number.at("quantity") == "max_pressure" &&
        number.at("point") == 1) {
      ++found;
      EXPECT_EQ(number.at("reference"), "stiff");
      EXPECT_NEAR(number.at("difference").get<double>(), std::pow(0.9, 2.0 / 3.0) - 1.0, 1e-6);
    }
  EXPECT_EQ(found, 1);
}

TEST(ToyModel, IsStudiedAsTheHalfSpaceIs) {
  const Folder folder;
  const Outcome outcome = toy(folder, {"study", folder.file("q.toml", quick_creep), "-m",
                                       "halfspace", "stiff", "--levels", "3", "-o", "out"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  expect_in(outcome.out, "stiff");
  const auto series = read(folder.work() / "out" / "study.json").at("places")[0].at("series");
  ASSERT_EQ(series.size(), 2U);
  EXPECT_EQ(series[1].at("model"), "stiff");
  EXPECT_EQ(series[1].at("levels").size(), 3U);
  expect_in(contents(folder.work() / "out" / "study.html"), "stiff half-space");
}

TEST(ToyModel, GoesOnFromItsCheckpointAndGivesStresses) {
  const Folder folder;
  const std::string file = folder.file("q.toml", quick_creep);
  ASSERT_EQ(toy(folder, {"run", file, "-m", "stiff", "--no-report", "--resume"}).status, 0);
  const Outcome stress = toy(folder, {"stress", "results/q", "--at", "0,0,2", "--no-figures"});
  EXPECT_EQ(stress.status, 0) << stress.err;
  expect_in(stress.out, "stiff");
}

}  // namespace
