// SPDX-License-Identifier: MIT
#include "microslip/workflow/measure/measurement_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string_view>
#include <system_error>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/base/version.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/response/virtual_measurement_file.hpp"
#include "microslip/documents/structure/rig_writer.hpp"
#include "microslip/io/bytes/named_file.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/io/output/output_folders.hpp"
#include "microslip/io/recordings/recording_csv.hpp"
#include "microslip/rig/setup/rig_structure.hpp"
#include "microslip/rig/virtual_test/virtual_record.hpp"
#include "microslip/workflow/measure/rig_demonstration.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/text/named_rig.hpp"
#include "microslip/workflow/text/nothing_found.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestInput = std::size_t{1} << 26U;

/// Provenance of the test.
struct MeasurementInputs {
  Rig rig;
  Joint joint;
  double linear_damping;  ///< β of the joint, J/m²
  std::string joint_path;
  std::string provenance;  ///< lines
};

MeasurementInputs read_inputs(const MeasurementRun& options) {
  const NamedInput rig_input{options.rig, read_text(options.rig, kLargestInput)};
  Rig rig = parse_rig(rig_input);
  const std::string joint_path = true_joint_path(rig, options.rig);
  if (!fs::exists(joint_path)) {
    throw InputError(input_name(options.rig) + ": contact.joint", "'" + joint_path + "'",
                     "must be there", "The path is relative to the folder of the rig.");
  }
  const NamedInput joint_input{joint_path, read_text(joint_path, kLargestInput)};
  JointFile joint = parse_joint(joint_input.text, joint_path);
  const double damping = identified_damping(joint).value_or(0.0);
  std::string provenance =
      fmt::format("{}\nvirtual test, seed {}",
                  provenance_of(options.command, {rig_input, joint_input}), options.seed);
  if (damping > 0.0) provenance += "\nlinear damping of the joint: " + damping_text(damping);
  return {std::move(rig), std::move(joint.joint), damping, joint_path, std::move(provenance)};
}

constexpr std::string_view kLevel = "level";
constexpr std::string_view kBeforeControl = "before_control";
constexpr std::string_view kForceControlFile = "force_control.csv";

/// Whether a file is named as one that this command can write for each level, of any format.
bool is_named_as_record(const fs::path& path) {
  constexpr std::array<std::string_view, 4> kEndings{".csv", ".uff", ".mat", ".h5"};
  const std::string name = path.filename().string();
  const bool stem = name.starts_with(fmt::format("{}_", kLevel)) ||
                    name.starts_with(fmt::format("{}_", kBeforeControl));
  return stem && std::ranges::find(kEndings, path.extension().string()) != kEndings.end();
}

/// The names of the records.
class RecordNames {
 public:
  RecordNames(const MeasurementRun& options, std::size_t levels)
      : format_(*find_recording_format(options.format)),
        ending_(options.format == "uff-ascii" ? "uff" : options.format),
        width_(std::max<std::size_t>(2, fmt::formatted_size("{}", levels))),
        levels_(levels) {}

  [[nodiscard]] RecordingFormat format() const { return format_; }
  [[nodiscard]] std::size_t levels() const { return levels_; }
  [[nodiscard]] std::string name(std::string_view stem, std::size_t number) const {
    return fmt::format("{}_{:0{}}.{}", stem, number, width_, ending_);
  }
  [[nodiscard]] std::vector<std::string> all(std::string_view stem) const {
    std::vector<std::string> names;
    for (std::size_t i = 1; i <= levels_; ++i) names.push_back(name(stem, i));
    return names;
  }

 private:
  RecordingFormat format_;
  std::string ending_;
  std::size_t width_;
  std::size_t levels_;
};

/// The kind of a record. That of a CSV lies in its columns, which are the channels of the rig.
std::string record_kind(const Rig& rig, RecordingFormat format) {
  if (format != RecordingFormat::kCsv) return std::string(recording_kind(format));
  Recording recording;
  const auto add = [&](const std::string& name, const Dimension& dimension) {
    recording.channels.push_back({name, dimension, {0.0, 0.0}, {}, {}});
  };
  add(rig.excitation.channel, kForce);
  for (const RigSensor& sensor : rig.accelerometers) add(sensor.channel, kAcceleration);
  if (rig.vibrometer) add(rig.vibrometer->channel, kLength);
  recording.axis.step = 1.0;
  return file_kind(format_recording_csv(recording));
}

