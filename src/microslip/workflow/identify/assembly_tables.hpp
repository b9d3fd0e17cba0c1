// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/identify/assemblies/assemblies.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/config/named_values.hpp"
#include "microslip/workflow/identify/assembly_levels.hpp"

/// @file
/// Assemblies in files.

namespace microslip {

/// Record for joint.json of the mean assembly: spreads, assumptions, warnings.
[[nodiscard]] NamedValues record_of_assemblies(const AssembliesResult& found);

/// Record for the joint.json of one assembly. @param assembly  from 0.
[[nodiscard]] NamedValues record_of_assembly(const AssembliesResult& found, std::size_t assembly);

/// assemblies.csv: a row each.
[[nodiscard]] CsvWriter assemblies_table(const AssembliesResult& found, const AssemblyLevels& read);

/// densities.csv: `common`, `next` and each assembly, one below the other.
[[nodiscard]] CsvWriter densities_table(const AssembliesResult& found);

/// The draws of the next assembly.
[[nodiscard]] JointSamples samples_of_next(const AssembliesResult& found,
                                           const Provenance& provenance);

}  // namespace microslip
