// SPDX-License-Identifier: LGPL-2.1-or-later
// The command run: its files and messages on success, on failure and on Ctrl-C.
#include "support/case_examples.hpp"
#include "support/program.hpp"

namespace {

namespace fs = std::filesystem;

const std::string quick_run = "models = [\"hertz\", \"halfspace\"]\n" + rolling("[0.0, 0.001]", 10);

bool has_control_characters(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7f;
  });
}

class Run : public ProgramTest {};

TEST_F(Run, AReportThatCouldNotBeDrawnIsStatus1WithTheResultsWritten) {
  const std::string file = folder.file("quick.toml", quick_run);
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"run", file, "-o", "out"}, {"profile", "S1002", "-o", "out"}}) {
    EXPECT_EQ(call(words).status, 0) << words[0];
    const Outcome outcome = call(words, {"ROLLFEM_PYTHON=/nowhere/python3"});
    EXPECT_EQ(outcome.status, 1) << words[0];
    EXPECT_TRUE(says(outcome.err, "not drawn: ")) << outcome.err;
  }
  EXPECT_TRUE(fs::exists(folder.work() / "out/summary.json"));
  EXPECT_TRUE(fs::exists(folder.work() / "out/profile.csv"));
}

TEST_F(Run, LeavesResultsAndSaysWhere) {
  const Outcome outcome = done({"run", folder.file("quick.toml", quick_run)});
  EXPECT_FALSE(says(outcome.err, "warning"));
  const auto made = folder.made();
  for (const char* name : {"results/quick/summary.json", "results/quick/results.h5",
                           "results/quick/creep_curve.csv", "results/quick/report.html"})
    EXPECT_TRUE(has(made, name)) << name;
  EXPECT_TRUE(says(outcome.out, "results: results/quick\n"));
  const auto summary = folder.json("results/quick/summary.json");
  ASSERT_EQ(summary.at("models").size(), 2u);
  EXPECT_EQ(summary.at("models")[0].at("name"), "hertz");
  EXPECT_EQ(summary.at("models")[1].at("name"), "halfspace");
  EXPECT_EQ(summary.at("models")[1].at("points").size(), 2u);
  // The printed table and the file are the same numbers.
  const double p0 = summary.at("models")[0].at("points")[0].at("max_pressure");
  char text[32];
  std::snprintf(text, sizeof text, "%12.3f", p0);
  EXPECT_TRUE(says(outcome.out, text));
}

TEST_F(Run, LeavesNoFileOfAnEarlierRunInItsFolder) {
  const std::string file = folder.file("quick.toml", quick_run);
  const auto run = [&](const std::string& directory, const std::string& friction) {
    done(
        {"run", file, "--no-report", "-o", directory, "--set", "friction.coefficient=" + friction});
  };
  run("fresh", "0.1");
  run("again", "0.5");
  run("again", "0.1");
  for (const char* name : {"/pass_work.csv", "/path_x.csv", "/path_y.csv"})
    EXPECT_EQ(folder.text(std::string("again") + name), folder.text(std::string("fresh") + name));
}

TEST_F(Run, AReportIsDrawnOfAFileWhoseNameIsNotUtf8) {
  done({"run", folder.file("latin\xe9.toml", quick_run), "-o", "out"});
  EXPECT_TRUE(folder.holds("out/report.html"));
}

TEST_F(Run, SaysWhichProblemIsSolved) {
  const std::string grid = "[contact_grid]\nelements_across = 10\n";
  struct Row {
    const char *problem, *stage, *note;
  };
  for (const Row& row :
       {Row{"[rolling]\nproblem = \"frictionless\"\n", "frictionless", "; normal problem only"},
        Row{"[rolling]\nproblem = \"shift\"\n[history]\n"
            "longitudinal_shift = [0.001, 0.001]\n",
            "shift              2/2 ", "; shift without rolling"}}) {
    const std::string file = folder.file("quick.toml", small_case + row.problem + grid);
    const Outcome outcome = done({"run", file, "--model", "halfspace", "--no-report"});
    EXPECT_TRUE(says(outcome.err, row.stage));
    EXPECT_TRUE(says(outcome.out, row.note));
    for (const char* word : {" xi ", "rolling "}) EXPECT_FALSE(says(outcome.err, word));
    EXPECT_FALSE(says(outcome.out, "upwind"));
  }
}

TEST_F(Run, TakesModelsFromTheCommandLineInAnyPlace) {
  const std::string file = folder.file("quick.toml", quick_run);
  const std::vector<std::vector<std::string>> calls{
      {"run", "--no-report", "--model", "hertz", file, "-q"},
      {"run", file, "-q", "--no-report", "-m", "hertz"},
      {"run", "-q", "--no-report", "--model=hertz", file},
      {"run", "-q", "--no-report", "--model", "hertz", "--model", "hertz", file},
  };
  for (const auto& arguments : calls) {
    done(arguments);
    const auto summary = folder.json("results/quick/summary.json");
    EXPECT_EQ(summary.at("models").size(), 1u);
  }
}

