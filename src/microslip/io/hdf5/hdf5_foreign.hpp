// SPDX-License-Identifier: MIT
#pragma once

#include <hdf5.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "microslip/base/error.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/io/recordings/recordings.hpp"

namespace microslip {

/// Tells how much of a file has been read.
class Hdf5Progress {
 public:
  Hdf5Progress(hid_t file, Progress progress) : progress_(std::move(progress)) {
    hsize_t size = 0;
    if (H5Fget_filesize(file, &size) >= 0) total_ = size;
  }

  /// So many values more. @throws Cancelled
  void add(std::size_t values) {
    done_ = std::min(done_ + sizeof(double) * values, total_);
    if (progress_ && !progress_(done_, total_)) throw Cancelled();
  }

 private:
  Progress progress_;
  std::size_t done_ = 0;
  std::size_t total_ = 0;
};

/// Recordings of a file that another program wrote, see hdf5_recording.hpp.
[[nodiscard]] Recordings read_foreign_hdf5(hid_t file, const std::string& path,
                                           Hdf5Progress& progress,
                                           const RecordingReadOptions& options);

}  // namespace microslip
