// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/workflow/compare/comparison_reading.hpp"
#include "microslip/workflow/predict/joint_tables.hpp"
#include "microslip/workflow/predict/model_draws.hpp"

namespace microslip {

/// Inputs and options of verify_tests().
struct TestsVerification {
  std::string model;                    ///< path of model.toml, or of joint.json for loops
  std::vector<std::string> tests = {};  ///< paths
  TestReading reading = {};             ///< of them
  std::string joint = {};               ///< of the model, for loops; empty: the only one
  /// Of the predictions of structures; nothing: those of HarmonicBalanceOptions.
  std::optional<std::size_t> harmonics = {};
  std::optional<DrawOptions> draws = {};  ///< nothing: no bands
  /// Of a joint by itself; a model says in its file what is uncertain.
  JointUncertainty uncertain = {};
  Execution execution = Execution::threads();  ///< of the draws
  Progress progress = {};                      ///< reports the draws of all tests; may cancel
};

}  // namespace microslip
