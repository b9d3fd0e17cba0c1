// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/joint_export_draws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/cells/comment_entry.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/output/provenance.hpp"

namespace microslip {
namespace {

std::vector<double> of_each(const std::vector<ExportedDraw>& exported,
                            double ExportedDraw::*number) {
  std::vector<double> values;
  for (const ExportedDraw& draw : exported) values.push_back(draw.*number);
  return values;
}

/// A draw as a joint.json of its own; what was identified, a linear damping for instance, stays.
JointFile file_of(const JointFile& file, DrawnJoint drawn) {
  JointFile one = file;
  one.joint = std::move(drawn.joint);
  return one;
}

}  // namespace

std::vector<std::string> draw_file_names(const ExportRequest& request, std::size_t count) {
  const std::size_t width = fmt::format("{}", count).size();
  const std::string_view ending = export_target(request.target).ending;
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= count; ++i) {
    names.push_back(fmt::format("{}_{:0{}}{}", request.name, i, width, ending));
  }
  return names;
}

std::vector<ExportedDraw> export_draws(const JointFile& file, const LoneJointDraws& draws,
                                       const ExportRequest& request, const std::string& remarks) {
  const std::size_t count = draws.options.count;
  std::vector<ExportedDraw> exported;
  for (std::size_t i = 0; i < count; ++i) {
    DrawnJoint drawn = draws.joint.draw(std::span(&file.joint, 1), i).front();
    const JointFile one = file_of(file, std::move(drawn));
    exported.push_back(
        {.result = export_joint(
             one, request,
             remarks + fmt::format("\ndraw {} of {}, seed {}", i + 1, count, draws.options.seed)),
         .stiffness = one.joint.stiffness(),
         .macroslip_force = one.joint.macroslip_force(),
         .elastic_stiffness = one.joint.stiffness() * one.joint.density().elastic_remainder()});
    if (draws.progress && !draws.progress(i + 1, count)) throw Cancelled();
  }
  return exported;
}

std::string exported_draws_table(const std::vector<ExportedDraw>& exported,
                                 const std::vector<std::string>& names, const LoneJointDraws& draws,
                                 const std::string& command) {
  CsvWriter table;
  if (!command.empty()) table.add_comment(heading_of(command));
  table.add_comment(comment_entry("draws", "",
                                  fmt::format("{} of seed {}; uncertain: {}", draws.options.count,
                                              draws.options.seed, draws.uncertain)));
  std::vector<double> number;
  std::vector<double> sliders;
  std::vector<double> error;
  for (const ExportedDraw& draw : exported) {
    number.push_back(static_cast<double>(number.size() + 1));
    sliders.push_back(static_cast<double>(draw.result.sliders));
    error.push_back(draw.result.errors.path);
  }
  table.add_numbers("draw", kDimensionless, number);
  table.add_text("file", names);
  table.add_numbers("stiffness", kStiffness, of_each(exported, &ExportedDraw::stiffness));
  table.add_numbers("macroslip_force", kForce, of_each(exported, &ExportedDraw::macroslip_force));
  table.add_numbers("elastic_stiffness", kStiffness,
                    of_each(exported, &ExportedDraw::elastic_stiffness));
  table.add_numbers("sliders", kDimensionless, sliders);
  table.add_numbers("path_error", kDimensionless, error);
  return table.str();
}

std::string exported_draws_summary(const std::vector<ExportedDraw>& exported,
                                   const ExportRequest& request, const std::string& folder) {
  double worst = 0.0;
  for (const ExportedDraw& draw : exported) worst = std::max(worst, draw.result.errors.path);
  const auto [least, most] = std::ranges::minmax(of_each(exported, &ExportedDraw::macroslip_force));
  return fmt::format(
      "{}: {} draws of {} for {}, macro-slip force from {:.4g} N to {:.4g} N\n"
      "force within {} of the largest along a nested path\n",
      folder, exported.size(), request.name, request.target, least, most, percent_text(worst));
}

}  // namespace microslip
