// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/joint_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/equal_error_sliders.hpp"
#include "microslip/joint/memory.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/workflow/predict/joint_tables.hpp"

namespace microslip {
namespace {

constexpr std::size_t kPathPoints = 60;
/// Of the error asked for: so much is allowed along the nested path, as other paths differ from it.
constexpr double kShareOfError = 0.5;
constexpr std::size_t kAmplitudes = 91;
/// The lowest amplitude of the table over the highest.
constexpr double kLowest = 1e-3;
constexpr std::size_t kMostSliders = 5000;
constexpr double kSmallestError = 1e-7;
constexpr double kLargestError = 0.5;
/// Of D: from the amplitude on that the summary names.
constexpr double kFairDissipation = 0.05;

/// Where the last slider within reach slips, m; of a joint that never slips as far as 1 N takes it.
double end_of_slip(const Joint& joint, double reach) {
  const double force = joint.density().largest_slip_force();
  return std::min(reach, (force > 0.0 ? force : 1.0) / joint.stiffness());
}

std::vector<double> forces_of(const Joint& joint, const std::vector<double>& path) {
  std::vector<double> force(path.size());
  Memory(joint).march(path, force);
  return force;
}

/// Largest difference of forces along the nested path over the largest force there.
double path_error(const Joint& joint, const Joint& sliders, double amplitude) {
  const std::vector<double> path = nested_path(amplitude, kPathPoints);
  const std::vector<double> exact = forces_of(joint, path);
  const std::vector<double> force = forces_of(sliders, path);
  double largest = 0.0;
  double error = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    largest = std::max(largest, std::abs(exact[i]));
    error = std::max(error, std::abs(force[i] - exact[i]));
  }
  return error / largest;
}

/// Those over the amplitude. @param errors  get them.
void add_amplitudes(const Joint& joint, const Joint& sliders, double highest,
                    SliderErrors& errors) {
  for (std::size_t i = 0; i < kAmplitudes; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kAmplitudes - 1);
    const double a = highest * std::pow(kLowest, 1.0 - share);
    const double exact = dissipation(joint, a);
    errors.amplitude.push_back(a);
    errors.dissipation.push_back(exact > 0.0 ? dissipation(sliders, a) / exact - 1.0 : 0.0);
    errors.secant.push_back(secant_stiffness(sliders, a) / secant_stiffness(joint, a) - 1.0);
  }
}

SliderErrors errors_of(const Joint& joint, const EqualErrorSliders& chosen,
                       const ExportRequest& request) {
  const Joint sliders = joint_of(chosen.network);
  const double highest = end_of_slip(joint, request.reach);
  SliderErrors errors;
  errors.first_loading = chosen.error / joint.virgin_force(highest);
  errors.path = path_error(joint, sliders, highest);
  if (request.amplitudes) add_amplitudes(joint, sliders, highest, errors);
  return errors;
}

/// The fewest that are as exact along the nested path as asked for.
EqualErrorSliders sliders_for(const Joint& joint, double error, double reach) {
  const std::size_t atoms = atoms_within(joint, reach);
  const double highest = end_of_slip(joint, reach);
  const auto is_enough = [&](std::size_t n) {
    return path_error(joint, joint_of(equal_error_sliders(joint, n, reach).network), highest) <=
           kShareOfError * error;
  };
  std::size_t low = atoms;  // not enough, unless there are atoms alone
  std::size_t high = atoms + 1;
  while (!is_enough(high)) {
    low = high;
    high = std::min(2 * high, kMostSliders);
    if (low == high) {
      throw InputError("`error`", error,
                       fmt::format("is not reached with {} sliders", kMostSliders),
                       "Ask for a larger error, or for a number of sliders.");
    }
  }
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (is_enough(middle) ? high : low) = middle;
  }
  return equal_error_sliders(joint, high, reach);
}

