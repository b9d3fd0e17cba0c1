// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/modal_decay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "microslip/base/codes.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/execution.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/reduce/decay_signal.hpp"
#include "microslip/workflow/reduce/decay_text.hpp"
#include "microslip/workflow/reduce/point_sensors.hpp"
#include "microslip/workflow/reduce/sensor_shapes.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

/// Of the motion of the joints in a mode, that in all others, above which these count.
constexpr double kMostOthers = 0.1;
/// Of the displacement at the sensor that a mode moves most: sensors below do not tell of it.
constexpr double kLeastMoved = 0.1;
/// Sensors that a mode is followed at: with more the damping is hardly known better.
constexpr std::size_t kMostSensors = 3;

/// A mode of a model, as a decay sees it.
struct SoughtMode {
  std::size_t number = 1;                  ///< from 1
  double frequency = 0.0;                  ///< with stuck joints, Hz
  std::vector<std::string> channels = {};  ///< of those sensors that it moves, the best first
  std::vector<ShapeCourse> shapes = {};    ///< at these sensors
  ShapeCourse response_shape = {};         ///< at the response point
  double to_response = 1.0;       ///< displacement at the response point over the first sensor
  bool response_measured = true;  ///< the first sensor is at the response point
  double joint_motion =
      0.0;  ///< √Σ k u² of the joints over the first sensor's displacement, √(N/m)
};

/// One that was followed, with what the table says of it.
struct FollowedMode {
  SoughtMode sought;
  ModalDecay result;
};

/// @param courses  of the mode's shape at the sensors, then at the response point.
SoughtMode sought_mode(const ModelFile& model, const std::vector<PointSensor>& sensors,
                       std::size_t mode, const std::vector<ShapeCourse>& courses) {
  const ModalModel& linear = model.structure.linear();
  const std::vector<double> shape = model.structure.stuck_mode(mode);
  struct Seen {
    double moved;
    bool at_response;
    std::string channel;
    ShapeCourse course;
  };
  std::vector<Seen> seen;
  double most = 0.0;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const PointSensor& sensor = sensors[i];
    const double moved = motion_at(shape, linear.shape(sensor.point));
    // A point of another name may be the same place.
    const bool at_response =
        std::ranges::equal(linear.shape(sensor.point), linear.shape(model.response));
    seen.push_back({moved, at_response, sensor.channel, courses[i]});
    most = std::max(most, moved);
  }
  std::erase_if(seen, [&](const Seen& sensor) { return !(sensor.moved > kLeastMoved * most); });
  std::ranges::stable_sort(seen, [](const Seen& a, const Seen& b) {
    return std::pair(a.at_response, a.moved) > std::pair(b.at_response, b.moved);
  });
  SoughtMode sought{
      .number = mode + 1,
      .frequency = model.structure.stuck_frequencies()[mode] / (2.0 * std::numbers::pi)};
  if (seen.empty()) return sought;
  for (const Seen& sensor : seen) {
    sought.channels.push_back(sensor.channel);
    sought.shapes.push_back(sensor.course);
  }
  sought.response_shape = courses.back();
  sought.response_measured = seen.front().at_response;
  if (!sought.response_measured) {
    sought.to_response = motion_at(shape, linear.shape(model.response)) / seen.front().moved;
  }
  double square = 0.0;
  for (const StructuralJoint& joint : model.structure.joints()) {
    const double u = motion_at(shape, joint.shape);
    square += joint.stuck_stiffness() * u * u;
  }
  sought.joint_motion = std::sqrt(square) / seen.front().moved;
  return sought;
}

/// By the frequency at its smallest amplitude, where the joints stick most.
bool is_nearest(const RingDown& decay, const std::vector<SoughtMode>& all, std::size_t number) {
  const double frequency = decay.frequency.back();
  const auto nearest = std::ranges::min_element(all, {}, [&](const SoughtMode& mode) {
    return std::abs(std::log(mode.frequency / frequency));
  });
  return nearest->number == number;
}

/// The displacement at the response point over that at the first sensor changes with the shape.
void move_shape(const SoughtMode& sought, RingDownLevels& levels) {
  for (std::size_t i = 0; i < levels.amplitude.size(); ++i) {
    const double omega = 2.0 * std::numbers::pi * levels.frequency[i];
    const double ratio = std::exp(sought.response_shape.log_motion_at(omega) -
                                  sought.shapes.front().log_motion_at(omega));
    levels.amplitude[i] *= ratio;
    levels.amplitude_std[i] *= ratio;
  }
}

