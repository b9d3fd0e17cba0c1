// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "cli/writings.hpp"

/// What stands under the name of an output is replaced only where this program wrote it: a file of
/// the same kind from a laboratory, or one written by hand, stays.

namespace microslip::cli_test::replacing_test {
namespace {

namespace fs = std::filesystem;

/// A file as another program would write it: the same without the mark of this one.
std::string without_mark(std::string text) {
  constexpr std::string_view kName = "microslip";
  for (const std::string_view before :
       {std::string_view("# "), std::string_view("\"program\": \""), std::string_view("\n"),
        std::string_view("written by "), std::string_view("Produced by "),
        std::string_view("Software\0", 9), std::string_view("/Producer ("),
        std::string_view("content=\"")}) {
    const std::string mark = std::string(before) + std::string(kName);
    for (std::size_t at = text.find(mark); at != text.npos; at = text.find(mark, at)) {
      text.replace(at + before.size(), kName.size(), "other one");
    }
  }
  return text;
}

class Replacing : public ::testing::TestWithParam<Writing> {};

TEST_P(Replacing, ItsOwnFileAndNoOther) {
  const Sandbox box;
  put_inputs(box);
  const Writing& writing = GetParam();
  ASSERT_EQ(box.run(writing.call).status, 0);
  const std::string own = box.get(writing.out);
  const Outcome again = box.run(writing.call);
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(box.get(writing.out), own);

  const std::string foreign = without_mark(own);
  if (writing.out == "rec.h5") return;  // its schema is its mark: no other program writes it
  const bool is_recording = writing.call.front() == "convert";
  if (is_recording && foreign == own) return;  // of CSV no mark is needed, see below
  ASSERT_NE(foreign, own) << writing.out << " bears no mark";
  box.put(writing.out, foreign);
  const auto before = box.content();
  const Outcome refused = box.run(writing.call);
  EXPECT_EQ(refused.status, 2) << refused.err;
  EXPECT_NE(refused.err.find(writing.out.substr(0, writing.out.find('/'))), std::string::npos)
      << refused.err;
  EXPECT_TRUE(box.content() == before) << refused.err;
}

INSTANTIATE_TEST_SUITE_P(EachFormat, Replacing, ::testing::ValuesIn(all_writings()),
                         [](const auto& each) {
                           std::string name = each.param.out;
                           std::ranges::replace_if(
                               name, [](char c) { return std::isalnum(c) == 0; }, '_');
                           return name;
                         });

std::string recording_text(int scale) {
  std::string text = "time [s],force [N],acc1 [m/s^2]\n";
  for (int i = 0; i < 10; ++i) {
    text += "0.00" + std::to_string(i) + "," + std::to_string(scale * i % 7) + ",1\n";
  }
  return text;
}

// The shell makes `convert level_1.csv level_2.csv` of the pattern.
TEST(Replacing, NoSecondRecordingOfAPattern) {
  const Sandbox box{{"level_1.csv", recording_text(1)}, {"level_2.csv", recording_text(2)}};
  expect_refused(box, {"convert", "level_1.csv", "level_2.csv"},
                 {"level_2.csv", "another content", "another name", "--replace"});
  for (const char* ending : {".uff", ".mat", ".h5"}) {
    const std::string first = std::string("1") + ending;
    const std::string second = std::string("2") + ending;
    expect_done(box, {"convert", "level_1.csv", first});
    expect_done(box, {"convert", "level_2.csv", second});
    expect_refused(box, {"convert", first, second}, {second, "another content", "--replace"});
    expect_done(box, {"convert", first, second, "--replace"});
  }
  expect_done(box, {"convert", "level_1.csv", "level_2.csv", "--replace"});
  EXPECT_NE(box.get("level_2.csv"), recording_text(2));
  expect_done(box, {"convert", "level_1.csv", "level_2.csv"});
}

// Recordings in CSV have the columns, and the lines above them, of their writers.
TEST(Replacing, ARecordingOfOtherColumnsWhereItIsGivenUp) {
  const Sandbox box{{"in.csv", recording_text(1)},
                    {"other.csv", "time [s],b [N]\n0,1\n1,2\n2,1\n"},
                    {"logger.csv", "Logger 7\nOperator,N.N.\ntime [s],b [N]\n0,1\n1,2\n2,1\n"},
                    {"notes.csv", "my notes\nline\n"},
                    {"levels.csv", sample_levels_text()}};
  expect_refused(box, {"convert", "in.csv", "notes.csv", "--replace"},
                 {"notes.csv", "is no recording"});
  for (const char* out : {"other.csv", "logger.csv"}) {
    expect_refused(box, {"convert", "in.csv", out}, {out, "exists"});
    expect_done(box, {"convert", "in.csv", out, "--replace", "--quiet"});
    EXPECT_NE(box.get(out).find("acc1"), std::string::npos);
  }
  expect_refused(box, {"convert", "in.csv", "levels.csv", "--replace"},
                 {"levels.csv", "is no recording"});
}

TEST(Replacing, NoFileWrittenByHand) {
  const Sandbox box{{"levels.csv", sample_levels_text()},
                    {"joint.json", kJointText},
                    {"loop.csv", "displacement [m],force [N]\n0,0\n1e-6,0.1\n"},
                    {"density.csv", "# by microslip 0.1\nslip_force [N],density [1/N]\n0,0.1\n"}};
  const std::string rule = "was not written by microslip";
  expect_refused(box, {"identify", "levels.csv", "--stiffness", "1.7e5", "--out", "joint.json"},
                 {"joint.json", rule, "Move it away"});
  expect_refused(box, {"loop", "joint.json", "--amplitude", "9um", "--out", "loop.csv"},
                 {"loop.csv", rule});
  expect_refused(box,
                 {"identify", "levels.csv", "--stiffness", "1.7e5", "--out", "j.json",
                  "--density-csv", "density.csv"},
                 {"density.csv", rule});
}

}  // namespace
}  // namespace microslip::cli_test::replacing_test
