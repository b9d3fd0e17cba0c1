// SPDX-License-Identifier: MIT
#include "microslip/io/recordings/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/recordings/doubtful_unit.hpp"
#include "microslip/io/recordings/unitless_times.hpp"

namespace microslip {
namespace {

constexpr double kEven = 1e-6;
constexpr std::string_view kUntimed = "points_untimed";
constexpr std::string_view kRateOption = "`rate`";
constexpr double kEvenAsStated = 0.01;

/// @param off  by which points may be.
bool lies_evenly(const std::vector<double>& points, double step, double off) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double expected = points.front() + static_cast<double>(i) * step;
    if (!(std::abs(points[i] - expected) <= off)) return false;
  }
  return true;
}

/// False where one is no number.
bool rise(const std::vector<double>& points) {
  const auto fault = std::ranges::adjacent_find(points, std::not_fn(std::less<>()));
  return points.size() > 1 && fault == points.end();
}

void scale(std::vector<double>& values, const Unit& unit) {
  if (unit.numerator == 1.0 && unit.denominator == 1.0) return;
  for (double& value : values) value = unit.to_si(value);
}

bool are_singles(const std::vector<double>& points) {
  return std::ranges::all_of(points, [](double v) {
    const bool in_range = std::abs(v) <= static_cast<double>(std::numeric_limits<float>::max());
    return in_range && static_cast<double>(static_cast<float>(v)) == v;
  });
}

bool has_whole_channel(const Recording& recording) {
  const auto are_finite = [](const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
  };
  return std::ranges::any_of(recording.channels, [&](const Channel& channel) {
    return are_finite(channel.values) && are_finite(channel.imaginary);
  });
}

/// Of its channels, in quotes.
std::string names_of(const Recording& recording) {
  std::string names;
  for (const Channel& channel : recording.channels) {
    names += (names.empty() ? "" : ", ") + in_quotes(channel.name);
  }
  return names;
}

/// Of numbers in any unit: whole ones up to this are exact as doubles, 2⁵³, and as singles, 2²⁴.
constexpr double kExactDoubles = 9007199254740992.0;
constexpr double kExactSingles = 16777216.0;
/// As if whole numbers had been printed: each is rounded to its unit at most.
constexpr PrintedDigits kWholeNumbers{.decimals = 0,
                                      .significant = std::numeric_limits<double>::max_digits10};

bool are_whole(const std::vector<double>& points, double largest) {
  return std::ranges::all_of(
      points, [&](double v) { return std::abs(v) <= largest && v == std::trunc(v); });
}

/// Whether numbers were rounded to whole ones, as stored integers are, and to nothing coarser.
bool are_rounded_to_whole(const std::vector<double>& points) {
  return are_whole(points, kExactSingles) ||
         (are_whole(points, kExactDoubles) && !are_singles(points));
}

/// The step of whole numbers that lie exactly evenly: nothing was rounded.
std::optional<double> whole_step(const std::vector<double>& points) {
  if (points.size() < 2 || !are_whole(points, kExactDoubles)) return std::nullopt;
  const double step = points[1] - points[0];
  const auto other = std::ranges::adjacent_find(
      points, [&](double before, double then) { return then - before != step; });
  return step > 0.0 && other == points.end() ? std::optional(step) : std::nullopt;
}

/// Times without a unit may tell it by their size; true where they count from 1970.
bool take_unit_by_size(PointsInFile& file, std::vector<Warning>& warnings) {
  const bool has_unit = !trimmed(file.unit).empty() || file.usual != kTime;
  if (has_unit || file.points.size() < 2) return false;
  if (const CountedUnit* const counted = counted_unit(file.points.front())) {
    file.unit = counted->unit;
    warnings.push_back(since_1970(*counted, file.place));
    return true;
  }
  if (!are_whole(file.points, kExactDoubles)) return false;
  auto doubt = doubtful_seconds(file.points[1] - file.points[0], file.place);
  if (doubt) warnings.push_back(*std::move(doubt));
  return false;
}

void begin_at_zero(std::vector<double>& points) {
  const double first = points.front();
  for (double& point : points) point -= first;
}

/// What of points is known before they are brought to SI.
struct StoredPoints {
  bool are_text;
  double rounding = 0.0;  ///< by which doubles may be off
  bool are_singles;
  std::optional<PrintedDigits> printed;  ///< also of whole numbers
  std::optional<double> exact_step;      ///< of whole numbers
};

