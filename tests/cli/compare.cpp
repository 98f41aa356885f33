// SPDX-License-Identifier: LGPL-2.1-or-later
// The command compare: several models and cases, skipped and failed models, resuming.
#include "support/case_examples.hpp"
#include "support/csv_rows.hpp"
#include "support/program.hpp"

namespace {

namespace fs = std::filesystem;

const std::string quick_pair = rolling("[0.0, 0.001]", 10);
/// Which theories cannot take.
const std::string given_force =
    small_case + "[rolling]\nlongitudinal_force = -1000.0\n[contact_grid]\nelements_across = 10\n";

using Compare = ProgramTest;

TEST_F(Compare, LaysModelsOfSeveralCasesBesideEachOther) {
  const std::string one = folder.file("one.toml", quick_pair);
  const std::string two = folder.file("two.toml", quick_pair);
  const Outcome outcome = done({"compare", one, two, "--model", "hertz", "fastsim", "halfspace"});
  EXPECT_FALSE(says(outcome.err, "warning"));
  const auto made = folder.made();
  for (const char* name : {"compare.json", "compare.csv", "compare.html", "one/summary.json",
                           "one/results.h5", "two/report.html"})
    EXPECT_TRUE(has(made, std::string("results/compare/") + name)) << name;
  EXPECT_TRUE(says(outcome.out, "Within the error bars of halfspace, hertz: "));
  const auto all = folder.json("results/compare/compare.json");
  ASSERT_EQ(all.at("cases").size(), 2U);
  EXPECT_TRUE(says(outcome.out, all.at("verdict").get<std::string>()));
  // The same numbers as run's own, and the half-space within a coarse grid's error of Hertz, which
  // is exact.
  const auto summary = folder.json("results/compare/one/summary.json");
  int found = 0;
  for (const auto& number : csv_records(folder.text("results/compare/compare.csv"))) {
    if (number.at("case") != "one" || number.at("quantity") != "max_pressure" ||
        number.at("point") != "1")
      continue;
    ++found;
    for (const auto& model : summary.at("models"))
      if (model.at("name") == number.at("model")) {
        EXPECT_EQ(std::stod(number.at("value")), model.at("points")[0].at("max_pressure"));
      }
    if (number.at("model") == "halfspace") {
      EXPECT_LT(std::stod(number.at("difference")), 0.0);  // percent
      EXPECT_GT(std::stod(number.at("difference")), -2.0);
    }
  }
  EXPECT_EQ(found, 3);
}

TEST_F(Compare, ModelsMayStandBeforeTheCaseAndTheReferenceIsChosen) {
  const Outcome outcome = done({"compare", "--no-report", "--reference", "hertz", "--model",
                                "hertz", "halfspace", folder.file("one.toml", quick_pair)});
  EXPECT_TRUE(says(outcome.out, "error bars of hertz: "));
  EXPECT_TRUE(has(folder.made(), "results/compare_one/compare.json"));
  EXPECT_FALSE(has(folder.made(), "results/compare_one/compare.html"));
}

TEST_F(Compare, AModelThatCannotTakeACaseIsLeftOutWithASentence) {
  const std::string file = folder.file("forces.toml", given_force);
  const Outcome outcome = done(
      {"compare", file, "--no-report", "--model", "hertz", "polach", "halfspace", "-o", "out"});
  EXPECT_TRUE(says(outcome.out, "polach: left out: "));
  EXPECT_FALSE(says(outcome.out, "do: run with"));
  const auto all = folder.json("out/compare.json");
  ASSERT_EQ(all.at("cases")[0].at("missing").size(), 1U);
  EXPECT_FALSE(all.at("cases")[0].at("missing")[0].at("failed").get<bool>());
}

TEST_F(Compare, ACaseThatNoModelTakesIsAnErrorThatNamesEachWithItsReason) {
  const std::string none = folder.file("forces.toml", given_force);
  const std::vector<std::string> models{"--no-report", "--model", "polach", "linear", "-o", "out"};
  const Outcome alone = call(joined({"compare", none}, models));
  EXPECT_EQ(alone.status, 2) << alone.err;
  EXPECT_TRUE(says(alone.err, "none of the models can solve forces: polach: ", "; linear: ",
                   "prescribed tangential force", "; do: name one"));
  // Beside a case that they can take, which is written.
  const std::string good = folder.file("good.toml", quick_pair);
  const Outcome both = call(joined({"compare", none, good}, models));
  EXPECT_EQ(both.status, 2);
  EXPECT_TRUE(says(both.err, "none of the models can solve forces"));
  const auto all = folder.json("out/compare.json");
  EXPECT_TRUE(says(folder.text("out/compare.csv"), "\n\"good\","));
  EXPECT_FALSE(all.at("cases")[0].at("complete").get<bool>());
}

TEST_F(Compare, AFailureKeepsTheOtherResultsAndIsReportedLast) {
  // The half-space ends at 320 elements across, short of this accuracy.
  const std::string bad = folder.file("bad.toml", "accuracy = 1e-5\n" + rolling("0.001", 20));
  const std::string good = folder.file("good.toml", quick_pair);
  const Outcome outcome =
      call({"compare", bad, good, "--no-report", "--model", "hertz", "halfspace", "-o", "out"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(says(outcome.err,
                   "rollfem: the comparison was written without the models that failed: "
                   "bad, halfspace: accuracy = 1e-05 was not reached"));
  const auto all = folder.json("out/compare.json");
  ASSERT_EQ(all.at("cases").size(), 2U);
  EXPECT_TRUE(all.at("cases")[0].at("missing")[0].at("failed").get<bool>());
  EXPECT_TRUE(all.at("cases")[1].at("missing").empty());
  EXPECT_TRUE(says(folder.text("out/compare.csv"), "\n\"good\","));
}

TEST_F(Compare, AWrongCaseIsRefusedBeforeAnythingIsComputed) {
  const std::string good = folder.file("good.toml", quick_pair);
  const std::string bad = folder.file("bad.toml", small_case + "no_such_key = 0\n");
  refuses({"compare", good, bad, "--model", "hertz", "-o", "out"}, "no_such_key");
  EXPECT_TRUE(folder.made().empty());
}

TEST_F(Compare, ResumeKeepsFinishedRuns) {
  const std::string one = folder.file("one.toml", quick_pair);
  const std::string two = folder.file("two.toml", quick_pair);
  const std::vector<std::string> models{"--model",     "hertz", "halfspace",
                                        "--no-report", "-o",    "out"};
  done(joined({"compare", one}, models));
  const auto before = fs::last_write_time(folder.work() / "out" / "one" / "results.h5");
  // The state after a kill between writing the result and removing its records.
  folder.file("work/out/one.unfinished/halfspace-0001.point", "record");
  folder.file("work/out/one.unfinished/about.txt", "Load points of an unfinished run of rollfem.");
  const Outcome outcome = done(joined({"compare", one, two, "--resume"}, models));
  EXPECT_TRUE(says(outcome.err, "compare: one was already done"));
  EXPECT_EQ(fs::last_write_time(folder.work() / "out" / "one" / "results.h5"), before);
  EXPECT_FALSE(folder.holds("out/one.unfinished"));
  EXPECT_EQ(folder.json("out/compare.json").at("cases").size(), 2U);
}

TEST_F(Compare, ResumeComputesAgainOnceAFileThatTheCaseNamesHasChanged) {
  const auto distance = [&](double curvature) {
    std::string lines;
    for (int j = -5; j <= 5; ++j)
      for (int i = -5; i <= 5; ++i)
        lines += std::to_string(2 * i) + ',' + std::to_string(2 * j) + ',' +
                 std::to_string(curvature * 4 * (i * i + j * j)) + '\n';
    folder.file("distance.csv", lines);
  };
  distance(1e-3);
  const std::string file = folder.file("one.toml",
                                       "[load]\nnormal_force = 5e4\n[friction]\ncoefficient = 0.3\n"
                                       "[undeformed_distance]\nfile = \"distance.csv\"\n"
                                       "[contact_grid]\nelements_across = 8\n");
  const std::vector<std::string> call{"compare",     file, "--model", "halfspace",
                                      "--no-report", "-o", "out"};
  const auto pressure = [&] {
    return folder.json("out/one/summary.json")["models"][0]["points"][0]["max_pressure"]
        .get<double>();
  };
  done(call);
  const double before = pressure();
  EXPECT_TRUE(says(done(joined(call, {"--resume"})).err, "compare: one was already done"));
  distance(2e-3);
  done(joined(call, {"--resume"}));
  EXPECT_GT(pressure(), 1.2 * before);
}

TEST_F(Compare, RefusesWhatMakesNoSense) {
  const std::string one = folder.file("one.toml", quick_pair);
  refuses({"compare"}, "no case file is named");
  refuses({"compare", one, "--model", "hertzz"}, "no such model");
  refuses({"compare", one, "--model", "hertz", "--reference", "strip"},
          "not among the models compared");
  const std::string other = folder.file("other/one.toml", quick_pair);
  refuses({"compare", one, other, "--model", "hertz"}, "would both be written to");
  done({"run", one, "--model", "hertz", "--no-report", "-o", "out"});
  refuses({"compare", one, "--model", "hertz", "-o", "out"}, "the result of another command");
}

}  // namespace
