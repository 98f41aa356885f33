// SPDX-License-Identifier: LGPL-2.1-or-later
// check, new-case, docs, --version, wrong calls and hostile files: exit status and message.
#include <gtest/gtest.h>

#include "support/case_examples.hpp"
#include "support/places.hpp"
#include "support/program.hpp"
#include <sys/stat.h>

namespace {

using namespace rollfem::testing;
namespace fs = std::filesystem;

TEST(Check, AcceptsEveryCommittedCase) {
  const Folder folder;
  int cases = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(ROLLFEM_SOURCE_DIR) / "cases")) {
    if (entry.path().extension() != ".toml") continue;
    const Outcome outcome = call(folder, {"check", entry.path().string()});
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

TEST(Check, DoesNotLoadTheLibrariesOfFiniteElements) {
  // Loading them takes longer than everything else in check.
  const Folder folder;
  const std::string file = folder.file("case.toml", small_case);
  const Outcome outcome = done(folder, {"check", file}, {"LD_DEBUG=files"});
  EXPECT_TRUE(says(outcome.err, "librollfem_contact"));
  for (const char* library : {"librollfem_fem", "libdeal", "libtrilinos", "libgmsh"})
    EXPECT_FALSE(says(outcome.err, library));
}

TEST(NewCase, IsAcceptedByCheck) {
  const Folder folder;
  const Outcome made = done(folder, {"new-case"});
  done(folder, {"check", folder.file("new.toml", made.out)});
}

TEST(Call, APathThatIsTooLongIsAWrongCall) {
  const Folder folder;
  const std::string path(300, 'x');
  for (const std::string command : {"run", "profile", "report", "mesh", "stress"})
    expect_refused(call(folder, {command, path}), "xxx");
  expect_refused(call(folder, {"new-case", "-o", path}),
                 "xxx: File name too long; do: correct the path");
}

TEST(NewCase, WritesANewFileButNeverOverAnother) {
  const Folder folder;
  done(folder, {"new-case", "-o", "new.toml"});
  done(folder, {"check", "new.toml"});
  expect_refused(call(folder, {"new-case", "-o", "new.toml"}), "already exists");
  expect_refused(call(folder, {"new-case", "-o", "no/such/folder.toml"}), "cannot write");
  // A file that does not fit is not left truncated.
  const Outcome full = execute(folder, {"/bin/sh", "-c", "ulimit -f 4; exec \"$0\" \"$@\"",
                                        ROLLFEM_PROGRAM, "new-case", "-o", "full.toml"});
  EXPECT_EQ(full.status, 1);  // the call is right
  EXPECT_TRUE(says(full.err, "ulimit -f"));
  EXPECT_FALSE(folder.holds("full.toml"));
}

TEST(Docs, CommittedPagesAreTheGeneratedOnes) {
  const Folder folder;
  for (const std::string page : {"case-file", "models"}) {
    const Outcome outcome = done(folder, {"docs", page});
    EXPECT_EQ(outcome.out, contents(fs::path(ROLLFEM_SOURCE_DIR) / "docs" / (page + ".md")))
        << "run: rollfem docs " << page << " > docs/" << page << ".md";
  }
}

TEST(Call, VersionAndHelpAreAnswered) {
  const Folder folder;
  const Outcome version = done(folder, {"--version"});
  EXPECT_EQ(version.out.rfind("rollfem 0.1.0", 0), 0u) << version.out;
  const Outcome help = done(folder, {"--help"});
  EXPECT_TRUE(says(help.out, "run", "check", "new-case"));
  done(folder, {"run", "--help"});
  EXPECT_EQ(call(folder, {"help"}).out, help.out);
  EXPECT_EQ(call(folder, {"help", "run"}).out, call(folder, {"run", "--help"}).out);
}

TEST(Call, WrongCallsAreRefused) {
  const Folder folder;
  const std::string file = folder.file("case.toml", small_case);
  expect_refused(call(folder, {}), "no command given");
  expect_refused(call(folder, {"bogus"}), "bogus: unknown command");
  expect_refused(call(folder, {"rnu"}), "rnu: unknown command; did you mean run? ");
  expect_refused(call(folder, {""}), "");
  expect_refused(call(folder, {"--bogus"}), "do: rollfem --help");
  expect_refused(call(folder, {"check"}), "case is required");
  expect_refused(call(folder, {"check", file, "more"}), "more");
  expect_refused(call(folder, {"run"}), "no case file");
  expect_refused(call(folder, {"run", file, "--model", "fme"}),
                 "--model fme: no such model; did you mean fem? ");
  expect_refused(call(folder, {"run", file, "--model"}), "--model");
  expect_refused(call(folder, {"run", file, "--bogus"}), "--bogus");
  expect_refused(call(folder, {"run", file, "--modle=hertz"}), "did you mean --model?");
  expect_refused(call(folder, {"docs", "novel"}), "novel");
  expect_refused(call(folder, {"hlep"}), "did you mean help? ");
  expect_refused(call(folder, {"docs", "schem"}), "schem is not allowed; did you mean schema? ");
  expect_refused(call(folder, {"study", file, "--vary", "gird"}), "did you mean grid? ");
  expect_refused(call(folder, {"profile", "S1003"}), "did you mean S1002? ");
  expect_refused(call(folder, {"run", file, "--ouput", "x"}),
                 "--ouput: unknown option; did you mean --output? allowed: --help");
  EXPECT_TRUE(folder.made().empty());
}

TEST(HostileFile, IsRefusedByCheckAndRunAlike) {
  const Folder folder;
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
    expect_refused(call(folder, {"check", file}), part);
    expect_refused(call(folder, {"run", file}), part);
  }
  EXPECT_TRUE(folder.made().empty());
}

TEST(Output, ThatCannotBeWrittenIsAnError) {
  const Folder folder;
  const std::string command = std::string(ROLLFEM_PROGRAM) + " new-case > /dev/full";
  const Outcome outcome = execute(folder, {"sh", "-c", command});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(says(outcome.err, "cannot be written"));
}

}  // namespace
