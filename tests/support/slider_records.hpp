// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/observe/force_record.hpp"

/// @file Records of joints whose sliders are moved one by one, along paths at constant speed or of
/// sines. Nothing of joint/ is used.

namespace microslip::testing {

/// Sliders, each a spring with a limit, beside a spring. Lengths over the amplitude A of a record,
/// stiffnesses over k.
struct Sliders {
  std::string name = {};
  std::vector<double> slip_displacement = {};  ///< of each, over A
  std::vector<double> stiffness = {};          ///< of each; with `elastic` 1 in sum
  double elastic = 0.0;

  /// The force on each point of a path over A.
  [[nodiscard]] std::vector<double> forces_on(const std::vector<double>& path) const;
};

/// Sliders of equal stiffness whose slip displacements are quantiles of a distribution.
Sliders sliders_of(const std::string& name, double elastic,
                   const std::function<double(double)>& quantile, std::size_t count = 300);

/// Twelve kinds: even, power laws, single ones, populations, with and without an end in the range.
std::vector<Sliders> all_sliders();

/// Motions of a bench.
enum class Motion {
  kSines,             ///< of one amplitude
  kTriangles,         ///< constant speed
  kGrowingTriangles,  ///< the same, of five amplitudes
  kRampsWithHolds,    ///< constant speed, with a rest at each turn
};
inline constexpr Motion kConstantSpeed[] = {Motion::kTriangles, Motion::kGrowingTriangles,
                                            Motion::kRampsWithHolds};

/// How a record is sampled.
struct SliderRecord {
  std::size_t per_cycle = 400;  ///< samples
  std::size_t between = 5;      ///< sixteenths of a sample from a turn to the next sample, 0 to 15
  double path_noise = 0.0;      ///< standard deviation, over A
  double force_noise = 0.0;     ///< over the largest force
  std::uint64_t seed = 1;
};

inline constexpr double kSliderAmplitude = 5e-6;  ///< A, m
inline constexpr double kSliderStiffness = 1e7;   ///< k, N/m

/// Three to five cycles of a motion, from rest.
ForceRecord record_of(const Sliders& sliders, Motion motion, const SliderRecord& how);

}  // namespace microslip::testing
