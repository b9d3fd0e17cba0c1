// SPDX-License-Identifier: MIT
#include "microslip/io/loggers/tdms_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <utility>

#include "microslip/base/units.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/recordings/sampling.hpp"

namespace microslip {
namespace {

/// Axes agree that are off by this part of a step.
constexpr double kPartOfStep = 1e-2;
/// s. Loggers round the stamps of their channels to microseconds.
constexpr double kRoundedStamp = 2e-6;
constexpr double kMostOfStep = 0.25;
constexpr double kRoundedStep = 1e-9;
/// Of the points of the longest channel: cut to less, a group would lose too much.
constexpr double kLeastInCommon = 0.9;

/// In whole steps from the start of the longest channel.
struct Span {
  double begin;
  double end;

  [[nodiscard]] double length() const { return end - begin; }
  [[nodiscard]] Span common(const Span& other) const {
    return {std::max(begin, other.begin), std::min(end, other.end)};
  }
};

struct Member {
  LoggedChannel* logged;
  Span span;
};

double points_of(const LoggedChannel* logged) {
  return static_cast<double>(logged->channel.values.size());
}

bool have_same_step(const LoggedChannel& longest, const LoggedChannel& other) {
  if (longest.axis->dimension != other.axis->dimension) return false;
  const double step = longest.axis->step;
  const double off = std::abs(other.axis->step - step);
  return off <= kRoundedStep * step || off * points_of(&longest) <= kPartOfStep * step;
}

/// Nothing where the samples of the other lie between those of the longest.
std::optional<Span> span_of(const LoggedChannel& longest, const LoggedChannel& other) {
  const Axis& axis = *longest.axis;
  const double apart = (other.axis->start - axis.start) / axis.step;
  const double rounded = axis.dimension == kTime ? kRoundedStamp / axis.step : 0.0;
  const double most = std::max(kPartOfStep, std::min(rounded, kMostOfStep));
  const double begin = std::round(apart);
  if (!(std::abs(apart - begin) <= most)) return std::nullopt;
  return Span{begin, begin + points_of(&other)};
}

/// The channels together with the longest, which is the first of them.
std::vector<Member> members_of(LoggedChannel* longest, const std::vector<LoggedChannel*>& all) {
  const Span whole{0.0, points_of(longest)};
  std::vector<Member> members;
  for (LoggedChannel* const logged : all) {
    if (!have_same_step(*longest, *logged)) continue;
    if (const std::optional<Span> span = span_of(*longest, *logged)) {
      members.push_back({logged, *span});
    }
  }
  std::ranges::stable_sort(members, std::greater{}, [&](const Member& member) {
    return member.logged == longest ? whole.length() + 1.0 : member.span.common(whole).length();
  });
  Span common = whole;
  const auto loses_much = [&](const Member& member) {
    const Span less = common.common(member.span);
    if (less.length() < kLeastInCommon * whole.length()) return true;
    common = less;
    return false;
  };
  std::vector<Member> kept;
  for (const Member& member : members) {
    if (!loses_much(member)) kept.push_back(member);
  }
  return kept;
}

/// Whether any was cut.
bool cut(const std::vector<Member>& members) {
  Span common = members.front().span;
  for (const Member& member : members) common = common.common(member.span);
  Axis axis = *members.front().logged->axis;
  axis.start += common.begin * axis.step;
  bool is_cut = false;
  for (const Member& member : members) {
    std::vector<double>& values = member.logged->channel.values;
    const auto first = static_cast<std::ptrdiff_t>(common.begin - member.span.begin);
    is_cut = is_cut || first > 0 || common.length() < points_of(member.logged);
    values.erase(values.begin(), values.begin() + first);
    values.resize(static_cast<std::size_t>(common.length()));
    member.logged->axis = axis;
  }
  return is_cut;
}

std::string reason_apart(const LoggedChannel& longest, const LoggedChannel& other,
                         double points_of_longest) {
  const std::string name = in_quotes(longest.channel.name);
  const Axis& axis = *other.axis;
  if (axis.dimension != longest.axis->dimension) return "the axis is another than that of " + name;
  if (!have_same_step(longest, other)) {
    return fmt::format("the step is {:.9g} {}, that of {} {:.9g}", axis.step,
                       si_unit(axis.dimension), name, longest.axis->step);
  }
  if (!span_of(longest, other)) return "the samples lie between those of " + name;
  return fmt::format("less than {} of the {} points of {} have the same times", kLeastInCommon,
                     points_of_longest, name);
}

}  // namespace

WaveformAxis waveform_axis(const TdmsProperties& properties,
                           const std::optional<TdmsTime>& earliest) {
  const double* const increment = properties.number("wf_increment");
  if (!states_step(increment)) return {};
  Unit unit{.dimension = kTime};
  const std::string* const text = properties.text("wf_xunit_string");
  if (text != nullptr && !trimmed(*text).empty()) {
    const std::optional<Unit> known = find_unit_of_points(*text);
    if (!known) return {.fault = fmt::format("values over {}, an unknown unit", in_quotes(*text))};
    if (known->dimension != kTime && known->dimension != kFrequency) {
      return {.fault = fmt::format("values over {}, not over a time or frequency in s or Hz",
                                   in_quotes(*text))};
    }
    unit = *known;
  }
  Axis axis;
  axis.dimension = unit.dimension;
  axis.step = unit.to_si(*increment);
  const double* const offset = properties.number("wf_start_offset");
  if (offset != nullptr) axis.start = unit.to_si(*offset);
  const TdmsTime* const start = properties.time("wf_start_time");
  if (start != nullptr && earliest && axis.dimension == kTime) {
    axis.start += seconds_between(*earliest, *start);
  }
  return {.axis = std::move(axis)};
}

std::vector<TdmsSteps> steps_of(const TdmsObject& object, std::size_t count) {
  std::vector<TdmsSteps> steps;
  std::size_t done = 0;
  const auto add = [&](std::size_t end, double increment) {
    if (end <= done) return;
    const bool goes_on = !steps.empty() && std::abs(increment - steps.back().increment) <=
                                               kRoundedStep * steps.back().increment;
    if (!goes_on) steps.push_back({0, increment});
    steps.back().count += end - done;
    done = end;
  };
  for (const auto& [end, increment] : object.former_steps) add(std::min(end, count), increment);
  const double* const last = object.properties.number("wf_increment");
  if (last != nullptr) add(count, *last);
  return steps;
}

Axis axis_of_steps(const Axis& last, const TdmsObject& object,
                   const std::vector<TdmsSteps>& steps) {
  const double* const increment = object.properties.number("wf_increment");
  const double unit = increment == nullptr ? 1.0 : last.step / *increment;
  Axis axis = last;
  if (steps.size() == 1) {
    axis.step = unit * steps.front().increment;
    return axis;
  }
  axis.start = 0.0;
  axis.step = 0.0;
  double begin = last.start;
  for (const TdmsSteps& part : steps) {
    const double step = unit * part.increment;
    for (std::size_t i = 0; i < part.count; ++i) {
      axis.values.push_back(begin + static_cast<double>(i) * step);
    }
    begin += static_cast<double>(part.count) * step;
  }
  return axis;
}

Alignment align_channels(std::vector<LoggedChannel>& channels) {
  Alignment result;
  std::vector<LoggedChannel*> left;
  for (LoggedChannel& logged : channels) {
    if (logged.axis && logged.axis->even()) left.push_back(&logged);
  }
  const LoggedChannel* first = nullptr;
  double points_of_first = 0.0;
  while (!left.empty()) {
    LoggedChannel* const longest = *std::ranges::max_element(left, {}, points_of);
    const std::vector<Member> members = members_of(longest, left);
    if (first == nullptr) {
      first = longest;
      points_of_first = points_of(longest);
    } else {
      ApartChannels& apart = result.apart.emplace_back();
      apart.reason = reason_apart(*first, *longest, points_of_first);
      for (const Member& member : members) apart.names.push_back(member.logged->channel.name);
    }
    result.is_cut = cut(members) || result.is_cut;
    std::set<const LoggedChannel*> done;
    for (const Member& member : members) done.insert(member.logged);
    std::erase_if(left, [&](const LoggedChannel* logged) { return done.contains(logged); });
  }
  return result;
}

}  // namespace microslip
