// SPDX-License-Identifier: MIT
#include "microslip/ensemble/case_prediction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numbers>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/documents/response/load_file.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "microslip/workflow/predict/backbone_draws.hpp"
#include "microslip/workflow/predict/march_draws.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/predict/response_draws.hpp"

namespace microslip {
namespace {

constexpr std::size_t kOfMotion = 3;  // w, ẇ, ẅ
constexpr double kTwoPi = 2.0 * std::numbers::pi;

HarmonicBalance balance_of_case(const PlannedCase& planned, const ModelFile& model) {
  HarmonicBalanceOptions options;
  options.harmonics = planned.harmonics;
  options.samples = planned.samples;
  return {model.structure, {model.response}, options};
}

void require_converged(const Summary& summary) {
  if (summary.converged()) return;
  throw InputError("the model itself", "not converged",
                   fmt::format("must have a response, as the reference: {}", summary.reason));
}

/// The constant excitation of the model: a force, or the acceleration of its base.
Target kept_of(const PlannedCase& planned, const ModelFile& model) {
  if (planned.response) return {Quantity::kResponse, *planned.response};
  const bool base = model.structure.base_driven();
  if (base != planned.acceleration.has_value()) {
    throw InputError(base ? "force_N" : "acceleration_m_per_s2",
                     base ? *planned.force : *planned.acceleration,
                     base ? "must be left out: the model is driven by its base"
                          : "must be left out: the model is driven by a force",
                     base ? "Give acceleration_m_per_s2." : "Give force_N.");
  }
  return {Quantity::kForceAmplitude, base ? *planned.acceleration : *planned.force};
}

void append(std::vector<double>& values, const std::vector<double>& more) {
  std::ranges::copy(more, std::back_inserter(values));
}

std::vector<EnsembleOutput> over(const std::vector<TableColumn>& shapes,
                                 const std::vector<double>& axis, const std::string& axis_name,
                                 const Dimension& axis_dimension) {
  std::vector<EnsembleOutput> outputs;
  for (const TableColumn& shape : shapes) {
    outputs.push_back({shape.name, shape.dimension, axis, axis_name, axis_dimension});
  }
  return outputs;
}

/// A curve over the frequency, and its peaks.
class ResponseCase : public CasePrediction {
 public:
  ResponseCase(const PlannedCase& planned, const ModelFile& model)
      : balance_(balance_of_case(planned, model)),
        range_{kept_of(planned, model), kTwoPi * planned.from, kTwoPi * planned.to},
        reference_(
            balance_.follow(range_.kept, Quantity::kAngularFrequency, range_.from, range_.to)) {
    require_converged(reference_.summary);
    prediction_ = std::make_unique<ResponseOfDraws>(balance_, reference_, range_);
    const bool of_force = planned.response.has_value();
    ResponseCurve judged = reference_;
    judge_response(balance_, model, range_.kept.quantity, judged);
    warnings_ = std::move(judged.warnings);
    const CurveHeight height = of_force ? drive_of(model.structure) : displacement_height();
    const std::string name(height.name);
    std::vector<double> axis;
    for (const SteadyVibration& point : reference_.points) axis.push_back(point.frequency());
    outputs_ = over({{name + "_lower", height.dimension}, {name + "_upper", height.dimension}},
                    axis, "frequency", kFrequency);
    if (reference_.peaks.empty()) return;
    axis.clear();
    for (const SteadyVibration& peak : reference_.peaks) axis.push_back(peak.frequency());
    std::ranges::move(over({{"peak_frequency", kFrequency}, {"peak_" + name, height.dimension}},
                           axis, "peak_of_model", kFrequency),
                      std::back_inserter(outputs_));
  }

  const std::vector<EnsembleOutput>& outputs() const override { return outputs_; }
  const std::vector<Warning>& warnings() const override { return warnings_; }

  JobResult of(StructureDraw drawn) const override {
    DrawnResponse response = prediction_->of(std::move(drawn));
    if (!response.failure.empty()) return {{}, std::move(response.failure)};
    JobResult result{std::move(response.lower), {}};
    append(result.values, response.upper);
    append(result.values, response.peak_frequency);
    append(result.values, response.peak_height);
    return result;
  }

