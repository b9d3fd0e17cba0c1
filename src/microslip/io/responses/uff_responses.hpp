// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/responses/frequency_response.hpp"

/// @file
/// Frequency responses from universal files: datasets 58 and 58b of the function type 4.

namespace microslip {

/// A system of units.
struct UnitSystem {
  double length = 1.0;  ///< m
  double force = 1.0;   ///< N
};

/// Frequency responses of a file.
struct FrequencyResponses {
  std::vector<FrequencyResponse> responses;  ///< at least one, in the order of the file
  std::vector<Warning> warnings;             ///< what the reader had to forgive
};

/// Reads all frequency responses of a file; other functions and datasets are skipped, and lines at
/// 0 Hz.
/// @param path       of the file.
/// @param otherwise  units of values without a label in a file without dataset 164.
/// @throws FormatError  where the file is not of this form or has no frequency response.
/// @throws InputError   naming the dataset, where a response has no node or direction, no unit, is
///                      not a motion over a force, is real, not finite or over no rising frequency.
/// @throws FileError    where it cannot be read.
[[nodiscard]] FrequencyResponses read_responses_uff(
    const std::string& path, const std::optional<UnitSystem>& otherwise = {});

}  // namespace microslip
