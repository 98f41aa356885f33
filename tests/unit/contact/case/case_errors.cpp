// SPDX-License-Identifier: LGPL-2.1-or-later
// Every error in a case file gives one message with file, line, key, value, allowed values and
// advice; none crashes.
#include "contact/base/errors.hpp"
#include "contact/base/text_fields.hpp"
#include "contact/case/case_reader.hpp"
#include "contact/case/case_text.hpp"

#include "support/case_examples.hpp"
#include "support/temporary_folder.hpp"

namespace {

std::string file_error(const std::string& path) {
  return refusal<contact::InputError>([&] { contact::read_case(path); });
}

struct Wrong {
  std::string name;
  std::string text;
  std::vector<std::string> parts;  ///< what the message must contain
};

void PrintTo(const Wrong& wrong, std::ostream* stream) {
  *stream << wrong.name;
}

class WrongCase : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongCase, GivesOneMessageWithAllItsParts) {
  expect_error(GetParam().text, GetParam().parts);
}

std::string rolling(const std::string& lines) {
  return plus("[rolling]\n" + lines + "\n");
}
std::string grid(const std::string& lines) {
  return plus("[contact_grid]\n" + lines + "\n");
}
std::string fem(const std::string& lines) {
  return plus("[fem]\n" + lines + "\n");
}
std::string first(const std::string& line) {
  return line + "\n" + small_case;
}

