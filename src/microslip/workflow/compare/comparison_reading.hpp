// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/levels/test_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/observe/modal_levels.hpp"
#include "microslip/rig/reduction/stepped_sine.hpp"
#include "microslip/signal/decay/ring_down.hpp"
#include "microslip/workflow/compare/comparison.hpp"
#include "microslip/workflow/reduce/force_records.hpp"

/// @file
/// Files of tests of a structure or of a joint, read to be compared.

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
/// As above, of a file that was opened before.
[[nodiscard]] ReadTest read_test(const TestFile& file, const ModelFile* model,
                                 const std::string& model_path, const TestReading& options);

}  // namespace microslip
