// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/sweep_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/rig/reduction/sweep_resonance.hpp"
#include "microslip/workflow/predict/model_comparison.hpp"

namespace microslip {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kRadPerCycle = 2.0 * std::numbers::pi;

/// A step, or the resonance, as it was measured.
struct MeasuredStep {
  double angular_frequency = 0.0;  // rad/s
  double force = 0.0;              // N
  double displacement = 0.0;       // m
};

MeasuredStep measured_step(double frequency, double force, double acceleration) {
  const double omega = kRadPerCycle * frequency;
  return {omega, force, acceleration / (omega * omega)};
}

/// The vibrations of a model that belong to a sweep, none where one was not found.
struct SweptVibrations {
  std::vector<std::optional<SteadyVibration>> steps;
  std::optional<SteadyVibration> peak;         // with what is kept
  std::optional<SteadyVibration> at_response;  // in phase resonance with the measured response
  std::string failure;
};

/// Asks models for a sweep.
class SweepQuestion {
 public:
  SweepQuestion(const SteppedSine& sweep, TestKind kind, const JointedStructure& structure)
      : of_force_(kind == TestKind::kSweep), resonance_(resonance_of(sweep)) {
    for (std::size_t i = 0; i < sweep.frequency.size(); ++i) {
      steps_.push_back(measured_step(sweep.frequency[i], sweep.force[i], sweep.acceleration[i]));
    }
    if (!resonance_) return;
    peak_ = measured_step(resonance_->frequency, resonance_->force, resonance_->acceleration);
    mode_ = nearest_mode(structure, peak_.angular_frequency);
  }

  [[nodiscard]] bool of_force() const { return of_force_; }
  [[nodiscard]] const std::vector<MeasuredStep>& steps() const { return steps_; }
  [[nodiscard]] const std::optional<SweepResonance>& resonance() const { return resonance_; }
  [[nodiscard]] const MeasuredStep& peak() const { return peak_; }

  /// @param gain  of the reading of the response.
  [[nodiscard]] SweptVibrations solve(const HarmonicBalance& balance, double gain) const {
    SweptVibrations found;
    found.steps.reserve(steps_.size());  // pointers into it stay
    if (resonance_) {
      found.at_response =
          vibration_near(balance, kPhaseResonance, {Quantity::kResponse, peak_.displacement / gain},
                         {}, mode_, found.failure);
    }
    const SteadyVibration* const resonant = found.at_response ? &*found.at_response : nullptr;
    const SteadyVibration* before = nullptr;
    for (const MeasuredStep& step : steps_) {
      const Target at{Quantity::kAngularFrequency, step.angular_frequency};
      found.steps.push_back(vibration_near(balance, at, kept(step, gain),
                                           std::array{before, resonant}, mode_, found.failure));
      if (found.steps.back()) before = &*found.steps.back();
    }
    if (!of_force_) found.peak = found.at_response;
    if (of_force_ && resonant != nullptr) {  // at constant force there may be no other path
      found.peak = vibration_near(balance, kPhaseResonance, kept(peak_, gain), std::array{resonant},
                                  mode_, found.failure);
    }
    return found;
  }

  /// Values as they would be measured. @param damping_scale  c, N⁻¹ s⁻².
  [[nodiscard]] TestPrediction readings(const SweptVibrations& found, double gain,
                                        double damping_scale) const {
    TestPrediction prediction{.failure = found.failure};
    for (const auto& step : found.steps) {
      prediction.values.push_back(step ? height(*step, gain) : kUnknown);
    }
    for (const auto& step : found.steps) {
      prediction.values.push_back(step ? folded(step->phase_lag) : kUnknown);
    }
    if (!resonance_) return prediction;
    prediction.values.push_back(found.peak ? height(*found.peak, gain) : kUnknown);
    prediction.values.push_back(found.peak ? found.peak->frequency() : kUnknown);
    prediction.values.push_back(found.at_response
                                    ? damping_scale * found.at_response->force_amplitude /
                                          std::pow(found.at_response->angular_frequency, 2)
                                    : kUnknown);
    return prediction;
  }

  /// |φ| within half a turn.
  [[nodiscard]] static double folded(double phase) {
    return std::abs(std::remainder(phase, kRadPerCycle));
  }

 private:
  [[nodiscard]] Target kept(const MeasuredStep& step, double gain) const {
    if (of_force_) return {Quantity::kForceAmplitude, step.force};
    return {Quantity::kResponse, step.displacement / gain};
  }

