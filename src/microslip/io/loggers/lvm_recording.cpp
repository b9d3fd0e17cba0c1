// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/character_set.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/loggers/logger_recording.hpp"
#include "microslip/io/loggers/lvm_contents.hpp"
#include "microslip/io/recordings/sampling.hpp"

namespace microslip {
namespace {

/// Of a step: a section goes on where the last one ended, and channels begin whole steps apart.
constexpr double kWholeLvmSteps = 0.1;

/// s since 1970 by `Date` (2026/11/29) and `Time` (10:00:00.25); nothing where they are others.
std::optional<double> lvm_time(std::string_view date, std::string_view time) {
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  int hours = 0;
  int minutes = 0;
  double seconds = 0.0;
  std::string text = fmt::format("{} {}", date, time);
  std::ranges::replace_if(
      text, [](char c) { return c == '/' || c == ':'; }, ' ');
  std::ranges::replace(text, ',', '.');
  std::istringstream words(text);
  words.imbue(std::locale::classic());
  words >> year >> month >> day >> hours >> minutes >> seconds;
  const std::chrono::year_month_day of{std::chrono::year(year), std::chrono::month(month),
                                       std::chrono::day(day)};
  if (words.fail() || !of.ok()) return std::nullopt;
  const auto days = std::chrono::sys_days(of).time_since_epoch();
  constexpr double kSecondsOfDay = 86400.0;
  return kSecondsOfDay * static_cast<double>(days.count()) + 3600.0 * hours + 60.0 * minutes +
         seconds;
}

class LvmReader {
 public:
  LvmReader(const std::string& path, LvmContents contents, const RecordingReadOptions& options)
      : path_(path), contents_(std::move(contents)), options_(options) {}

