// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/recording_arguments.hpp"
#include "microslip/workflow/identify/assemblies_identification.hpp"
#include "microslip/workflow/identify/evidence_kind.hpp"
#include "microslip/workflow/identify/levels_identification.hpp"
#include "microslip/workflow/identify/records_identification.hpp"

namespace microslip::app {

/// The options of `identify` as they are typed.
struct IdentifyArguments {
  std::vector<std::string> evidence;
  std::optional<std::string> stiffness;
  std::string out;
  std::string density_csv;
  std::string method = "inversion";
  std::string smoothing = "gcv";
  std::optional<std::string> smoothing_unit;
  std::string linear_damping = "none";
  std::string edges = "sought";
  bool atom = false;
  std::string bands = "0";
  std::optional<std::string> samples;  // the same number of draws for levels and records
  std::string samples_out;
  std::optional<std::string> seed;
  std::string dissipation_gain = "0";
  std::string amplitude_gain = "0";
  std::string loss_factor = "0";
  std::string fit = "none";
  std::string inner_reversals = "leave-out";
  std::optional<std::string> assemblies;

  /// Whether levels are of several assemblies that differ.
  [[nodiscard]] bool of_assemblies() const { return assemblies && *assemblies != "none"; }
  // Of records.
  std::string force;
  std::string displacement;
  std::string start = "auto";
  std::string viscous = "none";
  std::string drift = "none";
  RecordingArguments reading;
};

/// All but the evidence and --quiet.
void add_identify_arguments(CLI::App& command, IdentifyArguments& arguments);

/// The files of each kind.
struct EvidenceFiles {
  std::vector<std::string> levels;
  std::vector<TestFile> records;

  /// Whether there is one table of levels and nothing else.
  [[nodiscard]] bool one_table() const { return levels.size() == 1 && records.empty(); }
};

/// Opens the files and sorts them by their content.
/// @throws FileError, FormatError  as open_test() and evidence_kind().
[[nodiscard]] EvidenceFiles evidence_files(const IdentifyArguments& arguments);

/// Options for one table of levels.
/// @throws InputError  for an option that cannot be read, options that exclude each other, or one
///                     for records.
[[nodiscard]] LevelsIdentification levels_options(const IdentifyArguments& arguments, bool quiet);

/// Options for records, for records and levels, or for several tables of levels.
/// @throws InputError  as above, or for an option for a single table of levels.
[[nodiscard]] RecordsIdentification records_options(const IdentifyArguments& arguments,
                                                    const EvidenceFiles& files, bool quiet);

/// Options for levels of several assemblies.
/// @throws InputError  as above, or for an option for a single joint; for a record.
[[nodiscard]] AssembliesIdentification assemblies_options(const IdentifyArguments& arguments,
                                                          const EvidenceFiles& files,
                                                          const Call& call);

}  // namespace microslip::app
