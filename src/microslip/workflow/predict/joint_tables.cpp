// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/joint_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/work_size.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/memory.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/workflow/predict/model_text.hpp"

namespace microslip {
namespace {

/// Of a row of dissipation_of(): its numbers, and its line in a table that is built up.
constexpr double kBytesOfCurveRow = 280.0;

/// Constant normal load has an exact memory; a varying one needs elements that are marched.
std::vector<double> forces_along(const DisplacementPath& path, const Joint& joint,
                                 NormalLoadLaw law, std::size_t elements) {
  std::vector<double> force(path.displacement.size());
  if (path.normal_load.empty()) {
    Memory(joint).march(path.displacement, force);
    return force;
  }
  const JenkinsNetwork network = JenkinsNetwork::discretise(joint, elements);
  NetworkMemory(network, law).march(path.displacement, path.normal_load, force);
  return force;
}

/// Sliders slip that lie below k times the farthest displacement, as in a cycle of that amplitude.
double farthest(const DisplacementPath& path) {
  double result = 0.0;
  for (const double x : path.displacement) result = std::max(result, std::abs(x));
  return result;
}

/// A column of a dissipation curve.
struct CurveColumn {
  const char* name;
  Dimension dimension;
};

constexpr std::size_t kCurveColumns = 5;
constexpr std::size_t kLinearColumn = 4;

std::array<CurveColumn, kCurveColumns> curve_columns() {
  return {{{"force", kForce},
           {"dissipation", kEnergy},
           {"secant_stiffness", kStiffness},
           {"loss_factor", kDimensionless},
           {"joint_linear_dissipation", kEnergy}}};
}

/// One column after the other. D and the loss factor are those of slip and linear damping together,
/// as levels have them.
std::vector<double> curve_values(const Joint& joint, double beta,
                                 const std::vector<double>& amplitude) {
  const std::size_t count = amplitude.size();
  std::vector<double> values(kCurveColumns * count);
  for (std::size_t i = 0; i < count; ++i) {
    const double a = amplitude[i];
    const double linear = beta * a * a;
    const double secant = secant_stiffness(joint, a);
    values[i] = joint.virgin_force(a);
    values[count + i] = dissipation(joint, a) + linear;
    values[2 * count + i] = secant;
    values[3 * count + i] = loss_factor(joint, a) + beta / (std::numbers::pi * secant);
    values[kLinearColumn * count + i] = linear;
  }
  return values;
}

CsvWriter dissipation_table(const std::vector<double>& amplitude, double beta,
                            const std::vector<double>& values, const Band& band,
                            const std::string& command) {
  const std::size_t count = amplitude.size();
  const auto part = [&](const std::vector<double>& all, std::size_t column) {
    return std::span(all).subspan(column * count, count);
  };
  CsvWriter table;
  if (!command.empty()) table.add_comment(heading_of(command));
  if (beta > 0.0) table.add_comment("linear damping of the joint: " + damping_text(beta));
  table.add_numbers("amplitude", kLength, amplitude);
  const std::array<CurveColumn, kCurveColumns> columns = curve_columns();
  const std::size_t shown = beta > 0.0 ? kCurveColumns : kLinearColumn;
  for (std::size_t c = 0; c < shown; ++c) {
    table.add_numbers(columns[c].name, columns[c].dimension, part(values, c));
  }
  for (std::size_t c = 0; c < shown && !band.lower.empty(); ++c) {
    const std::string name = columns[c].name;
    table.add_numbers(name + "_lower", columns[c].dimension, part(band.lower, c));
    table.add_numbers(name + "_upper", columns[c].dimension, part(band.upper, c));
  }
  return table;
}

/// Values of each draw of a joint and of its linear damping, and the band of them with those of the
/// joint itself, which limits may leave on one side of nearly all draws.
struct DrawnValues {
  Band band = {};
  std::optional<DrawsTaken> taken = {};
  std::vector<Warning> warnings = {};
};

DrawnValues drawn_values(
    const JointFile& file, const std::optional<LoneJointDraws>& draws, std::size_t size,
    const std::function<std::vector<double>(const Joint& joint, double beta)>& values_of) {
  if (!draws) return {};
  draws->options.check_size(size, "Use fewer points, or fewer draws.");
  const double beta = identified_damping(file).value_or(0.0);
  std::vector<std::vector<double>> values(draws->options.count);
  const auto take = [&](std::size_t i) -> std::string {
    const DrawnJoint drawn = draws->joint.draw({&file.joint, 1}, i).front();
    values[i] = values_of(drawn.joint, drawn.linear_damping.value_or(beta));
    return "";
  };
  DrawnValues drawn;
  drawn.taken = take_draws(draws->options, take, draws->execution, draws->progress);
  drawn.band = band_of(values, draws->options.confidence);
  const std::vector<double> own = values_of(file.joint, beta);
  for (std::size_t i = 0; i < own.size(); ++i) {
    drawn.band.lower[i] = std::min(drawn.band.lower[i], own[i]);
    drawn.band.upper[i] = std::max(drawn.band.upper[i], own[i]);
  }
  drawn.warnings = draw_warnings(*drawn.taken);
  return drawn;
}

/// The table with what became of the draws.
JointTable with_draws(CsvWriter table, std::vector<Warning> warnings, DrawnValues drawn,
                      const std::optional<LoneJointDraws>& draws) {
  if (draws) table.add_comment(draws_comment(*drawn.taken, draws->uncertain));
  std::ranges::move(drawn.warnings, std::back_inserter(warnings));
  add_warnings(warnings, table);
  return {table.str(), std::move(warnings), std::move(drawn.taken)};
}

}  // namespace

std::optional<Warning> linear_damping_warning(const JointFile& file) {
  const double beta = identified_damping(file).value_or(0.0);
  if (beta == 0.0) return std::nullopt;
  return Warning{"linear_damping_left_out",
                 fmt::format("The joint was identified with a linear damping of {}, which is not "
                             "in the force: a rate-independent loss that grows with the square of "
                             "the amplitude has no force along a path. Per cycle of "
                             "amplitude A the joint loses {:.6g} J/m^2 A^2 more than the area of "
                             "the loop.",
                             damping_text(beta), beta)};
}

std::vector<double> loading_and_cycle(double amplitude, std::size_t points) {
  std::vector<double> x;
  x.reserve(3 * points + 1);
  const auto branch = [&](double from, double to) {
    for (std::size_t i = 1; i <= points; ++i) {
      x.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(points));
    }
  };
  x.push_back(0.0);
  branch(0.0, amplitude);
  branch(amplitude, -amplitude);
  branch(-amplitude, amplitude);
  return x;
}

