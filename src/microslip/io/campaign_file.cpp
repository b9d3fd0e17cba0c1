// SPDX-License-Identifier: MIT
#include "microslip/io/campaign_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "microslip/base/error.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/structured_input.hpp"
#include "microslip/io/text.hpp"
#include "microslip/io/toml_input.hpp"

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
  return (std::filesystem::path(campaign).parent_path() / file).string();
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

std::size_t draws_in(const TomlTable& table) {
  // Of fewer no draw lies beyond each edge of a band of 95 %; of more, more memory than use.
  constexpr std::size_t kFewest = 40;
  constexpr std::size_t kMost = 1'000'000;
  if (!table.has("draws")) return 0;
  const std::size_t draws = table.whole("draws");
  if (draws == 0 || (draws >= kFewest && draws <= kMost)) return draws;
  throw InputError(table.name("draws"), static_cast<double>(draws),
                   fmt::format("must be 0, for no bands, or from {} to {}", kFewest, kMost),
                   "1000 give a smooth band.");
}

/// What only draws show is refused without them, not ignored.
void check_draws_used(const TomlTable& table, std::size_t draws,
                      const std::vector<std::string_view>& keys) {
  if (draws > 0) return;
  for (const std::string_view key : keys) {
    if (!table.has(key)) continue;
    throw InputError(table.name(key), InputState{"given"}, "belongs to draws, and there are none",
                     "Give [identification] draws = 1000, or leave it out.");
  }
}

void read_campaign_identification(const TomlTable& table, CampaignFile& campaign) {
  table.allow_only({"stiffness_N_per_m", "linear_damping", "smoothing", "edges", "atom",
                    "inner_reversals", "draws", "seed", "dissipation_gain_std",
                    "amplitude_gain_std", "session_offsets", "leave_one_out"});
  campaign.stiffness = table.number("stiffness_N_per_m");
  if (!(campaign.stiffness > 0.0 && std::isfinite(campaign.stiffness))) {
    throw InputError(table.name("stiffness_N_per_m"), campaign.stiffness,
                     "must be above 0 and finite");
  }
  campaign.linear_damping = word_in(table, "linear_damping", {"none", "fit"}) == 1;
  if (table.has("smoothing")) campaign.smoothing = table.text("smoothing");
  campaign.edges = word_in(table, "edges", {"sought", "none"}) == 0;
  campaign.atom = flag_in(table, "atom");
  campaign.use_inner_reversals = word_in(table, "inner_reversals", {"leave-out", "use"}) == 1;
  campaign.draws = draws_in(table);
  if (table.has("seed")) campaign.seed = table.whole("seed");
  campaign.dissipation_gain_std = share_in(table, "dissipation_gain_std");
  campaign.amplitude_gain_std = share_in(table, "amplitude_gain_std");
  campaign.session_offsets = flag_in(table, "session_offsets");
  constexpr std::array kAll{LeaveOut::kNothing, LeaveOut::kTests, LeaveOut::kLevels};
  campaign.leave_out = kAll.at(word_in(table, "leave_one_out", {"none", "tests", "levels"}));
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
    conditions.push_back(
        {key, table.is_text(key) ? table.text(key) : fmt::format("{}", table.number(key))});
  }
  return conditions;
}

CampaignTest read_campaign_test(const TomlTable& table, std::string_view file) {
  table.allow_only({"name", "file", "use", "session", "conditions"});
  constexpr std::array kUses{CampaignUse::kIdentify, CampaignUse::kPredict, CampaignUse::kBoth};
  CampaignTest test{.name = file_name_in(table, "name"), .file = path_in(table, "file", file)};
  if (!table.has("use")) (void)table.text("use");  // throws: it is missing
  test.use = kUses.at(word_in(table, "use", {"identify", "predict", "both"}));
  if (table.has("session")) test.session = file_name_in(table, "session");
  test.conditions = read_conditions(table);
  return test;
}

void read_campaign_tests(const TomlTable& top, std::string_view file, CampaignFile& campaign) {
  for (const TomlTable& table : top.tables("test")) {
    CampaignTest test = read_campaign_test(table, file);
    if (std::ranges::count(campaign.tests, test.name, &CampaignTest::name) > 0) {
      throw InputError(table.name("name"), in_quotes(test.name), "must not be that of another test",
                       "Rename one of them.");
    }
    campaign.tests.push_back(std::move(test));
  }
  if (std::ranges::any_of(campaign.tests, &CampaignTest::identifies)) return;
  throw InputError(top.name("test"), fmt::format("{} to predict", campaign.tests.size()),
                   "must have one at least to identify from",
                   "Give one use = \"identify\", or \"both\".");
}

/// What would do nothing.
void check_enough(const TomlTable& top, const CampaignFile& campaign) {
  const TomlTable table = top.table("identification");
  const std::vector<std::string> sessions = campaign.sessions();
  if (campaign.session_offsets && sessions.size() < 2) {
    throw InputError(table.name("session_offsets"), "true",
                     fmt::format("does nothing: all tests to identify from are of session {}",
                                 in_quotes(sessions.front())),
                     "Leave it out, or say which tests are of another session.");
  }
  const auto tests = std::ranges::count_if(campaign.tests, &CampaignTest::identifies);
  if (campaign.leave_out == LeaveOut::kTests && tests < 2) {
    throw InputError(table.name("leave_one_out"), in_quotes("tests"),
                     "leaves nothing: there is one test to identify from",
                     "\"levels\" leaves out one level after the other.");
  }
}

}  // namespace

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
  top.allow_only({"schema", "title", "structure", "identification", "prediction", "test"});
  CampaignFile campaign;
  if (top.has("title")) campaign.title = top.text("title");
  campaign.structure = path_in(top, "structure", file);
  read_campaign_identification(top.table("identification"), campaign);
  if (top.has("prediction")) read_campaign_prediction(top.table("prediction"), campaign);
  read_campaign_tests(top, file, campaign);
  check_enough(top, campaign);
  return campaign;
}

}  // namespace microslip
