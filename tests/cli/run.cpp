// The command run: what it leaves and says on success, on failure and on Ctrl-C.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/case_examples.hpp"
#include "support/places.hpp"
#include "support/program.hpp"

namespace {

using namespace rollfem::testing;
namespace fs = std::filesystem;

const std::string quick_run = "models = [\"hertz\", \"halfspace\"]\n" + small_case +
                              "[rolling]\nlongitudinal_creepage = [0.0, 0.001]\n"
                              "[contact_grid]\nelements_across = 10\n";

bool has_control_characters(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7f;
  });
}

TEST(Run, LeavesResultsAndSaysWhere) {
  const Folder folder;
  const Outcome outcome = call(folder, {"run", folder.file("quick.toml", quick_run)});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err.find("warning"), std::string::npos) << outcome.err;
  const auto made = folder.made();
  for (const char* name : {"results/quick/summary.json", "results/quick/results.h5",
                           "results/quick/creep_curve.csv", "results/quick/report.html"})
    EXPECT_TRUE(has(made, name)) << name;
  EXPECT_NE(outcome.out.find("results: results/quick\n"), std::string::npos) << outcome.out;
  const auto summary =
      nlohmann::json::parse(contents(folder.work() / "results" / "quick" / "summary.json"));
  ASSERT_EQ(summary.at("models").size(), 2u);
  EXPECT_EQ(summary.at("models")[0].at("name"), "hertz");
  EXPECT_EQ(summary.at("models")[1].at("name"), "halfspace");
  EXPECT_EQ(summary.at("models")[1].at("points").size(), 2u);
  // The printed table and the file are the same numbers.
  const double p0 = summary.at("models")[0].at("points")[0].at("max_pressure");
  char text[32];
  std::snprintf(text, sizeof text, "%12.3f", p0);
  EXPECT_NE(outcome.out.find(text), std::string::npos) << text << outcome.out;
}

