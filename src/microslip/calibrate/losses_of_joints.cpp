// SPDX-License-Identifier: MIT
#include "microslip/calibrate/losses_of_joints.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "microslip/base/median.hpp"

namespace microslip {
namespace {

/// Two joints are known only together where the sum of their losses is known so many times better
/// than the loss of either, which is known to this share of it at best.
constexpr double kTogetherRatio = 5.0;
constexpr double kKnownAlone = 0.05;

struct Moments {
  double mean_first;
  double mean_second;
  double first;  // standard deviations
  double second;
  double sum;
  double correlation;
};

Moments moments_of(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  const double mean_a = std::accumulate(a.begin(), a.end(), 0.0) / n;
  const double mean_b = std::accumulate(b.begin(), b.end(), 0.0) / n;
  double aa = 0.0;
  double bb = 0.0;
  double ab = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
    ab += (a[i] - mean_a) * (b[i] - mean_b);
  }
  const double product = std::sqrt(aa * bb);
  return {mean_a,
          mean_b,
          std::sqrt(aa / n),
          std::sqrt(bb / n),
          std::sqrt(std::max(0.0, aa + bb + 2.0 * ab) / n),
          product > 0.0 ? ab / product : 0.0};
}

/// Finds pairs of joints whose individual losses are not determined.
/// @param losses  [level][joint][draw].
void read_pairs(const std::vector<std::vector<std::vector<double>>>& losses,
                CalibrationResult& result) {
  for (std::size_t first = 0; first < result.joints.size(); ++first) {
    for (std::size_t second = first + 1; second < result.joints.size(); ++second) {
      std::vector<double> correlation;
      std::vector<double> alone;
      std::vector<double> together;
      for (const auto& level : losses) {
        const Moments m = moments_of(level[first], level[second]);
        if (!(m.mean_first > 0.0 && m.mean_second > 0.0)) continue;
        correlation.push_back(m.correlation);
        // The better known of the two: a small share is never known well.
        alone.push_back(std::min(m.first / m.mean_first, m.second / m.mean_second));
        together.push_back(m.sum / (m.mean_first + m.mean_second));
      }
      if (correlation.empty()) continue;
      JointPair pair{first, second, median(std::move(correlation)), median(std::move(alone)),
                     median(std::move(together))};
      pair.known_only_together = pair.correlation < 0.0 && pair.spread_alone > kKnownAlone &&
                                 pair.spread_alone > kTogetherRatio * pair.spread_together;
      result.pairs.push_back(pair);
    }
  }
}

/// Of three and more joints that contribute alike no pair is known together, as the others take the
/// rest: compares each with the sum of all.
void read_groups(const std::vector<std::vector<std::vector<double>>>& losses,
                 CalibrationResult& result) {
  for (std::size_t joint = 0; joint < result.joints.size(); ++joint) {
    std::vector<double> alone;
    std::vector<double> together;
    for (const auto& level : losses) {
      std::vector<double> sum(level[joint].size(), 0.0);
      for (const std::vector<double>& values : level) {
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += values[i];
      }
      const Moments m = moments_of(level[joint], sum);
      if (!(m.mean_first > 0.0)) continue;
      alone.push_back(m.first / m.mean_first);
      together.push_back(m.second / m.mean_second);
    }
    if (alone.empty()) continue;
    const double spread = median(std::move(alone));
    if (spread < kKnownAlone || spread < kTogetherRatio * median(std::move(together))) continue;
    result.known_in_sum.push_back(joint);
  }
}

/// The loss of each joint over its standard deviation, where that is largest.
/// @param losses  [level][joint][draw].
void read_loss_significance(const std::vector<std::vector<std::vector<double>>>& losses,
                            CalibrationResult& result) {
  for (std::size_t i = 0; i < losses.size(); ++i) {
    if (!result.levels[i].found) continue;
    for (std::size_t j = 0; j < result.joints.size(); ++j) {
      const Moments m = moments_of(losses[i][j], losses[i][j]);
      if (!(m.first > 0.0)) continue;
      result.joints[j].loss_significance =
          std::max(result.joints[j].loss_significance, m.mean_first / m.first);
    }
  }
}

}  // namespace

void read_losses(const std::vector<std::vector<std::vector<double>>>& losses,
                 CalibrationResult& result) {
  read_pairs(losses, result);
  read_loss_significance(losses, result);
  if (result.joints.size() > 2) read_groups(losses, result);
}

}  // namespace microslip
