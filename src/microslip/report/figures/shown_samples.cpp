// SPDX-License-Identifier: MIT
#include "microslip/report/figures/shown_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace microslip {
namespace {

/// Samples per interval: lowest and highest of three signals.
constexpr std::size_t kPerStretch = 6;
/// Samples per half cycle, at which a loop is still round.
constexpr double kPerBranch = 60.0;

/// Adds the samples of the lowest and the highest value of a part; none where all are NaN.
void add_extremes(const std::vector<double>& values, RecordPart part,
                  std::vector<std::size_t>& samples) {
  std::size_t low = part.end;
  std::size_t high = part.end;
  for (std::size_t i = part.begin; i < part.end; ++i) {
    if (!std::isfinite(values[i])) continue;
    if (low == part.end || values[i] < values[low]) low = i;
    if (high == part.end || values[i] > values[high]) high = i;
  }
  if (low == part.end) return;
  samples.push_back(low);
  samples.push_back(high);
}

}  // namespace

std::vector<std::size_t> shown_samples(const ForcePath& path, RecordPart part, std::size_t most) {
  const std::size_t count = part.end - part.begin;
  std::vector<std::size_t> samples;
  if (count <= most) {
    samples.resize(count);
    std::iota(samples.begin(), samples.end(), part.begin);
    return samples;
  }
  const std::vector<double> residual = residual_of(path);
  const std::size_t stretches = most / kPerStretch;
  for (std::size_t s = 0; s < stretches; ++s) {
    const RecordPart stretch{part.begin + s * count / stretches,
                             part.begin + (s + 1) * count / stretches};
    for (const auto* values : {&path.displacement, &path.force, &residual}) {
      add_extremes(*values, stretch, samples);
    }
  }
  std::ranges::sort(samples);
  const auto rest = std::ranges::unique(samples);
  samples.erase(rest.begin(), rest.end());
  return samples;
}

RecordPart part_for_loops(const ForcePath& path, std::size_t most) {
  const std::size_t count = path.time.size();
  const double branches = static_cast<double>(most) / kPerBranch;
  const double length =
      branches * static_cast<double>(count) / static_cast<double>(path.reversals + 1);
  if (count <= most || length >= static_cast<double>(count)) return {0, count};
  const auto shown = std::max(static_cast<std::size_t>(length), most);
  const auto [low, high] = std::ranges::minmax(path.path);
  const double middle = 0.5 * (low + high);
  const auto largest =
      std::ranges::max_element(path.path, {}, [middle](double u) { return std::abs(u - middle); });
  const auto at = static_cast<std::size_t>(largest - path.path.begin());
  const std::size_t begin = std::min(at - std::min(at, shown / 2), count - shown);
  return {begin, begin + shown};
}

std::vector<double> residual_of(const ForcePath& path) {
  std::vector<double> residual(path.force.size());
  for (std::size_t i = 0; i < residual.size(); ++i) residual[i] = path.force[i] - path.found[i];
  return residual;
}

}  // namespace microslip
