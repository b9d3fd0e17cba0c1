// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/levels_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"

namespace microslip::levels_file_test {
namespace {

using test::message_of;
using Numbers = std::vector<double>;

std::string fault(const std::string& text) {
  return message_of<FormatError>([&] { return parse_levels(text, "levels.csv"); });
}

TEST(LevelsFile, ReadsWhatIsNeeded) {
  const LevelsFile file = parse_levels(
      "# bolted lap joint\namplitude [um],dissipation [mJ],frequency [Hz],source\n"
      "19.562,0.0018186,80.3654,a.csv\n\n79.241,0.037397,80.1827,b.csv\n",
      "levels.csv");
  EXPECT_EQ(file.levels.amplitude, (Numbers{19.562e-6, 79.241e-6}));
  EXPECT_EQ(file.levels.dissipation, (Numbers{1.8186e-6, 3.7397e-5}));
  EXPECT_TRUE(file.levels.amplitude_std.empty());
  EXPECT_TRUE(file.levels.secant_stiffness.empty());
  EXPECT_EQ(file.line, (std::vector<std::size_t>{3, 5}));
  EXPECT_EQ(file.file, "levels.csv");
}

TEST(LevelsFile, ReadsWhatIsOptional) {
  const LevelsFile file = parse_levels(
      "secant_stiffness_std [N/m],amplitude [m],amplitude_std [nm],dissipation [J],"
      "dissipation_std [J],secant_stiffness [kN/mm]\n1,2,3,4,5,6\n",
      "levels.csv");
  EXPECT_EQ(file.levels.amplitude_std, Numbers{3e-9});
  EXPECT_EQ(file.levels.dissipation_std, Numbers{5.0});
  EXPECT_EQ(file.levels.secant_stiffness, Numbers{6e6});
  EXPECT_EQ(file.levels.secant_stiffness_std, Numbers{1.0});
}

// That of the resonance counts where both are there, and with the deviation of the same name.
TEST(LevelsFile, ReadsAssembliesWhereTheyAreAskedFor) {
  const std::string text =
      "assembly,stiffness [kN/mm],amplitude [m],dissipation [J],reversals [1]\n"
      "a,1,1,1,2\nb 2,2,1,1,4\n,3,1,1,2\n";
  const LevelsFile file = parse_levels(text, "levels.csv");
  EXPECT_EQ(file.assembly, (std::vector<std::string>{"a", "b 2", ""}));
  EXPECT_TRUE(file.stiffness.empty());
  const auto all = [&] { return parse_levels(text, "levels.csv", {.assemblies = true}); };
  EXPECT_NE(message_of<FormatError>(all).find("levels.csv:4"), std::string::npos);
  const LevelsFile two = without_inner_reversals(
      parse_levels(text.substr(0, text.rfind(",3")), "levels.csv", {.assemblies = true}));
  EXPECT_EQ(two.assembly, std::vector<std::string>{"a"});
  EXPECT_EQ(two.stiffness, Numbers{1e6});
}

TEST(LevelsFile, ReadsFrequencies) {
  const std::string text =
      "amplitude [m],dissipation [J],frequency [Hz],frequency_std [Hz],resonance_frequency [Hz]\n"
      "1,2,80,0.1,81\n2,3,79,0.1,78\n";
  const Levels both = parse_levels(text, "levels.csv").levels;
  EXPECT_EQ(both.frequency, (Numbers{81.0, 78.0}));
  EXPECT_TRUE(both.frequency_std.empty());
  const Levels drive =
      parse_levels(
          "amplitude [m],dissipation [J],frequency [kHz],frequency_std [Hz]\n1,2,0.08,0.1\n", "l")
          .levels;
  EXPECT_EQ(drive.frequency, Numbers{80.0});
  EXPECT_EQ(drive.frequency_std, Numbers{0.1});
  EXPECT_EQ(fault("amplitude [m],dissipation [J],frequency [Hz]\n1,2,80\n2,3,0\n"),
            "levels.csv:3:5: expected a number above 0 in column 3 'frequency [Hz]', found '0'. "
            "Where it is "
            "not "
            "known at every level, remove the column.");
}

// As recordings, and as spreadsheets write it; other parentheses belong to the name.
TEST(LevelsFile, TakesUnitsInParentheses) {
  const LevelsFile file =
      parse_levels("amplitude (µm);dissipation (mJ);note (a);note (b)\n2,5;3;x;y\n", "levels.csv");
  EXPECT_EQ(file.levels.amplitude, Numbers{2.5e-6});
  EXPECT_EQ(file.levels.dissipation, Numbers{3e-3});
}

TEST(LevelsFile, ReadsTheLinearLossWhereItIsAskedFor) {
  const std::string text =
      "amplitude [m],dissipation [J],linear_dissipation [mJ],reversals [1],flags\n"
      "1,2,3,2,\n2,3,4,6,spike\n3,4,5,2,clipped few_cycles\n";
  EXPECT_TRUE(parse_levels(text, "levels.csv").levels.linear_dissipation.empty());
  const LevelsFile file =
      parse_levels(text, "levels.csv", {.linear_dissipation = LinearLossColumn::kNeeded});
  EXPECT_EQ(file.levels.linear_dissipation, (Numbers{3e-3, 4e-3, 5e-3}));
  const LevelsFile usable = without_inner_reversals(file);
  EXPECT_EQ(usable.levels.linear_dissipation, (Numbers{3e-3, 5e-3}));
  EXPECT_EQ(usable.flags, (std::vector<std::string>{"", "clipped few_cycles"}));
  const LevelsReadOptions where_there{.linear_dissipation = LinearLossColumn::kUsed};
  EXPECT_EQ(parse_levels(text, "levels.csv", where_there).levels.linear_dissipation,
            file.levels.linear_dissipation);
  const std::string without = "amplitude [m],dissipation [J]\n1,2\n";
  EXPECT_TRUE(parse_levels(without, "levels.csv", where_there).levels.linear_dissipation.empty());
  const auto fault_with_loss = [](const std::string& table) {
    return message_of<FormatError>([&] {
      return parse_levels(table, "levels.csv", {.linear_dissipation = LinearLossColumn::kNeeded});
    });
  };
  EXPECT_NE(fault_with_loss("amplitude [m],dissipation [J]\n1,2\n")
                .find("expected a column 'linear_dissipation [J]'"),
            std::string::npos);
  EXPECT_NE(fault_with_loss("amplitude [m],dissipation [J],linear_dissipation [J]\n1,2,-3\n")
                .find("levels.csv:2:5"),
            std::string::npos);
}

TEST(LevelsFile, LeavesOrderRepetitionAndNumberToTheIdentification) {
  EXPECT_EQ(parse_levels("amplitude [m],dissipation [J]\n1,0\n", "").levels.size(), 1U);
  EXPECT_EQ(parse_levels("amplitude [m],dissipation [J]\n2,1\n1,1\n2,1\n", "").levels.amplitude,
            (Numbers{2.0, 1.0, 2.0}));
}

TEST(LevelsFileFault, ValuesThatBreakARule) {
  EXPECT_EQ(fault("amplitude [um],dissipation [J]\n1,2\n-1,2\n"),
            "levels.csv:3:1: expected a number above 0 in column 1 'amplitude [um]', found '-1'. A "
            "level without motion has no information: remove the row. Logarithms are not taken.");
  EXPECT_NE(fault("amplitude [um],dissipation [J]\n0,2\n").find("levels.csv:2:1"),
            std::string::npos);
  EXPECT_EQ(fault("amplitude [um],dissipation [J]\n1,-2e-9\n"),
            "levels.csv:2:3: expected a number of 0 or more in column 2 'dissipation [J]', found "
            "'-2e-9'. A contact cannot give energy: remove the row, or check the phase.");
  EXPECT_NE(fault("amplitude [m],dissipation [J],amplitude_std [m]\n1,2,-3\n")
                .find("levels.csv:2:5: expected a number of 0 or more in column 3"),
            std::string::npos);
  EXPECT_NE(fault("amplitude [m],dissipation [J],secant_stiffness [N/m]\n1,2,0\n")
                .find("levels.csv:2:5: expected a number above 0 in column 3"),
            std::string::npos);
}

TEST(LevelsFileFault, NaNTextAndEmptyCells) {
  EXPECT_NE(
      fault("amplitude [m],dissipation [J]\n1,nan\n").find("levels.csv:2:3: expected a finite"),
      std::string::npos);
  EXPECT_NE(fault("amplitude [m],dissipation [J]\nhigh,1\n").find("found 'high'"),
            std::string::npos);
  EXPECT_NE(
      fault("amplitude [m],dissipation [J],dissipation_std [J]\n1,1,\n").find("an empty cell"),
      std::string::npos);
}

TEST(LevelsFileFault, ColumnsAndUnits) {
  EXPECT_NE(fault("amplitude [m]\n1\n")
                .find("a column 'dissipation [J]', found the columns "
                      "'amplitude'"),
            std::string::npos);
  EXPECT_NE(fault("amplitude,dissipation [J]\n1,1\n").find("Write 'amplitude [m]'."),
            std::string::npos);
  EXPECT_NE(fault("amplitude [N],dissipation [J]\n1,1\n").find("'N', a unit of force"),
            std::string::npos);
  EXPECT_EQ(message_of<FileError>([] { return read_levels("no-such-levels.csv"); }),
            "no-such-levels.csv: cannot be read: No such file or directory. Check the path.");
}

TEST(LevelsFile, SurvivesTheRoundTrip) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-300.0, 300.0);
  Levels levels;
  for (int i = 0; i < 2000; ++i) {
    levels.amplitude.push_back(std::pow(10.0, exponent(random)));
    levels.dissipation.push_back(std::pow(10.0, exponent(random)));
    levels.dissipation_std.push_back(std::pow(10.0, exponent(random)));
    levels.secant_stiffness.push_back(std::pow(10.0, exponent(random)));
  }
  CsvWriter writer = levels_table(levels);
  writer.add_text("source", std::vector<std::string>(2000, "a, b"));
  const Levels back = parse_levels(writer.str(), "").levels;
  EXPECT_EQ(back.amplitude, levels.amplitude);
  EXPECT_EQ(back.dissipation, levels.dissipation);
  EXPECT_TRUE(back.amplitude_std.empty());
  EXPECT_EQ(back.dissipation_std, levels.dissipation_std);
  EXPECT_EQ(back.secant_stiffness, levels.secant_stiffness);
}

}  // namespace
}  // namespace microslip::levels_file_test
