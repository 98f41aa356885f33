// SPDX-License-Identifier: LGPL-2.1-or-later
// Keys of a case file changed in its text: the edited text reads as requested.
#include "base/errors.hpp"
#include "case/reading/case_reader.hpp"

#include "support/temporary_folder.hpp"

namespace {

const std::string text = R"(title = "a wheel"   # told

[load]
normal_force = 50e3  # N

[wheel]
rolling_radius = 460.0
transverse_radius = inf
[rail]
transverse_radius = 300.0

[rolling]
longitudinal_creepage = [
  0.0,  # none
  0.001,
]
[friction]
coefficient = 0.3)";

std::string changed(const std::vector<std::string>& changes, const std::string& from = text) {
  return with_changes(from, "case.toml", changes);
}

std::string refused(const std::string& change, const std::string& from = text) {
  return refusal<InputError>([&] { changed({change}, from); });
}

}  // namespace

TEST(CaseEdit, ReplacesAValueAndNothingElse) {
  std::string expected = text + "\n";
  expected.replace(expected.find("50e3"), 4, "80e3");
  EXPECT_EQ(changed({"load.normal_force=80e3"}), expected);
  const Case read = parse_case(changed({" load.normal_force = 7.5e4 "}), "case.toml");
  EXPECT_EQ(read.load.normal_force, 7.5e4);
}

TEST(CaseEdit, ReplacesTextsAndListsOverManyLines) {
  const Case read = parse_case(
      changed({"title=worn", "rolling.longitudinal_creepage=[0.002]", "friction.coefficient=0.25"}),
      "case.toml");
  EXPECT_EQ(read.title, "worn");
  ASSERT_EQ(read.rolling.creepages.size(), 1u);
  EXPECT_EQ(read.rolling.creepages[0].longitudinal, 0.002);
  EXPECT_EQ(parse_case(changed({"title='one word, or two'"}), "case.toml").title,
            "one word, or two");
}

TEST(CaseEdit, WhereAKeyWantsTextItNeedsNoQuotes) {
  const auto with = [](const std::string& change) { return changed({change}); };
  EXPECT_NE(with("rail.profile=60E1").find("profile = \"60E1\""), std::string::npos);
  EXPECT_NE(with("track.inclination=1:40").find("inclination = \"1:40\""), std::string::npos);
  EXPECT_NE(with("track.inclination=0.025").find("inclination = 0.025"), std::string::npos);
  EXPECT_NE(with("title=\"60 E1\"").find("title = \"60 E1\""), std::string::npos);
}

TEST(CaseEdit, AddsKeysAndSections) {
  const Case read = parse_case(
      changed({"wheel.round_to=0.5", "accuracy=0.01", "output.fields=false"}), "case.toml");
  EXPECT_EQ(read.wheel.round_to, 0.5);
  EXPECT_FALSE(read.output.fields);
  EXPECT_EQ(read.accuracy, 0.01);
}

TEST(CaseEdit, AddsToSectionsWrittenWithDots) {
  const std::string dotted = "friction.coefficient = 0.3\nload.normal_force = 1e4\n";
  EXPECT_EQ(changed({"load.approach=0.1"}, dotted),
            "friction.coefficient = 0.3\nload.approach = 0.1\nload.normal_force = 1e4\n");
  EXPECT_TRUE(says(refused("load.approach=0.1", "load = {normal_force = 1e4}\n"),
                   "case.toml:1: load: the section is an inline table"));
}

TEST(CaseEdit, NamesTheErrorOfACall) {
  EXPECT_EQ(refused("friction.coefficient").find("--set friction.coefficient: expected KEY=VALUE"),
            0u);
  EXPECT_EQ(refused("friction.coefficent=0.3")
                .find("--set friction.coefficent=0.3: friction.coefficent is not a key"),
            0u);
  EXPECT_TRUE(says(refused("friction.coefficent=0.3"), "did you mean `coefficient`?"));
  EXPECT_EQ(refused("friction.coefficient=much")
                .find("--set friction.coefficient=much: expected a number"),
            0u);
  EXPECT_EQ(
      refused("friction.coefficient=-1").find("--set friction.coefficient=-1: is out of bounds"),
      0u);
  EXPECT_EQ(
      refused("friction.coefficient=").find("--set friction.coefficient=: the value is missing"),
      0u);
  EXPECT_EQ(
      refused("friction.coefficient=[").find("--set friction.coefficient=[: not a value in TOML"),
      0u);
  EXPECT_TRUE(says(refused("width=2"), "do: write geometry.width or fem.width"));
  EXPECT_TRUE(says(refused("subsurface.line.points=3"), "do: change it in the case file"));
  EXPECT_EQ(refused("title=\"a\"\n[load]"), refused("title=\x7f"));
  EXPECT_EQ(refused("load.normal_force=1", "x = \n").find("case.toml:1"), 0u);
}

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