  [[nodiscard]] double height(const SteadyVibration& vibration, double gain) const {
    return of_force_ ? gain * vibration.response : vibration.force_amplitude;
  }

  bool of_force_;
  std::optional<SweepResonance> resonance_;
  std::vector<MeasuredStep> steps_;
  MeasuredStep peak_;
  std::size_t mode_ = 0;
};

/// c of ζ = c F/ω² for the motion that the model has at the response; NaN where it has none.
double damping_scale_of(const SweptVibrations& nominal) {
  if (!nominal.at_response) return kUnknown;
  const SteadyVibration& there = *nominal.at_response;
  return there.damping_ratio() * std::pow(there.angular_frequency, 2) / there.force_amplitude;
}

/// The lag of the displacement, by the convention that is nearer to the prediction.
std::vector<double> measured_lag(const SteppedSine& sweep, const SweptVibrations& nominal,
                                 std::string& note) {
  std::vector<double> direct;
  std::vector<double> turned;
  double misses = 0.0;  // squares of the first less those of the second
  for (std::size_t i = 0; i < sweep.phase.size(); ++i) {
    direct.push_back(SweepQuestion::folded(sweep.phase[i]));
    turned.push_back(std::numbers::pi - direct.back());
    if (!nominal.steps[i]) continue;
    const double lag = SweepQuestion::folded(nominal.steps[i]->phase_lag);
    misses += std::pow(direct.back() - lag, 2) - std::pow(turned.back() - lag, 2);
  }
  const bool is_direct = misses <= 0.0;
  note = is_direct
             ? "phase: its magnitude is the lag of the displacement behind the force, as of an "
               "acceleration that is positive against the force"
             : "phase: of the acceleration against the force, pi less the lag of the "
               "displacement";
  return is_direct ? direct : turned;
}

ComparedCurve curve_of(const std::string& quantity, const Dimension& dimension, TestPart part,
                       std::vector<double> at, std::vector<double> measured) {
  ComparedCurve curve{.quantity = quantity, .dimension = dimension, .part = part};
  curve.axis = "frequency";
  curve.axis_dimension = kFrequency;
  curve.at = std::move(at);
  curve.measured = std::move(measured);
  return curve;
}

/// In the order of SweepQuestion::readings().
std::vector<ComparedCurve> measured_curves(const SweepQuestion& question, const SteppedSine& sweep,
                                           std::vector<double> lag, double damping_scale) {
  const std::string name = question.of_force() ? "displacement" : "force";
  const Dimension dimension = question.of_force() ? kLength : kForce;
  const auto height = [&](const MeasuredStep& step) {
    return question.of_force() ? step.displacement : step.force;
  };
  std::vector<double> heights;
  for (const MeasuredStep& step : question.steps()) heights.push_back(height(step));
  std::vector<ComparedCurve> curves{
      curve_of(name, dimension, TestPart::kCurve, sweep.frequency, std::move(heights)),
      curve_of("phase_lag", kAngle, TestPart::kCurve, sweep.frequency, std::move(lag))};
  if (!question.resonance()) return curves;
  const SweepResonance& resonance = *question.resonance();
  if (resonance.amplitude_std > 0.0) {
    for (const double height : curves[0].measured) {
      curves[0].measured_std.push_back(height * resonance.amplitude_std);
    }
    curves[1].measured_std.assign(sweep.frequency.size(), resonance.phase_std);
    for (std::size_t i : {0U, 1U}) curves[i].std_freedom = resonance.scatter_freedom;
  }
  const MeasuredStep& peak = question.peak();
  const double damping =
      damping_scale * peak.force / (peak.angular_frequency * peak.angular_frequency);
  const auto add = [&](const std::string& quantity, const Dimension& unit, double value,
                       double deviation) {
    curves.push_back(curve_of(quantity, unit, TestPart::kPeak, {resonance.frequency}, {value}));
    curves.back().measured_std = {deviation};
  };
  add(name, dimension, height(peak), height(peak) * resonance.damping_std);
  add("frequency", kFrequency, resonance.frequency, resonance.frequency_std);
  add("damping_ratio", kDimensionless, damping, damping * resonance.damping_std);
  return curves;
}

/// Whether the lag of the predicted steps passes a quarter turn, as at each resonance.
bool has_resonance(const SweptVibrations& nominal) {
  bool below = false;
  bool above = false;
  for (const auto& step : nominal.steps) {
    if (!step) continue;
    const bool behind = SweepQuestion::folded(step->phase_lag) >= 0.5 * std::numbers::pi;
    (behind ? above : below) = true;
  }
  return below && above;
}

/// Far from all modes of the model a sweep says little of its joints.
std::optional<Warning> mode_warning(const SweepQuestion& question, const SweptVibrations& nominal,
                                    const JointedStructure& structure) {
  if (has_resonance(nominal)) return std::nullopt;
  const auto [first, last] =
      std::ranges::minmax(question.steps(), {}, &MeasuredStep::angular_frequency);
  const double middle = std::sqrt(first.angular_frequency * last.angular_frequency);
  const double nearest =
      structure.stuck_frequencies().at(nearest_mode(structure, middle)) / kRadPerCycle;
  return Warning{
      "no_mode_in_sweep",
      fmt::format("the model has no resonance at the steps of the sweep, {:.6g} to {:.6g} Hz; its "
                  "nearest mode has {:.6g} Hz with stuck joints. Away from resonances a sweep "
                  "shows stiffness and mass, and hardly anything of joints. Is it a sweep of this "
                  "structure, and does the model contain all its modes?",
                  first.angular_frequency / kRadPerCycle, last.angular_frequency / kRadPerCycle,
                  nearest)};
}

/// Warnings of the model on such motions, and on what the sweep lacks.
std::vector<Warning> warnings_of(const SweepQuestion& question, const SweptVibrations& nominal,
                                 const HarmonicBalance& balance, const ModelFile& model) {
  ResponseCurve curve;
  for (const auto& step : nominal.steps) {
    if (step) curve.points.push_back(*step);
  }
  for (const auto* peak : {&nominal.peak, &nominal.at_response}) {
    if (*peak) curve.points.push_back(**peak);
  }
  const Quantity kept = question.of_force() ? Quantity::kForceAmplitude : Quantity::kResponse;
  std::vector<Warning> warnings = motion_warnings(balance, model, kept, std::move(curve));
  if (auto far = mode_warning(question, nominal, model.structure)) {
    warnings.push_back(*std::move(far));
  }
  if (!question.resonance()) {
    warnings.push_back({"no_resonance",
                        "the phase does not pass a quarter turn: the sweep is compared step by "
                        "step, without its peak."});
  } else {
    std::ranges::move(warnings_of(*question.resonance()), std::back_inserter(warnings));
  }
  return warnings;
}

/// How far the largest is above the smallest.
double unevenness(const std::vector<double>& values) {
  const auto [least, most] = std::ranges::minmax(values);
  return most / least;
}

}  // namespace

