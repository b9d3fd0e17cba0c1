// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/algebra/eigenvalues.hpp"
#include "microslip/base/random.hpp"

/// @file
/// A chain of unequal masses and springs whose matrices are known, and what a test of it writes to
/// a universal file: frequency responses that are solved for at each frequency, and mode shapes.

namespace microslip::test {

/// Masses 1, 2, … along z, nodes of the same numbers, fixed at the first end; C = αM + βK, so that
/// modes are real.
struct TestedChain {
  std::size_t masses = 5;
  double mass_damping = 0.5;        ///< α, 1/s
  double stiffness_damping = 2e-5;  ///< β, s
  double loss_factor = 0.0;         ///< η of K, in place of both where it is not 0
  double damper_at_end = 0.0;       ///< Ns/m, from the last mass to the ground: modes get complex

  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(masses); }

  [[nodiscard]] Eigen::MatrixXd mass() const;

  [[nodiscard]] Eigen::MatrixXd stiffness() const;

  [[nodiscard]] Eigen::MatrixXd damping() const;

  /// Of K − ω²M: ω² rising, shapes of unit modal mass.
  [[nodiscard]] Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes() const;

  /// η of a mode, 2ζ = α/ω + βω where damping is viscous.
  [[nodiscard]] double loss_of(double omega) const;

  /// (iω)^p (K − ω²M + iωC)⁻¹ to a force at mass `drive`, from 0; rows frequencies, columns masses.
  [[nodiscard]] Eigen::MatrixXcd responses(const std::vector<double>& hertz, std::size_t drive,
                                           int derivatives) const;
};

/// From, step, and how many.
std::vector<double> even_frequencies(double from, double step, std::size_t count);

/// To each column noise of this share of its rms.
void add_noise(double share, std::uint64_t seed, Eigen::MatrixXcd& responses);

/// Header of a dataset 58 of a frequency response.
struct UffResponse {
  long long response = 1;
  long long reference = 1;
  int response_direction = 3;
  int reference_direction = 3;
  int derivatives = 2;
  std::array<std::string, 3> units = {"m", "m/s", "m/s^2"};  ///< of the motion
  std::string force_unit = "N";
  int function_type = 4;
};

/// Dataset 58, even and double, over the first two frequencies' step.
std::string response_dataset(const UffResponse& of, const std::vector<double>& hertz,
                             const Eigen::VectorXcd& values);

/// The datasets 58 of all masses to a force at mass `drive`, from 0.
std::string response_datasets(const TestedChain& chain, const std::vector<double>& hertz,
                              std::size_t drive, int derivatives, double noise = 0.0);

/// Dataset 164: so many of its units in a metre and a newton.
std::string units_dataset(double per_metre, double per_newton);

/// Header of a dataset 55.
struct UffShape {
  int analysis = 2;  ///< 2 normal, 3 complex
  int specific_type = 8;
  int number = 1;
  std::vector<double> reals;  ///< of record 8
};

/// Dataset 55 of the masses' motions along z, three values a node.
std::string shape_dataset(const UffShape& of, const Eigen::VectorXcd& values);

/// Dataset 2414 of the same, in records 1 to 15 of the format's public description; modal data in
/// the fields of a normal mode, or those of a complex one.
std::string analysis_dataset(const UffShape& of, const Eigen::VectorXcd& values);

}  // namespace microslip::test
