// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign/campaign_test_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "microslip/base/codes.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/recordings/assumed_units.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/rig/setup/stick_state.hpp"
#include "microslip/signal/decay/ring_down_levels.hpp"
#include "microslip/workflow/compare/loops_comparison.hpp"
#include "microslip/workflow/predict/rig_model.hpp"
#include "microslip/workflow/reduce/decay_reduction.hpp"
#include "microslip/workflow/reduce/modal_decay.hpp"
#include "microslip/workflow/reduce/modal_levels_reduction.hpp"
#include "microslip/workflow/reduce/named_recordings.hpp"
#include "microslip/workflow/reduce/point_sensors.hpp"
#include "microslip/workflow/reduce/record_levels.hpp"
#include "microslip/workflow/reduce/recordings_reduction.hpp"
#include "microslip/workflow/text/named_rig.hpp"

namespace microslip {
namespace {

// ---- What a test may be. ----

std::string_view name_of(TestContent content) {
  switch (content) {
    case TestContent::kLevels:
      return "a table of levels";
    case TestContent::kModalLevels:
      return "a table of modal levels";
    case TestContent::kSteppedSine:
      return "a stepped-sine table";
    case TestContent::kRecording:
    case TestContent::kOther:  // which its reader refuses
      break;
  }
  return "a recording";
}

bool may_be_recording(TestContent content) {
  return content == TestContent::kRecording || content == TestContent::kOther;
}

bool fits(CampaignKind kind, TestContent content) {
  switch (kind) {
    case CampaignKind::kSweep:
    case CampaignKind::kConstantResponse:
      return content == TestContent::kSteppedSine;
    case CampaignKind::kRingDown:
      return may_be_recording(content) || content == TestContent::kModalLevels;
    case CampaignKind::kLoops:
      return may_be_recording(content);
    case CampaignKind::kFromFile:
      break;
  }
  return true;
}

std::string title_of(const CampaignTest& test) { return fmt::format("test '{}'", test.name); }

/// Refuses keys that only recordings have.
void check_recording_keys(const CampaignTest& test, TestContent content) {
  if (may_be_recording(content)) return;
  const auto refuse = [&](const char* key) {
    throw InputError(
        fmt::format("{}: {}", title_of(test), key), InputState{"given"},
        fmt::format("applies to recordings, and {} is {}", test.file, name_of(content)),
        "Leave it out.");
  };
  if (!test.sensors.empty()) refuse("sensors");
  if (!test.assumed_units.empty()) refuse("assume_units");
  if (test.allow_truncated) refuse("allow_truncated");
  if (test.rate) refuse("rate_Hz");
}

/// Reason why a table cannot be used as levels of modes, or as a recording;
/// empty of what may be a recording.
std::string why_no_recording(const TestFile& file) {
  if (!file.part.variable.empty()) return {};
  const std::string& head = file.text;
  if (std::ranges::all_of(head, [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); })) {
    return "is empty";
  }
  if (file.kind == kPathKind) {  // by its displacement alone
    const std::vector<std::string> columns = csv_column_names(head);
    const bool has_mode = std::ranges::find(columns, "mode") != columns.end();
    return has_mode ? "has no loss" : "lacks the column 'mode [1]'";
  }
  const KnownKind* const known = known_kind(file.kind);
  if (known == nullptr || known->is_recording) return {};
  return fmt::format("is {}", known->words);
}

/// Before its channels are looked for.
void check_may_be_recording(const CampaignTest& test, const TestFile& file) {
  const std::string why = why_no_recording(file);
  if (why.empty()) return;
  throw InputError(title_of(test), in_quotes(test.file),
                   fmt::format("must be levels of modes, or a recording, and {}", why),
                   "Levels of modes have columns 'mode [1]', 'displacement [m]' and, of the loss, "
                   "'dissipation [J]' or 'damping_ratio [1]'.");
}

void check_predictable(const CampaignTest& test, TestContent content) {
  const bool kind_given = test.kind != CampaignKind::kFromFile;
  if (content == TestContent::kSteppedSine || content == TestContent::kModalLevels) return;
  if (may_be_recording(content) && kind_given) return;
  throw InputError(
      title_of(test), in_quotes(test.file),
      "must be stepped sines, modal levels, or a recording with its kind to be predicted",
      content == TestContent::kLevels
          ? "Levels are for identification; leave_one_out predicts them."
          : "Of a recording give kind = \"ringdown\", a free decay, or \"loops\", force and "
            "displacement of the joint. The subcommand verify predicts steady records of a rig.");
}

/// Several joints are found from levels of modes.
void check_tells_of_modes(const CampaignTest& test, TestContent content) {
  if (content == TestContent::kModalLevels || may_be_recording(content)) return;
  throw InputError(
      title_of(test), in_quotes(test.file),
      fmt::format("must be levels of modes to identify a model from, and is {}", name_of(content)),
      content == TestContent::kLevels
          ? "The subcommand identify identifies a joint from its own levels; the model refers to "
            "its file."
          : "Give modal_levels.csv, or recordings: steady ones, or a free decay with "
            "kind = \"ringdown\". Stepped sines can be predicted.");
}

void check_identifiable(const CampaignTest& test, TestContent content) {
  if (content != TestContent::kModalLevels) return;
  throw InputError(
      title_of(test), in_quotes(test.file),
      "must not be modal levels to identify from: they have no amplitude of the joint",
      "Give the recording from which they come, with kind = \"ringdown\", or levels.csv.");
}

// ---- Levels of a ring-down. ----

/// The code of ring_down() for a decay whose shape may not be taken as fixed.
constexpr std::string_view kFrequencyMoves = "frequency_moves";

/// The structure with a joint that does not slip.
ModelFile stuck_model(const NamedInput& rig, double stiffness) {
  return model_of_rig(rig, {Joint(stiffness, {}), {}, {}}, "", kModesOfCampaign).file;
}

const std::string& point_of(const std::string& channel, const std::vector<PointSensor>& sensors) {
  return std::ranges::find(sensors, channel, &PointSensor::channel)->point;
}

/// The first mode while its joint slips, seen at a sensor.
struct SlippingMode {
  double modal_mass = 0.0;   ///< Σq_i²/x², kg
  double joint_ratio = 0.0;  ///< joint over sensor, 1
  double linear_loss = 0.0;  ///< πΣη_iω_i²q_i²/x², J/m²: what the structure loses without its joint
};

/// A spring that takes δψψᵀ off the stiffness, whatever δ, moves the mode to ω with shares
/// q_i ∝ ψ_i/(ω_i² − ω²) of the stuck modes; x = Σφ_iq_i at the sensor. It stays as it is stuck at
/// frequencies above that: these are no slip.
/// @param sensor  φ there, kg^-1/2. @param stiffness  k, N/m. @param frequency  ω/2π, Hz.
SlippingMode slipping_mode(const StickState& state, std::span<const double> sensor,
                           double stiffness, double frequency) {
  const double stuck = state.omega[0] * state.omega[0];
  const double square = std::min(std::pow(2.0 * std::numbers::pi * frequency, 2), stuck);
  double x = sensor[0];
  double u = state.joint[0];
  SlippingMode mode{.modal_mass = 1.0, .linear_loss = state.loss_factor[0] * stuck};
  for (std::size_t i = 1; i < state.modes(); ++i) {
    const double own = state.omega[i] * state.omega[i];
    const double q = state.joint[i] / state.joint[0] * (stuck - square) / (own - square);
    x += sensor[i] * q;
    u += state.joint[i] * q;
    mode.modal_mass += q * q;
    mode.linear_loss += state.loss_factor[i] * own * q * q;
  }
  mode.modal_mass /= x * x;
  mode.linear_loss *= std::numbers::pi / (x * x);
  mode.joint_ratio = u / x / (1.0 + stiffness * state.axial_compliance);
  return mode;
}

constexpr std::array kLevelValues{
    &RingDownLevels::amplitude,
    &RingDownLevels::amplitude_std,
    &RingDownLevels::dissipation,
    &RingDownLevels::dissipation_std,
    &RingDownLevels::time,
    &RingDownLevels::frequency,
    &RingDownLevels::frequency_std,
    &RingDownLevels::damping_ratio,
    &RingDownLevels::damping_ratio_std,
};

/// Leaves out levels of which the structure alone would lose as much.
void drop_lossless(RingDownLevels& levels) {
  const std::vector<double> loss = levels.dissipation;
  const auto drop = [&](auto& values) {
    std::size_t i = 0;
    std::erase_if(values, [&](const auto&) { return !(loss[i++] > 0.0); });
  };
  for (const auto values : kLevelValues) drop(levels.*values);
  drop(levels.flags);
  const std::size_t dropped = loss.size() - levels.amplitude.size();
  if (dropped == 0) return;
  levels.warnings.push_back(
      {"linear_loss_exceeds_all", fmt::format("{} levels are left out: the loss factors of the "
                                              "structure account for more than their total loss.",
                                              dropped)});
}

/// Levels of the joint of those of the sensor, which have a modal mass of 1 kg.
void bring_to_joint(const StickState& state, std::span<const double> sensor, double stiffness,
                    RingDownLevels& levels) {
  for (std::size_t i = 0; i < levels.amplitude.size(); ++i) {
    const SlippingMode mode = slipping_mode(state, sensor, stiffness, levels.frequency[i]);
    const double x = levels.amplitude[i];
    levels.dissipation[i] = mode.modal_mass * levels.dissipation[i] - mode.linear_loss * x * x;
    levels.dissipation_std[i] *= mode.modal_mass;
    levels.amplitude[i] *= std::abs(mode.joint_ratio);
    levels.amplitude_std[i] *= std::abs(mode.joint_ratio);
  }
  drop_lossless(levels);
}

/// Warnings on other modes at the joint belong to the levels of this one, too.
void flag_modulated(const RingDownLevels& modal, RingDownLevels& levels) {
  for (std::size_t i = 0; i < levels.time.size(); ++i) {
    const auto same = std::ranges::find(modal.time, levels.time[i]) - modal.time.begin();
    const std::string& flags = modal.flags[static_cast<std::size_t>(same)];
    if (flags.find(kModesModulate) == std::string::npos) continue;
    add_code(levels.flags[i], kModesModulate);
  }
}

RingDownLevels joint_levels(const CampaignFile& campaign, const ModalDecay& mode,
                            const StickState& state, std::span<const double> sensor) {
  RingDownLevels levels = levels_of(mode.decay, {.modal_mass = 1.0});
  bring_to_joint(state, sensor, campaign.stiffness, levels);
  if (levels.amplitude.empty()) {
    throw InputError("levels", fmt::format("a loss factor of {:.3g}", state.loss_factor[0]),
                     "must leave some loss to the joint, but exceeds all measured losses",
                     fmt::format("Check [damping] of {}.", campaign.structure));
  }
  flag_modulated(mode.levels, levels);
  return levels;
}

ReducedCampaignTest reduce_decay_of(const OpenedCampaign& opened, std::size_t number,
                                    const std::string& command) {
  const CampaignFile& campaign = opened.plan;
  const CampaignTest& test = campaign.tests[number];
  const NamedInput& rig = opened.structure;
  const ModelFile model = stuck_model(rig, campaign.stiffness);
  const StickState state =
      of_rig(rig, [&] { return stick_state(parse_rig(rig), kModesOfCampaign); });
  const Recordings recordings =
      read_recordings(opened.tests[number], campaign_reading(test).reading);
  ReducedModalDecay found = reduce_modal_decay({.recording = test.file,
                                                .model = campaign.structure,
                                                .sensors = test.sensors,
                                                .modes = {1},
                                                .reading = campaign_reading(test).reading},
                                               model, recordings);
  ModalDecay& mode = found.modes.front();
  const std::vector<PointSensor> sensors = point_sensors(test.sensors, model, campaign.structure);
  const std::span<const double> sensor =
      model.structure.linear().shape(point_of(mode.decay.sensors.front().name, sensors));
  RingDownLevels levels = joint_levels(campaign, mode, state, sensor);
  ReducedCampaignTest reduced{.warnings = std::move(found.warnings),
                              .converged = found.converged()};
  // Levels are those of the joint, in the shape that the mode has at its frequency.
  std::erase_if(reduced.warnings, [](const Warning& one) {
    return one.code == kShapeAssumed || one.code == kFrequencyMoves;
  });
  std::ranges::copy(levels.warnings, std::back_inserter(reduced.warnings));
  reduced.text = levels_text(
      ReducedDecay{found.source, std::move(mode.decay), std::move(levels), reduced.warnings, false},
      command);
  return reduced;
}

// ---- Levels of others. ----

/// Levels do not tell what loops do: a dead zone, or loops that are no branches of one another.
std::vector<Warning> departures_of_records(const ForceRecords& read) {
  std::vector<Warning> warnings;
  for (const NamedForceRecord& one : read.records) {
    if (auto warning = departures_of(RecordEvidence(one.record, PathStart::kUnknown))) {
      warnings.push_back(std::move(*warning));
    }
  }
  return warnings;
}

ReducedCampaignTest reduce_loops_of(const OpenedCampaign& campaign, std::size_t number,
                                    const std::string& command) {
  const TestReading reading = campaign_reading(campaign.plan.tests[number]);
  const ForceRecords read =
      read_force_records({campaign.tests[number]}, reading.channels, reading.reading);
  RecordLevels found = find_record_levels(read);
  std::ranges::move(departures_of_records(read), std::back_inserter(found.warnings));
  return {.text = levels_text(found, command), .warnings = found.warnings};
}

ReducedCampaignTest reduce_by_rig(const OpenedCampaign& campaign, std::size_t number,
                                  const std::string& command, const Progress& progress) {
  const CampaignTest& test = campaign.plan.tests[number];
  const ReducedRecordings found = reduce_recordings({.test = campaign.plan.structure,
                                                     .recordings = {test.file},
                                                     .reading = campaign_reading(test).reading,
                                                     .test_input = campaign.structure,
                                                     .opened = {campaign.tests[number]},
                                                     .progress = progress});
  ReducedCampaignTest reduced{.text = levels_text(found, command)};
  for (const std::vector<Warning>& warnings : found.warnings) {
    std::ranges::copy(warnings, std::back_inserter(reduced.warnings));
  }
  return reduced;
}

std::optional<TestKind> test_kind_of(CampaignKind kind) {
  switch (kind) {
    case CampaignKind::kSweep:
      return TestKind::kSweep;
    case CampaignKind::kConstantResponse:
      return TestKind::kConstantResponse;
    case CampaignKind::kRingDown:
      return TestKind::kRingDown;
    case CampaignKind::kLoops:
      return TestKind::kLoops;
    case CampaignKind::kFromFile:
      break;
  }
  return std::nullopt;
}

}  // namespace

