// What is TOML 1.0 passes, with letters beyond ASCII where it allows them; what is not is refused
// where it departs, before toml++ sees it.
#include "contact/case/toml/toml_syntax.hpp"

#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"

#include <gtest/gtest.h>

#include "support/case_examples.hpp"

namespace {

using namespace rollfem;
using contact::find_toml_fault;
using rollfem::testing::error_of;
using rollfem::testing::says;
using rollfem::testing::small_case;

std::string shown(const std::optional<contact::TomlFault>& fault) {
  return fault ? std::to_string(fault->line) + ":" + std::to_string(fault->column) + ": " +
                     fault->wrong
               : "none";
}

class Valid : public ::testing::TestWithParam<std::string> {};

TEST_P(Valid, HasNoFault) {
  EXPECT_EQ(shown(find_toml_fault(GetParam())), "none");
}

INSTANTIATE_TEST_SUITE_P(
    Toml, Valid,
    ::testing::Values(
        "", "\n", "# only a comment",
        "\xEF\xBB\xBF"
        "a = 1",
        "a = 1\r\n\r\nb = 2\r\n",
        "# r\xC3\xA9sum\xC3\xA9 \xE2\x80\xA8 \xC2\x85 \xF0\x9F\x9A\x83\nt = \"\xC2\xB5 = 0.3\"",
        "\"\xC3\xA9\" = 1\n'\xC2\xB5' . \"b c\".d-e_5 = 2",
        "a.b.c = 1\n[ x . y ]\n[[z]] # end\n[[z]]",
        "a = [1, 2,\n # comment ]\n 3,\n]\nb = []\nc = [ [ ], [\"]\"], {d = 1} ]",
        "p = {x = 1, y.z = [2, 3], \"w\" = {}}", "q = { }",
        "d = 1979-05-27 07:32:00.5Z\ne = 07:32:00\nf = 1979-05-27 # day\ng = "
        "1979-05-27T00:32:00-07:00",
        "h = 0xDEAD_BEEF\ni = -1_000.5e-3\nj = +inf\nk = -nan\nl = true",
        "m = \"\\b\\t\\n\\f\\r\\\"\\\\ \\u00b5 \\U0001F683\"\nn = 'C:\\x'\no = \"\"\np = ''",
        "q = \"\"\"\nfirst \"two\"\" \\\n  \n  goes on\"\"\"\"\"\nr = '''a\r\n'b''c'''''",
        "s = \"tab\there\"\n\t[\tt\t]\t"));

struct Fault {
  std::string text, expected;
};

void PrintTo(const Fault& fault, std::ostream* stream) {
  *stream << fault.expected;
}

class Invalid : public ::testing::TestWithParam<Fault> {};

TEST_P(Invalid, IsRefusedWhereItDeparts) {
  EXPECT_EQ(shown(find_toml_fault(GetParam().text)).rfind(GetParam().expected, 0), 0u)
      << shown(find_toml_fault(GetParam().text));
}

INSTANTIATE_TEST_SUITE_P(
    Toml, Invalid,
    ::testing::Values(
        // All of these made toml++ 3.3 abort.
        Fault{"[#", "1:2: expected a key"}, Fault{"a = 1\n[[ # b", "2:4: expected a key"},
        Fault{"[\x07",
              "1:2: expected a key, of the letters A to Z and a to z, digits, '_' and '-', "
              "found U+0007"},
        Fault{"m=[\"\",}", "1:7: expected a value, found '}'"},
        Fault{"s=[\xC2\x85", "1:4: expected a value, found U+0085"},
        Fault{"[.a]", "1:2: expected a key"}, Fault{"[", "1:2: expected a key"},
        // And these led it to undefined behaviour.
        Fault{"\xC3\xA9 = 1", "1:1: expected a key"},
        Fault{"\n\xC2\xB5 = 0.3", "2:1: expected a key"},
        Fault{"a = 1\xC2\xB5", "1:6: expected the end of the line or a comment, found U+00B5"},
        Fault{"a = \"\"\"b\\\n\xC3\xA9\"\"\"", "2:1: a continued line"},
        // The rest of the grammar.
        Fault{"a", "1:2: expected '=' after a key, found the end of the file"},
        Fault{"a =", "1:4: expected a value, found the end of the file"},
        Fault{"a =\nb = 2", "1:4: expected a value, found the end of the line"},
        Fault{"a = 1 b = 2", "1:7: expected the end of the line or a comment, found 'b'"},
        Fault{"a = 1\rb = 2", "1:6: expected the end of the line or a comment, found U+000D"},
        Fault{"a\xC2\xA0= 1", "1:2: expected '=' after a key, found U+00A0"},
        Fault{"\xC2\xA0", "1:1: expected a key"},
        Fault{"t = \"\xC3\xA9\" x", "1:9: expected the end of the line"},
        Fault{"a. = 1", "1:4: expected a key"}, Fault{"a..b = 1", "1:3: expected a key"},
        Fault{"\"\"\"a\"\"\" = 1", "1:1: a key must not be a multi-line string"},
        Fault{"[a", "1:3: expected ']'"}, Fault{"[[a]", "1:5: expected ']]'"},
        Fault{"[[a] ]", "1:5: expected ']]'"}, Fault{"[ [a]]", "1:3: expected a key"},
        Fault{"[a] b = 1", "1:5: expected the end of the line"},
        Fault{"a = [1 2]", "1:8: expected ',' or ']'"}, Fault{"a = [,1]", "1:6: expected a value"},
        Fault{"a = [1", "1:7: expected ',' or ']'"}, Fault{"a = {b = 1,}", "1:12: expected a key"},
        Fault{"a = {b = 1\n}", "1:11: expected ',' or '}'"}, Fault{"a = {", "1:6: expected a key"},
        Fault{"a = \"b\nc\"", "1:7: expected the closing quotation mark"},
        Fault{"a = 'b", "1:7: expected the closing quotation mark"},
        Fault{"a = \"\"\"b\"\"", "1:11: expected the three closing"},
        Fault{"a = '''", "1:8: expected the three closing"},
        Fault{"a = \"C:\\data\"", "1:8: unknown escape after a backslash"},
        Fault{"a = \"\\u12\"", "1:6: \\u needs 4 hexadecimal digits"},
        Fault{"a = \"\\ud800\"", "1:6: \\u gives U+D800"},
        Fault{"a = \"\\U00110000\"", "1:6: \\U gives U+110000"},
        Fault{"a = \"\"\"b\\ c\"\"\"", "1:9: unknown escape after a backslash"},
        Fault{"a = \"\x1B[0m\"", "1:6: control characters are not allowed in texts, found U+001B"},
        Fault{"# \x07", "1:3: control characters are not allowed in comments"},
        Fault{"# Latin-1: \xE9", "1:12: the file is not UTF-8: found byte 0xE9"},
        Fault{"# overlong: \xC0\xAF", "1:13: the file is not UTF-8"},
        Fault{"# surrogate: \xED\xA0\x80", "1:14: the file is not UTF-8"},
        Fault{"# cut off: \xE2\x82", "1:12: the file is not UTF-8"},
        Fault{"a = " + std::string(70, '[') + std::string(70, ']'), "1:70: nested more than 64"},
        Fault{"a" + std::string(200, '.'), "1:3: expected a key"}));

TEST(Toml, DottedKeysNestNoDeeperThanLists) {
  std::string key = "a";
  for (int k = 0; k < 63; ++k) key += ".a";
  EXPECT_EQ(shown(find_toml_fault(key + " = 1")), "none");
  EXPECT_EQ(shown(find_toml_fault(key + ".a = 1")), "1:129: nested more than 64 deep");
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
