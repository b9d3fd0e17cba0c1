// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <span>

#include "microslip/base/progress.hpp"
#include "microslip/bindings/python/structure.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"

namespace microslip::python {

/// A balance with the model by which its curves are checked: each has the warnings of the program,
/// on missing modes and harmonics, joints beyond their levels, no resonance.
struct JudgedBalance {
  SharedModel model;
  HarmonicBalance balance;

  /// HarmonicBalance::follow() over the frequency, rad/s.
  [[nodiscard]] ResponseCurve follow_frequency(const Target& kept, double from, double to,
                                               const Progress& progress) const;
  /// HarmonicBalance::resonances(), or backbone().
  [[nodiscard]] ResponseCurve follow_backbone(std::span<const double> responses, std::size_t mode,
                                              bool through_folds, const Progress& progress) const;
};

/// A curve as the package takes it.
[[nodiscard]] pybind11::dict curve_dict(const ResponseCurve& curve);

}  // namespace microslip::python
