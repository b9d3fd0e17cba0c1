// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "microslip/base/version.hpp"

namespace microslip::cli_test {
namespace {

/// The calls under "Example:" of a help text. A line that ends in \ goes on in the next.
std::vector<Arguments> examples(const std::string& help) {
  std::string text = help.substr(std::min(help.find("\nExample"), help.size() - 1) + 1);
  for (std::size_t i = text.find("\\\n"); i != std::string::npos; i = text.find("\\\n")) {
    text.erase(i, 2);
  }
  std::vector<Arguments> calls;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word) || word != "microslip") continue;
    calls.emplace_back();
    while (words >> word) calls.back().push_back(word);
  }
  return calls;
}

std::string help_of(const std::string& subcommand) {
  const Sandbox box;
  const Arguments call = subcommand.empty() ? Arguments{"--help"} : Arguments{subcommand, "--help"};
  const Outcome run = expect_done(box, call);
  EXPECT_NE(run.out.find("Usage: microslip " + subcommand), std::string::npos) << run.out;
  EXPECT_TRUE(box.content().empty());
  return run.out;
}

void expect_parts(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << "no '" << part << "' in\n" << text;
  }
}

TEST(Help, OfTheProgramNamesTheSubcommandsAndTheUnits) {
  expect_parts(help_of(""), {"identify", "loop", "dissipation", "demo", "SI", "--version"});
}

TEST(Help, OfEachSubcommandNamesColumnsAndUnits) {
  expect_parts(help_of("identify"),
               {"amplitude [m]", "dissipation [J]", "secant_stiffness [N/m]", "N/m",
                "slip_force [N]", "density [1/N]", "- is standard output"});
  expect_parts(help_of("loop"),
               {"displacement [m]", "normal_load [1]", "in m or with a unit", "standard output"});
  expect_parts(
      help_of("dissipation"),
      {"FROM:TO:COUNT[:log]", "in m or with units",
       "amplitude [m], force [N], dissipation [J], secant_stiffness [N/m], loss_factor [1]"});
  expect_parts(help_of("demo"), {"--out", "Folder"});
}

TEST(Help, IsForShortOptionsToo) {
  const Sandbox box;
  EXPECT_EQ(expect_done(box, {"-h"}).out, expect_done(box, {"--help"}).out);
}

TEST(Help, ExamplesRun) {
  const Sandbox box(
      {{"levels.csv", sample_levels_text()}, {"path.csv", "displacement [m]\n0\n1e-4\n-1e-4\n"}});
  for (const std::string subcommand : {"identify", "loop", "dissipation"}) {
    const std::vector<Arguments> calls = examples(help_of(subcommand));
    EXPECT_FALSE(calls.empty()) << subcommand;
    for (const Arguments& call : calls) {
      EXPECT_EQ(call.front(), subcommand);
      const Outcome run = box.run(call);
      EXPECT_EQ(run.status, 0) << typed(call) << "\n" << run.err;
    }
  }
}

TEST(Help, OfTheDemoHasAnExample) {
  const std::vector<Arguments> calls = examples(help_of("demo"));
  ASSERT_FALSE(calls.empty());
  EXPECT_EQ(calls.front().front(), "demo");
}

TEST(Version, IsPrinted) {
  const Sandbox box;
  EXPECT_EQ(expect_done(box, {"--version"}).out, "microslip " + std::string(kVersion) + "\n");
}

}  // namespace
}  // namespace microslip::cli_test
