// SPDX-License-Identifier: LGPL-2.1-or-later
// Files that are not what their names say: devices, FIFOs, links, other people's files. Nothing
// hangs, nothing of theirs is quoted or deleted, and no spreadsheet computes what a name says.
#include "support/case_examples.hpp"
#include "support/program.hpp"
#include <sys/stat.h>

namespace {

namespace fs = std::filesystem;

class Hostile : public ProgramTest {
 protected:
  std::string pipe(const std::string& name) const {
    const std::string path = (folder.work() / name).string();
    mkfifo(path.c_str(), 0600);
    return path;
  }
  std::string device(const std::string& name) const {
    fs::create_symlink("/dev/zero", folder.work() / name);
    return (folder.work() / name).string();
  }
};

TEST_F(Hostile, NoDeviceAndNoFifoIsRead) {
  const std::string quick = folder.file("q.toml", small_case);
  for (const std::string& name : {pipe("p.sections"), pipe("p.slcs"), pipe("p.csv"),
                                  device("z.sections"), device("z.slcs"), device("z.csv")})
    refuses({"profile", name, "--rail"}, "is not a regular file");
  for (const std::string& name : {pipe("p"), device("z")}) {
    refuses({"convert", name, "-o", "made"}, "is not a regular file");
    refuses({"check", name}, "is not a regular file");
    refuses({"stress", name}, "is not a regular file");
    refuses({"run", folder.file("given.toml", small_case + "[undeformed_distance]\nfile = \"work/" +
                                                  fs::path(name).filename().string() + "\"\n")},
            "is not a regular file");
    refuses({"stress", "somewhere", "--places", name}, "");
  }
  pipe("o.lock");
  refuses({"run", quick, "-o", "o"}, "is in the way");
  EXPECT_TRUE(fs::is_fifo(folder.work() / "o.lock"));
  fs::create_directory(folder.work() / "s");
  pipe("s/summary.json");
  refuses({"run", quick, "-o", "s"}, "not an earlier result");
  fs::create_directory(folder.work() / "u.unfinished");
  pipe("u.unfinished/about.txt");
  pipe("u.unfinished/halfspace-0001.point");
  for (const char* option : {"--resume", "--quiet"})
    refuses({"run", quick, "-o", "u", option}, "which rollfem did not write");
  EXPECT_TRUE(fs::is_fifo(folder.work() / "u.unfinished" / "halfspace-0001.point"));
}

TEST_F(Hostile, OtherPeoplesFilesAreNotQuoted) {
  const std::string secret = "root:$6$verysecret=:19000:0:::\ndaemon:*:19:0\nname\n";
  for (const auto& [name, arguments, said] :
       {std::tuple<const char*, Words, const char*>{"a.toml", {"check"}, "is not a case file"},
        {"b.toml", {"run"}, "is not a case file"},
        {"a.inp", {"convert"}, "is not an input file of CONTACT"},
        {"a.csv", {"profile", "--wheel"}, "is not a profile"},
        {"a.sections", {"profile", "--wheel"}, "is not a list of sections"},
        {"a.slcs", {"profile"}, "is not a list of sections"}}) {
    Words words = arguments;
    words.push_back(folder.file(name, secret));
    const Outcome outcome = call(words);
    expect_refused(outcome, said);
    EXPECT_FALSE(says(outcome.err, "secret")) << outcome.err;
    EXPECT_FALSE(says(outcome.err, "root")) << outcome.err;
  }
  // A case with a mistake is quoted, so that the mistake is found.
  refuses({"check", folder.file("c.toml", small_case + "wrong line\n")}, "`wrong line`");
}

TEST_F(Hostile, NoNameIsAFormulaOfASpreadsheet) {
  for (const char* name : {"=cmd|calc!A1.toml", "@sum.toml", "+1.toml", "-2.toml"})
    folder.file(std::string("work/") + name, small_case);
  done({"compare", "./=cmd|calc!A1.toml", "./@sum.toml", "./+1.toml", "./-2.toml", "-m", "hertz",
        "--no-report", "-o", "out"});
  std::istringstream rows(folder.text("out/compare.csv"));
  for (std::string row; std::getline(rows, row);)
    EXPECT_TRUE(row.rfind("case,", 0) == 0 || row.rfind("\"'", 0) == 0) << row;
}

TEST_F(Hostile, AResultOfAnotherCommandIsNotJoined) {
  const std::string quick = folder.file("q.toml", small_case);
  for (const auto& [command, other] : {std::pair<const char*, const char*>{"study", "table.h5"},
                                       {"compare", "table.h5"},
                                       {"table", "study.json"}}) {
    folder.file("work/f/" + std::string(other), "");
    refuses({command, quick, "-o", "f"}, "holds the result of another command");
    fs::remove_all(folder.work() / "f");
  }
}

TEST_F(Hostile, AnImpossibleNumberOfThreadsIsNamed) {
  expect_refused(call({"run", folder.file("q.toml", small_case), "-o", "o", "--no-report"},
                      {"OMP_NUM_THREADS=999999999"}),
                 "OMP_NUM_THREADS = 999999999; allowed: 1 to 1024");
}

TEST_F(Hostile, PositionsOfSectionsAreBounded) {
  refuses({"profile", folder.file("work/far.sections", "-1e308 60E1\n1e308 60E1\n"), "--rail"},
          "far.sections:1: position -1e+308; allowed: up to 1e+09");
}

TEST_F(Hostile, ATinyPatchFarFromWhereTheBodiesTouchFirstNeedsNoMemory) {
  const std::string file = folder.file("edge.toml", R"(models = ["halfspace"]
[load]
vertical_force = 1e-6
[friction]
coefficient = 1e-12
[wheel]
rolling_radius = 50.0
profile = "arcs"
[rail]
profile = "60E1"
[contact_grid]
elements_across = 10
[placement]
side = "right"
lateral_position = 2.792686301844646
yaw = -0.28101079231916926
roll = -0.44850217825619976
[wheel_profile]
radii = [inf]
ends = [-5.0, 5.0]
free_ends = true
)");
  const Outcome outcome = call({"run", file, "-o", "out", "--no-report", "--quiet"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(says(outcome.err, "edge.toml", "; do: "));
  EXPECT_FALSE(says(outcome.err, "out of memory"));
}

}  // namespace
