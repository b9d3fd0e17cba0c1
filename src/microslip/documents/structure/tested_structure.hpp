// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/responses/uff_responses.hpp"
#include "microslip/io/uff/uff55.hpp"
#include "microslip/structure/modal_model.hpp"

/// @file
/// Test data of a STRUCTURE.toml in place of matrices.

namespace microslip {

/// Mode shapes of a test, or the frequency responses that modes are to be found in.
struct TestedStructure {
  std::string file;                                ///< of shapes or responses, as it was named
  std::vector<UffModeShape> shapes = {};           ///< of datasets 55 and 2414; or
  std::vector<FrequencyResponse> responses = {};   ///< of datasets 58, or of channels
  std::string_view kept_as = "dataset 58";         ///< the responses in the file
  std::optional<DegreeOfFreedom> drive = {};       ///< where the force acts; always with responses
  std::optional<std::array<double, 2>> band = {};  ///< of the responses that is looked at, Hz
  std::vector<double> start_frequency = {};        ///< of the modes, Hz; empty: they are searched
  DampingLaw law = DampingLaw::kViscous;           ///< of the modes in the responses
  std::vector<double> modal_mass = {};   ///< kg, in place of those of the shapes; one per shape
  std::optional<UnitSystem> units = {};  ///< of shapes without dataset 164
  std::vector<Warning> warnings = {};    ///< of the reader
};

}  // namespace microslip
