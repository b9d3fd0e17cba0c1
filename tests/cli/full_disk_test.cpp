// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "cli/models.hpp"
#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "microslip/io/csv_writer.hpp"

/// Every format that is written, where it cannot be written whole: status 1, one message, nothing at
/// the final name and nothing beside it. A limit of the size of files stands for a full disk, since it
/// needs no rights: from some byte on the system takes no more.

namespace microslip::cli_test {
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

class FullDisk : public testing::TestWithParam<Writing> {
 protected:
  FullDisk() : box_(one_mass()) {
    box_.put("decay.csv", sample_decay_text());
    box_.put("levels.csv", sample_levels_text());
    box_.put("force.csv", force_text());
    fs::create_directory(box_.file("test"));
    box_.put("test/levels.csv", sample_levels_text());
    const std::string rig = MICROSLIP_EXAMPLES "/reference_rig/";
    box_.put("rig.toml", edited(edited(test::get(rig + "rig.toml"), "count = 90", "count = 2"),
                                "\"joint.json\"", "\"rig.json\""));
    box_.put("rig.json", test::get(rig + "joint.json"));
  }

  /// The size of the file that the call makes where nothing hinders it; all that it made is removed.
  std::size_t whole_size() const {
    const auto before = box_.content();
    expect_made();
    const std::size_t size = fs::file_size(box_.file(GetParam().out));
    for (const auto& [name, text] : box_.content()) {
      if (!before.contains(name)) fs::remove_all(name);
    }
    EXPECT_TRUE(box_.content() == before);
    return size;
  }

  void expect_made() const {
    const Outcome run = box_.run(GetParam().call);
    ASSERT_EQ(run.status, 0) << run.err;
    ASSERT_TRUE(box_.has(GetParam().out));
  }

  Sandbox box_;
};

TEST_P(FullDisk, LeavesNothing) {
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

INSTANTIATE_TEST_SUITE_P(EachFormat, FullDisk, testing::ValuesIn(all_writings()),
                         [](const auto& each) {
                           std::string name = each.param.out;
                           std::ranges::replace_if(
                               name, [](char c) { return std::isalnum(c) == 0; }, '_');
                           return name;
                         });

}  // namespace
}  // namespace microslip::cli_test
