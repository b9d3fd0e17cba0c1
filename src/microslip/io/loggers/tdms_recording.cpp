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
#include "microslip/io/loggers/tdms_contents.hpp"
#include "microslip/io/loggers/tdms_scaling.hpp"
#include "microslip/io/recordings/sampling.hpp"

namespace microslip {
namespace {

/// Starts of channels are whole steps apart where they are by this part of a step.
constexpr double kWholeSteps = 1e-3;

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

/// A channel with its values in its unit.
struct LoggedChannel {
  const TdmsObject* object;
  Channel channel;
  std::optional<Axis> axis = {};  ///< of its own
};

/// Cuts channels of the same step that begin whole steps apart to what they have in common.
/// @return  whether any was cut.
bool align(std::vector<LoggedChannel>& channels) {
  double start = -std::numeric_limits<double>::infinity();
  double end = std::numeric_limits<double>::infinity();
  const Axis* first = nullptr;
  for (const LoggedChannel& logged : channels) {
    if (!logged.axis) return false;
    const Axis& axis = *logged.axis;
    if (first == nullptr) first = &axis;
    const double apart = (axis.start - first->start) / axis.step;
    if (axis.step != first->step || axis.dimension != first->dimension ||
        !(std::abs(apart - std::round(apart)) < kWholeSteps)) {
      return false;
    }
    start = std::max(start, axis.start);
    end = std::min(end, axis.at(logged.channel.values.size()));
  }
  if (first == nullptr) return false;
  const double step = first->step;
  const double count = std::round((end - start) / step);
  if (!(count >= 2.0)) return false;
  bool is_cut = false;
  for (LoggedChannel& logged : channels) {
    const double before = std::round((start - logged.axis->start) / step);
    std::vector<double>& values = logged.channel.values;
    if (before == 0.0 && static_cast<double>(values.size()) == count) continue;
    is_cut = true;
    values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(before));
    values.resize(static_cast<std::size_t>(count));
  }
  for (LoggedChannel& logged : channels) logged.axis->start = start;
  return is_cut;
}

class TdmsGroups {
 public:
  TdmsGroups(const std::string& path, TdmsContents contents)
      : path_(path), contents_(std::move(contents)) {}

