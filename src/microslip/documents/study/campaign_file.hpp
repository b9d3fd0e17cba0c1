// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// campaign.toml, schema microslip.campaign/1: several tests of one structure, some to identify its
/// joints from, others to be predicted. Values are SI, their keys end in the unit.
///
///     schema = "microslip.campaign/1"
///     title = "…"            optional
///     structure = "rig.toml" of which all tests are, relative to the folder of the campaign; or
///     model = "model.toml"   the same, with any number of joints, some to be identified
///     [identification]       optional: edges = "sought" or "none", draws, seed, session_offsets,
///                            leave_one_out = "none", "tests" or "levels"; of a rig
///                            stiffness_N_per_m, optional: linear_damping = "none" or "fit",
///                            smoothing = "gcv" or "lambda=X", atom, inner_reversals = "leave-out"
///                            or "use", dissipation_gain_std, amplitude_gain_std; of a model,
///                            optional: frequency = "change", "absolute" or "ignore", stiffness =
///                            "given" or "fit", forcing = "excitation" or "modal", harmonics, and
///                            leave_one_out = "modes"
///     [prediction]           frequency_std, force_gain_std, each optional; optional
///     [[test]]               name, file, use = "identify", "predict" or "both"; optional: session,
///                            conditions = { … }, numbers and texts; kind = "sweep",
///                            "constant-response", "ringdown" or "loops"; of ring-downs sensors = {
///                            CHANNEL = "POINT" } and mode; of loops force and displacement, names
///                            of channels; of recordings assume_units = [ … ], as "acc1=m/s^2" or
///                            "SI", allow_truncated and rate_Hz; at least one

namespace microslip {

// g++ 12 says that scoped enumerators hide names of other types, which they do not.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"

/// Use of a test of a campaign.
enum class CampaignUse {
  kIdentify,  ///< the joint is identified from it, with the others
  kPredict,   ///< it is predicted
  kBoth,      ///< both: its prediction is no proof
};

/// Parts that are left out in turn and predicted from the rest.
enum class LeaveOut {
  kNothing,
  kTests,   ///< each test
  kLevels,  ///< each level
  kModes,   ///< each mode, over all tests; of a model
};

/// What is left out at once: "test", "level" or "mode"; empty of nothing.
[[nodiscard]] std::string_view name_of_part(LeaveOut what);

/// Subject of a campaign.
enum class CampaignSubject {
  kRig,    ///< a rig.toml: one joint, from its levels
  kModel,  ///< a model.toml: joints, from levels of its modes
};

/// Kind of a test, where its file does not determine it or another one is meant.
enum class CampaignKind {
  kFromFile,          ///< from the file: levels, modal levels, steady records, stepped sines
  kSweep,             ///< stepped sines, of which the response is predicted
  kConstantResponse,  ///< stepped sines, of which the force is predicted
  kRingDown,          ///< a recording of a free decay
  kLoops,             ///< recordings of force and displacement of the joint
};

/// Use of the frequencies of levels of modes, as FrequencyUse of calibrate().
enum class FrequencyOfLevels { kChange, kAbsolute, kIgnore };

#pragma GCC diagnostic pop

/// "sweep", "constant-response", "ringdown", "loops"; "from the file".
[[nodiscard]] std::string_view to_string(CampaignKind kind);

/// "identify", "predict", "both".
[[nodiscard]] std::string_view to_string(CampaignUse use);

/// A condition of a test: "torque_Nm", "20".
struct CampaignCondition {
  std::string name;                   ///< letters, digits and underscores
  std::string value;                  ///< as text; a number as the shortest that reads back
  std::optional<double> number = {};  ///< nothing of a text
};

/// A test of a campaign.
struct CampaignTest {
  std::string name;                                ///< usable as a file name; unique
  std::string file;                                ///< to be opened; may be `FILE:VARIABLE`
  CampaignUse use = CampaignUse::kIdentify;        ///< what it is for
  std::string session = "1";                       ///< in which it was measured
  std::vector<CampaignCondition> conditions = {};  ///< in alphabetical order
  CampaignKind kind = CampaignKind::kFromFile;     ///< what it is
  std::vector<std::string> sensors = {};           ///< CHANNEL=POINT; of ring-downs
  std::size_t mode = 1;                            ///< from 1; of ring-downs; 0: all there are
  std::string force = {};         ///< channel; of loops. Empty for the only force there is
  std::string displacement = {};  ///< as above
  std::vector<std::string> assumed_units = {};  ///< CHANNEL=UNIT or SI; of recordings
  bool allow_truncated = false;                 ///< of recordings
  std::optional<double> rate = {};              ///< Hz; of recordings without times

  /// Whether the joint is identified from it.
  [[nodiscard]] bool identifies() const { return use != CampaignUse::kPredict; }
  /// Whether it is predicted.
  [[nodiscard]] bool predicted() const { return use != CampaignUse::kIdentify; }
  /// The condition of that name; null where it has none.
  [[nodiscard]] const CampaignCondition* condition(std::string_view name) const;
};

/// Contents of a campaign.toml.
struct CampaignFile {
  std::string title = {};                           ///< may be empty
  CampaignSubject subject = CampaignSubject::kRig;  ///< what `structure` is
  std::string structure = {};         ///< path of rig.toml or model.toml, to be opened
  double stiffness = 0.0;             ///< k of the stuck joint, N/m; > 0; of a rig
  bool linear_damping = false;        ///< whether β is fitted
  std::string smoothing = "gcv";      ///< as of set_smoothing()
  bool edges = true;                  ///< whether edges of the density are sought
  bool atom = false;                  ///< whether one is sought at the end of the density
  bool use_inner_reversals = false;   ///< takes levels with inner reversals too
  std::size_t draws = 0;              ///< of joint and predictions; 0: none
  std::uint64_t seed = 1;             ///< of them
  double dissipation_gain_std = 0.0;  ///< of D, common to all levels of a test, relative
  double amplitude_gain_std = 0.0;    ///< of A, as above
  bool session_offsets = false;       ///< whether those of the frequency are fitted
  FrequencyOfLevels frequency = FrequencyOfLevels::kChange;  ///< of a model
  bool fit_stiffness = false;               ///< whether k of the joints is found too; of a model
  bool modal_forcing = false;               ///< whether nothing drove the levels; of a model
  std::size_t harmonics = 5;                ///< of vibrations of a model
  LeaveOut leave_out = LeaveOut::kNothing;  ///< what is left out in turn
  /// Of a predicted frequency, relative; nothing: what the frequencies miss those of the model by.
  std::optional<double> frequency_std = {};
  double force_gain_std = 0.0;           ///< of the force of a predicted test, relative
  std::vector<CampaignTest> tests = {};  ///< in the order of the file

  /// Whether it is of a model.toml.
  [[nodiscard]] bool of_model() const { return subject == CampaignSubject::kModel; }
  /// The sessions of the tests to identify from, in the order in which these first name them.
  [[nodiscard]] std::vector<std::string> sessions() const;
  /// The names of all conditions, in alphabetical order.
  [[nodiscard]] std::vector<std::string> conditions() const;
};

/// @param text  the file's whole text.
/// @param file  its name: its folder is where those it names are sought.
/// @throws FormatError  for text that is no TOML, another schema, keys unknown or missing.
/// @throws InputError   naming `campaign.toml:12:3: test[1].use` for a value of a wrong type or one
///                      that breaks a rule: no test to identify from, two of one name, options that
///                      would do nothing.
[[nodiscard]] CampaignFile parse_campaign(std::string_view text, std::string_view file);

}  // namespace microslip