StoredPoints stored_points(const PointsInFile& file) {
  constexpr double kRounding = 4.0 * std::numeric_limits<double>::epsilon();
  StoredPoints stored{.are_text = file.printed.has_value(),
                      .are_singles = file.points.size() > 1 && are_singles(file.points),
                      .printed = file.printed,
                      .exact_step = {}};
  if (stored.are_text || file.points.empty()) return stored;
  stored.rounding =
      kRounding * std::max(std::abs(file.points.front()), std::abs(file.points.back()));
  if (are_rounded_to_whole(file.points)) stored.printed = kWholeNumbers;
  stored.exact_step = whole_step(file.points);
  return stored;
}

/// What is stated beside points.
struct BesidePoints {
  double step = 0.0;                ///< in SI; 0: none
  std::optional<double> rate = {};  ///< by the user
  std::string place;
};

/// @param points  in SI, which were in `unit`.
PointsAxis axis_of(std::vector<double> points, const Unit& unit, const StoredPoints& stored,
                   const BesidePoints& beside, std::vector<Warning>& warnings) {
  const std::size_t count = points.size();
  const auto even = [&](double step) {
    return PointsAxis{
        {.dimension = unit.dimension, .start = points.front(), .step = step, .values = {}}, count};
  };
  const auto is_even = [&](double step, double tolerance) {
    const double off = tolerance * step + stored.rounding * unit.factor();
    return points.size() > 1 && step > 0.0 && lies_evenly(points, step, off);
  };
  if (!stored.are_text && is_even(beside.step, kEvenAsStated)) return even(beside.step);
  if (stored.exact_step) return even(unit.to_si(*stored.exact_step));
  if (stored.printed && rise(points)) {
    const auto axis = axis_of_stated_step(points, unit, *stored.printed, beside.step);
    Axis found = axis ? *axis : axis_from_printed(std::move(points), unit, *stored.printed);
    if (found.even()) return {std::move(found), count};
    points = std::move(found.values);
  }
  if (stored.printed && !stored.are_text) {
    StatedRates rates{.asked = beside.rate};
    if (beside.step > 0.0) rates.in_file = 1.0 / beside.step;
    auto clock = axis_of_clock(points, unit, *stored.printed, rates, beside.place, warnings);
    if (clock) return {*std::move(clock), count, beside.rate.has_value()};
  }
  const auto uneven = [&] {
    return PointsAxis{
        {.dimension = unit.dimension, .start = 0.0, .step = 0.0, .values = std::move(points)},
        count};
  };
  if (stored.printed) return uneven();
  const double mean =
      points.size() < 2 ? 0.0
                        : (points.back() - points.front()) / static_cast<double>(points.size() - 1);
  if (stored.are_singles && mean > 0.0) return {axis_from_singles(std::move(points), unit), count};
  if (is_even(mean, kEven)) return even(mean);
  return uneven();
}

/// Why a recording cannot be read; empty where it can.
std::string fault_of(const Recording& recording, const std::string& place) {
  try {
    check_read(recording, place);
    return {};
  } catch (const InputError& error) {
    if (!has_whole_channel(recording)) {
      return "each of its channels has values that are missing or not finite. Cut it where it is "
             "whole";
    }
    const std::string_view text = error.what();
    return std::string(text.substr(text.starts_with(place) ? place.size() + 2 : 0));
  }
}

Unit unit_of_axis(const PointsInFile& file) {
  if (trimmed(file.unit).empty()) return Unit{.dimension = file.usual};
  if (const std::optional<Unit> found = find_unit_of_points(file.unit)) return *found;
  throw InputError(file.place + ": unit", in_quotes(file.unit), "is not known",
                   fmt::format("Units that fit: {}.", usual_units(file.usual)));
}

}  // namespace

bool may_be_points(std::string_view name, std::span<const double> values) {
  if (name.size() > 1) return true;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (!(values[i - 1] < values[i])) return false;
  }
  return true;
}

bool may_be_frequencies(std::string_view name, std::span<const double> values, bool has_rate) {
  const auto fault = std::ranges::adjacent_find(values, std::not_fn(std::less<>()));
  return may_be_points(name, values) && (!has_rate || fault == values.end());
}

double step_of_rate(double rate, const std::string& place) {
  if (!(rate > 0.0) || !std::isfinite(1.0 / rate) || !std::isfinite(rate)) {
    throw InputError(place + ": sampling rate", rate, "must be above 0 and finite");
  }
  return 1.0 / rate;
}

