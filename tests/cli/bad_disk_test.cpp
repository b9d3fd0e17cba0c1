// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cli/models.hpp"
#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "microslip/io/csv_writer.hpp"

/// Every format that is written, where it cannot be written whole: status 1, one message, nothing
/// at the final name and nothing beside it. A limit of the size of files stands for a full disk,
/// since it needs no rights: from some byte on the system takes no more. A disk that reports its
/// error late, when the file is synced, closed or renamed, is played by failing_calls.

namespace microslip::cli_test::bad_disk_test {
namespace {

namespace fs = std::filesystem;

/// One call and the file that it makes.
struct Writing {
  std::string out;
  Arguments call;
};

void PrintTo(const Writing& writing, std::ostream* to) { *to << writing.out; }

std::vector<Writing> all_writings() {
  std::vector<Writing> all;
  for (const char* out : {"rec.csv", "rec.uff", "rec.mat", "rec.h5"}) {
    all.push_back({out, {"convert", "decay.csv", out}});
  }
  all.push_back({"text.uff", {"convert", "decay.csv", "text.uff", "--format", "uff-ascii"}});
  all.push_back(
      {"found.json", {"identify", "levels.csv", "--stiffness", "1.7e5", "--out", "found.json"}});
  all.push_back({"density.csv",
                 {"identify", "levels.csv", "--stiffness", "1.7e5", "--out", "found.json",
                  "--density-csv", "density.csv"}});
  all.push_back({"loop.csv", {"loop", "joint.json", "--amplitude", "9um", "--out", "loop.csv"}});
  all.push_back({"curve.csv",
                 {"dissipation", "joint.json", "--amplitude", "1um:9um:40", "--out", "curve.csv"}});
  all.push_back(
      {"decays.csv", {"ringdown", "decay.csv", "--modal-mass", "2", "--out", "decays.csv"}});
  all.push_back({"back.csv",
                 {"backbone", "model.toml", "--response", "1um:1mm:20:log", "--out", "back.csv"}});
  all.push_back(
      {"march.csv", {"march", "model.toml", "--force-file", "force.csv", "--out", "march.csv"}});
  all.push_back(
      {"frf.csv",
       {"frf", "model.toml", "--force", "0.1", "--frequency", "0.13:0.16", "--out", "frf.csv"}});
  all.push_back({"made.toml", {"model", "rig.toml", "rig.json", "--out", "made.toml"}});
  all.push_back({"reduced.csv", {"reduce", "rig.toml", "level_05.csv", "--out", "reduced.csv"}});
  const Arguments verify{"verify", "rig.toml", "rig.json", "level_05.csv", "--out", "verified.csv"};
  all.push_back({"verified.csv", verify});
  all.push_back({"harmonics.csv", with(verify, {"--harmonics-csv", "harmonics.csv"})});
  all.push_back({"histories.csv", with(verify, {"--histories", "histories.csv"})});
  all.push_back({"record.svg", with(verify, {"--picture", "record.svg"})});
  for (const char* out : {"levels.svg", "levels.png", "levels.pdf"}) {
    all.push_back({out, {"plot", "levels.csv", "--out", out}});
  }
  all.push_back({"report.html", {"report", "test", "--no-pictures", "--out", "report.html"}});
  all.push_back({"made/level_01.csv",
                 {"measure", "rig.toml", "--out", "made", "--format", "csv", "--seed", "1"}});
  return all;
}

std::string edited(std::string text, const std::string& before, const std::string& after) {
  return text.replace(text.find(before), before.size(), after);
}

/// A push of a half sine.
std::string force_text() {
  std::vector<double> time;
  std::vector<double> force;
  for (int i = 0; i <= 200; ++i) {
    time.push_back(1e-3 * i);
    force.push_back(i < 20 ? 20.0 * std::sin(0.157 * i) : 0.0);
  }
  CsvWriter writer;
  writer.add_numbers("time", kTime, time);
  writer.add_numbers("force", kForce, force);
  return writer.str();
}

class BadDisk : public ::testing::TestWithParam<Writing> {
 protected:
  BadDisk() : box_(one_mass()) {
    box_.put("decay.csv", sample_decay_text());
    box_.put("levels.csv", sample_levels_text());
    box_.put("force.csv", force_text());
    fs::create_directory(box_.file("test"));
    box_.put("test/levels.csv", sample_levels_text());
    const std::string rig = MICROSLIP_EXAMPLES "/reference_rig/";
    box_.put("rig.toml", edited(edited(test::get(rig + "rig.toml"), "count = 90", "count = 2"),
                                "\"joint.json\"", "\"rig.json\""));
    box_.put("rig.json", test::get(rig + "joint.json"));
    box_.put("level_05.csv", test::get(rig + "recordings/level_05.csv"));
    given_ = box_.content();
  }

