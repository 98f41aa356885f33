// The verification book: what `./rollfem book` calls once the program is built.
#include <nlohmann/json.hpp>

#include "support/places.hpp"
#include "support/resume.hpp"
#include <cmath>

namespace {

using rollfem::testing::contents;
using rollfem::testing::execute;
using rollfem::testing::Folder;
using rollfem::testing::kill_when;
using rollfem::testing::Outcome;

const std::string source = ROLLFEM_SOURCE_DIR;
const std::string build =
    std::filesystem::path(ROLLFEM_PROGRAM).parent_path().parent_path().string();

/// The call of the book with results and output in the folder where it is started; `script` runs
/// before its main.
std::vector<std::string> book_call(const std::vector<std::string>& options,
                                   const std::string& script) {
  const std::string code = "import sys; from book import published\n" + script +
                           "\nfrom book.__main__ import main; sys.exit(main())";
  std::vector<std::string> call{"/usr/bin/env",
                                "PYTHONPATH=" + source + "/benchmarks:" + source + "/postprocess",
                                "PYTHONDONTWRITEBYTECODE=1",
                                "/usr/bin/python3",
                                "-c",
                                code,
                                "--root=" + source,
                                "--build=" + build,
                                "--results=results",
                                "--output=out"};
  call.insert(call.end(), options.begin(), options.end());
  return call;
}

Outcome book(const Folder& folder, const std::vector<std::string>& options,
             const std::string& script = "") {
  return execute(folder, book_call(options, script));
}

TEST(Book, HoldsClosedFormNumberReachedAndTestOfEveryChapterAskedFor) {
  const Folder folder;
  const Outcome made = book(folder, {"--only", "hertz", "fastsim"});
  ASSERT_EQ(made.status, 0) << made.err;
  const auto data = nlohmann::json::parse(contents(folder.work() / "out/book.json"));
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
  const std::string page = contents(folder.work() / "out/README.md");
  for (const char* text :
       {"## 1. Hertz's ellipses", "| rail 80 mm: p0, MPa | half-space | 1920.37 |",
        "`unit.Hertz.GivesTheBenchmarkTable`", "27 of 27 numbers", "Cost: "})
    EXPECT_NE(page.find(text), std::string::npos) << text;
}

TEST(Book, OfANumberBeyondWhatIsAllowedEndsWithStatusOneAndSaysWhich) {
  const Folder folder;
  const Outcome made =
      book(folder, {"--only", "fastsim"}, "published.CONTACT_FASTSIM_A[0.002] = (0.36, 329.48376)");
  EXPECT_EQ(made.status, 1);
  EXPECT_NE(made.err.find("-F_x/F_z at xi = 0.2 %"), std::string::npos) << made.err;
  EXPECT_NE(contents(folder.work() / "out/README.md").find("**beyond**"), std::string::npos);
}

TEST(Book, TakesUpRunsOfTheSameProgramAndCase) {
  const Folder folder;
  ASSERT_EQ(book(folder, {"--only", "fastsim"}).status, 0);
  EXPECT_NE(book(folder, {"--only", "fastsim"}).out.find("fastsim: kept"), std::string::npos);
  EXPECT_EQ(book(folder, {"--only", "fastsim", "--fresh"}).out.find("kept"), std::string::npos);
  // A result that was cut short is not taken for one.
  std::filesystem::remove(folder.work() / "results/fastsim.stamp");
  EXPECT_EQ(book(folder, {"--only", "fastsim"}).out.find("kept"), std::string::npos);
}

/// Makes the book's first chapter one run on a grid of so many elements.
std::string chapter_of(int elements) {
  return "from book import chapters\ndef one(bench):\n  bench.run('one', 'cases/thesis_a.toml', "
         "['halfspace'], {'contact_grid.elements_across': " +
         std::to_string(elements) + "})\n  return chapters.fastsim(bench)\nchapters.ALL[0] = one\n";
}

TEST(Book, HasOneOwnerWhoseRunsEndWithIt) {
  const Folder folder;
  Outcome second;
  bool at_work = false;
  const auto killed = kill_when(folder, book_call({"--only", "one"}, chapter_of(400)), [&] {
    if (contents(folder.work() / "results/one.lock").empty()) return false;
    second = book(folder, {"--only", "fastsim"});
    at_work = std::filesystem::exists(folder.work() / "results/one.lock");
    return true;
  });
  ASSERT_TRUE(killed.killed) << killed.err;
  EXPECT_TRUE(at_work) << "the second waited for the first";
  EXPECT_EQ(second.status, 2) << second.err;
  for (const char* part : {"error: another run is writing ", "out: process ", ", started 20",
                           "--only one; do: wait for it"})
    EXPECT_NE(second.err.find(part), std::string::npos) << second.err;
  // The book was killed, and with it the run that it had called: its folder can be had.
  const Outcome third = book(folder, {"--only", "one"}, chapter_of(10));
  EXPECT_EQ(third.status, 0) << third.err;
  for (const char* lock : {"out.lock", "results.lock", "results/one.lock"})
    EXPECT_FALSE(std::filesystem::exists(folder.work() / lock)) << lock;
}

TEST(Book, SaysWhatIsWrongWithACall) {
  const Folder folder;
  const Outcome unknown = book(folder, {"--only", "hertzz"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("hertzz: there is no such chapter; allowed: hertz,"),
            std::string::npos)
      << unknown.err;
  const Outcome unbuilt = book(folder, {"--only", "fastsim", "--build", "nowhere"});
  EXPECT_EQ(unbuilt.status, 1);
  EXPECT_NE(unbuilt.err.find("do: ./rollfem build"), std::string::npos) << unbuilt.err;
  // A run that fails leaves its chapter out; the others are there.
  const Outcome failed =
      book(folder, {"--only", "hertz", "fastsim"},
           "from book import runs; runs.with_settings = lambda text, settings: text + '[unknown]' "
           "* bool(settings)");
  EXPECT_EQ(failed.status, 1);
  EXPECT_NE(failed.err.find("error: hertz: hertz_300: "), std::string::npos) << failed.err;
  EXPECT_NE(contents(folder.work() / "out/README.md").find("Left out: hertz"), std::string::npos);
  EXPECT_NE(book(folder, {"--list"}).out.find("wheel-on-rail"), std::string::npos);
}

}  // namespace
