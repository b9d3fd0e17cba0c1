// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/experiment_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <numeric>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/documents/joint/density_file.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/documents/structure/rig_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/workflow/identify/recorded_options.hpp"
#include "microslip/workflow/results/calibration_input.hpp"
#include "microslip/workflow/results/comparison_input.hpp"
#include "microslip/workflow/results/experiment_recordings.hpp"
#include "microslip/workflow/results/force_paths.hpp"
#include "microslip/workflow/results/level_records.hpp"
#include "microslip/workflow/results/record_tables.hpp"
#include "microslip/workflow/results/result_tables.hpp"
#include "microslip/workflow/results/rig_responses.hpp"

namespace microslip {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPredictions = 8;

/// Comments of a table that a program wrote begin with its name and version.
std::string made_by(std::string_view text) {
  constexpr std::string_view kStart = "# microslip ";
  if (!text.starts_with(kStart)) return {};
  const std::string_view line = text.substr(kStart.size(), text.find('\n') - kStart.size());
  const std::size_t colon = line.find(": ");
  return std::string(colon == std::string_view::npos ? line : line.substr(colon + 2));
}

/// The name of the folder itself, also of ".".
std::string name_of_folder(const std::string& folder) {
  std::error_code none;
  const fs::path whole = fs::absolute(folder, none).lexically_normal();
  const std::string name = whole.filename().string();
  return name.empty() ? whole.parent_path().filename().string() : name;
}

/// Reads the files of a folder into results.
class FolderReader {
 public:
  /// @param records  of force and displacement that are read. @param progress  reports them.
  FolderReader(std::string folder, std::span<const std::size_t> records, const Progress& progress)
      : folder_(std::move(folder)), records_(records), progress_(progress) {}

  ExperimentResults read() {
    results_.title = name_of_folder(folder_);
    if (results_.title.empty()) results_.title = "Test";
    read_joint_files();
    read_calibration();
    read_levels();
    read_rig_file();
    read_verification();
    read_force_control();
    read_curves();
    read_comparison();
    read_campaign();
    check_model_of_comparison();
    return std::move(results_);
  }

 private:
  /// The file, noted with its hash.
  std::optional<NamedInput> find(const std::string& name) {
    const std::string path = folder_ + "/" + name;
    std::error_code none;
    if (!fs::is_regular_file(path, none)) return std::nullopt;
    NamedInput input{path, read_text(path)};
    results_.files.push_back({name, sha256(input.text), made_by(input.text)});
    return input;
  }

  void read_joint_files() {
    if (const auto input = find("joint.json")) {
      const JointFile file = parse_joint(input->text, input->path);
      results_.joint = identified_joint_of(file, input->path);
      if (file.provenance) note_joint_provenance(*file.provenance);
      read_records(file);
    }
    if (results_.joint) read_density();
    if (const auto input = find("truth_joint.json")) {
      const JointFile file = parse_joint(input->text, input->path);
      results_.truth = file.joint;
      results_.true_linear_damping = identified_damping(file).value_or(0.0);
    }
  }

  /// Results of a calibration of several joints.
  void read_calibration() {
    std::vector<std::string> hashes;  // of what calibration.json was made from
    if (const auto input = find("calibration.json")) {
      const CalibrationFile file = parse_calibration(input->text, input->path);
      results_.calibration = calibration_summary_of(file, input->path);
      if (file.provenance) {
        note_origin(*file.provenance, "joints found by");
        for (const InputHash& hash : file.provenance->inputs) hashes.push_back(hash.sha256);
      }
    }
    if (const auto input = find("calibration.csv")) {
      results_.modal_levels = calibrated_levels_of(*input);
      check_calibration(*input, hashes);
    }
    if (const auto input = find("identifiability.csv")) {
      results_.densities = densities_of(*input);
      if (results_.calibration) {
        for (DensityFound& joint : results_.densities) {
          joint.confidence = results_.calibration->confidence;
        }
      }
      check_calibration(*input, hashes);
    }
  }

  /// The files of one calibration tell the same inputs.
  void check_calibration(const NamedInput& input, const std::vector<std::string>& hashes) {
    const std::vector<std::string> own = hashes_in(input);
    if (hashes.empty() || own.empty() || own == hashes) return;
    results_.warnings.push_back(
        {"files_of_other_calibration",
         fmt::format("{} and calibration.json are of different calibrations: calibrate again, or "
                     "the results shown are inconsistent.",
                     fs::path(input.path).filename().string())});
  }

