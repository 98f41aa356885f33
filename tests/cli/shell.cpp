// SPDX-License-Identifier: LGPL-2.1-or-later
// The command line made easier: keys changed by --set, completion, the manual page.
#include <gtest/gtest.h>

#include "support/case_examples.hpp"
#include "support/program.hpp"

namespace {

using namespace rollfem::testing;

/// Bash's completions after these words, of which the last is incomplete.
std::string completed(const Folder& folder, const std::string& words) {
  const std::string script = folder.file("completion", call(folder, {"docs", "bash"}).out);
  return execute(folder, {"bash", "-c",
                          "source " + script + "; COMP_WORDS=(" + words +
                              "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _rollfem; echo "
                              "\"${COMPREPLY[@]}\""})
      .out;
}

TEST(Set, ChangesAKeyOfTheCaseThatIsSolvedAndStored) {
  const Folder folder;
  const std::string file = folder.file("case.toml", small_case);
  const Outcome checked = done(folder, {"check", file, "--set", "friction.coefficient=0.125"});
  EXPECT_TRUE(says(checked.out, "0.125"));
  const Outcome run =
      done(folder, {"run", "--set", "friction.coefficient=0.125", "--set", "title=changed", file,
                    "--model", "hertz", "--no-report", "-o", "out"});
  EXPECT_EQ(run.out.rfind("changed\n", 0), 0u);
  const std::string stored = folder.text("out/case.toml");
  EXPECT_TRUE(says(stored, "coefficient = 0.125"));
  done(folder, {"check", "out/case.toml"});
}

TEST(Set, IsRefusedWhereItNamesNoKey) {
  const Folder folder;
  const std::string file = folder.file("case.toml", small_case);
  expect_refused(call(folder, {"run", file, "--set", "friction.coeficient=0.1"}),
                 "did you mean `coefficient`?");
  expect_refused(call(folder, {"run", file, "--set", "friction"}), "expected KEY=VALUE");
}

TEST(Shell, BashCompletesCommandsOptionsAndModels) {
  const Folder folder;
  EXPECT_EQ(completed(folder, "rollfem st"), "study stress\n");
  EXPECT_EQ(completed(folder, "rollfem study --to"), "--together\n");
  EXPECT_EQ(completed(folder, "rollfem run --model fasts"), "fastsim\n");
  done(folder, {"new-case", "-o", "mine.toml"});
  EXPECT_EQ(completed(folder, "rollfem run mi"), "mine.toml\n");
  std::filesystem::copy_file(folder.work() / "mine.toml", folder.work() / "mine.inp");
  EXPECT_EQ(completed(folder, "rollfem convert mi"), "mine.inp\n");
}

TEST(Shell, ManualPageNamesEveryCommandAndOption) {
  const Folder folder;
  const std::string page = call(folder, {"docs", "man"}).out;
  EXPECT_TRUE(says(page, ".SS run", ".SS compare", ".SS study", ".SS stress", ".SS mesh",
                   ".SS profile", ".SS check", ".SS docs", "\\-\\-resume", "EXIT STATUS"));
}

}  // namespace
