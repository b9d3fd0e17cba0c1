// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "microslip/documents/study/ensemble_plan_file.hpp"
#include "microslip/ensemble/found_density.hpp"
#include "microslip/ensemble/planned_jobs.hpp"
#include "microslip/ensemble/rig_tests.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/observe/levels.hpp"

namespace microslip {

/// Identifications from virtual tests of a known joint: the error to expect for a number of levels
/// and a noise. Each design, a number of levels with a noise of each kind, is a group; test i has
/// the random numbers i in all of them, so that designs differ only by their parameters.
///
///     A_i* = A_i(1 + σ_A z),  D_i* = max(0, D(A_i)(1 + σ_D z)),  k_i* = k_eq(A_i) + σ_k k z
///
/// With a rig the levels are records of its sensors that are reduced, RigTests; designs differ by
/// the noise of the sensors and by the sensors used.
class DesignJobs : public EnsembleJobs {
 public:
  /// @throws  as make_ensemble_jobs().
  DesignJobs(DesignPlan design, const EnsemblePlan& plan);

  JobResult run(std::size_t group, std::uint64_t index) const override;

 private:
  struct Design {
    std::size_t levels = 0;
    double noise = 0.0;
    double amplitude_noise = 0.0;
    double secant_noise = 0.0;  ///< 0: k_eq is not measured
    // Of a rig:
    std::size_t tests = 0;      ///< place of the number of levels
    double sensor_noise = 1.0;  ///< factor
    std::size_t sensors = 0;    ///< place of the choice
  };

  void take_joint(const std::string& plan);
  void take_rig(const std::string& plan);

  void add_designs();
  void add_rig_designs();
  void add_group(const Design& design);
  [[nodiscard]] std::string name_of(const Design& design) const;
  [[nodiscard]] Levels tested(const Design& design, std::uint64_t index) const;
  [[nodiscard]] std::vector<double> judged(const InversionResult& result,
                                           std::uint64_t index) const;

  DesignPlan plan_;
  std::uint64_t seed_;
  double confidence_;
  std::optional<RigTests> rig_;
  std::optional<Joint> truth_;
  double stiffness_ = 0.0;       ///< k, N/m
  double linear_damping_ = 0.0;  ///< β of the truth, J/m²
  std::optional<FoundDensity> found_;
  std::vector<Design> designs_;
};

}  // namespace microslip
