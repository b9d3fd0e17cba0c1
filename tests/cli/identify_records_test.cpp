// SPDX-License-Identifier: MIT
// `identify` of force–displacement records.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "microslip/documents/joint/density_file.hpp"
#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "support/force_records.hpp"

namespace microslip::cli_test::identify_records_test {
namespace {

using nlohmann::json;

Sandbox sandbox() { return Sandbox{{"record.csv", record_text(sample_record())}}; }

json identification(const Sandbox& box, const std::string& file = "joint.json") {
  return json::parse(box.get(file)).at("identification");
}

const Arguments kIdentify{"identify", "record.csv", "--out", "joint.json"};

TEST(identify_records, FindsJointAndStiffness) {
  const Sandbox box = sandbox();
  const Outcome done = expect_done(box, with(kIdentify, {"--density-csv", "density.csv"}));
  const Joint found = read_joint(box.file("joint.json")).joint;
  EXPECT_NEAR(found.stiffness() / kSampleStiffness, 1.0, 0.02);
  EXPECT_LE(testing::error_of_density(found, sample_joint(), kSampleStiffness * 2.4e-4), 0.15);
  const json file = identification(box);
  EXPECT_EQ(file.at("status"), "converged");
  EXPECT_EQ(file.at("start"), json({"virgin"}));
  EXPECT_EQ(file.at("band_samples"), 1000);
  EXPECT_LT(file.at("band_stiffness_N_per_m").at(0), kSampleStiffness);
  EXPECT_GT(file.at("band_stiffness_N_per_m").at(1), kSampleStiffness);
  EXPECT_NE(done.out.find("95 % band"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("record.csv"), std::string::npos) << done.out;
  const DensityTable table = parse_density(box.get("density.csv"), "density.csv");
  EXPECT_EQ(table.lower.size(), table.density.size());
}

TEST(identify_records, SaysWhereItsInputsCameFrom) {
  const Sandbox box = sandbox();
  expect_done(box, kIdentify);
  const json provenance = json::parse(box.get("joint.json")).at("provenance");
  EXPECT_EQ(provenance.at("inputs").at(0).at("file"), "record.csv");
  EXPECT_EQ(provenance.at("inputs").at(0).at("sha256"), sha256(box.get("record.csv")));
  EXPECT_EQ(provenance.at("seed"), 1);
}

TEST(identify_records, TakesSeveralInAnyFormat) {
  const Sandbox box = sandbox();
  box.put("other.csv", record_text(sample_record(2)));
  expect_done(box, {"convert", "other.csv", "other.uff"});
  expect_done(box, {"identify", "record.csv", "other.uff", "--out", "both.json"});
  expect_done(box, kIdentify);
  const auto width = [&](const std::string& file) {
    const json band = identification(box, file).at("band_stiffness_N_per_m");
    return band.at(1).get<double>() - band.at(0).get<double>();
  };
  EXPECT_EQ(identification(box, "both.json").at("scatter_force_N").size(), 2U);
  EXPECT_LT(width("both.json"), width("joint.json"));
}

TEST(identify_records, ChoosesChannels) {
  const Sandbox box;
  ForceRecord record = sample_record();
  std::string text = "time [s],u1 [um],u2 [um],f1 [N],f2 [N]\n";
  for (std::size_t i = 0; i < record.size(); ++i) {
    text += fmt::format("{:.6f},{:.9g},{:.9g},{:.9g},{:.9g}\n", 1e-3 * static_cast<double>(i),
                        1e6 * record.displacement[i], 1.0 + std::sin(0.1 * static_cast<double>(i)),
                        0.5, record.force[i]);
  }
  box.put("record.csv", text);
  expect_refused(box, kIdentify, {"record.csv", "force", "there 2 times", "'f1'", "--force"});
  expect_refused(box, with(kIdentify, {"--force", "f2"}), {"displacement", "--displacement"});
  expect_refused(box, with(kIdentify, {"--force", "u1", "--displacement", "u1"}), {"u1", "force"});
  expect_refused(box, with(kIdentify, {"--force", "f3", "--displacement", "u1"}),
                 {"f3", "missing"});
  expect_refused(box, with(kIdentify, {"--force", "f1", "--displacement", "u1"}),
                 {"record.csv", "force", "must vary"});
  expect_done(box, with(kIdentify, {"--force", "f2", "--displacement", "u1"}));
}

// Friction depends on the order of the samples alone; a viscous part is of a rate.
TEST(identify_records, TakesUnevenTimes) {
  const Sandbox box = sandbox();
  const ForceRecord record = sample_record();
  std::string text = "time [s],u [m],f [N]\n";
  for (std::size_t i = 0; i < record.size(); ++i) {
    text += fmt::format("{:.6f},{:.9g},{:.9g}\n",
                        1e-3 * (static_cast<double>(i) + (i % 3 == 0 ? 0.03 : 0.0)),
                        record.displacement[i], record.force[i]);
  }
  box.put("uneven.csv", text);
  expect_done(box, {"identify", "uneven.csv", "--out", "j.json"});
  expect_refused(box, {"identify", "uneven.csv", "--viscous", "fit", "--out", "j.json"},
                 {"time step", "--resample"});
  expect_done(box, {"levels", "uneven.csv", "--out", "levels.csv"});
}

TEST(identify_records, RefusesWhatIsNoRecordOfAJoint) {
  const Sandbox box = sandbox();
  ForceRecord swapped = sample_record();
  for (double& value : swapped.force) value = -value;
  box.put("swapped.csv", record_text(swapped));
  expect_refused(box, {"identify", "swapped.csv", "--out", "j.json"}, {"swapped.csv", "sign"});

  ForceRecord exchanged = sample_record();
  for (std::size_t i = 0; i < exchanged.size(); ++i) {
    const double force = exchanged.force[i];
    exchanged.force[i] = 1e6 * exchanged.displacement[i];
    exchanged.displacement[i] = 1e-6 * force;
  }
  box.put("exchanged.csv", record_text(exchanged));
  expect_refused(box, {"identify", "exchanged.csv", "--out", "j.json"}, {"exchanged.csv", "work"});
  expect_refused(box, {"identify", "none.csv", "--out", "j.json"}, {"none.csv"});

  ForceRecord ramp = sample_record();
  for (std::size_t i = 0; i < ramp.size(); ++i) {
    ramp.displacement[i] = 1e-7 * static_cast<double>(i);
  }
  box.put("ramp.csv", record_text(ramp));
  expect_refused(box, {"identify", "ramp.csv", "--out", "j.json"}, {"ramp.csv", "reversals"});

  box.put("unitless.csv", record_text(sample_record(), "time [s],u,f"));
  expect_refused(box, {"identify", "unitless.csv", "--out", "j.json"}, {"--assume-units"});
  expect_done(box, {"identify", "unitless.csv", "--assume-units", "u=um", "--assume-units", "f=N",
                    "--out", "j.json"});
}

TEST(identify_records, TakesLevelsWithThem) {
  const Sandbox box = sandbox();
  box.put("levels.csv", sample_levels_text());
  expect_done(box, kIdentify);
  const Outcome done =
      expect_done(box, {"identify", "levels.csv", "record.csv", "--out", "both.json"});
  EXPECT_NE(done.out.find("posterior of records and levels"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("levels.csv"), std::string::npos) << done.out;
  const json both = identification(box, "both.json");
  EXPECT_EQ(both.at("levels_verdict"), json({"held"}));
  EXPECT_EQ(both.at("levels_scatter").size(), 1U);
  EXPECT_EQ(json::parse(box.get("both.json")).at("provenance").at("inputs").size(), 2U);
  const auto error = [&](const std::string& file) {
    return testing::error_of_density(read_joint(box.file(file)).joint, sample_joint(),
                                     kSampleStiffness * 2e-4);
  };
  EXPECT_LT(error("both.json"), error("joint.json"));

  // Of another joint: said by name, in the file too.
  Levels other = sample_levels();
  for (double& d : other.dissipation) d *= 1.4;
  box.put("other.csv", levels_table(other).str());
  expect_done(box, {"identify", "record.csv", "other.csv", "--out", "j.json", "--quiet"});
  EXPECT_NE(box.get("j.json").find("other.csv: its D"), std::string::npos) << box.get("j.json");
}

TEST(identify_records, TakesSeveralTablesOfLevels) {
  const Sandbox box = sandbox();
  box.put("levels.csv", sample_levels_text());
  box.put("more.csv", sample_levels_text());
  const Arguments both{"identify", "levels.csv", "more.csv", "--out", "j.json"};
  expect_refused(box, both, {"--stiffness", "missing"});
  const Outcome done = expect_done(box, with(both, {"--stiffness", "1.7e5"}));
  EXPECT_NE(done.out.find("tables of levels"), std::string::npos) << done.out;
  expect_refused(box, with(both, {"--stiffness", "1.7e5", "--force", "f"}), {"--force", "records"});
  expect_refused(box, with(both, {"--stiffness", "1.7e5", "--fit", "uniform"}),
                 {"--fit", "single table"});
  box.put("more.csv", "amplitude [m],dissipation [J]\n1e-4,-1\n");
  expect_refused(box, with(both, {"--stiffness", "1.7e5"}), {"more.csv", "dissipation"});
}

TEST(identify_records, KeepsOptionsOfEvidenceApart) {
  const Sandbox box = sandbox();
  box.put("levels.csv", sample_levels_text());
  expect_refused(box, {"identify", "levels.csv", "--out", "j.json"}, {"--stiffness", "missing"});
  const Arguments levels{"identify", "levels.csv", "--stiffness", "1.7e5", "--out", "j.json"};
  for (const Arguments& more : {Arguments{"--force", "f"}, Arguments{"--displacement", "u"},
                                Arguments{"--start", "virgin"}, Arguments{"--viscous", "fit"}}) {
    expect_refused(box, with(levels, more), {more.front(), "records"});
  }
  for (const Arguments& more :
       {Arguments{"--method", "spline"}, Arguments{"--smoothing", "lambda=1"},
        Arguments{"--linear-damping", "fit"}, Arguments{"--inner-reversals", "use"},
        Arguments{"--atom"}, Arguments{"--bands", "100"}, Arguments{"--fit", "uniform"}}) {
    expect_refused(box, with(kIdentify, more), {more.front(), "levels"});
  }
}

// By a link, another way to write its name, or the same name: it would count twice.
TEST(identify_records, RefusesAFileThatIsThereTwice) {
  const Sandbox box = sandbox();
  box.put("levels.csv", sample_levels_text());
  std::filesystem::create_symlink("record.csv", box.file("link.csv"));
  std::filesystem::create_symlink("levels.csv", box.file("linked_levels.csv"));
  for (const std::string again : {"link.csv", "./record.csv", "record.csv"}) {
    const Arguments call{"identify", "record.csv", again, "--out", "joint.json"};
    expect_refused(box, call, {again, "the same file as record.csv", "Leave one"});
  }
  const Arguments levels{"identify",          "record.csv", "levels.csv",
                         "linked_levels.csv", "--out",      "joint.json"};
  expect_refused(box, levels, {"linked_levels.csv = the same file as levels.csv"});
  expect_refused(box, {"levels", "record.csv", "link.csv", "--out", "found.csv"},
                 {"link.csv = the same file as record.csv"});
}

TEST(identify_records, KeepsTheDraws) {
  const Sandbox box = sandbox();
  expect_done(box, with(kIdentify, {"--samples", "200", "--samples-out", "draws.h5"}));
  const JointSamples draws = read_joint_samples(box.file("draws.h5"));
  EXPECT_EQ(draws.size(), 200U);
  EXPECT_EQ(draws.method, "posterior of records");
  const json file = json::parse(box.get("joint.json"));
  EXPECT_EQ(file.at("provenance").at("options").at("samples_out"), "draws.h5");
  // The band of k contains 95 % of them at least, and the joint.
  const std::vector<double> band = file.at("identification").at("band_stiffness_N_per_m");
  const auto inside = [&](double k) { return band.at(0) <= k && k <= band.at(1); };
  EXPECT_GE(std::ranges::count_if(draws.stiffness, inside), 190);
  EXPECT_TRUE(inside(file.at("stiffness_N_per_m")));
  for (std::size_t i = 0; i < draws.size(); ++i) {
    EXPECT_LE(draws.joint(i).density().total().zeroth, 1.0 + 1e-12);
  }
}

// A prediction without a part that was found would be wrong without a word.
TEST(identify_records, RefusesToPredictWithoutAViscousPart) {
  const Sandbox box;
  ForceRecord record = sample_record();
  const std::vector<double> path = record.displacement;
  for (std::size_t i = 1; i + 1 < record.size(); ++i) {
    record.force[i] += 40.0 * (path[i + 1] - path[i - 1]) / (2.0 * record.time_step);
  }
  box.put("record.csv", record_text(record));
  expect_done(box, with(kIdentify, {"--viscous", "fit"}));
  EXPECT_GT(identification(box).at("viscous_N_s_per_m"), 10.0);
  expect_refused(box, {"dissipation", "joint.json", "--amplitude", "1um:100um:5", "--out", "d.csv"},
                 {"viscous_N_s_per_m"});
}

}  // namespace
}  // namespace microslip::cli_test::identify_records_test