 private:
  HarmonicBalance balance_;
  ResponseRange range_;
  ResponseCurve reference_;
  std::unique_ptr<const ResponseOfDraws> prediction_;  ///< refers to those above
  std::vector<EnsembleOutput> outputs_;
  std::vector<Warning> warnings_;
};

class BackboneCase : public CasePrediction {
 public:
  BackboneCase(const PlannedCase& planned, const ModelFile& model)
      : balance_(balance_of_case(planned, model)),
        responses_(planned.responses),
        mode_(planned.mode - 1),
        reference_(balance_.resonances(responses_, mode_)) {
    require_converged(reference_.summary);
    ResponseCurve judged = reference_;
    judge_backbone(balance_, model, judged);
    warnings_ = std::move(judged.warnings);
    std::vector<double> axis;
    for (const SteadyVibration& point : reference_.points) axis.push_back(point.response);
    const CurveHeight drive = drive_of(model.structure);
    outputs_ = over({{std::string(drive.name), drive.dimension},
                     {"frequency", kFrequency},
                     {"damping_ratio", kDimensionless}},
                    axis, "displacement", kLength);
  }

  const std::vector<EnsembleOutput>& outputs() const override { return outputs_; }
  const std::vector<Warning>& warnings() const override { return warnings_; }

  JobResult of(StructureDraw drawn) const override {
    DrawnBackbone backbone =
        drawn_backbone(balance_, reference_, responses_, mode_, std::move(drawn));
    if (!backbone.failure.empty()) return {{}, std::move(backbone.failure)};
    JobResult result{std::move(backbone.force), {}};
    append(result.values, backbone.frequency);
    append(result.values, backbone.damping_ratio);
    return result;
  }

 private:
  HarmonicBalance balance_;
  std::vector<double> responses_;
  std::size_t mode_;
  ResponseCurve reference_;
  std::vector<EnsembleOutput> outputs_;
  std::vector<Warning> warnings_;
};

/// How large a motion in time is: peaks and rms of w, ẇ and ẅ, where a base accelerates of the
/// absolute ones, too.
class MarchCase : public CasePrediction {
 public:
  MarchCase(const PlannedCase& planned, const ModelFile& model)
      : file_(planned.force_file), loads_(read_loads(planned.force_file, model.structure)) {
    options_.points = {model.response};
    options_.step = planned.step;
    MarchResult own = march_rows(model.structure, loads_, options_, [](const MarchRow&) {});
    require_converged(own.summary);
    for (const std::string size : {"largest_", "rms_"}) {
      add_outputs(size);
      if (!own.absolute_sizes().empty()) add_outputs(size + "absolute_");
    }
    options_.estimate_error = false;  // that of the model is used for all
    warnings_ = std::move(own.warnings);
    std::ranges::move(march_warnings(model, own.reach), std::back_inserter(warnings_));
    std::ranges::move(gain_warnings(model, loads_), std::back_inserter(warnings_));
  }

  const std::vector<EnsembleOutput>& outputs() const override { return outputs_; }
  const std::vector<Warning>& warnings() const override { return warnings_; }
  std::vector<std::string> files() const override { return {file_}; }

  JobResult of(StructureDraw drawn) const override {
    const MarchResult result = march_rows(drawn.structure, loads_over_gains(loads_, drawn),
                                          options_, [](const MarchRow&) {});
    if (!result.summary.converged()) return {{}, result.summary.reason};
    JobResult done;
    for (double SignalSize::*which : {&SignalSize::peak, &SignalSize::rms}) {
      const auto add = [&](std::span<const SignalSize> motion) {
        for (const SignalSize& size : motion) {
          done.values.push_back(drawn.response_gain * (size.*which));
        }
      };
      add(std::span(result.sizes).first(kOfMotion));
      add(result.absolute_sizes());
    }
    return done;
  }

 private:
  void add_outputs(const std::string& prefix) {
    outputs_.push_back({prefix + "displacement", kLength});
    outputs_.push_back({prefix + "velocity", kVelocity});
    outputs_.push_back({prefix + "acceleration", kAcceleration});
  }

  std::string file_;
  LoadHistory loads_;
  MarchOptions options_;
  std::vector<EnsembleOutput> outputs_;
  std::vector<Warning> warnings_;
};

}  // namespace

std::unique_ptr<const CasePrediction> make_case(const PlannedCase& planned, const ModelFile& model,
                                                const std::string& plan) {
  try {
    switch (planned.kind) {
      case PlannedCase::Kind::kBackbone:
        return std::make_unique<BackboneCase>(planned, model);
      case PlannedCase::Kind::kMarch:
        return std::make_unique<MarchCase>(planned, model);
      case PlannedCase::Kind::kFrf:
        break;
    }
    return std::make_unique<ResponseCase>(planned, model);
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: case '{}': {}", plan, planned.name, error.name()));
  }
}

std::vector<Warning> warnings_of(const std::vector<std::unique_ptr<const CasePrediction>>& cases,
                                 const std::vector<PlannedCase>& planned) {
  std::vector<Warning> warnings;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (const Warning& warning : cases[i]->warnings()) {
      warnings.push_back(
          {warning.code, fmt::format("Case '{}': {}", planned[i].name, warning.text)});
    }
  }
  return warnings;
}

}  // namespace microslip
