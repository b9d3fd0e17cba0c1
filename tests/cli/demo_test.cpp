// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cstdint>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>

#include "cli/run_program.hpp"
#include "microslip/io/density_file.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/io/levels_file.hpp"

namespace microslip::cli_test {
namespace {

namespace fs = std::filesystem;

std::set<std::string> names_in(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
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

/// What the file is by its name is what its reader takes.
void expect_readable(const std::string& path) {
  SCOPED_TRACE(path);
  const std::string text = test::get(path);
  if (path.ends_with(".png")) {
    expect_png(text);
  } else if (path.ends_with(".svg")) {
    expect_svg(text);
  } else if (path.ends_with("joint.json")) {
    const JointFile file = read_joint(path);
    EXPECT_GT(file.joint.stiffness(), 0.0);
    ASSERT_TRUE(file.provenance);
    EXPECT_EQ(file.provenance->inputs.size(), 1U);
  } else if (path.ends_with("density.csv")) {
    EXPECT_GT(read_density(path).slip_force.size(), 10U);
    EXPECT_FALSE(read_density(path).upper.empty());
  } else if (path.ends_with("levels.csv")) {
    EXPECT_GE(read_levels(path).levels.size(), 8U);
  } else {
    ADD_FAILURE() << "what is this?";
  }
}

// One run for all that is asked of it: it takes seconds.
TEST(demo, WritesJointsDensitiesAndPictures) {
  const Sandbox box;
  const Outcome run = expect_done(box, {"demo", "--out", "demo"});
  const std::set<std::string> names = names_in(box.file("demo"));
  for (const std::string& name : names) expect_readable(box.file("demo/" + name));
  for (const std::string name : {"brake_reuss_beam_joint.json", "brake_reuss_beam_density.csv",
                                 "brake_reuss_beam_dissipation.svg", "brake_reuss_beam_density.svg",
                                 "reference_joint_levels.csv", "reference_joint_joint.json",
                                 "reference_joint_density.csv", "reference_joint_dissipation.svg",
                                 "reference_joint_density.svg", "reference_joint_loops.svg"}) {
    EXPECT_EQ(names.count(name), 1U) << name;
    if (name.ends_with(".svg")) {
      EXPECT_EQ(names.count(name.substr(0, name.size() - 3) + "png"), 1U) << name;
      EXPECT_NE(run.out.find(name), std::string::npos) << name << " is not in the summary";
    }
  }
  EXPECT_NE(run.out.find("density error"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("demo"), std::string::npos) << run.out;
  EXPECT_EQ(names_in(box.path()), std::set<std::string>{"demo"});

  // Once more into the same folder: the same files, to the byte, and nothing said.
  const auto before = box.content();
  const Outcome again = expect_done(box, {"demo", "--out", "demo", "--quiet"});
  EXPECT_EQ(again.out, "");
  std::set<std::string> changed;
  for (const auto& [path, text] : box.content()) {
    const bool tells_the_call = path.ends_with("joint.json");
    if (before.at(path) != text && !tells_the_call) changed.insert(path);
  }
  EXPECT_EQ(changed, std::set<std::string>{});
}

TEST(demo, ReplacesNothingOfAnotherKind) {
  const Sandbox box;
  fs::create_directory(box.file("demo"));
  box.put("demo/reference_joint_density.csv", "my notes\n");
  expect_refused(box, {"demo", "--out", "demo"}, {"reference_joint_density.csv", "Remove it"});
}

TEST(demo, NeedsAFolder) {
  const Sandbox box{{"file", "x"}};
  expect_refused(box, {"demo", "--out", "file"}, {"file", "--out"});
  expect_refused(box, {"demo", "--out", "file/demo"}, {"file/demo", "--out"});
  expect_refused(box, {"demo", "--out", ""}, {"--out"});
}

}  // namespace
}  // namespace microslip::cli_test