Axis even_axis(const Sampling& sampling) {
  Axis axis;
  axis.start = sampling.start;
  axis.step = sampling.step.value();
  return axis;
}

std::optional<Unit> find_unit_of_points(std::string_view text) {
  constexpr std::array<std::string_view, 3> kDays{"DAYS", "DAY", "D"};
  constexpr double kSecondsOfDay = 86400.0;
  const std::string_view unit = trimmed(text.substr(0, text.find(" since ")));
  if (std::ranges::find(kDays, in_capitals(unit)) == kDays.end()) return find_unit(unit);
  return Unit{.numerator = kSecondsOfDay, .dimension = kTime};
}

std::optional<Unit> stated_unit_of_time(std::string_view text) {
  if (trimmed(text).empty()) return std::nullopt;
  const std::optional<Unit> unit = find_unit_of_points(text);
  return unit && unit->dimension == kTime ? unit : std::nullopt;
}

bool may_be_unit_of_points(std::string_view text, const Dimension& usual) {
  const std::optional<Unit> unit = find_unit_of_points(text);
  if (!unit || trimmed(text).empty() || unit->dimension == usual) return true;
  return usual == kFrequency && unit->dimension == kAngularFrequency;
}

std::string points_of_unknown_unit(std::string_view name, std::string_view unit) {
  return fmt::format("{} in {}, an unknown unit", in_quotes(name), in_quotes(unit));
}

PointsAxis axis_of_points(PointsInFile file, std::optional<double> stated_step,
                          std::vector<Warning>& warnings) {
  const bool from_first = take_unit_by_size(file, warnings);
  const Unit unit = unit_of_axis(file);
  const StoredPoints stored = stored_points(file);
  if (from_first) begin_at_zero(file.points);
  scale(file.points, unit);
  const double step = unit.dimension == kTime ? stated_step.value_or(0.0) : 0.0;
  return axis_of(std::move(file.points), unit, stored, {step, file.rate, file.place}, warnings);
}

std::optional<Warning> contradicting_rate(const PointsAxis& points,
                                          std::optional<double> stated_step, std::string_view name,
                                          std::string_view place) {
  const Axis& axis = points.axis;
  if (!stated_step || !axis.even() || axis.dimension != kTime) return std::nullopt;
  if (std::abs(axis.step - *stated_step) <= kEvenAsStated * *stated_step) return std::nullopt;
  return Warning{
      "rate_contradicts",
      fmt::format(
          "{}: {} has steps of {:.6g} s, {:.6g} Hz, and the file states {:.6g} Hz; the times "
          "are used. Take out what is wrong",
          place, in_quotes(name), axis.step, 1.0 / axis.step, 1.0 / *stated_step)};
}

std::optional<Warning> unused_rate(const Axis& axis, std::optional<double> stated_step,
                                   std::string_view name, std::string_view place) {
  if (!stated_step || axis.dimension != kFrequency) return std::nullopt;
  return Warning{
      "axis_chosen",
      fmt::format("{}: {} is taken for the axis, though the file states {:.6g} Hz as a sampling "
                  "rate. Where the values are over time, give {} another name, such as 'drive'",
                  place, in_quotes(name), 1.0 / *stated_step, in_quotes(name))};
}

void apply_unit(Channel& channel, std::string_view unit, const std::string& source,
                std::vector<Warning>& warnings) {
  if (trimmed(unit).empty()) return;
  const std::optional<Unit> found = find_unit(unit);
  if (!found) {
    channel.attributes.emplace_back("unit", unit);
    if (is_other_unit(unit)) return;
    warnings.push_back(
        {"unit_unknown",
         fmt::format("{}: channel {} is in {}, an unknown unit; it is treated as without unit",
                     source, in_quotes(channel.name), in_quotes(unit))});
    return;
  }
  if (is_gravity(*found) && says_per_gravity(channel.attributes)) {
    channel.attributes.emplace_back("unit", unit);
    warnings.push_back(doubtful_gravity(source, channel.name, channel.values));
    return;
  }
  const bool is_force = is_force_in_pounds(channel.name, *found);
  if (is_force) warnings.push_back(force_in_pounds(source, channel.name));
  const Unit applied = is_force ? pound_force() : *found;
  channel.dimension = applied.dimension;
  scale(channel.values, applied);
  scale(channel.imaginary, applied);
}

