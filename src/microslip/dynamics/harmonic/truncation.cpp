// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/truncation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

HarmonicBalance finer(const HarmonicBalance& balance, std::size_t harmonics) {
  HarmonicBalanceOptions options = balance.options();
  options.harmonics = harmonics;
  options.samples = std::max(options.samples, 4 * harmonics + 4);
  return {balance.structure(), balance.response(), options};
}

}  // namespace

std::optional<Truncation> judge_truncation(const HarmonicBalance& balance,
                                           const ResponseCurve& curve, Quantity kept) {
  if (curve.points.empty() || balance.structure().joints().empty()) return std::nullopt;
  const std::size_t harmonics = 2 * balance.options().harmonics + 1;
  try {
    return Truncation{solve_again(finer(balance, harmonics), curve, kept), harmonics};
  } catch (const InputError& error) {  // too many joints for so many harmonics
    Truncation unknown{{}, harmonics};
    unknown.unsolved = error.what();
    return unknown;
  }
}

std::optional<Warning> truncation_warning(const Truncation& truncation) {
  if (truncation.largest() > kTruncationAllowed) {
    return Warning{
        "truncated",
        fmt::format(
            "with {0} harmonics the dissipation of '{1}' changes by {2:.2g} %, the level by "
            "{3:.2g} % and the frequency by {4:.2g} %, most at the response {5:.4g} {7}, "
            "{6:.6g} Hz: take {0} harmonics",
            truncation.harmonics, truncation.joint, 100.0 * truncation.dissipation,
            100.0 * truncation.level, 100.0 * truncation.frequency, truncation.worst_response,
            truncation.worst_frequency, truncation.response_unit)};
  }
  if (truncation.unsolved) {
    return Warning{
        "truncation_unknown",
        fmt::format("whether the harmonics suffice could not be checked everywhere: with "
                    "{} of them: {}",
                    truncation.harmonics, *truncation.unsolved)};
  }
  return std::nullopt;
}

}  // namespace microslip
