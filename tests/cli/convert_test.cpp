// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "support/tested_chain.hpp"

namespace microslip::cli_test::convert_test {
namespace {

const std::string kLevel =
    "# operator: A. Böhm\n"
    "time [ms],force [N],acc1 [g],ldv\n"
    "0,1,0,1\n"
    "0.5,-2,0.5,2\n"
    "1,0.25,-1,3\n"
    "1.5,1,0,4\n";

Sandbox sandbox() { return Sandbox{{"level.csv", kLevel}}; }

/// The widest line in characters of UTF-8.
std::size_t widest(const std::string& text) {
  std::size_t width = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const auto count = std::count_if(line.begin(), line.end(), [](char c) {
      return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    });
    width = std::max(width, static_cast<std::size_t>(count));
  }
  return width;
}

TEST(Convert, ListsWhatAFileHolds) {
  const Sandbox box = sandbox();
  EXPECT_EQ(expect_done(box, {"convert", "level.csv", "--list"}).out,
            "Recording 1 of 1: level.csv\n"
            "    points    4, over time\n"
            "    rate      2000 Hz\n"
            "    start     0 s\n"
            "    end       0.0015 s\n"
            "    operator: A. Böhm\n"
            "  force: force, N\n"
            "    RMS 1.231, min -2, max 1\n"
            "  acc1: acceleration, m/s^2\n"
            "    RMS 5.482, min -9.807, max 4.903\n"
            "  ldv: no unit\n"
            "    RMS 2.739, min 1, max 4\n");
  EXPECT_EQ(box.content().size(), 1U);
}

/// A dataset 55 of two nodes with X, Y and Z.
std::string mode_shape(const std::string& form) {
  const std::string values = "  1.00000E+00  0.00000E+00 -5.00000E-01\n";
  return "    -1\n    55\nNONE\nNONE\nNONE\nNONE\nNONE\n" + form + "         1\n" + values +
         "         2\n" + values + "    -1\n";
}

std::string normal_mode(int number, const std::string& reals) {
  return mode_shape(
      "         1         2         2         8         2         3\n"
      "         2         4         0         " +
      std::to_string(number) + "\n" + reals + "\n");
}

const std::string kModes = normal_mode(1, "  5.58250E+01  1.00000E+00  1.20000E-03  0.00000E+00") +
                           normal_mode(2, "  1.53900E+02  1.00000E+00  0.00000E+00  4.00000E-03") +
                           mode_shape(
                               "         1         5         2         8         2         3\n"
                               "         2         1         0         3\n"
                               "  6.00000E+01\n");

const std::string kModesList =
    "3 datasets 55 (mode shapes)\n"
    "  mode 1: 55.825 Hz, damping 0.0012, 2 nodes\n"
    "  mode 2: 153.9 Hz, loss factor 0.004, 2 nodes\n"
    "  deflection 3: 60 Hz, 2 nodes\n";

TEST(Convert, ListsModeShapes) {
  const std::string geometry = "    -1\n    15\n         1\n    -1\n";
  const Sandbox box{{"level.csv", kLevel}, {"modes.unv", kModes}, {"nodes.unv", geometry}};
  EXPECT_EQ(expect_done(box, {"convert", "modes.unv", "--list"}).out, kModesList);
  expect_refused(box, {"convert", "modes.unv", "x.csv"},
                 {"modes.unv", "dataset 58", "found 3 datasets 55 (mode shapes)"});
  expect_refused(box, {"convert", "nodes.unv", "--list"}, {"nodes.unv", "found 1 dataset 15"});
  expect_refused(box, {"convert", "modes.unv", "--list", "--recording", "1"},
                 {"modes.unv", "found 3 datasets 55 (mode shapes)"});

  const std::string of_2414 = test::analysis_dataset(
      {.number = 4, .reals = {55.8, 1.0, 0.002, 0.0}}, Eigen::VectorXcd::Ones(2));
  const Sandbox newer{{"m.unv", kModes + of_2414}};
  EXPECT_EQ(
      expect_done(newer, {"convert", "m.unv", "--list"}).out,
      kModesList + "1 dataset 2414 (mode shapes)\n  mode 4: 55.8 Hz, damping 0.002, 2 nodes\n");
  expect_refused(newer, {"convert", "m.unv", "x.csv"},
                 {"found 3 datasets 55 (mode shapes), 1 dataset 2414 (results"});

  expect_done(box, {"convert", "level.csv", "both.uff"});
  const std::string recordings = expect_done(box, {"convert", "both.uff", "--list"}).out;
  box.put("both.uff", box.get("both.uff") + kModes);
  EXPECT_EQ(expect_done(box, {"convert", "both.uff", "--list"}).out, recordings + kModesList);
}

TEST(Convert, ListsWhatIsThereBesideADamagedModeShape) {
  const std::string damaged = mode_shape("x\n");
  const Sandbox box{{"damaged.unv", damaged}, {"modes.unv", damaged + kModes}};
  expect_refused(box, {"convert", "damaged.unv", "--list"}, {"damaged.unv:8"});
  const Outcome run = box.run({"convert", "modes.unv", "--list"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, kModesList);
  EXPECT_NE(run.err.find("microslip: warning: modes.unv:8"), std::string::npos) << run.err;
}

TEST(Convert, ListsOnSixtyColumns) {
  const std::string long_name(300, 'x');
  std::string comments;
  for (int i = 0; i < 50; ++i) comments += "# key" + std::to_string(i) + ": " + long_name + "\n";
  const Sandbox box{{"wide.csv", comments + "frequency [Hz],µ" + long_name + ".real [kg],µ" +
                                     long_name +
                                     ".imag [kg]\n1,-1e-300,0\n3,-1e-300,0\n4,2e300,5e305\n"}};
  const std::string text = expect_done(box, {"convert", "wide.csv", "--list"}).out;
  EXPECT_LE(widest(text), 60U) << text;
  EXPECT_NE(text.find("…"), std::string::npos);
  EXPECT_NE(text.find("and 38 more"), std::string::npos) << text;
  EXPECT_NE(text.find("spacing   uneven"), std::string::npos) << text;
  EXPECT_NE(text.find("magnitude RMS 2.887e+305"), std::string::npos) << text;
}

TEST(Convert, WritesCsvInSi) {
  const Sandbox box = sandbox();
  const Outcome run = expect_done(box, {"convert", "level.csv", "si.csv"});
  EXPECT_EQ(run.out, "si.csv: 1 recording, 3 channels\n");
  EXPECT_EQ(box.get("si.csv"),
            "# operator: A. Böhm\n"
            "time [s],force [N],acc1 [m/s^2],ldv\n"
            "0,1,0,1\n"
            "5e-04,-2,4.903325,2\n"
            "0.001,0.25,-9.80665,3\n"
            "0.0015,1,0,4\n");
  const std::string first = box.get("si.csv");
  expect_done(box, {"convert", "si.csv", "si.csv"});
  EXPECT_EQ(box.get("si.csv"), first) << "its own output, over itself";
}

TEST(Convert, ReadsAndWritesStandardFiles) {
  const Sandbox box;
  const Outcome run = expect_done(
      box, {"convert", "-", "-", "--channel", "acc1", "--channel=force"}, {.in = kLevel});
  EXPECT_NE(run.out.find("time [s],acc1 [m/s^2],force [N]\n0,0,1\n"), std::string::npos) << run.out;
}

TEST(Convert, ListsStandardInput) {
  const Sandbox box = sandbox();
  EXPECT_NE(expect_done(box, {"convert", "-", "--list"}, {.in = kLevel}).out.find("RMS 1.231"),
            std::string::npos);
}

TEST(Convert, AssumesUnits) {
  const Sandbox box{{"bare.csv", "time,force,acc1\n0,1,1\n1,2,2\n"}};
  expect_refused(box, {"convert", "bare.csv", "--list"},
                 {"bare.csv:1:1", "unit of time", "--assume-units time=s"});
  const Outcome run = expect_done(box, {"convert", "bare.csv", "-", "--assume-units", "time=ms",
                                        "--assume-units", "acc1=g", "--assume-units", "SI"});
  EXPECT_EQ(run.out, "time [s],force [N],acc1 [m/s^2]\n0,1,9.80665\n0.001,2,19.6133\n");
  expect_refused(
      box, {"convert", "bare.csv", "-", "--assume-units", "time=s", "--assume-units", "lvdt=mm"},
      {"lvdt", "'force', 'acc1'"});
}

TEST(Convert, TakesWhatIsThereOfAFileThatWasCut) {
  const Sandbox box{{"cut.csv", "time [s],a [N]\n0,1\n1,2\n2"}};
  expect_refused(box, {"convert", "cut.csv", "new.csv"}, {"cut.csv:4:1", "--allow-truncated"});
  const Outcome run = box.run({"convert", "cut.csv", "-", "--allow-truncated"});
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(run.out.starts_with("# warning: last_row_dropped: cut.csv:4: the last row"))
      << run.out;
  EXPECT_TRUE(run.out.ends_with("\ntime [s],a [N]\n0,1\n1,2\n")) << run.out;
  EXPECT_NE(run.err.find("microslip: warning: cut.csv:4: the last row"), std::string::npos);
  EXPECT_EQ(expect_done(box, {"convert", "cut.csv", "-", "--allow-truncated", "--quiet"}).out,
            run.out);
}

TEST(Convert, SaysAWarningOnceHoweverOftenAFileIsConverted) {
  const Sandbox box{{"a.csv", "time [s],x [m]\n0,1\n1,50\n2,2\n3,-50\n"}};
  const std::vector<std::string> names{"a.csv", "b.csv", "c.csv", "d.mat", "e.h5", "f.csv"};
  for (std::size_t i = 1; i < names.size(); ++i) {
    const Outcome run = box.run({"convert", names[i - 1], names[i], "--quiet"});
    EXPECT_EQ(run.status, 0) << run.err;
  }
  const std::string text = box.get("f.csv");
  const std::size_t first = text.find("# warning: implausible_value: a.csv: channel 'x'");
  ASSERT_NE(first, std::string::npos) << text;
  EXPECT_EQ(text.find("# warning", first + 1), std::string::npos) << text;
}

TEST(Convert, RefusesCallsThatMeanNothing) {
  const Sandbox box = sandbox();
  expect_refused(box, {"convert", "level.csv"}, {"out or --list", "convert --help"});
  expect_refused(box, {"convert", "level.csv", "x.csv", "--list"}, {"--list excludes out"});
  expect_refused(box, {"convert", "level.csv", "x.txt"}, {"x.txt", ".csv", "--format"});
  expect_refused(box, {"convert", "level.csv", "x.csv", "--format", "txt"},
                 {"--format", "uff-ascii"});
  expect_refused(box, {"convert", "level.csv", "x.csv", "--channel", "acc9"},
                 {"acc9", "'force', 'acc1', 'ldv'"});
  expect_refused(box, {"convert", "level.csv", "x.csv", "--recording", "2"},
                 {"--recording", "from 1 to 1", "--list"});
  expect_refused(box, {"convert", "none.csv", "x.csv"}, {"none.csv", "No such file"});
  expect_refused(box, {"convert", "level.csv:force", "x.csv"}, {"level.csv", "MATLAB"});
}

TEST(Convert, WritesOverNothingButItsKind) {
  const Sandbox box{{"level.csv", kLevel},
                    {"levels.csv", "amplitude [m],dissipation [J]\n1,1\n"},
                    {"notes.uff", "do not lose me\n"},
                    {"binary.csv", std::string("\x89HDF\r\n\x1A\n")}};
  expect_refused(box, {"convert", "level.csv", "levels.csv"}, {"levels.csv", "a table of levels"});
  expect_refused(box, {"convert", "level.csv", "notes.uff"},
                 {"notes.uff", "do not lose me", "a universal file"});
  expect_refused(box, {"convert", "level.csv", "binary.csv"}, {"binary.csv", "an HDF5 file"});
  expect_refused(box, {"convert", "level.csv", "none/x.uff"}, {"no folder 'none'"});
}

TEST(Convert, ShowsProgressOnATerminal) {
  std::string text = "time [s],a [N]\n";
  for (int i = 0; text.size() < 3'000'000; ++i) text += std::to_string(i) + ",0.5\n";
  const Sandbox box{{"long.csv", text}};
  const Outcome run = box.run({"convert", "long.csv", "out.csv"}, {.columns = 80});
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.out.find("reading ["), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("\r\033[Kout.csv: 1 recording"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace microslip::cli_test::convert_test