  /// The recordings that the joint was identified from.
  void read_records(const JointFile& file) {
    if (records_.empty() || !results_.joint->by_records) return;
    ForcePaths found = read_force_paths(file, folder_, records_, progress_);
    results_.force_paths = std::move(found.paths);
    std::ranges::move(found.files, std::back_inserter(results_.files));
    std::ranges::move(found.warnings, std::back_inserter(results_.warnings));
  }

  /// Its band is the joint's where joint.json has none.
  void read_density() {
    const auto input = find("density.csv");
    if (!input) return;
    const DensityTable table = parse_density(input->text, input->path);
    IdentifiedJoint& joint = *results_.joint;
    if (!is_density_of(table, joint.joint)) {
      results_.warnings.push_back({"density_of_other_joint",
                                   "density.csv contains another density than joint.json: it is "
                                   "not shown. Write both with one microslip identify."});
    } else if (joint.band_slip_force.empty() && !table.lower.empty()) {
      joint.band_slip_force = table.slip_force;
      joint.band_lower = table.lower;
      joint.band_upper = table.upper;
    }
  }

  /// SHA-256 of a file that was found; nothing of one that was not.
  [[nodiscard]] std::optional<std::string> hash_of(std::string_view name) const {
    const auto file = std::ranges::find(results_.files, name, &SourceFile::name);
    if (file == results_.files.end()) return std::nullopt;
    return file->sha256;
  }

  /// A table may tell the hashes of what it was made with; that may be newer.
  [[nodiscard]] bool was_made_with(const std::vector<std::string>& hashes,
                                   std::string_view name) const {
    const std::optional<std::string> hash = hash_of(name);
    return hashes.empty() || !hash || std::ranges::find(hashes, *hash) != hashes.end();
  }

  void check_origin(const NamedInput& input) {
    const std::vector<std::string> hashes = hashes_in(input);
    for (const std::string name : {"joint.json", "rig.toml"}) {
      if (was_made_with(hashes, name)) continue;
      results_.predictions_are_of_this_joint = false;
      results_.warnings.push_back(
          {name == "joint.json" ? "verification_of_other_joint" : "verification_of_other_rig",
           fmt::format("{} was not made with the {} in this folder. Verify again, or the "
                       "predictions are inconsistent with the rest.",
                       fs::path(input.path).filename().string(), name)});
    }
  }

  void note_option(const std::string& name, const NamedValue& value) {
    std::string text = "not given";
    if (const auto* number = std::get_if<double>(&value)) {
      text = fmt::format("{:g}", *number);
    } else if (const auto* words = std::get_if<std::string>(&value)) {
      if (!words->empty()) text = *words;
    } else if (const auto* list = std::get_if<JsonText>(&value)) {
      const std::vector<std::string> texts = texts_of(*list);
      if (!texts.empty()) text = fmt::format("{}", fmt::join(texts, ", "));
    } else {
      return;
    }
    results_.provenance.emplace_back("option " + name, text);
  }

  /// Who made what from which files.
  void note_origin(const Provenance& provenance, const char* what) {
    results_.files.back().made_by = provenance.command;
    results_.provenance.emplace_back(what,
                                     fmt::format("{} {}", provenance.program, provenance.version));
    results_.provenance.emplace_back("command", provenance.command);
    if (provenance.seed) {
      results_.provenance.emplace_back("seed", fmt::format("{}", *provenance.seed));
    }
    for (const auto& [name, value] : provenance.options) note_option(name, value);
    for (const InputHash& hash : provenance.inputs) {
      inputs_.emplace_back(results_.provenance.size(), hash.file);
      results_.provenance.emplace_back("identified from",
                                       fmt::format("{} (SHA-256 {})", hash.file, hash.sha256));
    }
  }

  void note_joint_provenance(const Provenance& provenance) {
    note_origin(provenance, "joint identified by");
    // The joint may be older than the levels beside it.
    for (const InputHash& hash : provenance.inputs) identified_from_.push_back(hash.sha256);
    takes_all_levels_ = std::ranges::any_of(provenance.options, [](const auto& option) {
      return option.first == "inner_reversals" && option.second == NamedValue("use");
    });
    try {
      results_.options = recorded_options(provenance.options);
    } catch (const InputError& error) {
      results_.warnings.push_back(
          {"options_not_understood",
           fmt::format("The other methods are shown with their defaults: {}", error.what())});
    }
  }

  void read_levels() {
    if (const auto input = find("levels.csv")) read_levels_file(*input);
    if (const auto input = find("truth.csv")) results_.true_levels = levels_of(*input);
  }

