// SPDX-License-Identifier: LGPL-2.1-or-later
// The verification book as called by `./rollfem book` after the build.
#include "support/resume.hpp"

namespace {

const std::string source = ROLLFEM_SOURCE_DIR;
const std::string build =
    std::filesystem::path(ROLLFEM_PROGRAM).parent_path().parent_path().string();

/// The call of the book with results and output in the folder where it is started; `script` runs
/// before its main.
std::vector<std::string> book_call(const std::vector<std::string>& options,
                                   const std::string& script = "") {
  const std::string code = "import sys; from book import published\n" + script +
                           "\nfrom book.__main__ import main; sys.exit(main())";
  return joined({"/usr/bin/env", "PYTHONPATH=" + source + "/benchmarks:" + source + "/postprocess",
                 "PYTHONDONTWRITEBYTECODE=1", "/usr/bin/python3", "-c", code, "--root=" + source,
                 "--build=" + build, "--results=results", "--output=out"},
                options);
}

Outcome book(const Folder& folder, const std::vector<std::string>& options,
             const std::string& script = "") {
  return folder.execute(book_call(options, script));
}

using Book = ProgramTest;

TEST_F(Book, HoldsClosedFormNumberReachedAndTestOfEveryChapterAskedFor) {
  checked(book(folder, {"--only", "hertz", "fastsim"}));
  const auto data = folder.json("out/book.json");
  ASSERT_EQ(data["chapters"].size(), 2U);
  int seen = 0;
  for (const auto& row : data["chapters"][0]["rows"])
    if (row["quantity"] == "rail 80 mm: p0" && row["by"] == "half-space") {
      ++seen;
      // The closed form of the book against the benchmark's table; what was reached is another
      // number.
      EXPECT_NEAR(row["reference"].get<double>(), 1920.375, 1e-3);
      EXPECT_NEAR(row["reached"].get<double>(), 1920.375, 1e-3 * 1920.375);
      EXPECT_GT(std::abs(row["reached"].get<double>() - 1920.375), 0.1);
      EXPECT_TRUE(row["holds"].get<bool>());
    }
  EXPECT_EQ(seen, 1);
  EXPECT_TRUE(says(folder.text("out/README.md"), "[1. Hertz's ellipses](hertz.md)",
                   "27 numbers are judged"));
  EXPECT_TRUE(says(folder.text("out/hertz.md"), "# 1. Hertz's ellipses",
                   "| rail 80 mm: p0, MPa | half-space | 1920.37 |",
                   "`unit.Hertz.GivesTheBenchmarkTable`", "Cost: "));
}

TEST_F(Book, ANumberBeyondItsLimitIsNamedAndEndsWithStatusOne) {
  const Outcome made =
      book(folder, {"--only", "fastsim"}, "published.CONTACT_FASTSIM_A[0.002] = (0.36, 329.48376)");
  EXPECT_EQ(made.status, 1);
  EXPECT_TRUE(says(made.err, "-F_x/F_z at xi = 0.2 %"));
  EXPECT_TRUE(says(folder.text("out/fastsim.md"), "**beyond**"));
}

TEST_F(Book, TakesUpRunsOfTheSameProgramAndCase) {
  checked(book(folder, {"--only", "fastsim"}));
  EXPECT_TRUE(says(book(folder, {"--only", "fastsim"}).out, "fastsim: kept"));
  EXPECT_FALSE(says(book(folder, {"--only", "fastsim", "--fresh"}).out, "kept"));
  // A truncated result is not accepted.
  std::filesystem::remove(folder.work() / "results/fastsim.stamp");
  EXPECT_FALSE(says(book(folder, {"--only", "fastsim"}).out, "fastsim: kept"));
}

/// Reduces the book's first chapter to one run on a given number of elements.
std::string chapter_of(int elements) {
  return "from book import chapters\ndef one(bench):\n  bench.run('one', 'cases/thesis_a.toml', "
         "['halfspace'], {'contact_grid.elements_across': " +
         std::to_string(elements) + "})\n  return chapters.fastsim(bench)\nchapters.ALL[0] = one\n";
}

TEST_F(Book, HasOneOwnerWhoseRunsEndWithIt) {
  Outcome second;
  bool at_work = false;
  kill_when(folder, book_call({"--only", "one"}, chapter_of(400)), [&] {
    if (folder.text("results/one.lock").empty()) return false;
    second = book(folder, {"--only", "fastsim"});
    at_work = folder.holds("results/one.lock");
    return true;
  });
  EXPECT_TRUE(at_work) << "the second waited for the first";
  EXPECT_EQ(second.status, 2) << second.err;
  EXPECT_TRUE(says(second.err, "error: another run is writing ", "out: process ", ", started 20",
                   "--only one; do: wait for it"));
  // Killing the book also killed its run, so the folder is free.
  checked(book(folder, {"--only", "one"}, chapter_of(10)));
  for (const char* lock : {"out.lock", "results.lock", "results/one.lock"})
    EXPECT_FALSE(folder.holds(lock)) << lock;
}

TEST_F(Book, NamesTheErrorOfACall) {
  const Outcome unknown = book(folder, {"--only", "hertzz"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_TRUE(says(unknown.err, "hertzz: unknown chapter; allowed: hertz,"));
  const std::string whole = R"({"chapters": [{"name": "hertz"}, {"name": "fastsim"}]})";
  folder.file("work/out/book.json", whole);
  const Outcome part = book(folder, {"--only", "fastsim"});
  EXPECT_EQ(part.status, 2);
  EXPECT_TRUE(says(part.err, "would remove the other chapters (1) of", "do: name another folder"));
  EXPECT_EQ(folder.text("out/book.json"), whole);
  std::filesystem::remove(folder.work() / "out/book.json");
  const Outcome unbuilt = book(folder, {"--only", "fastsim", "--build", "nowhere"});
  EXPECT_EQ(unbuilt.status, 1);
  EXPECT_TRUE(says(unbuilt.err, "do: ./rollfem build"));
  // A run that fails leaves its chapter out; the others are there.
  const Outcome failed =
      book(folder, {"--only", "hertz", "fastsim"},
           "from book import runs; runs.with_settings = lambda text, settings: text + '[unknown]' "
           "* bool(settings)");
  EXPECT_EQ(failed.status, 1);
  EXPECT_TRUE(says(failed.err, "error: hertz: hertz_300: "));
  EXPECT_TRUE(says(folder.text("out/README.md"), "Left out: hertz"));
  EXPECT_TRUE(says(book(folder, {"--list"}).out, "wheel-on-rail"));
}

}  // namespace
