// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/draw_arguments.hpp"
#include "arguments/recording_arguments.hpp"

/// @file
/// `verify` by a model.toml, or by a joint.json: tests of any kind against what it predicts.

namespace microslip::app {

/// Options of such tests only.
struct TestArguments {
  std::string kind;
  std::vector<std::string> sensors;
  std::vector<std::size_t> modes;
  std::string force;
  std::string displacement;
  std::string joint;
};

/// --kind, --sensor, --mode, --force, --displacement, --joint.
void add_test_arguments(CLI::App& command, TestArguments& arguments);

/// Inputs and options of a comparison of such tests.
struct TestsCall {
  std::string model;               ///< path of model.toml or joint.json
  std::vector<std::string> tests;  ///< paths
  std::string out;
  std::string picture;
  std::optional<std::size_t> harmonics;
  TestArguments arguments;
  RecordingArguments reading;
  JointDrawArguments drawn;
};

/// @return the exit status. @throws Error  as verify_tests().
[[nodiscard]] int run_of_tests(const TestsCall& options, const Call& call);

}  // namespace microslip::app