  void read_levels_file(const NamedInput& input) {
    if (file_kind(input.text) == kModalLevelsKind) {
      if (!results_.modal_levels) results_.modal_levels = modal_levels_of(input);
      return;
    }
    results_.levels = levels_of(input);
    reduced_with_ = hashes_in(input);
    if (takes_all_levels_) results_.levels->left_out.clear();
    const bool same =
        std::ranges::find(identified_from_, sha256(input.text)) != identified_from_.end();
    if (results_.joint) results_.joint->from_these_levels = same;
    if (!identified_from_.empty() && !same) {
      results_.warnings.push_back({"joint_from_other_levels",
                                   "joint.json was not identified from the levels.csv in this "
                                   "folder. Identify it again, or the figures are inconsistent."});
    }
  }

  void read_rig_file() {
    const auto input = find("rig.toml");
    if (!input) return;
    results_.rig = parse_rig(input->text, input->path);
    if (!was_made_with(reduced_with_, "rig.toml")) {
      results_.warnings.push_back(
          {"levels_of_other_rig",
           "levels.csv was not reduced with the rig.toml in this folder. Reduce the recordings "
           "again, or predictions are inconsistent with the levels."});
    }
    add_predictions(results_);
  }

  void read_verification() {
    if (const auto input = find("verification.csv")) {
      results_.comparisons = comparisons_of(*input);
      check_origin(*input);
    }
    if (const auto input = find("verification_histories.csv")) {
      check_origin(*input);
      results_.predictions =
          some_records(histories_of({input->text, input->path}, "recorded", "predicted"),
                       kMostPredictions, kMostSignalPoints);
    }
    if (const auto input = find("verification_harmonics.csv")) {
      check_origin(*input);
      const std::vector<LevelRecord> shown = results_.predictions;
      add_harmonics({input->text, input->path}, "recorded", "predicted", results_.predictions);
      if (!shown.empty()) results_.predictions.resize(shown.size());
    }
  }

  /// A table of that kind; another of the same name gives a warning and is not read.
  std::optional<NamedInput> find(const std::string& name, std::string_view kind) {
    const std::string path = folder_ + "/" + name;
    std::error_code none;
    if (!fs::is_regular_file(path, none)) return std::nullopt;
    if (file_kind(read_kind_head(path)) == kind) return find(name);
    results_.warnings.push_back(
        {"other_table", fmt::format("{} is not {}: it is not shown.", name, kind)});
    return std::nullopt;
  }

  /// Of predictions by a model.
  void read_curves() {
    PredictedCurves& curves = results_.curves;
    if (const auto input = find("frf.csv", kResponseKind)) {
      curves.response = predicted_response({input->text, input->path});
    }
    if (const auto input = find("backbone.csv", kBackboneKind)) {
      curves.backbone = predicted_backbone({input->text, input->path});
    }
    if (const auto input = find("curve.csv", kDissipationKind)) {
      curves.joint = dissipation_curve({input->text, input->path});
    }
    if (const auto input = find("march.csv", kMarchKind)) {
      curves.march = marched_histories({input->text, input->path});
    }
    if (const auto input = find("ensemble.csv", kEnsembleTableKind)) {
      curves.ensemble = ensemble_curves({input->text, input->path});
    }
  }

  /// Tests against a model, or a joint.
  void read_comparison() {
    const auto input = find("comparison.csv", kComparisonKind);
    if (!input) return;
    results_.comparison = comparison_of({input->path, input->text});
    comparison_ = *input;
  }

  /// A campaign wrote the model that lies beside its comparison from what both name.
  void check_model_of_comparison() {
    if (!comparison_ || hashes_in(*comparison_) == campaign_hashes_) return;
    for (const std::string name : {"joint.json", "model.toml"}) {
      const std::optional<std::string> hash = hash_of_input(*comparison_, name);
      const std::optional<std::string> beside = hash_beside(name);
      if (!hash || !beside || *hash == *beside) continue;
      results_.comparison->of_this_model = false;
      results_.warnings.push_back(
          {"comparison_of_other_model",
           fmt::format("comparison.csv was not made with the {} in this folder. Verify again, or "
                       "it is inconsistent with the rest.",
                       name)});
    }
  }

  /// Of a file beside the tables that need not be shown itself.
  [[nodiscard]] std::optional<std::string> hash_beside(const std::string& name) const {
    const std::string path = folder_ + "/" + name;
    std::error_code none;
    if (!fs::is_regular_file(path, none)) return std::nullopt;
    return sha256(read_file(path));
  }

