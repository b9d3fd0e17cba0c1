// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace microslip {

/// A density with a few parameters. f_d = kA_max is the largest slip force reached by the levels.
enum class ParametricModel {
  /// Segalman's: macroslip_force F_S > 0 [N], −1 < chi ≤ 0, beta ≥ 0, with K_T = k.
  kFourParameter,
  /// φ = R f*^χ [AR14 (6)]: coefficient R > 0 [N^−(1+χ)], exponent χ > −1, on [0, f_max] with f_max
  /// = f_d, or where the area reaches 1 if that is lower.
  kPowerLaw,
  /// φ = weight/to: 0 < weight ≤ 1, 0 < to ≤ f_d [N]. (Beyond f_d the levels determine only
  /// weight/to.)
  kUniform,
};

inline constexpr std::array kParametricModels = {ParametricModel::kFourParameter,
                                                 ParametricModel::kPowerLaw,
                                                 ParametricModel::kUniform};  ///< all

/// "four_parameter", "power_law", "uniform".
[[nodiscard]] std::string_view to_string(ParametricModel model);
/// The model of such a name; nothing for another.
[[nodiscard]] std::optional<ParametricModel> find_parametric_model(std::string_view name);

}  // namespace microslip