TEST_F(Run, WithoutATerminalPrintsNoControlCharactersAndAPlainLinePerStage) {
  const Outcome outcome =
      done({"run", "--no-report", folder.file("quick.toml", quick_run)}, {"TERM=xterm"});
  EXPECT_FALSE(has_control_characters(outcome.err)) << outcome.err;
  EXPECT_FALSE(has_control_characters(outcome.out)) << outcome.out;
  EXPECT_TRUE(says(outcome.err, "halfspace"));
  EXPECT_LT(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 20) << outcome.err;
}

TEST_F(Run, WithoutAReportGetsItLater) {
  const std::string result = folder.path("result");
  done({"run", "--no-report", folder.file("quick.toml", quick_run), "-o", result});
  EXPECT_FALSE(fs::exists(fs::path(result) / "report.html"));
  done({"report", result});
  EXPECT_TRUE(fs::exists(fs::path(result) / "report.html"));
  refuses({"report", "nowhere"}, "nowhere holds no result; do: ");
  fs::create_directory(folder.work() / "empty");
  refuses({"report", "empty"}, "empty holds no result; do: ");
}

TEST_F(Run, QuietPrintsNothingAndWritesToTheNamedFolder) {
  const Outcome outcome = done({"run", "--quiet", "--no-report", "--model", "hertz", "-o", "a/b",
                                folder.file("q.toml", quick_run)});
  EXPECT_EQ(outcome.out + outcome.err, "");
  EXPECT_TRUE(has(folder.made(), "a/b/summary.json"));
}

TEST_F(Run, AnExistingForeignFolderIsKeptAndRefusedBeforeComputing) {
  const std::string file = folder.file("q.toml", quick_run);
  for (const char* precious : {"mine/thesis.txt", "out.unfinished/thesis.txt", "locked.lock"})
    folder.file(std::string("work/") + precious, "years of work");
  const auto before = folder.made();
  for (const auto& [directory, said] : {std::pair<std::string, const char*>{file, ""},
                                        {file + "/below", ""},
                                        {"/proc/no/such", ""},
                                        {".", "is the current folder"},
                                        {"/", "/ is the root folder"},
                                        {"mine", "holds files that are not"},
                                        {"out", "thesis.txt"},
                                        {"locked", "is in the way"}}) {
    const Outcome outcome = call({"run", file, "-o", directory});
    expect_refused(outcome, said);
    EXPECT_FALSE(says(outcome.err, "normal"));  // no progress line
  }
  EXPECT_EQ(folder.made(), before);
  EXPECT_EQ(folder.text("locked.lock"), "years of work");
}

TEST_F(Run, GridBeyondAllMemoryIsAnErrorNotACrash) {
  std::string vast = quick_run;
  vast.replace(vast.find("elements_across = 10"), 20, "cell_size = [1e-5, 1e-5]");
  const Outcome outcome = call({"run", folder.file("vast.toml", vast)});
  EXPECT_TRUE(outcome.status == 1 || outcome.status == 2) << outcome.status << outcome.err;
  EXPECT_TRUE(says(outcome.err, "rollfem: "));
  EXPECT_TRUE(folder.made().empty());
}

TEST_F(Run, OnlyTheFirstProcessOfAParallelRunWorksOnTheHalfSpace) {
  const std::string file = folder.file("q.toml", quick_run);
  const Outcome other = done({"run", file}, {"OMPI_COMM_WORLD_RANK=1", "OMPI_COMM_WORLD_SIZE=2"});
  EXPECT_EQ(other.out + other.err, "");
  EXPECT_TRUE(folder.made().empty());
}

TEST_F(Run, AllTheoriesAreModelsWithTheirCurvesAndFigures) {
  const std::vector<std::string> models{"hertz",   "linear", "vermeulen-johnson",
                                        "polach",  "carter", "fastsim",
                                        "fastrip", "strip",  "halfspace"};
  done(joined({"run", folder.file("q.toml", quick_run), "-m"}, models));
  const auto summary = folder.json("results/q/summary.json");
  ASSERT_EQ(summary.at("models").size(), models.size());
  for (std::size_t k = 0; k < models.size(); ++k)
    EXPECT_EQ(summary.at("models")[k].at("name"), models[k]);
  const std::string report = folder.text("results/q/report.html");
  EXPECT_TRUE(says(report, "FASTSIM", "FaStrip", "Vermeulen-Johnson", "Carter", "Polach",
                   "linear theory", "strip"));
}