  /// Results of a campaign other than its levels, joint and comparison.
  void read_campaign() {
    CampaignFound found;
    const auto campaign = find("campaign.csv", kCampaignTableKind);
    if (!campaign) return;
    add_campaign_table(*campaign, found);
    if (!found.title.empty()) results_.title = found.title;
    campaign_hashes_ = hashes_in(*campaign);
    const auto read = [&](const std::string& name, std::string_view kind, const auto& add) {
      const auto input = find(name, kind);
      if (!input) return;
      if (hashes_in(*input) != campaign_hashes_) {
        results_.warnings.push_back({"files_of_other_campaign",
                                     fmt::format("{} and campaign.csv are of different campaigns: "
                                                 "it is not shown. Run the campaign again.",
                                                 name)});
        return;
      }
      add(*input, found);
    };
    read("sessions.csv", kSessionsKind, add_sessions);
    read("conditions.csv", kConditionsKind, add_conditions);
    read("leave_one_out.csv", kLeftOutKind, add_left_out);
    results_.campaign = std::move(found);
    tell_what_is_predicted_alone();
  }

  /// A campaign names all its tests among its inputs; sources begin with the file of theirs.
  void tell_what_is_predicted_alone() {
    for (const auto& [place, file] : inputs_) {
      const auto is_of = [&file](const CampaignEntry& entry) {
        const std::string_view source = entry.source;
        return entry.use == "predict" && source.starts_with(file) &&
               (source.size() == file.size() || source[file.size()] == ':');
      };
      if (std::ranges::any_of(results_.campaign->entries, is_of)) {
        results_.provenance[place].first = "predicted alone";
      }
    }
  }

  void read_force_control() {
    if (const auto input = find("force_control.csv")) {
      results_.force_control = force_control_of(*input);
    }
  }

  std::string folder_;
  std::span<const std::size_t> records_;
  const Progress& progress_;
  ExperimentResults results_;
  std::vector<std::string> reduced_with_;     ///< hashes that levels.csv tells
  std::vector<std::string> identified_from_;  ///< SHA-256 of each input
  /// Files of the inputs, each with the place of its fact in the provenance of the results.
  std::vector<std::pair<std::size_t, std::string>> inputs_;
  std::optional<NamedInput> comparison_;
  std::vector<std::string> campaign_hashes_;  ///< of all that a campaign was made from
  bool takes_all_levels_ = false;
};

}  // namespace

bool add_result_file(const std::string& kind, const std::string& text, const std::string& path,
                     ExperimentResults& results) {
  const NamedInput input{path, text};
  if (kind == kLevelsKind) {
    results.levels = levels_of(input);
  } else if (kind == kJointKind) {
    results.joint = identified_joint_of(parse_joint(text, path), path);
    DensityFound density = density_found_of(fs::path(path).stem().string(), *results.joint);
    if (!density.variance_reduction.empty()) results.densities.push_back(std::move(density));
  } else if (kind == kVerificationKind) {
    results.comparisons = comparisons_of(input);
  } else if (kind == kHistoriesKind) {
    results.predictions = histories_of({text, path}, "recorded", "predicted");
  } else if (kind == kForceControlKind) {
    results.force_control = force_control_of(input);
  } else if (kind == kCalibrationKind) {
    results.modal_levels = calibrated_levels_of(input);
  } else if (kind == kModalLevelsKind) {
    results.modal_levels = modal_levels_of(input);
  } else if (kind == kIdentifiabilityKind || kind == kDensitiesKind) {
    results.densities = densities_of(input);
  } else if (kind == kCalibrationFileKind) {
    results.calibration = calibration_summary_of(parse_calibration(text, path), path);
  } else {
    return false;
  }
  return true;
}

ExperimentResults read_experiment(const std::string& folder, std::size_t records,
                                  const Progress& progress) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throw FileError(folder, "is not a folder", "Name the folder with levels.csv and joint.json.");
  }
  std::vector<std::size_t> first(records);
  std::iota(first.begin(), first.end(), std::size_t{0});
  ExperimentResults results = FolderReader(folder, first, progress).read();
  if (records > 0) add_recordings(folder, records, progress, results);
  return results;
}

std::vector<std::string> folders_holding(const std::string& folder,
                                         std::initializer_list<const char*> files) {
  std::vector<std::string> found;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const auto holds = [&](const char* file) {
      return fs::is_regular_file(entry.path() / file, none);
    };
    if (std::ranges::any_of(files, holds)) found.push_back(entry.path().string());
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace microslip
