// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace microslip {

inline constexpr std::string_view kJointKind = "microslip.joint/1";  ///< joint.json
/// joint_samples.h5
inline constexpr std::string_view kSamplesKind = "microslip.joint_samples/1";
/// plan of an ensemble
inline constexpr std::string_view kEnsemblePlanKind = "microslip.ensemble/1";
/// of add_ensemble_result()
inline constexpr std::string_view kEnsembleKind = "microslip.ensemble_result/1";
/// of JournalWriter
inline constexpr std::string_view kJournalKind = "microslip.journal/1";
/// of add_ensemble_table()
inline constexpr std::string_view kEnsembleTableKind = "a table of an ensemble";
inline constexpr std::string_view kRigKind = "microslip.rig/1";  ///< rig.toml
/// campaign.toml
inline constexpr std::string_view kCampaignKind = "microslip.campaign/1";
inline constexpr std::string_view kAboutKind = "microslip.about/1";          ///< about.toml
inline constexpr std::string_view kStructureKind = "microslip.structure/1";  ///< STRUCTURE.toml
inline constexpr std::string_view kModelKind = "microslip.model/1";          ///< model.toml
inline constexpr std::string_view kLevelsKind = "a table of levels";         ///< levels.csv
/// of `microslip ringdown` without modal mass
inline constexpr std::string_view kDampingLevelsKind = "a table of damping ratios";
inline constexpr std::string_view kCalibrationFileKind =
    "microslip.calibration/1";  ///< calibration.json
/// modal_levels.csv
inline constexpr std::string_view kModalLevelsKind = "a table of modal levels";
/// calibration.csv
inline constexpr std::string_view kCalibrationKind = "a table of a calibration";
/// identifiability.csv
inline constexpr std::string_view kIdentifiabilityKind =
    "a table of densities and their variance reduction";
/// assemblies.csv
inline constexpr std::string_view kAssembliesKind = "a table of assemblies";
/// densities.csv
inline constexpr std::string_view kDensitiesKind = "a table of densities of assemblies";
inline constexpr std::string_view kDensityKind = "a table of a density";    ///< of parse_density()
inline constexpr std::string_view kPlanKind = "a table of planned levels";  ///< of plan_text()
/// of `microslip dissipation`
inline constexpr std::string_view kDissipationKind = "a table of a dissipation curve";
/// of parse_path()
inline constexpr std::string_view kPathKind = "a table of a displacement path";
inline constexpr std::string_view kLoopKind = "a table of forces on a path";  ///< of loop_table()
/// of response_table()
inline constexpr std::string_view kResponseKind = "a table of a frequency response";
/// of peaks_table()
inline constexpr std::string_view kPeaksKind = "a table of peaks of draws";
/// of march_peaks_table()
inline constexpr std::string_view kMarchPeaksKind = "a table of peaks of draws of a march";
/// of is_stepped_sine_table()
inline constexpr std::string_view kSteppedSineKind = "a stepped-sine table";
inline constexpr std::string_view kBackboneKind = "a table of a backbone";  ///< of backbone_table()
/// of verification_table()
inline constexpr std::string_view kVerificationKind = "a table of a verification";
/// of comparison_table()
inline constexpr std::string_view kComparisonKind = "a table of compared tests";
/// campaign.csv
inline constexpr std::string_view kCampaignTableKind = "a table of a campaign";
/// sessions.csv of a campaign
inline constexpr std::string_view kSessionsKind = "a table of sessions";
/// conditions.csv of a campaign
inline constexpr std::string_view kConditionsKind = "a table of conditions";
/// leave_one_out.csv of a campaign
inline constexpr std::string_view kLeftOutKind = "a table of what was left out";
/// of harmonics_table()
inline constexpr std::string_view kHarmonicsKind = "a table of predicted harmonics";
/// of histories_table()
inline constexpr std::string_view kHistoriesKind = "a table of predicted histories";
/// of force_control_table()
inline constexpr std::string_view kForceControlKind = "a table of a force control";
/// of html_report(); another page is "an HTML page"
inline constexpr std::string_view kReportKind = "a report of microslip";
inline constexpr std::string_view kSpectrumKind = "a shock response spectrum";  ///< of `spectrum`
inline constexpr std::string_view kMarchKind = "a table of a march";            ///< of MarchTable

/// of slider_errors_table()
inline constexpr std::string_view kSliderErrorsKind = "a table of errors of sliders";
/// draws.csv of joints that were exported
inline constexpr std::string_view kExportedDrawsKind = "a table of exported draws";
/// Of a joint exported to a target: "a joint exported to calculix". Its text has the comment
/// "microslip export: TARGET".
[[nodiscard]] std::string export_kind(std::string_view target);
/// In `modelDescription.xml`, the first file of an archive of FMI that `export` writes.
inline constexpr std::string_view kFmuMark = "<!-- microslip export: fmu -->";

class InputStream;

/// So much of a file tells its kind, unless comments or a very long header fill it.
inline constexpr std::size_t kKindHeadSize = 65536;

/// Of a file: what tells its kind, its first kKindHeadSize bytes or, where no line of them ends
/// that is neither empty nor a comment, so many more. @throws FileError  as InputStream::peek().
[[nodiscard]] std::string_view peek_kind_head(InputStream& file);
/// The same by a path, "-" being standard input. @throws FileError  as read_file().
[[nodiscard]] std::string read_kind_head(const std::string& path);

/// Kind of a file, by its first bytes: the schema of a JSON or TOML file, one of the kinds above by
/// the columns of a table, or its signature. Other tables are distinguished by the names of their
/// columns. Empty where it is none of these. Two files of one kind may replace each other.
[[nodiscard]] std::string file_kind(std::string_view head);

/// Kind of a file by its path; empty for standard input and pipes, which could be read only
/// once, and for what cannot be read.
[[nodiscard]] std::string kind_of_file(const std::string& path);

/// How a file of this program is written.
enum class KindFormat { kJson, kToml, kTable, kOther };

/// A file of this program as messages tell of one that is given in place of another.
struct KnownKind {
  std::string_view kind;      ///< of file_kind()
  std::string_view words;     ///< "a table of levels (levels.csv)"
  KindFormat format;          ///< that it is written in
  bool is_recording = false;  ///< a table that can be read as a recording, too
};

/// Description of a kind; null where it is none of this program, or a table with too few columns of
/// its own to be recognised by them.
[[nodiscard]] const KnownKind* known_kind(std::string_view kind);

/// Description of the kind of a file by its first bytes. @param head  may be the whole file.
[[nodiscard]] const KnownKind* known_kind_of(std::string_view head);

}  // namespace microslip
