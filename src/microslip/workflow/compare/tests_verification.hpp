// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/workflow/compare/comparison.hpp"
#include "microslip/workflow/compare/comparison_reading.hpp"
#include "microslip/workflow/compare/tests_verification_options.hpp"
#include "microslip/workflow/predict/model_draws.hpp"

/// @file
/// Files of tests against what a model, or a joint by itself, predicts of them.

namespace microslip {

/// Compares a test by a model that need not be a file.
/// @param test     as read.
/// @param model    that it is a test of.
/// @param balance  of the predictions.
/// @param spread   of the model; nothing without draws.
/// @param draws    which of them; nothing without.
/// @param joint    of the model, that loops are of; empty: the only one.
/// @param forcing  what drove levels of modes that are no recording; their kind is kRingDown where
///                 that was asked for, else kModalLevels.
/// @throws InputError  as compare_sweep(), compare_modal_levels(), compare_loops(); for a joint
///     that the model does not have.
/// @throws Cancelled   as the progress of the draws says.
[[nodiscard]] std::vector<ComparedTest> compare_test(const ReadTest& test, const ModelFile& model,
                                                     const HarmonicBalanceOptions& balance,
                                                     const std::optional<StructureDraws>& spread,
                                                     const std::optional<TestDraws>& draws,
                                                     const std::string& joint = {},
                                                     Forcing forcing = Forcing::kModal);

/// Objections to a joint from its identification: `joint_not_of_this_kind` for a verdict,
/// `joint_not_converged`.
/// @param path  of the joint. @param file  joint.json. @param warnings  get them behind theirs.
void add_joint_warnings(const std::string& path, const JointFile& file,
                        std::vector<Warning>& warnings);

/// Result of verify_tests().
struct VerifiedTests {
  std::string heading;                   ///< provenance: call, hashes of the inputs
  std::vector<ComparedTest> tests = {};  ///< one or more, in the order of the files
  std::vector<Warning> warnings = {};    ///< of the files and of the identification of the joints
  std::string uncertain = {};            ///< what draws vary, in words; empty without
  bool followed = true;                  ///< whether all ring-downs were followed to their end

  /// Whether all was found.
  [[nodiscard]] bool converged() const;
};

/// Reads the model and the tests, predicts, and compares. Warnings of a joint that was identified
/// with a verdict against it (`joint_not_of_this_kind`), or without convergence
/// (`joint_not_converged`), are among the others; `same_content` where two files hold the same.
/// @param options  see TestsVerification.
/// @param command  for the heading.
/// @throws FileError, FormatError, InputError  as read_test(), read_model(), read_joint(),
///     compare_sweep(), compare_modal_levels(), compare_loops(), draws_of(); where a file is given
///     twice, or a part of it beside the whole; naming an option that no test uses.
/// @throws Cancelled  as the progress says.
[[nodiscard]] VerifiedTests verify_tests(const TestsVerification& options,
                                         const std::string& command);

}  // namespace microslip
