// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/verification_draws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/dynamics/draws/structure_draws.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

constexpr std::size_t kChecked = 4;  // values of a record

struct CheckedColumn {
  const char* measured;   ///< `MEASURED_inside`
  const char* predicted;  ///< `PREDICTED_lower`, `PREDICTED_upper`
  Dimension dimension;
  CheckedValue CheckedRecord::*value;
  bool is_new;  ///< the table has no column of the prediction itself
};

std::array<CheckedColumn, kChecked> checked_columns() {
  return {
      {{"response", "predicted_response", kAcceleration, &CheckedRecord::response, true},
       {"frequency", "predicted_frequency", kFrequency, &CheckedRecord::frequency, true},
       {"joint_amplitude", "predicted_joint_amplitude", kLength, &CheckedRecord::amplitude, false},
       {"input_energy", "predicted_input_energy", kEnergy, &CheckedRecord::input_energy, false}}};
}

std::string text_of(const RigUncertainty& rig, bool has_samples) {
  std::string text = has_samples ? "samples of the joint" : "";
  const auto add = [&](const char* what, double spread) {
    if (spread > 0.0) text += fmt::format("{}{}, {:g}", text.empty() ? "" : "; ", what, spread);
  };
  add("normal load", rig.normal_load);
  add("frequencies", rig.frequency);
  add("loss factors", rig.loss_factor);
  add("gain of the force", rig.force_gain);
  add("gain of the accelerations", rig.acceleration_gain);
  return text;
}

/// One value a draw, in the order of checked_columns().
using Values = std::array<double, kChecked>;

/// Asks a balance what it does at a record; in words why not.
class RecordQuestion {
 public:
  RecordQuestion(const Verifier& verifier, const Verification& record, const JointDraws& joint,
                 const StructureSpread& spread, std::uint64_t seed)
      : record_(record),
        balance_(verifier.balance(record.setting)),
        draws_(balance_.structure(), spread, {joint}, JointPairing::kIndependent, seed),
        sees_joint_(verifier.reducer().rig().vibrometer &&
                    verifier.reducer().options().use_vibrometer) {}

  /// By the joint itself.
  [[nodiscard]] Values nominal() const {
    Values values{};
    const std::string reason = ask(balance_, 1.0, 1.0, values);
    if (reason.empty()) return values;
    throw InputError(fmt::format("{}: prediction", record_.recorded.source), "none",
                     fmt::format("must converge before draws are compared with it: {}", reason),
                     "Leave the record out.");
  }

  /// By draw i. @return why it failed, or nothing
  [[nodiscard]] std::string draw(std::size_t i, Values& values) const {
    StructureDraw drawn = draws_.draw(i);
    const double force_gain = drawn.force_gain.front();
    const double gain = drawn.response_gain;
    const HarmonicBalance balance(std::move(drawn.structure), balance_.response(),
                                  balance_.options());
    return ask(balance, gain, force_gain, values);
  }

 private:
  [[nodiscard]] std::string ask(const HarmonicBalance& balance, double gain, double force_gain,
                                Values& values) const {
    RecordedSetting setting = record_.setting;
    setting.response /= gain;
    const PredictedVibration there = predict_at(balance, setting, &record_.vibration);
    const std::string& source = record_.recorded.source;
    if (!there.summary.converged()) return fmt::format("{}: {}", source, there.summary.reason);
    const std::optional<PredictedPeak> peak = predict_peak(balance, setting, there.vibration);
    if (!peak) {
      return fmt::format("{}: no frequency near the recorded one has the recorded phase", source);
    }
    values = {gain * peak->response, peak->frequency,
              (sees_joint_ ? 1.0 : gain) * there.level.amplitude,
              gain * force_gain * there.level.input_energy};
    return "";
  }

  const Verification& record_;
  HarmonicBalance balance_;
  StructureDraws draws_;
  bool sees_joint_;
};

CheckedRecord checked(const Verification& record, const Values& nominal, const Band& band,
                      std::size_t first) {
  const ReducedLevel& level = record.recorded;
  const Values measured{level.response_amplitude,
                        record.setting.angular_frequency / (2.0 * std::numbers::pi),
                        level.amplitude.value, level.input_energy.value};
  CheckedRecord result;
  const std::array<CheckedColumn, kChecked> columns = checked_columns();
  for (std::size_t c = 0; c < kChecked; ++c) {
    result.*
        columns[c].value = {measured[c], nominal[c], band.lower[first + c], band.upper[first + c]};
  }
  return result;
}

