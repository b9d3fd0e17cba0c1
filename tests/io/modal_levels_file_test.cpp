// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/modal_levels_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"

namespace microslip::modal_levels_file_test {
namespace {

const std::vector<std::string> kJoints{"lap", "foot"};

ModalLevels parse(const std::string& text) { return parse_modal_levels(text, "m.csv", kJoints, 3); }

std::string message(const std::string& text) {
  return test::message_of<FormatError>([&] { return parse(text); });
}

TEST(ModalLevelsFile, ReadsAllColumnsInTheirUnits) {
  const ModalLevels levels = parse(
      "mode [1],displacement [um],frequency [Hz],frequency_std [mHz],dissipation [mJ],"
      "dissipation_std [mJ],amplitude_foot [um],amplitude_foot_std [um],"
      "dissipation_foot [mJ],dissipation_foot_std [mJ],source,anything\n"
      "1,2,30,1,4,0.1,3,0.2,1,0.3,a,x\n3,5,90,2,6,0.2,4,0.1,2,0.1,b,y\n");
  EXPECT_EQ(levels.mode, (std::vector<std::size_t>{0, 2}));
  EXPECT_DOUBLE_EQ(levels.displacement[1], 5e-6);
  EXPECT_DOUBLE_EQ(levels.frequency_std[1], 2e-3);
  EXPECT_DOUBLE_EQ(levels.dissipation[0], 4e-3);
  EXPECT_DOUBLE_EQ(levels.dissipation_std[1], 2e-4);
  ASSERT_EQ(levels.joints.size(), 1U);
  EXPECT_EQ(levels.joints[0].name, "foot");
  EXPECT_DOUBLE_EQ(levels.joints[0].amplitude[0], 3e-6);
  EXPECT_DOUBLE_EQ(levels.joints[0].amplitude_std[1], 1e-7);
  EXPECT_DOUBLE_EQ(levels.joints[0].dissipation[1], 2e-3);
  EXPECT_DOUBLE_EQ(levels.joints[0].dissipation_std[0], 3e-4);
  EXPECT_TRUE(levels.damping_ratio.empty());
  check_modal_levels(levels);
}

TEST(ModalLevelsFile, LevelsOfSeveralFilesKeepWhatEachHas) {
  ModalLevels levels = parse("mode [1],displacement [m],dissipation [J]\n1,1e-6,1e-9\n");
  append(parse("mode [1],displacement [m],damping_ratio [1],amplitude_lap [m]\n2,2e-6,0.01,1e-7\n"),
         levels);
  ASSERT_EQ(levels.size(), 2U);
  check_modal_levels(levels);
  EXPECT_TRUE(std::isnan(ModalLevels::value(levels.damping_ratio, 0)));
  EXPECT_TRUE(std::isnan(ModalLevels::value(levels.dissipation, 1)));
  EXPECT_TRUE(std::isnan(ModalLevels::value(levels.joints[0].amplitude, 0)));
  EXPECT_DOUBLE_EQ(levels.joints[0].amplitude[1], 1e-7);
}

TEST(ModalLevelsFile, ReadsTheErrorOfTheDisplacement) {
  const ModalLevels levels =
      parse("mode [1],displacement [m],displacement_std [um],dissipation [J]\n1,1e-5,0.2,1e-9\n");
  ASSERT_EQ(levels.displacement_std.size(), 1U);
  EXPECT_DOUBLE_EQ(levels.displacement_std[0], 2e-7);
}

// The deviation of x, or the amplitude of x_std: refused where both are joints and the column is
// there.
TEST(ModalLevelsFile, AColumnOfTwoJointsIsRefused) {
  const std::vector<std::string> joints{"x", "x_std"};
  const std::string head = "mode [1],displacement [m],dissipation [J]";
  EXPECT_EQ(parse_modal_levels(head + "\n1,1e-6,1e-9\n", "m.csv", joints, 3).size(), 1U);
  const std::string found = test::message_of<FormatError>([&] {
    return parse_modal_levels(head + ",amplitude_x_std [m]\n1,1e-6,1e-9,1e-6\n", "m.csv", joints,
                              3);
  });
  EXPECT_NE(found.find("of joint 'x_std' or the standard deviation of 'x'"), std::string::npos)
      << found;
}

TEST(ModalLevelsFile, NamesWhatIsWrong) {
  const auto expect = [](const std::string& part, const std::string& text) {
    EXPECT_NE(message(text).find(part), std::string::npos) << part << " in: " << message(text);
  };
  const std::string head = "mode [1],displacement [m],dissipation [J]\n";
  expect("a mode of the model, from 1 to 3", head + "4,1e-6,1e-9\n");
  expect("a mode of the model, from 1 to 3", head + "0,1e-6,1e-9\n");
  expect("a mode of the model, from 1 to 3", head + "1.5,1e-6,1e-9\n");
  expect("m.csv:3", head + "1,1e-6,1e-9\n2,0,1e-9\n");
  expect("m.csv:2", head + "1,1e-6,-1e-9\n");
  expect("'dissipation [J]' or 'damping_ratio [1]'", "mode [1],displacement [m]\n1,1e-6\n");
  expect("Did you mean amplitude_lap?",
         "mode [1],displacement [m],dissipation [J],amplitude_lapp [m]\n1,1e-6,1e-9,1e-6\n");
  expect("columns of joints of the model: lap, foot",
         "mode [1],displacement [m],dissipation [J],dissipation_1 [J]\n1,1e-6,1e-9,1e-6\n");
  expect("unit", "mode [1],displacement,dissipation [J]\n1,1e-6,1e-9\n");
  expect("mode", "displacement [m],dissipation [J]\n1e-6,1e-9\n");
}

}  // namespace
}  // namespace microslip::modal_levels_file_test
