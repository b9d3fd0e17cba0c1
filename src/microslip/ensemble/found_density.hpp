// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/documents/study/ensemble_plan_file.hpp"
#include "microslip/documents/study/ensemble_result_file.hpp"
#include "microslip/identify/inversion/inversion.hpp"

namespace microslip {

/// Outputs of an identification of an ensemble: area, and where it is identified linear_damping;
/// the density over slip forces, the dissipation over amplitudes.
class FoundDensity {
 public:
  /// @param stiffness       k, N/m.
  /// @param lowest, highest amplitudes of the levels, m.
  /// @param points          of the curves, ≥ 2.
  /// @param linear_damping  whether it is identified.
  FoundDensity(double stiffness, double lowest, double highest, std::size_t points,
               bool linear_damping);

  /// The outputs.
  [[nodiscard]] const std::vector<EnsembleOutput>& outputs() const { return outputs_; }

  /// The values of one result.
  [[nodiscard]] std::vector<double> of(const InversionResult& result) const;

 private:
  double stiffness_;
  bool linear_damping_;
  std::vector<EnsembleOutput> outputs_;
};

/// Options of an identification as planned.
[[nodiscard]] InversionOptions inversion_options(const PlannedIdentification& planned);

}  // namespace microslip
