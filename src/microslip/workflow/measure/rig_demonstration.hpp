// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/identify/methods/identification.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/rig/reduction/reduction.hpp"
#include "microslip/rig/reduction/reduction_batch.hpp"
#include "microslip/rig/verification/verification.hpp"
#include "microslip/rig/verification/verification_batch.hpp"
#include "microslip/rig/virtual_test/virtual_measurement.hpp"

/// @file
/// The whole chain on a rig whose joint is known, in memory.

namespace microslip {

/// The records of a test, as files of its folder.
struct VirtualRecords {
  std::vector<std::string> names;                                 ///< "recordings/level_01.csv"
  std::vector<Recording> recordings;                              ///< one a name
  std::vector<std::pair<std::string, Recording>> before_control;  ///< of some levels, with names
};

/// Results of the chain.
struct RigDemonstration {
  Rig rig;                         ///< with the truth
  Joint truth;                     ///< in its contact
  VirtualMeasurement test;         ///< of the rig
  VirtualRecords recordings;       ///< with noise
  Reducer reducer;                 ///< which does not know the truth
  ReductionBatch reduction;        ///< of the recordings
  std::string levels_text;         ///< of levels.csv
  LevelsFile levels;               ///< as read from that text
  IdentificationOptions options;   ///< of the identification
  Identification found;            ///< from the levels
  Verifier verifier;               ///< with the joint found
  VerificationBatch verification;  ///< of the recordings

  /// Whether identification and predictions did.
  [[nodiscard]] bool converged() const;
};

/// The rig without the name of its true joint: what the reduction reads.
[[nodiscard]] Rig without_truth(Rig rig);

/// Virtual test, its records reduced, the joint identified from the levels, the records predicted
/// by it.
/// @param rig       with a [test].
/// @param truth     the joint in its contact.
/// @param seed      of noise, phases and bands.
/// @param progress  makes the progress of a step: "virtual test", "reduction", "bands",
///                  "verification".
/// @throws Cancelled     as a progress says.
/// @throws NothingFound  where the virtual test does not converge.
[[nodiscard]] RigDemonstration demonstrate(const Rig& rig, const Joint& truth, std::uint64_t seed,
                                           const std::function<Progress(const char*)>& progress);

}  // namespace microslip
