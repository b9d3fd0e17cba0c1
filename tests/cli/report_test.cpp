// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"

namespace microslip::cli_test::report_test {
namespace {

/// A folder "test" with the levels and the joint of the samples, the joint identified from them.
void identify_in(const Sandbox& box) {
  std::filesystem::create_directory(box.file("test"));
  box.put("test/levels.csv", levels_table(sample_levels()).str());
  expect_done(box, {"identify", "test/levels.csv", "--stiffness", "1.7e5", "--bands", "20", "--out",
                    "test/joint.json", "--density-csv", "test/density.csv", "--quiet"});
}

/// Files in a folder "test".
void put_in_test(const Sandbox& box, const std::vector<Sandbox::File>& files) {
  std::filesystem::create_directory(box.file("test"));
  for (const auto& [name, text] : files) box.put("test/" + name, text);
}

void expect_parts_of(const std::string& html, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(html.find(part), std::string::npos) << part;
  }
}

/// A report of "test" that says something of what it read; the same is in the page.
std::string report_with_warning(const Sandbox& box, const std::string& code,
                                const std::string& part) {
  const Outcome run = box.run({"report", "test", "--out", "-", "--no-pictures"});
  EXPECT_EQ(run.status, 0) << run.err;
  expect_parts_of(run.err, {"microslip: warning: ", part});
  expect_parts_of(run.out, {code, part});
  return run.out;
}

TEST(report, IsOneFileWithLevelsDensityAndProvenance) {
  const Sandbox box;
  identify_in(box);
  const Outcome run = expect_done(box, {"report", "test", "--out", "report.html"});
  EXPECT_TRUE(run.out.starts_with("report.html: ")) << run.out;
  const std::string html = box.get("report.html");
  EXPECT_TRUE(html.starts_with("<!doctype html>"));
  EXPECT_LT(html.size(), 4'000'000);
  expect_parts_of(html, {"<h3>Slip-force density</h3>", "95 % band", "<h3>Energies per cycle</h3>",
                         "microslip identify test/levels.csv", "<code>microslip verify rig.toml",
                         "src=\"data:image/svg+xml,"});
  EXPECT_EQ(html.find("joint_from_other_levels"), std::string::npos);
}

// The other methods are shown with the options that the joint was identified with.
TEST(report, TakesTheOptionsOfTheJoint) {
  const Sandbox box;
  std::filesystem::create_directory(box.file("test"));
  box.put("test/levels.csv", levels_table(sample_levels()).str());
  expect_done(box, {"identify", "test/levels.csv", "--stiffness", "1.7e5", "--smoothing",
                    "lambda=0.125", "--out", "test/joint.json", "--quiet"});
  const Outcome run = expect_done(box, {"report", "test", "--out", "-", "--no-pictures"});
  expect_parts_of(run.out, {"chosen: \\u03bb = 0.125,", "as specified",
                            "<dt>option smoothing</dt><dd>lambda=0.125</dd>"});
}

/// The eight levels of the Brake–Reuß beam, whose frequency rises where a joint only softens.
void identify_contradicted_in(const Sandbox& box) {
  put_in_test(box, {{"levels.csv", test::get(MICROSLIP_EXAMPLES "/brake_reuss_beam/levels.csv")}});
  expect_done(box, {"identify", "test/levels.csv", "--stiffness", "5.08e5", "--out",
                    "test/joint.json", "--quiet"});
}

TEST(report, BeginsWithWhatTheLevelsContradict) {
  const Sandbox box;
  identify_contradicted_in(box);
  const std::string html = expect_done(box, {"report", "test", "--out", "-", "--no-pictures"}).out;
  const std::size_t verdict = html.find(
      "Not a Masing joint under constant normal load (the frequency does not fall as D implies)");
  ASSERT_NE(verdict, std::string::npos);
  EXPECT_LT(verdict, html.find("<figure"));
  EXPECT_LT(html.find(" warnings</a>: frequency rises; "), html.find("<figure"));
  expect_parts_of(html, {"<dt>joint amplitude</dt><dd>19.6 to 315 µm, 8 levels</dd>",
                         "the frequency does not fall as D implies: 0.41 %"});
}

TEST(report, RefusesADepartureWithoutItsNumbers) {
  const Sandbox box;
  identify_contradicted_in(box);
  const std::string joint = box.get("test/joint.json");
  const std::size_t key = joint.find("\"verdict_noise\": [");
  ASSERT_NE(key, std::string::npos);
  const std::size_t from = joint.find('[', key) + 1;
  box.put("test/joint.json", joint.substr(0, from) + "0.5, 0.5, 0.5, " + joint.substr(from));
  expect_refused(box, {"report", "test", "--out", "r.html"},
                 {"identification.verdict_noise", "must be 1", "Identify the joint again"});
}

TEST(report, RefusesABandWithoutAValueForEachForce) {
  const Sandbox box;
  identify_in(box);
  const std::string joint = box.get("test/joint.json");
  const std::size_t key = joint.find("\"band_upper_per_N\"");
  const std::size_t from = joint.find('[', key) + 1;
  box.put("test/joint.json", joint.substr(0, from) + joint.substr(joint.find(']', from)));
  for (const Arguments& call : {Arguments{"report", "test", "--out", "report.html"},
                                Arguments{"plot", "test", "--figure", "density"}}) {
    expect_refused(box, call,
                   {"test/joint.json: identification.band_upper_per_N = 0 numbers", "must be"});
  }
}

TEST(report, AFitHasItsParametersInTheSummary) {
  const Sandbox box;
  std::filesystem::create_directory(box.file("test"));
  box.put("test/levels.csv", levels_table(sample_levels()).str());
  expect_done(box, {"identify", "test/levels.csv", "--stiffness", "1.7e5", "--fit", "power_law",
                    "--out", "test/joint.json", "--quiet"});
  const Outcome run = expect_done(box, {"report", "test", "--out", "-", "--no-pictures"});
  expect_parts_of(run.out, {"by power_law from", "<dt>exponent</dt>", "<dt>coefficient</dt>"});
}

TEST(report, LevelsAlone) {
  const Sandbox box;
  std::filesystem::create_directory(box.file("test"));
  box.put("test/levels.csv", levels_table(sample_levels()).str());
  const Outcome run = expect_done(box, {"report", "test", "--out", "-", "--no-pictures"});
  expect_parts_of(run.out, {"no joint was identified yet",
                            "<h3>One row per level of vibration</h3>", ">Not in this report</h2>"});
}

/// The reference rig with six levels, and its joint.
Sandbox with_rig() {
  const std::string example = MICROSLIP_EXAMPLES "/reference_rig/";
  const std::string ninety = "count = 90";
  std::string rig = test::get(example + "rig.toml");
  rig.replace(rig.find(ninety), ninety.size(), "count = 6");
  return Sandbox{{"rig.toml", rig}, {"joint.json", test::get(example + "joint.json")}};
}

// A virtual test has records before and after the force control, no levels and no joint.
TEST(report, OfAVirtualTestFromItsRecordsToItsPredictions) {
  const Sandbox box = with_rig();
  expect_done(box, {"measure", "rig.toml", "--out", "test", "--before-control", "--quiet"});
  const Outcome measured = expect_done(box, {"report", "test", "--out", "-", "--no-pictures"});
  expect_parts_of(
      measured.out,
      {"<h3>Force over time</h3>", "before control", "<h3>Force control over the levels</h3>",
       "<td>before_control_06.csv</td>", "<code>microslip reduce rig.toml"});

  Arguments records;
  for (int i = 1; i <= 6; ++i) records.push_back("test/level_0" + std::to_string(i) + ".csv");
  Arguments reduce{"reduce", "test/rig.toml", "--out", "test/levels.csv", "--quiet"};
  reduce.insert(reduce.begin() + 2, records.begin(), records.end());
  expect_done(box, reduce);
  expect_done(box, {"identify", "test/levels.csv", "--stiffness", "1.7e5", "--out",
                    "test/joint.json", "--quiet"});
  Arguments verify{"verify",
                   "test/rig.toml",
                   "test/joint.json",
                   "--out",
                   "test/verification.csv",
                   "--histories",
                   "test/verification_histories.csv",
                   "--harmonics-csv",
                   "test/verification_harmonics.csv",
                   "--quiet"};
  verify.insert(verify.begin() + 3, records.begin(), records.end());
  expect_done(box, verify);
  const Outcome all = expect_done(box, {"report", "test", "--out", "-", "--no-pictures"});
  expect_parts_of(all.out,
                  {"<h3>Frequency responses at constant response</h3>",
                   "<h3>Misfit of the prediction</h3>", "<h3>Damping of the structure</h3>",
                   "level_06.csv (", "force, recorded", "force, predicted"});
  EXPECT_EQ(all.out.find("Not in this report"), std::string::npos);
  EXPECT_EQ(all.out.find("verification_of_other"), std::string::npos);

  // The same levels with another k: what was verified is not this joint.
  expect_done(box, {"identify", "test/levels.csv", "--stiffness", "1.9e5", "--out",
                    "test/joint.json", "--quiet"});
  const std::string stale = report_with_warning(
      box, "verification_of_other_joint", "verification.csv was not made with the joint.json");
  expect_parts_of(stale, {"Predictions of another joint or rig than"});
  EXPECT_EQ(stale.find("beyond the noise"), std::string::npos);
  // Each of the tables tells by itself.
  std::filesystem::remove(box.file("test/verification.csv"));
  report_with_warning(box, "verification_of_other_joint",
                      "verification_histories.csv was not made with the joint.json");
  std::filesystem::remove(box.file("test/verification_histories.csv"));
  report_with_warning(box, "verification_of_other_joint",
                      "verification_harmonics.csv was not made with the joint.json");
  EXPECT_EQ(all.out.find("levels_of_other_rig"), std::string::npos);
  box.put("test/rig.toml", box.get("test/rig.toml") + "\n# heavier now\n");
  report_with_warning(box, "levels_of_other_rig", "levels.csv was not reduced with the rig.toml");
}

TEST(report, SameBytesEachTimeAndReplacesAnOlderOne) {
  const Sandbox box;
  identify_in(box);
  expect_done(box, {"report", "test", "--out", "report.html", "--quiet"});
  const std::string first = box.get("report.html");
  expect_done(box, {"report", "test", "--out", "report.html", "--quiet"});
  EXPECT_EQ(box.get("report.html"), first);
}

TEST(report, ToStandardOutputWithoutPictures) {
  const Sandbox box;
  identify_in(box);
  const Outcome run =
      expect_done(box, {"report", "test", "--out", "-", "--no-pictures", "--title", "<Bolt>"});
  expect_parts_of(run.out, {"<h1>&lt;Bolt&gt;</h1>"});
  EXPECT_EQ(run.out.find("<img"), std::string::npos);
}

TEST(report, IsNamedAfterTheFolderHoweverThatIsWritten) {
  const Sandbox box;
  put_in_test(box, {{"levels.csv", sample_levels_text()}});
  for (const char* folder : {"test", "test/", "test/.", "./test/../test"}) {
    const Outcome run = expect_done(box, {"report", folder, "--out", "-", "--no-pictures"});
    expect_parts_of(run.out, {"<h1>test</h1>"});
  }
}

TEST(report, TellsThatTheJointIsNotFromTheseLevels) {
  const Sandbox box;
  identify_in(box);
  Levels other = sample_levels();
  other.dissipation.back() *= 1.001;
  box.put("test/levels.csv", levels_table(other).str());
  const std::string html = report_with_warning(box, "joint_from_other_levels", "levels.csv");
  expect_parts_of(html, {"according to its file not from the levels below"});
}

TEST(report, ABrokenRecordingIsAWarning) {
  const Sandbox box;
  identify_in(box);
  box.put("test/level_01.csv", "time [s],force [N]\n0,1\n");
  report_with_warning(box, "recording_not_shown", "level_01.csv");
}

TEST(report, SaysWhyNoRecordingCanBeShown) {
  const Sandbox box;
  put_in_test(box, {{"level_01.csv", "time [s],force [N]\n0,1\n0.1,nan\n"}});
  expect_refused(box, {"report", "test", "--out", "r.html"}, {"DIR = 'test'", "level_01.csv:3"});
}

// 1 s of a sine of 50 Hz.
std::string sine() {
  std::string text = "time [s],force [N]\n";
  for (int i = 0; i < 2000; ++i) {
    text += std::to_string(0.0005 * i) + "," + std::to_string(std::sin(0.157079632679 * i)) + "\n";
  }
  return text;
}

TEST(report, ARecordingBeforeControlThatIsBrokenLeavesItsLevel) {
  const Sandbox box;
  put_in_test(box, {{"level_01.csv", sine()}, {"before_control_01.csv", "broken\n"}});
  const std::string html = report_with_warning(box, "recording_not_shown", "before_control_01.csv");
  expect_parts_of(html, {"<h3>Force over time</h3>"});
}

TEST(report, ShowsAsManyRecordsOverTimeAsAreAskedForAndAllByTheirHarmonics) {
  const Sandbox box;
  put_in_test(box, {{"level_01.csv", sine()}, {"level_02.csv", sine()}, {"level_03.csv", sine()}});
  const auto charts_with = [](const std::string& html) {
    std::size_t count = 0;
    for (std::size_t at = html.find("\"level_02.csv\""); at != std::string::npos;
         at = html.find("\"level_02.csv\"", at + 1)) {
      ++count;
    }
    return count;
  };
  const Outcome some =
      expect_done(box, {"report", "test", "--out", "-", "--no-pictures", "--records", "2"});
  expect_parts_of(some.out, {"2 of the 3 records are shown over time"});
  EXPECT_EQ(charts_with(some.out), 1);
  const Outcome all =
      expect_done(box, {"report", "test", "--out", "-", "--no-pictures", "--records", "3"});
  EXPECT_EQ(all.out.find("are shown over time"), std::string::npos);
  EXPECT_EQ(charts_with(all.out), 2);
}

TEST(report, AJointWithoutItsIdentificationIsNotCalledIdentified) {
  const Sandbox box;
  put_in_test(box, {{"levels.csv", sample_levels_text()}, {"joint.json", kJointText}});
  const Outcome run = expect_done(box, {"report", "test", "--out", "-", "--no-pictures"});
  expect_parts_of(run.out, {"Its file does not state the method", "joint_of_unknown_origin"});
  EXPECT_EQ(run.out.find("was identified by"), std::string::npos);
  EXPECT_EQ(run.out.find("scatter of its levels"), std::string::npos);
}

TEST(report, ABandOfAnotherJointIsNotTaken) {
  const Sandbox box;
  identify_in(box);
  expect_done(box, {"identify", "test/levels.csv", "--stiffness", "1.9e5", "--out",
                    "test/joint.json", "--quiet"});
  const std::string html = report_with_warning(box, "density_of_other_joint", "density.csv");
  expect_parts_of(html, {"no band was computed"});
}

TEST(report, ADensityOfTheSameJointBringsItsBand) {
  const Sandbox box;
  identify_in(box);
  expect_done(box, {"identify", "test/levels.csv", "--stiffness", "1.7e5", "--out",
                    "test/joint.json", "--quiet"});
  const Outcome run = expect_done(box, {"report", "test", "--out", "-", "--no-pictures"});
  expect_parts_of(run.out, {"95 % band"});
  EXPECT_EQ(run.out.find("density_of_other_joint"), std::string::npos);
}

TEST(report, Refuses) {
  const Sandbox box;
  identify_in(box);
  box.put("notes.txt", "mine");
  std::filesystem::create_directory(box.file("empty"));
  expect_refused(box, {"report", "nowhere", "--out", "r.html"}, {"nowhere", "is not a folder"});
  expect_refused(box, {"report", "empty", "--out", "r.html"},
                 {"DIR = 'empty'", "must contain levels.csv, joint.json, recordings level_*"});
  expect_refused(box, {"report", ".", "--out", "r.html"}, {"There are levels in ./test."});
  std::filesystem::create_directory(box.file("alone"));
  std::filesystem::copy(box.file("test/density.csv"), box.file("alone/density.csv"));
  expect_refused(box, {"report", "alone", "--out", "r.html"}, {"DIR = 'alone'"});
  box.put("page.html", "<!doctype html><html><body>mine</body></html>");
  expect_refused(box, {"report", "test", "--out", "page.html"},
                 {"page.html", "exists and contains an HTML page", "a report of microslip"});
  expect_refused(box, {"report", "test", "--out", "notes.txt"}, {"notes.txt"});
  box.put("test/truth_joint.json", "{}");
  expect_refused(box, {"report", "test", "--out", "r.html"}, {"truth_joint.json"});
}

}  // namespace
}  // namespace microslip::cli_test::report_test
