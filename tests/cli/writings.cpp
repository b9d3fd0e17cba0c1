// SPDX-License-Identifier: MIT
#include "cli/writings.hpp"

#include <cmath>
#include <filesystem>

#include "cli/samples.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "support/replaced.hpp"

namespace microslip::cli_test {
namespace {

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

}  // namespace

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

void put_inputs(const Sandbox& box) {
  for (const char* name : {"model.toml", "joint.json"}) {
    box.put(name, test::get(std::string(MICROSLIP_EXAMPLES "/one_mass/") + name));
  }
  box.put("decay.csv", sample_decay_text());
  box.put("levels.csv", sample_levels_text());
  box.put("force.csv", force_text());
  std::filesystem::create_directory(box.file("test"));
  box.put("test/levels.csv", sample_levels_text());
  const std::string rig = MICROSLIP_EXAMPLES "/reference_rig/";
  const std::string two_levels =
      test::replaced(test::get(rig + "rig.toml"), "count = 90", "count = 2");
  box.put("rig.toml", test::replaced(two_levels, "\"joint.json\"", "\"rig.json\""));
  box.put("rig.json", test::get(rig + "joint.json"));
  box.put("level_05.csv", test::get(rig + "recordings/level_05.csv"));
}

}  // namespace microslip::cli_test
