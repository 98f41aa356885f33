// SPDX-License-Identifier: LGPL-2.1-or-later
// check, new-case, docs, --version, wrong calls and hostile files: exit status and message.
#include "support/case_examples.hpp"
#include "support/program.hpp"
#include <sys/stat.h>

namespace {

namespace fs = std::filesystem;

using Check = ProgramTest;

TEST_F(Check, AcceptsEveryCommittedCase) {
  int cases = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(ROLLFEM_SOURCE_DIR) / "cases")) {
    if (entry.path().extension() != ".toml") continue;
    const Outcome outcome = call({"check", entry.path().string()});
    EXPECT_EQ(outcome.status, 0) << entry.path() << outcome.err;
    const std::string name = entry.path().filename().string();
    if (name.rfind("conformal_", 0) == 0)
      EXPECT_EQ(outcome.err.rfind("warning: the patch is not small against the bodies", 0), 0u)
          << name << outcome.err;
    else
      EXPECT_EQ(outcome.err, "") << name;
    if (name.rfind("thesis_", 0) == 0) {
      EXPECT_TRUE(says(outcome.out, "normal_force           50000 N"));
    }
    ++cases;
  }
  EXPECT_GE(cases, 6);
  EXPECT_TRUE(folder.made().empty());
}

TEST_F(Check, DoesNotLoadTheLibrariesOfFiniteElements) {
  // Loading them takes longer than everything else in check.
  const std::string file = folder.file("case.toml", small_case);
  const Outcome outcome = done({"check", file}, {"LD_DEBUG=files"});
  EXPECT_TRUE(says(outcome.err, "librollfem_contact"));
  for (const char* library : {"librollfem_fem", "libdeal", "libtrilinos", "libgmsh"})
    EXPECT_FALSE(says(outcome.err, library));
}

using NewCase = ProgramTest;

TEST_F(NewCase, IsAcceptedByCheck) {
  const Outcome made = done({"new-case"});
  done({"check", folder.file("new.toml", made.out)});
}

using Call = ProgramTest;

TEST_F(Call, APathThatIsTooLongIsAWrongCall) {
  const std::string path(300, 'x');
  for (const std::string command : {"run", "profile", "report", "mesh", "stress"})
    refuses({command, path}, "xxx");
  refuses({"new-case", "-o", path}, "xxx: File name too long; do: correct the path");
}

TEST_F(NewCase, WritesANewFileButNeverOverAnother) {
  done({"new-case", "-o", "new.toml"});
  done({"check", "new.toml"});
  refuses({"new-case", "-o", "new.toml"}, "already exists");
  refuses({"new-case", "-o", "no/such/folder.toml"}, "cannot write");
  // A file that does not fit is not left truncated.
  const Outcome full = execute({"/bin/sh", "-c", "ulimit -f 4; exec \"$0\" \"$@\"", ROLLFEM_PROGRAM,
                                "new-case", "-o", "full.toml"});
  EXPECT_EQ(full.status, 1);  // the call is right
  EXPECT_TRUE(says(full.err, "ulimit -f"));
  EXPECT_FALSE(folder.holds("full.toml"));
}

using Docs = ProgramTest;

TEST_F(Docs, CommittedPagesAreTheGeneratedOnes) {
  for (const std::string page : {"case-file", "models"}) {
    const Outcome outcome = done({"docs", page});
    EXPECT_EQ(outcome.out, contents(fs::path(ROLLFEM_SOURCE_DIR) / "docs" / (page + ".md")))
        << "run: rollfem docs " << page << " > docs/" << page << ".md";
  }
}

TEST_F(Call, VersionAndHelpAreAnswered) {
  const Outcome version = done({"--version"});
  EXPECT_EQ(version.out.rfind("rollfem 0.1.0", 0), 0u) << version.out;
  const Outcome help = done({"--help"});
  EXPECT_TRUE(says(help.out, "run", "check", "new-case"));
  done({"run", "--help"});
  EXPECT_EQ(call({"help"}).out, help.out);
  EXPECT_EQ(call({"help", "run"}).out, call({"run", "--help"}).out);
}

TEST_F(Call, WrongCallsAreRefused) {
  const std::string file = folder.file("case.toml", small_case);
  expect_refused(call({}), "no command given");
  refuses({"bogus"}, "bogus: unknown command");
  refuses({"rnu"}, "rnu: unknown command; did you mean run? ");
  refuses({""}, "");
  refuses({"--bogus"}, "do: rollfem --help");
  refuses({"check"}, "case is required");
  refuses({"check", file, "more"}, "more");
  refuses({"run"}, "no case file");
  refuses({"run", file, "--model", "fme"}, "--model fme: no such model; did you mean fem? ");
  refuses({"run", file, "--model"}, "--model");
  refuses({"run", file, "--bogus"}, "--bogus");
  refuses({"run", file, "--modle=hertz"}, "did you mean --model?");
  refuses({"docs", "novel"}, "novel");
  refuses({"hlep"}, "did you mean help? ");
  refuses({"docs", "schem"}, "schem is not allowed; did you mean schema? ");
  refuses({"study", file, "--vary", "gird"}, "did you mean grid? ");
  refuses({"profile", "S1003"}, "did you mean S1002? ");
  refuses({"run", file, "--ouput", "x"},
          "--ouput: unknown option; did you mean --output? allowed: --help");
  EXPECT_TRUE(folder.made().empty());
}

using HostileFile = ProgramTest;

TEST_F(HostileFile, IsRefusedByCheckAndRunAlike) {
  std::string binary(4096, '\0');
  for (std::size_t i = 0; i < binary.size(); ++i) binary[i] = static_cast<char>(i * 7919 >> 3);
  fs::create_directory(folder.path("folder.toml"));
  mkfifo(folder.path("pipe.toml").c_str(), 0600);
  std::string deep;
  for (int i = 0; i < 4000; ++i) deep += "a.";
  const std::vector<std::pair<std::string, std::string>> files{
      {folder.file("binary.toml", binary), "binary"},
      {folder.file("empty.toml", ""), "is empty"},
      {folder.file("nan.toml", with("50e3", "nan")), "load.normal_force = nan"},
      {folder.file("huge.toml", with("50e3", "1e400")), "1e400"},
      {folder.file("deep.toml", "[" + deep + "a]\n" + deep + "b = 1\n"),
       "nested more than 64 deep"},
      {folder.path("folder.toml"), "is a folder"},
      {folder.path("pipe.toml"), "is not a regular file"},
      {"/dev/zero", "is not a regular file"},
      {"missing.toml", "missing.toml: there is no such file"},
      {"", ""},
      {std::string(5000, 'x'), ""},
  };
  for (const auto& [file, part] : files) {
    refuses({"check", file}, part);
    refuses({"run", file}, part);
  }
  EXPECT_TRUE(folder.made().empty());
}

using Output = ProgramTest;

TEST_F(Output, ThatCannotBeWrittenIsAnError) {
  const std::string command = std::string(ROLLFEM_PROGRAM) + " new-case > /dev/full";
  const Outcome outcome = execute({"sh", "-c", command});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(says(outcome.err, "cannot be written"));
}

}  // namespace
