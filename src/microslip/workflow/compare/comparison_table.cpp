// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/comparison_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/io/cells/comment_entry.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/workflow/compare/comparison_text.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/text/summary_text.hpp"
#include "microslip/workflow/text/table_cells.hpp"

namespace microslip {
namespace {

/// Calls row(test, curve, i) for each value.
template <typename Row>
void for_each_row(const VerifiedTests& verified, const Row& row) {
  for (const ComparedTest& test : verified.tests) {
    for (const ComparedCurve& curve : test.curves) {
      for (std::size_t i = 0; i < curve.size(); ++i) row(test, curve, i);
    }
  }
}

std::string cell_of(const std::vector<double>& values, std::size_t i) {
  return i < values.size() && std::isfinite(values[i]) ? fmt::format("{}", values[i]) : "";
}

std::string axis_of(const ComparedCurve& curve) {
  if (curve.axis.empty()) return "";
  return fmt::format("{} [{}]", curve.axis, si_unit(curve.axis_dimension));
}

/// The number of values of a curve inside its band, of how many, and the p-value of that; empty
/// without a band.
std::string inside_comment(const ComparedTest& test, const ComparedCurve& curve) {
  if (!curve.has_band() || curve.compared() == 0) return "";
  const std::string subject = curve_subject(test, curve);
  std::string text;
  if (curve.few_inside) text = '\n' + comment_entry(kFewInsideKey, subject, "yes");
  return text + '\n' + comment_entry(kInsideKey, subject, fmt::format("{}", curve.inside())) +
         '\n' + comment_entry(kComparedKey, subject, fmt::format("{}", curve.compared())) + '\n' +
         comment_entry(kPValueKey, subject, fmt::format("{:.3g}", curve.chance));
}

/// Warnings of a test name it.
std::vector<Warning> all_warnings(const VerifiedTests& verified) {
  std::vector<Warning> all = verified.warnings;
  for (const ComparedTest& test : verified.tests) {
    for (const Warning& warning : test.warnings) {
      all.push_back({warning.code, fmt::format("{}: {}", test.source, warning.text)});
    }
  }
  return all;
}

std::string test_comment(const ComparedTest& test) {
  std::string text;
  const auto add = [&](std::string_view key, const std::string& what) {
    text += '\n' + comment_entry(key, test.source, what);
  };
  if (!test.failure.empty()) add(kFailureKey, "NOT CONVERGED: " + test.failure);
  if (!test.note.empty()) add(kNoteKey, test.note);
  if (!test.taken) return text;
  for (const ComparedCurve& curve : test.curves) {
    if (curve.part != TestPart::kCurve) continue;  // the verdict of one value is in its row
    text += inside_comment(test, curve);
  }
  return text;
}

std::string comment_of(const VerifiedTests& verified) {
  std::string text = verified.heading;
  const auto drawn = std::ranges::find_if(
      verified.tests, [](const ComparedTest& test) { return test.taken.has_value(); });
  if (drawn != verified.tests.end()) {
    const double confidence = drawn->taken->options.confidence;
    text += '\n' + comment_entry(kConfidenceKey, "", fmt::format("{}", confidence));
  }
  for (const ComparedTest& test : verified.tests) {
    if (test.taken && (&test == &verified.tests.front() || test.taken->failed() > 0)) {
      text += "\n" + draws_comment(*test.taken, verified.uncertain);
    }
    text += test_comment(test);
  }
  return with_warnings(std::move(text), all_warnings(verified));
}

/// A value by itself.
std::string single_text(const ComparedCurve& curve) {
  if (!std::isfinite(curve.predicted[0])) return "not found";
  const std::string predicted = value_text(curve.predicted[0], curve.dimension);
  std::string text = predicted;
  if (std::isfinite(curve.measured[0])) {
    text = fmt::format("{}, predicted {} ({})", value_text(curve.measured[0], curve.dimension),
                       predicted, difference_text(curve, 0));
  }
  if (!curve.has_band()) return text;
  text += fmt::format(", band {} to {}", value_text(curve.lower[0], curve.dimension),
                      value_text(curve.upper[0], curve.dimension));
  const std::string verdict = verdict_of(curve, 0);
  return verdict.empty() ? text : text + ": " + verdict;
}

/// A curve as a whole.
std::string whole_text(const ComparedCurve& curve) {
  if (curve.compared() == 0) return "not found";
  std::string text =
      fmt::format("{} values, rms difference {}", curve.compared(), deviation_text(curve));
  const double normalised = curve.normalised_deviation();
  if (std::isfinite(normalised)) {
    text += fmt::format(", or {:.2g} of its standard deviations", normalised);
  }
  if (curve.has_band()) text += fmt::format(", {} inside", curve.inside());
  return text;
}

/// Values at the peak follow those along the curve, under a heading.
std::string describe_test(const ComparedTest& test) {
  std::string text = fmt::format("{}: {}\n", test.source, to_string(test.kind));
  const ComparedCurve* before = nullptr;
  for (const ComparedCurve& curve : test.curves) {
    const bool first = before != nullptr && before->part != curve.part;
    if (curve.part == TestPart::kPeak && first) text += "  at the peak\n";
    const bool whole = curve.part == TestPart::kCurve;
    text += line(shown_name(curve), whole ? whole_text(curve) : single_text(curve));
    before = &curve;
  }
  return text;
}

/// "frequency [Hz]" by its name and what it measures.
std::pair<std::string, Dimension> axis_and_unit(const CsvTable& table, std::size_t row,
                                                const std::string& text) {
  if (text.empty()) return {};
  const auto [name, unit_text] = name_and_unit(text);
  const auto unit = find_unit(unit_text);
  if (unit && !unit_text.empty()) return {name, unit->dimension};
  table.reject(row, "axis", "a name and its unit in brackets, or nothing");
}

template <typename Kind>
Kind named(const CsvTable& table, std::size_t row, const char* column, const std::string& cell,
           std::initializer_list<Kind> all) {
  for (const Kind kind : all) {
    if (to_string(kind) == cell) return kind;
  }
  table.reject(row, column, "one that this program writes");
}

/// Builds tests from the rows of a table, one after the other.
class ComparisonReader {
 public:
  explicit ComparisonReader(const CsvTable& table)
      : table_(table),
        source_(table.text("source")),
        kind_(table.text("kind")),
        part_(table.text("part")),
        quantity_(table.text("quantity")),
        unit_(table.text("unit")),
        axis_(table.text("axis")) {
    for (const char* name : {"at", "measured", "measured_std", "predicted", "lower", "upper"}) {
      numbers_.push_back(numbers_or_empty(table, name));
    }
  }

