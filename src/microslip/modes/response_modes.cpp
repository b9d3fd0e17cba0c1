// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/modes/response_fit.hpp"
#include "microslip/modes/tested_modes.hpp"

namespace microslip {
namespace {

constexpr double kPoorFit = 0.1;          // rms of what is left over that of a response
constexpr double kPoorReciprocity = 0.1;  // of the rms of the responses
constexpr double kUncertainScale = 0.1;   // standard deviation of a residue over it
constexpr std::size_t kLeastLines = 8;    // in the band
constexpr std::size_t kNamed = 5;         // in a warning
constexpr double kCircle = 2.0 * std::numbers::pi;

/// The responses of a fit: to the force at the drive point, or by reciprocity.
struct DriveColumn {
  std::vector<const FrequencyResponse*> responses;
  std::vector<DegreeOfFreedom> freedoms;
  std::vector<const FrequencyResponse*>
      exchanged;  // seen from both sides, or null; one per response
  std::size_t drive = 0;
};

std::string drives_there(const std::vector<FrequencyResponse>& responses) {
  std::vector<DegreeOfFreedom> references;
  for (const FrequencyResponse& response : responses) references.push_back(response.reference);
  std::ranges::sort(references);
  references.erase(std::unique(references.begin(), references.end()), references.end());
  std::string text;
  for (std::size_t i = 0; i < std::min(references.size(), kNamed); ++i) {
    text += fmt::format("{}{}", i == 0 ? "" : ", ", freedom_name(references[i]));
  }
  return text + (references.size() > kNamed ? " …" : "");
}

const FrequencyResponse* find_response(const std::vector<FrequencyResponse>& responses,
                                       const DegreeOfFreedom& response,
                                       const DegreeOfFreedom& reference) {
  const auto found = std::ranges::find_if(responses, [&](const FrequencyResponse& its) {
    return its.response == response && its.reference == reference;
  });
  return found == responses.end() ? nullptr : &*found;
}

void check_once(const std::vector<FrequencyResponse>& responses) {
  for (const FrequencyResponse& response : responses) {
    const FrequencyResponse* first =
        find_response(responses, response.response, response.reference);
    if (first == &response) continue;
    throw InputError(response.name, "there already, as " + first->name,
                     "must occur once: which of them applies is not given");
  }
}

DriveColumn drive_column(const TestedStructure& test) {
  check_once(test.responses);
  const DegreeOfFreedom drive = *test.drive;
  DriveColumn column;
  const auto add = [&](const FrequencyResponse& response, const DegreeOfFreedom& freedom,
                       const FrequencyResponse* other) {
    if (std::ranges::find(column.freedoms, freedom) != column.freedoms.end()) return;
    if (freedom == drive) column.drive = column.responses.size();
    column.responses.push_back(&response);
    column.freedoms.push_back(freedom);
    column.exchanged.push_back(&response == other ? nullptr : other);
  };
  for (const FrequencyResponse& response : test.responses) {
    if (response.reference != drive) continue;
    add(response, response.response, find_response(test.responses, drive, response.response));
  }
  for (const FrequencyResponse& response : test.responses) {
    if (response.response == drive) add(response, response.reference, nullptr);
  }
  if (find_response(test.responses, drive, drive) != nullptr) return column;
  throw InputError(
      "test.drive", freedom_name(drive),
      fmt::format("must have a response to its own force in {}: shapes are scaled by it",
                  test.file),
      fmt::format("There are forces at {}.", drives_there(test.responses)));
}

BandResponse in_band(const FrequencyResponse& response,
                     const std::optional<std::array<double, 2>>& band) {
  BandResponse cut{.omega = {}, .values = {}, .derivatives = response.derivatives};
  for (std::size_t i = 0; i < response.frequency.size(); ++i) {
    const double frequency = response.frequency[i];
    if (band && (frequency < (*band)[0] || frequency > (*band)[1])) continue;
    cut.omega.push_back(kCircle * frequency);
    cut.values.push_back(response.values[i]);
  }
  if (cut.omega.size() < kLeastLines) {
    throw InputError(response.name, fmt::format("{} lines in the band", cut.omega.size()),
                     fmt::format("must have at least {}", kLeastLines));
  }
  if (std::ranges::all_of(cut.values, [](const auto& value) { return std::norm(value) == 0.0; })) {
    throw InputError(response.name, "0 throughout the band", "must move");
  }
  return cut;
}

/// |H_jd − H_dj| over |H_jd|, root mean squares; nothing where they are not over the same lines.
std::optional<double> reciprocity(const FrequencyResponse& one, const FrequencyResponse& other,
                                  const std::optional<std::array<double, 2>>& band) {
  if (one.frequency != other.frequency || one.derivatives != other.derivatives) return std::nullopt;
  const BandResponse first = in_band(one, band);
  const BandResponse second = in_band(other, band);
  double difference = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < first.values.size(); ++i) {
    difference += std::norm(first.values[i] - second.values[i]);
    all += std::norm(first.values[i]);
  }
  return std::sqrt(difference / all);
}

void check_reciprocity(const TestedStructure& test, const DriveColumn& column,
                       TestedModes& tested) {
  double most = 0.0;
  std::size_t pairs = 0;
  for (std::size_t j = 0; j < column.responses.size(); ++j) {
    if (column.exchanged[j] == nullptr) continue;
    const auto found = reciprocity(*column.responses[j], *column.exchanged[j], test.band);
    if (!found) continue;
    ++pairs;
    most = std::max(most, *found);
    if (*found < kPoorReciprocity) continue;
    tested.warnings.push_back(
        {"not_reciprocal",
         fmt::format(
             "{} and {} differ by {:.3g} % of their rms. With force and response exchanged "
             "they are the same in a linear structure: one is off in scale, or joints slip.",
             column.responses[j]->name, column.exchanged[j]->name, 100.0 * *found)});
  }
  if (pairs == 0) return;
  tested.origin.push_back(
      fmt::format("reciprocity of {} pair{} of responses: up to {:.3g} % of the rms apart", pairs,
                  pairs == 1 ? "" : "s", 100.0 * most));
}

void warn_of_lines(const std::vector<BandResponse>& responses, TestedModes& tested) {
  const auto other = std::ranges::find_if(
      responses, [&](const BandResponse& its) { return its.omega != responses.front().omega; });
  if (other == responses.end()) return;
  tested.warnings.push_back(
      {"lines_differ",
       "not all frequency responses are over the same frequencies. Each is used at "
       "its own; were they measured in one session, of one structure?"});
}

void report_misfits(const DriveColumn& column, const ResponseFit& fit, TestedModes& tested) {
  std::string poor;
  std::size_t count = 0;
  double sum = 0.0;
  std::size_t worst = 0;
  for (std::size_t j = 0; j < fit.misfits.size(); ++j) {
    sum += fit.misfits[j] * fit.misfits[j];
    if (fit.misfits[j] > fit.misfits[worst]) worst = j;
    if (fit.misfits[j] < kPoorFit) continue;
    if (++count > kNamed) continue;
    poor += fmt::format("{}{} by {:.3g} %", count == 1 ? "" : ", ", column.responses[j]->name,
                        100.0 * fit.misfits[j]);
  }
  tested.origin.push_back(
      fmt::format("fit: misses the responses by {:.3g} % of their rms, at most by {:.3g} %, {}",
                  100.0 * std::sqrt(sum / static_cast<double>(fit.misfits.size())),
                  100.0 * fit.misfits[worst], column.responses[worst]->name));
  if (count == 0) return;
  tested.warnings.push_back(
      {"fit_poor",
       fmt::format("the modes miss {} of {} frequency responses by more than {:g} % of their rms: "
                   "{}{}. Modes are missing, damping is not {}, or there is noise.",
                   count, fit.misfits.size(), 100.0 * kPoorFit, poor, count > kNamed ? " …" : "",
                   tested.law == DampingLaw::kViscous ? "viscous" : "hysteretic")});
}

void warn_of_close_modes(const ResponseFit& fit, TestedModes& tested) {
  for (std::size_t i = 0; i + 1 < fit.modes.size(); ++i) {
    const Mode& one = fit.modes[i];
    const Mode& next = fit.modes[i + 1];
    const double width =
        0.5 * (one.loss_factor * one.angular_frequency + next.loss_factor * next.angular_frequency);
    if (next.angular_frequency - one.angular_frequency > width) continue;
    tested.warnings.push_back(
        {"modes_coincide",
         fmt::format("{} and {} overlap: they are closer than they are wide. With one drive point "
                     "their shapes are hard to distinguish.",
                     mode_name(i, one.angular_frequency / kCircle),
                     mode_name(i + 1, next.angular_frequency / kCircle))});
  }
}

void warn_of_undriven(const ResponseFit& fit, TestedModes& tested) {
  for (const double omega : fit.undriven) {
    tested.warnings.push_back(
        {"mode_not_driven",
         fmt::format("a peak at {:.6g} Hz is left out: its residue at the drive point has the "
                     "opposite sign to that of the highest. A mode that hardly moves there, or an "
                     "artefact.",
                     omega / kCircle)});
  }
}

[[noreturn]] void fail_residue(const std::string& mode, const FrequencyResponse& drive,
                               double residue) {
  throw InputError(
      fmt::format("residue of {} in {}", mode, drive.name), fmt::format("{:.4g} 1/kg", residue),
      "must be positive: force and response at one place move in phase below a resonance",
      "Are the signs of the two channels as their directions state? Or give a drive point that "
      "moves "
      "in this mode, or a band without it.");
}

/// Adds mode r, in which the drive point moves.
void add_fitted_mode(const DriveColumn& column, const ResponseFit& fit, std::size_t mode,
                     TestedModes& tested) {
  const auto r = static_cast<Eigen::Index>(mode);
  const auto d = static_cast<Eigen::Index>(column.drive);
  const double hertz = fit.modes[mode].angular_frequency / kCircle;
  const std::string name = mode_name(mode, hertz);
  const double residue = fit.residues(d, r);
  if (!(residue > 0.0)) fail_residue(name, *column.responses[column.drive], residue);
  const double at_drive = std::sqrt(residue);
  tested.shapes.col(r) = fit.residues.col(r) / at_drive;
  const double spread = fit.errors(d, r) / residue;
  const Eigen::VectorXcd numerators = fit.numerators.col(r);
  const double collinearity = phase_collinearity(numerators);
  const double phase = std::arg(numerators(d));
  tested.lines.push_back(
      fmt::format("residue at the drive point {:.5g} 1/kg ± {:.2g} %, phase {:.2f} degrees, modal "
                  "phase collinearity {:.4f}",
                  residue, 100.0 * spread, 360.0 * phase / kCircle, collinearity));
  warn_of_complexity(name, collinearity, phase, tested.warnings);
  if (spread < kUncertainScale) return;
  tested.warnings.push_back(
      {"scale_uncertain",
       fmt::format("the residue of {} at the drive point is known only to ± {:.2g} %: its shape is "
                   "scaled by its root. Does the drive point hardly move in it?",
                   name, 100.0 * spread)});
}

void report_drive_compliance(const DriveColumn& column, const ResponseFit& fit,
                             TestedModes& tested) {
  const auto d = static_cast<Eigen::Index>(column.drive);
  double inside = 0.0;
  for (std::size_t r = 0; r < fit.modes.size(); ++r) {
    const double omega = fit.modes[r].angular_frequency;
    inside += fit.residues(d, static_cast<Eigen::Index>(r)) / (omega * omega);
  }
  tested.origin.push_back(fmt::format(
      "drive point: static {:.4g} m/N in the modes; modes above the band add {:.4g} m/N, "
      "which the model lacks",
      inside, fit.upper(d)));
}

}  // namespace

