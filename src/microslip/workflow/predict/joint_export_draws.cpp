// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/joint_export_draws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <span>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/comment_entry.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/kinds/file_kind.hpp"
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

/// Whether a file is named as one of draw_file_names() and was exported.
bool is_draw(const std::filesystem::path& path) {
  const std::string stem = path.stem().string();
  const std::size_t end = stem.find_last_not_of("0123456789");
  const bool numbered = end != std::string::npos && end + 1 < stem.size() && stem[end] == '_';
  return numbered && kind_of_file(path.string()).starts_with(export_kind(""));
}

}  // namespace

std::vector<std::string> draw_file_names(const ExportRequest& request, std::size_t count) {
  const std::size_t width = fmt::format("{}", count).size();
  const ExportTarget& target = export_target(request.target);
  const std::string_view ending = target.ending;
  if (request.name.size() + 1 + width > target.longest_file) {
    throw InputError(
        "`name`", request.name,
        fmt::format("must have at most {} letters for so many draws: {} calls a file "
                    "by its name, of {} letters",
                    target.longest_file - 1 - width, target.name, target.longest_file));
  }
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= count; ++i) {
    names.push_back(fmt::format("{}_{:0{}}{}", request.name, i, width, ending));
  }
  return names;
}

void check_other_draws(const std::string& folder, const std::vector<std::string>& names) {
  std::vector<std::string> others;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (std::ranges::find(names, name) == names.end() && is_draw(entry.path())) {
      others.push_back(name);
    }
  }
  if (others.empty()) return;
  std::ranges::sort(others);
  throw FileError(folder,
                  fmt::format("holds draws of another call, which these do not replace: {}",
                              first_texts(others, 3)),
                  "Remove them or choose another folder.");
}

std::vector<ExportedDraw> export_draws(const JointFile& file, const LoneJointDraws& draws,
                                       const ExportRequest& request, const std::string& remarks) {
  ExportRequest each = request;
  each.amplitudes = false;  // draws.csv has none
  const std::size_t count = draws.options.count;
  std::vector<ExportedDraw> exported;
  for (std::size_t i = 0; i < count; ++i) {
    DrawnJoint drawn = draws.joint.draw(std::span(&file.joint, 1), i).front();
    const JointFile one = file_of(file, std::move(drawn));
    exported.push_back(
        {.result = export_joint(
             one, each,
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
