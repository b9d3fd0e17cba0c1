// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/loggers/logger_recording.hpp"
#include "microslip/io/loggers/tdms_axes.hpp"
#include "microslip/io/loggers/tdms_contents.hpp"
#include "microslip/io/loggers/tdms_scaling.hpp"
#include "microslip/io/recordings/sampling.hpp"

namespace microslip {
namespace {

constexpr std::string_view kLeftOut = "channel_left_out";

template <class Names>
const double* number_of(const TdmsProperties& properties, const Names& names) {
  for (const char* name : names) {
    if (const double* found = properties.number(name)) return found;
  }
  return nullptr;
}

std::string unit_of(const TdmsProperties& properties) {
  constexpr std::array kNames{"unit_string", "NI_UnitDescription", "unit", "units", "Unit"};
  for (const char* name : kNames) {
    const std::string* text = properties.text(name);
    if (text != nullptr && !text->empty()) return *text;
  }
  return {};
}

/// What a file states beside what is read of it here.
Attributes attributes_of(const TdmsProperties& properties) {
  Attributes attributes;
  for (const auto& [name, value] : properties.all) {
    const bool is_known = name.starts_with("NI_") || name.starts_with("wf_") ||
                          name == "unit_string" || name == "name" || name.empty();
    const std::string* const text = std::get_if<std::string>(&value);
    if (!is_known && text != nullptr && !text->empty()) attributes.emplace_back(name, *text);
  }
  return attributes;
}

/// Names that a warning shows.
constexpr std::size_t kMostNames = 5;

const TdmsProperties kNoProperties;

struct TdmsGroup {
  std::string name;
  const TdmsProperties* properties = &kNoProperties;
  std::vector<TdmsObject*> channels = {};
};

/// What the channels of a group have in common.
struct GroupAxes {
  const TdmsProperties* outer;
  const TdmsProperties* outermost;
  std::optional<double> rate = {};  ///< that the user states, Hz
  std::optional<PointsAxis> points = {};
  std::string name_of_points = {};
  std::optional<PointsAxis> compared = {};  ///< times of a channel that has an increment as well
  std::string name_of_compared = {};
  std::optional<TdmsTime> earliest = {};
  bool has_warned = false;  ///< of a rate that contradicts the points
};

/// By an interval or a rate of the channel, its group or the file; nothing where there is none.
std::optional<double> stated_step(const TdmsProperties& own, const GroupAxes& axes,
                                  const std::string& place) {
  for (const TdmsProperties* properties : {&own, axes.outer, axes.outermost}) {
    const double* const step = number_of(*properties, kStepNames);
    if (step != nullptr && *step > 0.0) return *step;
    const double* const rate = number_of(*properties, kRateNames);
    if (rate != nullptr) return step_of_rate(*rate, place);
  }
  return std::nullopt;
}

class TdmsGroups {
 public:
  TdmsGroups(const std::string& path, TdmsContents contents)
      : path_(path), contents_(std::move(contents)) {}

  Recordings read(const RecordingReadOptions& options) {
    for (const TdmsGroup& group : groups()) read_group(group, options);
    if (result_.recordings.empty()) fail_without_recording();
    check_foreign(result_, path_);
    warn_without_rate(without_axis_, result_.warnings);
    if (contents_.truncated) {
      result_.warnings.push_back({"file_truncated", path_ + ": ends within a segment, of which "
                                                            "the last values are left out"});
    }
    if (contents_.part_chunks > 0) {
      result_.warnings.push_back(
          {"file_truncated",
           fmt::format("{}: {} bytes of values that are no whole chunk are left out", path_,
                       contents_.part_chunks)});
    }
    return std::move(result_);
  }

