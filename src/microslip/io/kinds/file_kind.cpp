// SPDX-License-Identifier: MIT
#include "microslip/io/kinds/file_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/input_stream.hpp"
#include "microslip/io/bytes/signature.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/bytes/text_pieces.hpp"
#include "microslip/io/cells/csv_header.hpp"
#include "microslip/io/kinds/comment_text.hpp"

namespace microslip {
namespace {

/// A table is of the first kind whose columns it has, if it is no history in time: one of these can
/// be a recording, which nothing but the same channels may replace.
struct TableKind {
  std::string_view kind;
  std::array<std::string_view, 3> columns;  // unused ones are empty
};

constexpr std::array kTableKinds{
    TableKind{kCalibrationKind, {"level", "mode", "damping_ratio"}},
    TableKind{kIdentifiabilityKind, {"joint", "slip_displacement", "told"}},
    TableKind{kModalLevelsKind, {"mode", "displacement", "frequency"}},
    TableKind{kModalLevelsKind, {"mode", "displacement", "dissipation"}},
    TableKind{kModalLevelsKind, {"mode", "displacement", "damping_ratio"}},
    TableKind{kVerificationKind, {"channel", "NRMSE", "noise_share"}},
    TableKind{kComparisonKind, {"quantity", "measured", "verdict"}},
    TableKind{kCampaignTableKind, {"test", "use", "amplitude_verdict"}},
    TableKind{kSessionsKind, {"session", "frequency_offset", "dissipation_offset"}},
    TableKind{kConditionsKind, {"condition", "value", "dissipation_offset"}},
    TableKind{kLeftOutKind, {"left_out", "predicted", "deviation"}},
    TableKind{kHarmonicsKind, {"source", "harmonic", "frequency"}},
    TableKind{kForceControlKind, {"level", "force_before", "force_after"}},
    TableKind{kExportedDrawsKind, {"draw", "file", "macroslip_force"}},
    TableKind{kSliderErrorsKind, {"amplitude", "dissipation_error", "secant_stiffness_error"}},
    TableKind{kDissipationKind, {"amplitude", "dissipation", "loss_factor"}},
    TableKind{kEnsembleTableKind, {"group", "output", "unit"}},
    TableKind{kLevelsKind, {"amplitude", "dissipation"}},
    TableKind{kPlanKind, {"amplitude", "repeats", "width_after"}},
    TableKind{kDampingLevelsKind, {"amplitude", "damping_ratio", "decay_time"}},
    TableKind{kAssembliesKind, {"assembly", "stiffness", "slip_force_scale"}},
    TableKind{kDensitiesKind, {"assembly", "slip_force", "density"}},
    TableKind{kDensityKind, {"slip_force", "density"}},
    TableKind{kPeaksKind, {"frequency", "frequency_lower", "draws"}},
    TableKind{kMarchPeaksKind, {"statistic", "displacement_lower", "draws"}},
    TableKind{kResponseKind, {"frequency", "displacement", "phase"}},
    TableKind{kSteppedSineKind, {"force", "acceleration", "phase"}},
    TableKind{kSpectrumKind, {"frequency", "maximax", "relative_displacement"}},
    TableKind{kBackboneKind, {"frequency", "displacement", "damping_ratio"}},
    TableKind{kLoopKind, {"displacement", "force"}},
    TableKind{kPathKind, {"displacement"}},
};

/// Tables of a displacement path, and of forces on one, have names that any table may have.
constexpr std::array kKnownKinds{
    KnownKind{kJointKind, "a joint (joint.json)", KindFormat::kJson},
    KnownKind{kCalibrationFileKind, "the record of a calibration (calibration.json)",
              KindFormat::kJson},
    KnownKind{kRigKind, "the description of a frictional-support test (rig.toml)",
              KindFormat::kToml},
    KnownKind{kModelKind, "a structure with joints (model.toml)", KindFormat::kToml},
    KnownKind{kStructureKind, "a structure whose modes are sought (structure.toml)",
              KindFormat::kToml},
    KnownKind{kCampaignKind, "a campaign (campaign.toml)", KindFormat::kToml},
    KnownKind{kAboutKind, "the head of a report (about.toml)", KindFormat::kToml},
    KnownKind{kEnsemblePlanKind, "the plan of an ensemble (plan.toml)", KindFormat::kToml},
    KnownKind{kSamplesKind, "draws of a joint (joint_samples.h5)", KindFormat::kOther},
    KnownKind{kEnsembleKind, "the result of an ensemble (result.h5)", KindFormat::kOther},
    KnownKind{kJournalKind, "the journal of an ensemble", KindFormat::kOther},
    KnownKind{kReportKind, "a report of microslip (report.html)", KindFormat::kOther},
    KnownKind{kLevelsKind, "a table of levels (levels.csv)", KindFormat::kTable},
    KnownKind{kModalLevelsKind, "a table of modal levels (modal_levels.csv)", KindFormat::kTable},
    KnownKind{kDampingLevelsKind, "a table of damping ratios, of ringdown without modal mass",
              KindFormat::kTable},
    KnownKind{kCalibrationKind, "a table of a calibration (calibration.csv)", KindFormat::kTable},
    KnownKind{kIdentifiabilityKind,
              "a table of densities and their variance reduction (identifiability.csv)",
              KindFormat::kTable},
    KnownKind{kAssembliesKind, "a table of assemblies (assemblies.csv)", KindFormat::kTable},
    KnownKind{kDensitiesKind, "a table of densities of assemblies (densities.csv)",
              KindFormat::kTable},
    KnownKind{kDensityKind, "a table of a density (density.csv)", KindFormat::kTable},
    KnownKind{kPlanKind, "a table of planned levels, of plan", KindFormat::kTable},
    KnownKind{kDissipationKind, "a table of a dissipation curve, of dissipation",
              KindFormat::kTable},
    KnownKind{kSliderErrorsKind, "a table of errors of sliders, of export", KindFormat::kTable},
    KnownKind{kExportedDrawsKind, "a table of exported draws, of export --draws",
              KindFormat::kTable},
    KnownKind{kPeaksKind, "a table of peaks of draws, of frf --peaks-csv", KindFormat::kTable},
    KnownKind{kMarchPeaksKind, "a table of peaks of draws, of march", KindFormat::kTable},
    KnownKind{kBackboneKind, "a table of a backbone (backbone.csv)", KindFormat::kTable},
    KnownKind{kVerificationKind, "a table of a verification (verification.csv)",
              KindFormat::kTable},
    KnownKind{kComparisonKind, "a table of compared tests (comparison.csv)", KindFormat::kTable},
    KnownKind{kCampaignTableKind, "a table of a campaign (campaign.csv)", KindFormat::kTable},
    KnownKind{kSessionsKind, "a table of sessions of a campaign (sessions.csv)",
              KindFormat::kTable},
    KnownKind{kConditionsKind, "a table of conditions of a campaign (conditions.csv)",
              KindFormat::kTable},
    KnownKind{kLeftOutKind, "a table of a leave-one-out campaign (leave_one_out.csv)",
              KindFormat::kTable},
    KnownKind{kHarmonicsKind, "a table of predicted harmonics, of verify", KindFormat::kTable},
    KnownKind{kForceControlKind, "a table of a force control (force_control.csv)",
              KindFormat::kTable},
    KnownKind{kEnsembleTableKind, "a table of an ensemble", KindFormat::kTable},
    KnownKind{kHistoriesKind, "a table of predicted histories, of verify", KindFormat::kTable},
    KnownKind{kResponseKind, "a table of a frequency response (frf.csv)", KindFormat::kTable, true},
    KnownKind{kSteppedSineKind, "a stepped-sine table", KindFormat::kTable, true},
    KnownKind{kSpectrumKind, "a shock response spectrum", KindFormat::kTable, true},
    KnownKind{kMarchKind, "a table of a march (march.csv)", KindFormat::kTable, true},
};

/// source, time, NAME_recorded, NAME_predicted, …
bool is_histories(const std::vector<std::string>& names) {
  return names.size() >= 4 && names[0] == "source" && names[1] == "time" &&
         names[2].ends_with("_recorded") && names[3].ends_with("_predicted");
}

/// time, forces, displacement, velocity, acceleration, and a joint's displacement and force at the
/// end, but for what draws and accelerating bases add: no recording is like that.
bool is_march(std::vector<std::string> names) {
  while (names.size() > 1 &&
         (names.back().ends_with("_lower") || names.back().ends_with("_upper") ||
          names.back() == "absolute_displacement" || names.back() == "absolute_velocity" ||
          names.back() == "absolute_acceleration")) {
    names.pop_back();
  }
  constexpr std::array<std::string_view, 3> kMotion{"displacement", "velocity", "acceleration"};
  const auto motion = std::search(names.begin(), names.end(), kMotion.begin(), kMotion.end());
  return names.front() == "time" && names.end() - motion > 4 &&
         names[names.size() - 2].ends_with(" displacement") && names.back().ends_with(" force");
}

std::string table_kind(const std::vector<std::string>& names) {
  if (is_histories(names)) return std::string(kHistoriesKind);
  if (is_march(names)) return std::string(kMarchKind);
  const auto has = [&](std::string_view name) {
    return name.empty() || std::find(names.begin(), names.end(), name) != names.end();
  };
  const bool is_history = std::find(names.begin(), names.end(), "time") != names.end();
  for (const TableKind& kind : kTableKinds) {
    if (is_history) break;
    if (std::all_of(kind.columns.begin(), kind.columns.end(), has)) return std::string(kind.kind);
  }
  std::string list;
  for (const std::string& name : names) list += fmt::format("{}{}", list.empty() ? "" : ", ", name);
  return fmt::format("a table of {}", in_quotes(list, 120));
}

/// The text in quotes, double or single, after `key` and the sign between them; empty where it does
/// not come so.
std::string_view quoted_value(std::string_view head, std::string_view key, char sign) {
  const std::size_t start = head.find(key);
  if (start == std::string_view::npos) return {};
  std::string_view rest = trimmed(head.substr(start + key.size()));
  if (!rest.starts_with(sign)) return {};
  rest = trimmed(rest.substr(1));
  if (!rest.starts_with('"') && !rest.starts_with('\'')) return {};
  const std::size_t end = rest.find(rest.front(), 1);
  return end == std::string_view::npos ? std::string_view{} : rest.substr(1, end - 1);
}

/// TOML: the first line that is no comment is schema = "…".
std::string_view toml_schema(std::string_view head) {
  if (head.starts_with(kByteOrderMark)) head.remove_prefix(kByteOrderMark.size());
  while (!head.empty()) {
    const std::string_view line = head.substr(0, head.find('\n'));
    const std::string_view text = trimmed(line.substr(0, line.find('\r')));
    if (text.starts_with("schema")) return quoted_value(text, "schema", '=');
    if (!text.empty() && !text.starts_with('#')) return {};
    head.remove_prefix(std::min(line.size() + 1, head.size()));
  }
  return {};
}

/// Whether a line ends that is neither empty nor a comment: that of a table's header, or of a
/// schema.
bool has_line(std::string_view head) {
  if (head.starts_with(kByteOrderMark)) head.remove_prefix(kByteOrderMark.size());
  for (;;) {
    const std::size_t end = head.find_first_of("\r\n");
    if (end == std::string_view::npos) return false;
    const std::string_view line = trimmed(head.substr(0, end));
    if (!line.empty() && !line.starts_with('#')) return true;
    head.remove_prefix(end + 1);
  }
}

/// The target of an export, by a comment at its head.
std::string_view exported_to(std::string_view head) {
  constexpr std::string_view kMark = "microslip export: ";
  while (!head.empty()) {
    const std::string_view text = comment_text(take_dos_line(head));
    if (text.empty()) return {};
    if (text.starts_with(kMark))
      return text.substr(kMark.size(), text.find(' ', kMark.size()) - kMark.size());
  }
  return {};
}

/// By the mark that a report has in its head.
bool is_report(std::string_view head) {
  return head.substr(0, head.find("<body"))
             .find("<meta name=\"generator\" content=\"microslip report\">") !=
         std::string_view::npos;
}

}  // namespace

std::string_view peek_kind_head(InputStream& file) {
  constexpr std::size_t kMost = std::size_t{1} << 26U;  // a binary file may have no lines
  for (std::size_t size = kKindHeadSize;; size *= 4) {
    const std::string_view head = file.peek(size);
    const bool whole = head.size() < size || size >= kMost;
    const bool no_text = head.find('\0') != std::string_view::npos;
    if (whole || no_text || !signature(head).empty() || has_line(head)) return head;
  }
}

std::string read_kind_head(const std::string& path) {
  InputStream file(path);
  return std::string(peek_kind_head(file));
}

std::string export_kind(std::string_view target) {
  return fmt::format("a joint exported to {}", target);
}

std::string file_kind(std::string_view head) {
  const std::string_view name = signature(head);
  if (name == "JSON") {
    const std::string_view schema = quoted_value(head, "\"schema\"", ':');
    if (!schema.empty()) return std::string(schema);
  }
  if (name == "an HTML page" && is_report(head)) return std::string(kReportKind);
  if (head.starts_with(kJournalKind)) return std::string(kJournalKind);
  for (const std::string_view schema : {kSamplesKind, kEnsembleKind}) {
    if (name == "an HDF5 file" && head.find(schema) != std::string_view::npos) {
      return std::string(schema);
    }
  }
  if (name == kZipSignature && head.find(kFmuMark) != std::string_view::npos) {
    return export_kind("fmu");
  }
  if (!name.empty()) return std::string(name);
  if (const std::string_view target = exported_to(head); !target.empty())
    return export_kind(target);
  if (const std::string_view schema = toml_schema(head); !schema.empty())
    return std::string(schema);
  const std::vector<std::string> names = csv_column_names(head);
  return names.empty() ? std::string{} : table_kind(names);
}

std::string kind_of_file(const std::string& path) {
  if (path == "-" || is_pipe_or_device(path)) return {};
  try {
    return file_kind(read_kind_head(path));
  } catch (const FileError&) {
    return {};
  }
}

const KnownKind* known_kind(std::string_view kind) {
  const auto* found = std::ranges::find(kKnownKinds, kind, &KnownKind::kind);
  return found == kKnownKinds.end() ? nullptr : found;
}

const KnownKind* known_kind_of(std::string_view head) {
  return known_kind(file_kind(head.substr(0, kKindHeadSize)));
}

}  // namespace microslip
