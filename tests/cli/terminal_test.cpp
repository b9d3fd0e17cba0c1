// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <sstream>
#include <string>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"

/// The progress bar: on a terminal and nowhere else.

namespace microslip::cli_test::terminal_test {
namespace {

constexpr const char* kBack = "\r";
constexpr const char* kErase = "\033[K";

Sandbox sandbox() { return Sandbox{{"levels.csv", sample_levels_text()}}; }

Arguments bands(const Arguments& more = {}) {
  Arguments all{"identify", "levels.csv", "--stiffness", "1.7e5",
                "--out",    "joint.json", "--bands",     "200"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// The longest stretch between returns of the cursor before the summary, in places.
std::size_t widest(std::string shown) {
  shown = shown.substr(0, shown.find("Identified joint"));
  std::size_t width = 0;
  std::istringstream stream(shown);
  for (std::string part; std::getline(stream, part, *kBack);) {
    for (std::size_t i = part.find(kErase); i != std::string::npos; i = part.find(kErase)) {
      part.erase(i, 3);
    }
    width = std::max(width, part.size());
  }
  return width;
}

TEST(Terminal, ShowsProgress) {
  const Sandbox box = sandbox();
  const Outcome run = box.run(bands(), {.columns = 80});
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.out.find("bands ["), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("100 %"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("s left"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("\r\033[KIdentified joint"), std::string::npos)
      << "the bar is gone before the summary";
}

TEST(Terminal, MayBeNarrow) {
  for (const unsigned short columns : std::initializer_list<unsigned short>{80, 40, 20, 10, 2}) {
    const Sandbox box = sandbox();
    const Outcome run = box.run(bands(), {.columns = columns});
    EXPECT_EQ(run.status, 0);
    EXPECT_LT(widest(run.out), columns) << "the bar breaks the line:\n" << run.out;
  }
}

TEST(Terminal, OfUnknownWidth) {
  const Sandbox box = sandbox();
  const Outcome run = box.run(bands(), {.columns = 0});
  EXPECT_EQ(run.status, 0);
  EXPECT_LT(widest(run.out), 80U);
}

TEST(Terminal, IsLeftAloneWhenQuiet) {
  const Sandbox box = sandbox();
  EXPECT_EQ(box.run(bands({"--quiet"}), {.columns = 80}).out, "");
}

TEST(Terminal, ElseThereIsNoBar) {
  const Sandbox box = sandbox();
  const Outcome run = expect_done(box, bands());
  EXPECT_EQ(run.out.find(kBack), std::string::npos);
}

TEST(Terminal, ShowsAMessageOnce) {
  const Sandbox box = sandbox();
  const Outcome run =
      box.run({"identify", "none.csv", "--stiffness", "1", "--out", "j.json"}, {.columns = 40});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out,
            "microslip: none.csv: cannot be read: No such file or directory. Check the "
            "path.\r\n");
}

/// The longest line of the descriptions, in characters; options and examples are as they must be
/// typed.
std::size_t longest_line(const std::string& help) {
  std::size_t longest = 0;
  std::istringstream stream(help.substr(0, help.find("Example")));
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("Usage") || line.starts_with("  -")) continue;
    std::erase_if(line, [](char c) { return c == '\r' || (c & 0xC0) == 0x80; });
    longest = std::max(longest, line.size());
  }
  return longest;
}

TEST(Terminal, BreaksTheHelpBetweenWords) {
  const Sandbox box;
  for (const std::string command : {"identify", "measure", "march", "plot", "report"}) {
    EXPECT_LE(longest_line(expect_done(box, {command, "--help"}).out), 80U) << command;
    const Outcome narrow = box.run({command, "--help"}, {.columns = 46});
    EXPECT_EQ(narrow.status, 0);
    EXPECT_LE(longest_line(narrow.out), 46U) << narrow.out;
  }
}

}  // namespace
}  // namespace microslip::cli_test::terminal_test