ModalDecay follow_mode(const Recording& recording, const SoughtMode& sought,
                       const RingDownOptions& given, const std::vector<SoughtMode>& all) {
  if (sought.channels.empty() || !(sought.to_response > 0.0)) {
    throw InputError(fmt::format("mode {}", sought.number), "no motion at the sensors",
                     "must move a sensor and the response point");
  }
  RingDownOptions options = given;
  options.frequency = sought.frequency;
  options.shapes = sought.shapes;
  ModalDecay result{sought.number, ring_down(recording, sought.channels, options), {}};
  if (!is_nearest(result.decay, all, sought.number)) {
    throw InputError(fmt::format("{}: mode {}", recording.source, sought.number),
                     fmt::format("{:.6g} Hz", result.decay.frequency.back()),
                     fmt::format("must be nearer to {:.6g} Hz than to another mode of the model",
                                 sought.frequency));
  }
  result.levels = damping_levels_of(result.decay, sought.to_response);
  move_shape(sought, result.levels);
  return result;
}

// ---- Modes that ring at once. ----

/// √Σ k u² of the joints in a mode at a time: between its windows, and on as it fell at the last.
double joint_motion_at(const FollowedMode& mode, double time) {
  const RingDown& decay = mode.result.decay;
  const double scale = mode.sought.joint_motion;
  if (time <= decay.time.front()) return scale * decay.amplitude.front();
  const auto after = std::ranges::upper_bound(decay.time, time);
  if (after == decay.time.end()) {
    const double rate =
        decay.damping_ratio.back() * 2.0 * std::numbers::pi * decay.frequency.back();
    return scale * decay.amplitude.back() * std::exp(-rate * (time - decay.time.back()));
  }
  const auto i = static_cast<std::size_t>(after - decay.time.begin());
  const double share = (time - decay.time[i - 1]) / (decay.time[i] - decay.time[i - 1]);
  return scale * std::pow(decay.amplitude[i - 1], 1.0 - share) *
         std::pow(decay.amplitude[i], share);
}

/// Flags the levels of a mode during which the others move the joints.
void flag_modulation(FollowedMode& mode, const std::vector<FollowedMode>& all,
                     std::vector<Warning>& warnings) {
  std::size_t count = 0;
  double most = 0.0;
  RingDownLevels& levels = mode.result.levels;
  for (std::size_t i = 0; i < levels.time.size(); ++i) {
    double others = 0.0;
    for (const FollowedMode& other : all) {
      if (other.sought.number == mode.sought.number) continue;
      others = std::hypot(others, joint_motion_at(other, levels.time[i]));
    }
    const double share = others / joint_motion_at(mode, levels.time[i]);
    if (!(share > kMostOthers)) continue;
    ++count;
    most = std::max(most, share);
    add_code(levels.flags[i], kModesModulate);
  }
  if (count == 0) return;
  warnings.push_back({std::string(kModesModulate),
                      fmt::format("mode {}: at {} of {} levels other modes move the joints by up "
                                  "to {:.2g} of its own motion: the damping is that of both "
                                  "together. Use the other levels, or excite the mode alone.",
                                  mode.sought.number, count, levels.time.size(), most)});
}

void flag_shape(FollowedMode& mode, std::vector<Warning>& warnings) {
  if (mode.sought.response_measured) return;
  for (std::string& flags : mode.result.levels.flags) add_code(flags, kShapeAssumed);
  warnings.push_back(
      {std::string(kShapeAssumed),
       fmt::format(
           "mode {}: no sensor that it moves is at the response point: its displacement there is "
           "taken as {:.4g} times that at '{}' with stuck joints, and as the model's shape moves "
           "while they slip.",
           mode.sought.number, mode.sought.to_response, mode.sought.channels.front())});
}

void add_decay_warnings(const FollowedMode& mode, bool several, std::vector<Warning>& warnings) {
  for (const auto* list : {&mode.result.decay.warnings, &mode.result.levels.warnings}) {
    for (const Warning& warning : *list) {
      const std::string which = several ? fmt::format("mode {}: ", mode.sought.number) : "";
      warnings.push_back({warning.code, which + warning.text});
    }
  }
}