const std::vector<Wrong> wrong_values{
    {"NegativeFriction",
     with("0.55", "-0.1"),
     {"case.toml:4:15: friction.coefficient = -0.1: is out of bounds",
      "allowed: a number or a list of numbers from 1e-12 to 1000, or 0"}},
    {"FrictionThatIsNone",
     with("0.55", "1e-300"),
     {"case.toml:4:15: friction.coefficient = 1e-300: is out of bounds",
      "allowed: a number or a list of numbers from 1e-12 to 1000, or 0"}},
    {"NotANumber", with("50e3", "nan"), {"case.toml:2:16: load.normal_force = nan", "allowed: "}},
    {"InfiniteForce", with("50e3", "inf"), {"load.normal_force = inf", "infinite"}},
    {"MinusInfiniteRadius", with("= inf", "= -inf"), {"wheel.transverse_radius = -inf"}},
    {"TooBigForTheMachine", with("50e3", "1e400"), {"case.toml:2:", "normal_force = 1e400"}},
    {"TooSmallForTheMachine", with("50e3", "1e-320"), {"normal_force = 1e-320"}},
    {"AccuracyOutOfBounds",
     with("[load]", "accuracy = 7.0\n[load]"),
     {"accuracy = 7.0: is out of bounds", "for instance `accuracy = 0.25`"}},
    {"ZeroForce", with("50e3", "0"), {"load.normal_force = 0: is out of bounds"}},
    {"UnknownFarBoundary",
     fem("far_boundary = \"free\""),
     {"case.toml:11:16: fem.far_boundary = \"free\"", "one of clamped, point_load"}},
    {"PointLoadBoundaryOfAGivenMesh",
     with("[rail]", "[fem]\nfar_boundary = \"point_load\"\n[rail]\nmesh = \"rail.msh\""),
     {"fem.far_boundary = \"point_load\": applies to segments meshed by rollfem, but this case "
      "provides a mesh",
      "allowed: \"clamped\"", "remove fem.far_boundary"}},
    {"NegativeForce", with("50e3", "-50e3"), {"load.normal_force = -50e3: is out of bounds"}},
    {"NegativeVerticalForce",
     with("normal_force = 50e3", "vertical_force = -80e3"),
     {"load.vertical_force = -80e3: is out of bounds", "for instance `vertical_force = 80000`"}},
    {"ZeroRadius",
     with("2000.0", "0.0"),
     {"case.toml:9:21: rail.transverse_radius = 0.0: is out of bounds", "or inf"}},
    {"InfiniteRollingRadius", with("405.0", "inf"), {"wheel.rolling_radius = inf: is infinite"}},
    {"IncompressibleBody",
     with("[rail]", "[rail]\npoisson_ratio = 0.5"),
     {"rail.poisson_ratio = 0.5: is out of bounds", "from 0 to below 0.5"}},
    {"DensityInKilogramsPerCubicMetre",
     with("[rail]", "[rail]\ndensity = 7850.0"),
     {"rail.density = 7850.0: is out of bounds", "from 1e-15 to 1e-07 t/mm^3, or 0"}},
    {"FasterThanSurfaceWaves",
     plus("[rolling]\nspeed = 2.7e6\n[fem]\ninertia = true\n"),
     {"case.toml:11:9: rolling.speed = 2.7e6: is at or above 0.9 of the Rayleigh wave speed of the "
      "wheel, 2.9",
      "allowed: below 2.6", "density (t/mm^3)"}},
    {"SpeedThatOnlyTheSofterRailRefuses",
     with("[rail]", "[fem]\ninertia = true\n[rolling]\nspeed = 5e4\n[rail]\nyoung_modulus = 10.0"),
     {"rolling.speed = 5e4", "of the rail"}},
    {"InertiaAtRest",
     plus("[fem]\ninertia = true\n"),
     {"case.toml:11:11: fem.inertia = true: needs a rolling speed, and rolling.speed is 0; "
      "allowed: "
      "true with rolling.speed > 0; do: give `speed`"}},
    {"NegativeModulus",
     with("[rail]", "[rail]\nyoung_modulus = -1"),
     {"rail.young_modulus = -1: is out of bounds", "MPa"}},
    {"TextForNumber",
     with("405.0", "\"405\""),
     {"case.toml:6:18: wheel.rolling_radius = \"405\": expected a number, got a string", "mm"}},
    {"BooleanForNumber", with("405.0", "true"), {"wheel.rolling_radius = true"}},
    {"DateForNumber", with("405.0", "2024-01-01"), {"wheel.rolling_radius", "a date or time"}},
    {"ListForNumber",
     with("405.0", "[405.0]"),
     {"wheel.rolling_radius = [405.0]: expected a number, got a list"}},
    {"SectionForNumber", with("405.0", "{a = 1}"), {"wheel.rolling_radius", "a section"}},
    {"CreepageAboveOne",
     rolling("longitudinal_creepage = 1.5"),
     {"case.toml:11:25: rolling.longitudinal_creepage = 1.5", "from -1 to 1"}},
    {"BadEntryOfAList", rolling("spin = [0.0,\n  nan]"), {"case.toml:12:3: rolling.spin = nan"}},
    {"TextInAList",
     rolling("spin = [\"a\"]"),
     {"rolling.spin = \"a\": expected a number, got a string"}},
    {"ListInAList",
     rolling("spin = [[0.0]]"),
     {"rolling.spin = [0.0]: expected a number, got a list"}},
    {"EmptyList",
     rolling("lateral_creepage = []"),
     {"case.toml:11:20: rolling.lateral_creepage = []: is an empty list"}},
    {"UnknownWord",
     rolling("upwind_order = \"secnd\""),
     {"rolling.upwind_order = \"secnd\": is not known (near: second)", "one of first, second"}},
    {"NumberForWord",
     rolling("upwind_order = 2"),
     {"rolling.upwind_order = 2: expected a string in quotes, got a whole number"}},
    {"TooFewElements", grid("elements_across = 3"), {"elements_across = 3", "from 4 to 2000"}},
    {"HalfAnElement",
     grid("elements_across = 40.5"),
     {"elements_across = 40.5", "expected a whole number"}},
    {"MoreThan64Bits", grid("elements_across = 99999999999999999999"), {"case.toml:11:", "9999"}},
    {"OneNumberForPair", grid("cell_size = 0.2"), {"contact_grid.cell_size = 0.2", "two numbers"}},
    {"ThreeNumbersForPair", grid("cell_size = [1, 2, 3]"), {"has 3 entries, not 2"}},
    {"NegativeCell", grid("cell_size = [0.2, -0.2]"), {"contact_grid.cell_size = -0.2"}},
    {"CubicElements", fem("degree = 3"), {"fem.degree = 3: is out of bounds", "from 1 to 2"}},
    {"UnknownSolver", fem("linear_solver = \"lu\""), {"automatic, factorisation, multigrid"}},
    {"TextForBoolean", plus("[output]\nfields = \"yes\"\n"), {"output.fields = \"yes\""}},
    {"UnknownPath", plus("[output]\npaths = [\"z\"]\n"), {"output.paths = [\"z\"]: is not known"}},
    {"UnknownModel",
     first("models = [\"fme\"]"),
     {"case.toml:1:10: models", "near: fem", "allowed: a list of some of hertz, halfspace, fem"}},
    {"ModelTwice", first("models = [\"fem\", \"fem\"]"), {"names fem twice"}},
    {"TextForModels", first("models = \"fem\""), {"models = \"fem\": expected a list"}},
    {"TitleWithControlCharacters", first("title = \"a\\u001b[31mb\""), {"control character"}},
    {"VeryLongTitle", first("title = \"" + std::string(300, 'x') + "\""), {"longer than 200"}},
};

