// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/loops_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/identify/records/record_inversion.hpp"
#include "microslip/joint/covered_range.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/observe/record_cycles.hpp"
#include "microslip/observe/record_force.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/text/departure_meanings.hpp"

namespace microslip {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Asks joints for a record.
class LoopQuestion {
 public:
  explicit LoopQuestion(const ForceRecord& record)
      : evidence_(record, PathStart::kUnknown), cycles_(record_cycles(evidence_)) {}

  [[nodiscard]] const RecordCycles& cycles() const { return cycles_; }
  [[nodiscard]] const RecordEvidence& evidence() const { return evidence_; }
  [[nodiscard]] const ForceRecord& record() const { return evidence_.measured(); }

  /// N, at each sample; NaN where the state is not known.
  [[nodiscard]] std::vector<double> force(const LoopJoint& joint) const {
    if (joint.viscous > 0.0 && record().time_step == 0.0) {
      throw InputError(
          "time step", 0.0, "must be known to predict a viscous part",
          "Give evenly spaced times: `microslip convert IN OUT --resample` makes them.");
    }
    return found_force(evidence_, joint.joint, joint.viscous);
  }

  [[nodiscard]] TestPrediction values(const LoopJoint& joint,
                                      const std::vector<double>& force) const {
    TestPrediction prediction;
    for (const RecordCycle& cycle : cycles_.cycles) {
      prediction.values.push_back(loss_of(joint, cycle));
    }
    for (const RecordCycle& cycle : cycles_.cycles) {
      prediction.values.push_back(secant_stiffness(joint.joint, cycle.amplitude));
    }
    prediction.values.push_back(unexplained_share(record().force, force));
    prediction.values.push_back(cycles_.force_noise / rms_of_known(record().force, force));
    return prediction;
  }

  /// @return the number of samples at which the force is known.
  [[nodiscard]] static std::ptrdiff_t known(const std::vector<double>& force) {
    return std::ranges::count_if(force, [](double value) { return std::isfinite(value); });
  }

 private:
  [[nodiscard]] double loss_of(const LoopJoint& joint, const RecordCycle& cycle) const {
    const double a = cycle.amplitude;
    const double period = record().time_step * static_cast<double>(cycle.last - cycle.first);
    const double rate = period > 0.0 ? 2.0 * std::numbers::pi / period : 0.0;
    return dissipation(joint.joint, a) + joint.linear_damping * a * a +
           std::numbers::pi * joint.viscous * rate * a * a;
  }

  RecordEvidence evidence_;
  RecordCycles cycles_;
};

ComparedCurve of_cycles(const RecordCycles& cycles, const char* quantity,
                        const Dimension& dimension, double RecordCycle::*value,
                        double RecordCycle::*value_std) {
  ComparedCurve curve{
      .quantity = quantity, .dimension = dimension, .axis = "amplitude", .axis_dimension = kLength};
  for (const RecordCycle& cycle : cycles.cycles) {
    curve.at.push_back(cycle.amplitude);
    curve.measured.push_back(cycle.*value);
    curve.measured_std.push_back(cycle.*value_std > 0.0 ? cycle.*value_std : kNone);
  }
  return curve;
}

ComparedCurve whole_record(const char* quantity) {
  return {.quantity = quantity,
          .dimension = kDimensionless,
          .part = TestPart::kRecord,
          .at = {kNone},
          .measured = {kNone}};
}

/// In the order of LoopQuestion::values().
std::vector<ComparedCurve> curves_of(const RecordCycles& cycles) {
  std::vector<ComparedCurve> curves{
      of_cycles(cycles, "dissipation", kEnergy, &RecordCycle::dissipation,
                &RecordCycle::dissipation_std),
      of_cycles(cycles, "secant_stiffness", kStiffness, &RecordCycle::secant_stiffness,
                &RecordCycle::secant_stiffness_std),
      whole_record("force_nrmse"), whole_record("force_noise")};
  std::erase_if(curves, [](const ComparedCurve& curve) { return curve.size() == 0; });
  return curves;
}

std::vector<Warning> warnings_of(const LoopQuestion& question, const LoopJoint& joint) {
  std::vector<Warning> warnings;
  const auto [least, most] = std::ranges::minmax(question.record().displacement);
  const double amplitude = 0.5 * (most - least);
  if (const auto beyond = beyond_identification(joint.joint, amplitude, joint.covered_to)) {
    warnings.push_back(*beyond);
  }
  if (joint.linear_damping > 0.0) {
    warnings.push_back(
        {"linear_damping_left_out",
         fmt::format(
             "the joint was identified with a linear damping of {}, which is in its dissipation "
             "but not in its force: a rate-independent loss has no force along a path.",
             damping_text(joint.linear_damping))});
  }
  if (const auto departs = departures_of(question.evidence())) warnings.push_back(*departs);
  if (question.cycles().cycles.empty()) {
    warnings.push_back({"no_closed_cycles",
                        "no cycle of the path closes above its noise: forces are compared, losses "
                        "are not."});
  }
  return warnings;
}

}  // namespace

std::optional<Warning> departures_of(const RecordEvidence& evidence) {
  constexpr std::size_t kFewDraws = 100;  // the verdicts use none
  RecordInversionResult nearest;
  try {
    nearest = invert_records({&evidence, 1}, {}, {.draws = kFewDraws});
  } catch (const InputError& error) {
    return Warning{
        "departures_unknown",
        fmt::format("whether the record is of a Masing joint was not tested: {}", error.what())};
  }
  std::string text;
  for (const RecordVerdict& verdict : nearest.records.front().verdicts) {
    if (!verdict.broken) continue;
    text += fmt::format("{}{}, {:.2g} % of the force, {:.2g} % by noise", text.empty() ? "" : "; ",
                        departure_with_code(to_string(verdict.departure)), 100.0 * verdict.share,
                        100.0 * verdict.noise);
  }
  if (text.empty()) return std::nullopt;
  return Warning{kTestNotOfThisKind,
                 fmt::format("the record is NOT OF A MASING JOINT under constant normal load, "
                             "whatever its density: {}. No such joint predicts it.",
                             text)};
}

ComparedTest compare_loops(const NamedForceRecord& record, const LoopJoint& joint,
                           const std::function<LoopJoint(std::size_t i)>& draw,
                           const std::optional<TestDraws>& draws) {
  ComparedTest test{.source = record.source, .kind = TestKind::kLoops};
  of_record(record.source, [&] {
    const LoopQuestion question(record.record);
    std::vector<double> force = question.force(joint);
    if (LoopQuestion::known(force) == 0) {
      throw InputError("displacement", "a path that never reverses",
                       "must reverse at least once: before that, it is unknown which elements slip",
                       "Record a closed cycle.");
    }
    test.curves = curves_of(question.cycles());
    test.warnings = warnings_of(question, joint);
    TestPredictor predictor{.nominal = question.values(joint, force)};
    if (draw) {
      predictor.draw = [&](std::size_t i) {
        const LoopJoint drawn = draw(i);
        return question.values(drawn, question.force(drawn));
      };
    }
    compare(predictor, draws, test);
    test.loop = {question.record().displacement, question.record().force, std::move(force)};
  });
  return test;
}

}  // namespace microslip
