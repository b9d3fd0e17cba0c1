// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace microslip {

/// s^p of one exponent for many s, some three times as fast as std::pow: with s = 2^e m, m in
/// [1, 2), and c the middle of the 64th of that interval in which m lies,
///
///     s^p = 2^(ep) c^p (1 + r)^p,   r = (m − c)/c,   |r| ≤ 1/128
///
/// The first two factors are tabulated, the third is its binomial series up to r^7: the remainder
/// is below 2^−56 for p ≤ 8. The relative error is below 5e-16: four times 2^−53, of the
/// tables and of products. Internal to joint.
class FixedPower {
 public:
  /// @param exponent  p; a table is made for p in (0, 8].
  /// @param most      the largest s, > 0, finite. The least is 2^−63 of it.
  FixedPower(double exponent, double most);

  /// Whether s is in the range of the table, if there is one.
  [[nodiscard]] bool covers(double s) const { return s >= least_ && s <= most_; }

  /// s^p. @param s  within covers().
  [[nodiscard]] double operator()(double s) const {
    const auto bits = std::bit_cast<std::uint64_t>(s);
    const std::size_t interval = (bits >> (kMantissa - kIntervalBits)) & (kIntervals - 1);
    const double m = std::bit_cast<double>((bits & kMantissaMask) | kOne);
    const double r = (m - middle(interval)) * inverse_[interval];
    const auto& c = series_;
    const double r2 = r * r;
    const double series =
        r * (c[0] + r * c[1] + r2 * (c[2] + r * c[3]) + r2 * r2 * (c[4] + r * c[5] + r2 * c[6]));
    const double scale = octave_[(bits >> kMantissa) - lowest_octave_] * interval_[interval];
    return scale + scale * series;
  }

 private:
  static constexpr unsigned kMantissa = 52;
  static constexpr unsigned kIntervalBits = 6;
  static constexpr std::size_t kIntervals = std::size_t{1} << kIntervalBits;
  static constexpr std::size_t kOctaves = 64;
  static constexpr std::uint64_t kMantissaMask = (std::uint64_t{1} << kMantissa) - 1;
  static constexpr std::uint64_t kOne = std::uint64_t{1023} << kMantissa;

  [[nodiscard]] static double middle(std::size_t interval) {
    return 1.0 + (static_cast<double>(interval) + 0.5) / static_cast<double>(kIntervals);
  }

  double least_ = 1.0;  // above the most: nothing is covered
  double most_ = 0.0;
  std::size_t lowest_octave_ = 0;  // biased, as in the bits
  std::array<double, kOctaves> octave_{};
  std::array<double, kIntervals> interval_{};
  std::array<double, kIntervals> inverse_{};
  std::array<double, 7> series_{};
};

}  // namespace microslip
