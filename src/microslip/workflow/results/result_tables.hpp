// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/documents/joint/density_file.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// The files of a test as its results. Internal to workflow.

namespace microslip {

/// verification.csv. @throws FormatError  where a column is missing.
[[nodiscard]] std::vector<ChannelMisfit> comparisons_of(const NamedInput& input);

/// force_control.csv: `level, response_amplitude [m/s^2], before_2 [1] …, after_2 [1] …`.
/// @throws FormatError  where a column is missing.
[[nodiscard]] std::vector<ForceControlLevel> force_control_of(const NamedInput& input);

/// The SHA-256 of each input that the comments of a table name. Empty where they name none.
[[nodiscard]] std::vector<std::string> hashes_in(const NamedInput& input);

/// That of the file of a name, in whatever folder it was; nothing where the table does not name it.
[[nodiscard]] std::optional<std::string> hash_of_input(const NamedInput& input,
                                                       std::string_view name);

/// Whether a table of a density is of that joint, by what it says at its points but those at steps.
[[nodiscard]] bool is_density_of(const DensityTable& table, const Joint& joint);

}  // namespace microslip
