// SPDX-License-Identifier: MIT
// `plot` of a joint and the records that it was identified from.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"

namespace microslip::cli_test::plot_records_test {
namespace {

/// joint.json of two records.
class plot_records : public ::testing::Test {
 protected:
  plot_records() {
    expect_done(box, {"identify", "a.csv", "b.csv", "--samples", "100", "--out", "joint.json"});
  }

  const Sandbox box{{"a.csv", record_text(sample_record())},
                    {"b.csv", record_text(sample_record(2))}};
};

std::string svg_of(const Sandbox& box, const Arguments& arguments) {
  const std::string svg = expect_done(box, with(arguments, {"--out", "-"})).out;
  EXPECT_TRUE(svg.starts_with("<?xml")) << typed(arguments);
  return svg;
}

void expect_parts(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(text.find("<text>" + part + "</text>"), std::string::npos) << part;
  }
}

TEST_F(plot_records, DrawsThemBesideTheJoint) {
  expect_parts(svg_of(box, {"plot", ".", "--figure", "force"}),
               {"joint force [N]", "residual force [N]", "time [s]", "measured", "identified joint",
                "± 2 deviations of a sample"});
  expect_parts(svg_of(box, {"plot", "joint.json", "--figure", "record-loops"}),
               {"joint force [N]", "joint displacement [µm]", "measured", "identified joint"});
  expect_parts(svg_of(box, {"plot", "joint.json", "--figure", "residuals"}),
               {"residual force [N]", "joint displacement [µm]", "one of 3 samples",
                "mean while it rises", "mean while it falls"});
  expect_parts(svg_of(box, {"plot", "joint.json", "--figure", "density"}),
               {"95 % band", "determined from", "k × largest half range"});
}

TEST_F(plot_records, TakesARecordAndAPartOfIt) {
  const Arguments force{"plot", "joint.json", "--figure", "force"};
  const std::string first = svg_of(box, force);
  EXPECT_EQ(svg_of(box, with(force, {"--record", "1"})), first);
  EXPECT_NE(svg_of(box, with(force, {"--record", "2"})), first);
  EXPECT_NE(svg_of(box, with(force, {"--time", "1:2"})), first);
  EXPECT_EQ(svg_of(box, with(force, {"--time", "0:3"})), first);
  expect_refused(box, with(force, {"--record", "3"}), {"--record = 3", "from 1 to 2"});
  expect_refused(box, with(force, {"--time", "5:6"}), {"--time", "spans 0 to 2.999 s"});
  expect_refused(box, {"plot", "joint.json", "--figure", "density", "--record", "1"},
                 {"--record", "density"});
  expect_refused(box, {"plot", "joint.json", "--figure", "density", "--time", "1:2"},
                 {"--time", "density"});
}

TEST_F(plot_records, SaysWhichRecordIsMissing) {
  std::filesystem::create_directory(box.file("alone"));
  box.put("alone/joint.json", box.get("joint.json"));
  box.put("a.csv", box.get("b.csv"));
  expect_refused(box, {"plot", "alone", "--figure", "force"},
                 {"'force'", "a.csv is not the file from which joint.json was identified"});
  expect_done(box, {"plot", "alone", "--figure", "force", "--record", "2", "--out", "p.svg"});
  expect_refused(box, {"plot", "alone", "--figure", "verification"}, {"verification.csv"});
}

}  // namespace
}  // namespace microslip::cli_test::plot_records_test