std::string inside_text(const VerificationSpread& spread) {
  std::string text;
  for (const CheckedColumn& column : checked_columns()) {
    text += fmt::format("{}{} {} of {}", text.empty() ? "" : ", ", column.measured,
                        spread.inside(column.value), spread.records.size());
  }
  std::ranges::replace(text, '_', ' ');
  return text;
}

}  // namespace

std::size_t VerificationSpread::inside(CheckedValue CheckedRecord::*value) const {
  return static_cast<std::size_t>(std::ranges::count_if(
      records, [&](const CheckedRecord& record) { return (record.*value).inside(); }));
}

VerificationSpread verification_spread(const Verifier& verifier,
                                       const std::vector<Verification>& records, JointDraws joint,
                                       const RigUncertainty& rig, const DrawOptions& options,
                                       const Execution& execution, const Progress& progress) {
  options.check();
  VerificationSpread spread;
  spread.uncertain = text_of(rig, joint.count > 0);
  if (spread.uncertain.empty()) {
    throw InputError("uncertainty", "none", "must include a parameter that the draws can vary",
                     "Give `samples` of the joint, `normal_load_std`, `frequency_std`, "
                     "`loss_factor_std`, `force_gain_std` or `acceleration_gain_std`.");
  }
  if (records.empty())
    throw InputError("records", 0, "must be 1 or more to be compared with draws");
  const std::size_t modes = verifier.reducer().state().modes();
  const StructureSpread numbers{.frequency = std::vector<double>(modes, rig.frequency),
                                .loss_factor = std::vector<double>(modes, rig.loss_factor),
                                .normal_load = {rig.normal_load},
                                .force_gain = {rig.force_gain},
                                .response_gain = rig.acceleration_gain};
  std::vector<RecordQuestion> questions;
  std::vector<Values> nominal;
  for (const Verification& record : records) {
    questions.emplace_back(verifier, record, joint, numbers, options.seed);
    nominal.push_back(questions.back().nominal());
  }
  std::vector<std::vector<double>> values(options.count);  // [draw][record, column]
  const auto take = [&](std::size_t i) {
    std::vector<double> all;
    for (const RecordQuestion& question : questions) {
      Values one{};
      std::string reason = question.draw(i, one);
      if (!reason.empty()) return reason;
      all.insert(all.end(), one.begin(), one.end());
    }
    values[i] = std::move(all);
    return std::string();
  };
  spread.taken = take_draws(options, take, execution, progress);
  const Band band = band_of(values, options.confidence);
  for (std::size_t r = 0; r < records.size(); ++r) {
    spread.records.push_back(checked(records[r], nominal[r], band, kChecked * r));
  }
  spread.warnings = draw_warnings(spread.taken);
  return spread;
}

void add_checked(const VerificationSpread& spread, const std::vector<Verification>& records,
                 CsvWriter& table) {
  const auto add = [&](const std::string& name, const Dimension& dimension, auto value) {
    std::vector<double> rows;
    for (std::size_t r = 0; r < records.size(); ++r) {
      rows.insert(rows.end(), records[r].channels.size(), value(spread.records[r]));
    }
    table.add_numbers(name, dimension, rows);
  };
  const std::array<CheckedColumn, kChecked> columns = checked_columns();
  for (const CheckedColumn& column : columns) {
    if (!column.is_new) continue;
    add(column.predicted, column.dimension,
        [&](const CheckedRecord& record) { return (record.*column.value).predicted; });
  }
  for (const CheckedColumn& column : columns) {
    const std::string name = column.predicted;
    add(name + "_lower", column.dimension,
        [&](const CheckedRecord& record) { return (record.*column.value).lower; });
    add(name + "_upper", column.dimension,
        [&](const CheckedRecord& record) { return (record.*column.value).upper; });
  }
  for (const CheckedColumn& column : columns) {
    add(std::string(column.measured) + "_inside", kDimensionless,
        [&](const CheckedRecord& record) { return (record.*column.value).inside() ? 1.0 : 0.0; });
  }
}

std::string checked_comment(const VerificationSpread& spread) {
  return draws_comment(spread.taken, spread.uncertain) +
         "\ninside the band of the draws: " + inside_text(spread);
}

std::string describe_checked(const VerificationSpread& spread) {
  return "Draws\n" + describe_draws(spread.taken, spread.uncertain) +
         line("measured inside", inside_text(spread));
}

}  // namespace microslip
