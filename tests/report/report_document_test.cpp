// SPDX-License-Identifier: MIT
#include "microslip/report/report_document.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>

#include "report/support.hpp"

namespace microslip::report_document_test {
namespace {

using test::input_fault;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

ReportFigure figure_with(ReportTrace trace) {
  return {.title = "F",
          .x = {.label = "A", .unit = "m"},
          .y = {.label = "D", .unit = "J"},
          .choices = {{"", {std::move(trace)}}}};
}

std::string fault(ReportBlock block) {
  const ReportDocument document{.title = "T", .sections = {{"S", {std::move(block)}}}};
  return input_fault([&] { check_report(document); });
}

std::string trace_fault(ReportTrace trace) { return fault(figure_with(std::move(trace))); }

constexpr const char* kTrace = "sections[0].blocks[0].choices[0].traces[0]";

TEST(ReportDocument, AcceptsEveryKindOfTrace) {
  EXPECT_EQ(trace_fault({.name = "a", .x = {1.0, 2.0}, .y = {1.0, kNan}}), "no error");
  EXPECT_EQ(
      trace_fault(
          {.name = "a", .kind = TraceKind::kBand, .x = {1.0}, .lower = {0.0}, .upper = {0.0}}),
      "no error");
  EXPECT_EQ(trace_fault({.name = "a", .kind = TraceKind::kMarker, .x = {1.0}}), "no error");
}

TEST(ReportDocumentFault, Traces) {
  const std::string name = kTrace;
  EXPECT_EQ(trace_fault({.name = "a"}), name + ".x.size() = 0; must be 1 or more");
  EXPECT_EQ(trace_fault({.name = "a", .x = {1.0}, .y = {1.0}, .stroke = {.colour = -1}}),
            name + ".stroke.colour = -1; must be 0 or more");
  EXPECT_EQ(trace_fault({.name = "a", .x = {1.0}}), name + ".y.size() = 0; must be 1");
  EXPECT_EQ(trace_fault({.name = "a", .x = {kNan}, .y = {1.0}}),
            name + ".x[0] = nan; must be finite");
  EXPECT_EQ(trace_fault({.name = "a", .x = {1.0}, .y = {1.0}, .y_std = {-1.0}}),
            name + ".y_std[0] = -1; must be 0 or more");
  EXPECT_EQ(
      trace_fault(
          {.name = "a", .kind = TraceKind::kBand, .x = {1.0}, .lower = {1.0}, .upper = {0.5}}),
      name + ".upper[0] = 0.5; must be at least the 1 of lower");
}

TEST(ReportDocumentFault, Figures) {
  ReportFigure figure = figure_with({.name = "a", .x = {1.0}, .y = {1.0}});
  figure.y.unit = "";
  EXPECT_EQ(fault(figure), "sections[0].blocks[0].y.unit = ''; must not be empty");
  figure.y.unit = "J";
  figure.chosen = 1;
  EXPECT_EQ(fault(figure), "sections[0].blocks[0].chosen = 1; must be below the 1 choices");
  figure.chosen = 0;
  figure.choices[0].traces.clear();
  EXPECT_EQ(fault(figure), "sections[0].blocks[0].choices[0].traces.size() = 0; must be 1 or more");
}

TEST(ReportDocumentFault, TablesAndSections) {
  EXPECT_EQ(fault(ReportTable{.title = "T", .columns = {{"a"}, {"b"}}, .rows = {{1.0}}}),
            "sections[0].blocks[0].rows[0].size() = 1; must be 2");
  EXPECT_EQ(input_fault([] { check_report({.title = "T"}); }),
            "sections.size() = 0; must be 1 or more");
}

}  // namespace
}  // namespace microslip::report_document_test