void check_campaign_test(const CampaignTest& test, const TestFile& file, CampaignSubject subject) {
  const TestContent content = file.content;
  require_file(file, title_of(test), "a file");
  if (!fits(test.kind, content)) {
    throw InputError(fmt::format("{}: kind", title_of(test)), in_quotes(to_string(test.kind)),
                     fmt::format("must be what {} is: {}", test.file, name_of(content)),
                     "Leave it out; the file determines it.");
  }
  check_recording_keys(test, content);
  const bool of_model = subject == CampaignSubject::kModel;
  if (of_model && may_be_recording(content)) check_may_be_recording(test, file);
  if (test.predicted()) check_predictable(test, content);
  if (!test.identifies()) return;
  if (of_model) {
    check_tells_of_modes(test, content);
  } else {
    check_identifiable(test, content);
  }
}

ReducedCampaignTest reduce_modal_test(const OpenedCampaign& campaign, std::size_t number,
                                      const std::string& command, const Progress& progress) {
  const CampaignTest& test = campaign.plan.tests[number];
  const TestFile& file = campaign.tests[number];
  const TestReading reading = campaign_reading(test);
  if (test.kind == CampaignKind::kRingDown) {
    const ReducedModalDecay found =
        reduce_modal_decay({.recording = test.file,
                            .model = campaign.plan.structure,
                            .sensors = test.sensors,
                            .modes = reading.modes,
                            .reading = reading.reading},
                           *campaign.model, read_recordings(file, reading.reading));
    return {.text = modal_levels_text(found, command),
            .warnings = found.warnings,
            .converged = found.converged()};
  }
  const ReducedModalLevels found = reduce_modal_levels({.test = campaign.plan.structure,
                                                        .recordings = {test.file},
                                                        .reading = reading.reading,
                                                        .test_input = campaign.structure,
                                                        .opened = {file},
                                                        .progress = progress});
  ReducedCampaignTest reduced{.text = modal_levels_text(found, command)};
  for (const std::vector<Warning>& warnings : found.warnings) {
    std::ranges::copy(warnings, std::back_inserter(reduced.warnings));
  }
  return reduced;
}

ReducedCampaignTest reduce_campaign_test(const OpenedCampaign& campaign, std::size_t number,
                                         const std::string& command, const Progress& progress) {
  const CampaignKind kind = campaign.plan.tests[number].kind;
  if (kind == CampaignKind::kRingDown) return reduce_decay_of(campaign, number, command);
  if (kind == CampaignKind::kLoops) return reduce_loops_of(campaign, number, command);
  return reduce_by_rig(campaign, number, command, progress);
}

TestReading campaign_reading(const CampaignTest& test) {
  TestReading reading{.kind = test_kind_of(test.kind),
                      .sensors = test.sensors,
                      .channels = {.force = test.force, .displacement = test.displacement},
                      .reading = {.allow_truncated = test.allow_truncated,
                                  .rate = test.rate,
                                  .assumed_units = parse_assumed_units(test.assumed_units)}};
  if (test.kind == CampaignKind::kRingDown && test.mode > 0) reading.modes = {test.mode};
  return reading;
}

}  // namespace microslip