  [[nodiscard]] std::vector<ComparedTest> read() {
    for (std::size_t row = 0; row < table_.rows(); ++row) add(row);
    for (ComparedTest& test : tests_) {
      for (ComparedCurve& curve : test.curves) drop_empty(curve);
    }
    return std::move(tests_);
  }

 private:
  void add(std::size_t row) {
    const bool same_test =
        row > 0 && source_[row] == source_[row - 1] && kind_[row] == kind_[row - 1];
    if (!same_test) {
      tests_.push_back(
          {.source = source_[row],
           .kind = named(table_, row, "kind", kind_[row],
                         {TestKind::kSweep, TestKind::kConstantResponse, TestKind::kRingDown,
                          TestKind::kModalLevels, TestKind::kLoops})});
    }
    const bool same_curve =
        same_test && part_[row] == part_[row - 1] && quantity_[row] == quantity_[row - 1];
    if (!same_curve) tests_.back().curves.push_back(curve_at(row));
    ComparedCurve& curve = tests_.back().curves.back();
    std::size_t n = 0;
    for (auto* values : {&curve.at, &curve.measured, &curve.measured_std, &curve.predicted,
                         &curve.lower, &curve.upper}) {
      values->push_back(numbers_[n++][row]);
    }
  }

  [[nodiscard]] ComparedCurve curve_at(std::size_t row) const {
    const auto unit = find_unit(unit_[row]);
    if (!unit) table_.reject(row, "unit", "a unit");
    auto [axis, axis_dimension] = axis_and_unit(table_, row, axis_[row]);
    return {.quantity = quantity_[row],
            .dimension = unit->dimension,
            .part = named(table_, row, "part", part_[row],
                          {TestPart::kCurve, TestPart::kPeak, TestPart::kRecord}),
            .axis = std::move(axis),
            .axis_dimension = axis_dimension};
  }