TEST_F(Run, AModelThatCannotTakeTheCaseIsRefusedBeforeAnyIsRun) {
  const std::string shift = small_case +
                            "[rolling]\nproblem = \"shift\"\n[history]\n"
                            "longitudinal_shift = 0.001\n";
  refuses({"run", folder.file("s.toml", shift), "-m", "halfspace", "fastsim"},
          "model fastsim: rolling.problem");
  EXPECT_TRUE(folder.made().empty());
}

TEST_F(Run, PointsBelowTheSurfaceComeOutAsATable) {
  const std::string below = quick_run +
                            "[[subsurface.line]]\nfrom = [0, 0, 0.5]\nto = [0, 0, 6]\npoints = 12\n"
                            "[[subsurface.plane]]\nbody = \"rail\"\nfrom = [-4, 0, -1]\n"
                            "to = [4, 0, -1]\nacross = [-4, 0, -5]\npoints = [9, 5]\n";
  done({"run", "-q", folder.file("q.toml", below)});
  const std::string table = folder.text("results/q/subsurface.csv");
  // Head, and twelve points at each of two load points; planes are in results.h5 alone.
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 2 * 12) << table;
  const Outcome hertz = done({"run", "--no-report", folder.file("q.toml", below), "-m", "hertz"});
  EXPECT_TRUE(says(hertz.out, "no stress below the surface; models that compute it: halfspace"));
}

TEST_F(Run, AShiftAndAGivenPressureAreReportedStepByStep) {
  for (const char* name : {"cattaneo", "benchmark9"}) {
    const std::string file =
        (fs::path(ROLLFEM_SOURCE_DIR) / "cases" / (std::string(name) + ".toml")).string();
    const Outcome outcome = done({"run", file});
    EXPECT_FALSE(says(outcome.err, "warning"));
    EXPECT_TRUE(has(folder.made(), std::string("results/") + name + "/report.html"));
  }
  const auto summary = folder.json("results/cattaneo/summary.json");
  const auto& steps = summary.at("models")[1].at("points");
  ASSERT_EQ(steps.size(), 15u);
  // Cattaneo: after the shift of 0.008172 mm the force is 7/8 mu F_z.
  EXPECT_NEAR(steps[2].at("longitudinal_shift").get<double>(), 0.008172, 1e-12);
  EXPECT_NEAR(steps[2].at("traction_coefficient").get<double>(), 0.35, 0.003 * 0.35);
}

/// What is printed in place of the given forces gives these forces back.
TEST_F(Run, CreepagesFoundForAForceAreTabulated) {
  const auto solved = [&](const std::string& motion, std::string& printed) {
    printed = done({"run", folder.file("f.toml", "models = [\"halfspace\"]\n" + small_case +
                                                     "[contact_grid]\nelements_across = 16\n"
                                                     "[rolling]\nspin = 1e-4\n" +
                                                     motion)})
                  .out;
    return folder.json("results/f/summary.json").at("models")[0].at("points")[0];
  };
  std::string out, again;
  const auto point = solved("longitudinal_force = -9e3\nlateral_force = -6e3\n", out);
  std::string found;
  for (const char* name : {"longitudinal", "lateral"}) {
    const std::size_t at = out.find(std::string(name) + " creepage ");
    ASSERT_NE(at, std::string::npos) << out;
    std::istringstream table(out.substr(out.find('\n', out.find('\n', at) + 1) + 1));
    std::string forces[2], spin, value;
    table >> forces[0] >> forces[1] >> spin >> value;
    EXPECT_EQ(forces[0] + ' ' + forces[1], "-9000 -6000");
    found += std::string(name) + "_creepage = " + value + '\n';
  }
  EXPECT_FALSE(says(out, "coefficient -F"));
  const std::string report = folder.text("results/f/report.html");
  EXPECT_TRUE(says(report, "Lateral creepage η, found for the given force", "ξ, found"));
  EXPECT_FALSE(says(report, "Traction coefficient −"));
  EXPECT_TRUE(folder.holds("results/f/figures/creep_found.svg"));
  const auto back = solved(found, again);
  EXPECT_NEAR(back.at("longitudinal_force").get<double>(), -9e3, 1.0);
  EXPECT_NEAR(back.at("lateral_force").get<double>(), -6e3, 1.0);
  EXPECT_TRUE(says(again, "traction coefficient -F_x/F_z"));
}

#if !ROLLFEM_WITH_FEM
TEST_F(Run, FemInABuildWithoutItIsAnErrorNotSilence) {
  const std::string by_list = folder.file("list.toml", "models = [\"fem\"]\n" + small_case);
  const Outcome list = call({"run", by_list});
  EXPECT_EQ(list.status, 2);
  EXPECT_TRUE(says(list.err, "list.toml: models: model fem is not in this build"));
  const Outcome option = call({"run", by_list, "--model", "fem"});
  EXPECT_EQ(option.status, 2);
  EXPECT_TRUE(says(option.err, "--model fem: model fem is not in this build"));
  EXPECT_TRUE(folder.made().empty());
}
#endif

}  // namespace
