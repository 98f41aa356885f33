// SPDX-License-Identifier: LGPL-2.1-or-later
// Valid TOML 1.0 is read, with non-ASCII letters where allowed; invalid text is refused at the
// place of the error in one message and never ends the program.
#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"

#include "support/case_examples.hpp"
#include <algorithm>
#include <cctype>

namespace {

struct Text {
  const char* name;
  std::string text;
};

void PrintTo(const Text& of, std::ostream* stream) {
  *stream << of.name;
}

class ValidText : public ::testing::TestWithParam<Text> {};

/// None of them is a case file: refused for an unknown or a missing key.
TEST_P(ValidText, IsRead) {
  EXPECT_FALSE(says(error_of(GetParam().text), "not valid TOML"));
}

INSTANTIATE_TEST_SUITE_P(
    Grammar, ValidText,
    ::testing::Values(
        Text{"Empty", ""}, Text{"EmptyLine", "\n"}, Text{"OnlyAComment", "# only a comment"},
        Text{"ByteOrderMark",
             "\xEF\xBB\xBF"
             "a = 1"},
        Text{"LinesOfWindows", "a = 1\r\n\r\nb = 2\r\n"},
        Text{"CommentsBeyondAscii",
             "# r\xC3\xA9sum\xC3\xA9 \xE2\x80\xA8 \xC2\x85 \xF0\x9F\x9A\x83\nt = \"\xC2\xB5 = "
             "0.3\""},
        Text{"KeysInQuotes", "\"\xC3\xA9\" = 1\n'\xC2\xB5' . \"b c\".d-e_5 = 2"},
        Text{"Tables", "a.b.c = 1\n[ x . y ]\n[[z]] # end\n[[z]]"},
        Text{"Lists", "a = [1, 2,\n # comment ]\n 3,\n]\nb = []\nc = [ [ ], [\"]\"], {d = 1} ]"},
        Text{"InlineTables", "p = {x = 1, y.z = [2, 3], \"w\" = {}}"},
        Text{"EmptyInlineTable", "q = { }"},
        Text{"DatesAndTimes",
             "d = 1979-05-27 07:32:00.5Z\ne = 07:32:00\nf = 1979-05-27 # day\ng = "
             "1979-05-27T00:32:00-07:00"},
        Text{"Numbers", "h = 0xDEAD_BEEF\ni = -1_000.5e-3\nj = +inf\nk = -nan\nl = true"},
        Text{"Escapes",
             "m = \"\\b\\t\\n\\f\\r\\\"\\\\ \\u00b5 \\U0001F683\"\nn = 'C:\\x'\no = \"\"\np = ''"},
        Text{"LongTexts",
             "q = \"\"\"\nfirst \"two\"\" \\\n  \n  goes on\"\"\"\"\"\nr = '''a\r\n'b''c'''''"},
        Text{"Tabs", "s = \"tab\there\"\n\t[\tt\t]\t"},
        Text{"LettersAfterALineEnd", "a = \"\"\"b\\\n\xC3\xA9\"\"\""}),
    [](const auto& test) { return std::string(test.param.name); });

struct Fault {
  std::string text, expected;
};

void PrintTo(const Fault& fault, std::ostream* stream) {
  *stream << fault.expected;
}

class WrongText : public ::testing::TestWithParam<Fault> {};

TEST_P(WrongText, IsRefusedWhereItDeparts) {
  const std::string place = GetParam().expected.substr(0, GetParam().expected.find(' ') + 1);
  expect_error(GetParam().text, {"case.toml:" + place + "not valid TOML in `",
                                 GetParam().expected.substr(place.size())});
}

/// "3_1_7__expected_a_number__true_or_false"
std::string name_of(const ::testing::TestParamInfo<Fault>& test) {
  std::string name = std::to_string(test.index) + '_' + test.param.expected;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(
    Grammar, WrongText,
    ::testing::Values(
        // All of these make toml++ 3.3 abort by its asserts.
        Fault{"[#", "1:2: expected a key"}, Fault{"a = 1\n[[ # b", "2:4: expected a key"},
        Fault{"[\x07",
              "1:2: expected a key, of the letters A to Z and a to z, digits, '_' and '-', "
              "found '\\u0007'"},
        Fault{"m=[\"\",}", "1:7: expected a number, true or false, a list in brackets"},
        Fault{"s=[\xC2\x85", "1:4: expected a number, true or false, a list in brackets"},
        Fault{"[.a]", "1:2: expected a key"}, Fault{"[", "1:2: expected a key"},
        // And these lead it to undefined behaviour.
        Fault{"\xC3\xA9 = 1", "1:1: expected a key"},
        Fault{"\n\xC2\xB5 = 0.3", "2:1: expected a key"},
        Fault{
            "a = 1\xC2\xB5",
            "1:6: expected a digit or the end of the number, found a character that is not ASCII"},
        Fault{"a = 1979-02-01 2", "1:5: expected a number, true or false"},
        // The rest of the grammar.
        Fault{"a", "1:2: expected '=' after a key, found the end of the line"},
        Fault{"a =", "1:4: expected a value, found the end of the line"},
        Fault{"a =\nb = 2", "1:4: expected a value, found the end of the line"},
        Fault{"a = 1 b = 2", "1:7: expected the end of the line or a comment, found 'b'"},
        Fault{"a = 1\rb = 2", "1:7: key-value pair: expected '\\n' after '\\r', saw 'b'"},
        Fault{"a\xC2\xA0= 1", "1:2: key: expected space or tab, saw '\\u00A0'"},
        Fault{"\xC2\xA0", "1:1: root table: expected space or tab"},
        Fault{"t = \"\xC3\xA9\" x", "1:9: expected the end of the line"},
        Fault{"a. = 1", "1:4: expected a key"}, Fault{"a..b = 1", "1:3: expected a key"},
        Fault{"\"\"\"a\"\"\" = 1", "1:1: key: multi-line strings are prohibited in keys"},
        Fault{"[a", "1:3: expected ']'"}, Fault{"[[a]", "1:5: expected ']'"},
        Fault{"[[a] ]", "1:5: expected ']'"},
        Fault{"[ [a]]", "1:3: table header: [[array-of-table]] brackets"},
        Fault{"[a] b = 1", "1:5: expected the end of the line"},
        Fault{"a = [1 2]", "1:8: expected ',' or ']'"}, Fault{"a = [,1]", "1:6: expected a value"},
        Fault{"a = [1", "1:8: expected ',' or ']'"},
        Fault{"a = {b = 1,}", "1:12: inline table: expected key-value pair"},
        Fault{"a = {b = 1\n}", "1:11: expected ',' or '}'"},
        Fault{"a = {", "1:6: expected ',' or '}'"},
        Fault{"a = \"b\nc\"", "1:7: expected the closing quotation mark"},
        Fault{"a = 'b", "1:7: expected the closing quotation mark"},
        Fault{"a = \"\"\"b\"\"", "1:12: expected the three closing"},
        Fault{"a = '''", "1:9: expected the three closing"},
        Fault{"a = \"C:\\data\"", "1:9: unknown escape after a backslash"},
        Fault{"a = \"\\u12\"", "1:10: \\u and \\U need 4 and 8 hexadecimal digits"},
        Fault{"a = \"\\ud800\"", "1:12: \\u and \\U need 4 and 8 hexadecimal digits"},
        Fault{"a = \"\\U00110000\"", "1:16: \\u and \\U need 4 and 8 hexadecimal digits"},
        Fault{"a = \"\"\"b\\ c\"\"\"", "1:11: unknown escape after a backslash"},
        Fault{"a = \"\x1B[0m\"", "1:6: control characters are not allowed in texts"},
        Fault{"# \x07", "1:3: control characters are not allowed in texts and comments"},
        Fault{"# Latin-1: \xE9", "1:12: the file is not UTF-8: found byte 0xE9"},
        Fault{"# overlong: \xC0\xAF", "1:13: the file is not UTF-8"},
        Fault{"# surrogate: \xED\xA0\x80", "1:14: the file is not UTF-8"},
        Fault{"# cut off: \xE2\x82", "1:12: the file is not UTF-8"},
        Fault{"a = " + std::string(70, '[') + std::string(70, ']'), "1:70: nested more than 64"},
        Fault{"a" + std::string(200, '.'), "1:3: expected a key"},
        // Common typing errors.
        Fault{"model = hertz",
              "1:9: expected a number, true or false, a list in brackets, or a "
              "string in straight quotes"},
        Fault{"model = fem", "1:10: expected a number, true or false"},
        Fault{"a = \xE2\x80\x9Chertz\xE2\x80\x9D", "1:5: expected a number, true or false"},
        Fault{"a = 1,5", "1:6: expected the end of the line or a comment, found ','"},
        Fault{"a = .5", "1:5: expected a digit (0.5, not .5; 5.0, not 5.), found '.'"},
        Fault{"a = 5.", "1:7: expected a digit (0.5, not .5; 5.0, not 5.), found the end of"},
        Fault{"a = 1/40", "1:6: expected a digit or the end of the number, found '/'"},
        Fault{"a = 1e400", "1:10: floating-point: '1e400' could not"},
        Fault{"a = 1\na = 2", "2:5: key-value pair: cannot redefine existing integer 'a'"},
        Fault{"a = []\n[a.b]\n", "2:7: table header: cannot redefine existing array"}),
    name_of);

TEST(Toml, DottedKeysNestNoDeeperThanLists) {
  std::string key = "a";
  for (int k = 0; k < 63; ++k) key += ".a";
  expect_error(key + " = 1", {"case.toml:1:1: a: is not a key"});
  expect_error("[" + key + ".a]", {"case.toml:1:130: not valid TOML", "nested more than 64 deep"});
  // Whatever stands before it in quotes or in a comment.
  for (const std::string before :
       {"", "x = '''\n'a''''\n", "x = \"\\\"\" # '\n", "'=\"'.x = 1\n", "x = \"\"\"\\\"\"\"\"\n"}) {
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    expect_error(before + key + ".a = 1", {"case.toml:" + std::to_string(line) + ":129: not valid",
                                           "nested more than 64 deep"});
  }
  const std::string dots(150, '.');
  EXPECT_EQ(error_of("title = \"" + dots + "\" # " + dots + "\n" + small_case), "");
}

TEST(Toml, ListsThatAreNeverClosedDoNotEndTheProgram) {
  std::string text = "a = ";
  for (int k = 0; k < 100; ++k) text += std::string(9000, '[') + '\n';
  expect_error(text, {"case.toml:1:70: not valid TOML", "nested more than 64 deep"});
}

TEST(Toml, ACaseMayHaveLettersBeyondAsciiInTextsAndComments) {
  const contact::Case input = contact::parse_case(
      "# \xC2\xB5 = friction\ntitle = \"\xC3\x9C"
      "bergang, \xC2\xB5 = 0.3\"\n" +
          rollfem::testing::small_case,
      "case.toml");
  EXPECT_EQ(input.title,
            "\xC3\x9C"
            "bergang, \xC2\xB5 = 0.3");
}

TEST(Toml, WhatKeysInQuotesHoldDoesNotReachTheTerminal) {
  const std::string text = error_of("\"\\u001b[2J\\n\" = 1\n" + small_case);
  EXPECT_EQ(text.rfind("case.toml:1:1: ?[2J?: is not a key", 0), 0u) << text;
}

TEST(Toml, WhatTheParserQuotesDoesNotEndTheLineOfTheMessage) {
  const std::string text = error_of("a = i\n");
  EXPECT_NE(text, "");
  EXPECT_FALSE(says(text, "\n"));
}

}  // namespace