  Recordings read() {
    join_sections();
    for (LvmSection& section : contents_.sections) add_section(section);
    if (result_.recordings.empty() && falling_) throw FormatError(*falling_);
    if (result_.recordings.empty() && !without_axis_.empty()) {
      throw no_sampling_rate(without_axis_.front(),
                             "Save values over Time or Frequency, with a column of it or Delta_X.");
    }
    if (result_.recordings.empty()) {
      throw FormatError({path_, 0, 0}, "a section of values, two or more", "none");
    }
    check_foreign(result_, path_);
    warn_without_rate(without_axis_, result_.warnings);
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::optional<double> number(const LvmSection& section, std::string_view tag,
                                             const LvmChannel& channel) const {
    return lvm_number(section.entry(tag, channel), contents_.comma);
  }

  /// What the header states as the step, in the unit of x.
  [[nodiscard]] std::optional<double> stated_step(const LvmSection& section,
                                                  const LvmChannel& channel) const {
    const std::optional<double> step = number(section, "Delta_X", channel);
    return step && *step > 0.0 ? step : std::nullopt;
  }

  /// Where a section begins, as it says itself.
  struct SectionBegin {
    std::optional<double> time;  ///< s, by Date and Time
    double x = 0.0;              ///< s
  };

  /// LabVIEW writes a section for each piece of a measurement that goes on.
  void join_sections() {
    std::vector<LvmSection> joined;
    SectionBegin last;
    std::vector<SectionStep> steps;  // of sections that are joined
    for (LvmSection& next : contents_.sections) {
      const SectionBegin begin{clock_of(next), start_of(next)};
      const bool by_x = !joined.empty() && goes_on(joined.back(), next, 0.0);
      if (by_x && last.time && begin.time) {
        steps.push_back({next.line, *begin.time - *last.time, begin.x - last.x});
      }
      if (by_x || (!joined.empty() && goes_on_by_time(joined.back(), next))) {
        append(joined.back(), next);
      } else {
        warn_of_clock(steps);
        steps.clear();
        joined.push_back(std::move(next));
      }
      last = begin;
    }
    warn_of_clock(steps);
    contents_.sections = std::move(joined);
  }

  /// Where x begins anew in each section, Date and Time say that it goes on.
  [[nodiscard]] bool goes_on_by_time(const LvmSection& joined, const LvmSection& next) const {
    const std::optional<double> before = begin_of(joined);
    const std::optional<double> then = begin_of(next);
    return before && then && *then > *before && goes_on(joined, next, *then - *before);
  }

  /// From the begin of a section to that of the next one, whose x go on.
  struct SectionStep {
    std::size_t line;  ///< where the next one begins
    double by_clock;   ///< s, by Date and Time
    double by_x;       ///< s

    [[nodiscard]] double lag() const { return by_clock - by_x; }
    /// Whether Time does neither as x do nor stays as it is.
    [[nodiscard]] bool is_jump() const {
      constexpr double kLateClock = 1.0;  // s, as pieces are written after they were sampled
      const double off = std::min(std::abs(by_clock), std::abs(lag()));
      return off > std::max(kLateClock, std::abs(by_x));
    }
  };

  /// Says once where Date and Time contradict the x of sections that are joined: by a jump, or by
  /// lags of all of them that add up to more than a hundredth.
  void warn_of_clock(const std::vector<SectionStep>& steps) {
    if (const auto jump = std::ranges::find_if(steps, &SectionStep::is_jump); jump != steps.end()) {
      const auto others = std::ranges::count_if(jump + 1, steps.end(), &SectionStep::is_jump);
      result_.warnings.push_back(
          {"time_jumps",
           fmt::format("{}:{}: a section begins {:.6g} s {} the one before by Date and Time, and "
                       "its x go on; they are joined{}. Split the file there where it was not "
                       "sampled in one run",
                       path_, jump->line, std::abs(jump->by_clock),
                       jump->by_clock > 0.0 ? "after" : "before",
                       others == 0 ? "" : fmt::format(", and {} more such sections", others))});
      return;
    }
    constexpr std::size_t kEnough = 3;
    constexpr double kShare = 0.01;
    double lag = 0.0;
    double length = 0.0;
    for (const SectionStep& step : steps) {
      lag += step.lag();
      length += step.by_x;
    }
    const auto lags_alike = [&](const SectionStep& step) {
      return step.by_clock > 0.0 && step.lag() * lag > 0.0;
    };
    const bool is_steady = steps.size() >= kEnough && std::ranges::all_of(steps, lags_alike);
    if (!is_steady || std::abs(lag) <= kShare * std::abs(length)) return;
    result_.warnings.push_back(
        {"time_jumps",
         fmt::format("{}: {} sections whose x go on take {:.4g} s by x and {:.4g} s by Date and "
                     "Time; they are joined by their x. Either values are missing between them, or "
                     "the sampling rate is {:.3g} % off",
                     path_, steps.size() + 1, length, length + lag,
                     100.0 * std::abs(lag) / std::abs(length))});
  }

  /// Of x, s, by the first channel.
  [[nodiscard]] double start_of(const LvmSection& section) const {
    if (section.channels.empty()) return 0.0;
    const LvmChannel& first = section.channels.front();
    const std::optional<Unit> unit = find_unit_of_points(section.entry("X_Unit_Label", first));
    const bool has_x = !section.x.empty() && !section.x[first.x].values.empty();
    const double start =
        has_x ? section.x[first.x].values.front() : number(section, "X0", first).value_or(0.0);
    return start * (unit ? unit->factor() : 1.0);
  }

  /// @param later  s, by which the values of the next section are later than their x says.
  [[nodiscard]] bool goes_on(const LvmSection& last, const LvmSection& next, double later) const {
    if (last.channels.empty() || last.channels.size() != next.channels.size() ||
        last.x.size() != next.x.size()) {
      return false;
    }
    for (std::size_t i = 0; i < last.channels.size(); ++i) {
      if (!goes_on(last, next, last.channels[i], next.channels[i], later)) return false;
    }
    return true;
  }

  [[nodiscard]] bool goes_on(const LvmSection& last, const LvmSection& next, const LvmChannel& a,
                             const LvmChannel& b, double later) const {
    if (a.column.name != b.column.name) return false;
    for (const char* tag : {"Y_Unit_Label", "X_Unit_Label", "X_Dimension", "Delta_X"}) {
      if (last.entry(tag, a) != next.entry(tag, b)) return false;
    }
    const std::optional<Unit> unit = find_unit_of_points(last.entry("X_Unit_Label", a));
    const bool is_spectrum =
        last.entry("X_Dimension", a) == "Frequency" || (unit && unit->dimension == kFrequency);
    if (later > 0.0 && is_spectrum) return false;
    later /= unit ? unit->factor() : 1.0;
    const std::size_t size = a.column.values.size();
    const std::optional<double> step = stated_step(last, a);
    if (last.x.empty()) {
      const double from = number(last, "X0", a).value_or(0.0);
      const double to = number(next, "X0", b).value_or(0.0);
      return step && is_step(to + later - from - static_cast<double>(size) * *step + *step, *step);
    }
    const std::vector<double>& x = last.x[a.x].values;
    const std::vector<double>& then = next.x[b.x].values;
    if (x.size() != size || then.empty() || x.empty()) return false;
    const double mean = x.size() < 2 ? std::numeric_limits<double>::quiet_NaN()
                                     : (x.back() - x.front()) / static_cast<double>(x.size() - 1);
    const double printed = std::pow(10.0, -last.x[a.x].digits.decimals);
    return is_step(then.front() + later - x.back(), step.value_or(mean), printed);
  }

  /// @param printed  by how much numbers that were printed may be off.
  static bool is_step(double gap, double step, double printed = 0.0) {
    constexpr double kHalf = 0.5;  // a sample that is missing is a whole step
    return std::abs(gap - step) < std::min(kWholeLvmSteps * step + printed, kHalf * step);
  }

  static void append(LvmColumn& to, const LvmColumn& next) {
    to.values.insert(to.values.end(), next.values.begin(), next.values.end());
    to.digits.decimals = std::max(to.digits.decimals, next.digits.decimals);
    to.digits.significant = std::max(to.digits.significant, next.digits.significant);
  }

  /// Of column i of x, which is that of a single point as stated.
  [[nodiscard]] double last_step(const LvmSection& section, std::size_t i) const {
    const std::vector<double>& x = section.x[i].values;
    if (x.size() > 1) return x.back() - x[x.size() - 2];
    const auto over = std::ranges::find(section.channels, i, &LvmChannel::x);
    return over == section.channels.end() ? 0.0 : stated_step(section, *over).value_or(0.0);
  }

  /// Where x begins anew it goes on by the step before.
  void append(LvmSection& to, LvmSection& next) const {
    for (std::size_t i = 0; i < to.x.size(); ++i) {
      const std::vector<double>& x = to.x[i].values;
      std::vector<double>& then = next.x[i].values;
      if (!x.empty() && !then.empty() && then.front() <= x.back()) {
        const double by = x.back() + last_step(to, i) - then.front();
        for (double& value : then) value += by;
      }
      append(to.x[i], next.x[i]);
    }
    for (std::size_t i = 0; i < to.channels.size(); ++i) {
      append(to.channels[i].column, next.channels[i].column);
    }
  }

  /// Where one x is missing, those beside it tell it by the step that is stated.
  void fill_missing_x(LvmSection& section) {
    for (const LvmChannel& channel : section.channels) {
      if (section.x.empty()) return;
      std::vector<double>& x = section.x[channel.x].values;
      const std::optional<double> step = stated_step(section, channel);
      if (!step || x.empty() || !std::isfinite(x.front())) continue;
      std::size_t missing = 0;
      for (std::size_t i = 1; i < x.size(); ++i) {
        if (std::isfinite(x[i])) continue;
        x[i] = x[i - 1] + *step;
        ++missing;
      }
      if (missing == 0) continue;
      result_.warnings.push_back(
          {"points_missing",
           fmt::format("{}:{}: {} of the {} x of a section {} missing; each is taken to be Delta_X "
                       "above the one before",
                       path_, section.line, missing, x.size(), missing == 1 ? "is" : "are")});
    }
  }

  void add_section(LvmSection& section) {
    fill_missing_x(section);
    const std::optional<double> begin = begin_of(section);
    std::vector<Recording> added;
    std::size_t starts = 0;
    for (std::size_t i = 0; i < section.channels.size(); ++i) {
      add_channel_of(section, section.channels[i], i, begin, added);
    }
    for (const Recording& recording : added) {
      if (recording.axis.start != added.front().axis.start) ++starts;
    }
    if (starts > 0) warn_of_starts(section);
    std::ranges::move(added, std::back_inserter(result_.recordings));
  }

  void warn_of_starts(const LvmSection& section) {
    result_.warnings.push_back(
        {"starts_differ",
         fmt::format(
             "{}:{}: channels begin at different times by Date, Time, X0 or x; those are "
             "recordings of their own. Where they were sampled together, give them one Date, "
             "Time and X0",
             path_, section.line)});
  }

  [[nodiscard]] std::optional<double> time_of(const LvmSection& section,
                                              const LvmChannel& channel) const {
    if (contents_.has_absolute_times) return std::nullopt;
    return lvm_time(section.entry("Date", channel), section.entry("Time", channel));
  }

  /// Date and Time of the first channel, whether x count from them or not.
  [[nodiscard]] static std::optional<double> clock_of(const LvmSection& section) {
    if (section.channels.empty()) return std::nullopt;
    const LvmChannel& first = section.channels.front();
    return lvm_time(section.entry("Date", first), section.entry("Time", first));
  }

  /// When the earliest channel begins; nothing where that is not known of all.
  [[nodiscard]] std::optional<double> begin_of(const LvmSection& section) const {
    double begin = std::numeric_limits<double>::infinity();
    for (const LvmChannel& channel : section.channels) {
      const std::optional<double> time = time_of(section, channel);
      if (!time) return std::nullopt;
      begin = std::min(begin, *time);
    }
    return begin;
  }

  [[nodiscard]] std::string place_of(const Channel& channel) const {
    return fmt::format("{}: {}", path_, in_quotes(channel.name, 80));
  }

  void add_channel_of(const LvmSection& section, LvmChannel& from, std::size_t index,
                      std::optional<double> begin, std::vector<Recording>& added) {
    Channel channel;
    channel.name = from.column.name;
    if (channel.name.empty()) channel.name = fmt::format("channel_{}", index + 1);
    channel.values = std::move(from.column.values);
    if (channel.values.empty()) return;
    if (channel.values.size() == 1) {
      without_axis_.push_back(
          {place_of(channel), fmt::format("one value, below line {}", section.line)});
      return;
    }
    std::optional<Axis> axis = axis_of(section, from, channel);
    if (!axis) return;
    if (begin) delay(*axis, *time_of(section, from) - *begin);
    apply_unit(channel, section.entry("Y_Unit_Label", from), path_, result_.warnings);
    const std::size_t before = result_.recordings.size();
    const std::string number = before == 0 ? "" : fmt::format(" #{}", before + 1);
    add_channel(added, file_name(path_) + number, *axis, std::move(channel),
                fmt::format("column {}", from.number));
  }

  /// By whole steps where it is almost so, as clocks are read with an error.
  static void delay(Axis& axis, double by) {
    if (!axis.even()) {
      for (double& value : axis.values) value += by;
      return;
    }
    const double steps = std::round(by / axis.step);
    axis.start += std::abs(by / axis.step - steps) < kWholeLvmSteps ? steps * axis.step : by;
  }

  std::optional<Axis> axis_of(const LvmSection& section, const LvmChannel& from,
                              const Channel& channel) {
    const std::string_view over = section.entry("X_Dimension", from);
    const std::string_view label = section.entry("X_Unit_Label", from);
    const bool is_spectrum = over == "Frequency";
    const std::optional<Unit> unit = trimmed(label).empty()
                                         ? Unit{.dimension = is_spectrum ? kFrequency : kTime}
                                         : find_unit_of_points(label);
    const bool is_known = over.empty() || over == "Time" || is_spectrum;
    if (!is_known || !unit) {
      without_axis_.push_back(
          {place_of(channel), is_known ? points_of_unknown_unit("X_Unit_Label", label)
                                       : fmt::format("X_Dimension {}", in_quotes(over))});
      return std::nullopt;
    }
    std::optional<double> step = stated_step(section, from);
    if (step) step = *step * unit->factor();
    if (!section.x.empty()) return axis_of_x(section, from, channel, *unit, step);
    if (step) {
      Axis axis = even_axis({.step = *step, .start = number(section, "X0", from).value_or(0.0)});
      axis.start *= unit->factor();
      axis.dimension = unit->dimension;
      return axis;
    }
    if (!options_.allow_untimed) without_axis_.push_back({place_of(channel)});
    if (!options_.allow_untimed) return std::nullopt;
    note_untimed(options_, path_, result_);
    return even_axis({.step = untimed_step(options_)});
  }

  std::optional<Axis> axis_of_x(const LvmSection& section, const LvmChannel& from,
                                const Channel& channel, const Unit& unit,
                                std::optional<double> step) {
    const LvmColumn& x = section.x[from.x];
    const std::size_t size = channel.values.size();
    const std::size_t given = std::min(x.values.size(), size);
    if (falls(x, channel, section)) return std::nullopt;
    if (given < size && (!step || given == 0)) {
      without_axis_.push_back(
          {place_of(channel), fmt::format("{} x for its {} values", x.values.size(), size)});
      return std::nullopt;
    }
    const std::string_view label = trimmed(section.entry("X_Unit_Label", from));
    PointsAxis points =
        axis_of_points({.points = points_of(x, given, step.value_or(0.0) / unit.factor()),
                        .unit = label.empty() && unit.dimension == kTime ? "s" : std::string(label),
                        .usual = unit.dimension,
                        .place = path_,
                        .printed = x.digits},
                       step ? step : common_step(section, from, unit), result_.warnings);
    auto warning = contradicting_rate(points, step, x.name, place_of(channel));
    if (warning) result_.warnings.push_back(*std::move(warning));
    if (step && !points.axis.even()) {
      result_.warnings.push_back(
          {"rate_contradicts",
           fmt::format("{}: {} has uneven steps, and the file states {:.6g}; the former are used. "
                       "Take out what is wrong",
                       place_of(channel), in_quotes(x.name), *step)});
    }
    if (given < size) continue_axis(points.axis, given, *step, x.name, channel);
    return std::move(points.axis);
  }

  /// The first ones; where there is one alone a second, a step behind it.
  static std::vector<double> points_of(const LvmColumn& x, std::size_t count, double step) {
    std::vector<double> points(x.values.begin(),
                               x.values.begin() + static_cast<std::ptrdiff_t>(count));
    if (count == 1) points.push_back(points.front() + step);
    return points;
  }

  /// Where x end early, the other points follow: in even steps of x, else in those of Delta_X.
  void continue_axis(Axis& axis, std::size_t given, double step, std::string_view name,
                     const Channel& channel) {
    const std::size_t size = channel.values.size();
    const bool is_even = axis.even();
    result_.warnings.push_back(
        {"points_missing",
         fmt::format("{}: {} has {} values for its {}; the others follow in steps of {}",
                     place_of(channel), in_quotes(name), given, size,
                     is_even ? fmt::format("{:.6g}", axis.step) : "Delta_X")});
    if (is_even) return;
    const double last = axis.values.back();
    for (std::size_t i = given; i < size; ++i) {
      axis.values.push_back(last + static_cast<double>(i + 1 - given) * step);
    }
  }

  /// Whether x fall somewhere, which leaves the channel out.
  bool falls(const LvmColumn& x, const Channel& channel, const LvmSection& section) {
    const auto fault = std::ranges::adjacent_find(x.values, std::not_fn(std::less<>()));
    if (fault == x.values.end()) return false;
    const auto missing = std::ranges::find_if_not(x.values, [](double v) { return v == v; });
    if (missing != x.values.end()) {
      without_axis_.push_back(
          {place_of(channel),
           fmt::format("no x for value {} below line {}",
                       std::distance(x.values.begin(), missing) + 1, section.line)});
      return true;
    }
    const std::string found =
        fmt::format("x that do not rise: {:.9g} after {:.9g}, value {} below line {}", *(fault + 1),
                    *fault, std::distance(x.values.begin(), fault) + 2, section.line);
    if (!falling_) {
      falling_ = FormatError({path_, 0, 0}, "x that rise", found,
                             "Split the file there, or take out rows that were recorded twice.");
    }
    without_axis_.push_back({place_of(channel), found});
    return true;
  }

  /// Of the first channel over the same x that has one.
  [[nodiscard]] std::optional<double> common_step(const LvmSection& section, const LvmChannel& from,
                                                  const Unit& unit) const {
    for (const LvmChannel& channel : section.channels) {
      if (channel.x != from.x) continue;
      if (const auto step = stated_step(section, channel)) return *step * unit.factor();
    }
    return std::nullopt;
  }

  const std::string& path_;
  LvmContents contents_;
  const RecordingReadOptions& options_;
  std::vector<WithoutAxis> without_axis_;
  std::optional<FormatError> falling_;  ///< the first x that do not rise
  Recordings result_;
};

}  // namespace

Recordings read_recordings_lvm(const std::string& path, const RecordingReadOptions& options) {
  const std::string text = to_utf8(read_text(path));
  return LvmReader(path, parse_lvm(text, path), options).read();
}

}  // namespace microslip
