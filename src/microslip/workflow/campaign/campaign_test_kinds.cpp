// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign/campaign_test_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/documents/levels/stepped_sine_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/io/recordings/assumed_units.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/rig/setup/stick_state.hpp"
#include "microslip/signal/decay/ring_down_levels.hpp"
#include "microslip/workflow/compare/loops_comparison.hpp"
#include "microslip/workflow/predict/rig_model.hpp"
#include "microslip/workflow/reduce/decay_reduction.hpp"
#include "microslip/workflow/reduce/modal_decay.hpp"
#include "microslip/workflow/reduce/modal_levels_reduction.hpp"
#include "microslip/workflow/reduce/point_sensors.hpp"
#include "microslip/workflow/reduce/record_levels.hpp"
#include "microslip/workflow/reduce/recordings_reduction.hpp"
#include "microslip/workflow/text/named_rig.hpp"

namespace microslip {
namespace {

// ---- What a test may be. ----

/// What its file holds.
enum class CampaignContent : std::uint8_t { kLevels, kModalLevels, kSweeps, kRecording };

CampaignContent content_of_test(const CampaignTest& test) {
  if (is_stepped_sine(test.file)) return CampaignContent::kSweeps;
  const PartOfFile part = part_of_file(test.file);
  const std::string kind = file_kind(read_kind_head(part.file));  // throws where there is no file
  if (!part.variable.empty()) return CampaignContent::kRecording;
  if (kind == kLevelsKind) return CampaignContent::kLevels;
  return kind == kModalLevelsKind ? CampaignContent::kModalLevels : CampaignContent::kRecording;
}

std::string_view name_of(CampaignContent content) {
  switch (content) {
    case CampaignContent::kLevels:
      return "a table of levels";
    case CampaignContent::kModalLevels:
      return "a table of modal levels";
    case CampaignContent::kSweeps:
      return "a stepped-sine table";
    case CampaignContent::kRecording:
      break;
  }
  return "a recording";
}

bool fits(CampaignKind kind, CampaignContent content) {
  switch (kind) {
    case CampaignKind::kSweep:
    case CampaignKind::kConstantResponse:
      return content == CampaignContent::kSweeps;
    case CampaignKind::kRingDown:
      return content == CampaignContent::kRecording || content == CampaignContent::kModalLevels;
    case CampaignKind::kLoops:
      return content == CampaignContent::kRecording;
    case CampaignKind::kTold:
      break;
  }
  return true;
}

std::string title_of(const CampaignTest& test) { return fmt::format("test '{}'", test.name); }

/// What only recordings have.
void check_recording_keys(const CampaignTest& test, CampaignContent content) {
  if (content == CampaignContent::kRecording) return;
  const auto refuse = [&](const char* key) {
    throw InputError(
        fmt::format("{}: {}", title_of(test), key), InputState{"given"},
        fmt::format("belongs to recordings, and {} is {}", test.file, name_of(content)),
        "Leave it out.");
  };
  if (!test.sensors.empty()) refuse("sensors");
  if (!test.assumed_units.empty()) refuse("assume_units");
  if (test.allow_truncated) refuse("allow_truncated");
}

/// What of a table that is given in place of levels of modes, or of a recording, is in the way;
/// empty of what may be a recording.
std::string why_no_recording(const CampaignTest& test) {
  const PartOfFile part = part_of_file(test.file);
  if (!part.variable.empty()) return {};
  const std::string head = read_kind_head(part.file);
  if (std::ranges::all_of(head, [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); })) {
    return "is empty";
  }
  const std::string kind = file_kind(head);
  if (kind == kPathKind) {  // by its displacement alone
    const std::vector<std::string> columns = csv_column_names(head);
    const bool has_mode = std::ranges::find(columns, "mode") != columns.end();
    return has_mode ? "tells no loss" : "lacks the column 'mode [1]'";
  }
  const KnownKind* const known = known_kind(kind);
  if (known == nullptr || known->is_recording) return {};
  return fmt::format("is {}", known->words);
}

/// Before its channels are looked for.
void check_may_be_recording(const CampaignTest& test) {
  const std::string why = why_no_recording(test);
  if (why.empty()) return;
  throw InputError(title_of(test), in_quotes(test.file),
                   fmt::format("must be levels of modes, or a recording, and {}", why),
                   "Levels of modes have columns 'mode [1]', 'displacement [m]' and, of the loss, "
                   "'dissipation [J]' or 'damping_ratio [1]'.");
}

void check_predictable(const CampaignTest& test, CampaignContent content) {
  const bool told = test.kind != CampaignKind::kTold;
  if (content == CampaignContent::kSweeps || content == CampaignContent::kModalLevels) return;
  if (content == CampaignContent::kRecording && told) return;
  throw InputError(
      title_of(test), in_quotes(test.file),
      "must be stepped sines, modal levels, or a recording with its kind to be predicted",
      content == CampaignContent::kLevels
          ? "Levels are what joints are identified from; leave_one_out predicts them."
          : "Of a recording give kind = \"ringdown\", a free decay, or \"loops\", force and "
            "displacement of the joint. The subcommand verify predicts steady records of a rig.");
}

/// Several joints are found from levels of modes.
void check_tells_of_modes(const CampaignTest& test, CampaignContent content) {
  if (content == CampaignContent::kModalLevels || content == CampaignContent::kRecording) return;
  throw InputError(
      title_of(test), in_quotes(test.file),
      fmt::format("must be levels of modes to identify a model from, and is {}", name_of(content)),
      content == CampaignContent::kLevels
          ? "The subcommand identify finds a joint from its own levels, which the "
            "model takes by its file."
          : "Give modal_levels.csv, or recordings: steady ones, or a free decay with "
            "kind = \"ringdown\". Stepped sines can be predicted.");
}

void check_identifiable(const CampaignTest& test, CampaignContent content) {
  if (content != CampaignContent::kModalLevels) return;
  throw InputError(title_of(test), in_quotes(test.file),
                   "must not be modal levels to identify from: they have no amplitude of the joint",
                   "Give the recording that they are of, with kind = \"ringdown\", or levels.csv.");
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
      {"linear_loss_exceeds_all",
       fmt::format(
           "{} levels are left out: the loss factors of the structure exceed all of theirs.",
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

/// What other modes do to the joint belongs to the levels of this one, too.
void flag_modulated(const RingDownLevels& modal, RingDownLevels& levels) {
  for (std::size_t i = 0; i < levels.time.size(); ++i) {
    const auto same = std::ranges::find(modal.time, levels.time[i]) - modal.time.begin();
    const std::string& flags = modal.flags[static_cast<std::size_t>(same)];
    if (flags.find(kModesModulate) == std::string::npos) continue;
    levels.flags[i] += (levels.flags[i].empty() ? "" : " ") + std::string(kModesModulate);
  }
}

RingDownLevels joint_levels(const CampaignFile& campaign, const ModalDecay& mode,
                            const StickState& state, std::span<const double> sensor) {
  RingDownLevels levels = levels_of(mode.decay, {.modal_mass = 1.0});
  bring_to_joint(state, sensor, campaign.stiffness, levels);
  if (levels.amplitude.empty()) {
    throw InputError("levels", fmt::format("a loss factor of {:.3g}", state.loss_factor[0]),
                     "must leave some loss to the joint, and exceeds all that was measured",
                     fmt::format("Check [damping] of {}.", campaign.structure));
  }
  flag_modulated(mode.levels, levels);
  return levels;
}

ReducedCampaignTest reduce_decay_of(const CampaignFile& campaign, const CampaignTest& test,
                                    const std::string& command) {
  const NamedInput rig{campaign.structure, read_file(campaign.structure)};
  const ModelFile model = stuck_model(rig, campaign.stiffness);
  const StickState state =
      of_rig(rig, [&] { return stick_state(parse_rig(rig), kModesOfCampaign); });
  ReducedModalDecay found = reduce_modal_decay({.recording = test.file,
                                                .model = campaign.structure,
                                                .sensors = test.sensors,
                                                .modes = {1},
                                                .reading = campaign_reading(test).reading},
                                               model);
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
std::vector<Warning> departures_of_records(const CampaignTest& test, const TestReading& reading) {
  std::vector<Warning> warnings;
  for (const NamedForceRecord& one :
       read_force_records({test.file}, reading.channels, reading.reading).records) {
    if (auto warning = departures_of(RecordEvidence(one.record, PathStart::kUnknown))) {
      warnings.push_back(std::move(*warning));
    }
  }
  return warnings;
}

ReducedCampaignTest reduce_loops_of(const CampaignTest& test, const std::string& command) {
  const TestReading reading = campaign_reading(test);
  RecordLevels found = find_record_levels(
      {.records = {test.file}, .channels = reading.channels, .reading = reading.reading});
  std::ranges::move(departures_of_records(test, reading), std::back_inserter(found.warnings));
  return {.text = levels_text(found, command), .warnings = found.warnings};
}

ReducedCampaignTest reduce_by_rig(const CampaignFile& campaign, const CampaignTest& test,
                                  const std::string& command, const Progress& progress) {
  const ReducedRecordings found = reduce_recordings({.rig = campaign.structure,
                                                     .recordings = {test.file},
                                                     .reading = campaign_reading(test).reading,
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
    case CampaignKind::kTold:
      break;
  }
  return std::nullopt;
}

}  // namespace

void check_campaign_test(const CampaignTest& test, CampaignSubject subject) {
  const CampaignContent content = content_of_test(test);
  if (!fits(test.kind, content)) {
    throw InputError(fmt::format("{}: kind", title_of(test)), in_quotes(to_string(test.kind)),
                     fmt::format("must be what {} is: {}", test.file, name_of(content)),
                     "Leave it out where the file tells.");
  }
  check_recording_keys(test, content);
  const bool of_model = subject == CampaignSubject::kModel;
  if (of_model && content == CampaignContent::kRecording) check_may_be_recording(test);
  if (test.predicted()) check_predictable(test, content);
  if (!test.identifies()) return;
  if (of_model) {
    check_tells_of_modes(test, content);
  } else {
    check_identifiable(test, content);
  }
}

ReducedCampaignTest reduce_modal_test(const CampaignFile& campaign, const CampaignTest& test,
                                      const std::string& command, const Progress& progress) {
  const TestReading reading = campaign_reading(test);
  if (test.kind == CampaignKind::kRingDown) {
    const ReducedModalDecay found =
        reduce_modal_decay({.recording = test.file,
                            .model = campaign.structure,
                            .sensors = test.sensors,
                            .modes = reading.modes,
                            .reading = reading.reading},
                           read_model(campaign.structure, JointsToFind::kAllowed));
    return {.text = modal_levels_text(found, command),
            .warnings = found.warnings,
            .converged = found.converged()};
  }
  const ReducedModalLevels found = reduce_modal_levels({.model = campaign.structure,
                                                        .recordings = {test.file},
                                                        .reading = reading.reading,
                                                        .progress = progress});
  ReducedCampaignTest reduced{.text = modal_levels_text(found, command)};
  for (const std::vector<Warning>& warnings : found.warnings) {
    std::ranges::copy(warnings, std::back_inserter(reduced.warnings));
  }
  return reduced;
}

ReducedCampaignTest reduce_campaign_test(const CampaignFile& campaign, const CampaignTest& test,
                                         const std::string& command, const Progress& progress) {
  if (test.kind == CampaignKind::kRingDown) return reduce_decay_of(campaign, test, command);
  if (test.kind == CampaignKind::kLoops) return reduce_loops_of(test, command);
  return reduce_by_rig(campaign, test, command, progress);
}

TestReading campaign_reading(const CampaignTest& test) {
  TestReading reading{.kind = test_kind_of(test.kind),
                      .sensors = test.sensors,
                      .channels = {.force = test.force, .displacement = test.displacement},
                      .reading = {.allow_truncated = test.allow_truncated,
                                  .assumed_units = parse_assumed_units(test.assumed_units)}};
  if (test.kind == CampaignKind::kRingDown && test.mode > 0) reading.modes = {test.mode};
  return reading;
}

}  // namespace microslip