// ---- By a model. ----

/// The recording that has the channel of the first sensor.
const Recording& recording_with(const Recordings& file, const std::vector<PointSensor>& sensors,
                                const std::string& path) {
  return *choose_signals(file.recordings, {sensors.front().channel}, path).recording;
}

void check_modes(const std::vector<std::size_t>& modes, std::size_t count) {
  for (const std::size_t mode : modes) {
    if (mode >= 1 && mode <= count) continue;
    throw InputError("mode", static_cast<double>(mode),
                     fmt::format("must be from 1 to {}, the modes of the model", count));
  }
}

bool is_asked_for(const ModalDecayReduction& options, std::size_t mode) {
  return options.modes.empty() || std::ranges::count(options.modes, mode) > 0;
}

/// All modes that can be followed; those that were asked for by number must. The others only tell
/// whether they modulate these: one sensor is enough.
std::vector<FollowedMode> follow_modes(const ModalDecayReduction& options,
                                       const Recording& recording,
                                       const std::vector<SoughtMode>& sought) {
  std::vector<std::optional<FollowedMode>> found(sought.size());
  std::vector<std::exception_ptr> faults(sought.size());
  const auto follow = [&](std::size_t i) {
    SoughtMode mode = sought[i];
    if (!is_asked_for(options, mode.number) && mode.channels.size() > 1) {
      mode.channels.resize(1);
      mode.shapes.resize(1);
    }
    try {
      found[i] = FollowedMode{mode, follow_mode(recording, mode, options.analysis, sought)};
    } catch (const InputError&) {
      faults[i] = std::current_exception();
    }
  };
  Execution::threads().for_each(sought.size(), follow, options.progress);
  std::vector<FollowedMode> followed;
  for (std::size_t i = 0; i < sought.size(); ++i) {
    const bool must = std::ranges::count(options.modes, sought[i].number) > 0;
    if (found[i]) followed.push_back(std::move(*found[i]));
    if (faults[i] && must) std::rethrow_exception(faults[i]);
  }
  if (followed.empty()) std::rethrow_exception(faults.front());
  return followed;
}

ReducedModalDecay reduce_by_model(const ModalDecayReduction& options, const ModelFile& model,
                                  const Recordings& file) {
  const std::vector<PointSensor> sensors = point_sensors(options.sensors, model, options.model);
  const Recording& recording = recording_with(file, sensors, options.recording);
  for (const PointSensor& sensor : sensors) (void)recording.channel(sensor.channel);
  const std::size_t count = model.structure.linear().vibrations();
  check_modes(options.modes, count);
  std::vector<std::span<const double>> points;
  for (const PointSensor& sensor : sensors) {
    points.push_back(model.structure.linear().shape(sensor.point));
  }
  points.push_back(model.structure.linear().shape(model.response));
  const auto courses = shape_courses(model.structure, points);
  std::vector<SoughtMode> sought;
  for (std::size_t mode = 0; mode < count; ++mode) {
    sought.push_back(sought_mode(model, sensors, mode, courses[mode]));
  }
  std::vector<FollowedMode> followed = follow_modes(options, recording, sought);
  ReducedModalDecay reduced{recording.source, {}, file.warnings};
  for (FollowedMode& mode : followed) {
    if (!is_asked_for(options, mode.sought.number)) continue;
    flag_modulation(mode, followed, reduced.warnings);
    flag_shape(mode, reduced.warnings);
    add_decay_warnings(mode, true, reduced.warnings);
    reduced.modes.push_back(mode.result);
  }
  return reduced;
}

ReducedModalDecay reduce_by_number(const ModalDecayReduction& options, const Recordings& file) {
  if (options.modes.size() != 1) {
    throw InputError("mode", fmt::format("{} modes", options.modes.size()),
                     "must be one without a model", "Give a `model` for several.");
  }
  const DecaySignal signal = choose_signals(file.recordings, options.channels, options.recording);
  RingDown decay = ring_down(*signal.recording, signal.channels, options.analysis);
  RingDownLevels levels = damping_levels_of(decay);
  FollowedMode mode{{.number = options.modes.front()},
                    {options.modes.front(), std::move(decay), std::move(levels)}};
  ReducedModalDecay reduced{signal.recording->source, {}, file.warnings};
  add_decay_warnings(mode, false, reduced.warnings);
  reduced.modes.push_back(std::move(mode.result));
  return reduced;
}

