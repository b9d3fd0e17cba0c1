// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/experiment_recordings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/workflow/results/level_records.hpp"

namespace microslip {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostHarmonicValues = 30000;  // of all records: as much again
constexpr std::uintmax_t kMostBytes = 400'000'000;  // of all records: some 10 s
constexpr std::string_view kLevelPrefix = "level_";

/// Recording of the level before force control, "…/before_control_07.csv".
std::string name_before_control(std::string name) {
  return name.replace(name.rfind(kLevelPrefix), kLevelPrefix.size(), "before_control_");
}

/// Reads recordings of a folder into results.
class RecordingsReader {
 public:
  RecordingsReader(std::string folder, std::size_t most_records, ExperimentResults& results)
      : folder_(std::move(folder)), most_records_(most_records), results_(results) {}

  /// All have harmonics unless they are large or many, some are shown over time.
  void read(const Progress& progress) {
    std::vector<std::string> all = recording_names();
    const std::vector<std::string> over_time = selected(all);
    results_.record_count = all.size();
    if (!are_small(all)) all = over_time;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool shown = std::ranges::find(over_time, all[i]) != over_time.end();
      add_level(all[i], shown ? kMostSignalPoints / (2 * over_time.size()) : 0);
      if (progress && !progress(i + 1, all.size())) throw Cancelled();
    }
    drop_harmonics_beyond_measure();
  }

 private:
  /// Those level_*, in the folder or in recordings/ of it.
  [[nodiscard]] std::vector<std::string> recording_names() const {
    std::vector<std::string> names;
    for (const std::string part : {"", "recordings/"}) {
      std::error_code error;
      for (const auto& entry : fs::directory_iterator(folder_ + "/" + part, error)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with(kLevelPrefix) && entry.is_regular_file()) names.push_back(part + name);
      }
    }
    std::ranges::sort(names);
    return names;
  }

  [[nodiscard]] std::string path_of(const std::string& name) const { return folder_ + "/" + name; }

  [[nodiscard]] bool was_controlled(const std::string& name) const {
    std::error_code none;
    return fs::exists(path_of(name_before_control(name)), none);
  }

  /// Those that are shown over time: some, and some that have another one before control.
  [[nodiscard]] std::vector<std::string> selected(const std::vector<std::string>& names) const {
    std::vector<std::string> compared;
    std::ranges::copy_if(names, std::back_inserter(compared),
                         [&](const std::string& name) { return was_controlled(name); });
    std::vector<std::string> all = spread(names, most_records_);
    std::ranges::copy(spread(compared, most_records_), std::back_inserter(all));
    std::ranges::sort(all);
    all.erase(std::ranges::unique(all).begin(), all.end());
    return all;
  }

  void note_file(const std::string& name) {
    results_.files.push_back({name, sha256(read_file(path_of(name))), {}});
  }

  /// Nothing of a recording that cannot be shown, with a warning.
  std::optional<LevelRecord> read_one(const std::string& name, std::size_t most_points) {
    try {
      const Recordings file = microslip::read_recordings(path_of(name), {});
      LevelRecord record = level_record(file.recordings.front(), name, most_points);
      if (const std::size_t count = file.recordings.size(); count > 1) {
        results_.warnings.push_back(
            {"first_recording_shown",
             fmt::format("{} contains {} recordings; the first is shown.", path_of(name), count)});
      }
      note_file(name);
      return record;
    } catch (const Error& error) {
      const std::string text = error.what();
      const bool named = text.find(name) != std::string::npos;
      results_.warnings.push_back(
          {"recording_not_shown", named ? text : fmt::format("{}: {}", path_of(name), text)});
      return std::nullopt;
    }
  }

  /// With what was recorded before control, where there is such a record.
  void add_level(const std::string& name, std::size_t most_points) {
    std::optional<LevelRecord> record = read_one(name, most_points);
    if (!record) {
      --results_.record_count;
      return;
    }
    if (was_controlled(name)) {
      const auto before = read_one(name_before_control(name), most_points);
      if (before) add_other(*before, *record);
    }
    results_.records.push_back(std::move(*record));
  }

  /// Whether reading the records takes some seconds, and not minutes.
  [[nodiscard]] bool are_small(const std::vector<std::string>& names) const {
    std::uintmax_t bytes = 0;
    for (const std::string& name : names) {
      std::error_code none;
      bytes += fs::file_size(path_of(name), none);
    }
    return bytes <= kMostBytes;
  }

  /// The harmonics of all records may be too many for one page.
  void drop_harmonics_beyond_measure() {
    std::size_t numbers = 0;
    for (const LevelRecord& record : results_.records) {
      for (const HarmonicsPair& channel : record.harmonics) numbers += channel.recorded.size();
    }
    if (numbers <= kMostHarmonicValues) return;
    std::erase_if(results_.records, [](const LevelRecord& one) { return one.signals.empty(); });
  }

  std::string folder_;
  std::size_t most_records_;
  ExperimentResults& results_;
};

}  // namespace

void add_recordings(const std::string& folder, std::size_t records, const Progress& progress,
                    ExperimentResults& results) {
  RecordingsReader(folder, records, results).read(progress);
}

}  // namespace microslip
