// SPDX-License-Identifier: MIT
#include "microslip/workflow/measure/watch_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/workflow/identify/evidence_kind.hpp"
#include "microslip/workflow/identify/identification_text.hpp"
#include "microslip/workflow/identify/levels_identification.hpp"
#include "microslip/workflow/identify/records_identification.hpp"
#include "microslip/workflow/reduce/recordings_reduction.hpp"
#include "microslip/workflow/text/distinct_files.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kRigFile = "rig.toml";
constexpr std::string_view kLevelsFile = "levels.csv";
constexpr std::string_view kJointFile = "joint.json";
constexpr std::string_view kDensityFile = "density.csv";
constexpr std::string_view kNextFile = "next_levels.csv";
constexpr std::string_view kReportFile = "watch.html";
/// By which a file shows that it was written here.
constexpr std::string_view kWatchCommand = "microslip watch";
constexpr std::size_t kRanked = 3;  // levels of next_levels.csv

/// Files that microslip writes into folders of tests, which are no records.
bool is_result_name(std::string_view name) {
  constexpr std::array<std::string_view, 9> kResults{
      kDensityFile,        kNextFile,          "truth.csv",
      "force_control.csv", "calibration.csv",  "identifiability.csv",
      "modal_levels.csv",  "joint_samples.h5", "peaks.csv"};
  return std::ranges::find(kResults, name) != kResults.end() || name.starts_with("verification") ||
         name.starts_with("before_control_");
}

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

bool is_among(const std::vector<std::string>& files, const std::string& path) {
  return std::ranges::find(files, path) != files.end();
}

std::string level_line(const ReducedLevel& level) {
  std::string text = fmt::format("A = {}, D = {:.4g} J", length_text(level.amplitude.value),
                                 level.dissipation.value);
  if (level.secant_stiffness) {
    text += fmt::format(", k_eq = {:.5g} N/m", level.secant_stiffness->value);
  }
  for (const Warning& flag : level.flags) text += ", " + flag.code;
  return text;
}

std::string joint_line(const Identification& found, std::size_t levels) {
  std::string text = levels > 0 ? counted(levels, "level") + ": " : "";
  text +=
      fmt::format("k = {:.5g} N/m, slipping fraction {:.3g} up to {:.4g} N",
                  found.joint.stiffness(), found.joint.density().total().zeroth, found.covered_to);
  for (const Warning& warning : found.warnings) text += ", " + warning.code;
  return text;
}

/// Fault of a call, if any: it ends only that call, as the next file may
/// mend it.
std::optional<std::string> fault_in(const std::function<void()>& call) {
  try {
    call();
    return std::nullopt;
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    return error.what();
  }
}

/// Contents of a complete and valid file.
std::string evidence_line(const std::string& path, bool is_table) {
  if (is_table) {
    const LevelTable table = read_level_table(path, {.assemblies = AssemblyColumn::kRefused});
    return counted(table.used.levels.size(), "level");
  }
  const ForceRecords found = read_force_records({path}, {}, {});
  std::size_t samples = 0;
  for (const NamedForceRecord& record : found.records) samples += record.record.size();
  return fmt::format("{} of force and displacement, {} samples",
                     counted(found.records.size(), "record"), samples);
}

/// Truncated records are not read here: most are short because they are being
/// written. Another command makes a record of it.
std::string as_watch_advises(std::string fault, const std::string& file) {
  constexpr std::string_view kOption = "`allow_truncated`";
  const std::string name = file_name(file);
  const std::string call =
      fmt::format("`microslip convert {} whole_{} --allow-truncated`", name, name);
  for (std::size_t at = 0; (at = fault.find(kOption, at)) != fault.npos; at += call.size()) {
    fault.replace(at, kOption.size(), call);
  }
  return fault;
}

}  // namespace

WatchedTest::WatchedTest(WatchedTestOptions options) : options_(std::move(options)) {
  if (!fs::is_directory(options_.folder)) {
    throw FileError(options_.folder, "is not a folder",
                    "Name the folder in which the records arrive.");
  }
  check_own();
}

std::string WatchedTest::path(const std::string& name) const {
  return (fs::path(options_.folder) / name).string();
}

std::string WatchedTest::report_path() const { return path(std::string(kReportFile)); }

