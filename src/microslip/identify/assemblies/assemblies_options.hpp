// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"

namespace microslip {

/// How identify_assemblies() solves.
struct AssembliesOptions {
  int coefficients = 56;                       ///< of the density; ≥ 10. More cost time only.
  std::size_t draws = 1000;                    ///< of the posterior; ≥ 100
  double confidence = 0.95;                    ///< of bands and intervals, in (0, 1)
  std::uint64_t seed = 1;                      ///< of the draws
  Execution execution = Execution::threads();  ///< of the chains
  Progress progress = {};                      ///< of the draws

  /// @throws InputError  naming the option that breaks a rule.
  void check() const;
};

}  // namespace microslip