 private:
  /// Those with channels, in the order of the file.
  std::vector<TdmsGroup> groups() {
    std::vector<TdmsGroup> groups;
    std::map<std::string, std::size_t, std::less<>> places;
    for (TdmsObject& object : contents_.objects) {
      if (object.kind == TdmsObject::Kind::kFile) {
        outermost_ = &object.properties;
        continue;
      }
      const auto [place, is_new] = places.try_emplace(object.group, groups.size());
      if (is_new) groups.push_back({.name = object.group});
      TdmsGroup& group = groups[place->second];
      if (object.kind == TdmsObject::Kind::kChannel) {
        group.channels.push_back(&object);
      } else {
        group.properties = &object.properties;
      }
    }
    return groups;
  }

  [[nodiscard]] std::string place_of(const TdmsObject& object) const {
    return fmt::format("{}: {}", path_, in_quotes(object.group + "/" + object.channel, 80));
  }

  void read_group(const TdmsGroup& group, const RecordingReadOptions& options) {
    GroupAxes axes{.outer = group.properties, .outermost = outermost_, .rate = options.rate};
    std::vector<LoggedChannel> read;
    for (TdmsObject* const object : group.channels) read_channel(*object, axes, read);
    std::vector<LoggedChannel> channels;
    for (LoggedChannel& logged : read) {
      name(logged);
      WaveformAxis own = waveform_axis(logged.object->properties, axes.earliest);
      if (!own.fault.empty()) {
        warn_left_out(*logged.object, own.fault, "state wf_xunit_string in s or Hz");
        continue;
      }
      const bool has_own = own.axis.has_value();
      if (has_own) take_former_steps(*own.axis, logged);
      logged.axis = has_own ? std::move(own.axis) : axis_of_group(logged, axes);
      if (has_own) warn_beside_points(logged, axes);
      channels.push_back(std::move(logged));
    }
    warn_without_start(channels, axes);
    add_channels(group, channels, options);
  }

  void read_channel(TdmsObject& object, GroupAxes& axes, std::vector<LoggedChannel>& channels) {
    if (!axes.points && !object.times.empty()) {
      axes.points = points_of_times(object);
      axes.name_of_points = object.channel;
    }
    ScaledValues scaled = scaled_values(object, {&object.properties, axes.outer, axes.outermost});
    if (!scaled.fault.empty() || !object.other.empty()) {
      warn_left_out(object, scaled.fault.empty() ? object.other : scaled.fault,
                    "let LabVIEW or DIAdem save it as numbers in its unit");
    } else if (!axes.points && is_points(object, scaled.values) && !has_increment(object)) {
      PointsInFile points = points_in_file(object, std::move(scaled.values));
      points.rate = axes.rate;
      axes.points = axis_of_points(std::move(points), {}, result_.warnings);
      result_.rate_used = result_.rate_used || axes.points->rate_used;
      axes.name_of_points = object.channel;
    } else if (scaled.values.size() > 1) {
      if (!axes.compared) note_times(object, scaled.values, axes);
      channels.push_back({&object, {}});
      channels.back().channel.values = std::move(scaled.values);
      const TdmsTime* const start = object.properties.time("wf_start_time");
      if (start != nullptr && (!axes.earliest || seconds_between(*start, *axes.earliest) > 0.0)) {
        axes.earliest = *start;
      }
      warn_of_change(object);
    }
  }

  void warn_of_change(const TdmsObject& object) {
    if (object.change.empty()) return;
    result_.warnings.push_back(
        {"properties_change",
         fmt::format("{}: a later segment states another {}; the values of all segments are joined "
                     "without gap, as one channel of the {}unit and scale that were stated last. "
                     "Have each part written to a group of its own",
                     place_of(object), object.change,
                     object.former_steps.empty() ? "step, " : "")});
  }

  /// Values of segments with other increments are over uneven points.
  void take_former_steps(Axis& axis, const LoggedChannel& logged) {
    const TdmsObject& object = *logged.object;
    if (object.former_steps.empty()) return;
    const std::vector<TdmsSteps> steps = steps_of(object, logged.channel.values.size());
    axis = axis_of_steps(axis, object, steps);
    if (steps.size() < 2) return;
    result_.warnings.push_back(
        {"step_changes",
         fmt::format("{}: a later segment states another wf_increment ({}, then {}); the values of "
                     "all segments are joined without gap, over times in uneven steps. Have each "
                     "part written to a group of its own",
                     place_of(object), steps[0].increment, steps[1].increment)});
  }

