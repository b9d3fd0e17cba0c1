// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/dynamics/harmonic_balance.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/io/model_file.hpp"
#include "microslip/io/recordings.hpp"
#include "microslip/observe/modal_levels.hpp"
#include "microslip/rig/stepped_sine.hpp"
#include "microslip/signal/ring_down.hpp"
#include "microslip/workflow/force_records.hpp"
#include "microslip/workflow/joint_tables.hpp"
#include "microslip/workflow/model_draws.hpp"
#include "microslip/workflow/test_comparison.hpp"

/// @file
/// Files of tests against what a model, or a joint by itself, predicts of them.

namespace microslip {

/// How files of tests are read.
struct TestReading {
  /// Nothing: by what a file holds. A stepped-sine table is a sweep, or of constant response, by
  /// kind_of(); a recording without a displacement beside a force is a ring-down, one with both
  /// loops. Of a table of modal levels kRingDown says that they are those of a decay.
  std::optional<TestKind> kind = {};
  std::vector<std::string> sensors = {};  ///< of recordings of ring-downs: see ModalDecayReduction
  std::vector<std::size_t> modes = {};    ///< of those, from 1; empty: all that there are
  RingDownOptions decay = {};             ///< of recordings of ring-downs
  JointChannels channels = {};            ///< of loops
  RecordingReadOptions reading = {};      ///< of recordings
};

/// A file of tests as it was read.
struct ReadTest {
  std::string path;         ///< as it was named
  std::string digest = {};  ///< SHA-256 of the file
  /// Sweeps, with the kind that is asked for; levels of modes; records of a joint.
  std::variant<std::vector<SteppedSine>, ModalLevels, std::vector<NamedForceRecord>> content;
  bool is_recording = false;           ///< over time, rather than a table
  std::optional<TestKind> kind = {};   ///< where it was asked for
  std::vector<Warning> warnings = {};  ///< of the readers and of the analysis of a ring-down
  bool converged = true;               ///< of a ring-down, to the end of the record or to the noise
};

/// The numbers, from 0, of the levels of some modes.
/// @param levels  of any modes. @param modes  from 1; empty: all.
/// @param path    of the levels, for the message.
/// @throws InputError  naming `mode`, where there are levels and none is of these modes.
[[nodiscard]] std::vector<std::size_t> levels_of_modes(const ModalLevels& levels,
                                                       const std::vector<std::size_t>& modes,
                                                       const std::string& path);

/// @param path     of a recording, `FILE:VARIABLE`, or a table.
/// @param model    that it is a test of; null for a joint by itself, which has loops alone.
/// @param model_path  of the model.
/// @param options  see TestReading.
/// @throws FileError, FormatError, InputError  as the readers; where the file is not of the kind
///     that is asked for, is a pipe, or a joint by itself is to predict a structure.
[[nodiscard]] ReadTest read_test(const std::string& path, const ModelFile* model,
                                 const std::string& model_path, const TestReading& options);

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

/// What the identification of a joint said against it: `joint_not_of_this_kind` for a verdict,
/// `joint_not_converged`.
/// @param path  of the joint. @param file  joint.json. @param warnings  get them behind theirs.
void add_joint_warnings(const std::string& path, const JointFile& file,
                        std::vector<Warning>& warnings);

/// What is to be compared, and how.
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
  Progress progress = {};                      ///< told of the draws of all tests; may cancel
};

/// What came of it.
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
/// @param command  that is told in the heading.
/// @throws FileError, FormatError, InputError  as read_test(), read_model(), read_joint(),
///     compare_sweep(), compare_modal_levels(), compare_loops(), draws_of(); where a file is given
///     twice, or a part of it beside the whole; naming an option that no test uses.
/// @throws Cancelled  as the progress says.
[[nodiscard]] VerifiedTests verify_tests(const TestsVerification& options,
                                         const std::string& command);

}  // namespace microslip
