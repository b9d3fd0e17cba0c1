// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/response_draws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "microslip/base/error.hpp"
#include "microslip/dynamics/harmonic/curve_heights.hpp"
#include "microslip/identify/posterior/quantiles.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/workflow/predict/model_comparison.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

using Station = ResponseOfDraws::Station;

std::vector<Station> stations_of(const ResponseCurve& reference, Quantity kept) {
  const CurveHeights heights(reference, kept);
  std::vector<Station> stations;
  for (const SteadyVibration& point : reference.points) {
    const std::vector<double> here = heights.at(point.angular_frequency);
    const double own = height_of(point, kept);
    std::size_t branch = 0;
    for (std::size_t b = 1; b < here.size(); ++b) {
      if (std::abs(here[b] - own) < std::abs(here[branch] - own)) branch = b;
    }
    stations.push_back({point.angular_frequency, branch, std::max<std::size_t>(1, here.size())});
  }
  return stations;
}

/// The least and the largest height of a draw that may be meant at a station.
/// @param heights  rising
std::pair<double, double> meant(const Station& station, const std::vector<double>& heights) {
  if (heights.size() == station.branches) {
    return {heights[station.branch], heights[station.branch]};
  }
  if (station.branches > 1 && station.branch == 0) return {heights.front(), heights.front()};
  if (station.branches > 1 && station.branch + 1 == station.branches) {
    return {heights.back(), heights.back()};
  }
  return {heights.front(), heights.back()};
}

/// The peak of the reference next to a frequency.
std::size_t next_peak(const ResponseCurve& reference, double angular_frequency) {
  const auto next = std::ranges::min_element(reference.peaks, {}, [&](const SteadyVibration& peak) {
    return std::abs(std::log(peak.angular_frequency / angular_frequency));
  });
  return static_cast<std::size_t>(next - reference.peaks.begin());
}

std::vector<double> numbers_of(const std::vector<double>& values) {
  std::vector<double> numbers;
  std::ranges::copy_if(values, std::back_inserter(numbers),
                       [](double value) { return !std::isnan(value); });
  return numbers;
}

PeakSpread peak_spread(const SteadyVibration& peak, Quantity kept,
                       const std::vector<double>& frequency, const std::vector<double>& height,
                       double confidence) {
  std::vector<double> frequencies = numbers_of(frequency);
  std::vector<double> heights = numbers_of(height);
  PeakSpread spread{.frequency = peak.frequency(),
                    .frequency_lower = peak.frequency(),
                    .frequency_upper = peak.frequency(),
                    .height = height_of(peak, kept),
                    .height_lower = height_of(peak, kept),
                    .height_upper = height_of(peak, kept),
                    .draws = heights.size()};
  if (heights.empty()) return spread;
  std::tie(spread.frequency_lower, spread.frequency_upper) = quantile_pair(frequencies, confidence);
  std::tie(spread.height_lower, spread.height_upper) = quantile_pair(heights, confidence);
  return spread;
}

/// Draws without a peak, other than those that failed: the band is that of the rest.
void add_peak_warnings(ResponseSpread& spread) {
  const std::size_t taken = spread.taken.options.count - spread.taken.failed();
  const double tail = 0.5 * (1.0 - spread.taken.options.confidence);
  for (const PeakSpread& peak : spread.peaks) {
    const std::size_t without = taken - peak.draws;
    if (static_cast<double>(without) <= tail * static_cast<double>(taken)) continue;
    spread.warnings.push_back(
        {"peak_missing",
         fmt::format("{} of {} draws have no peak near {:.6g} Hz: its band is that of the others. "
                     "Theirs may lie outside the frequency range, or merge with another peak.",
                     without, taken, peak.frequency)});
  }
}

}  // namespace

ResponseOfDraws::ResponseOfDraws(const HarmonicBalance& balance, const ResponseCurve& reference,
                                 const ResponseRange& range)
    : balance_(balance),
      reference_(reference),
      range_(range),
      options_(options_of_draws(balance.options())),
      stations_(stations_of(reference, range.kept.quantity)) {}

DrawnResponse ResponseOfDraws::of(StructureDraw drawn) const {
  const bool of_force = range_.kept.quantity == Quantity::kResponse;
  const double gain = of_force ? 1.0 : drawn.response_gain;  // of the heights
  Target kept = range_.kept;
  if (of_force) kept.value /= drawn.response_gain;
  const HarmonicBalance balance(std::move(drawn.structure), balance_.response(), options_);
  const ResponseCurve curve =
      balance.follow(kept, Quantity::kAngularFrequency, range_.from, range_.to);
  if (!curve.summary.converged()) return {.failure = curve.summary.reason};
  DrawnResponse response;
  if (!add_heights(CurveHeights(curve, kept.quantity), gain, response)) {
    return {.failure = "its curve does not cover all frequencies of the reference"};
  }
  add_peaks(curve, gain, response);
  return response;
}

bool ResponseOfDraws::add_heights(const CurveHeights& heights, double gain,
                                  DrawnResponse& response) const {
  for (const Station& station : stations_) {
    const std::vector<double> here = heights.at(station.angular_frequency);
    if (here.empty()) return false;
    const auto [least, most] = meant(station, here);
    response.lower.push_back(gain * least);
    response.upper.push_back(gain * most);
  }
  return true;
}