  /// Beside channels that state when they begin, one that does not may begin at any time.
  void warn_without_start(const std::vector<LoggedChannel>& channels, const GroupAxes& axes) {
    if (!axes.earliest) return;
    std::vector<std::string> names;
    for (const LoggedChannel& logged : channels) {
      const bool is_over_time = logged.axis && logged.axis->dimension == kTime;
      if (is_over_time && logged.object->properties.time("wf_start_time") == nullptr) {
        names.push_back(logged.channel.name);
      }
    }
    if (names.empty()) return;
    result_.warnings.push_back(
        {"start_time_missing",
         fmt::format("{}: {} without wf_start_time beside channels that state one; taken to begin "
                     "with the earliest of them. State it for all channels",
                     path_, list_of_names(names, kMostNames))});
  }

  void name(LoggedChannel& logged) {
    const TdmsProperties& properties = logged.object->properties;
    logged.channel.name = logged.object->channel;
    logged.channel.attributes = attributes_of(properties);
    apply_unit(logged.channel, unit_of(properties), path_, result_.warnings);
  }

  void warn_left_out(const TdmsObject& object, const std::string& reason, std::string_view remedy) {
    result_.warnings.push_back(
        {std::string(kLeftOut),
         fmt::format("{}: left out, it has {}; {}", place_of(object), reason, remedy)});
  }

  static bool is_points(const TdmsObject& object, const std::vector<double>& values) {
    return is_one_of(object.channel, kTimeNames) && values.size() > 1 &&
           may_be_unit_of_points(unit_of(object.properties), kTime) &&
           may_be_points(object.channel, values);
  }

  static bool has_increment(const TdmsObject& object) {
    return states_step(object.properties.number("wf_increment"));
  }

  /// Integers that no scale has changed keep all their digits.
  PointsInFile points_in_file(const TdmsObject& object, std::vector<double> values) {
    PointsInFile points{std::move(values), unit_of(object.properties), kTime, place_of(object)};
    const std::vector<std::int64_t>& bits = object.whole.bits;
    const bool as_stored = bits.size() == points.points.size() &&
                           static_cast<double>(bits.front()) == points.points.front() &&
                           static_cast<double>(bits.back()) == points.points.back();
    if (!as_stored) return points;
    WholeTimes times = whole_times(object.whole, points.unit, points.place);
    if (times.warning) result_.warnings.push_back(*std::move(times.warning));
    points.points = std::move(times.values);
    points.unit = std::move(times.unit);
    return points;
  }

  /// Where values are times; those in an unknown unit are compared with nothing.
  void note_times(const TdmsObject& object, const std::vector<double>& values, GroupAxes& axes) {
    const std::string unit = unit_of(object.properties);
    if (!is_points(object, values) || (!unit.empty() && !find_unit_of_points(unit))) return;
    std::vector<Warning> unused;  // as the values stay a channel
    axes.compared = axis_of_points({values, unit, kTime, place_of(object)}, {}, unused);
    axes.name_of_compared = object.channel;
  }

  PointsAxis points_of_times(const TdmsObject& object) {
    std::vector<double> points;
    points.reserve(object.times.size());
    for (const TdmsTime& time : object.times) {
      points.push_back(seconds_between(object.times.front(), time));
    }
    return axis_of_points({std::move(points), "s", kTime, place_of(object)}, {}, result_.warnings);
  }

  /// The axis of a channel that states no increment.
  std::optional<Axis> axis_of_group(const LoggedChannel& logged, GroupAxes& axes) {
    const std::string place = place_of(*logged.object);
    const std::optional<double> step = stated_step(logged.object->properties, axes, place);
    if (!axes.points || axes.points->points != logged.channel.values.size()) {
      return step ? std::optional(even_axis({.step = *step})) : std::nullopt;
    }
    const auto warning = contradicting_rate(*axes.points, step, axes.name_of_points, place);
    if (warning && !axes.has_warned) result_.warnings.push_back(*warning);
    axes.has_warned = axes.has_warned || warning;
    return axes.points->axis;
  }

