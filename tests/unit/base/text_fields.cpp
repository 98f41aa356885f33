// SPDX-License-Identifier: LGPL-2.1-or-later
// Lines, fields and numbers of delimited text.
#include "base/text_fields.hpp"

#include "support/test.hpp"
#include <clocale>

using Fields = std::vector<std::string_view>;

TEST(TextLines, AreTrimmedAndCounted) {
  std::vector<std::string> lines;
  for (TextLines text("a b\r\n\n\t c \nlast"); text.next();)
    lines.push_back(std::to_string(text.number()) + std::string(text.line()));
  EXPECT_EQ(lines, (std::vector<std::string>{"1a b", "2", "3c", "4last"}));
  EXPECT_FALSE(TextLines("").next());
  TextLines ended("one\n");
  EXPECT_TRUE(ended.next());
  EXPECT_FALSE(ended.next());
}

TEST(TextFields, StandBetweenSeparators) {
  EXPECT_EQ(fields_of(" 1,2;;\t3 ", " ,;\t"), (Fields{"1", "2", "3"}));
  EXPECT_EQ(fields_of("", ","), Fields{});
  EXPECT_EQ(fields_of(" ,", " ,"), Fields{});
  EXPECT_EQ(parts_of("1,,2", ","), (Fields{"1", "", "2"}));
  EXPECT_EQ(parts_of("1,2,", ","), (Fields{"1", "2", ""}));
  EXPECT_EQ(parts_of("", ","), Fields{""});
  EXPECT_EQ(parts_of("a:b;c", ":;"), (Fields{"a", "b", "c"}));
}

TEST(TextFields, EndWhereACommentBegins) {
  EXPECT_EQ(without_comment("1 2 # three", "#"), "1 2 ");
  EXPECT_EQ(without_comment("1 2", "#!"), "1 2");
  EXPECT_EQ(without_comment("! all", "#!"), "");
}

TEST(Tables, AreTextsOfWhichMostLinesBeginWithNumbers) {
  for (const char* table : {"1 2\n", "y;z\n1,5;2,5\n", "# words\n-1,2\n", "12\n1 2\nmm of y\n",
                            "type = 1\nunits.len.f = 1000\n 0.5 1\n"})
    EXPECT_TRUE(looks_like_table(table, "#")) << table;
  for (const char* other : {"", "#1 2\n", "root:x:0:0:root:/root:/bin/sh\n", "Dear Sir\n",
                            "TOKEN = 12\n", "a b\nc d\n1 2\n", "\xff\xfe"})
    EXPECT_FALSE(looks_like_table(other, "#")) << other;
}

TEST(NumberOfAField, IsAllOfIt) {
  EXPECT_EQ(number_of("1.5"), 1.5);
  EXPECT_EQ(number_of("+1.5e-3"), 1.5e-3);
  EXPECT_EQ(number_of("-.25"), -0.25);
  EXPECT_EQ(number_of("1,5", true), 1.5);
  EXPECT_EQ(whole_number_of("+12"), 12);
  for (const char* wrong : {"", " 1", "1 ", "1mm", "1,5", "0x10", "nan", "inf", "1e999", "+-1", "+",
                            "--1", "1.2.3", "e5"})
    EXPECT_FALSE(number_of(wrong)) << wrong;
  EXPECT_FALSE(number_of("1,5,2", true));
  for (const char* wrong : {"", "1.0", "1e3", "99999999999"})
    EXPECT_FALSE(whole_number_of(wrong)) << wrong;
}

TEST(NumberOfAField, IsTheSameInEveryLocale) {
  // Where this locale is not installed the test cannot fail.
  std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
  EXPECT_EQ(number_of("1.5"), 1.5);
  EXPECT_FALSE(number_of("1,5"));
  std::setlocale(LC_NUMERIC, "C");
}

TEST(FieldInAMessage, IsShortAndPrintable) {
  EXPECT_EQ(printable("a\tb\xff"), "a?b?");
  EXPECT_EQ(printable(std::string(100, 'x')).size(), 40u);
}

TEST(TextFields, NearestNameIsOnlyGivenWhenItIsNear) {
  const std::vector<std::string> names{"normal_force", "approach"};
  EXPECT_EQ(contact::nearest_name("normalforce", names), "normal_force");
  EXPECT_EQ(contact::nearest_name("force", names), "normal_force");
  EXPECT_EQ(contact::nearest_name("aproach", names), "approach");
  EXPECT_EQ(contact::nearest_name("quux", names), "");
  EXPECT_EQ(contact::nearest_name(std::string(100000, 'a'), names), "");
}
