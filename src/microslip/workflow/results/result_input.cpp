// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/result_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/documents/joint/density_file.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/workflow/compare/comparison_table.hpp"
#include "microslip/workflow/results/calibration_input.hpp"
#include "microslip/workflow/results/experiment_folder.hpp"
#include "microslip/workflow/results/force_paths.hpp"

namespace microslip {
namespace {

DensityCurve density_of(const std::string& text, const std::string& file) {
  DensityTable table = parse_density(text, file);
  return {.slip_force = std::move(table.slip_force),
          .density = std::move(table.density),
          .lower = std::move(table.lower),
          .upper = std::move(table.upper)};
}

/// Channels of one dimension share an axis, which their unit names; one that is alone, or has no
/// unit, has its own name.
std::string quantity_of(const Channel& channel, const std::vector<Channel>& channels) {
  const auto same = std::ranges::count(channels, channel.dimension, &Channel::dimension);
  if (!channel.dimension || same == 1) return channel.name;
  return {};
}

/// The real channels over time, of the first recording of a file; the first few of each quantity.
void add_recorded(const std::string& path, ResultInput& input) {
  constexpr std::ptrdiff_t kMostOfAQuantity = 8;  // as many as there are colours
  const Recordings file = read_recordings(path, {});
  const Recording& recording = file.recordings.front();
  std::vector<HistorySignal>& signals = input.history;
  if (recording.axis.dimension != kTime) return;
  std::vector<double> time(recording.size());
  for (std::size_t i = 0; i < time.size(); ++i) time[i] = recording.axis.at(i);
  for (const Channel& channel : recording.channels) {
    if (!channel.imaginary.empty()) continue;
    const std::string quantity = quantity_of(channel, recording.channels);
    const std::string unit = channel.dimension ? si_unit(*channel.dimension) : "";
    const auto shares_axis = [&](const HistorySignal& other) {
      return other.quantity == quantity && other.unit == unit;
    };
    if (std::ranges::count_if(signals, shares_axis) == kMostOfAQuantity) {
      ++input.left_out;
      continue;
    }
    signals.push_back({channel.name, quantity, unit, time, channel.values});
  }
}

/// "Name one of the folders in it with results: a, b." for a folder that has none itself.
std::string folders_text(const std::string& path) {
  constexpr std::size_t kFew = 4;
  std::vector<std::string> found =
      folders_holding(path, {"levels.csv", "joint.json", "density.csv", "calibration.csv"});
  if (found.empty()) {
    return "Name a folder with levels.csv, joint.json or calibration.csv, or a result.";
  }
  for (std::string& one : found) one = std::filesystem::path(one).lexically_normal().string();
  const char* more = found.size() > kFew ? " and others" : "";
  found.resize(std::min(found.size(), kFew));
  return fmt::format("Name one of the folders in it with results: {}{}.", fmt::join(found, ", "),
                     more);
}

/// @return whether the text is one of the tables and models of this program.
bool add_text(const std::string& kind, const std::string& text, const std::string& file,
              ResultInput& input) {
  if (add_result_file(kind, text, file, input.test)) return true;
  if (kind == kDensityKind) {
    input.density = density_of(text, file);
  } else if (kind == kResponseKind) {
    input.response = predicted_response({text, file});
  } else if (kind == kBackboneKind) {
    input.backbone = predicted_backbone({text, file});
  } else if (kind == kSpectrumKind) {
    input.spectrum = shock_spectrum({text, file});
  } else if (kind == kDissipationKind) {
    input.dissipation = dissipation_curve({text, file});
  } else if (kind == kLoopKind) {
    input.path = parse_path(text, file);
    const CsvTable table(text, file);
    input.path_force = table.numbers("force", kForce);
    input.path_band = band_columns(table, "", kForce);
  } else if (kind == kEnsembleTableKind) {
    input.ensemble = ensemble_curves({text, file});
    input.instead = "A sweep has values of its grid, in its table and its HDF5 file.";
  } else if (kind == kComparisonKind) {
    input.compared = compared_tests({text, file});
  } else if (kind == kMarchKind) {
    input.history = marched_histories({text, file});
  } else {
    return false;
  }
  return true;
}

/// A record that the joint in a file was identified from.
void add_record(const JointFile& file, const std::string& folder, std::size_t record,
                ResultInput& input) {
  const std::optional<IdentifiedJoint>& joint = input.test.joint;
  if (!joint || !joint->by_records) return;
  const std::size_t count = joint->by_records->records.size();
  if (record < 1 || record > count) {
    throw InputError("`record`", static_cast<double>(record),
                     fmt::format("must be from 1 to {}, the records of {}", count, input.name));
  }
  const std::size_t index = record - 1;
  ForcePaths found = read_force_paths(file, folder, {&index, 1});
  input.test.force_paths = std::move(found.paths);
  if (!found.warnings.empty()) input.no_record = found.warnings.front().text;
}

/// Files next to a file.
std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// The part of a history, or of a record, between two times.
class TimeCut {
 public:
  TimeCut(const std::vector<double>& time, double from, double to) {
    for (std::size_t i = 0; i < time.size(); ++i) {
      if (time[i] >= from && time[i] <= to) kept_.push_back(i);
    }
  }

