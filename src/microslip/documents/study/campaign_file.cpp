// SPDX-License-Identifier: MIT
#include "microslip/documents/study/campaign_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <set>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/named_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/config/structured_input.hpp"
#include "microslip/io/config/toml_input.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/recordings/assumed_units.hpp"

namespace microslip {
namespace {

/// One of some words, or the first where the key is missing.
std::size_t word_in(const TomlTable& table, std::string_view key,
                    const std::vector<std::string_view>& words) {
  if (!table.has(key)) return 0;
  const std::string found = table.text(key);
  const auto at = std::ranges::find(words, found);
  if (at != words.end()) return static_cast<std::size_t>(at - words.begin());
  throw InputError(table.name(key), in_quotes(found),
                   fmt::format("must be one of {}", fmt::join(words, ", ")));
}

bool flag_in(const TomlTable& table, std::string_view key) {
  return table.has(key) && table.boolean(key);
}

double finite_in(const TomlTable& table, std::string_view key) {
  const double value = table.number(key);
  if (std::isfinite(value)) return value;
  throw InputError(table.name(key), value, "must be finite");
}

/// A standard deviation as a share.
double share_in(const TomlTable& table, std::string_view key) {
  constexpr double kLargest = 0.3;
  if (!table.has(key)) return 0.0;
  const double value = table.number(key);
  if (value >= 0.0 && value < kLargest) return value;
  throw InputError(table.name(key), value, "must be 0 or more and below 0.3, as a share of 1");
}

std::string path_in(const TomlTable& table, std::string_view key, std::string_view campaign) {
  const std::string file = table.text(key);
  if (file.empty() || file == "-") {
    throw InputError(table.name(key), in_quotes(file), "must be the path of a file");
  }
  return file_beside(std::string(campaign), file);
}

/// Names of tests and sessions become names of files.
std::string file_name_in(const TomlTable& table, std::string_view key) {
  const std::string name = table.text(key);
  const bool usable = !name.empty() && name.find('/') == std::string::npos &&
                      !name.starts_with('.') && printable(name) == name;
  if (usable) return name;
  throw InputError(table.name(key), in_quotes(name),
                   "must be usable in the name of a file: not empty, without /, not beginning with "
                   "a point",
                   "Rename it.");
}

std::size_t draws_in(const TomlTable& table, CampaignSubject subject) {
  // Of fewer no draw lies beyond each edge of a band of 95 %, and several joints are the mean of
  // theirs; of more, more memory than use.
  const bool of_model = subject == CampaignSubject::kModel;
  const std::size_t fewest = of_model ? 100 : 40;
  const std::size_t most = of_model ? 100'000 : 1'000'000;
  if (!table.has("draws")) return 0;
  const std::size_t draws = table.whole("draws");
  if (draws == 0 || (draws >= fewest && draws <= most)) return draws;
  throw InputError(table.name("draws"), static_cast<double>(draws),
                   fmt::format("must be 0, for no bands, or from {} to {}", fewest, most),
                   "1000 give a smooth band.");
}

/// Refuses keys that need draws where there are none.
void check_draws_used(const TomlTable& table, std::size_t draws,
                      const std::vector<std::string_view>& keys) {
  if (draws > 0) return;
  for (const std::string_view key : keys) {
    if (!table.has(key)) continue;
    throw InputError(table.name(key), InputState{"given"}, "requires draws, and there are none",
                     "Give [identification] draws = 1000, or leave it out.");
  }
}

const std::vector<std::string_view> kKeysOfRig{
    "stiffness_N_per_m", "linear_damping",       "smoothing",         "atom",
    "inner_reversals",   "dissipation_gain_std", "amplitude_gain_std"};
const std::vector<std::string_view> kKeysOfModel{"frequency", "stiffness", "forcing", "harmonics"};

/// Keys that what the campaign is of does not have.
void check_of_subject(const TomlTable& table, CampaignSubject subject) {
  const bool of_model = subject == CampaignSubject::kModel;
  for (const std::string_view key : of_model ? kKeysOfRig : kKeysOfModel) {
    if (!table.has(key)) continue;
    throw InputError(
        table.name(key), InputState{"given"},
        of_model
            ? "applies to one joint, identified from its levels, and this campaign is of a model"
            : "applies to joints of a model, identified from levels of modes, and this campaign is "
              "of a rig",
        of_model
            ? "Leave it out: the model.toml gives k of each joint and the gains of the sensors."
            : "Leave it out, or give model = \"model.toml\" in place of structure.");
  }
}

void read_identification_of_rig(const TomlTable& table, CampaignFile& campaign) {
  campaign.stiffness = table.number("stiffness_N_per_m");
  if (!(campaign.stiffness > 0.0 && std::isfinite(campaign.stiffness))) {
    throw InputError(table.name("stiffness_N_per_m"), campaign.stiffness,
                     "must be above 0 and finite");
  }
  campaign.linear_damping = word_in(table, "linear_damping", {"none", "fit"}) == 1;
  if (table.has("smoothing")) campaign.smoothing = table.text("smoothing");
  campaign.atom = flag_in(table, "atom");
  campaign.use_inner_reversals = word_in(table, "inner_reversals", {"leave-out", "use"}) == 1;
  campaign.dissipation_gain_std = share_in(table, "dissipation_gain_std");
  campaign.amplitude_gain_std = share_in(table, "amplitude_gain_std");
}

void read_identification_of_model(const TomlTable& table, CampaignFile& campaign) {
  constexpr std::size_t kMostHarmonics = 100;
  constexpr std::array kUses{FrequencyOfLevels::kChange, FrequencyOfLevels::kAbsolute,
                             FrequencyOfLevels::kIgnore};
  campaign.frequency = kUses.at(word_in(table, "frequency", {"change", "absolute", "ignore"}));
  campaign.fit_stiffness = word_in(table, "stiffness", {"given", "fit"}) == 1;
  if (campaign.fit_stiffness && campaign.frequency != FrequencyOfLevels::kAbsolute) {
    throw InputError(table.name("stiffness"), in_quotes("fit"),
                     "needs absolute frequencies: their changes do not determine k",
                     "Give frequency = \"absolute\", or leave it out.");
  }
  campaign.modal_forcing = word_in(table, "forcing", {"excitation", "modal"}) == 1;
  if (!table.has("harmonics")) return;
  campaign.harmonics = table.whole("harmonics");
  if (campaign.harmonics >= 1 && campaign.harmonics <= kMostHarmonics) return;
  throw InputError(table.name("harmonics"), static_cast<double>(campaign.harmonics),
                   fmt::format("must be from 1 to {}", kMostHarmonics));
}

LeaveOut leave_out_in(const TomlTable& table, CampaignSubject subject) {
  constexpr std::array kAll{LeaveOut::kNothing, LeaveOut::kTests, LeaveOut::kLevels,
                            LeaveOut::kModes};
  std::vector<std::string_view> words{"none", "tests", "levels"};
  if (subject == CampaignSubject::kModel) words.emplace_back("modes");
  return kAll.at(word_in(table, "leave_one_out", words));
}

void read_campaign_identification(const TomlTable& table, CampaignFile& campaign) {
  std::vector<std::string_view> known{"edges", "draws", "seed", "session_offsets", "leave_one_out"};
  for (const auto* keys : {&kKeysOfRig, &kKeysOfModel})
    std::ranges::copy(*keys, std::back_inserter(known));
  table.allow_only(known);
  check_of_subject(table, campaign.subject);
  if (campaign.of_model()) {
    read_identification_of_model(table, campaign);
  } else {
    read_identification_of_rig(table, campaign);
  }
  campaign.edges = word_in(table, "edges", {"sought", "none"}) == 0;
  campaign.draws = draws_in(table, campaign.subject);
  if (table.has("seed")) campaign.seed = table.whole("seed");
  campaign.session_offsets = flag_in(table, "session_offsets");
  if (campaign.session_offsets && campaign.frequency == FrequencyOfLevels::kAbsolute) {
    throw InputError(table.name("session_offsets"), "true",
                     "contradicts frequency = \"absolute\", which assumes exact modes of the model",
                     "Give frequency = \"change\", or leave it out.");
  }
  campaign.leave_out = leave_out_in(table, campaign.subject);
  std::vector<std::string_view> drawn{"seed", "dissipation_gain_std", "amplitude_gain_std"};
  if (campaign.leave_out != LeaveOut::kNothing) drawn.emplace_back("leave_one_out");
  check_draws_used(table, campaign.draws, drawn);
}

void read_campaign_prediction(const TomlTable& table, CampaignFile& campaign) {
  table.allow_only({"frequency_std", "force_gain_std"});
  if (table.has("frequency_std")) campaign.frequency_std = share_in(table, "frequency_std");
  campaign.force_gain_std = share_in(table, "force_gain_std");
  check_draws_used(table, campaign.draws, {"frequency_std", "force_gain_std"});
}

std::vector<CampaignCondition> read_conditions(const TomlTable& test) {
  std::vector<CampaignCondition> conditions;
  if (!test.has("conditions")) return conditions;
  const TomlTable table = test.table("conditions");
  for (const std::string& key : table.keys()) {
    const bool plain = std::ranges::all_of(key, [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '_';  // it becomes the name of a column
    });
    if (!plain || key.empty()) {
      throw InputError(table.name(key), in_quotes(key),
                       "must be named by letters, digits and underscores", "Rename it.");
    }
    if (table.is_text(key)) {
      conditions.push_back({key, table.text(key)});
    } else {
      const double number = finite_in(table, key);
      conditions.push_back({key, fmt::format("{}", number), number});
    }
  }
  return conditions;
}

constexpr std::array kCampaignKinds{CampaignKind::kSweep, CampaignKind::kConstantResponse,
                                    CampaignKind::kRingDown, CampaignKind::kLoops};

CampaignKind kind_in(const TomlTable& table) {
  if (!table.has("kind")) return CampaignKind::kFromFile;
  std::vector<std::string_view> words;
  for (const CampaignKind kind : kCampaignKinds) words.push_back(to_string(kind));
  return kCampaignKinds.at(word_in(table, "kind", words));
}

/// Keys that one kind alone has.
void check_of_kind(const TomlTable& table, const CampaignTest& test, CampaignKind kind,
                   const std::vector<std::string_view>& keys) {
  if (test.kind == kind) return;
  for (const std::string_view key : keys) {
    if (!table.has(key)) continue;
    throw InputError(table.name(key), InputState{"given"},
                     fmt::format("applies to kind = \"{}\", and kind is {} here", to_string(kind),
                                 test.kind == CampaignKind::kFromFile
                                     ? "not given"
                                     : fmt::format("\"{}\"", to_string(test.kind))),
                     fmt::format("Leave it out, or give kind = \"{}\".", to_string(kind)));
  }
}

/// The kind of prediction of stepped sines does not apply to levels reduced from them.
void check_kind_used(const TomlTable& table, const CampaignTest& test) {
  const bool of_sweeps =
      test.kind == CampaignKind::kSweep || test.kind == CampaignKind::kConstantResponse;
  if (!of_sweeps || test.predicted()) return;
  throw InputError(table.name("kind"), in_quotes(to_string(test.kind)),
                   "has no effect: it applies to a sweep that is predicted, and this is not one",
                   "Leave it out.");
}

std::vector<std::string> sensors_in(const TomlTable& test) {
  std::vector<std::string> sensors;
  if (!test.has("sensors")) return sensors;
  const TomlTable table = test.table("sensors");
  for (const std::string& channel : table.keys()) {
    sensors.push_back(fmt::format("{}={}", channel, table.text(channel)));
  }
  if (!sensors.empty()) return sensors;
  throw InputError(test.name("sensors"), "empty", "must have at least one channel",
                   "For instance { acc1 = \"drive\" }.");
}

std::size_t mode_in(const TomlTable& table, const CampaignTest& test, CampaignSubject subject) {
  const bool of_model = subject == CampaignSubject::kModel;
  if (!table.has("mode")) return of_model ? 0 : 1;
  const std::size_t mode = table.whole("mode");
  if (mode == 0) throw InputError(table.name("mode"), 0.0, "must be 1 or more");
  if (of_model || mode == 1 || !test.identifies()) return mode;
  throw InputError(table.name("mode"), static_cast<double>(mode),
                   "must be 1 to identify from: frequencies of levels are those of the first mode",
                   "Give use = \"predict\".");
}

/// Loops are of a joint by itself.
void check_kind_of_subject(const TomlTable& table, const CampaignTest& test,
                           CampaignSubject subject) {
  if (subject != CampaignSubject::kModel || test.kind != CampaignKind::kLoops) return;
  throw InputError(
      table.name("kind"), in_quotes("loops"),
      "is a test of one joint, and the campaign is of a model",
      test.identifies()
          ? "The subcommand identify identifies a joint from it; the model refers to its file."
          : "The subcommand verify, with the option joint, predicts it with the model that is "
            "written.");
}

void read_kind(const TomlTable& table, CampaignSubject subject, CampaignTest& test) {
  test.kind = kind_in(table);
  check_kind_of_subject(table, test, subject);
  check_kind_used(table, test);
  check_of_kind(table, test, CampaignKind::kRingDown, {"sensors", "mode"});
  check_of_kind(table, test, CampaignKind::kLoops, {"force", "displacement"});
  test.sensors = sensors_in(table);
  test.mode = mode_in(table, test, subject);
  if (table.has("force")) test.force = table.text("force");
  if (table.has("displacement")) test.displacement = table.text("displacement");
}

void read_recording_keys(const TomlTable& table, CampaignTest& test) {
  test.allow_truncated = flag_in(table, "allow_truncated");
  if (table.has("rate_Hz")) {
    test.rate = table.number("rate_Hz");
    if (!(*test.rate > 0.0)) throw InputError(table.name("rate_Hz"), *test.rate, "must be above 0");
  }
  if (!table.has("assume_units")) return;
  test.assumed_units = table.texts("assume_units");
  try {
    (void)parse_assumed_units(test.assumed_units);
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", table.name("assume_units"), error.name()));
  }
}

CampaignTest read_campaign_test(const TomlTable& table, std::string_view file,
                                CampaignSubject subject) {
  table.allow_only({"name", "file", "use", "session", "conditions", "kind", "sensors", "mode",
                    "force", "displacement", "assume_units", "allow_truncated", "rate_Hz"});
  constexpr std::array kUses{CampaignUse::kIdentify, CampaignUse::kPredict, CampaignUse::kBoth};
  CampaignTest test{.name = file_name_in(table, "name"), .file = path_in(table, "file", file)};
  if (subject == CampaignSubject::kModel && test.name == "modal") {
    throw InputError(table.name("name"), in_quotes(test.name),
                     "must be another: modal_levels.csv holds the levels of all tests",
                     "Rename it.");
  }
  if (!table.has("use")) (void)table.text("use");  // throws: it is missing
  test.use = kUses.at(word_in(table, "use", {"identify", "predict", "both"}));
  if (table.has("session")) test.session = file_name_in(table, "session");
  test.conditions = read_conditions(table);
  read_kind(table, subject, test);
  read_recording_keys(table, test);
  return test;
}

void read_campaign_tests(const TomlTable& top, std::string_view file, CampaignFile& campaign) {
  for (const TomlTable& table : top.tables("test")) {
    CampaignTest test = read_campaign_test(table, file, campaign.subject);
    if (std::ranges::count(campaign.tests, test.name, &CampaignTest::name) > 0) {
      throw InputError(table.name("name"), in_quotes(test.name), "must not be that of another test",
                       "Rename one of them.");
    }
    campaign.tests.push_back(std::move(test));
  }
  if (std::ranges::any_of(campaign.tests, &CampaignTest::identifies)) return;
  throw InputError(top.name("test"), fmt::format("{} to predict", campaign.tests.size()),
                   "must have at least one to identify from",
                   "Give one use = \"identify\", or \"both\".");
}

void read_subject(const TomlTable& top, std::string_view file, CampaignFile& campaign) {
  if (!top.has("model")) {
    campaign.structure = path_in(top, "structure", file);
    return;
  }
  if (top.has("structure")) {
    throw InputError(top.name("model"), InputState{"given"},
                     "must not be given with structure: a campaign has one of them",
                     "structure is a rig.toml, model a model.toml.");
  }
  campaign.subject = CampaignSubject::kModel;
  campaign.structure = path_in(top, "model", file);
}

/// Refuses keys without effect.
void check_enough(const TomlTable& top, const CampaignFile& campaign) {
  const std::vector<std::string> sessions = campaign.sessions();
  if (campaign.session_offsets && sessions.size() < 2) {
    throw InputError(top.table("identification").name("session_offsets"), "true",
                     fmt::format("has no effect: all tests to identify from are of session {}",
                                 in_quotes(sessions.front())),
                     "Leave it out, or specify the tests of another session.");
  }
  const auto tests = std::ranges::count_if(campaign.tests, &CampaignTest::identifies);
  if (campaign.leave_out == LeaveOut::kTests && tests < 2) {
    throw InputError(top.table("identification").name("leave_one_out"), in_quotes("tests"),
                     "leaves nothing: there is one test to identify from",
                     "\"levels\" leaves out one level at a time.");
  }
}

}  // namespace

std::string_view name_of_part(LeaveOut what) {
  switch (what) {
    case LeaveOut::kTests:
      return "test";
    case LeaveOut::kLevels:
      return "level";
    case LeaveOut::kModes:
      return "mode";
    case LeaveOut::kNothing:
      break;
  }
  return "";
}

std::string_view to_string(CampaignUse use) {
  switch (use) {
    case CampaignUse::kIdentify:
      return "identify";
    case CampaignUse::kPredict:
      return "predict";
    case CampaignUse::kBoth:
      break;
  }
  return "both";
}

std::string_view to_string(CampaignKind kind) {
  switch (kind) {
    case CampaignKind::kSweep:
      return "sweep";
    case CampaignKind::kConstantResponse:
      return "constant-response";
    case CampaignKind::kRingDown:
      return "ringdown";
    case CampaignKind::kLoops:
      return "loops";
    case CampaignKind::kFromFile:
      break;
  }
  return "from the file";
}

const CampaignCondition* CampaignTest::condition(std::string_view name) const {
  const auto found = std::ranges::find(conditions, name, &CampaignCondition::name);
  return found == conditions.end() ? nullptr : &*found;
}

std::vector<std::string> CampaignFile::conditions() const {
  std::set<std::string> names;
  for (const CampaignTest& test : tests) {
    for (const CampaignCondition& one : test.conditions) names.insert(one.name);
  }
  return {names.begin(), names.end()};
}

std::vector<std::string> CampaignFile::sessions() const {
  std::vector<std::string> names;
  for (const CampaignTest& test : tests) {
    if (test.identifies() && std::ranges::count(names, test.session) == 0) {
      names.push_back(test.session);
    }
  }
  return names;
}

CampaignFile parse_campaign(std::string_view text, std::string_view file) {
  const toml::table table = parse_toml(text, file);
  const TomlTable top(table, file);
  check_schema(top.place("schema"), top.text("schema"), kCampaignKind, "a campaign");
  top.allow_only({"schema", "title", "structure", "model", "identification", "prediction", "test"});
  CampaignFile campaign;
  if (top.has("title")) campaign.title = top.text("title");
  read_subject(top, file, campaign);
  if (!campaign.of_model() || top.has("identification")) {
    read_campaign_identification(top.table("identification"), campaign);
  }
  if (top.has("prediction")) read_campaign_prediction(top.table("prediction"), campaign);
  read_campaign_tests(top, file, campaign);
  check_enough(top, campaign);
  return campaign;
}

}  // namespace microslip
