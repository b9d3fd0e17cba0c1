// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/modal_levels_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/workflow/predict/model_comparison.hpp"

namespace microslip {
namespace {

/// A quantity of levels, with what a vibration has of it.
struct ModalQuantity {
  const char* name;
  Dimension dimension;
  std::vector<double> ModalLevels::*values;
  std::vector<double> ModalLevels::*std;
  double (*of)(const SteadyVibration&);
};

double loss_of_joints(const SteadyVibration& vibration) {
  double sum = 0.0;
  for (const JointCycle& joint : vibration.joints) sum += joint.dissipation;
  return sum;
}

const std::array<ModalQuantity, 3> kModalQuantities{{
    {"frequency", kFrequency, &ModalLevels::frequency, &ModalLevels::frequency_std,
     [](const SteadyVibration& vibration) { return vibration.frequency(); }},
    {"damping_ratio", kDimensionless, &ModalLevels::damping_ratio, &ModalLevels::damping_ratio_std,
     [](const SteadyVibration& vibration) { return vibration.damping_ratio(); }},
    {"dissipation", kEnergy, &ModalLevels::dissipation, &ModalLevels::dissipation_std,
     loss_of_joints},
}};

/// One mode of the levels.
class ModeQuestion {
 public:
  ModeQuestion(const ModalLevels& levels, std::size_t mode, std::size_t std_freedom) : mode_(mode) {
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (levels.mode[i] == mode) rows_.push_back(i);
    }
    std::ranges::stable_sort(rows_, {}, [&](std::size_t i) { return levels.displacement[i]; });
    for (const std::size_t i : rows_) {
      displacement_.push_back(levels.displacement[i]);
      const double deviation = ModalLevels::value(levels.displacement_std, i);
      displacement_std_.push_back(std::isfinite(deviation) ? deviation : 0.0);
    }
    for (const ModalQuantity& quantity : kModalQuantities) add_curve(levels, quantity);
    for (ComparedCurve& curve : curves_) curve.std_freedom = std_freedom;
  }

  [[nodiscard]] std::size_t mode() const { return mode_; }
  [[nodiscard]] const std::vector<ComparedCurve>& curves() const { return curves_; }

  [[nodiscard]] const std::vector<double>& displacement() const { return displacement_; }

  /// Possible true values: readings with their noise, over the gain.
  [[nodiscard]] std::vector<double> drawn_displacement(double gain, std::uint64_t seed,
                                                       std::size_t draw) const {
    // Apart from the streams of structures, joints and other readings.
    constexpr std::uint64_t kDisplacementStreams = std::uint64_t{0x101} << 48U;
    constexpr double kLeast = 1e-3;  // of the reading: noise beyond is not that of a level
    RandomStream random(seed, kDisplacementStreams + draw);
    std::vector<double> drawn;
    for (std::size_t i = 0; i < displacement_.size(); ++i) {
      const double there = displacement_[i] + displacement_std_[i] * random.normal();
      drawn.push_back(std::max(there, kLeast * displacement_[i]) / gain);
    }
    return drawn;
  }

  /// At these displacements; fewer where they were not all found.
  [[nodiscard]] std::vector<SteadyVibration> solve(const HarmonicBalance& balance,
                                                   const std::vector<double>& displacements,
                                                   std::string& failure) const {
    std::vector<SteadyVibration> found;
    for (const double displacement : displacements) {
      const std::array before{found.empty() ? nullptr : &std::as_const(found).back()};
      std::optional<SteadyVibration> there = vibration_near(
          balance, kPhaseResonance, {Quantity::kResponse, displacement}, before, mode_, failure);
      if (!there) break;
      found.push_back(std::move(*there));
    }
    return found;
  }

  [[nodiscard]] TestPrediction readings(const std::vector<SteadyVibration>& found,
                                        std::string failure) const {
    TestPrediction prediction{.failure = std::move(failure)};
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      for (const std::size_t level : level_of_[c]) {
        prediction.values.push_back(level < found.size()
                                        ? quantity_of_[c]->of(found[level])
                                        : std::numeric_limits<double>::quiet_NaN());
      }
    }
    return prediction;
  }

 private:
  void add_curve(const ModalLevels& levels, const ModalQuantity& quantity) {
    ComparedCurve curve{.quantity = quantity.name,
                        .dimension = quantity.dimension,
                        .axis = "displacement",
                        .axis_dimension = kLength};
    std::vector<std::size_t> level_of;
    for (std::size_t level = 0; level < rows_.size(); ++level) {
      const double measured = ModalLevels::value(levels.*quantity.values, rows_[level]);
      if (!std::isfinite(measured)) continue;
      level_of.push_back(level);
      curve.at.push_back(displacement_[level]);
      curve.measured.push_back(measured);
      curve.measured_std.push_back(ModalLevels::value(levels.*quantity.std, rows_[level]));
    }
    if (curve.at.empty()) return;
    curves_.push_back(std::move(curve));
    level_of_.push_back(std::move(level_of));
    quantity_of_.push_back(&quantity);
  }

