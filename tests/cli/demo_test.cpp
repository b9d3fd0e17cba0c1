// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>

#include "cli/run_program.hpp"
#include "microslip/documents/joint/density_file.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/documents/structure/rig_file.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "support/built_file.hpp"
#include "support/effort.hpp"

namespace microslip::cli_test::demo_test {
namespace {

namespace fs = std::filesystem;

/// All files below a folder, by their path from it.
std::set<std::string> names_in(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) names.insert(fs::relative(entry.path(), folder).string());
  }
  return names;
}

std::uint32_t big_endian(const std::string& text, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value << 8U | static_cast<unsigned char>(text.at(at + i));
  return value;
}

/// The signature, IHDR with a size, whole chunks one behind the other, IEND and nothing more.
void expect_png(const std::string& text) {
  constexpr std::size_t kAround = 12;  // length, type and checksum of a chunk
  ASSERT_TRUE(text.starts_with("\x89PNG\r\n\x1A\n"));
  std::string types;
  for (std::size_t at = 8; at < text.size();) {
    ASSERT_LE(at + kAround, text.size());
    const std::string type = text.substr(at + 4, 4);
    if (type == "IHDR") {
      EXPECT_GE(big_endian(text, at + 8), 300U) << "wide";
      EXPECT_GE(big_endian(text, at + 12), 200U) << "high";
    }
    types += type;
    at += kAround + big_endian(text, at);
    ASSERT_LE(at, text.size());
  }
  EXPECT_TRUE(types.starts_with("IHDR"));
  EXPECT_TRUE(types.ends_with("IEND"));
}

void expect_svg(const std::string& text) {
  std::istringstream stream(text);
  boost::property_tree::ptree tree;
  ASSERT_NO_THROW(boost::property_tree::read_xml(stream, tree));
  ASSERT_EQ(tree.count("svg"), 1U);
  EXPECT_GT(std::stod(tree.get<std::string>("svg.<xmlattr>.width")), 100.0);
  EXPECT_NE(text.find("<path"), std::string::npos);
}

void expect_joint(const std::string& path) {
  const JointFile file = read_joint(path);
  EXPECT_GT(file.joint.stiffness(), 0.0);
  if (path.ends_with("truth_joint.json")) return;
  ASSERT_TRUE(file.provenance);
  EXPECT_EQ(file.provenance->inputs.size(), 1U);
}

void expect_density(const std::string& path) {
  const DensityTable density = read_density(path);
  EXPECT_GT(density.slip_force.size(), 10U);
  EXPECT_FALSE(density.upper.empty());
}

/// A page of at most 4 MB that lacks no section but those a measured bolt cannot have.
void expect_report(const std::string& path) {
  const std::string html = test::get(path);
  EXPECT_TRUE(html.starts_with("<!doctype html>"));
  EXPECT_LE(html.size(), 4'000'000U);
  EXPECT_EQ(html.find("pictures_missing"), std::string::npos);
  EXPECT_NE(html.find("<h3>Slip-force density</h3>"), std::string::npos);
  if (path.find("brake_reuss_beam") != std::string::npos) return;
  EXPECT_EQ(html.find("Not in this report"), std::string::npos);
  for (const char* title :
       {"Force over time", "Force control over the levels", "Energies per cycle",
        "Regenerated loops", "Resonance frequency", "Secant stiffness",
        "Frequency responses at constant response", "Misfit of the prediction"}) {
    EXPECT_NE(html.find("<h3>" + std::string(title) + "</h3>"), std::string::npos) << title;
  }
}

/// What the file is by its name is what its reader takes.
void expect_readable(const std::string& path) {
  SCOPED_TRACE(path);
  if (path.ends_with(".png")) {
    expect_png(test::get(path));
  } else if (path.ends_with(".svg")) {
    expect_svg(test::get(path));
  } else if (path.ends_with("joint.json")) {
    expect_joint(path);
  } else if (path.ends_with("density.csv")) {
    expect_density(path);
  } else if (path.ends_with("/levels.csv") || path.ends_with("/truth.csv")) {
    EXPECT_GE(read_levels(path).levels.size(), 8U);
  } else if (path.ends_with("rig.toml")) {
    EXPECT_EQ(read_rig(path).accelerometers.size(), 3U);
  } else if (path.ends_with("report.html")) {
    expect_report(path);
  } else if (path.find("/recordings/level_") != std::string::npos ||
             path.find("/recordings/before_control_") != std::string::npos) {
    EXPECT_EQ(read_recordings(path, {}).recordings.at(0).size(), 8192U);
  } else {
    EXPECT_TRUE(path.ends_with("force_control.csv") || path.ends_with("verification.csv") ||
                path.ends_with("verification_harmonics.csv") ||
                path.ends_with("verification_histories.csv"))
        << "what is this?";
  }
}