TestedModes modes_of_responses(const TestedStructure& test, const TestedModesOptions& options) {
  const DriveColumn column = drive_column(test);
  TestedModes tested{.freedoms = column.freedoms,
                     .modes = {},
                     .shapes = {},
                     .law = test.law,
                     .origin = {},
                     .lines = {}};
  std::vector<BandResponse> cut;
  for (const FrequencyResponse* response : column.responses) {
    cut.push_back(in_band(*response, test.band));
  }
  ResponseFitOptions wanted{.count = options.count, .law = test.law, .drive = column.drive};
  for (const double frequency : test.start_frequency) wanted.start.push_back(kCircle * frequency);
  const ResponseFit fit = fit_responses(cut, wanted);

  const BandResponse& drive = cut[column.drive];
  tested.origin.push_back(
      fmt::format("modes of a test: {} frequency responses ({}) of {} to a force at {}, "
                  "{:.6g} to {:.6g} "
                  "Hz, scaled by the drive point",
                  cut.size(), test.kept_as, test.file, freedom_name(*test.drive),
                  drive.omega.front() / kCircle, drive.omega.back() / kCircle));
  report_misfits(column, fit, tested);
  report_drive_compliance(column, fit, tested);
  check_reciprocity(test, column, tested);
  warn_of_lines(cut, tested);
  warn_of_close_modes(fit, tested);
  warn_of_undriven(fit, tested);
  tested.modes = fit.modes;
  tested.shapes.resize(fit.residues.rows(), fit.residues.cols());
  for (std::size_t r = 0; r < fit.modes.size(); ++r) add_fitted_mode(column, fit, r, tested);
  tested.summary = fit.summary;
  return tested;
}

}  // namespace microslip
