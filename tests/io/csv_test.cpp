// SPDX-License-Identifier: MIT
#include "microslip/io/tables/csv.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <locale>
#include <string>
#include <vector>

#include "io/support.hpp"

namespace microslip::csv_test {
namespace {

using std::literals::operator""s;
using test::message_of;
using Numbers = std::vector<double>;

CsvTable table(const std::string& text) { return CsvTable(text, "t.csv"); }

Numbers lengths(const std::string& text) { return table(text).numbers("a", kLength); }

/// What is wrong with a text, when its column a is asked for as a length.
std::string fault(const std::string& text) {
  return message_of<FormatError>([&] { return lengths(text); });
}

// ---- What is read. ----

TEST(Csv, ReadsColumnsInSi) {
  const CsvTable t = table("a [um],b [kN]\n1,2\n-3.5e1,.5\n");
  EXPECT_EQ(t.rows(), 2U);
  EXPECT_EQ(t.columns()[1].name, "b");
  EXPECT_EQ(t.columns()[1].unit, "kN");
  EXPECT_EQ(t.numbers("a", kLength), (Numbers{1e-6, -35e-6}));
  EXPECT_EQ(t.numbers("b", kForce), (Numbers{2000.0, 500.0}));
}

TEST(Csv, KeepsCommentsAndSkipsBlankLines) {
  const CsvTable t = table("# one\n\n  #two \na [m]\n# three\r\n1\n \t\n2\n#");
  EXPECT_EQ(std::vector<std::string>(t.comments().begin(), t.comments().end()),
            (std::vector<std::string>{"one", "two", "three", ""}));
  EXPECT_EQ(t.numbers("a", kLength), (Numbers{1.0, 2.0}));
  EXPECT_EQ(t.row_lines(), (std::vector<std::size_t>{6, 8}));
}

TEST(Csv, ReadsTheSameWhateverTheFormOfTheText) {
  const Numbers expected{1.5, -2.0};
  EXPECT_EQ(lengths("a [m],b [N]\n1.5,0\n-2,0\n"), expected);
  EXPECT_EQ(lengths("a [m],b [N]\n1.5,0\n-2,0"), expected) << "no line break at the end";
  EXPECT_EQ(lengths("\xEF\xBB\xBF"
                    "a [m],b [N]\r\n1.5,0\r\n-2,0\r\n"),
            expected)
      << "BOM, CRLF";
  EXPECT_EQ(lengths("a [m];b [N]\n1.5;0\n-2;0\n"), expected);
  EXPECT_EQ(lengths("a [m]\tb [N]\n1.5\t0\n-2\t0\n"), expected);
  EXPECT_EQ(lengths("a [m];b [N]\n1,5;0\n-2;0,25\n"), expected) << "decimal comma";
  EXPECT_EQ(lengths("a [m]\tb [N]\n1,5\t0\n-2\t0\n"), expected) << "decimal comma and tabs";
  EXPECT_EQ(lengths("\"a [m]\",\"b [N]\"\n\"1.5\",0\n\"-2\" , 0\n"), expected) << "quotes";
  EXPECT_EQ(lengths(" a  [ m ] , b [N]\n +1.5 ,\t0\n -2 , 0 \n"), expected) << "blanks, plus";
  EXPECT_EQ(lengths("a [m],b [N],\n1.5,0,\n-2,0,\n"), expected) << "trailing separators";
  EXPECT_EQ(lengths("a [m],b [N]\n1.5,0,\n-2,0\n"), expected) << "one trailing separator";
  EXPECT_EQ(lengths("b [N],a [m]\n0,1.5\n0,-2\n"), expected) << "another order";
  EXPECT_EQ(lengths("a [m]\n1.5\n-2\n"), expected) << "a single column";
}

TEST(Csv, ADecimalCommaLateInTheTableHoldsForAllOfIt) {
  const CsvTable t = table("# x\na [m];b [m]\n# y\n1;2\n3,25;4\n");
  EXPECT_EQ(t.numbers("a", kLength), (Numbers{1.0, 3.25}));
  EXPECT_EQ(t.comments().size(), 2U) << "comments are not kept twice";
  EXPECT_EQ(fault("a [m];b [m]\n1.5;2\n3,25;4\n"),
            "t.csv:2:1: expected a finite number in column 1 'a [m]', found '1.5'. This table has "
            "decimal commas elsewhere: write all numbers one way.");
  EXPECT_NE(fault("a [m];b [m]\n1,234.5;2\n").find("found '1,234.5'"), std::string::npos);
}

TEST(Csv, TextColumnsNeedNoUnitAndNumbersInThemStayText) {
  const CsvTable t = table("source,a [m],flags\n\"run 1, \"\"left\"\"\",1,\n007,2,late nan\n");
  EXPECT_EQ(t.text("source"), (std::vector<std::string>{"run 1, \"left\"", "007"}));
  EXPECT_EQ(t.text("flags"), (std::vector<std::string>{"", "late nan"}));
  EXPECT_EQ(t.numbers("a", kLength), (Numbers{1.0, 2.0}));
}

TEST(Csv, ColumnsNobodyAsksForMayHoldAnything) {
  EXPECT_EQ(lengths("x,a [m],y [furlong]\nnan,1,\n,2,inf\n"), (Numbers{1.0, 2.0}));
}

TEST(Csv, MissingColumnsCanBeOptional) {
  EXPECT_TRUE(table("a [m]\n1\n").numbers_if_present("b", kLength).empty());
  EXPECT_EQ(table("a [m]\n1\n").numbers_if_present("a", kLength), Numbers{1.0});
}

TEST(Csv, ReadsNumbersAtTheEdgesOfTheRange) {
  EXPECT_EQ(lengths("a [m]\n4.9406564584124654e-324\n2.2250738585072014e-308\n"
                    "1.7976931348623157e308\n-0.0\n9007199254740993\n"),
            (Numbers{4.9406564584124654e-324, 2.2250738585072014e-308, 1.7976931348623157e308, -0.0,
                     9007199254740992.0}));
}

TEST(Csv, ReadsTheHeaderOfAPieceOfATable) {
  EXPECT_EQ(csv_column_names("# c\na [m],b\n1,"), (std::vector<std::string>{"a", "b"}));
  // A column that stands twice is refused by who reads the table, not taken for another kind.
  EXPECT_EQ(csv_column_names("time [s],force [N],force [N]\n"),
            (std::vector<std::string>{"time", "force", "force"}));
  EXPECT_TRUE(csv_column_names("1,2\n").empty());
  EXPECT_TRUE(csv_column_names("{\"a\": 1}").empty());
}

// ---- What is refused, and with which words. ----

TEST(CsvFault, Empty) {
  EXPECT_EQ(
      fault(""),
      "t.csv: expected a header such as 'amplitude [m],dissipation [J]', found an empty file. Was "
      "it written to its end?");
  EXPECT_EQ(fault("\n# only this\n \n"),
            "t.csv: expected a header such as 'amplitude [m],dissipation [J]', found nothing but "
            "blanks and comments. Was it written to its end?");
  EXPECT_EQ(fault("\xEF\xBB\xBF"), fault("\n"));
}

TEST(CsvFault, HeaderOnly) {
  EXPECT_EQ(fault("a [m]\n# no rows\n"),
            "t.csv:3:1: expected a row of values below the header, found the end of the file. Was "
            "it written to its end?");
}

TEST(CsvFault, NoHeader) {
  EXPECT_EQ(fault("1,2\n3,4\n"),
            "t.csv:1:1: expected a header such as 'amplitude [m],dissipation [J]', found a row of "
            "numbers. Add a first line that names each column with its unit.");
}

TEST(CsvFault, Binary) {
  EXPECT_EQ(
      fault("\x89HDF\r\n\x1A\n\0\0\0"s),
      "t.csv: expected a table of comma-separated values, found an HDF5 file. Is it the right "
      "file?");
  EXPECT_EQ(fault("\xFF\xFE"
                  "a\0 \0"s),
            "t.csv: expected a table of comma-separated values, found UTF-16 text. Save it as "
            "UTF-8.");
  EXPECT_EQ(fault("a [m],b\n1,x\0y\n"s),
            "t.csv:2:4: expected text, found the byte 0x00. Is this a text table?");
  EXPECT_EQ(fault("\x01\x02\x03"),
            "t.csv:1:1: expected text, found the byte 0x01. Is this a text table?");
  EXPECT_EQ(fault("a [m]\r1\r2\r"),
            "t.csv:1:6: expected text, found the byte 0x0D. Save the table with line breaks LF or "
            "CRLF.");
}

TEST(CsvFault, Ragged) {
  EXPECT_EQ(fault("a [m],b [N]\n1,2\n\n3\n"),
            "t.csv:4:1: expected 2 cells as in the header, found 1. The separator of this table is "
            "','.");
  EXPECT_EQ(
      fault("a [m],b [N]\n1,5,2,5\n"),
      "t.csv:2:1: expected 2 cells as in the header, found 4. Decimal commas need ';' or tabs "
      "between the columns.");
  EXPECT_EQ(fault("a [m]\n1,5\n"),
            "t.csv:2:1: expected 1 cell as in the header, found 2. Decimal commas need ';' or tabs "
            "between the columns; lines above the header begin with '#'.");
}

TEST(CsvFault, HugeCellIsShownInShort) {
  const std::string message = fault("a [m]\n" + std::string(10'000'000, 'x') + "\n");
  EXPECT_EQ(message, "t.csv:2:1: expected a finite number in column 1 'a [m]', found '" +
                         std::string(40, 'x') +
                         "…' (10000000 bytes). Correct the cell or remove the row.");
  EXPECT_LT(fault(std::string(10'000'000, ',')).size(), 200U);
  EXPECT_LT(fault(std::string(10'000'000, 'h') + "\n1\n").size(), 300U);
}

TEST(CsvFault, NotANumber) {
  EXPECT_EQ(
      fault("b [N],a [m]\n1,2\n3,nan\n"),
      "t.csv:3:3: expected a finite number in column 2 'a [m]', found 'nan'. Correct the cell "
      "or remove the row.");
  for (const char* cell :
       {"inf",  "-inf", "INFINITY", "NaN", "nan(1)", "1e999", "-1e999", "abc",   "1 2",   "1.2.3",
        "0x10", "1e",   "--1",      "+-1", "+",      "-",     ".",      "1_000", "1'000", "１"}) {
    EXPECT_NE(fault("a [m],b\n"s + cell + ",x\n").find("t.csv:2:1: expected a finite number"),
              std::string::npos)
        << cell << ": " << fault("a [m],b\n"s + cell + ",x\n");
  }
}

TEST(CsvFault, NotANumberAcrossCells) {
  // from_chars takes nan(…) as one number; no text may run over a separator or a line break.
  EXPECT_NE(fault("a [m],b\nnan(1,2)\n").find("found 'nan(1'"), std::string::npos);
}

TEST(CsvFault, EmptyCell) {
  EXPECT_EQ(fault("a [m],b [N]\n,2\n"),
            "t.csv:2:1: expected a finite number in column 1 'a [m]', found an empty cell. Correct "
            "the cell or remove the row.");
}

TEST(CsvFault, OutOfRangeInSi) {
  EXPECT_NE(fault("a [km]\n1e308\n").find("found '1e308'"), std::string::npos);
}

TEST(CsvFault, DuplicateColumns) {
  EXPECT_EQ(fault("a [m],b,a [mm]\n1,2,3\n"),
            "t.csv:1:9: expected columns with different names, found 'a' as column 1 and as column "
            "3. Rename or remove one of them.");
}

TEST(CsvFault, MissingColumn) {
  EXPECT_EQ(fault("# c\nA [m],a (left)\n1,2\n"),
            "t.csv:2:1: expected a column 'a [m]', found the columns 'A, a (left)'. Names are "
            "case-sensitive; write units in square brackets.");
}

TEST(CsvFault, NoUnit) {
  EXPECT_EQ(fault("b [N],a\n1,2\n"),
            "t.csv:1:7: expected a unit of length for column 2, found 'a' without one. Write "
            "'a [m]'.");
}

TEST(CsvFault, UnknownUnit) {
  EXPECT_EQ(
      fault("a [furlong]\n1\n"),
      "t.csv:1:1: expected a unit of length for column 1, found the unknown unit 'furlong' of "
      "'a'. Units that fit: m, mm, um (µm), nm, cm, in, ft, mil.");
  EXPECT_NE(fault("a []\n1\n").find("the unknown unit ''"), std::string::npos);
  EXPECT_NE(fault("a [\xB5m]\n1\n").find("the unknown unit '\\xB5m'"), std::string::npos);
}

TEST(CsvFault, WrongUnit) {
  EXPECT_EQ(fault("a [N]\n1\n"),
            "t.csv:1:1: expected a unit of length for column 1, found 'N', a unit of force, for "
            "'a'. Units that fit: m, mm, um (µm), nm, cm, in, ft, mil.");
}

TEST(CsvFault, HeaderForms) {
  EXPECT_EQ(fault("a [m\n1\n"),
            "t.csv:1:1: expected 'name [unit]' as the header of column 1, found 'a [m'");
  EXPECT_EQ(fault("a [m],,b\n1,2,3\n"),
            "t.csv:1:7: expected a name for column 2, found an empty cell");
  EXPECT_EQ(fault("[m]\n1\n"), "t.csv:1:1: expected a name for column 1, found '[m]'");
}

TEST(CsvFault, Quotes) {
  EXPECT_EQ(fault("a [m]\n\"1\n2\"\n"),
            "t.csv:2:1: expected a closing quote on the line of the opening one, found the end of "
            "the line. Close the quote or remove it.");
  EXPECT_EQ(fault("a [m],b\n1,\"x\"y\n"),
            "t.csv:2:6: expected a separator after the closing quote, found 'y'. Double the quotes "
            "that belong to the text.");
}

TEST(CsvFault, ReadersRulesNameTheCell) {
  const CsvTable t = table("b,a [mm]\nx,1\ny,-2\n");
  EXPECT_EQ(message_of<FormatError>(
                [&]() -> int { t.reject(1, "a", "a positive amplitude", "Remove the row."); }),
            "t.csv:3:3: expected a positive amplitude in column 2 'a [mm]', found '-2'. Remove the "
            "row.");
}

// ---- Locales. ----

class CommaPunctuation : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Csv, DoesNotDependOnTheLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaPunctuation));
  const std::string c_before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"}) {
    if (std::setlocale(LC_ALL, name) != nullptr) break;  // where one is installed
  }
  EXPECT_EQ(lengths("a [m]\n1234.5\n"), Numbers{1234.5});
  EXPECT_EQ(lengths("a [m];b\n1234,5;x\n"), Numbers{1234.5});
  std::setlocale(LC_ALL, c_before.c_str());
  std::locale::global(before);
}

}  // namespace
}  // namespace microslip::csv_test
