// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/base/units.hpp"
#include "microslip/workflow/predict/model_draws.hpp"

/// @file
/// A test against its prediction, whatever its kind: curves of what was measured, what is predicted
/// there, between which values the draws lie, and whether what was measured does.

namespace microslip {

// g++ 12 says that scoped enumerators hide names of other types, which they do not.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"

/// Kind of a test, which determines the inputs of the model.
enum class TestKind {
  kSweep,             ///< frequency and force of each step; the response is predicted
  kConstantResponse,  ///< frequency and response of each step; the force is predicted
  kRingDown,     ///< the amplitude of a mode in a decay; its frequency and losses are predicted
  kModalLevels,  ///< as kRingDown, of levels in a table, whose excitation is not known
  kLoops,        ///< the path of a joint; its force, and the losses of its cycles
};

/// Where on a test values are.
enum class TestPart {
  kCurve,   ///< along it
  kPeak,    ///< at its phase resonance
  kRecord,  ///< one of the whole
};

#pragma GCC diagnostic pop

/// "sweep", "constant-response", "ringdown", "modal-levels", "loops".
[[nodiscard]] std::string_view to_string(TestKind kind);
/// Whether it goes through frequencies step by step.
[[nodiscard]] bool is_of_sweeps(TestKind kind);
/// "curve", "peak", "record".
[[nodiscard]] std::string_view to_string(TestPart part);

/// One quantity of a test. Vectors have one entry per value, or none where stated; NaN where
/// there is none.
struct ComparedCurve {
  std::string quantity;                   ///< "displacement"
  Dimension dimension;                    ///< of its values, in SI
  TestPart part = TestPart::kCurve;       ///< where they are
  std::string axis = {};                  ///< "frequency": what `at` is
  Dimension axis_dimension = {};          ///< of `at`
  std::vector<double> at = {};            ///< place of each value
  std::vector<double> measured = {};      ///< NaN where it is a prediction alone
  std::vector<double> measured_std = {};  ///< of it; empty where that is not known
  /// Degrees of freedom of the estimate that measured_std is, off by one factor for all; 0 where it
  /// is known.
  std::size_t std_freedom = 0;
  std::vector<double> predicted = {};  ///< by the model as it is; NaN where it was not found
  std::vector<double> lower = {};      ///< of the draws; empty without
  std::vector<double> upper = {};      ///< as above
  /// p-value: share of the draws of which as few values, or fewer, lie in the band as of the
  /// measured ones, 1. NaN without a band.
  double chance = std::numeric_limits<double>::quiet_NaN();
  bool few_inside = false;  ///< whether a warning `few_inside` is of it

  /// The number of values.
  [[nodiscard]] std::size_t size() const { return at.size(); }
  /// Whether there is a band.
  [[nodiscard]] bool has_band() const { return !lower.empty(); }
  /// Whether value i was measured and predicted, so that the two can be compared.
  [[nodiscard]] bool compares(std::size_t i) const;
  /// Whether value i lies in the band. @throws std::out_of_range without one.
  [[nodiscard]] bool inside(std::size_t i) const;
  /// How many values can be compared.
  [[nodiscard]] std::size_t compared() const;
  /// How many of them lie in the band.
  [[nodiscard]] std::size_t inside() const;
  /// √(mean of squares) of predicted over measured less 1; of angles of the difference, rad. NaN
  /// where nothing can be compared.
  [[nodiscard]] double deviation() const;
  /// Of the values that have a standard deviation, √(mean (measured − predicted)²/σ²), 1: near 1
  /// where the noise explains what they differ by. NaN where none has.
  [[nodiscard]] double normalised_deviation() const;
};

/// "inside" or "outside" of the band; "not_found" where value i was measured and is not predicted;
/// empty where it was not measured or there is no band.
[[nodiscard]] std::string verdict_of(const ComparedCurve& curve, std::size_t i);

/// A loop that was measured and its prediction, for pictures. One length.
struct ComparedLoop {
  std::vector<double> displacement = {};  ///< m
  std::vector<double> measured = {};      ///< N
  std::vector<double> predicted = {};     ///< N; NaN where it is not known
};

/// A test beside its prediction.
struct ComparedTest {
  std::string source = {};                 ///< its file, and the part of it
  TestKind kind = TestKind::kSweep;        ///< what is given and what is predicted
  std::vector<ComparedCurve> curves = {};  ///< one a quantity and part
  ComparedLoop loop = {};                  ///< of kLoops; else empty
  std::string note = {};                   ///< interpretation of its columns; may be empty
  std::string failure = {};                ///< why a value was not found; empty where all were
  std::optional<DrawsTaken> taken = {};    ///< what became of the draws
  std::vector<Warning> warnings = {};      ///< what must be known of it

  /// Whether all values were found, and enough of the draws.
  [[nodiscard]] bool converged() const;
  /// The number of values of all curves.
  [[nodiscard]] std::size_t size() const;
};

/// Prediction of a model for the values of a test, curve after curve.
struct TestPrediction {
  std::vector<double> values = {};  ///< NaN where one was not found
  std::string failure = {};         ///< why; empty where all were found
};

/// How the values of a test are predicted.
struct TestPredictor {
  TestPrediction nominal = {};  ///< by the model as it is
  /// By draw i, of what would be read; called by several threads at once. Empty without draws.
  std::function<TestPrediction(std::size_t i)> draw = {};
};

/// Draws through a test.
struct TestDraws {
  DrawOptions options = {};                    ///< which of them
  Execution execution = Execution::threads();  ///< of the draws
  Progress progress = {};                      ///< reports the number done; may cancel
};

/// Fills in what is predicted, and the bands: of what would be read, the draw of the model and,
/// where what was measured has a standard deviation σ, noise σz of its own (z standard normal, a
/// function of seed, draw and value). A draw fails of which a value is not found. Warnings:
/// `not_converged`, `draws_failed`, `draws_few` (fewer than kFewBeyond beyond each edge),
/// `few_inside` (a curve of which at most 1 − P of the draws have so few values in the band as what
/// was measured: errors that all values share, of a gain or a frequency, are in the draws).
/// @param predictor  of the values of the test.
/// @param draws      nothing, or a predictor without draws: no bands.
/// @param test       with what was measured.
/// @throws InputError  as DrawOptions; where all draws failed. @throws Cancelled  as progress says.
void compare(const TestPredictor& predictor, const std::optional<TestDraws>& draws,
             ComparedTest& test);

/// Fewer draws than these beyond an edge of a band do not tell where it is.
inline constexpr double kFewBeyond = 5.0;

}  // namespace microslip
