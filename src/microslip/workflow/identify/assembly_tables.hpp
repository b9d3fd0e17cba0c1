// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/identify/assemblies/assemblies.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/workflow/identify/assembly_levels.hpp"

/// @file
/// Assemblies as tables and draws.

namespace microslip {

/// assemblies.csv: a row each.
[[nodiscard]] CsvWriter assemblies_table(const AssembliesResult& found, const AssemblyLevels& read);

/// densities.csv: `common`, `next` and each assembly, one below the other.
[[nodiscard]] CsvWriter densities_table(const AssembliesResult& found);

/// The draws of the next assembly.
[[nodiscard]] JointSamples samples_of_next(const AssembliesResult& found,
                                           const Provenance& provenance);

}  // namespace microslip
