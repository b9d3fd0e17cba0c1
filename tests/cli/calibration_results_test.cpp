// SPDX-License-Identifier: MIT
// `report` and `plot` of what `calibrate` reads and writes.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"

namespace microslip::cli_test::calibration_results_test {
namespace {

const std::string kData = MICROSLIP_TEST_DATA "/two_joints/";

/// Made once: a calibration takes seconds.
const Sandbox& calibrated() {
  static const Sandbox made{{"model.toml", test::get(kData + "model.toml")},
                            {"levels.csv", test::get(kData + "modal_levels.csv")}};
  if (!made.has("found")) {
    expect_done(made, {"calibrate", "model.toml", "levels.csv", "--samples", "100", "--out",
                       "found", "--keep-samples"});
  }
  return made;
}

class calibration_results : public ::testing::Test {
 protected:
  calibration_results() {
    std::filesystem::copy(calibrated().path(), box.path(),
                          std::filesystem::copy_options::recursive);
  }

  std::string report(const std::string& folder) {
    expect_done(box, {"report", folder, "--out", "r.html", "--no-pictures"});
    return box.get("r.html");
  }

  std::string svg(const std::vector<std::string>& in, const std::string& figure) {
    Arguments call{"plot"};
    call.insert(call.end(), in.begin(), in.end());
    if (!figure.empty()) call.insert(call.end(), {"--figure", figure});
    return expect_done(box, with(call, {"--out", "-"})).out;
  }

  const Sandbox box;
};

void expect_texts(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST_F(calibration_results, AreReported) {
  const std::string html = report("found");
  expect_texts(html, {"The slip-force densities of 2 joints were found from 75 levels of 3 modes",
                      "The levels distinguish the joints", "Slip-force densities", "Loss per cycle",
                      "Residuals of the frequencies", "Share of joint2 in the loss",
                      "Variance reduction", "distinguished", "joints found by"});
  EXPECT_EQ(html.find("Not in this report"), std::string::npos);
}

TEST_F(calibration_results, TellWhatHalfOfAFolderLacks) {
  std::filesystem::remove(box.file("found/calibration.json"));
  expect_texts(report("found"), {"No calibration.json in this folder", "Loss per cycle"});
  std::filesystem::remove(box.file("found/calibration.csv"));
  expect_texts(report("found"), {"no calibration.csv in this folder", "Slip-force densities"});
  std::filesystem::remove(box.file("found/identifiability.csv"));
  expect_refused(box, {"report", "found", "--out", "q.html"},
                 {"what microslip calibrate or campaign writes", "microslip calibrate"});
  // Levels of modes alone, under the name of levels of one joint.
  expect_texts(report("."), {"no joint was identified from them yet", "Frequency"});
}

TEST_F(calibration_results, TellFilesThatDoNotBelongTogether) {
  std::string table = box.get("found/calibration.csv");
  const std::string mark = "sha256[";
  const std::size_t at = table.find("] = ", table.find(mark));
  ASSERT_NE(at, std::string::npos);
  box.put("found/calibration.csv", table.insert(at + 4, "0"));
  const Outcome run = box.run({"report", "found", "--out", "r.html", "--no-pictures"});
  EXPECT_EQ(run.status, 0);
  expect_texts(run.err, {"calibration.csv", "calibration.json"});
  expect_texts(box.get("r.html"), {"files_of_other_calibration"});
}

TEST_F(calibration_results, AreDrawn) {
  expect_texts(svg({"found"}, "densities"), {"joint1", "joint2", "slip force f* [N]"});
  expect_texts(svg({"found/identifiability.csv"}, "identifiability"),
               {"variance reduction [1]", "half"});
  for (const std::string input : {"found", "found/calibration.csv"}) {
    expect_texts(svg({input}, "modal-losses"),
                 {"mode 3", "dissipation of all joints [mJ]", "measured less found loss [%]"});
    expect_texts(svg({input}, "modal-frequencies"), {"mode 1", "change of frequency [%]"});
    expect_texts(svg({input}, "modal-damping"), {"damping ratio ζ [%]"});
    expect_texts(svg({input}, "modal-residuals"), {"residual of the frequency [1]"});
    expect_texts(svg({input}, "joint-amplitudes"), {"joint over response [1]", "joint2"});
    expect_texts(svg({input}, "loss-shares"), {"share of the loss [%]", "joint1"});
  }
  expect_texts(svg({"found/joint2_samples.h5"}, ""), {"95 % band of 100 draws", "40 of them"});
  expect_texts(svg({"levels.csv"}, "modal-losses"), {"dissipation of all joints [mJ]", "mode 2"});
  expect_texts(svg({"found/joint1.json", "found/joint2.json"}, ""), {"joint1", "joint2"});
}

TEST_F(calibration_results, AreRefusedWithARemedy) {
  expect_refused(box, {"plot", "found"}, {"must name one of several", "identifiability"});
  expect_refused(box, {"plot", "levels.csv", "--figure", "loss-shares"},
                 {"calibration.csv", "modal-losses"});
  expect_refused(box, {"plot", "found/calibration.json"}, {"calibration.csv"});
  expect_refused(box, {"plot", "found/joint1.json", "levels.csv"}, {"levels.csv", "joint.json"});
  std::string text = box.get("found/calibration.json");
  const std::size_t at = text.find("\"pair_verdict\"");
  ASSERT_NE(at, std::string::npos);
  box.put("found/calibration.json", text.replace(at, 14, "\"pair_opinion\""));
  expect_refused(box, {"report", "found", "--out", "q.html"},
                 {"calibration.pair_verdict", "microslip calibrate"});
  box.put("found/calibration.json", box.get("found/joint1.json"));
  expect_refused(box, {"report", "found", "--out", "q.html"}, {"microslip.calibration/1"});
}

}  // namespace
}  // namespace microslip::cli_test::calibration_results_test