TestKind kind_of(const SteppedSine& sweep) {
  check_stepped_sine(sweep);
  const bool constant_response = unevenness(sweep.acceleration) < unevenness(sweep.force);
  return constant_response ? TestKind::kConstantResponse : TestKind::kSweep;
}

ComparedTest compare_sweep(const SteppedSine& sweep, TestKind kind, const ModelFile& model,
                           const HarmonicBalanceOptions& options,
                           const std::optional<StructureDraws>& spread,
                           const std::optional<TestDraws>& draws) {
  if (model.structure.base_driven()) {
    throw InputError("excitation", "a base", "must be a force for a sweep, which has its force",
                     "Name the drive point in [excitation] of the model.");
  }
  const HarmonicBalance balance(model.structure, {model.response}, options);
  const SweepQuestion question(sweep, kind, model.structure);
  const SweptVibrations nominal = question.solve(balance, 1.0);
  const double damping_scale = damping_scale_of(nominal);

  ComparedTest test{.source = sweep.source, .kind = kind};
  std::vector<double> lag = measured_lag(sweep, nominal, test.note);
  test.curves = measured_curves(question, sweep, std::move(lag), damping_scale);
  test.warnings = warnings_of(question, nominal, balance, model);
  TestPredictor predictor{.nominal = question.readings(nominal, 1.0, damping_scale)};
  const HarmonicBalanceOptions drawn = options_of_draws(options);
  if (spread) {
    predictor.draw = [&](std::size_t i) {
      StructureDraw draw = spread->draw(i);
      const double gain = draw.response_gain;
      const HarmonicBalance of_draw(std::move(draw.structure), balance.response(), drawn);
      return question.readings(question.solve(of_draw, gain), gain, damping_scale);
    };
  }
  compare(predictor, draws, test);
  return test;
}

}  // namespace microslip