/// Records that the test writes: all levels, or those that converged.
std::vector<std::string> record_names(const MeasurementRun& options, const RecordNames& names,
                                      std::size_t levels,
                                      const std::function<bool(std::size_t)>& is_found) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < levels; ++i) {
    if (!is_found(i)) continue;
    all.push_back(names.name(kLevel, i + 1));
    if (options.before_control) all.push_back(names.name(kBeforeControl, i + 1));
  }
  return all;
}

/// Refuses files of another test, which would be taken for a part of this one.
void check_strangers(const MeasurementRun& options, const std::vector<std::string>& records) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(options.out, error)) {
    const std::string name = entry.path().filename().string();
    const bool stranger = is_named_as_record(entry.path())
                              ? std::ranges::find(records, name) == records.end()
                              : name == kForceControlFile && options.no_shaker;
    if (!stranger) continue;
    throw InputError("`out`", options.out,
                     fmt::format("must not contain {}, of another test", name),
                     "Choose another folder, or remove it.");
  }
}

/// Whether rig.toml in the folder of the test is the rig that is tested.
bool keeps_rig(const MeasurementRun& options) {
  std::error_code error;
  return fs::equivalent(fs::path(options.out) / "rig.toml", options.rig, error);
}

/// Recordings of a laboratory have the names and the form of those of a virtual test; what tells
/// the folder of one is its truth.csv.
void check_origin(const MeasurementRun& options, std::vector<std::string> written) {
  const fs::path truth = fs::path(options.out) / "truth.csv";
  std::error_code error;
  if (fs::is_regular_file(truth, error) && read_file(truth.string()).starts_with("# microslip")) {
    return;
  }
  written.insert(written.end(), {"truth.csv", std::string(kForceControlFile)});
  if (!keeps_rig(options)) written.emplace_back("rig.toml");
  for (const std::string& name : written) {
    if (!fs::exists(fs::path(options.out) / name, error)) continue;
    throw InputError("`out`", options.out,
                     fmt::format("must not contain {} that is not of a virtual test", name),
                     "Choose another folder, or move it away.");
  }
}

/// Before the computation: a folder that is there must take the files.
void check_folder(const MeasurementRun& options, const Rig& rig, const RecordNames& names) {
  if (options.out.empty() || options.out == "-") {
    throw InputError("`out`", "'" + options.out + "'", "must be a folder",
                     "One file per level and the exact results are written to it.");
  }
  const fs::file_status status = fs::status(options.out);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status)) {
    throw FileError(options.out, "is a file", "Name a folder with `out`.");
  }
  const std::vector<std::string> records =
      record_names(options, names, names.levels(), [](std::size_t) { return true; });
  check_strangers(options, records);
  const auto check = [&](Replacing replacing) {
    const auto check_one = [&](std::string_view name, std::string_view kind) {
      check_output((fs::path(options.out) / name).string(), kind, replacing);
    };
    check_one("truth.csv", kLevelsKind);
    if (!keeps_rig(options)) check_one("rig.toml", kRigKind);
    if (!options.no_shaker) check_one(kForceControlFile, kForceControlKind);
    const std::string kind = record_kind(rig, names.format());
    for (const std::string& name : records) check_one(name, kind);
  };
  // Of files that are not of a virtual test, check_origin() says more than that they are not of
  // microslip.
  check(Replacing::kSame);
  check_origin(options, records);
  check(Replacing::kOwn);
}

/// After it: something must have been found, and an old record of a level that was not would pass
/// for one of this test.
void check_found(const MeasurementRun& options, const RecordNames& names,
                 const VirtualMeasurement& test) {
  const auto is_found = [&](std::size_t i) { return test.levels[i].summary.converged(); };
  const std::vector<std::string> records =
      record_names(options, names, test.levels.size(), is_found);
  if (records.empty()) {
    throw NothingFound(fmt::format("{}; nothing is written", test.summary.reason));
  }
  check_strangers(options, records);
}