void WatchedTest::check_own() const {
  std::vector<std::string_view> written{kJointFile, kDensityFile, kNextFile, kReportFile};
  if (fs::exists(path(std::string(kRigFile)))) written.push_back(kLevelsFile);
  for (const std::string_view name : written) {
    const std::string file = path(std::string(name));
    if (!fs::exists(file)) continue;
    const bool is_own =
        fs::is_regular_file(file) &&
        (fs::file_size(file) == 0 || read_file(file).find(kWatchCommand) != std::string::npos);
    if (is_own) continue;
    throw InputError(file, "there already",
                     "would be written here, and no file of another program is replaced",
                     "Move it away, or watch a folder with the records alone.");
  }
}

bool WatchedTest::reads(const std::string& name) const {
  if (name == kRigFile) return true;
  if (name == kLevelsFile && fs::exists(path(std::string(kRigFile)))) return false;
  const bool is_record =
      find_recording_format_of_name(name) || name.ends_with(".txt") || name.ends_with(".TXT");
  return is_record && !is_result_name(name);
}

bool WatchedTest::done(const std::function<void()>& call) const {
  const std::optional<std::string> fault = fault_in(call);
  if (fault) options_.tell(WatchedNews::kFault, *fault);
  return !fault;
}

void WatchedTest::tell_left_out(const std::string& file, const std::string& fault) {
  faulty_[file] = fault;
  options_.tell(WatchedNews::kFault,
                fmt::format("{}: {}{} Left out until it changes.", file_name(file),
                            as_watch_advises(fault, file), fault.ends_with('.') ? "" : "."));
}

bool WatchedTest::evaluate(const FolderChange& files) {
  joint_written_ = planned_ = unwritten_ = false;
  if (!done([&] { check_own(); })) return false;
  for (const std::string& file : files.changed) faulty_.erase(file);
  std::vector<std::string> records = files.whole;
  const std::string rig = path(std::string(kRigFile));
  const bool of_a_rig = std::erase(records, rig) > 0;
  if (!of_a_rig && fs::exists(rig)) return false;  // it is being written
  leave_out_repeated(records);
  if (records.empty()) return false;
  if (of_a_rig) {
    (void)done([&] { of_rig(records, files); });
  } else {
    of_evidence(records, files);
  }
  if (joint_written_ && !planned_) forget_plan();
  return joint_written_;
}

/// A link to a record beside it is no further level.
void WatchedTest::leave_out_repeated(std::vector<std::string>& files) {
  std::vector<std::string> kept;
  for (const std::string& file : files) {
    const std::optional<std::string> other = same_file(kept, file);
    if (!other) {
      kept.push_back(file);
    } else if (!faulty_.contains(file)) {
      tell_left_out(file, fmt::format("the same file as {}", file_name(*other)));
    }
  }
  files = std::move(kept);
}

/// One that rests on other evidence than the joint that is there now.
void WatchedTest::forget_plan() const {
  const std::string plan = path(std::string(kNextFile));
  if (!fs::exists(plan) || fs::file_size(plan) == 0) return;
  remove_file(plan);
  options_.tell(
      WatchedNews::kNext,
      fmt::format("{} was for the previous joint, and is removed: there is no plan for this one",
                  kNextFile));
}

void WatchedTest::of_rig(const std::vector<std::string>& files, const FolderChange& change) {
  // All are reduced again when the rig has changed; otherwise faulty files remain faulty.
  if (is_among(change.changed, path(std::string(kRigFile)))) faulty_.clear();
  std::vector<std::string> asked;
  for (const std::string& file : files) {
    if (!faulty_.contains(file)) asked.push_back(file);
  }
  if (asked.empty()) return;
  const ReducedRecordings reduced = reduce_recordings({.test = path(std::string(kRigFile)),
                                                       .recordings = asked,
                                                       .reading = {},
                                                       .skip_faulty = true,
                                                       .progress = options_.progress});
  for (const RejectedRecord& rejected : reduced.batch.rejected) {
    const std::string& file = asked[rejected.index];
    tell_left_out(file, rejected.reason);
  }
  for (const ReducedLevel& level : reduced.batch.levels) {
    for (const std::string& file : change.changed) {
      if (!level.source.starts_with(file)) continue;
      options_.tell(WatchedNews::kRecord,
                    fmt::format("{}{}: {}", file_name(file), level.source.substr(file.size()),
                                level_line(level)));
      break;
    }
  }
  if (reduced.batch.levels.empty()) return;
  write({{kLevelsFile, levels_text(reduced, options_.command)}});
  identify_table(path(std::string(kLevelsFile)),
                 options_.stiffness.value_or(reduced.reducer.state().stiffness));
}

