// SPDX-License-Identifier: MIT
#pragma once

#include <boost/math/distributions/chi_squared.hpp>
#include <cstddef>
#include <string>
#include <vector>

/// @file
/// Simulation-based calibration [Talts et al., arXiv 1804.06788]: of truths that are drawn from the
/// prior, the rank among draws from the posterior of their data is uniform.

namespace microslip::testing {

/// Counts of ranks in bins.
class RankHistogram {
 public:
  /// @param draws  that a truth is ranked among: ranks from 0 to this.
  /// @param bins   divide draws + 1.
  RankHistogram(std::string name, std::size_t draws, std::size_t bins)
      : name_(std::move(name)), draws_(draws), counts_(bins, 0.0) {}

  void add(std::size_t rank) { counts_[rank * counts_.size() / (draws_ + 1)] += 1.0; }

  [[nodiscard]] const std::string& name() const { return name_; }

  /// p of the hypothesis that all ranks are equally frequent, by χ².
  [[nodiscard]] double uniformity() const {
    double total = 0.0;
    for (const double count : counts_) total += count;
    const double expected = total / static_cast<double>(counts_.size());
    double sum = 0.0;
    for (const double count : counts_) sum += (count - expected) * (count - expected) / expected;
    const boost::math::chi_squared distribution(static_cast<double>(counts_.size() - 1));
    return boost::math::cdf(boost::math::complement(distribution, sum));
  }

 private:
  std::string name_;
  std::size_t draws_;
  std::vector<double> counts_;
};

}  // namespace microslip::testing
