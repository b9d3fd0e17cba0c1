// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "microslip/io/config/named_values.hpp"
#include "microslip/joint/joint.hpp"

/// @file
/// joint_samples.h5, schema microslip.joint_samples/1: posterior draws of a joint.

namespace microslip {

/// Draws of a joint, each as likely as any other. With slip displacements x* = f*/k, which all
/// share, and ψ(x*) = k²φ(kx*) between them linear, draw i is the joint of stiffness k_i and
/// density φ(f*) = ψ_i(f*/k_i)/k_i², with an atom where there is one.
struct JointSamples {
  std::string method = {};  ///< that drew them
  std::uint64_t seed = 0;   ///< of the random numbers

  std::vector<double> slip_displacement = {};  ///< points x*, m; rising, ≥ 0; two or more
  std::vector<double> stiffness_density = {};  ///< ψ, N/m per m; draws × points, by draws; ≥ 0
  std::vector<double> stiffness = {};          ///< k of each draw, N/m; > 0

  std::optional<double> atom_slip_displacement = {};  ///< m; > 0; nothing without an atom
  std::vector<double> atom_weight = {};  ///< of each draw, share of k; empty without one

  std::vector<double> linear_damping = {};  ///< β of each draw, J/m²; ≥ 0; empty where not sought
  std::vector<double> viscous = {};  ///< c of each draw, N s/m; ≥ 0; empty where not sought

  std::optional<Provenance> provenance = {};  ///< how they came to be

  /// How many there are.
  [[nodiscard]] std::size_t size() const { return stiffness.size(); }

  /// Draw i. @throws InputError  where there is none of that number.
  [[nodiscard]] Joint joint(std::size_t i) const;

  /// @throws InputError  naming the value that breaks its rule; where ∫ψ dx* and the atom are more
  ///                     than k, beyond rounding; where there is no draw.
  void check() const;
};

/// The bytes of a file, the same for the same draws.
/// @param samples  as check() demands.
/// @param path     of the file, for messages.
/// @throws InputError  as check(). @throws FileError  in a build without HDF5.
[[nodiscard]] std::string joint_samples_bytes(const JointSamples& samples, const std::string& path);

/// The draws of a file, in a process of their own, as that of recordings.
/// @throws FileError    where it cannot be read, or in a build without HDF5.
/// @throws FormatError  naming file and dataset, where it is not of the schema, or lacks a dataset,
///                      or has one of another shape, or one that it should not have.
/// @throws InputError   naming file, dataset and draw, for a value that breaks its rule.
[[nodiscard]] JointSamples read_joint_samples(const std::string& path);

}  // namespace microslip
