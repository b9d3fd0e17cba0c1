// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/force_paths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/observe/record_force.hpp"
#include "microslip/observe/sensor_drift.hpp"
#include "microslip/workflow/identify/records_identification.hpp"
#include "microslip/workflow/reduce/named_recordings.hpp"

namespace microslip {
namespace {

namespace fs = std::filesystem;

/// Where a file that a joint was identified from is now.
struct FoundInput {
  std::string path = {};  // empty where it is not there
  bool changed = false;   // one of the name is there, with another content
};

FoundInput find_input(const InputHash& input, const std::string& folder) {
  const std::string name = fs::path(input.file).filename().string();
  FoundInput found;
  for (const std::string& path :
       {folder + "/" + name, folder + "/recordings/" + name, input.file}) {
    std::error_code none;
    if (!fs::is_regular_file(part_of_file(path).file, none)) continue;
    if (recording_sha256(path) == input.sha256) return {path, false};
    found.changed = true;
  }
  return found;
}

Warning missing_warning(const InputHash& input, bool changed) {
  if (changed) {
    return {"record_changed", fmt::format("{} is not the file from which joint.json was "
                                          "identified: it is not shown. Identify the joint again.",
                                          input.file)};
  }
  return {"record_missing", fmt::format("{}, from which joint.json was identified, is missing: it "
                                        "is not shown. Copy it next to joint.json.",
                                        input.file)};
}

/// Reads the records of one file after the other.
class ForcePathReader {
 public:
  ForcePathReader(const JointFile& file, std::string folder, ForcePaths& out)
      : file_(file), folder_(std::move(folder)), out_(out) {}

  void read(std::span<const std::size_t> records, const Progress& progress) {
    const std::optional<FoundByRecords> found = identified_joint_of(file_, "joint.json").by_records;
    if (!found || !file_.provenance) return;
    viscous_ = found->viscous ? found->viscous->value : 0.0;
    std::vector<std::size_t> wanted(records.begin(), records.end());
    std::erase_if(wanted, [&](std::size_t record) { return record >= found->records.size(); });
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      add(wanted[i], found->records);
      if (progress && !progress(i + 1, wanted.size())) throw Cancelled();
    }
  }

 private:
  void add(std::size_t record, const std::vector<RecordFound>& found) {
    const double number = found[record].input;
    const std::vector<InputHash>& inputs = file_.provenance->inputs;
    if (!(number >= 1.0 && number <= static_cast<double>(inputs.size()))) return;
    const InputHash& hash = inputs[static_cast<std::size_t>(number) - 1];
    const auto before = static_cast<std::size_t>(
        std::ranges::count(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(record),
                           number, &RecordFound::input));
    try {
      if (number != number_) open(hash, number);
      if (before >= recordings_.size()) return;
      add(record, recordings_[before], found[record]);
    } catch (const Error& error) {
      out_.warnings.push_back({"record_not_shown", error.what()});
    }
  }

  /// Takes the recordings of a file, none where it is not there.
  void open(const InputHash& hash, double number) {
    number_ = number;
    recordings_.clear();
    const FoundInput found = find_input(hash, folder_);
    if (found.path.empty()) {
      out_.warnings.push_back(missing_warning(hash, found.changed));
      return;
    }
    std::vector<Warning> warnings;  // of the identification
    recordings_ = named_recordings(
        read_recordings(found.path, recorded_reading(file_.provenance->options).reading),
        found.path, warnings);
    const bool inside = found.path.starts_with(folder_ + "/");
    out_.files.push_back(
        {inside ? found.path.substr(folder_.size() + 1) : found.path, hash.sha256, {}});
  }

  void add(std::size_t number, const Recording& recording, const RecordFound& found) {
    const ForceRecord record =
        without_drift(force_record(recording, recorded_reading(file_.provenance->options).channels),
                      {.displacement = found.displacement_drift, .force = found.force_drift});
    const bool virgin = found.start == to_string(PathStart::kVirgin);
    const RecordEvidence evidence(record, virgin ? PathStart::kVirgin : PathStart::kUnknown);
    ForcePath path{.record = number,
                   .source = std::string(file_name(recording.source)),
                   .displacement = record.displacement,
                   .path = evidence.path().displacement,
                   .force = record.force,
                   .found = found_force(evidence, file_.joint, viscous_),
                   .displacement_noise = evidence.path().noise,
                   .reversals = evidence.rows().reversals};
    for (std::size_t i = 0; i < record.size(); ++i) path.time.push_back(recording.axis.at(i));
    out_.paths.push_back(std::move(path));
  }

  const JointFile& file_;
  std::string folder_;
  ForcePaths& out_;
  double viscous_ = 0.0;
  double number_ = 0.0;  // of the open file
  std::vector<Recording> recordings_;
};

}  // namespace

ForcePaths read_force_paths(const JointFile& file, const std::string& folder,
                            std::span<const std::size_t> records, const Progress& progress) {
  ForcePaths out;
  ForcePathReader(file, folder, out).read(records, progress);
  return out;
}

}  // namespace microslip
