// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "microslip/identify/evidence/evidence_verdicts.hpp"
#include "microslip/identify/evidence/joint_evidence.hpp"

/// @file
/// Agreement of a table of levels with the joint of the records, or of all other tables where there
/// are no records.

namespace microslip {

/// Verdicts on a table of levels, measured against the joint of that evidence: D, and k_eq where it
/// was measured. Levels beyond the range of the others are not judged.
struct LevelAgreement {
  std::optional<LevelVerdict> dissipation;
  std::optional<LevelVerdict> secant;
};

/// @param evidence      of one joint. @param table  index of the levels to judge.
/// @param known         k, N/m, where it is known.
/// @param coefficients  of the density.
/// @return nothing where there is no other evidence.
[[nodiscard]] LevelAgreement agreement_of_levels(const JointEvidence& evidence, std::size_t table,
                                                 std::optional<double> known, int coefficients);

}  // namespace microslip
