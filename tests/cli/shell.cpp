// SPDX-License-Identifier: LGPL-2.1-or-later
// The command line made easier: keys changed by --set, completion, the manual page.
#include "support/case_examples.hpp"
#include "support/program.hpp"

namespace {

/// Bash's completions after these words, of which the last is incomplete.
std::string completed(const Folder& folder, const std::string& words) {
  const std::string script = folder.file("completion", folder.call({"docs", "bash"}).out);
  return folder
      .execute({"bash", "-c",
                "source " + script + "; COMP_WORDS=(" + words +
                    "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _rollfem; echo "
                    "\"${COMPREPLY[@]}\""})
      .out;
}

using Set = ProgramTest;

TEST_F(Set, ChangesAKeyOfTheCaseThatIsSolvedAndStored) {
  const std::string file = folder.file("case.toml", small_case);
  const Outcome checked = done({"check", file, "--set", "friction.coefficient=0.125"});
  EXPECT_TRUE(says(checked.out, "0.125"));
  const Outcome run = done({"run", "--set", "friction.coefficient=0.125", "--set", "title=changed",
                            file, "--model", "hertz", "--no-report", "-o", "out"});
  EXPECT_EQ(run.out.rfind("changed\n", 0), 0u);
  const std::string stored = folder.text("out/case.toml");
  EXPECT_TRUE(says(stored, "coefficient = 0.125"));
  done({"check", "out/case.toml"});
}

TEST_F(Set, IsRefusedWhereItNamesNoKey) {
  const std::string file = folder.file("case.toml", small_case);
  refuses({"run", file, "--set", "friction.coeficient=0.1"}, "did you mean `coefficient`?");
  refuses({"run", file, "--set", "friction"}, "expected KEY=VALUE");
}

using Shell = ProgramTest;

TEST_F(Shell, BashCompletesCommandsOptionsAndModels) {
  EXPECT_EQ(completed(folder, "rollfem st"), "study stress\n");
  EXPECT_EQ(completed(folder, "rollfem study --to"), "--together\n");
  EXPECT_EQ(completed(folder, "rollfem run --model fasts"), "fastsim\n");
  done({"new-case", "-o", "mine.toml"});
  EXPECT_EQ(completed(folder, "rollfem run mi"), "mine.toml\n");
  std::filesystem::copy_file(folder.work() / "mine.toml", folder.work() / "mine.inp");
  EXPECT_EQ(completed(folder, "rollfem convert mi"), "mine.inp\n");
}

TEST_F(Shell, ManualPageNamesEveryCommandAndOption) {
  const std::string page = call({"docs", "man"}).out;
  EXPECT_TRUE(says(page, ".SS run", ".SS compare", ".SS study", ".SS stress", ".SS mesh",
                   ".SS profile", ".SS check", ".SS docs", "\\-\\-resume", "EXIT STATUS"));
}

}  // namespace
