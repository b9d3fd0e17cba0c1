// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/io/tables/csv.hpp"

namespace microslip::cli_test::identify_assemblies_test {
namespace {

using nlohmann::json;

struct Row {
  std::string assembly;
  std::string stiffness;
};

/// Levels of assemblies whose slip forces differ by 6 % each.
std::string levels_of(const std::vector<Row>& assemblies) {
  std::string text = "assembly,stiffness [N/m],amplitude [m],dissipation [J]";
  const Joint joint = sample_joint();
  for (std::size_t j = 0; j < assemblies.size(); ++j) {
    for (int i = 1; i <= 8; ++i) {
      const double a = 2.5e-5 * i;
      const double scale = 1.0 + 0.06 * static_cast<double>(j);
      const double d = scale * scale * dissipation(joint, a / scale);
      text +=
          fmt::format("\n{},{},{:.12g},{:.12g}", assemblies[j].assembly, assemblies[j].stiffness, a,
                      d * (1.0 + 0.004 * std::sin(7.0 * i + static_cast<double>(j))));
    }
  }
  return text + '\n';
}

std::string three() { return levels_of({{"old", "170000"}, {"new", "175000"}, {"b 3", "168000"}}); }

const Arguments kCall{"identify",  "levels.csv", "--assemblies", "column",
                      "--samples", "100",        "--out",        "found"};

Sandbox box_of(const std::string& levels) { return Sandbox{{"levels.csv", levels}}; }

// The file and the line where the levels of the assembly begin.
TEST(identify_assemblies, SaysWhereLevelsLoseNothing) {
  const std::string nothing =
      "assembly,stiffness [N/m],amplitude [m],dissipation [J]\n"
      "a,1e5,1e-5,1e-9\na,1e5,2e-5,8e-9\nb,1e5,1e-5,0\nb,1e5,2e-5,0\n";
  expect_refused(box_of(nothing), kCall,
                 {"levels.csv:4: ", "above 0", "assembly 'b'", "0 at all 2 levels"});
  const Sandbox one{{"none.csv", "amplitude [m],dissipation [J]\n1e-5,0\n2e-5,0\n"}};
  expect_refused(one, {"identify", "none.csv", "--stiffness", "1e5", "--out", "j.json"},
                 {"none.csv:2: ", "above 0", "0 at all 2 levels"});
}

TEST(identify_assemblies, WritesAFolder) {
  const Sandbox box = box_of(three());
  const Outcome run = expect_done(box, kCall);
  EXPECT_NE(run.out.find("spread of k"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("determine a spread only roughly"), std::string::npos) << run.out;
  const CsvTable table(box.get("found/assemblies.csv"), "assemblies.csv");
  EXPECT_EQ(table.text("assembly"), (std::vector<std::string>{"old", "new", "b 3"}));
  EXPECT_EQ(table.numbers("stiffness", kStiffness), (std::vector<double>{170000, 175000, 168000}));
  const std::vector<double> scale = table.numbers("slip_force_scale", kDimensionless);
  EXPECT_LT(scale[0], scale[1]);
  EXPECT_LT(scale[1], scale[2]);
  EXPECT_DOUBLE_EQ(read_joint(box.file("found/assembly_b 3.json")).joint.stiffness(), 168000);
  const json middle = json::parse(box.get("found/joint.json"));
  EXPECT_EQ(middle.at("identification").at("assembly"), json({"old", "new", "b 3"}));
  EXPECT_EQ(middle.at("provenance").at("options").at("assemblies"), "column");
  EXPECT_NEAR(middle.at("stiffness_N_per_m").get<double>(),
              std::cbrt(170000.0 * 175000.0 * 168000.0), 1e-6 * 170000.0);
  for (const std::string spread : {"stiffness_spread", "slip_force_spread", "shape_spread"}) {
    const json& record = middle.at("identification");
    EXPECT_LT(record.at("band_" + spread)[0], record.at(spread)) << spread;
    EXPECT_GT(record.at("band_" + spread)[1], record.at(spread)) << spread;
  }
  const JointSamples next = read_joint_samples(box.file("found/joint_samples.h5"));
  EXPECT_EQ(next.size(), 100U);
  EXPECT_EQ(next.method, "the next of several assemblies");
}

// What is written predicts: the draws of the next assembly are samples of a model.
TEST(identify_assemblies, GivesSamplesThatPredict) {
  const Sandbox box = box_of(three());
  expect_done(box, kCall);
  box.put("model.toml", R"(schema = "microslip.model/1"
[structure]
frequency_Hz = [16.0]
damping_ratio = [0.002]
[[structure.point]]
name = "tip"
shape = [0.1]
[[joint]]
file = "found/joint.json"
samples = "found/joint_samples.h5"
shape = [0.1]
[excitation]
point = "tip"
)");
  const Arguments call{"backbone", "model.toml", "--response", "20um:150um:4",
                       "--draws",  "40",         "--out"};
  expect_done(box, with(call, {"next.csv"}));
  const CsvTable next(box.get("next.csv"), "next.csv");
  const auto frequency = next.numbers("frequency", kFrequency);
  const auto lower = next.numbers("frequency_lower", kFrequency);
  const auto upper = next.numbers("frequency_upper", kFrequency);
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    EXPECT_LT(lower[i], frequency[i]);
    EXPECT_GT(upper[i], frequency[i]);
  }
}

TEST(identify_assemblies, TakesFilesAsAssemblies) {
  const std::string levels = sample_levels_text();
  const Sandbox box{{"a.csv", levels}, {"b.csv", levels}, {"c.csv", levels}};
  expect_done(box, {"identify", "a.csv", "b.csv", "c.csv", "--assemblies", "files", "--stiffness",
                    "1.7e5", "--samples", "100", "--out", "found"});
  const CsvTable table(box.get("found/assemblies.csv"), "assemblies.csv");
  EXPECT_EQ(table.text("assembly"), (std::vector<std::string>{"a", "b", "c"}));
  const json middle = json::parse(box.get("found/joint.json"));
  EXPECT_EQ(middle.at("identification").at("stiffness_from"), "common");
  EXPECT_FALSE(middle.at("identification").contains("stiffness_spread"));
}

TEST(identify_assemblies, SaysWhatIsWrong) {
  const auto refused = [](const std::string& levels, const Arguments& call,
                          const std::vector<std::string>& texts) {
    const Sandbox box = box_of(levels);
    expect_refused(box, call, texts);
    EXPECT_FALSE(std::filesystem::exists(box.file("found")));
  };
  const auto edited = [](std::string text, const std::string& before, const std::string& after) {
    return text.replace(text.find(before), before.size(), after);
  };
  refused(levels_of({{"a", "170000"}}), kCall, {"number of assemblies = 1", "3 or more"});
  refused(levels_of({{"a", "170000"}, {"b", "170000"}}), kCall, {"number of assemblies = 2"});
  refused(edited(three(), "\nnew,", "\n,"), kCall, {"levels.csv:10", "name of an assembly"});
  refused(edited(three(), "\nnew,175000", "\nnew,176000"), kCall, {"levels.csv:11", "has one k"});
  refused(edited(three(), "\nnew,175000", "\nnew,"), kCall, {"levels.csv:10"});
  refused(levels_of({{"a/b", "1e5"}, {"b", "1e5"}, {"c", "1e5"}}), kCall, {"'a/b'", "Rename"});
  refused(levels_of({{"next", "1e5"}, {"b", "1e5"}, {"c", "1e5"}}), kCall, {"'next'", "Rename"});
  refused(edited(three(), "stiffness [N/m]", "other [N/m]"), kCall, {"stiffness is missing"});
  refused(sample_levels_text(), kCall, {"column assembly is missing", "--assemblies files"});
  refused(three(), with(kCall, {"--stiffness", "1.7e5"}), {"is given for each assembly, too"});
  refused(three(), with(kCall, {"--loss-factor-std", "0.1"}), {"--loss-factor-std"});
  refused(three(), {"identify", "levels.csv", "--stiffness", "1.7e5", "--out", "found"},
          {"column assembly = 3 names", "--assemblies column"});
}

// One name says nothing of assemblies, and levels of one joint are what they were.
TEST(identify_assemblies, OneNameIsOneJoint) {
  const Sandbox box = box_of(levels_of({{"a", "170000"}}));
  expect_done(box, {"identify", "levels.csv", "--stiffness", "1.7e5", "--out", "j.json"});
}

TEST(identify_assemblies, AreDrawnWithTheBandOfTheNext) {
  const Sandbox box = box_of(three());
  expect_done(box, kCall);
  expect_done(box, {"plot", "found/densities.csv", "--out", "p.svg"});
  const std::string picture = box.get("p.svg");
  for (const char* text : {"common", "next", "old", "new", "b 3"}) {
    EXPECT_NE(picture.find(text), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace microslip::cli_test::identify_assemblies_test
