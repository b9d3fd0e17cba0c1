// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/identify/methods/identification.hpp"
#include "microslip/identify/records/drift_fit.hpp"
#include "microslip/identify/records/record_start.hpp"
#include "microslip/io/config/named_values.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/workflow/reduce/force_records.hpp"
#include "microslip/workflow/reduce/level_table.hpp"

/// @file
/// Recordings of force and displacement, and tables of levels with them, to joint.json and
/// density.csv.

namespace microslip {

/// Inputs and options of identify_records().
struct RecordsIdentification {
  std::vector<std::string> records = {};  ///< paths of recordings of one joint
  std::vector<TestFile> opened = {};      ///< the records, where they were opened before
  std::vector<std::string> levels = {};   ///< paths of tables of its levels, levels.csv
  JointChannels channels = {};            ///< of each of them
  std::optional<double> stiffness = {};   ///< k of the stuck joint, N/m; found without it
  std::optional<PathStart> start = {};    ///< of each of them; by what it shows without it
  bool fit_drift = false;                 ///< whether drifts of their sensors are sought
  RecordInversionOptions options = {};    ///< of the method
  RecordingReadOptions reading = {};      ///< of the recordings
  bool use_inner_reversals = false;       ///< of the levels, as LevelTableOptions
  AssemblyColumn assemblies = AssemblyColumn::kUnsaid;  ///< of the levels
  /// The texts of the units that `reading` assumes, for joint.json.
  std::vector<std::string> assumed_units = {};
  std::string samples_out = {};  ///< file that the draws go to; empty for none
};

/// A record as evidence of a joint: with the state that it begins in, and without the drift of its
/// sensors where that is sought.
struct ReadyRecord {
  RecordEvidence evidence;             ///< without the drift
  RecordStart start = {};              ///< detected where not given
  std::optional<DriftFit> drift = {};  ///< that was subtracted; nothing where none was sought
};

/// @param record   as measured.
/// @param options  of the identification.
/// @throws InputError  as check_records().
[[nodiscard]] ReadyRecord ready_record(const ForceRecord& record,
                                       const RecordsIdentification& options);

/// Where the evidence of a joint comes from, and how its records were read. Vectors of records have
/// one entry each, in the order of the evidence.
struct EvidenceSources {
  std::vector<std::string> records = {};            ///< of each record: file, or name
  std::vector<double> input = {};                   ///< number of the file of each record, from 1
  std::vector<RecordStart> start = {};              ///< of each record; detected where not given
  std::vector<std::optional<DriftFit>> drift = {};  ///< of each record, as ReadyRecord::drift
  std::vector<std::string> tables = {};             ///< of each table of levels: file, or name
  std::vector<std::size_t> levels = {};             ///< of each: how many were used
  std::vector<InputHash> inputs = {};               ///< the files
};

/// Records and tables of levels of one joint as identify_evidence() takes them.
struct SourcedEvidence {
  std::vector<RecordEvidence> records = {};  ///< each record, with its state and without its drift
  std::vector<LevelEvidence> levels = {};    ///< each table
  EvidenceSources from = {};                 ///< of records and tables, in the same order

  /// Adds a record. Its file, of which it may be one of several, is for the caller to hash.
  /// @throws InputError  as ready_record(), naming the record.
  void add(const NamedForceRecord& record, const RecordsIdentification& options);

  /// Adds a table of levels, which is for the caller to hash.
  /// @param name  of the table. @param table  its levels.
  /// @throws InputError  as LevelEvidence, naming the table.
  void add(const std::string& name, const Levels& table);
};

/// Result of identify_records() and identify_evidence().
struct IdentifiedRecords {
  EvidenceSources from = {};  ///< of its evidence
  Identification found;       ///< with warnings of the files, too
};

/// Warning `drift_uncertain` of each record whose drift was subtracted and that is of no Masing
/// joint even so: wear or a changing load looks like a drift of the sensors, too.
/// @param done  with its joint and drifts.
[[nodiscard]] std::vector<Warning> drift_warnings(const IdentifiedRecords& done);

/// Identifies the joint of evidence that was read before.
/// @param evidence  of one joint.
/// @param options   k of the stuck joint and those of the method; the rest was for the evidence.
/// @throws InputError  as identify().
/// @throws Cancelled   as the progress of the options says.
[[nodiscard]] IdentifiedRecords identify_evidence(SourcedEvidence evidence,
                                                  const RecordsIdentification& options);

/// Reads recordings and levels and identifies the joint, as identify_evidence().
/// @throws FileError, FormatError  as read_recordings() and read_level_table().
/// @throws InputError  as read_force_records() and identify(); where there is no recording.
/// @throws Cancelled   as the progress of the options says.
[[nodiscard]] IdentifiedRecords identify_records(const RecordsIdentification& options);

/// How records were read that a joint was identified from.
struct RecordedReading {
  JointChannels channels = {};        ///< of each of them
  RecordingReadOptions reading = {};  ///< of their files
};

/// As the options in its joint.json say.
/// @throws InputError  as parse_assumed_units().
[[nodiscard]] RecordedReading recorded_reading(const NamedValues& options);

/// Contents of joint.json.
/// @param options  that it was found with.
/// @param done     what was found.
/// @param command  that the file is made by.
[[nodiscard]] JointFile identified_joint(const RecordsIdentification& options,
                                         const IdentifiedRecords& done, std::string_view command);

/// The text of joint.json; the rest as of identified_joint().
[[nodiscard]] std::string joint_text(const RecordsIdentification& options,
                                     const IdentifiedRecords& done, std::string_view command);

/// The bytes of joint_samples.h5, for options.samples_out; the rest as of joint_text().
/// @throws FileError  as joint_samples_bytes().
[[nodiscard]] std::string samples_bytes(const RecordsIdentification& options,
                                        const IdentifiedRecords& done, std::string_view command);

/// The summary.
[[nodiscard]] std::string describe_identified_records(const IdentifiedRecords& done);

}  // namespace microslip
