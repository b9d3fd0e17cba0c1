// SPDX-License-Identifier: MIT
#include "microslip/report/figures/force_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "microslip/base/gather.hpp"
#include "microslip/report/figures/shown_samples.hpp"

namespace microslip {
namespace {

constexpr Stroke kMeasuredForce = {.colour = kGrey, .width = 3.0};
constexpr Stroke kFoundForce = {.colour = kBlue, .width = 1.1};
constexpr Stroke kResidual = {.colour = kBlue, .width = 1.0};
constexpr Stroke kScatter = {.colour = kGrey, .style = LineStyle::kDashed, .width = 1.2};

/// Adds a line for each part without a gap: on paper a line has none.
void add_line(std::vector<Layer>& layers, const std::vector<double>& x,
              const std::vector<double>& y, const std::string& legend, const Stroke& stroke) {
  LineLayer line{.legend = legend, .stroke = stroke};
  const auto end_line = [&] {
    if (!line.x.empty()) layers.emplace_back(line);
    line.x.clear();
    line.y.clear();
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::isfinite(y[i])) {
      line.x.push_back(x[i]);
      line.y.push_back(y[i]);
    } else {
      end_line();
    }
  }
  end_line();
}

/// Adds lines at ±2s over a range of the axis.
void add_scatter(std::vector<Layer>& layers, std::optional<double> scatter, double from,
                 double to) {
  if (!scatter) return;
  for (const double level : {-2.0 * *scatter, 2.0 * *scatter}) {
    layers.emplace_back(
        LineLayer{{from, to}, {level, level}, "± 2 deviations of a sample", kScatter});
  }
}

/// Means over bins of the displacement.
class BinnedMeans {
 public:
  BinnedMeans(double low, double high) : low_(low), width_((high - low) / kBins) {}

  void add(double u, double value) {
    const double at = width_ > 0.0 ? (u - low_) / width_ : 0.0;  // a part may be at rest
    const auto bin = static_cast<std::size_t>(std::clamp(at, 0.0, kBins - 1.0));
    sum_[bin] += value;
    ++count_[bin];
  }

  /// @param colour  of the line.
  [[nodiscard]] LineLayer line(std::string legend, int colour) const {
    LineLayer line{.legend = std::move(legend), .stroke = {.colour = colour, .width = 2.0}};
    for (std::size_t i = 0; i < sum_.size(); ++i) {
      if (count_[i] < kFewest) continue;
      line.x.push_back(low_ + (static_cast<double>(i) + 0.5) * width_);
      line.y.push_back(sum_[i] / static_cast<double>(count_[i]));
    }
    return line;
  }

 private:
  static constexpr double kBins = 40.0;
  static constexpr std::size_t kFewest = 5;  // samples that make a mean
  double low_;
  double width_;
  std::array<double, static_cast<std::size_t>(kBins)> sum_ = {};
  std::array<std::size_t, static_cast<std::size_t>(kBins)> count_ = {};
};

/// Thins out the samples, so that marks do not cover each other.
PointLayer some_samples(const ForcePath& path, const std::vector<double>& residual) {
  constexpr std::size_t kMost = 1200;
  PointLayer points{.legend = "samples", .colour = kGrey, .size = 0.3};
  const std::size_t step = (residual.size() + kMost - 1) / kMost;
  if (step > 1) points.legend = fmt::format("one of {} samples", step);
  for (std::size_t i = 0; i < residual.size(); i += step) {
    if (!std::isfinite(residual[i])) continue;
    points.x.push_back(path.path[i]);
    points.y.push_back(residual[i]);
  }
  return points;
}

}  // namespace

std::vector<Layer> force_layers(const ForcePath& path, std::size_t most) {
  const std::vector<std::size_t> samples = shown_samples(path, {0, path.time.size()}, most);
  const std::vector<double> time = gather(path.time, samples);
  std::vector<Layer> layers;
  add_line(layers, time, gather(path.force, samples), "measured", kMeasuredForce);
  add_line(layers, time, gather(path.found, samples), "identified joint", kFoundForce);
  return layers;
}

std::vector<Layer> loop_layers(const ForcePath& path, std::size_t most) {
  const std::vector<std::size_t> samples = shown_samples(path, part_for_loops(path, most), most);
  std::vector<Layer> layers;
  add_line(layers, gather(path.displacement, samples), gather(path.force, samples), "measured",
           kMeasuredForce);
  add_line(layers, gather(path.path, samples), gather(path.found, samples), "identified joint",
           kFoundForce);
  return layers;
}

std::vector<Layer> residual_layers(const ForcePath& path, std::optional<double> scatter,
                                   std::size_t most) {
  const std::vector<std::size_t> samples = shown_samples(path, {0, path.time.size()}, most);
  std::vector<Layer> layers;
  add_line(layers, gather(path.time, samples), gather(residual_of(path), samples), "residual",
           kResidual);
  add_scatter(layers, scatter, path.time.front(), path.time.back());
  return layers;
}

std::vector<Layer> residual_over_displacement(const ForcePath& path,
                                              std::optional<double> scatter) {
  const std::vector<double> residual = residual_of(path);
  const auto [low, high] = std::ranges::minmax(path.path);
  BinnedMeans rising(low, high);
  BinnedMeans falling(low, high);
  for (std::size_t i = 1; i + 1 < residual.size(); ++i) {
    if (!std::isfinite(residual[i])) continue;
    const bool rises = path.path[i + 1] > path.path[i - 1];
    (rises ? rising : falling).add(path.path[i], residual[i]);
  }
  std::vector<Layer> layers;
  if (PointLayer points = some_samples(path, residual); !points.x.empty()) {
    layers.emplace_back(std::move(points));
  }
  add_scatter(layers, scatter, low, high);
  const auto add = [&layers](LineLayer mean) {
    if (!mean.x.empty()) layers.emplace_back(std::move(mean));
  };
  add(rising.line("mean while it rises", kVermillion));
  add(falling.line("mean while it falls", kBlue));
  return layers;
}

std::optional<double> scatter_of(const ExperimentResults& results, const ForcePath& path) {
  if (!results.joint || !results.joint->by_records) return std::nullopt;
  const std::vector<RecordFound>& records = results.joint->by_records->records;
  if (path.record >= records.size()) return std::nullopt;
  return records[path.record].scatter;
}

}  // namespace microslip
