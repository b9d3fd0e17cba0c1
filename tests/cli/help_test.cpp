// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "cli/models.hpp"
#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "cli/shown_calls.hpp"
#include "microslip/base/version.hpp"

namespace microslip::cli_test::help_test {
namespace {

/// The calls under "Example:" of a help text.
std::vector<Arguments> examples(const std::string& help) {
  return shown_calls(help.substr(std::min(help.find("\nExample"), help.size() - 1) + 1));
}

std::string help_of(const std::string& subcommand) {
  const Sandbox box;
  const Arguments call = subcommand.empty() ? Arguments{"--help"} : Arguments{subcommand, "--help"};
  const Outcome run = expect_done(box, call);
  EXPECT_NE(run.out.find("Usage: microslip " + subcommand), std::string::npos) << run.out;
  EXPECT_TRUE(box.content().empty());
  return run.out;
}

/// Without the breaks of its lines.
std::string flowing(const std::string& help) {
  std::istringstream stream(help);
  std::string text;
  for (std::string word; stream >> word;) text += (text.empty() ? "" : " ") + word;
  return text;
}

void expect_parts(const std::string& text, const std::vector<std::string>& parts) {
  const std::string flow = flowing(text);
  for (const std::string& part : parts) {
    EXPECT_NE(flow.find(part), std::string::npos) << "no '" << part << "' in\n" << text;
  }
}

TEST(Help, OfTheProgramNamesTheSubcommandsAndTheUnits) {
  expect_parts(help_of(""), {"measure", "reduce", "identify", "verify", "model", "ringdown",
                             "convert", "loop", "dissipation", "frf", "backbone", "march", "demo",
                             "report", "plot", "SI", "--version"});
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
  expect_parts(help_of("ringdown"), {"time [s]", "amplitude [m]", "dissipation [J]",
                                     "LOW:HIGH [Hz]", "[kg]", "- is standard output"});
  expect_parts(help_of("measure"), {"rig.toml", "[test]", "--format", "--seed", "--no-shaker"});
  expect_parts(help_of("reduce"),
               {"rig.toml", "frequency [Hz], force [N], acceleration [m/s^2], phase [rad]",
                "FILE.mat:VARIABLE", "CHANNEL=UNIT", "- is standard output"});
  expect_parts(help_of("frf"), {"model.toml", "FROM:TO, in Hz or with units", "in N or with a unit",
                                "frequency [Hz], force [N], displacement [m], phase [rad]"});
  expect_parts(help_of("backbone"),
               {"model.toml", "FROM:TO:COUNT[:log]", "in m or with units",
                "displacement [m], force [N], frequency [Hz], damping_ratio [1]"});
  expect_parts(help_of("march"),
               {"model.toml", "time [s], force [N]", "normal_load [1]", "in s or with a unit",
                "JOINT displacement [m], JOINT force [N]", "- is standard output"});
  expect_parts(help_of("convert"), {"CHANNEL=UNIT", "--list", ".hdf5", "- is standard"});
  expect_parts(help_of("demo"), {"--out", "Folder"});
  expect_parts(help_of("plot"), {"IN", "--figure", "energies", "constant-response", "--width-mm",
                                 "--grey", "svg", "- is standard"});
  expect_parts(help_of("report"), {"DIR", "levels.csv", "--out", "--no-pictures"});
}

TEST(Help, OfEachSubcommandHasQuiet) {
  const Sandbox box;
  std::istringstream lines(help_of(""));
  std::size_t count = 0;
  bool listed = false;
  for (std::string line; std::getline(lines, line);) {
    if (listed && line.starts_with("  ") && line[2] != ' ') {
      const std::string subcommand = line.substr(2, line.find(' ', 2) - 2);
      EXPECT_NE(help_of(subcommand).find("--quiet"), std::string::npos) << subcommand;
      ++count;
    }
    listed = line.starts_with("Subcommands:") || (listed && !line.empty());
  }
  EXPECT_GE(count, 14U);
}

TEST(Help, IsForShortOptionsToo) {
  const Sandbox box;
  EXPECT_EQ(expect_done(box, {"-h"}).out, expect_done(box, {"--help"}).out);
}

TEST(Help, IsASubcommandToo) {
  const Sandbox box;
  EXPECT_EQ(expect_done(box, {"help"}).out, expect_done(box, {"--help"}).out);
  EXPECT_EQ(expect_done(box, {"help", "frf"}).out, expect_done(box, {"frf", "--help"}).out);
  const Outcome unknown = box.run({"help", "frff"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("did you mean frf?"), std::string::npos) << unknown.err;
}

/// A decay as two accelerometers see it.
std::string seen_twice(const std::string& decay) {
  std::istringstream lines(decay);
  std::string text = "time [s],acc1 [m/s^2],acc2 [m/s^2]\n";
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) text += line + line.substr(line.find(',')) + "\n";
  return text;
}

/// Levels as three assemblies have them, all alike.
std::string of_three_assemblies(const std::string& levels) {
  std::istringstream lines(levels);
  std::string line;
  std::getline(lines, line);
  std::string text = line + ",assembly\n";
  while (std::getline(lines, line)) {
    for (const char* name : {"first", "second", "third"}) text += line + "," + name + "\n";
  }
  return text;
}

TEST(Help, ExamplesRun) {
  const Sandbox box({{"levels.csv", "# microslip 0.1.0: may be replaced\n" + sample_levels_text()},
                     {"campaign.csv", of_three_assemblies(sample_levels_text())},
                     {"path.csv", "displacement [m]\n0\n1e-4\n-1e-4\n"},
                     {"record.csv", record_text(sample_record())},
                     {"decay.csv", sample_decay_text()},
                     {"model.toml", test::get(MICROSLIP_TEST_DATA "/two_joints/model.toml")},
                     {"blow.csv", seen_twice(sample_decay_text({.frequency = 33.2}))}});
  for (const std::string subcommand : {"identify", "loop", "dissipation", "ringdown"}) {
    const std::vector<Arguments> calls = examples(help_of(subcommand));
    EXPECT_FALSE(calls.empty()) << subcommand;
    for (const Arguments& call : calls) {
      EXPECT_EQ(call.front(), subcommand);
      const Outcome run = box.run(call);
      EXPECT_EQ(run.status, 0) << typed(call) << "\n" << run.err;
    }
  }
}

TEST(Help, ExamplesWithModelsRun) {
  for (const std::string subcommand : {"frf", "backbone", "march"}) {
    const std::vector<Arguments> calls = examples(help_of(subcommand));
    EXPECT_FALSE(calls.empty()) << subcommand;
    const Sandbox box = one_mass();
    box.put("force.csv", "time [s],force [N]\n0,0\n1,0.1\n3,0\n");
    std::string model = box.get("model.toml");
    const std::string key = "damping_ratio";
    model.insert(model.find(key), "frequency_std = [0.01]\n");  // what draws may vary
    box.put("model.toml", model);
    box.put("shaken.toml",
            "schema = \"microslip.model/1\"\n[structure]\nfrequency_Hz = [50.0]\n"
            "damping_ratio = [0.02]\n[[structure.point]]\nname = \"mass\"\nshape = [1.0]\n"
            "[[structure.base]]\nname = \"table\"\nparticipation = [1.0]\n"
            "point_motion = [1.0]\n[excitation]\nbase = \"table\"\n"
            "[response]\npoint = \"mass\"\n");
    for (const Arguments& call : calls) {
      const Outcome run = box.run(call);
      EXPECT_EQ(run.status, 0) << typed(call) << "\n" << run.err;
    }
  }
}

/// The pattern of a shell.
Arguments expanded(const Arguments& call) {
  Arguments result;
  for (const std::string& word : call) {
    if (word == "level_*.csv") {
      result.insert(result.end(), {"level_1.csv", "level_2.csv"});
    } else if (word == "mode1_*.csv") {
      result.emplace_back("mode1_1.csv");
    } else {
      result.push_back(word);
    }
  }
  return result;
}

TEST(Help, ExamplesWithRecordingsRun) {
  const std::string rig = MICROSLIP_EXAMPLES "/reference_rig/";
  const std::string structure = MICROSLIP_TEST_DATA "/two_joints/";
  const std::string modes = MICROSLIP_EXAMPLES "/brake_reuss_beam/rig.toml";
  for (const std::string subcommand : {"convert", "reduce"}) {
    const std::vector<Arguments> calls = examples(help_of(subcommand));
    EXPECT_FALSE(calls.empty()) << subcommand;
    const Sandbox box({{"rig.toml", test::get(rig + "rig.toml")},
                       {"modes.toml", test::get(modes)},
                       {"level_1.csv", test::get(rig + "recordings/level_01.csv")},
                       {"level_2.csv", test::get(rig + "recordings/level_12.csv")},
                       {"model.toml", test::get(structure + "model.toml")},
                       {"mode1_1.csv", test::get(structure + "recordings/mode1_level16.csv")},
                       {"logger.csv", "time,acc1\n0,1\n0.5,0\n1,-1\n"},
                       {"sweep.csv",
                        "frequency [Hz],force [N],acceleration [m/s^2],phase [deg]\n"
                        "80.2,1,40,-80\n80.4,1,41,-100\n"}});
    expect_done(box, {"convert", "level_1.csv", "test.h5", "--quiet"});
    for (const Arguments& call : calls) {
      const Outcome run = box.run(expanded(call));
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
}  // namespace microslip::cli_test::help_test
