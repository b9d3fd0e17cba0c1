// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign/campaign_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/workflow/campaign/campaign.hpp"
#include "microslip/workflow/campaign/campaign_joints.hpp"
#include "microslip/workflow/campaign/campaign_tables.hpp"
#include "microslip/workflow/campaign/campaign_test_kinds.hpp"
#include "microslip/workflow/compare/comparison_table.hpp"
#include "microslip/workflow/identify/smoothing_text.hpp"
#include "microslip/workflow/text/distinct_files.hpp"

namespace microslip {
namespace {

namespace fs = std::filesystem;

void check_structure(const CampaignFile& plan, const std::string& text) {
  const std::string_view asked = plan.of_model() ? kModelKind : kRigKind;
  const std::string kind = file_kind(text);
  if (kind == asked) return;
  if (plan.of_model()) {
    throw InputError("model", in_quotes(plan.structure), "must be a model.toml",
                     kind == kRigKind ? "Give a rig.toml, of one joint, as structure."
                                      : "The subcommand modes makes one from matrices or a test.");
  }
  throw InputError("structure", in_quotes(plan.structure), "must be a rig.toml, of one joint",
                   kind == kModelKind ? "Give a model.toml, whose joints are identified from "
                                        "levels of its modes, as model in place of structure."
                                      : "A structure given by its modes has [modes] there.");
}

/// In the words of campaign.toml: only the inversion has draws, and p is of another method.
void check_smoothing(const CampaignRun& run, const CampaignFile& plan) {
  const std::string place = fmt::format("{}: identification.smoothing", printable(run.campaign));
  IdentificationOptions none;
  try {
    if (!plan.smoothing.starts_with("p=")) return set_smoothing(plan.smoothing, std::nullopt, none);
  } catch (const InputError& error) {
    throw error.renamed(place);
  }
  throw InputError(place, in_quotes(plan.smoothing), "must be gcv or lambda=X",
                   "p is of the method spline of identify, which has no draws.");
}

/// All levels are taken to be driven alike: nothing drives a decay, and a steady record is driven.
void check_forcing(const CampaignFile& plan, const std::vector<TestFile>& files) {
  if (!plan.of_model()) return;
  for (std::size_t t = 0; t < plan.tests.size(); ++t) {
    const CampaignTest& test = plan.tests[t];
    if (!test.identifies()) continue;
    const bool decay = test.kind == CampaignKind::kRingDown;
    if (decay && !plan.modal_forcing) {
      throw InputError(
          fmt::format("test '{}': kind", test.name), in_quotes("ringdown"),
          "must not be used to identify with forcing = \"excitation\": a decay is not driven",
          "Give forcing = \"modal\", and driven levels in a campaign of their own.");
    }
    if (!decay && plan.modal_forcing && files[t].content != TestContent::kModalLevels) {
      throw InputError(fmt::format("test '{}'", test.name), in_quotes(test.file),
                       "must not be used to identify with forcing = \"modal\": a steady record is "
                       "driven by the excitation",
                       "Give forcing = \"excitation\", and decays in a campaign of their own.");
    }
  }
}

/// Conditions of tests that are predicted alone are columns, no more.
bool has_conditions(const CampaignFile& plan) {
  return std::ranges::any_of(plan.tests, [](const CampaignTest& test) {
    return test.identifies() && !test.conditions.empty();
  });
}

}  // namespace

OpenedCampaign open_campaign(const CampaignRun& run) {
  if (run.campaign == "-") {
    throw InputError("campaign", "standard input", "must be a file: its folder has the tests");
  }
  NamedInput campaign{run.campaign, read_file(run.campaign)};
  CampaignFile plan = parse_campaign(campaign.text, input_name(run.campaign));
  NamedInput structure{plan.structure, read_file(plan.structure)};
  check_structure(plan, structure.text);
  check_smoothing(run, plan);
  std::vector<std::string> paths;
  for (const CampaignTest& test : plan.tests) paths.push_back(test.file);
  check_distinct_files(paths);
  std::vector<TestFile> files;
  for (const CampaignTest& test : plan.tests) {
    check_campaign_test(test, files.emplace_back(open_test(test.file)), plan.subject);
  }
  check_forcing(plan, files);
  OpenedCampaign opened{std::move(plan), std::move(campaign), std::move(structure),
                        std::move(files)};
  if (opened.plan.of_model()) opened.model = model_to_calibrate(opened.structure);
  return opened;
}

std::vector<std::string> sessions_with_model(const CampaignFile& plan) {
  std::vector<std::string> names;
  if (!plan.session_offsets) return names;
  const std::string first = plan.sessions().front();
  for (const CampaignTest& test : plan.tests) {
    if (!test.predicted() || test.session == first) continue;
    if (std::ranges::count(names, test.session) == 0) names.push_back(test.session);
  }
  return names;
}

std::string model_name(const std::string& session) { return fmt::format("model_{}.toml", session); }

std::string in_folder(const CampaignRun& run, const std::string& name) {
  return (fs::path(run.out) / name).string();
}

std::vector<ResultFile> files_of(const CampaignRun& run, const OpenedCampaign& opened) {
  const CampaignFile& plan = opened.plan;
  std::vector<ResultFile> files;
  const auto add = [&](const std::string& name, std::string_view kind) {
    files.push_back({in_folder(run, name), kind});
  };
  const std::string_view levels = plan.of_model() ? kModalLevelsKind : kLevelsKind;
  const TestContent table = plan.of_model() ? TestContent::kModalLevels : TestContent::kLevels;
  for (std::size_t t = 0; t < plan.tests.size(); ++t) {
    const CampaignTest& test = plan.tests[t];
    if (test.identifies() && opened.tests[t].content != table) {
      files.push_back({levels_path(run.out, test), levels});
    }
  }
  std::ranges::move(
      plan.of_model() ? planned_files_of_model(run, opened) : planned_files_of_rig(run, plan),
      std::back_inserter(files));
  add("model.toml", kModelKind);
  for (const std::string& session : sessions_with_model(plan)) add(model_name(session), kModelKind);
  if (std::ranges::any_of(plan.tests, &CampaignTest::predicted)) {
    add("comparison.csv", kComparisonKind);
  }
  add("campaign.csv", kCampaignTableKind);
  add("sessions.csv", kSessionsKind);
  if (has_conditions(plan)) add("conditions.csv", kConditionsKind);
  if (plan.leave_out != LeaveOut::kNothing) add("leave_one_out.csv", kLeftOutKind);
  return files;
}

void check_not_replaced(const CampaignRun& run, const CampaignFile& plan,
                        const std::vector<ResultFile>& files) {
  std::vector<std::string> inputs{run.campaign, plan.structure};
  for (const CampaignTest& test : plan.tests) inputs.push_back(part_of_file(test.file).file);
  for (const ResultFile& file : files) {
    for (const std::string& input : inputs) {
      std::error_code none;
      if (!fs::equivalent(file.path, input, none)) continue;
      throw InputError("out", in_quotes(run.out),
                       fmt::format("must not be the folder of {}, which would be replaced", input),
                       "Choose another folder.");
    }
  }
}

}  // namespace microslip
