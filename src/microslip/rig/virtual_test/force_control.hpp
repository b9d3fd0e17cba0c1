// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/algebra/core.hpp"
#include "microslip/rig/virtual_test/broyden.hpp"

namespace microslip {

/// Brings harmonics of a force to zero by those of the voltage, V ← V − H⁻¹F. It sees measured
/// forces alone: H begins as measured elsewhere and is corrected by what each step did. Internal to
/// rig.
class ForceController {
 public:
  /// @param transfer  H_n, N/V: change of each harmonic of the force over that of the voltage.
  explicit ForceController(Eigen::VectorXcd transfer)
      : transfer_(std::move(transfer)),
        broyden_(transfer_.size()),
        voltage_(Eigen::VectorXcd::Zero(transfer_.size())) {}

  /// The voltages now, V; 0 to begin with.
  [[nodiscard]] const Eigen::VectorXcd& voltage() const { return voltage_; }

  /// The next voltages. @param force  measured under the voltages of now, N.
  const Eigen::VectorXcd& step(const Eigen::VectorXcd& force) {
    const Eigen::VectorXcd scaled = transfer_.cwiseProduct(voltage_);
    voltage_ = broyden_.next(scaled, force).cwiseQuotient(transfer_);
    return voltage_;
  }

 private:
  Eigen::VectorXcd transfer_;
  Broyden broyden_;
  Eigen::VectorXcd voltage_;
};

}  // namespace microslip