void check(const ExportRequest& request, const JointFile& file) {
  if (!request.sliders && !(request.error >= kSmallestError && request.error <= kLargestError)) {
    throw InputError("`error`", request.error,
                     fmt::format("must be from {:g} to {:g}, of the largest force on a path",
                                 kSmallestError, kLargestError));
  }
  if (request.sliders && *request.sliders > kMostSliders) {
    throw InputError("`elements`", static_cast<double>(*request.sliders),
                     fmt::format("must be at most {}", kMostSliders));
  }
  if (request.first_number < 1 || request.first_number > kLargestFirstNumber) {
    throw InputError("`first_number`", static_cast<double>(request.first_number),
                     fmt::format("must be from 1 to {}", kLargestFirstNumber));
  }
  const double viscous = identified_viscous(file);
  if (viscous != 0.0) {
    throw InputError("joint", fmt::format("viscous part of {:.6g} N s/m", viscous),
                     "cannot be exported: sliders have no viscous part",
                     "Put a damper of this value beside it in the other program, and take the key "
                     "out of the identification in joint.json.");
  }
}

/// The lowest amplitude from which on all values are within a limit, by its place; the last where
/// there is none.
std::size_t within_from(const std::vector<double>& values, double limit) {
  std::size_t from = values.size();
  while (from > 0 && std::abs(values[from - 1]) <= limit) --from;
  return std::min(from, values.size() - 1);
}

double largest_of(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

std::vector<double> nested_path(double amplitude, std::size_t points) {
  constexpr std::array kTurns{1.0, -0.9, 0.75, -0.6,  0.45, -0.3,  0.15, -0.05,
                              0.1, -0.2, 0.4,  -0.55, 0.7,  -0.95, 1.0};
  std::vector<double> path{0.0};
  for (const double turn : kTurns) {
    const double from = path.back();
    const double to = turn * amplitude;
    for (std::size_t i = 1; i <= points; ++i) {
      path.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(points));
    }
  }
  return path;
}

JointExport export_joint(const JointFile& file, const ExportRequest& request,
                         const std::string& remarks) {
  const ExportTarget& target = export_target(request.target);
  const ExportUnits& units = export_units(request.units);
  check(request, file);
  const EqualErrorSliders chosen =
      request.sliders ? equal_error_sliders(file.joint, *request.sliders, request.reach)
                      : sliders_for(file.joint, request.error, request.reach);
  JointExport result{.text = {},
                     .sliders = chosen.network.size(),
                     .errors = errors_of(file.joint, chosen, request),
                     .warnings = {}};
  if (auto warning = linear_damping_warning(file)) result.warnings.push_back(*std::move(warning));
  ExportedJoint joint = exported_joint(chosen.network, request.name, units);
  joint.first_number = request.first_number;
  joint.remarks = with_warnings(
      remarks + fmt::format("\nthe force is within {} of the largest on first loading, and within "
                            "{} along a nested path",
                            percent_text(result.errors.first_loading),
                            percent_text(result.errors.path)),
      result.warnings);
  result.text = export_text(target, joint);
  return result;
}

std::string slider_errors_table(const SliderErrors& errors, const std::string& command) {
  CsvWriter table;
  if (!command.empty()) table.add_comment(heading_of(command));
  table.add_numbers("amplitude", kLength, errors.amplitude);
  table.add_numbers("dissipation_error", kDimensionless, errors.dissipation);
  table.add_numbers("secant_stiffness_error", kDimensionless, errors.secant);
  return table.str();
}

std::string export_summary(const JointExport& result, const ExportRequest& request,
                           const std::string& path) {
  const ExportUnits& units = export_units(request.units);
  const SliderErrors& errors = result.errors;
  return fmt::format(
      "{}: {} for {}, {} slider{}, in {} and {}\n"
      "up to {}: force within {} of the largest on first loading, {} along a nested path; k_eq "
      "within {}, D within {} from {} on\n",
      path, request.name, request.target, result.sliders, result.sliders == 1 ? "" : "s",
      units.force, units.length, length_text(errors.amplitude.back()),
      percent_text(errors.first_loading), percent_text(errors.path),
      percent_text(largest_of(errors.secant)), percent_text(kFairDissipation),
      length_text(errors.amplitude[within_from(errors.dissipation, kFairDissipation)]));
}

}  // namespace microslip