  std::size_t mode_;
  std::vector<std::size_t> rows_;     // of the levels, by rising displacement
  std::vector<double> displacement_;  // of each
  std::vector<double> displacement_std_;
  std::vector<ComparedCurve> curves_;
  std::vector<std::vector<std::size_t>> level_of_;  // of each value of each curve
  std::vector<const ModalQuantity*> quantity_of_;   // of each curve
};

/// Modal forcing, unless another is asked for or no joint takes part in the mode.
HarmonicBalance balance_of(const ModelFile& model, HarmonicBalanceOptions options,
                           const ModeQuestion& question) {
  if (options.forcing != Forcing::kModal) return {model.structure, {model.response}, options};
  HarmonicBalance modal(model.structure, {model.response}, options);
  try {
    std::string ignored;
    (void)question.solve(modal, {question.displacement().front()}, ignored);
    return modal;
  } catch (const InputError& error) {
    if (error.name() != "mode with modal forcing") throw;
  }
  options.forcing = Forcing::kExcitation;
  return {model.structure, {model.response}, options};
}

ComparedTest compare_mode(const std::string& source, const ModeQuestion& question,
                          const ModelFile& model, const HarmonicBalanceOptions& options,
                          const std::optional<StructureDraws>& spread,
                          const std::optional<TestDraws>& draws) {
  const HarmonicBalance balance = balance_of(model, options, question);
  ComparedTest test{.source = source, .kind = TestKind::kModalLevels, .curves = question.curves()};
  std::string failure;
  const std::vector<SteadyVibration> nominal =
      question.solve(balance, question.displacement(), failure);
  test.warnings = motion_warnings(balance, model, Quantity::kPhaseLag,
                                  {.points = nominal,
                                   .peaks = {},
                                   .peak_points = {},
                                   .turning_points = {},
                                   .warnings = {},
                                   .summary = {}});
  TestPredictor predictor{.nominal = question.readings(nominal, failure)};
  const HarmonicBalanceOptions drawn = options_of_draws(balance.options());
  const std::uint64_t seed = draws ? draws->options.seed : 0;
  if (spread) {
    predictor.draw = [&](std::size_t i) {
      StructureDraw draw = spread->draw(i);
      const HarmonicBalance of_draw(std::move(draw.structure), balance.response(), drawn);
      std::string missed;
      const std::vector<SteadyVibration> found =
          question.solve(of_draw, question.drawn_displacement(draw.response_gain, seed, i), missed);
      return question.readings(found, missed);
    };
  }
  compare(predictor, draws, test);
  return test;
}

}  // namespace

ModalLevels levels_of(const ReducedModalDecay& decay) {
  ModalLevels levels;
  for (const ModalDecay& mode : decay.modes) {
    const RingDownLevels& found = mode.levels;
    append({.mode = std::vector<std::size_t>(found.amplitude.size(), mode.mode - 1),
            .displacement = found.amplitude,
            .displacement_std = found.amplitude_std,
            .frequency = found.frequency,
            .frequency_std = found.frequency_std,
            .damping_ratio = found.damping_ratio,
            .damping_ratio_std = found.damping_ratio_std},
           levels);
  }
  return levels;
}

std::vector<ComparedTest> compare_modal_levels(const std::string& source, const ModalLevels& levels,
                                               const ModelFile& model,
                                               const HarmonicBalanceOptions& options,
                                               const std::optional<StructureDraws>& spread,
                                               const std::optional<TestDraws>& draws,
                                               Forcing forcing, std::size_t std_freedom) {
  HarmonicBalanceOptions of_levels = options;
  of_levels.forcing = forcing;
  const std::set<std::size_t> modes(levels.mode.begin(), levels.mode.end());
  std::vector<ComparedTest> tests;
  for (const std::size_t mode : modes) {
    const ModeQuestion question(levels, mode, std_freedom);
    if (question.curves().empty()) continue;
    const std::string name =
        modes.size() == 1 ? source : fmt::format("{}: mode {}", source, mode + 1);
    tests.push_back(compare_mode(name, question, model, of_levels, spread, draws));
  }
  if (!tests.empty()) return tests;
  throw InputError(source, "no frequency, damping ratio or dissipation of all joints",
                   "must contain one of them to be compared");
}

}  // namespace microslip
