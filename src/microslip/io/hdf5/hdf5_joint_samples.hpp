// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/io/sandbox/parcel.hpp"

/// @file
/// Draws of a joint in HDF5, as a process reads them and hands them over. Internal to io.

namespace microslip {

/// A dataset of a file of draws, by its name and unit.
struct SamplesColumn {
  std::string_view name;
  std::string_view unit;
  std::size_t dimensions;
  bool required;
};
inline constexpr std::array kSamplesColumns{
    SamplesColumn{"slip_displacement", "m", 1, true},
    SamplesColumn{"stiffness_density", "N/m^2", 2, true},
    SamplesColumn{"stiffness", "N/m", 1, true},
    SamplesColumn{"atom_slip_displacement", "m", 1, false},
    SamplesColumn{"atom_weight", "1", 1, false},
    SamplesColumn{"linear_damping", "J/m^2", 1, false},
    SamplesColumn{"viscous", "N*s/m", 1, false},
};

/// Attributes of the file.
inline constexpr const char* kSamplesMethod = "method";
inline constexpr const char* kSamplesSeed = "seed";
inline constexpr const char* kSamplesProvenance = "provenance";

/// Contents of a file, its numbers not yet checked.
struct RawSamples {
  std::string method;
  std::string seed;
  std::string provenance;                    ///< JSON; empty where there is none
  std::vector<std::vector<double>> columns;  ///< of kSamplesColumns; empty where one is not there
  std::vector<std::size_t> sizes;            ///< of stiffness_density
};

template <class Parcel>
void pass(Parcel& parcel, RawSamples& samples) {
  pass(parcel, samples.method);
  pass(parcel, samples.seed);
  pass(parcel, samples.provenance);
  pass(parcel, samples.columns);
  pass(parcel, samples.sizes);
}

/// Read where they are asked for: in a process that may crash, see hdf5_reader.hpp.
/// @throws FormatError  as read_joint_samples().
[[nodiscard]] RawSamples hdf5_joint_samples(const std::string& path, const Progress& progress);

}  // namespace microslip
