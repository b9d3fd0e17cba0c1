// SPDX-License-Identifier: MIT
#pragma once

namespace microslip {

/// Formats that recordings are read and written in.
enum class RecordingFormat {
  kCsv,        ///< comma-separated text, recording_csv.hpp
  kUff,        ///< universal file, datasets 58 in text
  kUffBinary,  ///< universal file, datasets 58b
  kMat,        ///< MATLAB
  kMat73,      ///< MATLAB 7.3, which is HDF5, read alone
  kHdf5,       ///< HDF5
  kTdms,       ///< TDMS of LabVIEW, read alone
  kLvm,        ///< LVM of LabVIEW, read alone
  kWav,        ///< WAV, read alone
};

}  // namespace microslip
