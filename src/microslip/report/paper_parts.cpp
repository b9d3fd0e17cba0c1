// SPDX-License-Identifier: MIT
#include "microslip/report/paper_parts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

constexpr Stroke kIdentified{.colour = kBlue};
constexpr Stroke kTruthStroke{.colour = kVermillion, .style = LineStyle::kDashed};
constexpr std::array<Stroke, 3> kOthers = {{{.colour = kGreen, .style = LineStyle::kDashDotted},
                                            {.colour = kPurple, .style = LineStyle::kLongDashed},
                                            {.colour = kOrange, .style = LineStyle::kDotted}}};

}  // namespace

void throw_missing(const char* what, const char* rule) {
  throw InputError(what, InputState{"missing"}, rule);
}

const IdentifiedJoint& joint_of(const ExperimentResults& results) {
  if (!results.joint) throw_missing("joint", "the figure needs a joint");
  return *results.joint;
}

const MeasuredLevels& levels_of(const ExperimentResults& results) {
  if (!results.levels) throw_missing("levels", "the figure needs levels");
  return *results.levels;
}

const char* name_of(const IdentifiedJoint& found) {
  return found.covered_to ? "identified joint" : "joint";
}

std::vector<DrawnJoint> drawn_others(const ExperimentResults& results,
                                     const PaperOptions& options) {
  std::vector<DrawnJoint> drawn;
  if (results.truth) drawn.push_back({"truth", *results.truth, kTruthStroke});
  for (std::size_t i = 0; i < options.others.size(); ++i) {
    const NamedJoint& other = options.others[i];
    drawn.push_back({other.name, other.joint, kOthers.at(i % kOthers.size())});
  }
  return drawn;
}

std::vector<DrawnJoint> drawn_joints(const ExperimentResults& results,
                                     const PaperOptions& options) {
  std::vector<DrawnJoint> drawn;
  if (results.joint) {
    drawn.push_back({name_of(*results.joint), results.joint->joint, kIdentified});
  }
  std::ranges::move(drawn_others(results, options), std::back_inserter(drawn));
  return drawn;
}

double macroslip_amplitude(const Joint& joint) {
  const double slip_force = joint.density().largest_slip_force();
  if (slip_force > 0.0) return slip_force / joint.stiffness();
  throw InputError("joint", "no slider", "the figure needs a joint of which a part slips");
}

bool is_log(const PaperOptions& options, bool suits) {
  return options.scale == AmplitudeScale::kAsSuits ? suits : options.scale == AmplitudeScale::kLog;
}

}  // namespace microslip
