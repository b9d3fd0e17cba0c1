// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "support/effort.hpp"
#include "support/replaced.hpp"

/// Calls of legal form that ask for more memory or time than there is: refused before the work,
/// with the value, the bound and what to do. base.WorkSize has the bounds.

namespace microslip::cli_test::limits_test {
namespace {

using Parts = std::vector<std::string>;

struct Asked {
  Arguments call;
  Parts parts;
};

const Parts kMemory{"at most: each takes", "1 GiB"};
const Parts kTime{"must be 1e+10 at most, which take an hour or more"};

void expect_refused_by(const Sandbox& box, const Arguments& call, const Parts& rule,
                       const Parts& parts) {
  Parts all = rule;
  all.insert(all.end(), parts.begin(), parts.end());
  expect_refused(box, call, all);
}

Sandbox sandbox() {
  return {{"levels.csv", sample_levels_text()},
          {"joint.json", kJointText},
          {"force.csv", "time [s],force [N]\n0,0\n0.2,1\n1e12,0\n"},
          {"shock.csv", "time [s],absolute_acceleration [m/s^2]\n0,0\n0.2,1\n1e9,0\n"},
          {"model.toml", test::get(MICROSLIP_EXAMPLES "/one_mass/model.toml")},
          {"rig.toml", test::replaced(test::get(MICROSLIP_EXAMPLES "/reference_rig/rig.toml"),
                                      "duration_s = 1.0", "duration_s = 1e5")}};
}

// 2^30/280 values.
TEST(Limits, OfMemoryAreToldBeforehand) {
  const Sandbox box = sandbox();
  const std::string many = ":10000000";
  const std::vector<Asked> all{
      {{"dissipation", "joint.json", "--amplitude", "1um:9um" + many, "--out", "x.csv"},
       {"values of --amplitude = 10000000; must be 3834792 at most", "Take fewer."}},
      {{"backbone", "model.toml", "--response", "1um:1mm" + many, "--out", "x.csv"},
       {"number of responses = 10000000", "Take fewer."}},
      {{"frf", "model.toml", "--force", "0.1", "--frequency", "0.1:0.2", "--at", "0.1:0.2" + many,
        "--out", "x.csv"},
       {"frequencies of --at = 10000000", "Take fewer."}},
      {{"load", "sine", "model.toml", "--peak", "1", "--frequency", "1", "--duration", "1e6s",
        "--out", "x.csv"},
       {"number of times = 256000", "Change the duration or the sampling rate."}},
      {{"dissipation", "joint.json", "--amplitude", "1um:9um:1000", "--draws", "1000000",
        "--normal-load-std", "0.1", "--out", "x.csv"},
       {"--draws = 1000000", "or fewer draws"}},
      {{"plan", "levels.csv", "--stiffness", "1.7e5", "--draws", "100000", "--out", "x.csv"},
       {"--draws = 100000", "Take fewer."}}};
  for (const Asked& one : all) expect_refused_by(box, one.call, kMemory, one.parts);
  expect_refused(box, {"measure", "rig.toml", "--out", "made"},
                 {"test.duration_s = 100000", "samples of 6 columns, 1 GiB", "Record less"});
}

TEST(Limits, OfTimeAreToldBeforehand) {
  const Sandbox box = sandbox();
  expect_refused(
      box, {"march", "model.toml", "--force-file", "force.csv", "--out", "x.csv"},
      {"step = ", "must be at least 100 s", "1e+12 s long", "1e+10 steps", "unit of time"});
  expect_refused_by(
      box, {"spectrum", "shock.csv", "--frequency", "1:1000:1000", "--out", "x.csv"}, kTime,
      {"steps of a response spectrum", "1000 natural frequencies", "a shorter record"});
}

std::string model_of_joints(int count) {
  std::string model = test::get(MICROSLIP_EXAMPLES "/one_mass/model.toml");
  for (int i = 1; i < count; ++i) {
    model += fmt::format("[[joint]]\nname = \"a{}\"\nfile = \"joint.json\"\nshape = [1.0]\n", i);
  }
  return model;
}

// Dense matrices over 11 coefficients of each joint: five of them, of 471 joints, take 1 GiB; over
// the joints alone 28 of them, of 2189.
TEST(Limits, OfJointsOfOneStructure) {
  const Sandbox box{{"joint.json", kJointText},
                    {"many.toml", model_of_joints(1000)},
                    {"force.csv", "time [s],force [N]\n0,0\n0.2,1\n"},
                    {"more.toml", model_of_joints(2300)}};
  expect_refused(box, {"march", "more.toml", "--force-file", "force.csv", "--out", "x.csv"},
                 {"number of joints = 2300", "2189 at most", "1 GiB", "Take fewer joints"});
  for (const Arguments& call :
       {Arguments{"frf", "many.toml", "--force", "1", "--frequency", "1:2", "--out", "x.csv"},
        Arguments{"backbone", "many.toml", "--response", "1um:2um:2", "--out", "x.csv"}}) {
    expect_refused(
        box, call,
        {"number of joints = 1000", "471 at most with 5 harmonics", "1 GiB", "Take fewer joints"});
  }
}

/// A file as a crash of the system leaves it: its size, but zeros where nothing was written.
void put_zeros(const Sandbox& box, const std::string& name, const std::string& head) {
  constexpr std::size_t kSize = 800'000'000;
  box.put(name, head);
  std::filesystem::resize_file(box.file(name), kSize);
}

// The limit is below the size of the file: it cannot have been read whole.
TEST(Limits, OfAFileOfZerosAreItsFirst) {
  const Sandbox box = sandbox();
  put_zeros(box, "zeros.csv", "");
  put_zeros(box, "tail.csv", sample_levels_text());
  put_zeros(box, "zeros.toml", "");
  std::string record = "time [s],force [N],acc1 [m/s^2]\n";
  for (int i = 0; i < 1000; ++i) record += fmt::format("{:.3f},{},1\n", 1e-3 * i, i % 7);
  put_zeros(box, "record.csv", record + "1.0");
  Circumstances little;
  if (!test::kSanitized) little.memory = 600'000'000;
  const auto refused = [&](const Arguments& call, const Parts& parts) {
    const Outcome run = box.run(call, little);
    EXPECT_EQ(run.status, 2) << typed(call);
    for (const std::string& part : parts) {
      EXPECT_NE(run.err.find(part), std::string::npos) << part << ": " << run.err;
    }
  };
  refused({"identify", "zeros.csv", "--stiffness", "1e5", "--out", "j.json"},
          {"zeros.csv:1:1", "0x00", "Is this a text table?"});
  refused({"identify", "tail.csv", "--stiffness", "1e5", "--out", "j.json"}, {"tail.csv:", "0x00"});
  refused({"identify", "/dev/zero", "--stiffness", "1e5", "--out", "j.json"}, {"/dev/zero:1:1"});
  refused({"convert", "zeros.csv", "--list"}, {"zeros.csv:1:1"});
  refused({"convert", "record.csv", "--list"}, {"record.csv:1002:4", "0x00"});
  refused({"loop", "joint.json", "--path", "zeros.csv", "--out", "x.csv"}, {"zeros.csv:1:1"});
  refused({"plan", "zeros.csv", "--stiffness", "1e5", "--out", "x.csv"}, {"zeros.csv:1:1"});
  refused({"frf", "zeros.toml", "--force", "1", "--frequency", "1:2", "--out", "x.csv"},
          {"zeros.toml"});
}

TEST(Limits, OfWaitingForAPipeThatAFileNames) {
  const Sandbox box = sandbox();
  ASSERT_EQ(::mkfifo(box.file("pipe").c_str(), 0600), 0);
  const Parts parts{"pipe", "a pipe or a device, and named in another file", "regular file"};
  box.put("model.toml", test::replaced(box.get("model.toml"), "joint.json", "pipe"));
  const Arguments frf{"frf", "model.toml", "--force", "1", "--frequency", "1:2", "--out", "x.csv"};
  expect_refused(box, frf, parts);
  box.put("model.toml", test::replaced(box.get("model.toml"), "pipe", "/dev/zero"));
  expect_refused(box, frf, {"/dev/zero", parts[1]});
  box.put("rig.toml", test::replaced(test::get(MICROSLIP_EXAMPLES "/reference_rig/rig.toml"),
                                     "joint.json", "pipe"));
  expect_refused(box, {"measure", "rig.toml", "--out", "made"}, parts);
  box.put("plan.toml",
          "schema = \"microslip.ensemble/1\"\nkind = \"bootstrap\"\n[bootstrap]\n"
          "levels = \"pipe\"\nstiffness_N_per_m = 1.7e5\ncount = 20\n");
  expect_refused(box, {"ensemble", "plan.toml", "--out", "x.h5"}, parts);
  box.put("campaign.toml",
          "schema = \"microslip.campaign/1\"\nstructure = \"pipe\"\n[[test]]\nname = \"a\"\n"
          "file = \"levels.csv\"\nuse = \"identify\"\n");
  expect_refused(box, {"campaign", "campaign.toml", "--out", "made"}, parts);
}

}  // namespace
}  // namespace microslip::cli_test::limits_test
