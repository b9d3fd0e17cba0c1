// SPDX-License-Identifier: MIT
#include "microslip/report/figures/record_figures.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "report/support.hpp"

namespace microslip::record_figures_test {
namespace {

ExperimentResults record_of(int accelerations) {
  LevelRecord record{.source = "level_01.csv", .signals = {}, .harmonics = {}};
  for (int i = 1; i <= accelerations; ++i) {
    const std::string name = "a" + std::to_string(i);
    record.signals.push_back({name, "m/s^2", {0.0, 1.0}, {1.0, 2.0}, {}, {}});
    record.harmonics.push_back({name, "m/s^2", {1.0, 0.1}, {}});
  }
  record.signals.push_back({"force", "N", {0.0, 1.0}, {1.0, 2.0}, {}, {}});
  return {.records = {record}};
}

ReportSection signals_of(const ExperimentResults& results) {
  ReportSection section{.title = "Signals", .blocks = {}};
  add_records(section, results, results.records, kControlNames);
  return section;
}

TEST(RecordFigures, EightChannelsOfAQuantityAtMostAndTheCaptionSaysSo) {
  const ReportSection section = signals_of(record_of(200));
  ASSERT_EQ(section.blocks.size(), 3);
  const auto& accelerations = std::get<ReportFigure>(section.blocks[0]);
  ASSERT_EQ(accelerations.choices[0].layers.size(), 8);
  EXPECT_EQ(name_of(accelerations.choices[0].layers[7]), "a8");
  EXPECT_EQ(accelerations.figure.caption,
            "The first 8 of the 200 channels of the record are shown.");
  const auto& force = std::get<ReportFigure>(section.blocks[1]);
  EXPECT_EQ(force.choices[0].layers.size(), 1);
  EXPECT_EQ(force.figure.caption, "");
  const auto& harmonics = std::get<ReportFigure>(section.blocks[2]);
  EXPECT_EQ(harmonics.choices[0].layers.size(), 9);  // with the line of 1 %
  EXPECT_TRUE(test::contains(harmonics.figure.caption, "The first 8 of the 200 channels"))
      << harmonics.figure.caption;
}

TEST(RecordFigures, AllOfFewChannels) {
  const ReportSection section = signals_of(record_of(8));
  const auto& accelerations = std::get<ReportFigure>(section.blocks[0]);
  EXPECT_EQ(accelerations.choices[0].layers.size(), 8);
  EXPECT_EQ(accelerations.figure.caption, "");
  EXPECT_FALSE(
      test::contains(std::get<ReportFigure>(section.blocks[2]).figure.caption, "channels"));
}

}  // namespace
}  // namespace microslip::record_figures_test
