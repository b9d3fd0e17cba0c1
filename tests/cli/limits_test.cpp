// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
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

}  // namespace
}  // namespace microslip::cli_test::limits_test
