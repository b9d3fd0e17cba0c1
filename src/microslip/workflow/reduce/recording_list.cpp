// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/recording_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "microslip/base/units.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

constexpr std::size_t kWidth = 60;
constexpr std::size_t kMostAttributes = 12;

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// One line of so many characters at most; what control characters there are become blanks.
std::string as_line(std::string_view text) {
  std::string result;
  std::size_t width = 0;
  for (const char c : text) {
    if (!continues_character(c) && ++width > kWidth - 1) break;
    result += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;
  }
  return result + (result.size() < text.size() ? "…\n" : "\n");
}

std::string fact(std::string_view name, std::string_view value) {
  return as_line(fmt::format("    {:<9} {}", name, value));
}

std::string describe_attributes(const Attributes& attributes) {
  std::string text;
  const std::size_t shown = std::min(attributes.size(), kMostAttributes);
  for (std::size_t i = 0; i < shown; ++i) {
    text += as_line(fmt::format("    {}: {}", attributes[i].first, attributes[i].second));
  }
  if (shown < attributes.size()) {
    text += as_line(fmt::format("    and {} more like these", attributes.size() - shown));
  }
  return text;
}

std::string describe_axis(const Recording& recording) {
  const Axis& axis = recording.axis;
  const std::string unit = si_unit(axis.dimension);
  const std::size_t last = recording.size() - 1;
  std::string text;
  if (!axis.even()) {
    text += fact("spacing", "uneven");
  } else if (axis.dimension == kTime) {
    text += fact("rate", fmt::format("{:.9g} Hz", recording.sampling_rate()));
  } else {
    text += fact("step", fmt::format("{:.6g} {}", axis.step, unit));
  }
  text += fact("start", fmt::format("{:.6g} {}", axis.at(0), unit));
  return text + fact("end", fmt::format("{:.6g} {}", axis.at(last), unit));
}

std::string unit_of(const Channel& channel) {
  if (!channel.dimension) return "no unit";
  const std::string unit = si_unit(*channel.dimension);
  const std::string quantity = dimension_name(*channel.dimension);
  return quantity == unit ? unit : fmt::format("{}, {}", quantity, unit);
}

std::string describe_values(const Channel& channel) {
  const bool complex = !channel.imaginary.empty();
  const auto value = [&](std::size_t i) {
    return complex ? std::hypot(channel.values[i], channel.imaginary[i]) : channel.values[i];
  };
  double least = value(0);
  double greatest = least;
  for (std::size_t i = 1; i < channel.values.size(); ++i) {
    least = std::min(least, value(i));
    greatest = std::max(greatest, value(i));
  }
  // In shares of the largest, whose square might not be a number.
  const double scale = std::max(std::abs(least), std::abs(greatest));
  double sum = 0.0;
  for (std::size_t i = 0; i < channel.values.size() && scale > 0.0; ++i) {
    const double share = value(i) / scale;
    sum += share * share;
  }
  const double rms = scale * std::sqrt(sum / static_cast<double>(channel.values.size()));
  return as_line(fmt::format("    {}RMS {:.4g}, min {:.4g}, max {:.4g}",
                             complex ? "magnitude " : "", rms, least, greatest));
}

std::string describe(const Recording& recording) {
  std::string text = fact("points", fmt::format("{}, over {}", recording.size(),
                                                dimension_name(recording.axis.dimension)));
  text += describe_axis(recording) + describe_attributes(recording.attributes);
  for (const Channel& channel : recording.channels) {
    text += as_line(fmt::format("  {}: {}", channel.name, unit_of(channel)));
    text += describe_values(channel) + describe_attributes(channel.attributes);
  }
  return text;
}

std::string damping_of(const UffModeShape& shape) {
  const double ratio = shape.damping_ratio.value_or(0.0);
  if (ratio == 0.0 && shape.loss_factor.value_or(0.0) != 0.0) {
    return fmt::format("loss factor {:.4g}", *shape.loss_factor);
  }
  if (!shape.damping_ratio) return "damping not given";
  return fmt::format("damping {:.4g}", ratio);
}

std::string describe(const UffModeShape& shape) {
  const std::string nodes = counted(shape.nodes.size(), "node");
  switch (shape.analysis) {
    case UffAnalysis::kNormalMode:
    case UffAnalysis::kComplexMode:
      return fmt::format("mode {}: {:.6g} Hz, {}, {}", shape.number, shape.frequency,
                         damping_of(shape), nodes);
    case UffAnalysis::kFrequencyResponse:
      return fmt::format("deflection {}: {:.6g} Hz, {}", shape.number, shape.frequency, nodes);
    case UffAnalysis::kOther:
      break;
  }
  return fmt::format("of no mode or frequency: {}", nodes);
}

}  // namespace

std::string list_mode_shapes(std::span<const UffModeShape> shapes) {
  if (shapes.empty()) return {};
  std::string text;
  for (const int dataset : {55, 2414}) {
    std::string lines;
    std::size_t count = 0;
    for (const UffModeShape& shape : shapes) {
      if (shape.dataset != dataset) continue;
      lines += as_line("  " + describe(shape));
      ++count;
    }
    if (count > 0) text += fmt::format("{} {} (mode shapes)\n", counted(count, "dataset"), dataset);
    text += lines;
  }
  return text;
}

std::string list_recordings(const Recordings& recordings) {
  std::string text;
  const std::size_t count = recordings.recordings.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Recording& recording = recordings.recordings[i];
    text += as_line(fmt::format("Recording {} of {}: {}", i + 1, count, recording.source));
    text += describe(recording);
  }
  return text;
}

}  // namespace microslip
