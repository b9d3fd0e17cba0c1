// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"

/// Files that are at fault: each is refused with its place, what was found, the rule and, where
/// there is one, the remedy.

namespace microslip::cli_test::bad_input_test {
namespace {

using Parts = std::vector<std::string>;

const std::string kHeader = "amplitude [m],dissipation [J]\n";

struct BadFile {
  std::string name;
  std::string content;
  Parts parts;
};

void expect_levels_refused(const std::string& content, const Parts& parts,
                           const Arguments& more = {}) {
  const Sandbox box{{"levels.csv", content}};
  Arguments arguments{"identify", "levels.csv", "--stiffness",   "1e5",
                      "--out",    "joint.json", "--density-csv", "d.csv"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  expect_refused(box, arguments, parts);
}

void expect_joint_refused(const std::string& content, const Parts& parts) {
  const Sandbox box{{"joint.json", content}};
  expect_refused(box, {"dissipation", "joint.json", "--amplitude", "1um:9um:3", "--out", "c.csv"},
                 parts);
  expect_refused(box, {"loop", "joint.json", "--amplitude", "1um", "--out", "loop.csv"}, parts);
}

std::string joint_with(const std::string& density) {
  return R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 1e5, "density": [)" + density +
         "]}";
}

std::string repeated(const std::string& text, std::size_t count) {
  std::string result;
  result.reserve(text.size() * count);
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

TEST(BadLevels, ThatAreNoTable) {
  expect_levels_refused("", {"levels.csv", "an empty file", "amplitude [m],dissipation [J]"});
  expect_levels_refused("\n# only this\n\n", {"levels.csv", "comments"});
  expect_levels_refused(std::string("\x01\x00\xFF\xFE\x00", 5), {"levels.csv:1:2", "0x00"});
  expect_levels_refused(
      "\x7F"
      "ELF\x02\x01",
      {"levels.csv:1:1", "0x7F"});
  expect_levels_refused(std::string("a [m],b [J]\n1,\x00\n", 16), {"levels.csv:2:3", "0x00"});
  expect_levels_refused(kJointText, {"levels.csv", "a joint (joint.json)"});
  expect_levels_refused("\x89PNG\r\n\x1A\n", {"levels.csv", "PNG"});
  expect_levels_refused("PK\x03\x04xlsx", {"levels.csv"});
}

TEST(BadLevels, OfAWrongForm) {
  expect_levels_refused(kHeader, {"levels.csv:2:1", "a row of values"});
  expect_levels_refused("1,2\n3,4\n", {"levels.csv:1:1", "header", "row of numbers"});
  expect_levels_refused(kHeader + "1e-6,1e-9\n2e-6\n", {"levels.csv:3", "2 cells", "found 1"});
  expect_levels_refused(kHeader + "1e-6,1e-9,5\n", {"levels.csv:2", "2 cells", "found 3"});
  expect_levels_refused("amplitude [m],amplitude [m],dissipation [J]\n1,1,1\n",
                        {"levels.csv:1", "amplitude"});
  expect_levels_refused(kHeader + "\"1e-6,1e-9\n", {"levels.csv:2:1", "closing quote"});
}

TEST(BadLevels, WithABadCell) {
  expect_levels_refused(kHeader + "1e-6,nan\n", {"levels.csv:2:6", "finite number", "'nan'"});
  expect_levels_refused(kHeader + "1e-6,inf\n", {"levels.csv:2:6", "finite number", "'inf'"});
  expect_levels_refused(kHeader + "1e-6,1e999\n", {"levels.csv:2:6", "'1e999'"});
  expect_levels_refused(kHeader + "1e-6,abc\n", {"levels.csv:2:6", "'dissipation [J]'", "'abc'"});
  expect_levels_refused(kHeader + "1e-6,\n", {"levels.csv:2:6", "an empty cell"});
  expect_levels_refused(kHeader + "1e-6,1e-9\n-2e-6,1e-9\n",
                        {"levels.csv:3:1", "above 0", "'-2e-6'", "remove the row"});
  expect_levels_refused(kHeader + "0,1e-9\n", {"levels.csv:2:1", "above 0", "'0'"});
  expect_levels_refused(kHeader + "1e-6,-1e-9\n", {"levels.csv:2:6", "0 or more", "'-1e-9'"});
}

TEST(BadLevels, BeyondEveryJoint) {
  expect_levels_refused(
      kHeader + "1e-6,1e-9\n1e7,1e-8\n",
      {"levels.csv:3: expected amplitude from 1e-15 to 1e+06 m", "1e+07", "unit"});
  expect_levels_refused(kHeader + "1e-20,1e-9\n", {"levels.csv:2: ", "amplitude", "1e-20"});
  expect_levels_refused(kHeader + "1e-6,1e300\n", {"levels.csv:2: ", "dissipation", "1e+300"});
  expect_levels_refused(kHeader + "1e-6,1e-200\n",
                        {"levels.csv:2: ", "dissipation 0 or from 1e-30", "1e-200"});
  const std::string head = "amplitude [m],dissipation [J],";
  expect_levels_refused(
      head + "secant_stiffness [N/m],secant_stiffness_std [N/m]\n1e-6,1e-9,1e5,1e-200\n",
      {"levels.csv:2: ", "secant_stiffness_std 0 or from", "1e-200"});
}

TEST(BadLevels, WithABadOptionalColumn) {
  const std::string head = "amplitude [m],dissipation [J],";
  expect_levels_refused(head + "dissipation_std [J]\n1e-6,1e-9,-1\n",
                        {"levels.csv:2:11", "0 or more", "'-1'"});
  expect_levels_refused(head + "secant_stiffness [N/m]\n1e-6,1e-9,0\n",
                        {"levels.csv:2:11", "above 0", "'0'"});
  expect_levels_refused(head + "secant_stiffness [N]\n1e-6,1e-9,1\n",
                        {"levels.csv:1:31", "stiffness", "'N'", "N/m"});
  expect_levels_refused(head + "amplitude_std\n1e-6,1e-9,1\n",
                        {"levels.csv:1:31", "'amplitude_std'", "Write 'amplitude_std [m]'"});
}

TEST(BadLevels, WithoutTheRightUnits) {
  expect_levels_refused("amplitude,dissipation [J]\n1,1\n",
                        {"levels.csv:1:1", "length", "Write 'amplitude [m]'"});
  expect_levels_refused("amplitude [furlong],dissipation [J]\n1,1\n",
                        {"levels.csv:1:1", "unknown unit 'furlong'", "mm"});
  expect_levels_refused("amplitude [m],dissipation [N]\n1,1\n",
                        {"levels.csv:1:15", "'N', a unit of force", "J, mJ"});
  expect_levels_refused("amplitude [g],dissipation [J]\n1,1\n",
                        {"levels.csv:1:1", "acceleration", "length"});
  expect_levels_refused("displacement [m],dissipation [J]\n1,1\n",
                        {"levels.csv:1:1", "'amplitude [m]'", "displacement, dissipation"});
}

TEST(BadLevels, WithAFieldOfTenMegabytes) {
  constexpr std::size_t kMany = 10'000'000;
  expect_levels_refused(kHeader + "1e-6," + std::string(kMany, '9') + "\n",
                        {"levels.csv:2:6", "10000000 bytes"});
  expect_levels_refused(kHeader + "1e-6," + std::string(kMany, 'x') + "\n",
                        {"levels.csv:2:6", "10000000 bytes"});
  expect_levels_refused(std::string(kMany, 'x'), {"levels.csv:1:1"});
}

TEST(BadLevels, TooFewOfThem) {
  for (const Arguments& more : {Arguments{}, Arguments{"--linear-damping", "fit"}}) {
    expect_levels_refused(kHeader + "1e-6,1e-9\n", {"levels.csv: number of", "= 1", "4 or more"},
                          more);
  }
  expect_levels_refused(kHeader + "1e-6,1e-9\n", {"levels.csv: number of", "= 1", "at least 3"},
                        {"--fit", "uniform"});
  expect_levels_refused(kHeader + "1e-6,1e-9\n2e-6,1e-8\n", {"levels.csv: number of", "= 2"});
  expect_levels_refused(repeated(kHeader, 1) + repeated("1e-6,1e-9\n", 9),
                        {"levels.csv: number of", "= 1"});
  for (const std::string method : {"spline", "differences"}) {
    expect_levels_refused(kHeader + "1e-6,1e-9\n", {"levels.csv: number of", "= 1", "at least"},
                          {"--method", method});
  }
}

TEST(BadLevels, WithoutAnyDissipation) {
  expect_levels_refused(kHeader + "1e-6,0\n2e-6,0\n3e-6,0\n4e-6,0\n5e-6,0\n",
                        {"levels.csv:2: ", "dissipation above 0", "0 at all 5 levels"});
}

TEST(BadLevels, ThatCannotBeRead) {
  const Sandbox box{{"k.csv", "x"}};
  const Arguments rest{"--stiffness", "1e5", "--out", "joint.json"};
  const auto call = [&](const std::string& levels) {
    Arguments all{"identify", levels};
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
  };
  expect_refused(box, call("none.csv"), {"none.csv", "No such file", "Check the path."});
  expect_refused(box, call("."), {".: is a folder"});
  expect_refused(box, call("k.csv/levels.csv"), {"k.csv/levels.csv", "a file, not a folder"});
  expect_refused(box, call(""), {"cannot be read"});
  expect_refused(box, call("a\nb\x1B[31m.csv"), {"a?b?[31m.csv"});
  expect_refused(box, call("-"), {"standard input", "an empty file"});
  expect_refused(box, call(std::string(300, 'x')), {"File name too long"});
}

TEST(BadPath, IsRefused) {
  const std::vector<BadFile> files{
      {"empty", "", {"path.csv", "an empty file"}},
      {"column", "x [m]\n1\n", {"path.csv:1:1", "'displacement [m]'", "'x'"}},
      {"unit", "displacement\n1\n", {"path.csv:1:1", "Write 'displacement [m]'"}},
      {"wrong unit", "displacement [N]\n1\n", {"path.csv:1:1", "'N', a unit of force"}},
      {"text", "displacement [m]\n0\nx\n", {"path.csv:3:1", "finite number", "'x'"}},
      {"negative load",
       "displacement [m],normal_load [1]\n0,1\n1e-6,-0.5\n",
       {"path.csv:3:6", "0 or more", "'-0.5'", "normal load"}},
      {"load in N",
       "displacement [m],normal_load [N]\n0,1\n",
       {"path.csv:1:18", "'N', a unit of force", "1, %"}},
      {"load without unit",
       "displacement [m],normal_load\n0,1\n",
       {"path.csv:1:18", "Write 'normal_load [1]'"}},
      {"a joint", kJointText, {"path.csv", "a joint (joint.json)"}}};
  for (const BadFile& file : files) {
    SCOPED_TRACE(file.name);
    const Sandbox box{{"joint.json", kJointText}, {"path.csv", file.content}};
    expect_refused(box, {"loop", "joint.json", "--path", "path.csv", "--out", "loop.csv"},
                   file.parts);
  }
}

TEST(BadJoint, OfAWrongForm) {
  expect_joint_refused("", {"joint.json", "an empty file"});
  expect_joint_refused("{", {"joint.json:1:2", "the end of the file", "brackets"});
  expect_joint_refused("{\n  \"schema\": }", {"joint.json:2:13", "'}'"});
  expect_joint_refused("[]", {"joint.json", "an object", "an array"});
  expect_joint_refused(sample_levels_text(), {"expected JSON", "a table of levels (levels.csv)"});
  expect_joint_refused(std::string("\x00\x01\x02", 3), {"joint.json:1:1"});
  expect_joint_refused("{\"schema\": \"\xFF\xFE\"}", {"joint.json:1"});
  expect_joint_refused(R"({"stiffness_N_per_m": 1})", {"joint.json", "'schema'"});
  expect_joint_refused(R"({"schema": 1})", {"joint.json: schema = 1", "text"});
  expect_joint_refused(R"({"schema": "microslip.joint/2"})",
                       {"joint.json", "'microslip.joint/1'", "'microslip.joint/2'", "version"});
  expect_joint_refused(R"({"schema": "microslip.joint/1", "density": []})",
                       {"joint.json", "'stiffness_N_per_m'"});
  expect_joint_refused(joint_with("3"), {"joint.json", "density[0]", "an object", "found 3"});
  expect_joint_refused(joint_with(R"({"type": "iwan"})"),
                       {"joint.json: density[0].type = 'iwan'", "four_parameter"});
  expect_joint_refused(joint_with(R"({"type": "uniform", "from_N": 0, "to_N": 1})"),
                       {"joint.json", "'weight'", "density[0]"});
  expect_joint_refused(
      joint_with(R"({"type": "uniform", "from_N": 0, "to_N": 1, "weight": 1, "unit": "N"})"),
      {"joint.json", "'unit'", "density[0]"});
}

TEST(BadJoint, NestedTooDeep) {
  constexpr std::size_t kLevels = 100'000;
  const std::string open = repeated("[", kLevels);
  for (const std::string& text :
       {open, open + repeated("]", kLevels), joint_with(open), repeated("{\"a\":", kLevels)}) {
    expect_joint_refused(text, {"joint.json", "at most 64"});
  }
}

TEST(BadJoint, WithABadStiffness) {
  const std::string begin =
      R"({"schema": "microslip.joint/1", "density": [], "stiffness_N_per_m": )";
  expect_joint_refused(begin + "0}", {"joint.json: stiffness_N_per_m = 0", "positive"});
  expect_joint_refused(begin + "-1}", {"joint.json: stiffness_N_per_m = -1", "positive"});
  expect_joint_refused(begin + "\"1e5\"}",
                       {"joint.json: stiffness_N_per_m = '1e5'", "a number", "without quotes"});
  expect_joint_refused(begin + "1e999}", {"joint.json:1", "'1e999'"});
  expect_joint_refused(begin + "NaN}", {"joint.json:1", "JSON"});
}

TEST(BadJoint, WithABadDensity) {
  const std::string uniform = R"({"type": "uniform", "from_N": )";
  expect_joint_refused(joint_with(uniform + R"(5, "to_N": 1, "weight": 1})"),
                       {"joint.json: density[0].to_N = 1", "larger than", "swap the two"});
  expect_joint_refused(joint_with(uniform + R"(-1, "to_N": 1, "weight": 1})"),
                       {"joint.json: density[0].from_N = -1", "0 or more"});
  expect_joint_refused(joint_with(uniform + R"(0, "to_N": 1, "weight": 1.5})"),
                       {"joint.json: total weight of density = 1.5", "must not exceed 1"});
  expect_joint_refused(joint_with(uniform + R"(0, "to_N": 1, "weight": -0.5})"),
                       {"joint.json: density[0].weight = -0.5", "0 or more"});
  expect_joint_refused(
      joint_with(
          R"({"type": "piecewise_linear", "slip_force_N": [0, 1], "density_per_N": [0, -1]})"),
      {"joint.json: density[0].density_per_N[1] = -1", "cannot be negative"});
  expect_joint_refused(
      joint_with(
          R"({"type": "piecewise_linear", "slip_force_N": [1, 0], "density_per_N": [0, 0]})"),
      {"joint.json: density[0].slip_force_N[1] = 0", "Sort"});
  for (const std::string chi : {"-1", "0.5"}) {
    expect_joint_refused(
        joint_with(R"({"type": "four_parameter", "macroslip_force_N": 400, "beta": 1, "chi": )" +
                   chi + "}"),
        {"joint.json: density[0].chi = " + chi, "(-1, 0]"});
  }
}

}  // namespace
}  // namespace microslip::cli_test::bad_input_test