  static void drop_empty(ComparedCurve& curve) {
    for (auto* values : {&curve.measured_std, &curve.lower, &curve.upper}) {
      const bool none = std::ranges::none_of(*values, [](double v) { return std::isfinite(v); });
      if (none) values->clear();
    }
  }

  const CsvTable& table_;
  std::vector<std::string> source_;
  std::vector<std::string> kind_;
  std::vector<std::string> part_;
  std::vector<std::string> quantity_;
  std::vector<std::string> unit_;
  std::vector<std::string> axis_;
  std::vector<std::vector<double>> numbers_;  // one per column of numbers
  std::vector<ComparedTest> tests_;
};

}  // namespace

std::string curve_subject(const ComparedTest& test, const ComparedCurve& curve) {
  return fmt::format("{}: {}", test.source, curve.quantity);
}

std::vector<ComparedTest> compared_tests(const CsvTable& table) {
  return ComparisonReader(table).read();
}

std::string comparison_table(const VerifiedTests& verified) {
  CsvWriter table;
  table.add_comment(comment_of(verified));
  const auto add = [&](std::string_view name, auto cell) {
    std::vector<std::string> cells;
    for_each_row(verified, [&](const ComparedTest& test, const ComparedCurve& curve,
                               std::size_t i) { cells.emplace_back(cell(test, curve, i)); });
    table.add_text(name, cells);
  };
  using Test = const ComparedTest&;
  using Curve = const ComparedCurve&;
  add("source", [](Test test, Curve, std::size_t) { return test.source; });
  add("kind", [](Test test, Curve, std::size_t) { return to_string(test.kind); });
  add("part", [](Test, Curve curve, std::size_t) { return to_string(curve.part); });
  add("quantity", [](Test, Curve curve, std::size_t) { return curve.quantity; });
  add("unit", [](Test, Curve curve, std::size_t) { return si_unit(curve.dimension); });
  add("axis", [](Test, Curve curve, std::size_t) { return axis_of(curve); });
  add("at", [](Test, Curve curve, std::size_t i) { return cell_of(curve.at, i); });
  add("measured", [](Test, Curve curve, std::size_t i) { return cell_of(curve.measured, i); });
  add("measured_std",
      [](Test, Curve curve, std::size_t i) { return cell_of(curve.measured_std, i); });
  add("predicted", [](Test, Curve curve, std::size_t i) { return cell_of(curve.predicted, i); });
  add("lower", [](Test, Curve curve, std::size_t i) { return cell_of(curve.lower, i); });
  add("upper", [](Test, Curve curve, std::size_t i) { return cell_of(curve.upper, i); });
  add("verdict", [](Test, Curve curve, std::size_t i) { return verdict_of(curve, i); });
  return table.str();
}

std::string describe_tests(const VerifiedTests& verified) {
  std::string text = fmt::format("Prediction of {}\n", counted(verified.tests.size(), "test"));
  for (const ComparedTest& test : verified.tests) text += describe_test(test);
  for (const ComparedTest& test : verified.tests) {
    if (test.taken) {
      text += describe_draws(*test.taken, verified.uncertain);
      break;
    }
  }
  return text + describe_warnings(all_warnings(verified));
}

}  // namespace microslip