TEST(Run, SaysWhichProblemIsSolved) {
  const std::string grid = "[contact_grid]\nelements_across = 10\n";
  struct Row {
    const char *problem, *stage, *note;
  };
  for (const Row& row :
       {Row{"[rolling]\nproblem = \"frictionless\"\n", "frictionless", "; normal problem alone"},
        Row{"[rolling]\nproblem = \"shift\"\n[history]\n"
            "longitudinal_shift = [0.001, 0.001]\n",
            "shift              2/2 ", "; shift without rolling"}}) {
    const Folder folder;
    const std::string file = folder.file("quick.toml", small_case + row.problem + grid);
    const Outcome outcome = call(folder, {"run", file, "--model", "halfspace", "--no-report"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.err.find(row.stage), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.out.find(row.note), std::string::npos) << outcome.out;
    for (const char* word : {" xi ", "rolling "})
      EXPECT_EQ(outcome.err.find(word), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out.find("upwind"), std::string::npos) << outcome.out;
  }
}

TEST(Run, TakesModelsFromTheCommandLineInAnyPlace) {
  const Folder folder;
  const std::string file = folder.file("quick.toml", quick_run);
  const std::vector<std::vector<std::string>> calls{
      {"run", "--no-report", "--model", "hertz", file, "-q"},
      {"run", file, "-q", "--no-report", "-m", "hertz"},
      {"run", "-q", "--no-report", "--model=hertz", file},
      {"run", "-q", "--no-report", "--model", "hertz", "--model", "hertz", file},
  };
  for (const auto& arguments : calls) {
    const Outcome outcome = call(folder, arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto summary =
        nlohmann::json::parse(contents(folder.work() / "results" / "quick" / "summary.json"));
    EXPECT_EQ(summary.at("models").size(), 1u);
  }
}

TEST(Run, WithoutATerminalPrintsNoControlCharactersAndAPlainLinePerStage) {
  const Folder folder;
  const Outcome outcome =
      call(folder, {"run", "--no-report", folder.file("quick.toml", quick_run)}, {"TERM=xterm"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_FALSE(has_control_characters(outcome.err)) << outcome.err;
  EXPECT_FALSE(has_control_characters(outcome.out)) << outcome.out;
  EXPECT_NE(outcome.err.find("halfspace"), std::string::npos) << outcome.err;
  EXPECT_LT(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 20) << outcome.err;
}

TEST(Run, WithoutAReportGetsItLater) {
  const Folder folder;
  const std::string result = folder.output("result").string();
  ASSERT_EQ(call(folder, {"run", "--no-report", folder.file("quick.toml", quick_run), "-o", result})
                .status,
            0);
  EXPECT_FALSE(fs::exists(fs::path(result) / "report.html"));
  const Outcome outcome = call(folder, {"report", result});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(fs::path(result) / "report.html"));
  expect_refused(call(folder, {"report", "nowhere"}), "nowhere holds no result; do: ");
  fs::create_directory(folder.work() / "empty");
  expect_refused(call(folder, {"report", "empty"}), "empty holds no result; do: ");
}

TEST(Run, QuietPrintsNothing) {
  const Folder folder;
  const Outcome outcome =
      call(folder, {"run", "--quiet", "--model", "hertz", folder.file("q.toml", quick_run)});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "");
}

TEST(Run, WritesToTheNamedFolder) {
  const Folder folder;
  const std::string file = folder.file("q.toml", quick_run);
  ASSERT_EQ(call(folder, {"run", "-q", "--no-report", "-m", "hertz", "-o", "a/b", file}).status, 0);
  EXPECT_TRUE(has(folder.made(), "a/b/summary.json"));
}

TEST(Run, AFolderThatCannotBeMadeIsRefusedBeforeComputing) {
  const Folder folder;
  const std::string file = folder.file("q.toml", quick_run);
  for (const std::string& directory : {file, file + "/below", std::string("/proc/no/such")}) {
    const Outcome outcome = call(folder, {"run", file, "-o", directory});
    EXPECT_EQ(outcome.status, 2) << directory << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  EXPECT_TRUE(folder.made().empty());
}

TEST(Run, CtrlCLeavesNothing) {
  const Folder folder;
  std::string slow = quick_run;
  slow.replace(slow.find("elements_across = 10"), 20, "elements_across = 400");
  const Outcome outcome = call(folder, {"run", folder.file("slow.toml", slow)}, {}, 300);
  EXPECT_EQ(outcome.status, 128 + SIGINT) << outcome.err;
  EXPECT_TRUE(folder.made().empty());
}

TEST(Run, GridBeyondAllMemoryIsAnErrorNotACrash) {
  const Folder folder;
  std::string vast = quick_run;
  vast.replace(vast.find("elements_across = 10"), 20, "cell_size = [1e-5, 1e-5]");
  const Outcome outcome = call(folder, {"run", folder.file("vast.toml", vast)});
  EXPECT_TRUE(outcome.status == 1 || outcome.status == 2) << outcome.status << outcome.err;
  EXPECT_NE(outcome.err.find("rollfem: "), std::string::npos) << outcome.err;
  EXPECT_TRUE(folder.made().empty());
}

TEST(Run, OnlyTheFirstProcessOfAParallelRunWorksOnTheHalfSpace) {
  const Folder folder;
  const std::string file = folder.file("q.toml", quick_run);
  const Outcome other =
      call(folder, {"run", file}, {"OMPI_COMM_WORLD_RANK=1", "OMPI_COMM_WORLD_SIZE=2"});
  EXPECT_EQ(other.status, 0);
  EXPECT_EQ(other.out + other.err, "");
  EXPECT_TRUE(folder.made().empty());
}

TEST(Run, AllTheoriesAreModelsWithTheirCurvesAndFigures) {
  const Folder folder;
  const std::vector<std::string> models{"hertz",   "linear", "vermeulen-johnson", "carter",
                                        "fastsim", "strip",  "halfspace"};
  std::vector<std::string> arguments{"run", folder.file("q.toml", quick_run), "-m"};
  arguments.insert(arguments.end(), models.begin(), models.end());
  const Outcome outcome = call(folder, arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto summary =
      nlohmann::json::parse(contents(folder.work() / "results" / "q" / "summary.json"));
  ASSERT_EQ(summary.at("models").size(), models.size());
  for (std::size_t k = 0; k < models.size(); ++k)
    EXPECT_EQ(summary.at("models")[k].at("name"), models[k]);
  const std::string report = contents(folder.work() / "results" / "q" / "report.html");
  for (const char* label : {"FASTSIM", "Vermeulen-Johnson", "Carter", "linear theory", "strip"})
    EXPECT_NE(report.find(label), std::string::npos) << label;
}

TEST(Run, AModelThatCannotTakeTheCaseIsRefusedBeforeAnyIsRun) {
  const Folder folder;
  const std::string shift = small_case +
                            "[rolling]\nproblem = \"shift\"\n[history]\n"
                            "longitudinal_shift = 0.001\n";
  const Outcome outcome =
      call(folder, {"run", folder.file("s.toml", shift), "-m", "halfspace", "fastsim"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("model fastsim: rolling.problem"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("halfspace  "), std::string::npos) << outcome.err;
  EXPECT_TRUE(folder.made().empty());
}

TEST(Run, AFolderOfOtherThingsIsRefusedBeforeComputing) {
  const Folder folder;
  fs::create_directory(folder.work() / "mine");
  std::ofstream(folder.work() / "mine" / "thesis.txt") << "years of work";
  const Outcome outcome = call(folder, {"run", folder.file("q.toml", quick_run), "-o", "mine"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err.find("normal"), std::string::npos) << outcome.err;  // no progress line
  EXPECT_NE(outcome.err.find("holds files that are not"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.made(), (std::vector<std::string>{"mine", "mine/thesis.txt"}));
}

TEST(Run, PointsBelowTheSurfaceComeOutAsATable) {
  const Folder folder;
  const std::string below = quick_run +
                            "[[subsurface.line]]\nfrom = [0, 0, 0.5]\nto = [0, 0, 6]\npoints = 12\n"
                            "[[subsurface.plane]]\nbody = \"rail\"\nfrom = [-4, 0, -1]\n"
                            "to = [4, 0, -1]\nacross = [-4, 0, -5]\npoints = [9, 5]\n";
  ASSERT_EQ(call(folder, {"run", "-q", folder.file("q.toml", below)}).status, 0);
  const std::string table = contents(folder.work() / "results" / "q" / "subsurface.csv");
  // Head, and twelve points at each of two load points; planes are in results.h5 alone.
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 2 * 12) << table;
  const Outcome hertz =
      call(folder, {"run", "--no-report", folder.file("q.toml", below), "-m", "hertz"});
  EXPECT_EQ(hertz.status, 0);
  EXPECT_NE(hertz.err.find("warning: "), std::string::npos) << hertz.err;
}

TEST(Run, AShiftAndAGivenPressureAreReportedStepByStep) {
  const Folder folder;
  for (const char* name : {"cattaneo", "benchmark9"}) {
    const std::string file =
        (fs::path(ROLLFEM_SOURCE_DIR) / "cases" / (std::string(name) + ".toml")).string();
    const Outcome outcome = call(folder, {"run", file});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("warning"), std::string::npos) << outcome.err;
    EXPECT_TRUE(has(folder.made(), std::string("results/") + name + "/report.html"));
  }
  const auto summary =
      nlohmann::json::parse(contents(folder.work() / "results" / "cattaneo" / "summary.json"));
  const auto& steps = summary.at("models")[1].at("points");
  ASSERT_EQ(steps.size(), 15u);
  // Cattaneo: after the shift of 0.008172 mm the force is 7/8 mu F_z.
  EXPECT_NEAR(steps[2].at("longitudinal_shift").get<double>(), 0.008172, 1e-12);
  EXPECT_NEAR(steps[2].at("traction_coefficient").get<double>(), 0.35, 0.003 * 0.35);
}

#if !ROLLFEM_WITH_FEM
TEST(Run, FemInABuildWithoutItIsAnErrorNotSilence) {
  const Folder folder;
  const std::string by_list = folder.file("list.toml", "models = [\"fem\"]\n" + small_case);
  const Outcome list = call(folder, {"run", by_list});
  EXPECT_EQ(list.status, 2);
  EXPECT_NE(list.err.find("list.toml: models: model fem is not in this build"), std::string::npos)
      << list.err;
  const Outcome option = call(folder, {"run", by_list, "--model", "fem"});
  EXPECT_EQ(option.status, 2);
  EXPECT_NE(option.err.find("--model fem: model fem is not in this build"), std::string::npos);
  EXPECT_TRUE(folder.made().empty());
}
#endif

}  // namespace
