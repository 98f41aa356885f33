// SPDX-License-Identifier: LGPL-2.1-or-later
// The text of a case file in another folder, and the files that a case reads. Keys changed in the
// text: tests/cli/test_cases.py.
#include "case/reading/case_reader.hpp"

#include "support/temporary_folder.hpp"

TEST(TextInFolder, PathsLeadFromThere) {
  const TemporaryFolder folder;
  std::string points;
  for (int k = 0; k < 16; ++k)
    points +=
        std::to_string(k % 4) + " " + std::to_string(k / 4) + " 0." + std::to_string(k) + "\n";
  folder.file("mine/points.csv", points);
  const std::string head = "[load]\nnormal_force = 1.0\n[friction]\ncoefficient = 0.3\n";
  const Case given = read_case(folder.file(
      "mine/case.toml", head + "[undeformed_distance]\nfile = \"points.csv\"  # measured\n"));
  const std::string moved = text_in_folder(given, folder.path("out/deep"));
  EXPECT_TRUE(says(moved, "file = \"../../mine/points.csv\"  # measured"));
  const Case again = read_case(folder.file("out/deep/case.toml", moved));
  EXPECT_EQ(again.undeformed_distance.values->values, given.undeformed_distance.values->values);
  EXPECT_EQ(text_in_folder(given, folder.path("mine")), given.text);
  // Built-in profiles are no files.
  const std::string profiles =
      "[wheel]\nrolling_radius = 460.0\nprofile = \"S1002\"\n[rail]\nprofile = "
      "\"worn/rail.csv\"\n[track]\ninclination = \"1:40\"\n";
  const Case pair =
      parse_case("[load]\nvertical_force = 1e5\n[friction]\ncoefficient = 0.3\n" + profiles,
                 folder.path("mine/pair.toml"));
  EXPECT_TRUE(
      says(text_in_folder(pair, folder.path("out")), "\"S1002\"", "\"../mine/worn/rail.csv\""));
}

TEST(FilesReadBy, ACaseAreThoseOfItsKeysAndOfListsAmongThem) {
  const TemporaryFolder folder;
  // A list that names itself, and one that names another list, end too.
  folder.file("rail.sections",
              "0 a.csv 1.0 -  # comment\n100, 'deep/b.csv' 2 3\n200 rail.sections\n");
  folder.file("deep/wheel.slcw", "0 1\n2\n0 0 0\n1\n0 'c.prw'\n90 missing.prw\n");
  for (const char* file : {"a.csv", "deep/b.csv", "deep/c.prw", "wheel.msh", "rail.csv", "s.csv"})
    folder.file(file, "1 2\n");
  Case input;
  input.file = folder.path("case.toml");
  input.wheel.profile.name = "deep/wheel.slcw";
  input.rail.profile.name = "rail.sections";
  input.wheel.mesh = "wheel.msh";
  input.wheel.plasticity.emplace().residual.file = "s.csv";
  input.undeformed_distance.values.emplace().file = "rail.csv";
  input.rolling.extra_slip_values.emplace().file = "deep/../a.csv";
  std::vector<std::string> expected;
  for (const char* file : {"deep/wheel.slcw", "deep/c.prw", "wheel.msh", "rail.sections", "a.csv",
                           "deep/b.csv", "s.csv", "rail.csv"})
    expected.push_back(folder.path(file));
  std::vector<std::string> found = files_read_by(input);
  std::sort(found.begin(), found.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(found, expected);
  input.wheel.profile.name = "S1002";
  input.rail.profile.name = "missing.csv";
  EXPECT_EQ(files_read_by(input).size(), 4U);
}