  Recordings read(bool allow_untimed) {
    std::vector<std::string> groups;
    for (const TdmsObject& object : contents_.objects) {
      if (object.channel.empty()) continue;
      if (std::ranges::find(groups, object.group) == groups.end()) groups.push_back(object.group);
    }
    for (const std::string& group : groups) read_group(group, allow_untimed);
    if (result_.recordings.empty()) fail_without_recording();
    warn_without_rate(without_axis_, result_.warnings);
    if (contents_.truncated) {
      result_.warnings.push_back({"file_truncated", path_ + ": ends within a segment, of which "
                                                            "the last values are left out"});
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] const TdmsProperties& properties_of(const std::string& group) const {
    static const TdmsProperties kNone;
    const auto found = std::ranges::find_if(contents_.objects, [&](const TdmsObject& object) {
      return object.channel.empty() && object.group == group;
    });
    return found == contents_.objects.end() ? kNone : found->properties;
  }

  [[nodiscard]] std::string place_of(const TdmsObject& object) const {
    return fmt::format("{}: {}", path_, in_quotes(object.group + "/" + object.channel, 80));
  }

  void read_group(const std::string& group, bool allow_untimed) {
    const TdmsProperties& outer = properties_of(group);
    const TdmsProperties& outermost = properties_of("");
    std::vector<LoggedChannel> channels;
    std::optional<PointsAxis> points;
    std::optional<TdmsTime> earliest;
    for (TdmsObject& object : contents_.objects) {
      if (object.group != group || object.channel.empty()) continue;
      if (!points && !object.times.empty()) points = points_of_times(object);
      ScaledValues scaled = scaled_values(object, {&object.properties, &outer, &outermost});
      if (!scaled.fault.empty() || !object.other.empty()) {
        warn_left_out(object, scaled.fault.empty() ? object.other : scaled.fault);
      } else if (!points && is_points(object, scaled.values)) {
        points = axis_of_points(
            {std::move(scaled.values), unit_of(object.properties), kTime, place_of(object)}, {});
      } else if (scaled.values.size() > 1) {
        channels.push_back({&object, {}});
        channels.back().channel.values = std::move(scaled.values);
        const TdmsTime* const start = object.properties.time("wf_start_time");
        if (start != nullptr && (!earliest || seconds_between(*start, *earliest) > 0.0)) {
          earliest = *start;
        }
      }
    }
    for (LoggedChannel& logged : channels) name(logged);
    for (LoggedChannel& logged : channels) {
      logged.axis = axis_of(logged, points, outer, outermost, earliest);
    }
    add_channels(group, outer, channels, allow_untimed);
  }

  void name(LoggedChannel& logged) {
    const TdmsProperties& properties = logged.object->properties;
    logged.channel.name = logged.object->channel;
    logged.channel.attributes = attributes_of(properties);
    apply_unit(logged.channel, unit_of(properties), path_, result_.warnings);
  }

  void warn_left_out(const TdmsObject& object, const std::string& reason) {
    result_.warnings.push_back(
        {std::string(kLeftOut),
         fmt::format(
             "{}: left out, it has {}; let LabVIEW or DIAdem save it as numbers in its unit",
             place_of(object), reason)});
  }

  static bool is_points(const TdmsObject& object, const std::vector<double>& values) {
    return is_one_of(object.channel, kTimeNames) && values.size() > 1 &&
           object.properties.number("wf_increment") == nullptr &&
           may_be_unit_of_points(unit_of(object.properties), kTime) &&
           may_be_points(object.channel, values);
  }

  PointsAxis points_of_times(const TdmsObject& object) const {
    std::vector<double> points;
    points.reserve(object.times.size());
    for (const TdmsTime& time : object.times) {
      points.push_back(seconds_between(object.times.front(), time));
    }
    return axis_of_points({std::move(points), "s", kTime, place_of(object)}, {});
  }

  /// The axis that a channel states by itself, else that of its group.
  std::optional<Axis> axis_of(const LoggedChannel& logged, const std::optional<PointsAxis>& points,
                              const TdmsProperties& outer, const TdmsProperties& outermost,
                              const std::optional<TdmsTime>& earliest) const {
    const TdmsProperties& own = logged.object->properties;
    const double* const increment = own.number("wf_increment");
    if (increment != nullptr && *increment > 0.0 && std::isfinite(*increment)) {
      Axis axis;
      axis.step = *increment;
      const double* const offset = own.number("wf_start_offset");
      if (offset != nullptr) axis.start = *offset;
      const TdmsTime* const start = own.time("wf_start_time");
      if (start != nullptr) axis.start += seconds_between(*earliest, *start);
      const std::string* const unit = own.text("wf_xunit_string");
      const std::optional<Unit> known = unit == nullptr ? std::nullopt : find_unit(*unit);
      if (known && known->dimension == kFrequency) axis.dimension = kFrequency;
      return axis;
    }
    if (points && points->points == logged.channel.values.size()) return points->axis;
    for (const TdmsProperties* properties : {&own, &outer, &outermost}) {
      const double* const step = number_of(*properties, kStepNames);
      if (step != nullptr && *step > 0.0) return even_axis({.step = *step});
      const double* const rate = number_of(*properties, kRateNames);
      if (rate != nullptr)
        return even_axis({.step = step_of_rate(*rate, place_of(*logged.object))});
    }
    return std::nullopt;
  }

  void add_channels(const std::string& group, const TdmsProperties& outer,
                    std::vector<LoggedChannel>& channels, bool allow_untimed) {
    if (align(channels)) {
      result_.warnings.push_back(
          {"channels_cut", fmt::format("{}: the channels of {} do not begin and end together; "
                                       "they are cut to the time that all have",
                                       path_, in_quotes(group, 80))});
    }
    const bool untimed =
        allow_untimed && std::ranges::none_of(channels, [](const LoggedChannel& logged) {
          return logged.axis.has_value();
        });
    if (untimed && !channels.empty()) result_.warnings.push_back(points_untimed(path_));
    std::vector<Recording> recordings;
    for (LoggedChannel& logged : channels) {
      if (untimed) logged.axis = even_axis({.step = 1.0});
      if (!logged.axis) {
        without_axis_.push_back({place_of(*logged.object)});
        continue;
      }
      add_channel(recordings, file_name(path_) + ":" + group, *logged.axis,
                  std::move(logged.channel), logged.object->channel);
    }
    for (Recording& recording : recordings) {
      recording.attributes = attributes_of(outer);
      check_foreign(recording, path_, result_.warnings);
      result_.recordings.push_back(std::move(recording));
    }
  }

  [[noreturn]] void fail_without_recording() const {
    if (!without_axis_.empty()) {
      throw no_sampling_rate(without_axis_.front(),
                             "Write waveforms, which have wf_increment, or a channel Time [s].");
    }
    const std::string found = result_.warnings.empty() ? "none" : result_.warnings.front().text;
    throw FormatError({.file = path_}, "a channel of two numbers or more", found);
  }

  const std::string& path_;
  TdmsContents contents_;
  Recordings result_;
  std::vector<WithoutAxis> without_axis_;
};

}  // namespace

Recordings read_recordings_tdms(const std::string& path, const RecordingReadOptions& options) {
  return TdmsGroups(path, read_tdms(path, options.allow_truncated, options.progress))
      .read(options.allow_untimed);
}

}  // namespace microslip
