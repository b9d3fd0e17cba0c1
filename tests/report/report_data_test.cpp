// SPDX-License-Identifier: MIT
#include "microslip/report/page/report_data.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace microslip::report_data_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

ReportDocument with_layer(Layer layer) {
  ReportFigure figure{.figure = {.title = "Loss",
                                 .x = {.label = "A", .unit = "µm", .log = true},
                                 .y = {.label = "D", .unit = "mJ", .log_switch = true},
                                 .layers = {std::move(layer)}}};
  return {.title = "T", .sections = {{"S", {ReportText{"text"}}}, {"S", {figure}}}};
}

nlohmann::json first_figure(const ReportDocument& document) {
  return nlohmann::json::parse(report_data(document)).at(0);
}

nlohmann::json first_trace(const ReportDocument& document) {
  return first_figure(document)["choices"][0]["traces"][0];
}

TEST(ReportData, FigureWithItsAxes) {
  const nlohmann::json figure =
      first_figure(with_layer(LineLayer{.x = {1.0}, .y = {2.0}, .legend = "a"}));
  EXPECT_EQ(figure["section"], 1);
  EXPECT_EQ(figure["x"]["unit"], "µm");
  EXPECT_EQ(figure["x"]["log"], true);
  EXPECT_EQ(figure["y"]["switch"], true);
  EXPECT_EQ(figure["chart"], "plot");
}

TEST(ReportData, EveryStyleHasItsName) {
  const auto style = [](LineStyle of) {
    return first_trace(with_layer(
        LineLayer{.x = {1.0}, .y = {2.0}, .legend = "a", .stroke = {.style = of}}))["style"];
  };
  EXPECT_EQ(style(LineStyle::kSolid), "solid");
  EXPECT_EQ(style(LineStyle::kDashed), "dash");
  EXPECT_EQ(style(LineStyle::kDotted), "dot");
  EXPECT_EQ(style(LineStyle::kDashDotted), "dashdot");
  EXPECT_EQ(style(LineStyle::kLongDashed), "longdash");
}

TEST(ReportData, WhatIsNotFiniteIsNull) {
  const nlohmann::json trace =
      first_trace(with_layer(LineLayer{.x = {1.0, 2.0}, .y = {kNan, 0.1}, .legend = "a"}));
  EXPECT_TRUE(trace["y"][0].is_null());
  EXPECT_EQ(trace["y"][1], 0.1);
}

// Half a unit of the seventh digit is 5e-7 relative.
TEST(ReportData, NumbersHaveSevenDigits) {
  const double value = 1.0 / 3.0;
  const nlohmann::json trace =
      first_trace(with_layer(LineLayer{.x = {value}, .y = {-value}, .legend = "a"}));
  EXPECT_NEAR(trace["x"][0].get<double>(), value, 5e-7 * value);
  EXPECT_EQ(trace["x"][0].dump(), "0.3333333");
}

TEST(ReportData, NumbersBelowTheNormalOnesAreTaken) {
  const nlohmann::json trace =
      first_trace(with_layer(LineLayer{.x = {1.0, 2.0}, .y = {1e-310, -5e-324}, .legend = "a"}));
  EXPECT_NEAR(trace["y"][0].get<double>(), 0.0, 2e-310);
  EXPECT_NEAR(trace["y"][1].get<double>(), 0.0, 2e-310);
}

TEST(ReportData, LongEvenAxesAreThreeNumbers) {
  std::vector<double> x;
  for (std::size_t i = 0; i < 100; ++i) x.push_back(0.5 + 0.25 * static_cast<double>(i));
  const nlohmann::json even = first_trace(with_layer(LineLayer{.x = x, .y = x, .legend = "a"}));
  EXPECT_EQ(even["x"]["from"], 0.5);
  EXPECT_EQ(even["x"]["step"], 0.25);
  EXPECT_EQ(even["x"]["count"], 100);
  std::vector<double> bent = x;
  bent[50] += 1e-3;
  EXPECT_TRUE(first_trace(with_layer(LineLayer{.x = bent, .y = x, .legend = "a"}))["x"].is_array());
}

TEST(ReportData, TheSameXIsThereOnce) {
  ReportDocument document = with_layer(LineLayer{.x = {1.0, 2.0}, .y = {3.0, 4.0}, .legend = "a"});
  auto& figure = std::get<ReportFigure>(document.sections[1].blocks[0]);
  figure.figure.layers.emplace_back(LineLayer{{1.0, 3.0}, {3.0, 4.0}, "b"});
  figure.figure.layers.emplace_back(LineLayer{{1.0, 3.0}, {5.0, 6.0}, "c"});
  const nlohmann::json traces = first_figure(document)["choices"][0]["traces"];
  EXPECT_TRUE(traces[0]["x"].is_array());
  EXPECT_TRUE(traces[1]["x"].is_array());
  EXPECT_EQ(traces[2]["x"]["of"], 1);
}

TEST(ReportData, ANameThatSaysMoreThanTheLegend) {
  const auto trace = first_trace(with_layer(LineLayer{.x = {1.0}, .y = {1.0}, .legend = "a"}));
  EXPECT_EQ(trace["name"], "a");
  EXPECT_EQ(trace["group"], "a");
  const auto more = first_trace(
      with_layer(LineLayer{.x = {1.0}, .y = {1.0}, .legend = "g", .name = "a", .shown = false}));
  EXPECT_EQ(more["name"], "a");
  EXPECT_EQ(more["group"], "g");
  EXPECT_EQ(more["shown"], false);
}

TEST(ReportData, EveryKindOfLayer) {
  const nlohmann::json points = first_trace(with_layer(
      PointLayer{.x = {1.0}, .y = {2.0}, .x_error = {0.1}, .y_error = {0.2}, .colour = kGreen}));
  EXPECT_EQ(points["kind"], "points");
  EXPECT_EQ(points["colour"], kGreen);
  EXPECT_EQ(points["xStd"][0], 0.1);
  EXPECT_EQ(points["yStd"][0], 0.2);
  const nlohmann::json band =
      first_trace(with_layer(BandLayer{.x = {1.0}, .lower = {2.0}, .upper = {3.0}}));
  EXPECT_EQ(band["kind"], "band");
  EXPECT_EQ(band["lower"][0], 2.0);
  EXPECT_EQ(band["upper"][0], 3.0);
  EXPECT_FALSE(band.contains("y"));
  const nlohmann::json marker = first_trace(with_layer(MarkerLayer{.x = 4.0, .label = "m"}));
  EXPECT_EQ(marker["kind"], "marker");
  EXPECT_EQ(marker["x"][0], 4.0);
  EXPECT_EQ(marker["group"], "m");
  EXPECT_EQ(first_trace(with_layer(LoopLayer{.x = {1.0}, .y = {2.0}}))["kind"], "loop");
  EXPECT_EQ(first_trace(with_layer(BarLayer{.x = {1.0}, .y = {2.0}}))["kind"], "bars");
}

TEST(ReportData, NothingInItEndsAScriptElement) {
  const std::string name = "</script><!-- ]]> & \xE2\x80\xA8 \"\\";
  const std::string json =
      report_data(with_layer(LineLayer{.x = {1.0}, .y = {1.0}, .legend = name}));
  EXPECT_EQ(json.find_first_of("<>&"), std::string::npos);
  for (const char c : json) EXPECT_TRUE(c >= ' ' && c <= '~');
  EXPECT_EQ(nlohmann::json::parse(json)[0]["choices"][0]["traces"][0]["name"], name);
}

}  // namespace
}  // namespace microslip::report_data_test