// ---- Texts. ----

template <typename Value>
std::vector<double> joined(const std::vector<ModalDecay>& modes, Value value) {
  std::vector<double> all;
  for (const ModalDecay& mode : modes) {
    const std::vector<double>& values = mode.levels.*value;
    all.insert(all.end(), values.begin(), values.end());
  }
  return all;
}

std::string modal_decay_comment(const ReducedModalDecay& reduced, std::string_view command) {
  std::string text = heading_of(command);
  for (const ModalDecay& mode : reduced.modes) {
    text += fmt::format("\nmode {}: sensors: {}", mode.mode, decay_sensors_text(mode.decay));
    text += fmt::format("\nmode {}: free decay from: {}", mode.mode, decay_start_text(mode.decay));
    text += fmt::format("\nmode {}: ended: {}", mode.mode, mode.decay.summary.reason);
  }
  return with_warnings(std::move(text), reduced.warnings);
}

}  // namespace

bool ReducedModalDecay::converged() const {
  return std::ranges::all_of(modes,
                             [](const ModalDecay& mode) { return mode.decay.summary.converged(); });
}

ReducedModalDecay reduce_modal_decay(const ModalDecayReduction& options) {
  if (!options.model.empty()) {
    return reduce_modal_decay(options, read_model(options.model, JointsToFind::kAllowed));
  }
  return reduce_by_number(options, read_recordings(options.recording, options.reading));
}

ReducedModalDecay reduce_modal_decay(const ModalDecayReduction& options, const ModelFile& model) {
  return reduce_modal_decay(options, model, read_recordings(options.recording, options.reading));
}

ReducedModalDecay reduce_modal_decay(const ModalDecayReduction& options, const ModelFile& model,
                                     const Recordings& file) {
  return reduce_by_model(options, model, file);
}

std::string modal_levels_text(const ReducedModalDecay& reduced, std::string_view command) {
  std::vector<double> numbers;
  std::vector<std::string> flags;
  for (const ModalDecay& mode : reduced.modes) {
    const std::string all = codes_of_decay(mode.decay.warnings);
    for (std::string own : mode.levels.flags) {
      add_code(own, all);
      flags.push_back(std::move(own));
      numbers.push_back(static_cast<double>(mode.mode));
    }
  }
  CsvWriter table;
  const auto add = [&](std::string_view name, const Dimension& dimension, auto value) {
    table.add_numbers(name, dimension, joined(reduced.modes, value));
  };
  table.add_numbers("mode", kDimensionless, numbers);
  add("displacement", kLength, &RingDownLevels::amplitude);
  add("frequency", kFrequency, &RingDownLevels::frequency);
  add("damping_ratio", kDimensionless, &RingDownLevels::damping_ratio);
  add("displacement_std", kLength, &RingDownLevels::amplitude_std);
  add("frequency_std", kFrequency, &RingDownLevels::frequency_std);
  add("damping_ratio_std", kDimensionless, &RingDownLevels::damping_ratio_std);
  add("decay_time", kTime, &RingDownLevels::time);
  table.add_text("source", std::vector<std::string>(numbers.size(), reduced.source));
  table.add_text("flags", flags);
  table.add_comment(modal_decay_comment(reduced, command));
  return table.str();
}

std::string describe_modal_decay(const ReducedModalDecay& reduced) {
  std::string text = "Ring-down to modal levels\n";
  text += line("recording", reduced.source);
  for (const ModalDecay& mode : reduced.modes) {
    const RingDownLevels& levels = mode.levels;
    const auto span = [](const std::vector<double>& values) {
      return fmt::format("{:.4g} to {:.4g}", values.front(), values.back());
    };
    text += line(fmt::format("mode {}", mode.mode), decay_sensors_text(mode.decay));
    text += line("  free decay from", decay_start_text(mode.decay));
    text +=
        line("  levels", fmt::format("{}, {}", levels.amplitude.size(), mode.decay.summary.reason));
    text += line("  displacement", span(levels.amplitude) + " m");
    text += line("  frequency", fmt::format("{:.6g} to {:.6g} Hz", levels.frequency.front(),
                                            levels.frequency.back()));
    text += line("  damping ratio", span(levels.damping_ratio));
  }
  return text + describe_warnings(reduced.warnings);
}

}  // namespace microslip
