// SPDX-License-Identifier: MIT
#include "microslip/io/config/toml_input.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "io/support.hpp"
#include "microslip/base/error.hpp"

namespace microslip::toml_input_test {
namespace {

using std::literals::operator""s;
using test::message_of;

std::string syntax_fault(const std::string& text) {
  return message_of<FormatError>([&] { return parse_toml(text, "a.toml"); });
}

void expect_starts(const std::string& text, const std::string& start) {
  EXPECT_EQ(text.substr(0, start.size()), start);
}

const std::string kSample =
    "number = 1.5\n"
    "whole = 3\n"
    "text = 'µ'\n"
    "numbers = [1, 2.5, inf]\n"
    "date = 2014-06-01\n"
    "[inner]\n"
    "a = true\n"
    "[[row]]\n"
    "x = 1\n"
    "[[row]]\n"
    "  x = 'two'\n";

class Sample : public ::testing::Test {
 protected:
  template <class Call>
  [[nodiscard]] std::string type_fault(const Call& call) const {
    return message_of<InputError>(call);
  }

  const toml::table content_ = parse_toml(kSample, "a.toml");
  const TomlTable top_{content_, "a.toml"};
};

using TomlTableTest = Sample;

TEST_F(TomlTableTest, ReadsEachType) {
  EXPECT_EQ(top_.number("number"), 1.5);
  EXPECT_EQ(top_.number("whole"), 3.0) << "an integer is a number";
  EXPECT_EQ(top_.whole("whole"), 3U);
  EXPECT_EQ(top_.text("text"), "µ");
  EXPECT_EQ(top_.numbers("numbers"), (std::vector<double>{1.0, 2.5, HUGE_VAL}));
  EXPECT_TRUE(top_.has("inner"));
  EXPECT_FALSE(top_.has("outer"));
  EXPECT_TRUE(top_.table("inner").has("a"));
  ASSERT_EQ(top_.tables("row").size(), 2U);
  EXPECT_EQ(top_.tables("row")[0].number("x"), 1.0);
}

TEST_F(TomlTableTest, NamesThePlaceOfAValueOfAWrongType) {
  EXPECT_EQ(type_fault([&] { return top_.number("text"); }),
            "a.toml:3:8: text = 'µ'; must be a number. Write it without quotes.");
  EXPECT_EQ(type_fault([&] { return top_.number("date"); }),
            "a.toml:5:8: date = a date or time; must be a number");
  EXPECT_EQ(type_fault([&] { return top_.text("number"); }),
            "a.toml:1:10: number = 1.5; must be a text in quotes");
  EXPECT_EQ(type_fault([&] { return top_.whole("number"); }),
            "a.toml:1:10: number = 1.5; must be a whole number, 0 or more");
  EXPECT_EQ(type_fault([&] { return top_.numbers("number"); }),
            "a.toml:1:10: number = 1.5; must be an array of numbers. Write it in [ ].");
  EXPECT_EQ(type_fault([&] { return top_.numbers("row"); }),
            "a.toml:8:1: row[0] = a table; must be a number");
  EXPECT_EQ(type_fault([&] { return top_.text("numbers"); }),
            "a.toml:4:11: numbers = an array of 3; must be a text in quotes");
  EXPECT_EQ(type_fault([&] { return top_.table("inner").number("a"); }),
            "a.toml:7:5: inner.a = true; must be a number");
  EXPECT_EQ(type_fault([&] { return top_.tables("row")[1].number("x"); }),
            "a.toml:11:7: row[1].x = 'two'; must be a number. Write it without quotes.");
}

TEST_F(TomlTableTest, SaysHowTablesAreWritten) {
  EXPECT_EQ(type_fault([&] { return top_.table("row").has("x"); }),
            "a.toml:8:1: row = an array of 2; must be a table. Write [row], and only once.");
  EXPECT_EQ(type_fault([&] { return top_.tables("inner").size(); }),
            "a.toml:6:1: inner = a table; must be an array of tables. Write [[inner]].");
  EXPECT_EQ(type_fault([&] { return top_.tables("numbers").size(); }),
            "a.toml:4:12: numbers[0] = 1; must be a table");
}

TEST_F(TomlTableTest, NamesAMissingKey) {
  EXPECT_EQ(message_of<FormatError>([&] { return top_.table("inner").number("b"); }),
            "a.toml:6:1: expected the key 'b' in inner, found the keys 'a'");
  EXPECT_EQ(message_of<FormatError>([&] { return top_.tables("row")[1].number("y"); }),
            "a.toml:10:1: expected the key 'y' in row[1], found the keys 'x'");
}

TEST_F(TomlTableTest, NamesAnUnknownKeyAndWhatItMayBe) {
  const auto unknown = [&](const std::vector<std::string_view>& keys) {
    return message_of<FormatError>([&] {
      top_.tables("row")[1].allow_only(keys);
      return 0;
    });
  };
  EXPECT_EQ(unknown({"y", "x_m"}),
            "a.toml:11:3: expected in row[1] the keys y, x_m, found the unknown key 'x'. Did you "
            "mean 'x_m'?");
  EXPECT_EQ(
      unknown({"length"}),
      "a.toml:11:3: expected in row[1] the keys length, found the unknown key 'x'. Correct or "
      "remove it.");
  EXPECT_EQ(unknown({"x", "z"}), "no error");
}

TEST_F(TomlTableTest, NamesFromAPath) {
  EXPECT_EQ(toml_name(content_, "a.toml", "row[1].x"), "a.toml:11:7: row[1].x");
  EXPECT_EQ(toml_name(content_, "a.toml", "row[1].y"), "a.toml:10:1: row[1].y") << "around it";
  EXPECT_EQ(toml_name(content_, "a.toml", "row[7].y"), "a.toml:8:1: row[7].y");
  EXPECT_EQ(toml_name(content_, "a.toml", "none.y"), "a.toml:1:1: none.y");
}

TEST(TomlInput, ReadsByteOrderMarkAndEitherLineBreak) {
  const toml::table content = parse_toml("\xEF\xBB\xBF# c\r\nx = 1\r\ny = 'a'\r\n", "a.toml");
  const TomlTable top(content, "a.toml");
  EXPECT_EQ(top.number("x"), 1.0);
  EXPECT_EQ(top.text("y"), "a");
  EXPECT_EQ(top.name("y"), "a.toml:3:5: y");
}

TEST(TomlInput, RefusesWhatIsNoTomlAtAll) {
  EXPECT_EQ(syntax_fault(""), "a.toml: expected TOML, found an empty file");
  EXPECT_EQ(syntax_fault("\xEF\xBB\xBF \r\n\t\n"), "a.toml: expected TOML, found an empty file");
  EXPECT_EQ(syntax_fault("{\"schema\": 1}"),
            "a.toml: expected TOML, found JSON. Is it the right file?");
  for (const char* table : {"time [s],force [N]\n0,1\n", "# a test\n\n A [m];D [J]\r\n1;2\r\n"}) {
    EXPECT_EQ(syntax_fault(table),
              "a.toml: expected TOML, found a table of comma-separated values. Is it the right "
              "file?");
  }
  EXPECT_EQ(syntax_fault("\x89HDF\r\n\x1A\n"),
            "a.toml: expected TOML, found an HDF5 file. Is it the right file?");
  EXPECT_EQ(syntax_fault("\xFF\xFE"
                         "a\0=\0"s),
            "a.toml: expected TOML, found UTF-16 text. Save it as UTF-8.");
  EXPECT_EQ(syntax_fault("\1\2\0\xFF"s),
            "a.toml:1:4: expected UTF-8, found '\\xFF'. Save the file as UTF-8.");
}

// What the parser says, of toml++ 3.3 here, is passed on and not relied on.
TEST(TomlInput, NamesThePlaceOfASyntaxError) {
  const std::string general =
      "Quote strings; write numbers with a decimal point and no unit; give each key once per "
      "table; write [[table]] for each of several tables.";
  const auto expect = [&](const std::string& text, const std::string& start,
                          const std::string& remedy = "") {
    const std::string fault = syntax_fault(text);
    expect_starts(fault, start + ". The parser says 'Error while parsing ");
    EXPECT_TRUE(fault.ends_with("'. " + (remedy.empty() ? general : remedy))) << fault;
  };
  expect("a = 1\nb = 0,583\n", "a.toml:2:6: expected TOML, found ',583'",
         "Write a decimal point, not a comma.");
  expect("a: 1\n", "a.toml:1:2: expected TOML, found ': 1'", "Write key = value.");
  expect("a = 1;\n", "a.toml:1:6: expected TOML, found ';'",
         "Only a comment may follow a value: remove ';'.");
  expect("a = “b”\n", "a.toml:1:5: expected TOML, found '“b”'", "Use straight quotes: \"text\".");
  expect("a = \"C:\\data\\b.csv\"\n", "a.toml:1:9: expected TOML, found 'data\\b.csv\"'",
         "In \"...\" a backslash starts an escape: write paths with '/', or in '...'.");
  expect("a = \"b\nc = 1\n", "a.toml:1:7: expected TOML, found the end of the line",
         "Close the quote on the same line.");
  expect("a = 5 mm\n", "a.toml:1:7: expected TOML, found 'mm'");
  const std::string digits = "A decimal point needs a digit on each side: 80.0 or 0.5.";
  expect("a = 5.\n", "a.toml:1:7: expected TOML, found the end of the line", digits);
  expect("a = [80., 3.0]\n", "a.toml:1:9: expected TOML, found ', 3.0]'", digits);
  expect("a = [80.,310.0]\n", "a.toml:1:9: expected TOML, found ',310.0]'", digits);
  expect("a = .5\n", "a.toml:1:5: expected TOML, found '.5'", digits);
  expect("a = joint.json\n", "a.toml:1:5: expected TOML, found 'joint.json'");
  expect("[a\nb = 1", "a.toml:1:3: expected TOML, found the end of the line");
  expect("# µ\na = [1, 2", "a.toml:2:10: expected TOML, found the end of the file");
  EXPECT_LT(syntax_fault("a = \"" + std::string(1'000'000, 'x')).size(), 500U);
  EXPECT_LT(syntax_fault(std::string(1'000'000, 'x')).size(), 500U);
}

TEST(TomlInput, RefusesAHeaderWithoutAKey) {
  expect_starts(syntax_fault("\n[=]\n"), "a.toml:2:2: expected ");
  expect_starts(syntax_fault("[[.a]]\n"), "a.toml:1:3: expected ");
  expect_starts(syntax_fault("a. = 1\n"), "a.toml:1:4: expected ");
}

TEST(TomlInput, RefusesNumbersBeyondTheirType) {
  expect_starts(syntax_fault("a = 1e999"), "a.toml:1:10:");
  expect_starts(syntax_fault("a = 99999999999999999999"), "a.toml:1:25");
}

TEST(TomlInput, RefusesAKeyGivenTwice) {
  expect_starts(syntax_fault("a = 1\nb = 2\na = 3\n"), "a.toml:3:5: expected TOML, found ");
  expect_starts(syntax_fault("[a]\n[a]\n"), "a.toml:2:1: expected TOML, found ");
  expect_starts(syntax_fault("a = 1\na.b = 3\n"), "a.toml:2:1: expected TOML, found 'a.b = 3'");
  const std::string name(100'000, 'x');
  EXPECT_LT(syntax_fault(name + " = 1\n" + name + " = 2\n").size(), 500U);
}

// ---- Depth: freeing a tree of tables recurses, and so does the parser. ----

std::string repeated(const std::string& text, std::size_t count) {
  std::string result;
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

TEST(TomlInput, BoundsTheDepthOfBrackets) {
  const std::string expected = "expected at most 64 nested arrays and tables, found more";
  for (const char* bracket : {"[", "{ a = ", "[{ a = "}) {
    const std::string message = syntax_fault("a = " + repeated(bracket, 1'000'000));
    EXPECT_NE(message.find(expected), std::string::npos) << message;
  }
  EXPECT_NO_THROW((void)parse_toml("a = " + repeated("[", 64) + repeated("]", 64), ""));
  EXPECT_EQ(syntax_fault("\na = " + repeated("[", 65) + repeated("]", 65)),
            "a.toml:2:69: " + expected);
}

TEST(TomlInput, BoundsThePartsOfAKey) {
  const std::string expected = "expected at most 16 parts in a dotted key, found more";
  for (const char* part : {"a.", "a . ", "'[a'.", "\"\\\"\"."}) {
    const std::string key = repeated(part, 1'000'000) + "a";
    for (const std::string& text :
         {key + " = 1", "[" + key + "]", "x = { " + key + " = 1 }", "x = '' #''\n" + key + " = 1",
          "x = [\"\"\"a\\\"\"\"\"\", \"\"\"\"\"\", '''b''''] # \"\n" + key + " = 1",
          "x = \"\"\"a\"\"\"\"\n" + key + " = 1"}) {
      const std::string message = syntax_fault(text);
      EXPECT_NE(message.find(expected), std::string::npos) << message;
    }
  }
  EXPECT_NO_THROW((void)parse_toml(repeated("a.", 15) + "a = 1", ""));
  EXPECT_EQ(syntax_fault("\n" + repeated("a.", 16) + "a = 1"), "a.toml:2:32: " + expected);
}

TEST(TomlInput, BoundsBothTogether) {
  std::string text = "x = ";
  for (int i = 0; i < 32; ++i) text += "[{ " + repeated("a.", 15) + "a = ";
  text += "1";
  for (int i = 0; i < 32; ++i) text += " }]";
  EXPECT_NO_THROW((void)parse_toml(text, "a.toml")) << "the deepest that is let through";
}

TEST(TomlInput, DotsAndBracketsInTextsAndCommentsAreFree) {
  const std::string free = repeated("[.", 1000);
  const toml::table content =
      parse_toml("# " + free + "\na = '" + free + "' # '" + free + "\nb = \"\\\"" + free +
                     "\"\nc = '''\n" + free + "''''\nd = [" + repeated("1.5, ", 1000) + "]",
                 "a.toml");
  EXPECT_EQ(TomlTable(content, "").text("a"), free);
  EXPECT_EQ(TomlTable(content, "").text("c"), free + "'");
  EXPECT_EQ(TomlTable(content, "").numbers("d").size(), 1000U);
}

// Found by fuzzing: toml++ gives no double of them.
TEST(TomlInput, RoundsWholeNumbersThatADoubleDoesNotHold) {
  const toml::table table =
      parse_toml("x = 8868759961067043\ny = [9007199254740993, -3]\n", "a.toml");
  const TomlTable file(table, "a.toml");
  EXPECT_EQ(file.number("x"), 8868759961067043.0);
  EXPECT_EQ(file.numbers("y"), (std::vector<double>{9007199254740992.0, -3.0}));
}

}  // namespace
}  // namespace microslip::toml_input_test
