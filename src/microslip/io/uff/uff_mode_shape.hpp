// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// @file
/// One mode shape of a universal file, as dataset 55 or 2414 has it.

namespace microslip {

/// Kind of such a dataset.
enum class UffAnalysis {
  kOther,
  kNormalMode,         ///< real mode of the undamped structure
  kComplexMode,        ///< from a complex eigenvalue
  kFrequencyResponse,  ///< deflection shape at a frequency
};

/// Values at nodes, in the units of the file: the scale of a mode shape is its maker's choice.
struct UffModeShape {
  int dataset = 55;                            ///< or 2414
  std::array<std::string, 5> id_lines;         ///< empty where the file has NONE
  UffAnalysis analysis = UffAnalysis::kOther;  ///< what the dataset says it is
  std::int64_t load_case = 0;                  ///< its number; 0 where there is none
  std::int64_t number = 0;                     ///< of the mode or of the frequency
  std::int64_t specific_type = 0;  ///< or result type: 8 displacement, 11 velocity, 12 acceleration
  double frequency = 0.0;          ///< Hz; of a complex mode |λ|/2π
  std::optional<double> damping_ratio;  ///< viscous, ζ, 1; of a complex mode -Re λ/|λ|
  std::optional<double> loss_factor;    ///< hysteretic, η, 1
  std::optional<double> modal_mass;     ///< of a normal mode, as in the file
  std::optional<std::complex<double>> eigenvalue;  ///< λ of a complex mode, rad/s
  /// Of a complex mode as in the file: a of the receptance Σ ψψᵀ/(a(iω − λ)) and the conjugate.
  std::optional<std::complex<double>> modal_a;
  std::optional<double> length_unit;  ///< m, by dataset 164; nothing without one
  std::optional<double> force_unit;   ///< N, as above
  std::size_t values_per_node = 0;    ///< 3: X, Y, Z; 6: rotations too
  std::vector<std::int64_t> nodes;    ///< their numbers in the file
  std::vector<double> values;         ///< nodes × values_per_node, a node after the other
  std::vector<double> imaginary;      ///< of the same length, or empty where values are real

  /// Value j of node number i of the list, both from 0.
  [[nodiscard]] double at(std::size_t i, std::size_t j) const {
    return values[i * values_per_node + j];
  }
};

}  // namespace microslip
