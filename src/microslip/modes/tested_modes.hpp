// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/documents/structure/tested_structure.hpp"
#include "microslip/structure/modal_model.hpp"
#include "microslip/structure/structural_matrices.hpp"

/// @file
/// Modes of a test at its measured degrees of freedom. Internal to modes.

namespace microslip {

/// Modes at the degrees of freedom that were measured.
struct TestedModes {
  std::vector<DegreeOfFreedom> freedoms;  ///< each once
  std::vector<Mode> modes;                ///< rising in ω; loss factors as measured
  Eigen::MatrixXd shapes;                 ///< mass-normalised, kg^−½: freedoms × modes
  DampingLaw law = DampingLaw::kViscous;  ///< of the modes
  std::vector<std::string> origin;        ///< lines on their origin, for the user
  std::vector<std::string> lines;         ///< one per mode: how it was measured
  std::vector<Warning> warnings = {};     ///< what the user must know
  Summary summary = {};                   ///< of the fit
};

/// How far the values z of a shape are from one phase: 1 for a real mode, whatever its phase,
///
///     ((S_xx − S_yy)² + 4S_xy²)/(S_xx + S_yy)²,   S_xy = Σ Re z Im z
///
/// the modal phase collinearity [Pappa et al.]. 1 for less than two values.
[[nodiscard]] double phase_collinearity(const Eigen::VectorXcd& shape);

/// Options of the modes of a test.
struct TestedModesOptions {
  std::optional<std::size_t> count = {};  ///< the lowest so many; of responses so many are searched
  bool damping_given = false;             ///< by the user: that of the test may be missing
};

/// Modes of datasets 55 and 2414: φ = ψ/√m by the modal mass, of complex modes the real part of
/// ψ √(2iω_d/a) by modal A, once its phase is that of most of it.
/// @throws InputError  naming the mode, where it has no modal mass, damping, units, or other nodes.
[[nodiscard]] TestedModes modes_of_shapes(const TestedStructure& test,
                                          const TestedModesOptions& options);

/// Modes of frequency responses by fit_responses(): φ_d = √R_d at the drive point, φ_j = R_j/φ_d.
/// Where a response to the force at the drive point is missing, that of the drive point to a force
/// there is used, which is equal.
/// @throws InputError  naming the drive point or the response, and as fit_responses().
[[nodiscard]] TestedModes modes_of_responses(const TestedStructure& test,
                                             const TestedModesOptions& options);

/// Warns of a mode that is not real. `phase` of its residue, rad; `code` of the warning.
void warn_of_complexity(const std::string& mode, double collinearity, double phase,
                        std::vector<Warning>& warnings);

/// "node 12 x".
[[nodiscard]] std::string freedom_name(const DegreeOfFreedom& freedom);

/// "mode 3 (12.5 Hz)": a mode by its number from 0.
[[nodiscard]] std::string mode_name(std::size_t number, double hertz);

}  // namespace microslip