const std::vector<Wrong> wrong_structure{
    {"UnknownKey",
     with("rolling_radius", "rolling_radios"),
     {"case.toml:6:1: wheel.rolling_radios: is not a key", "did you mean `rolling_radius`?",
      "allowed: rolling_radius, transverse_radius, round_to, young_modulus, poisson_ratio"}},
    {"UnknownSection",
     with("[friction]", "[frction]"),
     {"case.toml:3:2: frction: is not a key", "did you mean `friction`?"}},
    {"KeyInTheWrongSection",
     with("[friction]", "poisson_ratio = 0.3\n[friction]"),
     {"case.toml:3:1: load.poisson_ratio", "move it to [wheel]"}},
    {"KeyBeforeItsSection", first("normal_force = 1.0"), {"move it to [load]"}},
    {"NothingLikeIt", first("quux = 1"), {"case.toml:1:1: quux", "docs/case-file.md"}},
    {"ValueForASection", first("fem = 5"), {"case.toml:1:7: fem = 5: is a section, not a key"}},
    {"ListOfSections", with("[load]", "[[load]]"), {"case.toml:1:1: load", "is a section"}},
    {"NestedSection", plus("[fem.solver]\nname = 1\n"), {"fem.solver: is not a key"}},
    {"DuplicateKey",
     with("[friction]", "[friction]\ncoefficient = 0.3"),
     {"case.toml:5:", "cannot redefine", "coefficient"}},
    {"DuplicateSection", plus("[load]\n"), {"case.toml:10:", "load"}},
    {"NotToml", plus("this is no TOML\n"), {"case.toml:10:", "not valid TOML"}},
    {"OpenString", plus("title = \"open\n"), {"case.toml:10:", "not valid TOML"}},
    {"NotUtf8",
     first("title = \"\xff\xfe\""),
     {"case.toml:1:10: ", "the file is not UTF-8: found byte 0xFF"}},
    {"Binary",
     std::string("\x7f"
                 "ELF\0\0\1",
                 7),
     {"case.toml: is a binary file"}},
    {"Empty", "", {"case.toml: is empty"}},
    {"OnlyBlanks", " \r\n\t\n", {"case.toml: is empty"}},
    {"OnlyAComment", "# nothing\n", {"load.normal_force: is missing, and load.approach too"}},
    {"ForceAndApproach",
     with("[friction]", "approach = 0.05\n[friction]"),
     {"case.toml:3:12: load.approach = 0.05: contradicts load.normal_force = 50e3 of line 2",
      "exactly one"}},
    {"NeitherForceNorApproach",
     with("normal_force = 50e3\n", ""),
     {"case.toml:1:1: load.normal_force: is missing", "exactly one"}},
    {"NoFriction",
     with("coefficient = 0.55\n", ""),
     {"case.toml:3:1: friction.coefficient: is missing", "add `coefficient = 0.55` under"}},
    {"NoRollingRadius", with("rolling_radius = 405.0\n", ""), {"wheel.rolling_radius: is missing"}},
    {"NoRail",
     with("[rail]\ntransverse_radius = 2000.0\n", ""),
     {"case.toml: rail.transverse_radius: is missing"}},
    {"TwoGridSizes",
     grid("elements_across = 40\ncell_size = [0.2, 0.2]"),
     {"case.toml:12:13: contact_grid.cell_size = [0.2, 0.2]: contradicts", "of line 11"}},
    {"ListsOfDifferentLength",
     rolling("longitudinal_creepage = [0, 0.1]\nspin = [0, 0, 0]"),
     {"rolling.spin = [0, 0, 0]: has 3 entries, but rolling.longitudinal_creepage of line 11 has "
      "2"}},
    {"TooManyLoadPoints",
     rolling([] {
       std::string list = "spin = [\n";
       for (int i = 0; i < 1001; ++i) list += "0,\n";
       return list + "]";
     }()),
     {"rolling.spin", "more than 1000 entries"}},
    {"VeryDeepKey",
     [] {
       std::string text;
       for (int i = 0; i < 100000; ++i) text += "a.";
       return text + "a = 1\n";
     }(),
     {"case.toml:1: the line is longer than"}},
    {"VeryDeepList",
     "a = " + std::string(9000, '['),
     {"case.toml:1:70: ", "nested more than 64 deep"}},
    {"LargerThanACase", std::string((1 << 20) + 1, '#'), {"larger than 1 MB"}},
};

