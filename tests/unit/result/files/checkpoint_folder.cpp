// SPDX-License-Identifier: LGPL-2.1-or-later
// Records are of one case and of all files that it reads.
#include "result/files/checkpoint_folder.hpp"

#include "base/errors.hpp"

#include "support/temporary_folder.hpp"
#include "support/test.hpp"

namespace rollfem::result {
namespace {

TEST(CheckpointFolder, RecordsAreStaleOnceAFileThatAListNamesHasChanged) {
  const rollfem::testing::TemporaryFolder folder;
  contact::Case input;
  input.file = folder.path("case.toml");
  input.text = "the case";
  for (const char* list : {"rail.sections", "rail.slcs"}) {
    folder.file(list, "0 section/a.csv\n100 section/b.csv\n");
    input.rail.profile.name = list;
    folder.file("section/a.csv", "0 0\n1 0\n");
    folder.file("section/b.csv", "0 0\n1 0\n");
    const auto opened = [&](bool resume) {
      return CheckpointFolder(folder.path("out"), input, "program", resume, [](auto&) {});
    };
    EXPECT_TRUE(opened(false).mark("point"));
    EXPECT_EQ(opened(true).found(), 1) << list;
    EXPECT_TRUE(opened(true).find("point"));
    folder.file("section/b.csv", "0 0\n1 0.001\n");
    EXPECT_TRUE(
        says(refusal<contact::InputError>([&] { opened(true); }), "(or a file that it names) has"))
        << list;
    remove_records(folder.path("out"));
  }
}

}  // namespace
}  // namespace rollfem::result
