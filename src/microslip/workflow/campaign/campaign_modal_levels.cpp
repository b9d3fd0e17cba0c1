// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign/campaign_modal_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "microslip/documents/levels/modal_levels_file.hpp"
#include "microslip/io/bytes/input_name.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/workflow/campaign/campaign_test_kinds.hpp"
#include "microslip/workflow/identify/calibration.hpp"

namespace microslip {
namespace {

/// The table of a test: as it is, or reduced.
NamedInput modal_table_of_test(const OpenedCampaign& campaign, std::size_t number,
                               const std::string& out, const std::string& command,
                               const Progress& progress, CampaignLevels& all) {
  const CampaignTest& test = campaign.plan.tests[number];
  const TestFile& file = campaign.tests[number];
  if (file.content == TestContent::kModalLevels) return {file.path, file.text};
  ReducedCampaignTest reduced = of_campaign_test(
      test, [&] { return reduce_modal_test(campaign, number, command, progress); });
  all.converged = all.converged && reduced.converged;
  for (const Warning& warning : reduced.warnings) {
    all.warnings.push_back({warning.code, fmt::format("{}: {}", test.name, warning.text)});
  }
  all.tables.push_back({levels_path(out, test), kModalLevelsKind, std::move(reduced.text)});
  return {all.tables.back().path, all.tables.back().content};
}

/// A vector of one value per level, NaN where it was not measured.
std::vector<double> whole(const std::vector<double>& values, std::size_t count) {
  return values.empty() ? std::vector<double>(count, std::numeric_limits<double>::quiet_NaN())
                        : values;
}

std::size_t number_of_session(const CampaignFile& campaign, const CampaignTest& test) {
  const std::vector<std::string> sessions = campaign.sessions();
  return static_cast<std::size_t>(std::ranges::find(sessions, test.session) - sessions.begin());
}

void append_modal_test(const CampaignFile& campaign, std::size_t number, const ModelFile& model,
                       const NamedInput& input, CampaignModalLevels& all) {
  const std::vector<std::string> joints = names_of_joints(model);
  const LabelledModalLevels table = parse_labelled_modal_levels(
      input.text, input_name(input.path), joints, model.structure.linear().vibrations());
  const CampaignTest& test = campaign.tests[number];
  const std::vector<std::size_t> asked = of_campaign_test(
      test, [&] { return levels_of_modes(table.levels, campaign_reading(test).modes, test.file); });
  ModalLevels more = some_levels(table.levels, asked);
  const std::size_t count = more.size();
  if (campaign.session_offsets) {
    more.session.assign(count, number_of_session(campaign, test));
  }
  append(more, all.modal);
  CampaignLevels& levels = all.levels;
  for (const std::size_t mode : more.mode) levels.mode.push_back(mode + 1);
  levels.test.insert(levels.test.end(), count, number);
  for (const std::size_t i : asked) {
    levels.source.push_back(table.source.empty() ? numbered_level(i) : table.source[i]);
    levels.flags.push_back(table.flags.empty() ? "" : table.flags[i]);
  }
  levels.reversals.insert(levels.reversals.end(), count, 2.0);
  std::ranges::copy(more.displacement, std::back_inserter(levels.levels.amplitude));
  std::ranges::copy(whole(more.frequency, count), std::back_inserter(levels.levels.frequency));
  std::ranges::copy(whole({}, count), std::back_inserter(levels.levels.dissipation));
}

/// A column that may be empty, with cells that may be.
void add_column(CsvWriter& table, const std::string& name, const Dimension& dimension,
                const std::vector<double>& values) {
  if (!values.empty()) table.add_numbers_or_empty(name, dimension, values);
}

}  // namespace

CampaignModalLevels campaign_modal_levels(const OpenedCampaign& campaign, const std::string& out,
                                          const std::string& command, const Progress& progress) {
  CampaignModalLevels all;
  for (std::size_t t = 0; t < campaign.tests.size(); ++t) {
    if (!campaign.plan.tests[t].identifies()) continue;
    append_modal_test(campaign.plan, t, *campaign.model,
                      modal_table_of_test(campaign, t, out, command, progress, all.levels), all);
  }
  return all;
}

std::vector<double> measured_losses(const CalibrationResult& found) {
  std::vector<double> losses;
  for (const CalibratedLevel& level : found.levels) {
    losses.push_back(level.found ? level.measured_dissipation
                                 : std::numeric_limits<double>::quiet_NaN());
  }
  return losses;
}

std::string pooled_modal_levels_text(const CampaignModalLevels& all, const CampaignFile& campaign,
                                     const std::vector<double>& offset,
                                     const std::string& comment) {
  const ModalLevels& modal = all.modal;
  std::vector<double> corrected = modal.frequency;
  for (std::size_t i = 0; i < corrected.size(); ++i) corrected[i] *= std::exp(-offset[i]);
  std::vector<double> modes(all.levels.mode.begin(), all.levels.mode.end());
  CsvWriter table;
  table.add_comment(comment);
  table.add_numbers("mode", kDimensionless, modes);
  table.add_numbers("displacement", kLength, modal.displacement);
  add_column(table, "displacement_std", kLength, modal.displacement_std);
  add_column(table, "frequency", kFrequency, corrected);
  add_column(table, "frequency_std", kFrequency, modal.frequency_std);
  add_column(table, "measured_frequency", kFrequency, modal.frequency);
  add_column(table, "dissipation", kEnergy, modal.dissipation);
  add_column(table, "dissipation_std", kEnergy, modal.dissipation_std);
  add_column(table, "damping_ratio", kDimensionless, modal.damping_ratio);
  add_column(table, "damping_ratio_std", kDimensionless, modal.damping_ratio_std);
  for (const JointLevels& joint : modal.joints) {
    add_column(table, "amplitude_" + joint.name, kLength, joint.amplitude);
    add_column(table, "amplitude_" + joint.name + "_std", kLength, joint.amplitude_std);
    add_column(table, "dissipation_" + joint.name, kEnergy, joint.dissipation);
    add_column(table, "dissipation_" + joint.name + "_std", kEnergy, joint.dissipation_std);
  }
  std::vector<std::string> tests;
  std::vector<std::string> sessions;
  for (const std::size_t test : all.levels.test) {
    tests.push_back(campaign.tests[test].name);
    sessions.push_back(campaign.tests[test].session);
  }
  table.add_text("test", tests);
  table.add_text("session", sessions);
  table.add_text("source", all.levels.source);
  table.add_text("flags", all.levels.flags);
  return table.str();
}

}  // namespace microslip