/// Solves the test; names in [test] are those of the file.
VirtualMeasurement solve(const MeasurementRun& options, const MeasurementInputs& inputs) {
  VirtualMeasurementOptions test;
  test.shaker = !options.no_shaker;
  test.linear_damping = inputs.linear_damping;
  test.progress = options.solving;
  return of_rig({options.rig, {}},
                [&] { return measure_virtually(inputs.rig, inputs.joint, test); });
}

/// Behind other text: a record has one comment.
std::string warnings_on_a_line(const std::vector<Warning>& warnings) {
  std::string text;
  for (const Warning& warning : warnings) {
    text += fmt::format("; warning: {}: {}", warning.code, warning.text);
  }
  return text;
}

/// Writes all files of a test into its folder.
class MeasurementWriter {
 public:
  /// @param comment  of all tables and the rig: provenance and warnings.
  MeasurementWriter(const MeasurementRun& options, const MeasurementInputs& inputs,
                    const RecordNames& names, std::string comment)
      : options_(options),
        inputs_(inputs),
        names_(names),
        comment_(std::move(comment)),
        state_(stick_state(inputs.rig)) {
    folders_.make(options.out, "Choose another folder with `out`.");
  }

  /// truth.csv comes first, so that it has its name before the others get theirs: without it, what
  /// a process wrote that was killed meanwhile would be taken for recordings of a laboratory.
  void write(const VirtualMeasurement& test, const Progress& progress) {
    write_tables(test);
    for (const VirtualLevel& level : test.levels) {
      if (level.summary.converged()) write_level(level);
      if (progress && !progress(level.number, test.levels.size())) throw Cancelled();
    }
    write_rig();
    files_.commit();
  }

 private:
  void write_level(const VirtualLevel& level) {
    write_record(level, false);
    if (options_.before_control) write_record(level, true);
  }

  [[nodiscard]] std::string file(const std::string& name) const {
    return (fs::path(options_.out) / name).string();
  }

  void write_record(const VirtualLevel& level, bool before_control) {
    Recording recording =
        virtual_record(inputs_.rig, state_, before_control ? level.uncontrolled : level.controlled,
                       options_.seed, record_number(level, before_control));
    recording.source = names_.name(before_control ? kBeforeControl : kLevel, level.number);
    recording.attributes.emplace_back(
        "comment",
        fmt::format("microslip {}: virtual test, level {}, {:.6g} m/s^2 at {:.6g} Hz{}, seed {}{}",
                    kVersion, level.number, level.response, level.frequency,
                    before_control ? ", before force control" : "", options_.seed,
                    warnings_on_a_line(level.warnings)));
    write_recordings(files_, file(recording.source), {&recording, 1}, names_.format());
  }

  void add(const std::string& name, CsvWriter table) {
    table.add_comment(comment_);
    files_.add(file(name), table.str());
  }

  void write_tables(const VirtualMeasurement& test) {
    add("truth.csv", truth_table(test.levels, inputs_.joint, names_.all(kLevel)));
    if (options_.no_shaker) return;
    add(std::string(kForceControlFile),
        force_control_table(test.levels, VirtualMeasurementOptions{}.controlled_harmonics));
  }

  /// The rig without the joint, which a test does not know; where the rig lies in the folder itself
  /// it stays.
  void write_rig() {
    const std::string path = file("rig.toml");
    if (keeps_rig(options_)) return;
    std::string comments = "# " + comment_;
    for (std::size_t at = comments.find('\n'); at != std::string::npos;
         at = comments.find('\n', at + 3)) {
      comments.insert(at + 1, "# ");
    }
    files_.add(path, comments + "\n" + format_rig(without_truth(inputs_.rig)));
  }

  const MeasurementRun& options_;
  const MeasurementInputs& inputs_;
  const RecordNames& names_;
  std::string comment_;
  StickState state_;
  OutputFolders folders_;
  OutputFiles files_;
};

std::string range(double from, double to, std::string_view unit) {
  return fmt::format("{:.4g} to {:.4g} {}", from, to, unit);
}

