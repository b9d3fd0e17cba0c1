// SPDX-License-Identifier: MIT
#pragma once

namespace microslip {

/// How the smoothing parameter of the inversion is chosen from its path.
enum class SmoothingRule {
  /// Smallest generalised cross-validation score m·rss/(m − 1.4 edf)². Without the factor of 1.4
  /// [Kim & Gu, J. R. Stat. Soc. B 66 (2004) 337] it takes noise for structure now and then.
  kGcv,
  /// Largest restricted (marginal) likelihood.
  kReml,
};

}  // namespace microslip