  /// Where the increment of a channel contradicts times that the group has as well.
  void warn_beside_points(const LoggedChannel& logged, GroupAxes& axes) {
    constexpr double kSame = 0.01;  // as contradicting_rate()
    const std::optional<PointsAxis>& times = axes.points ? axes.points : axes.compared;
    if (axes.has_warned || !times || times->points != logged.channel.values.size()) return;
    const Axis& points = times->axis;
    const Axis& own = *logged.axis;
    const bool agrees = points.even() && std::abs(points.step - own.step) <= kSame * own.step;
    if (points.dimension != own.dimension || agrees) return;
    axes.has_warned = true;
    result_.warnings.push_back(
        {"rate_contradicts",
         fmt::format(
             "{}: wf_increment gives steps of {:.6g} s, and the times of {} are others; the "
             "increment is used. Take out what is wrong",
             place_of(*logged.object), own.step,
             in_quotes(axes.points ? axes.name_of_points : axes.name_of_compared))});
  }

  void align(const TdmsGroup& group, std::vector<LoggedChannel>& channels) {
    const Alignment alignment = align_channels(channels);
    if (alignment.is_cut) {
      result_.warnings.push_back(
          {"channels_cut", fmt::format("{}: the channels of {} do not begin and end together; "
                                       "they are cut to the time that all have",
                                       path_, in_quotes(group.name, 80))});
    }
    for (const ApartChannels& apart : alignment.apart) {
      result_.warnings.push_back(
          {"channels_apart",
           fmt::format("{}: {} of {} in a recording apart: {}; a call that needs channels together "
                       "takes them from one recording, so have them recorded alike",
                       path_, list_of_names(apart.names, kMostNames), in_quotes(group.name, 80),
                       apart.reason)});
    }
  }

  void add_channels(const TdmsGroup& group, std::vector<LoggedChannel>& channels,
                    const RecordingReadOptions& options) {
    align(group, channels);
    const bool untimed =
        options.allow_untimed && std::ranges::none_of(channels, [](const LoggedChannel& logged) {
          return logged.axis.has_value();
        });
    if (untimed && !channels.empty()) note_untimed(options, path_, result_);
    std::vector<Recording> recordings;
    for (LoggedChannel& logged : channels) {
      if (untimed) logged.axis = even_axis({.step = untimed_step(options)});
      if (!logged.axis) {
        const double* const increment = logged.object->properties.number("wf_increment");
        without_axis_.push_back(
            {place_of(*logged.object),
             increment == nullptr ? "" : fmt::format("a wf_increment of {}", *increment)});
        continue;
      }
      add_channel(recordings, file_name(path_) + ":" + group.name, *logged.axis,
                  std::move(logged.channel), logged.object->channel);
    }
    for (Recording& recording : recordings) {
      recording.attributes = attributes_of(*group.properties);
      result_.recordings.push_back(std::move(recording));
    }
  }

  [[noreturn]] void fail_without_recording() const {
    if (!without_axis_.empty()) {
      throw no_sampling_rate(
          without_axis_.front(),
          without_axis_.front().found.empty()
              ? "Write waveforms, which have wf_increment, or a channel Time [s]."
              : "Write waveforms whose wf_increment is their step, or give `rate`.");
    }
    const std::string found = result_.warnings.empty() ? "none" : result_.warnings.front().text;
    throw FormatError({.file = path_}, "a channel of two numbers or more", found);
  }

  const std::string& path_;
  TdmsContents contents_;
  const TdmsProperties* outermost_ = &kNoProperties;
  Recordings result_;
  std::vector<WithoutAxis> without_axis_;
};

}  // namespace

Recordings read_recordings_tdms(const std::string& path, const RecordingReadOptions& options) {
  return TdmsGroups(path, read_tdms(path, options.allow_truncated, options.progress)).read(options);
}

}  // namespace microslip
