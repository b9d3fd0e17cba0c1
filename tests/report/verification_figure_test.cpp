// SPDX-License-Identifier: MIT
#include "microslip/report/figures/verification_figure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/workflow/results/verified_results.hpp"
#include "report/support.hpp"

namespace microslip::verification_figure_test {
namespace {

constexpr double kOmega = 2.0 * std::numbers::pi * 50.0;  // rad/s

/// Recorded harmonics 2, 0 and 0.5; predicted 3, 0 and 0.25.
ChannelComparison channel(const std::string& name, const Dimension& dimension,
                          const std::vector<double>& history) {
  ChannelComparison made;
  made.name = name;
  made.dimension = dimension;
  made.recorded = {.omega = kOmega, .trend = {}, .harmonic = {2.0, 0.0, 0.5}};
  made.predicted = {.omega = kOmega, .trend = {}, .harmonic = {3.0, 0.0, 0.25}};
  made.recorded_std = {0.02, 0.02, 0.04};
  made.recorded_history = std::vector<double>(history.size(), 7.0);
  made.nrmse = 0.0123;
  made.noise_share = 0.004;
  return made;
}

/// A cycle of 20 ms that starts at 1 s, 1 ms between samples.
Verification record(const std::string& source, double response) {
  Verification made;
  made.recorded.source = source;
  made.recorded.response_amplitude = response;
  made.recorded.frequency = 50.0;
  for (int i = 0; i <= 20; ++i) made.history.push_back(1.0 + 0.001 * i);
  made.channels = {channel("force", kForce, made.history),
                   channel("other", kAcceleration, made.history),
                   channel("exciter", kAcceleration, made.history)};
  made.drive_point = 2;
  return made;
}

template <class L>
const L& layer(const Figure& panel, std::size_t i) {
  return std::get<L>(panel.layers.at(i));
}

FigureGrid figure_of(const std::vector<Verification>& records, const FigureOptions& options = {}) {
  ExperimentResults results;
  add_verified(records, results);
  return verification_figure(results, options);
}

TEST(VerificationFigure, DrawsARowOfTheLowestAMiddleAndTheHighestLevel) {
  const std::vector<Verification> records{record("a/four.csv", 4.0), record("one.csv", 1.0),
                                          record("two.csv", 2.0), record("three.csv", 3.0)};
  const FigureGrid figure = figure_of(records);
  ASSERT_EQ(figure.panels.size(), 9U);
  EXPECT_EQ(figure.columns, 3U);
  EXPECT_EQ(figure.panels[0].title, "1 m/s², 50.00 Hz");
  EXPECT_EQ(figure.panels[3].title, "2 m/s², 50.00 Hz");
  EXPECT_EQ(figure.panels[6].title, "4 m/s², 50.00 Hz");
  EXPECT_NO_THROW(check_figure(figure));
}

TEST(VerificationFigure, DrawsForceAndAccelerationAtTheExciterInTheirUnits) {
  const std::vector<Verification> records{record("one", 1.0)};
  const FigureGrid figure = figure_of(records);
  EXPECT_EQ(axis_text(figure.panels[0].y), "force [N]");
  EXPECT_EQ(axis_text(figure.panels[1].y), "exciter [m/s²]");
  EXPECT_EQ(figure.panels[1].subtitle, "NRMSE 1.2 %, noise 0.40 %");
  const auto& recorded = layer<PointLayer>(figure.panels[1], 1);
  EXPECT_NEAR(recorded.x.back(), 20.0, 1e-9) << "ms from the start of the history";
  EXPECT_EQ(recorded.y, std::vector<double>(21, 7.0));
  // 1 s is 50 cycles: 3 cos(100 π t) + 0.25 cos(300 π t), a whole cycle of it.
  const auto& predicted = layer<LineLayer>(figure.panels[1], 0);
  EXPECT_NEAR(predicted.y.front(), 3.25, 1e-9);
  EXPECT_NEAR(predicted.y.back(), 3.25, 1e-9);
  EXPECT_NEAR(predicted.x[predicted.x.size() / 2], 10.0, 1e-9);
  EXPECT_NEAR(predicted.y[predicted.y.size() / 2], -3.25, 1e-9);
}

// Over the first one recorded, 2; three standard errors of 0.04 over 2 are 0.06.
TEST(VerificationFigure, DrawsHarmonicsOverTheFirstRecorded) {
  const std::vector<Verification> records{record("one", 1.0)};
  const Figure panel = figure_of(records).panels[2];
  EXPECT_EQ(layer<BarLayer>(panel, 0).y, (std::vector<double>{1.0, 0.0, 0.25}));
  EXPECT_EQ(layer<BarLayer>(panel, 1).y, (std::vector<double>{1.5, 0.0, 0.125}));
  const auto& noise = std::get<LineLayer>(panel.layers.back());
  EXPECT_NEAR(noise.y.back(), 0.06, 1e-15);
}

TEST(VerificationFigure, TellsTheLevelInTheUnitThatIsAskedFor) {
  const std::vector<Verification> records{record("one", 0.2 * 9.80665)};
  EXPECT_EQ(figure_of(records, {.response_unit = "g"}).panels[0].title, "0.2 g, 50.00 Hz");
  EXPECT_THROW((void)figure_of(records, {.response_unit = "mm"}), InputError);
}

TEST(VerificationFigure, TellsTheRecordWithoutItsFolders) {
  const std::vector<Verification> records{record("a/four.csv", 4.0)};
  EXPECT_EQ(figure_of(records).panels[2].subtitle, "four.csv");
}

TEST(VerificationFigure, GrowsByTheRow) {
  const std::vector<Verification> one{record("one", 1.0)};
  const std::vector<Verification> two{record("one", 1.0), record("two", 2.0)};
  const PictureSize low = verification_size(figure_of(one));
  const PictureSize high = verification_size(figure_of(two));
  EXPECT_EQ(low.width, high.width);
  EXPECT_EQ(high.height - low.height, 340);
}

/// Two cycles in which the prediction is 0.5 above the record.
LevelRecord recorded(const std::string& source) {
  LevelRecord made{source, {}, {}};
  for (const std::string unit : {"N", "m/s^2"}) {
    made.signals.push_back(
        {unit == "N" ? "force" : "acc1", unit, {0.0, 0.01}, {1.0, 2.0}, {0.0, 0.01}, {1.5, 2.5}});
  }
  made.harmonics = {{"acc1", "m/s^2", {2.0, 0.5}, {2.5, 0.25}}};
  return made;
}

ExperimentResults files() {
  ExperimentResults made;
  for (const double response : {3.0, 1.0, 2.0, 4.0}) {
    const std::string source = "level " + std::to_string(static_cast<int>(response));
    made.predictions.push_back(recorded(source));
    for (const std::string channel : {"force", "acc1"}) {
      made.comparisons.push_back(
          {source, channel, "converged", 50.0, response, 0.0123, 0.01, 1.0, 0.0});
    }
  }
  return made;
}

TEST(VerificationFigureOfFiles, HasARowOfTheLowestAMiddleAndTheHighestLevel) {
  const FigureGrid figure = verification_figure(files());
  ASSERT_EQ(figure.panels.size(), 9U);
  EXPECT_EQ(figure.columns, 3U);
  EXPECT_EQ(figure.panels[0].title, "1 m/s², 50.00 Hz");
  EXPECT_EQ(figure.panels[0].subtitle, "NRMSE 1.2 %, noise 1.0 %");
  EXPECT_EQ(figure.panels[3].title, "2 m/s², 50.00 Hz");
  EXPECT_EQ(figure.panels[6].title, "4 m/s², 50.00 Hz");
  EXPECT_EQ(axis_text(figure.panels[1].y), "acc1 [m/s²]");
  EXPECT_EQ(layer<LineLayer>(figure.panels[1], 0).y, (std::vector<double>{1.5, 2.5}));
  EXPECT_EQ(layer<PointLayer>(figure.panels[1], 1).x, (std::vector<double>{0.0, 10.0}));
  EXPECT_EQ(layer<BarLayer>(figure.panels[2], 0).y, (std::vector<double>{1.0, 0.25}));
  EXPECT_EQ(layer<BarLayer>(figure.panels[2], 1).y, (std::vector<double>{1.25, 0.125}));
  EXPECT_NO_THROW(check_figure(figure));
}

TEST(VerificationFigureOfFiles, NeedsNeitherComparisonsNorHarmonics) {
  ExperimentResults bare;
  bare.predictions = {recorded("one")};
  bare.predictions[0].harmonics.clear();
  const FigureGrid figure = verification_figure(bare);
  ASSERT_EQ(figure.panels.size(), 2U);
  EXPECT_EQ(figure.columns, 2U);
  EXPECT_EQ(figure.panels[0].title, "one");
  EXPECT_TRUE(figure.panels[0].subtitle.empty());
  EXPECT_THROW((void)verification_figure(ExperimentResults{}), InputError);
}

}  // namespace
}  // namespace microslip::verification_figure_test