std::string describe_force(const std::vector<const VirtualLevel*>& levels) {
  const std::size_t harmonics = VirtualMeasurementOptions{}.controlled_harmonics;
  const auto worst = [&](auto state) {
    const VirtualLevel& level = **std::ranges::max_element(
        levels, {},
        [&](const VirtualLevel* one) { return force_distortion(state(*one), harmonics); });
    return std::pair{force_distortion(state(level), harmonics), level.number};
  };
  const auto before = worst([](const VirtualLevel& l) -> const auto& { return l.uncontrolled; });
  const auto after = worst([](const VirtualLevel& l) -> const auto& { return l.controlled; });
  return fmt::format("up to {} of the first before control (level {}), {} after it (level {})",
                     percent_text(before.first), before.second, percent_text(after.first),
                     after.second);
}

/// Each kind of warning once, of its first level.
std::vector<Warning> warnings_of(const MeasurementInputs& inputs, const VirtualMeasurement& test) {
  std::vector<Warning> warnings;
  if (const auto other = stiffness_warning(stick_state(inputs.rig), inputs.joint)) {
    warnings.push_back(*other);
  }
  for (const VirtualLevel& level : test.levels) {
    for (const Warning& warning : level.warnings) {
      const auto same = [&](const Warning& other) { return other.code == warning.code; };
      if (std::ranges::none_of(warnings, same)) warnings.push_back(warning);
    }
  }
  return warnings;
}

}  // namespace

std::string true_joint_path(const Rig& rig, const std::string& rig_path) {
  if (rig.contact.joint.empty()) {
    throw InputError(input_name(rig_path) + ": contact.joint", "none",
                     "must name the file of the true joint",
                     "Add joint = \"FILE\" to [contact], the joint to be used as the true one; the "
                     "path is relative to the rig's.");
  }
  return file_beside(rig_path, rig.contact.joint);
}

FinishedMeasurement run_measurement(const MeasurementRun& options) {
  const MeasurementInputs inputs = read_inputs(options);
  const RecordNames names(options, inputs.rig.test ? inputs.rig.test->count : 0);
  check_folder(options, inputs.rig, names);
  VirtualMeasurement test = solve(options, inputs);
  check_found(options, names, test);
  std::vector<Warning> warnings = warnings_of(inputs, test);
  MeasurementWriter(options, inputs, names, with_warnings(inputs.provenance, warnings))
      .write(test, options.writing);
  return {inputs.joint_path, inputs.linear_damping, std::move(test), names.all(kLevel),
          std::move(warnings)};
}

std::string describe_measurement(const MeasurementRun& options, const FinishedMeasurement& done) {
  const VirtualMeasurement& test = done.test;
  std::vector<const VirtualLevel*> found;
  for (const VirtualLevel& level : test.levels) {
    if (level.summary.converged()) found.push_back(&level);
  }
  const SteadyVibration& first = found.front()->controlled.vibration;
  const SteadyVibration& last = found.back()->controlled.vibration;
  std::string text =
      fmt::format("Virtual test of {} with {}\n", input_name(options.rig), done.joint_path);
  text +=
      line("levels", fmt::format("{} of {}, {} at the exciter", found.size(), test.levels.size(),
                                 range(first.response, last.response, "m/s^2")));
  text += line("drive", fmt::format("{}, {}", range(first.frequency(), last.frequency(), "Hz"),
                                    range(first.force_amplitude, last.force_amplitude, "N")));
  text +=
      line("joint",
           fmt::format("{}, {}",
                       range(1e6 * first.joints[0].amplitude, 1e6 * last.joints[0].amplitude, "um"),
                       range(1e6 * first.joints[0].dissipation, 1e6 * last.joints[0].dissipation,
                             "uJ per cycle")));
  if (done.linear_damping > 0.0) {
    text += line("linear damping", damping_text(done.linear_damping) + ", as identified");
  }
  text += line("force harmonics", options.no_shaker ? "none: a pure force" : describe_force(found));
  text += line("solved in", fmt::format("{:.2f} s, {} harmonic balances", test.summary.wall_seconds,
                                        test.summary.iterations));
  text +=
      line("written", fmt::format("{}: {} to {}, truth.csv, {}rig.toml", options.out,
                                  done.records[found.front()->number - 1],
                                  done.records[found.back()->number - 1],
                                  options.no_shaker ? "" : fmt::format("{}, ", kForceControlFile)));
  if (!test.summary.converged()) text += fmt::format("Not found: {}\n", test.summary.reason);
  return text;
}

}  // namespace microslip