/// The figure behind a name in the summary.
double figure_in(const std::string& summary, const std::string& name) {
  const auto at = summary.find("  " + name + " ");
  EXPECT_NE(at, std::string::npos) << name;
  if (at == std::string::npos) return std::nan("");
  const auto digit = summary.find_first_of("0123456789", at + 2 + name.size());
  return std::stod(summary.substr(digit));
}

/// Where one run of the demonstration, the fixture of this suite, has left its folder and summary.
const std::string kRun = test::built_file("MICROSLIP_DEMO_RUN", MICROSLIP_DEMO_RUN);

TEST(demo, RunsTheWholeChain) {
  const std::string summary = test::get(kRun + "/summary.txt");
  const std::set<std::string> names = names_in(kRun + "/demo");
  for (const std::string& name : names) expect_readable(kRun + "/demo/" + name);
  for (const std::string name : {"brake_reuss_beam/joint.json",
                                 "brake_reuss_beam/density.svg",
                                 "brake_reuss_beam/report.html",
                                 "reference_rig/report.html",
                                 "reference_rig/rig.toml",
                                 "reference_rig/recordings/before_control_90.csv",
                                 "reference_rig/recordings/level_01.csv",
                                 "reference_rig/recordings/level_90.csv",
                                 "reference_rig/truth.csv",
                                 "reference_rig/force_control.csv",
                                 "reference_rig/levels.csv",
                                 "reference_rig/joint.json",
                                 "reference_rig/density.csv",
                                 "reference_rig/verification.csv",
                                 "reference_rig/resonance.svg",
                                 "reference_rig/force_control.svg",
                                 "reference_rig/energies.svg",
                                 "reference_rig/dissipation.svg",
                                 "reference_rig/density.svg",
                                 "reference_rig/loops.svg",
                                 "reference_rig/constant_response.svg",
                                 "reference_rig/verification.svg"}) {
    EXPECT_EQ(names.count(name), 1U) << name;
    if (name.ends_with(".svg")) {
      EXPECT_EQ(names.count(name.substr(0, name.size() - 3) + "png"), 1U) << name;
      EXPECT_NE(summary.find(name), std::string::npos) << name << " is not in the summary";
    }
  }
  // The main report is listed first.
  const auto rig_report = summary.find("  demo/reference_rig/report.html");
  ASSERT_NE(rig_report, std::string::npos) << summary;
  EXPECT_LT(rig_report, summary.find("  demo/brake_reuss_beam/report.html"));
  // What the chain must reach, in per cent; the truth is known.
  EXPECT_LE(figure_in(summary, "density error"), 5.0) << summary;
  EXPECT_GE(figure_in(summary, "95 % band          "), 90.0) << summary;
  EXPECT_EQ(names_in(kRun).size(), names.size() + 1) << "files beside the folder";
}

// Into the same folder: the same files, to the byte, and nothing said.
TEST(demo, GivesTheSameOnceMore) {
  MICROSLIP_STUDY();  // the code is that of the first run
  const Sandbox box;
  fs::copy(kRun + "/demo", box.file("demo"), fs::copy_options::recursive);
  const auto before = box.content();
  const Outcome again = expect_done(box, {"demo", "--out", "demo", "--quiet"});
  EXPECT_EQ(again.out, "");
  std::set<std::string> changed;
  for (const auto& [path, text] : box.content()) {
    const bool tells_the_call = path.ends_with("joint.json") || path.ends_with("report.html") ||
                                path.ends_with("verification.csv") ||
                                path.ends_with("verification_harmonics.csv") ||
                                path.ends_with("verification_histories.csv");
    if (before.at(path) != text && !tells_the_call) changed.insert(path);
  }
  EXPECT_EQ(changed, std::set<std::string>{});
}

TEST(demo, ReplacesNothingOfAnotherKind) {
  const Sandbox box;
  fs::create_directories(box.file("demo/reference_rig"));
  box.put("demo/reference_rig/density.csv", "my notes\n");
  expect_refused(box, {"demo", "--out", "demo"}, {"reference_rig/density.csv", "Remove it"});
}

// The reports come last; what stands in their way is reported before anything is written.
TEST(demo, ReplacesNoPageThatIsNone) {
  const Sandbox box;
  fs::create_directories(box.file("demo/brake_reuss_beam"));
  box.put("demo/brake_reuss_beam/report.html", "my notes\n");
  expect_refused(box, {"demo", "--out", "demo"}, {"brake_reuss_beam/report.html", "Remove it"});
  EXPECT_EQ(names_in(box.file("demo")).size(), 1U);
}

TEST(demo, NeedsAFolder) {
  const Sandbox box{{"file", "x"}};
  expect_refused(box, {"demo", "--out", "file"}, {"file", "--out"});
  expect_refused(box, {"demo", "--out", "file/demo"}, {"file/demo", "--out"});
  expect_refused(box, {"demo", "--out", ""}, {"--out"});
}

}  // namespace
}  // namespace microslip::cli_test::demo_test
