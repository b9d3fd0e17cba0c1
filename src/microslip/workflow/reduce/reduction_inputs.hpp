// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/documents/levels/test_file.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/io/recordings/recordings.hpp"

namespace microslip {

/// The files that a reduction takes, and how it reads them.
struct ReductionInputs {
  std::string test;                           ///< path of rig.toml, or of model.toml
  std::vector<std::string> recordings;        ///< paths of records or, of a rig, of stepped-sine
                                              ///< tables; one or more
  RecordingReadOptions reading = {};          ///< of the recordings
  std::optional<NamedInput> test_input = {};  ///< rig.toml or model.toml, where it was read before
  std::vector<TestFile> opened = {};          ///< the recordings, where they were opened before
  bool skip_faulty = false;                   ///< leaves out what cannot be read or reduced
  Progress progress = {};                     ///< reports the records
};

}  // namespace microslip
