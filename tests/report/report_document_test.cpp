// SPDX-License-Identifier: MIT
#include "microslip/report/document/report_document.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "report/support.hpp"

namespace microslip::report_document_test {
namespace {

using test::input_fault;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

ReportFigure figure_with(Layer layer) {
  return {.figure = {.title = "F",
                     .x = {.label = "A", .unit = "m"},
                     .y = {.label = "D", .unit = "J"},
                     .layers = {std::move(layer)}}};
}

std::string fault(ReportBlock block) {
  const ReportDocument document{.title = "T", .sections = {{"S", {std::move(block)}}}};
  return input_fault([&] { check_report(document); });
}

std::string layer_fault(Layer layer) { return fault(figure_with(std::move(layer))); }

const std::string kBlock = "sections[0].blocks[0].";
const std::string kLayer = kBlock + "figure.layers[0]";

// A value along y that is no number is a gap.
TEST(ReportDocument, AcceptsEveryKindOfLayer) {
  const std::vector<double> two = {1.0, 2.0};
  const std::vector<double> gap = {1.0, kNan};
  EXPECT_EQ(layer_fault(LineLayer{.x = two, .y = gap}), "no error");
  EXPECT_EQ(layer_fault(PointLayer{.x = two, .y = gap}), "no error");
  EXPECT_EQ(layer_fault(BarLayer{.x = two, .y = gap}), "no error");
  EXPECT_EQ(layer_fault(LoopLayer{.x = two, .y = two}), "no error");
  EXPECT_EQ(layer_fault(BandLayer{.x = {1.0}, .lower = {0.0}, .upper = {0.0}}), "no error");
  EXPECT_EQ(layer_fault(MarkerLayer{.x = 1.0}), "no error");
}

TEST(ReportDocumentFault, Layers) {
  EXPECT_EQ(layer_fault(LineLayer{}),
            kLayer + ".x.size() = 0; must be 1 or more. Leave an empty layer out.");
  EXPECT_EQ(layer_fault(LineLayer{.x = {1.0}, .y = {1.0}, .stroke = {.colour = -1}}),
            kLayer + ".colour = -1; must not be negative");
  EXPECT_EQ(layer_fault(LineLayer{.x = {1.0}}), kLayer + ".y.size() = 0; must be the 1 of x");
  EXPECT_EQ(layer_fault(LineLayer{.x = {kNan}, .y = {1.0}}),
            kLayer + ".x[0] = nan; must be finite, at most 1e100 in magnitude");
  EXPECT_EQ(layer_fault(PointLayer{.x = {1.0}, .y = {1.0}, .y_error = {-1.0}}),
            kLayer + ".y_error[0] = -1; must not be negative");
  EXPECT_EQ(layer_fault(BandLayer{.x = {1.0}, .lower = {1.0}, .upper = {0.5}}),
            kLayer + ".upper[0] = 0.5; must not be below lower[0] = 1");
  EXPECT_EQ(layer_fault(BarLayer{.x = {1.5}, .y = {1.0}}),
            kLayer + ".x[0] = 1.5; must be a whole number");
}

TEST(ReportDocumentFault, Figures) {
  const Layer line = LineLayer{.x = {1.0}, .y = {1.0}};
  ReportFigure figure = figure_with(line);
  figure.figure.y.unit = "";
  EXPECT_EQ(fault(figure), kBlock + "figure.y.unit = ''; must not be empty");
  figure.figure.y.unit = "J";
  figure.choices = {{"one", {line}}};
  EXPECT_EQ(fault(figure), kBlock + "figure.layers.size() = 1; must be 0");
  figure.figure.layers.clear();
  EXPECT_EQ(fault(figure), "no error");
  figure.chosen = 1;
  EXPECT_EQ(fault(figure), kBlock + "chosen = 1; must be below the 1 choices");
  figure.chosen = 0;
  figure.choices[0].layers.clear();
  EXPECT_EQ(fault(figure), kBlock + "choices[0].layers.size() = 0; must be 1 or more");
}

TEST(ReportDocumentFault, TablesAndSections) {
  EXPECT_EQ(fault(ReportTable{.title = "T", .columns = {{"a"}, {"b"}}, .rows = {{1.0}}}),
            "sections[0].blocks[0].rows[0].size() = 1; must be 2");
  EXPECT_EQ(input_fault([] { check_report({.title = "T"}); }),
            "sections.size() = 0; must be 1 or more");
}

}  // namespace
}  // namespace microslip::report_document_test
