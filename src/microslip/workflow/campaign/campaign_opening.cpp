// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign/campaign_opening.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/workflow/campaign/campaign_test_kinds.hpp"
#include "microslip/workflow/identify/calibration.hpp"
#include "microslip/workflow/identify/smoothing_text.hpp"
#include "microslip/workflow/text/distinct_files.hpp"

namespace microslip {
namespace {

/// No structure comes near it.
constexpr std::size_t kLargestStructure = std::size_t{16} << 20U;

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

}  // namespace

OpenedCampaign open_campaign(const CampaignRun& run) {
  if (run.campaign == "-") {
    throw InputError("campaign", "standard input", "must be a file: its folder has the tests");
  }
  NamedInput campaign{run.campaign, read_text(run.campaign)};
  CampaignFile plan = parse_campaign(campaign.text, input_name(run.campaign));
  NamedInput structure{plan.structure, read_text(plan.structure, kLargestStructure)};
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

}  // namespace microslip
