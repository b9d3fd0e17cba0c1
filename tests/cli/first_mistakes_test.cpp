// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "support/replaced.hpp"

/// What goes wrong at first, with the files of the three sessions of README.md: the message says
/// where, what, why and what to do.

namespace microslip::cli_test::first_mistakes_test {
namespace {

using Parts = std::vector<std::string>;

const std::string kReference = MICROSLIP_EXAMPLES "/reference_rig/";

Sandbox sandbox() {
  return {{"levels.csv", sample_levels_text()},
          {"joint.json", kJointText},
          {"rig.toml", test::get(kReference + "rig.toml")},
          {"model.toml", test::get(MICROSLIP_EXAMPLES "/one_mass/model.toml")}};
}

struct Mistake {
  std::string content;
  Parts parts;
};

/// Each content in place of the file.
void expect_all_refused(const std::string& file, const Arguments& call,
                        const std::vector<Mistake>& mistakes) {
  const Sandbox box = sandbox();
  for (const Mistake& mistake : mistakes) {
    box.put(file, mistake.content);
    expect_refused(box, call, mistake.parts);
  }
}

TEST(FirstMistakes, InTablesOfLevels) {
  const Arguments identify{"identify", "l.csv", "--stiffness", "1.7e5", "--out", "new.json"};
  const std::string header = "amplitude [m],dissipation [J]\n";
  expect_all_refused(
      "l.csv", identify,
      {{header + "1e-5,1e-8\n2e-5,12.Mar\n", {"l.csv:3:6", "'12.Mar'", "looks like a date"}},
       {header + "1e-5,1e-8\n2e-5,12/03/2024\n", {"l.csv:3:6", "looks like a date"}},
       {header + "1e-5,1e-8\n2e-5,#DIV/0!\n", {"l.csv:3:6", "Correct the cell"}},
       {header + "-5.1,-8.2\n-5.0,-8.1\n", {"l.csv:2:1", "'-5.1'", "Logarithms are not taken."}},
       {"amplitude [m] dissipation [J]\n1e-5 1e-8\n",
        {"l.csv:1:1", "Separate columns by commas, semicolons or tabs."}},
       {"Test of Monday\namplitude [m],dissipation [J]\n1e-5,1e-8\n",
        {"l.csv:2:1", "lines above the header begin with '#'"}},
       {"Test of Monday\n1e-5\n",
        {"l.csv:1:1", "'Test of Monday'", "Lines above it begin with '#'"}}});
}

TEST(FirstMistakes, InRecords) {
  const Arguments identify{"identify", "r.csv", "--out", "new.json"};
  expect_all_refused("r.csv", identify,
                     {{"time [s],gap [um],load [kN]\n00:00:01.0,1,2\n00:00:02.0,2,3\n",
                       {"r.csv:2:1", "'00:00:01.0'", "Write times in seconds"}}});
  expect_all_refused(
      "r.csv", {"convert", "r.csv", "--list"},
      {{"Logger 3\ntime [s],force [N]\n0,1\n1\n",
        {"r.csv:1:1", "'Logger 3'", "Lines above it begin with '#'."}},
       {"gap [um],load [kN]\n1,2\n2,3\n", {"r.csv:1:1", "a column of time such as 'time [s]'"}}});
}

TEST(FirstMistakes, InDescriptionsOfRigs) {
  const std::string rig = test::get(kReference + "rig.toml");
  const auto changed = [&](const std::string& from, const std::string& to) {
    return test::replaced(rig, from, to);
  };
  expect_all_refused(
      "rig.toml", {"measure", "rig.toml", "--out", "made"},
      {{changed("7850.0", "7.85"), {"beam.mass_density", "= 7.85", "25 or more", "no g/cm^3"}},
       {changed("2.07e11", "207"), {"beam.youngs_modulus", "= 207", "1e+06 or more", "no GPa"}},
       {changed("length_m = 0.583", "length_m = 583"), {"duration", "units of the beam"}},
       {changed("count = 90", "count = 90.0"), {"count = 90", "without a decimal point"}},
       {changed("length_m = 0.583", "length_m = 0,583"), {"rig.toml:5:13", "decimal point"}},
       {changed("schema = \"microslip.rig/1\"\n", ""), {"'schema'", "docs/file_formats.md"}},
       {"\xFF\xFE" + rig, {"rig.toml", "UTF-16", "Save it as UTF-8."}}});
}

TEST(FirstMistakes, InLoads) {
  expect_all_refused("f.csv", {"march", "model.toml", "--force-file", "f.csv", "--out", "new.csv"},
                     {{"time [s],load [N]\n0,0\n1,1\n",
                       {"f.csv", "a column 'force [N]'", "the columns 'time', 'load'"}}});
}

struct Typed {
  Arguments call;
  Parts parts;
};

TEST(FirstMistakes, InCalls) {
  const Sandbox box = sandbox();
  box.put("page.html", "<html><body></body></html>");
  const std::vector<Typed> all{
      {{"identify", "levels.csv", "--stiffness", "--out", "j.json"},
       {"--stiffness has no value", "--out"}},
      {{"identify", "levels.csv", "--stiffness", "1,7e5", "--out", "j.json"},
       {"--stiffness = '1,7e5'", "decimal point", "Write 1.7e5."}},
      {{"loop", "joint.json", "--amplitude", "9", "um", "--out", "l.csv"},
       {"'um' stands alone", "without a space"}},
      {{"frf", "model.toml", "--force", "1", "--frequency", "14-18", "--out", "f.csv"},
       {"--frequency = '14-18'", "FROM:TO", "colon"}},
      {{"frf", "model.toml", "--force", "1", "--frequency", "88rad/s:113rad/s", "--out", "f.csv"},
       {"'rad/s'", "1 Hz is 2 pi rad/s"}},
      {{"identify", "level_*.csv", "--stiffness", "1e5", "--out", "j.json"},
       {"level_*.csv", "No file fits this pattern"}},
      {{"verify", "page.html", "levels.csv", "--out", "v.csv"},
       {"page.html: expected TOML, found an HTML page"}},
      {{"identify", "'levels.csv'", "--stiffness", "1e5", "--out", "j.json"},
       {"quotes are part of the name"}}};
  for (const Typed& one : all) expect_refused(box, one.call, one.parts);
}

// Reported on the screen and in the file.
TEST(FirstMistakes, AJointThatMovesByMetresIsDoubted) {
  const Sandbox box = sandbox();
  for (const Arguments& call :
       {Arguments{"dissipation", "joint.json", "--amplitude", "1:300:50", "--out", "x.csv"},
        Arguments{"loop", "joint.json", "--amplitude", "9", "--out", "l.csv"}}) {
    const Outcome run = box.run(call);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.err.find("no structure survives"), std::string::npos) << run.err;
    EXPECT_NE(box.get(call.back()).find("no structure survives"), std::string::npos);
  }
}

}  // namespace
}  // namespace microslip::cli_test::first_mistakes_test
