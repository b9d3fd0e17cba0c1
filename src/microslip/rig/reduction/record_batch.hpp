// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Common parts of computations on the records of many files.

namespace microslip {

/// The records of a file; called from several threads at once.
using RecordReader = std::function<std::vector<Recording>(std::size_t index)>;

/// A file of a batch that could not be read, or a record of it that could not be worked on.
struct RejectedRecord {
  std::size_t index = 0;  ///< of the file
  std::string reason;     ///< text of the error
};

/// How the files of a batch are worked on.
struct RecordBatchOptions {
  /// Leave out files that cannot be read and records that cannot be processed, and list them.
  /// Otherwise the first of them, in the order of the files, ends the batch.
  bool skip_faulty = false;
  Progress progress = {};                      ///< files done of all files
  Execution execution = Execution::threads();  ///< of the files
};

}  // namespace microslip
