// SPDX-License-Identifier: MIT
// `report` of a joint and the records that it was identified from.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"

namespace microslip::cli_test::report_records_test {
namespace {

void expect_parts(const std::string& html, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_NE(html.find(part), std::string::npos) << part;
}

/// A folder "lab" with recordings.
class report_records : public ::testing::Test {
 protected:
  report_records() { std::filesystem::create_directory(box.file("lab")); }

  /// joint.json of recordings in "lab".
  void identify(const Arguments& records, const Arguments& more = {}) const {
    Arguments call{"identify"};
    call.insert(call.end(), records.begin(), records.end());
    expect_done(box, with(with(call, more), {"--samples", "100", "--out", "lab/joint.json"}));
  }

  [[nodiscard]] std::string report(const Arguments& more = {}) const {
    return expect_done(box, with({"report", "lab", "--no-pictures", "--out", "-"}, more)).out;
  }

  const Sandbox box;
};

TEST_F(report_records, ShowsVerdictsForcesAndLoops) {
  box.put("lab/a.csv", record_text(sample_record()));
  box.put("lab/b.csv", record_text(sample_record(2)));
  identify({"lab/a.csv", "lab/b.csv"});
  const std::string html = report();
  expect_parts(html, {"none of 8", "Is it a Masing joint?", "<h3>Slip-force density</h3>",
                      "<h3>Force over time</h3>", "<h3>Residual over time</h3>",
                      "<h3>Measured and found loops</h3>", "<h3>Residual over displacement</h3>",
                      "<h3>Dissipation of the joint</h3>", "2: b.csv", "virgin, shown",
                      "microslip identify lab/a.csv lab/b.csv"});
  EXPECT_EQ(html.find("Not in this report"), std::string::npos);
  const std::string one = report({"--records", "1"});
  expect_parts(one, {"1 of the 2 records are drawn"});
  EXPECT_EQ(one.find("2: b.csv"), std::string::npos);
  EXPECT_NE(one.find(">b.csv<"), std::string::npos) << "in the table";
}

// What the call said of the recording is needed to read it again.
TEST_F(report_records, ReadsThemAsTheIdentificationDid) {
  box.put("lab/a.csv", record_text(sample_record(), "time,u,f"));
  identify({"lab/a.csv"}, {"--assume-units", "u=um", "--assume-units", "f=N", "--assume-units",
                           "time=s", "--force", "f"});
  expect_parts(report(), {"<h3>Force over time</h3>", "u=um, f=N, time=s"});
}

TEST_F(report_records, SaysWhatIsBroken) {
  ForceRecord record = sample_record();
  const std::vector<double> path = record.displacement;
  for (std::size_t i = 1; i + 1 < record.size(); ++i) {
    record.force[i] += 40.0 * (path[i + 1] - path[i - 1]) / (2.0 * record.time_step);
  }
  box.put("lab/a.csv", record_text(record));
  identify({"lab/a.csv"});
  expect_parts(report(), {"It is not a Masing joint under constant normal load",
                          "<code>(rate_dependent)</code>", "--viscous fit", "<tr class=\"marked\">",
                          "1 of 7"});
}

TEST_F(report_records, SaysWhichRecordIsNotThere) {
  box.put("lab/a.csv", record_text(sample_record()));
  identify({"lab/a.csv"});
  box.put("lab/a.csv", record_text(sample_record(2)));
  const Outcome run = box.run({"report", "lab", "--no-pictures", "--out", "-"});
  EXPECT_EQ(run.status, 0);
  expect_parts(run.err, {"lab/a.csv is not the file from which joint.json was identified"});
  expect_parts(run.out, {"record_changed", "No forces and no loops"});
}

// A page stays small enough for mail whatever the record is.
TEST_F(report_records, ThinsALongRecord) {
  const std::vector<double> path = testing::random_motion(3000, 2.4e-4, 1, 50);
  box.put("lab/a.csv", record_text(testing::simulated_record(sample_joint(), path, 1, {}, 2e-5)));
  identify({"lab/a.csv"});
  const std::string html = report();
  expect_parts(html, {"Of a record of more than 6000 samples", ">150000<"});
  EXPECT_LT(html.size(), 3'000'000);
}

}  // namespace
}  // namespace microslip::cli_test::report_records_test
