// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign/campaign_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <string_view>

#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/workflow/campaign/campaign_joints.hpp"
#include "microslip/workflow/campaign/campaign_levels.hpp"

namespace microslip {
namespace {

namespace fs = std::filesystem;

/// Conditions of tests that are predicted alone are columns, no more.
bool has_conditions(const CampaignFile& plan) {
  return std::ranges::any_of(plan.tests, [](const CampaignTest& test) {
    return test.identifies() && !test.conditions.empty();
  });
}

}  // namespace

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

}  // namespace microslip
