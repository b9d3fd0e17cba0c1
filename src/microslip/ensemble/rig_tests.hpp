// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/study/ensemble_plan_file.hpp"
#include "microslip/observe/levels.hpp"
#include "microslip/rig/reduction/reduction.hpp"
#include "microslip/rig/setup/stick_state.hpp"
#include "microslip/rig/virtual_test/virtual_measurement.hpp"

/// @file
/// Virtual tests of a rig: records of its sensors, reduced to levels.

namespace microslip {

/// The vibrations of a rig under a sinusoidal force at each number of levels, found once; each test
/// has its own noise and phases of the records. Shared by threads.
class RigTests {
 public:
  /// @param design  with a rig; relative paths are as they are opened.
  /// @param plan    name of its file, for messages.
  /// @throws FileError, FormatError  as the readers of the rig and its joint.
  /// @throws InputError  as measure_virtually() and Reducer; where the rig has no test, no joint,
  ///     no known k, or no noise that is to be scaled; for a sensor that it has not; where a
  ///     vibration is not found.
  RigTests(const DesignPlan& design, const std::string& plan);

  /// The true joint.
  [[nodiscard]] const JointFile& truth() const { return truth_; }
  /// k of the stuck joint, N/m.
  [[nodiscard]] double stiffness() const { return reducers_.front().state().stiffness; }
  /// The lowest amplitude of the joint at any number of levels, m.
  [[nodiscard]] double lowest() const { return lowest_; }
  /// The highest, m.
  [[nodiscard]] double highest() const { return highest_; }
  /// Whether levels lie in equal ratios of the response.
  [[nodiscard]] bool equal_ratios() const { return rig_.test->logarithmic; }
  /// Paths of the rig and of its joint.
  [[nodiscard]] const std::vector<std::string>& files() const { return files_; }
  /// Warnings of the vibrations.
  [[nodiscard]] const std::vector<Warning>& warnings() const { return warnings_; }

  /// Levels of a test, without those whose dissipation is below noise or that have more than two
  /// reversals per cycle.
  /// @param levels   place of the number of levels in the design.
  /// @param noise    factor of the noise of all sensors of the rig.
  /// @param sensors  place of the sensors in the design; 0 where it has none.
  /// @param seed     of the records; the same records for the same seed.
  /// @throws InputError  as Reducer::reduce(), and where no level is left.
  [[nodiscard]] Levels levels(std::size_t levels, double noise, std::size_t sensors,
                              std::uint64_t seed) const;

 private:
  void measure(const DesignPlan& design);
  void make_reducers(const DesignPlan& design, const std::string& plan);

  std::string file_;
  Rig rig_;
  std::vector<std::string> files_;  // of the rig, then of its joint
  JointFile truth_;
  std::vector<VirtualMeasurement> tests_;  // one per number of levels
  StickState state_;                       // of the records
  std::vector<Reducer> reducers_;          // one per choice of sensors
  double lowest_ = 0.0;
  double highest_ = 0.0;
  std::vector<Warning> warnings_;
};

}  // namespace microslip