  [[nodiscard]] std::size_t size() const { return kept_.size(); }

  void apply(std::vector<double>& values) const {
    for (std::size_t i = 0; i < kept_.size(); ++i) values[i] = values[kept_[i]];
    values.resize(kept_.size());
  }

 private:
  std::vector<std::size_t> kept_;  // rising
};

TimeCut cut_of(const ResultInput& input, const std::vector<double>& time, double from, double to) {
  TimeCut cut(time, from, to);
  if (cut.size() >= 2) return cut;
  throw InputError("`time`", fmt::format("{:g}:{:g}", from, to),
                   fmt::format("must contain two or more samples of {}, which spans {:g} to {:g} s",
                               input.name, time.front(), time.back()));
}

}  // namespace

ResultInput read_result(const std::string& path, std::size_t record) {
  ResultInput input{.name = input_name(path)};
  std::error_code none;
  if (path != "-" && std::filesystem::is_directory(path, none)) {
    input.test = read_experiment(path);
    if (input.test.joint) add_record(read_joint(path + "/joint.json"), path, record, input);
    const std::string density = path + "/density.csv";
    if (!input.test.joint && std::filesystem::is_regular_file(density, none)) {
      input.density = density_of(read_file(density), density);
    }
    input.instead = folders_text(path);
    return input;
  }
  // A file of another kind may be a recording of any size.
  const std::string head = path == "-" ? read_file(path) : read_kind_head(path);
  const std::string kind = file_kind(head);
  if (add_text(kind, path == "-" ? head : read_file(path), input.name, input)) {
    if (kind == kCalibrationFileKind) {
      input.instead = "Name its folder, or calibration.csv or identifiability.csv in it.";
    }
    if (kind == kJointKind && path != "-") {
      add_record(read_joint(path), folder_of(path), record, input);
    }
    return input;
  }
  if (kind == kSamplesKind && path != "-") {
    input.samples = read_joint_samples(path);
    return input;
  }
  if (path == "-") {
    throw InputError("IN", "standard input", "must be a table or a joint of this program",
                     "Name a recording by its file.");
  }
  add_recorded(path, input);
  return input;
}

ResultInput read_joints(const std::vector<std::string>& paths) {
  ResultInput input{.name = fmt::format("{}", fmt::join(paths, ", "))};
  const auto stem = [](const std::string& path) {
    return std::filesystem::path(path).stem().string();
  };
  for (const std::string& path : paths) {
    const auto same = [&](const std::string& other) { return stem(other) == stem(path); };
    const std::string name = std::ranges::count_if(paths, same) > 1 ? path : stem(path);
    const std::string kind =
        path == "-" ? std::string(kJointKind) : file_kind(read_kind_head(path));
    if (kind != kJointKind) {
      throw InputError("IN", in_quotes(path), "must be a joint.json where several are named",
                       "Draw it separately.");
    }
    input.test.densities.push_back(
        density_found_of(name, identified_joint_of(read_joint(path), path)));
  }
  return input;
}

void cut_history(ResultInput& input, double from, double to) {
  for (HistorySignal& signal : input.history) {
    const TimeCut cut = cut_of(input, signal.time, from, to);
    for (auto* values : {&signal.time, &signal.values}) cut.apply(*values);
    for (auto* edge : {&signal.band.lower, &signal.band.upper}) {
      if (!edge->empty()) cut.apply(*edge);
    }
  }
  for (ForcePath& path : input.test.force_paths) {
    const double before = static_cast<double>(path.time.size());
    const TimeCut cut = cut_of(input, path.time, from, to);
    for (auto* values : {&path.time, &path.displacement, &path.path, &path.force, &path.found}) {
      cut.apply(*values);
    }
    const double share = static_cast<double>(path.time.size()) / before;
    path.reversals = static_cast<std::size_t>(static_cast<double>(path.reversals) * share);
  }
}

}  // namespace microslip