void ResponseOfDraws::add_peaks(const ResponseCurve& curve, double gain,
                                DrawnResponse& response) const {
  const std::size_t count = reference_.peaks.size();
  response.peak_frequency.assign(count, std::numeric_limits<double>::quiet_NaN());
  response.peak_height = response.peak_frequency;
  if (count == 0) return;
  const bool of_force = range_.kept.quantity == Quantity::kResponse;
  for (const SteadyVibration& peak : curve.peaks) {
    const std::size_t p = next_peak(reference_, peak.angular_frequency);
    const double height = gain * height_of(peak, range_.kept.quantity);
    double& known = response.peak_height[p];
    const bool less = of_force ? height >= known : height <= known;
    if (!std::isnan(known) && less) continue;
    known = height;
    response.peak_frequency[p] = peak.frequency();
  }
}

ResponseSpread response_spread(const HarmonicBalance& balance, const ResponseCurve& reference,
                               const ResponseRange& range, const StructureDraws& draws,
                               const DrawOptions& options, const Execution& execution,
                               const Progress& progress) {
  options.check();
  const ResponseOfDraws prediction(balance, reference, range);
  using Rows = std::vector<std::vector<double>>;
  Rows lower(options.count);  // [draw][point]
  Rows upper(options.count);
  ResponseSpread spread;
  spread.peak_frequency.assign(
      reference.peaks.size(),
      std::vector<double>(options.count, std::numeric_limits<double>::quiet_NaN()));
  spread.peak_height = spread.peak_frequency;
  const auto take = [&](std::size_t i) {
    DrawnResponse drawn = prediction.of(draws.draw(i));
    if (!drawn.failure.empty()) return drawn.failure;
    lower[i] = std::move(drawn.lower);
    upper[i] = std::move(drawn.upper);
    for (std::size_t p = 0; p < reference.peaks.size(); ++p) {
      spread.peak_frequency[p][i] = drawn.peak_frequency[p];
      spread.peak_height[p][i] = drawn.peak_height[p];
    }
    return std::string();
  };
  spread.taken = take_draws(options, take, execution, progress);
  spread.band = band_of(lower, upper, options.confidence);
  for (std::size_t p = 0; p < reference.peaks.size(); ++p) {
    spread.peaks.push_back(peak_spread(reference.peaks[p], range.kept.quantity,
                                       spread.peak_frequency[p], spread.peak_height[p],
                                       options.confidence));
  }
  spread.warnings = draw_warnings(spread.taken);
  add_peak_warnings(spread);
  return spread;
}

std::string peaks_comment(const ResponseSpread& spread, const CurveHeight& height) {
  const std::string unit = si_unit(height.dimension);
  std::string text;
  for (const PeakSpread& peak : spread.peaks) {
    text += fmt::format(
        "{}peak of draws: frequency {:.9g} Hz, {:.9g} to {:.9g} Hz; {} {:.9g} {}, {:.9g} to {:.9g} "
        "{}; {} draws",
        text.empty() ? "" : "\n", peak.frequency, peak.frequency_lower, peak.frequency_upper,
        height.name, peak.height, unit, peak.height_lower, peak.height_upper, unit, peak.draws);
  }
  return text;
}

std::string peaks_table(const ResponseSpread& spread, const CurveHeight& height,
                        const std::string& heading) {
  CsvWriter table;
  if (!heading.empty()) table.add_comment(heading);
  const auto add = [&](std::string_view name, const Dimension& dimension, auto value) {
    std::vector<double> values;
    for (const PeakSpread& peak : spread.peaks) values.push_back(value(peak));
    table.add_numbers(name, dimension, values);
  };
  const std::string name(height.name);
  add("frequency", kFrequency, [](const PeakSpread& peak) { return peak.frequency; });
  add("frequency_lower", kFrequency, [](const PeakSpread& peak) { return peak.frequency_lower; });
  add("frequency_upper", kFrequency, [](const PeakSpread& peak) { return peak.frequency_upper; });
  add(name, height.dimension, [](const PeakSpread& peak) { return peak.height; });
  add(name + "_lower", height.dimension, [](const PeakSpread& peak) { return peak.height_lower; });
  add(name + "_upper", height.dimension, [](const PeakSpread& peak) { return peak.height_upper; });
  add("draws", kDimensionless,
      [](const PeakSpread& peak) { return static_cast<double>(peak.draws); });
  return table.str();
}

std::string describe_peak_spread(const ResponseSpread& spread, const CurveHeight& height) {
  std::string text;
  for (const PeakSpread& peak : spread.peaks) {
    text += line(height.drives ? "resonance of draws" : "peak of draws",
                 fmt::format("{:.6g} to {:.6g} Hz, {:.5g} to {:.5g} {}", peak.frequency_lower,
                             peak.frequency_upper, peak.height_lower, peak.height_upper,
                             si_unit(height.dimension)));
  }
  return text;
}

}  // namespace microslip