LoneJointDraws draws_of(const JointFile& file, const JointUncertainty& uncertain,
                        const DrawOptions& options) {
  options.check();
  return draws_without_band(file, uncertain, options);
}

LoneJointDraws draws_without_band(const JointFile& file, const JointUncertainty& uncertain,
                                  const DrawOptions& options) {
  JointDraws draws;
  std::string text;
  if (!uncertain.samples.empty()) {
    draws =
        joint_draws_of(samples_for(uncertain.samples, file.joint.stiffness(), "the joint"), false);
    text = "samples";
  }
  if (uncertain.normal_load != 0.0) {
    text += fmt::format("{}normal load, {:g}", text.empty() ? "" : "; ", uncertain.normal_load);
  }
  if (text.empty()) {
    throw InputError("uncertainty", "none", "must include a parameter that the draws can vary",
                     "Give `samples` of the joint, or `normal_load_std`.");
  }
  return {DrawnJoints({std::move(draws)}, {uncertain.normal_load}, JointPairing::kIndependent,
                      options.seed),
          options, std::move(text)};
}

JointTable loop_of(const JointFile& file, const DisplacementPath& path, NormalLoadLaw law,
                   std::size_t elements, const std::string& command,
                   const std::optional<LoneJointDraws>& draws) {
  std::vector<Warning> warnings = reach_warnings(file, farthest(path));
  if (const auto warning = linear_damping_warning(file)) warnings.push_back(*warning);
  DrawnValues drawn = drawn_values(
      file, draws, path.displacement.size(),
      [&](const Joint& joint, double) { return forces_along(path, joint, law, elements); });
  CsvWriter table = loop_table(path, forces_along(path, file.joint, law, elements));
  if (!command.empty()) table.add_comment(heading_of(command));
  if (draws) {
    table.add_numbers("lower", kForce, drawn.band.lower);
    table.add_numbers("upper", kForce, drawn.band.upper);
  }
  return with_draws(std::move(table), std::move(warnings), std::move(drawn), draws);
}

JointTable dissipation_of(const JointFile& file, const std::vector<double>& amplitude,
                          const std::string& command, const std::optional<LoneJointDraws>& draws) {
  check_memory("values of `amplitude`", static_cast<double>(amplitude.size()), kBytesOfCurveRow,
               "Take fewer.");
  const double beta = identified_damping(file).value_or(0.0);
  DrawnValues drawn = drawn_values(
      file, draws, kCurveColumns * amplitude.size(),
      [&](const Joint& joint, double own) { return curve_values(joint, own, amplitude); });
  CsvWriter table = dissipation_table(amplitude, beta, curve_values(file.joint, beta, amplitude),
                                      drawn.band, command);
  return with_draws(std::move(table), reach_warnings(file, amplitude.back()), std::move(drawn),
                    draws);
}

}  // namespace microslip