  /// The size of the file that the call makes where nothing hinders it; all that it made is
  /// removed.
  std::size_t whole_size() const {
    expect_made();
    const std::size_t size = fs::file_size(box_.file(GetParam().out));
    remove_made();
    return size;
  }

  void remove_made() const {
    for (const auto& [name, text] : box_.content()) {
      if (!given_.contains(name)) fs::remove_all(name);
    }
    EXPECT_TRUE(box_.content() == given_);
  }

  void expect_made() const {
    const Outcome run = box_.run(GetParam().call);
    ASSERT_EQ(run.status, 0) << run.err;
    ASSERT_TRUE(box_.has(GetParam().out));
  }

  Sandbox box_;
  std::map<std::string, std::string> given_;
};

TEST_P(BadDisk, ThatIsFullLeavesNothing) {
  constexpr std::size_t kMessage = 700;  // which goes to a file here, too
  const std::size_t whole = whole_size();
  std::set<std::size_t> sizes;
  for (const std::size_t size : {kMessage, whole / 3, whole / 2, whole * 9 / 10, whole - 1}) {
    if (size >= kMessage && size < whole) sizes.insert(size);
  }
  ASSERT_FALSE(sizes.empty()) << whole << " bytes are too few to be cut";
  for (const std::size_t size : sizes) {
    SCOPED_TRACE(size);
    expect_unwritten(box_, GetParam().call, {"annot be written"}, {.file_size = size});
  }
  expect_made();
}

/// Whether the program came to the `number`th such call; it then has to be as if it had not run.
bool failed(const Sandbox& box, const Arguments& call, const std::string& what, int number) {
  SCOPED_TRACE(what + " " + std::to_string(number));
  const Sandbox outside;
  const std::vector<std::string> environment{
      "LD_PRELOAD=" MICROSLIP_FAILING_CALLS,
      "ASAN_OPTIONS=verify_asan_link_order=0",
      "MICROSLIP_FAILING_FOLDER=" + fs::canonical(box.path()).string(),
      "MICROSLIP_FAILING_CALL=" + what,
      "MICROSLIP_FAILING_NUMBER=" + std::to_string(number),
      "MICROSLIP_FAILED=" + outside.file("failed")};
  const auto before = box.content();
  const Outcome run = box.run(call, {.environment = environment});
  if (!outside.has("failed")) {
    EXPECT_EQ(run.status, 0) << run.err;
    return false;
  }
  EXPECT_EQ(run.status, 1) << run.err;
  EXPECT_NE(run.err.find("Input/output error"), std::string::npos) << run.err;
  EXPECT_TRUE(box.content() == before) << "something was left";
  return true;
}

TEST_P(BadDisk, ThatFailsLateLeavesNothing) {
  for (const char* call : {"close", "fsync", "rename"}) {
    int number = 1;
    while (!HasFailure() && failed(box_, GetParam().call, call, number)) ++number;
    EXPECT_GT(number, 1) << "never called: " << call;
    if (HasFailure()) return;
    remove_made();
  }
}

INSTANTIATE_TEST_SUITE_P(EachFormat, BadDisk, ::testing::ValuesIn(all_writings()),
                         [](const auto& each) {
                           std::string name = each.param.out;
                           std::ranges::replace_if(
                               name, [](char c) { return std::isalnum(c) == 0; }, '_');
                           return name;
                         });

}  // namespace
}  // namespace microslip::cli_test::bad_disk_test