WatchedTest::Kept WatchedTest::sort_out(const std::vector<std::string>& files,
                                        const FolderChange& change) {
  Kept kept;
  for (const std::string& file : files) {
    if (faulty_.contains(file)) continue;
    const std::optional<std::string> fault = fault_in([&] {
      const bool is_table = evidence_kind(open_test(file, Hashed::kNo)) == EvidenceKind::kLevels;
      if (is_among(change.changed, file)) {
        options_.tell(WatchedNews::kRecord,
                      fmt::format("{}: {}", file_name(file), evidence_line(file, is_table)));
      }
      (is_table ? kept.levels : kept.records).push_back(file);
    });
    if (fault) tell_left_out(file, *fault);
  }
  return kept;
}

void WatchedTest::of_evidence(const std::vector<std::string>& files, const FolderChange& change) {
  const Kept kept = sort_out(files, change);
  if (kept.records.empty() && kept.levels.empty()) return;
  if (kept.records.empty() && !options_.stiffness) {
    throw InputError("`stiffness`", InputState{"missing"},
                     "must be given with levels: slip forces are k times A",
                     "Give the stiffness of the stuck joint, for instance from a low-level test.");
  }
  if (kept.records.empty() && kept.levels.size() == 1) {
    (void)done([&] { identify_table(kept.levels.front(), *options_.stiffness); });
  } else {
    (void)done([&] { identify_together(kept); });
  }
}

void WatchedTest::identify_table(const std::string& levels, double stiffness) {
  LevelsIdentification options;
  options.levels = levels;
  options.stiffness = stiffness;
  options.options.bands = BandOptions{.progress = options_.progress};
  const IdentifiedLevels done = identify_levels(options);
  options_.tell(WatchedNews::kJoint, joint_line(done.found, done.count));
  write_joint(joint_text(options, done.found, done.input, options_.command),
              density_csv(done.found, options_.command));
  plan_next(levels, stiffness, done.count);
}

void WatchedTest::identify_together(const Kept& kept) {
  RecordsIdentification options;
  options.records = kept.records;
  options.levels = kept.levels;
  options.stiffness = options_.stiffness;
  options.options.progress = options_.progress;
  const IdentifiedRecords done = identify_records(options);
  options_.tell(WatchedNews::kJoint, joint_line(done.found, 0));
  write_joint(joint_text(options, done, options_.command),
              density_csv(done.found, options_.command));
}

void WatchedTest::write_joint(const std::string& joint, const std::string& density) {
  write({{kJointFile, joint}, {kDensityFile, density}});
  joint_written_ = true;
}

/// All of them or none.
void WatchedTest::write(const std::vector<std::pair<std::string_view, std::string>>& files) {
  try {
    OutputFiles outputs;
    for (const auto& [name, text] : files) outputs.add(path(std::string(name)), text);
    outputs.commit();
  } catch (const FileError&) {
    unwritten_ = true;
    throw;
  }
}

void WatchedTest::plan_next(const std::string& levels, double stiffness, std::size_t count) {
  if (count < kFewestToPlan) {
    options_.tell(WatchedNews::kNext,
                  fmt::format("{} so far: first measure {} or more in equal steps from the "
                              "smallest to the largest amplitude",
                              counted(count, "level"), kFewestToPlan));
    return;
  }
  LevelPlanning planning{.levels = levels, .stiffness = stiffness, .target = options_.target};
  planning.count = kRanked;
  planning.amplitude = options_.amplitude;
  planning.progress = options_.progress;
  const LevelPlan plan = plan_levels(planning);
  write({{kNextFile, plan_text(plan, planning, options_.command)}});
  planned_ = true;
  const DesignedLevel& first = plan.design.levels.front();
  const bool area = options_.target == PlanTarget::kArea;
  options_.tell(WatchedNews::kNext,
                fmt::format("{}; the width of the {} is then {:.3g} instead of {:.3g}{}",
                            length_text(plan.amplitude[first.candidate]), area ? "area" : "density",
                            first.after, first.before, area ? "" : " 1/N"));
}

}  // namespace microslip
