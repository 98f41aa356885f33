// The command compare: several models and cases, what is left out and what failed, taking up again.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/case_examples.hpp"
#include "support/json_files.hpp"
#include "support/program.hpp"

namespace {

using namespace rollfem::testing;
namespace fs = std::filesystem;

const std::string quick_pair = small_case +
                               "[rolling]\nlongitudinal_creepage = [0.0, 0.001]\n"
                               "[contact_grid]\nelements_across = 10\n";

TEST(Compare, LaysModelsOfSeveralCasesBesideEachOther) {
  const Folder folder;
  const std::string one = folder.file("one.toml", quick_pair);
  const std::string two = folder.file("two.toml", quick_pair);
  const Outcome outcome =
      call(folder, {"compare", one, two, "--model", "hertz", "fastsim", "halfspace"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err.find("warning"), std::string::npos) << outcome.err;
  const auto made = folder.made();
  for (const char* name : {"compare.json", "compare.csv", "compare.html", "one/summary.json",
                           "one/results.h5", "two/report.html"})
    EXPECT_TRUE(has(made, std::string("results/compare/") + name)) << name;
  EXPECT_NE(outcome.out.find("Within the error bars of halfspace: "), std::string::npos)
      << outcome.out;
  const auto all = read(folder.work() / "results" / "compare" / "compare.json");
  ASSERT_EQ(all.at("cases").size(), 2U);
  EXPECT_NE(outcome.out.find(all.at("verdict").get<std::string>()), std::string::npos);
  // The same numbers as run's own, and Hertz within a coarse grid's error of the half-space.
  const auto summary = read(folder.work() / "results" / "compare" / "one" / "summary.json");
  int found = 0;
  for (const auto& number : all.at("cases")[0].at("numbers")) {
    if (number.at("quantity") != "max_pressure" || number.at("point") != 1) continue;
    ++found;
    for (const auto& model : summary.at("models"))
      if (model.at("name") == number.at("model")) {
        EXPECT_EQ(number.at("value"), model.at("points")[0].at("max_pressure"));
      }
    if (number.at("model") == "hertz") {
      EXPECT_GT(number.at("difference").get<double>(), 0.0);
      EXPECT_LT(number.at("difference").get<double>(), 0.02);
    }
  }
  EXPECT_EQ(found, 3);
}

TEST(Compare, ModelsMayStandBeforeTheCaseAndTheReferenceIsChosen) {
  const Folder folder;
  const Outcome outcome = call(folder, {"compare", "--no-report", "--reference", "hertz", "--model",
                                        "hertz", "halfspace", folder.file("one.toml", quick_pair)});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("error bars of hertz: "), std::string::npos) << outcome.out;
  EXPECT_TRUE(has(folder.made(), "results/compare_one/compare.json"));
  EXPECT_FALSE(has(folder.made(), "results/compare_one/compare.html"));
}

TEST(Compare, AModelThatCannotTakeACaseIsLeftOutWithASentence) {
  const Folder folder;
  const std::string file =
      folder.file("forces.toml", small_case +
                                     "[rolling]\nlongitudinal_force = -1000.0\n"
                                     "[contact_grid]\nelements_across = 10\n");
  const Outcome outcome = call(folder, {"compare", file, "--no-report", "--model", "hertz",
                                        "fastsim", "halfspace", "-o", "out"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("fastsim: left out: "), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("do: run with"), std::string::npos) << outcome.out;
  const auto all = read(folder.work() / "out" / "compare.json");
  ASSERT_EQ(all.at("cases")[0].at("missing").size(), 1U);
  EXPECT_FALSE(all.at("cases")[0].at("missing")[0].at("failed").get<bool>());
}

TEST(Compare, ACaseThatNoModelTakesIsAnErrorThatNamesEachWithItsReason) {
  const Folder folder;
  const std::string none =
      folder.file("forces.toml", small_case +
                                     "[rolling]\nlongitudinal_force = -1000.0\n"
                                     "[contact_grid]\nelements_across = 10\n");
  const std::vector<std::string> models{"--no-report", "--model", "fastsim", "strip", "-o", "out"};
  std::vector<std::string> arguments{"compare", none};
  arguments.insert(arguments.end(), models.begin(), models.end());
  const Outcome alone = call(folder, arguments);
  EXPECT_EQ(alone.status, 2) << alone.err;
  for (const char* part : {"none of the models can solve forces: fastsim: ", "; strip: ",
                           "prescribed tangential force", "; do: name one"})
    EXPECT_NE(alone.err.find(part), std::string::npos) << alone.err;
  // Beside a case that they take: that one is written.
  arguments.insert(arguments.begin() + 2, folder.file("good.toml", quick_pair));
  const Outcome both = call(folder, arguments);
  EXPECT_EQ(both.status, 2);
  EXPECT_NE(both.err.find("none of the models can solve forces"), std::string::npos) << both.err;
  const auto all = read(folder.work() / "out" / "compare.json");
  EXPECT_FALSE(all.at("cases")[1].at("numbers").empty());
  EXPECT_FALSE(all.at("cases")[0].at("complete").get<bool>());
}

TEST(Compare, AFailureDoesNotLoseTheOthersAndIsToldAtTheEnd) {
  const Folder folder;
  // The half-space ends at 320 elements across, short of this accuracy.
  const std::string bad = folder.file("bad.toml", "accuracy = 1e-5\n" + small_case +
                                                      "[rolling]\nlongitudinal_creepage = 0.001\n"
                                                      "[contact_grid]\nelements_across = 20\n");
  const std::string good = folder.file("good.toml", quick_pair);
  const Outcome outcome = call(
      folder, {"compare", bad, good, "--no-report", "--model", "hertz", "halfspace", "-o", "out"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("rollfem: the comparison was written without the models that failed: "
                             "bad, halfspace: accuracy = 1e-05 was not reached"),
            std::string::npos)
      << outcome.err;
  const auto all = read(folder.work() / "out" / "compare.json");
  ASSERT_EQ(all.at("cases").size(), 2U);
  EXPECT_TRUE(all.at("cases")[0].at("missing")[0].at("failed").get<bool>());
  EXPECT_TRUE(all.at("cases")[1].at("missing").empty());
  EXPECT_FALSE(all.at("cases")[1].at("numbers").empty());
}

TEST(Compare, AWrongCaseIsRefusedBeforeAnythingIsComputed) {
  const Folder folder;
  const std::string good = folder.file("good.toml", quick_pair);
  const std::string bad = folder.file("bad.toml", small_case + "no_such_key = 0\n");
  expect_refused(call(folder, {"compare", good, bad, "--model", "hertz", "-o", "out"}),
                 "no_such_key");
  EXPECT_TRUE(folder.made().empty());
}

TEST(Compare, ResumeKeepsWhatIsDone) {
  const Folder folder;
  const std::string one = folder.file("one.toml", quick_pair);
  const std::string two = folder.file("two.toml", quick_pair);
  const std::vector<std::string> models{"--model",     "hertz", "halfspace",
                                        "--no-report", "-o",    "out"};
  std::vector<std::string> first{"compare", one};
  first.insert(first.end(), models.begin(), models.end());
  ASSERT_EQ(call(folder, first).status, 0);
  const auto before = fs::last_write_time(folder.work() / "out" / "one" / "results.h5");
  // What a kill leaves that comes when the result is written and its records have not gone yet.
  folder.file("work/out/one.unfinished/halfspace-0001.point", "record");
  std::vector<std::string> second{"compare", one, two, "--resume"};
  second.insert(second.end(), models.begin(), models.end());
  const Outcome outcome = call(folder, second);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("compare: one was already done"), std::string::npos) << outcome.err;
  EXPECT_EQ(fs::last_write_time(folder.work() / "out" / "one" / "results.h5"), before);
  EXPECT_FALSE(fs::exists(folder.work() / "out" / "one.unfinished"));
  EXPECT_EQ(read(folder.work() / "out" / "compare.json").at("cases").size(), 2U);
}

TEST(Compare, RefusesWhatMakesNoSense) {
  const Folder folder;
  const std::string one = folder.file("one.toml", quick_pair);
  expect_refused(call(folder, {"compare"}), "no case file is named");
  expect_refused(call(folder, {"compare", one, "--model", "hertzz"}), "no such model");
  expect_refused(call(folder, {"compare", one, "--model", "hertz", "--reference", "strip"}),
                 "not among the models compared");
  fs::create_directory(folder.output("other"));
  std::ofstream(folder.output("other") / "one.toml") << quick_pair;
  expect_refused(call(folder, {"compare", one, (folder.output("other") / "one.toml").string(),
                               "--model", "hertz"}),
                 "would both be written to");
  ASSERT_EQ(call(folder, {"run", one, "--model", "hertz", "--no-report", "-o", "out"}).status, 0);
  expect_refused(call(folder, {"compare", one, "--model", "hertz", "-o", "out"}),
                 "the result of another command");
}

}  // namespace
