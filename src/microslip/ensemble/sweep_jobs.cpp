// SPDX-License-Identifier: MIT
#include "microslip/ensemble/sweep_jobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/ensemble/input_hashes.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/config/changed_number.hpp"

namespace microslip {
namespace {

/// Numbers that no prediction of one structure uses would give the same everywhere.
void check_number_matters(const SweepAxis& axis, const std::string& plan) {
  const std::string key = axis.path.substr(0, axis.path.rfind('['));
  const bool spread = axis.joint.empty() && key.ends_with("_std");
  const bool record = !axis.joint.empty() && (axis.path.starts_with("identification") ||
                                              axis.path.starts_with("provenance"));
  if (!spread && !record) return;
  throw InputError(fmt::format("{}: number", plan), in_quotes(axis.number),
                   "must be one that a prediction depends on: this states uncertainty or origin "
                   "of others",
                   spread ? "The kind predict uses it for draws." : "");
}

}  // namespace

SweepJobs::SweepJobs(SweepPlan sweep, const EnsemblePlan& plan)
    : sweep_(std::move(sweep)), text_(read_text(sweep_.model)) {
  const ModelFile model = parse_model(text_, input_name(sweep_.model));
  find_joints(model, plan.file);
  try_axes(plan.file);
  std::uint64_t points = 1;
  for (const SweepAxis& axis : sweep_.axes) points *= axis.values.size();
  for (const PlannedCase& planned : plan.cases) {
    cases_.push_back(make_case(planned, model, plan.file));
    groups_.push_back({planned.name, points, cases_.back()->outputs(), sweep_.axes});
  }
  inputs_ = hashes_of(sweep_.model, model, cases_);
  warnings_ = warnings_of(cases_, plan.cases);
  for (const SweepAxis& axis : sweep_.axes) {
    notes_.push_back(fmt::format("axis: {}, {} values", axis.number, axis.values.size()));
  }
}

void SweepJobs::find_joints(const ModelFile& model, const std::string& plan) {
  const auto joints = model.structure.joints();
  for (const SweepAxis& axis : sweep_.axes) {
    if (axis.joint.empty()) continue;
    const auto found = std::ranges::find(joints, axis.joint, &StructuralJoint::name);
    if (found == joints.end()) {
      throw InputError(fmt::format("{}: number", plan), in_quotes(axis.number),
                       "must name a joint of the model before the colon");
    }
    const auto j = static_cast<std::size_t>(found - joints.begin());
    if (std::ranges::find(joints_, j, &JointText::joint) != joints_.end()) continue;
    joints_.push_back({j, axis.joint, model.joint_files[j], read_text(model.joint_files[j])});
  }
}

/// Checks that each number exists and has an effect, before hours of work.
void SweepJobs::try_axes(const std::string& plan) const {
  for (const SweepAxis& axis : sweep_.axes) {
    check_number_matters(axis, plan);
    try {
      if (axis.joint.empty()) {
        (void)toml_with_number(text_, sweep_.model, axis.path, axis.values.front());
        continue;
      }
      const auto joint = std::ranges::find(joints_, axis.joint, &JointText::name);
      (void)json_with_number(joint->text, joint->file, axis.path, axis.values.front());
    } catch (const InputError& error) {
      throw error.renamed(fmt::format("{}: number '{}': {}", plan, axis.number, error.name()));
    }
  }
}

JointedStructure SweepJobs::structure_at(const std::vector<double>& values) const {
  std::string text = text_;
  for (std::size_t a = 0; a < values.size(); ++a) {
    const SweepAxis& axis = sweep_.axes[a];
    if (axis.joint.empty()) text = toml_with_number(text, sweep_.model, axis.path, values[a]);
  }
  const JointedStructure structure = parse_model(text, input_name(sweep_.model)).structure;
  if (joints_.empty()) return structure;
  std::vector<StructuralJoint> joints(structure.joints().begin(), structure.joints().end());
  for (const JointText& joint : joints_) {
    std::string changed = joint.text;
    for (std::size_t a = 0; a < values.size(); ++a) {
      const SweepAxis& axis = sweep_.axes[a];
      if (axis.joint != joint.name) continue;
      changed = json_with_number(changed, joint.file, axis.path, values[a]);
    }
    joints[joint.joint].joint = parse_joint(changed, joint.file).joint;
  }
  return structure.with_joints(std::move(joints));
}

std::vector<double> values_at(const std::vector<SweepAxis>& axes, std::uint64_t point) {
  std::vector<double> values(axes.size());
  for (std::size_t a = axes.size(); a-- > 0;) {
    const std::uint64_t count = axes[a].values.size();
    values[a] = axes[a].values[point % count];
    point /= count;
  }
  return values;
}

JobResult SweepJobs::run(std::size_t group, std::uint64_t index) const {
  try {
    return cases_[group]->of({structure_at(values_at(sweep_.axes, index)), 1.0});
  } catch (const InputError& error) {
    return {{}, error.what()};
  } catch (const FormatError& error) {
    return {{}, error.what()};
  }
}

}  // namespace microslip