const std::vector<Wrong> wrong_geometry{
    {"FlatOnFlat",
     with("2000.0", "inf"),
     {"case.toml:7:21: wheel.transverse_radius = inf", "line contact"}},
    {"ConcaveWheelOfTheRailsRadius",
     with("= inf", "= -2000"),
     {"wheel.transverse_radius = -2000: concave", "2000 mm", "below -2000 mm"}},
    {"ConcaveWheelSharperThanTheRail", with("= inf", "= -105"), {"below -2000 mm"}},
    {"ConcaveRailSharperThanTheWheel",
     "[load]\nnormal_force=1\n[friction]\ncoefficient=0.3\n[wheel]\nrolling_radius=405\n"
     "transverse_radius=300\n[rail]\ntransverse_radius=-200\n",
     {"wheel.transverse_radius = 300: convex", "from 0 to below 200 mm"}},
    {"FlatWheelInAConcaveRail", with("2000.0", "-2000.0"), {"leaves no convex body"}},
    {"FlatRailInAConcaveWheel",
     "[load]\nnormal_force=1\n[friction]\ncoefficient=0.3\n[wheel]\nrolling_radius=405\n"
     "transverse_radius=-300\n[rail]\ntransverse_radius=inf\n",
     {"wheel.transverse_radius = -300", "leaves no convex body"}},
    {"RadiiThatCancelToRounding", with("= inf", "= -2000.0000001"), {"below -2000 mm"}},
    {"ApproachAsLargeAsTheWheel",
     with("normal_force = 50e3", "approach = 300.0"),
     {"load.approach = 300.0: is not small", "less than 40.5 mm"}},
};

std::string name_of(const ::testing::TestParamInfo<Wrong>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Values, WrongCase, ::testing::ValuesIn(wrong_values), name_of);
INSTANTIATE_TEST_SUITE_P(Structure, WrongCase, ::testing::ValuesIn(wrong_structure), name_of);
INSTANTIATE_TEST_SUITE_P(Geometry, WrongCase, ::testing::ValuesIn(wrong_geometry), name_of);

TEST(CaseFile, MissingFileFolderAndDeviceAreRefused) {
  EXPECT_TRUE(says(file_error("/nowhere/case.toml"), "/nowhere/case.toml: there is no such file"));
  EXPECT_TRUE(says(file_error("/"), "/: is a folder"));
  EXPECT_TRUE(says(file_error("/dev/zero"), "is not a regular file"));
  EXPECT_TRUE(says(file_error(""), "there is no such file"));
}

TEST(CaseFile, HugeFileIsRefusedWithoutReadingIt) {
  const TemporaryFolder folder;
  const std::string path = folder.file("huge.toml", "#");
  std::filesystem::resize_file(path, std::uintmax_t{1} << 40);  // sparse: takes no space
  const std::string message = file_error(path);
  EXPECT_TRUE(says(message, "larger than 1 MB"));
}

TEST(CaseText, MessagesCannotUpsetATerminal) {
  const std::string message = error_of(first("title = 'a\x1b[31m\x07'"));
  for (const char c : message) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << message;
}

TEST(CaseText, NearestNameIsOnlyGivenWhenItIsNear) {
  const std::vector<std::string> names{"normal_force", "approach"};
  EXPECT_EQ(contact::nearest_name("normalforce", names), "normal_force");
  EXPECT_EQ(contact::nearest_name("force", names), "normal_force");
  EXPECT_EQ(contact::nearest_name("aproach", names), "approach");
  EXPECT_EQ(contact::nearest_name("quux", names), "");
  EXPECT_EQ(contact::nearest_name(std::string(100000, 'a'), names), "");
}

}  // namespace