void add_channel(std::vector<Recording>& recordings, const std::string& source, const Axis& axis,
                 Channel channel, std::string_view place) {
  const auto fits = [&](const Recording& r) {
    return r.size() == channel.values.size() && r.axis == axis;
  };
  auto recording = std::ranges::find_if(recordings, fits);
  if (recording == recordings.end()) {
    recordings.emplace_back();
    recordings.back().source = source;
    recordings.back().axis = axis;
    recording = std::prev(recordings.end());
    if (recordings.size() > 1) recording->source += fmt::format(" #{}", recordings.size());
  }
  const auto taken = [&](const std::string& name) {
    return std::ranges::find(recording->channels, name, &Channel::name) !=
           recording->channels.end();
  };
  if (taken(channel.name)) channel.name += fmt::format(" ({})", place);
  recording->channels.push_back(std::move(channel));
}

void check_read(const Recording& recording, const std::string& place) {
  try {
    check_recording(recording);
  } catch (const InputError& error) {
    std::string_view name = error.name();  // begins with the source, which may be any text
    if (name.starts_with(recording.source)) name.remove_prefix(recording.source.size());
    if (name.starts_with(": ")) name.remove_prefix(2);
    constexpr std::size_t kLong = 120;
    throw error.renamed(fmt::format(
        "{}: {}", place, name.size() > kLong ? in_quotes(name, kLong) : printable(name)));
  }
}

void check_foreign(Recordings& read, const std::string& place) {
  for (Recording& recording : read.recordings) {
    for (const std::string& reason : leave_out_incomplete(recording)) {
      read.warnings.push_back({"channel_left_out", fmt::format("{}: {}", place, reason)});
    }
  }
  std::vector<std::string> faults;
  for (const Recording& recording : read.recordings) faults.push_back(fault_of(recording, place));
  if (std::ranges::none_of(faults, &std::string::empty)) {
    for (const Recording& recording : read.recordings) check_read(recording, place);
  }
  auto fault = faults.begin();
  std::erase_if(read.recordings, [&](const Recording& recording) {
    const std::string& reason = *fault++;
    if (reason.empty()) return false;
    read.warnings.push_back(
        {"recording_left_out",
         fmt::format("{}: the recording {} of {} is left out: {}", place,
                     in_quotes(recording.source), names_of(recording), reason)});
    return true;
  });
}

void warn_without_rate(std::span<const WithoutAxis> places, std::vector<Warning>& warnings) {
  for (const auto& [place, found] : places) {
    warnings.push_back(
        {"sampling_rate_missing", fmt::format("{}: left out, it has {}", place,
                                              found.empty() ? "no sampling rate or time" : found)});
  }
}

bool may_be_untimed(std::span<const WithoutAxis> places) {
  return !places.empty() && std::ranges::all_of(places, &std::string::empty, &WithoutAxis::found);
}

void check_rate(double rate) {
  if (std::isfinite(1.0 / rate) && rate > 0.0 && std::isfinite(rate)) return;
  throw InputError(std::string(kRateOption), rate, "must be above 0 Hz and finite");
}

double untimed_step(const RecordingReadOptions& options) {
  return options.rate ? 1.0 / *options.rate : 1.0;
}

void note_untimed(const RecordingReadOptions& options, std::string_view place,
                  Recordings& recordings) {
  recordings.rate_used = recordings.rate_used || options.rate;
  const auto is_untimed = [](const Warning& warning) { return warning.code == kUntimed; };
  if (options.rate || std::ranges::any_of(recordings.warnings, is_untimed)) return;
  recordings.warnings.push_back(
      {std::string(kUntimed),
       fmt::format("{}: has no time or sampling rate; its points are taken to be 1 s apart, so "
                   "that times are numbers of points and rates mean nothing",
                   place)});
}

void require_rate_used(double rate, std::string_view file, const Recordings& recordings) {
  if (recordings.rate_used) return;
  throw InputError(std::string(kRateOption), fmt::format("{:.12g} Hz", rate),
                   fmt::format("must not be given for {}: it has times or a rate of its own", file),
                   "Leave it out.");
}

FormatError no_sampling_rate(const WithoutAxis& place, std::string_view remedy) {
  return {{.file = place.place},
          "a sampling rate",
          place.found.empty() ? "none" : place.found,
          place.found.empty() ? fmt::format("{} Or give {}.", remedy, kRateOption)
                              : std::string(remedy)};
}

std::string file_name(const std::string& path) { return path.substr(path.rfind('/') + 1); }

}  // namespace microslip
