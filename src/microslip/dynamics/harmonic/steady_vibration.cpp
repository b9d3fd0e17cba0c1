// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/steady_vibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <span>
#include <string_view>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

void check_modal(const std::vector<std::vector<std::complex<double>>>& modal, std::size_t modes,
                 std::size_t harmonics) {
  if (modal.size() != modes) {
    throw InputError("modes of the vibration", static_cast<double>(modal.size()),
                     fmt::format("must be those of the model, {}", modes));
  }
  for (std::size_t i = 0; i < modes; ++i) {
    if (modal[i].size() == harmonics) continue;
    throw InputError(fmt::format("harmonics of mode {}", i + 1),
                     static_cast<double>(modal[i].size()),
                     fmt::format("must be as many as those of mode 1, {}", harmonics));
  }
}

/// Σ_i weight_i q_{i,n}.
std::vector<std::complex<double>> weighted(
    const std::vector<std::vector<std::complex<double>>>& modal, std::span<const double> weights) {
  const std::size_t count = modal.empty() ? 0 : modal.front().size();
  if (!modal.empty()) check_modal(modal, weights.size(), count);
  std::vector<std::complex<double>> result(count);
  for (std::size_t i = 0; i < modal.size(); ++i) {
    for (std::size_t n = 0; n < count; ++n) result[n] += weights[i] * modal[i][n];
  }
  return result;
}

}  // namespace

double SteadyVibration::frequency() const { return angular_frequency / (2.0 * std::numbers::pi); }

double SteadyVibration::damping_ratio() const {
  double square = 0.0;  // of the modal amplitude
  for (const auto& harmonics : modal) {
    if (harmonics.size() > 1) square += std::norm(harmonics[1]);
  }
  const double energy = 2.0 * std::numbers::pi * angular_frequency * angular_frequency * square;
  double lost = linear_dissipation;
  for (const JointCycle& joint : joints) lost += joint.dissipation;
  return energy > 0.0 ? lost / energy : 0.0;
}

std::vector<std::complex<double>> SteadyVibration::displacement(const ModalModel& model,
                                                                std::string_view point) const {
  return weighted(modal, model.shape(point));
}

std::vector<std::complex<double>> SteadyVibration::worked_on(const ModalModel& model,
                                                             std::string_view place) const {
  return weighted(modal, model.load(place));
}

std::vector<std::complex<double>> SteadyVibration::absolute_displacement(
    const JointedStructure& structure, std::string_view point) const {
  const ModalModel& linear = structure.linear();
  std::vector<std::complex<double>> result = displacement(linear, point);
  for (const Excitation& excitation : structure.excitations()) {
    const double carried = linear.carried(point, excitation.point);
    if (carried == 0.0) continue;
    for (std::size_t n = 1; n < std::min(result.size(), excitation.harmonics.size() + 1); ++n) {
      const double rate = static_cast<double>(n) * angular_frequency;
      result[n] -= carried * force_amplitude * excitation.harmonics[n - 1] / (rate * rate);
    }
  }
  return result;
}

std::vector<std::complex<double>> SteadyVibration::acceleration(const ModalModel& model,
                                                                std::string_view point) const {
  std::vector<std::complex<double>> result = displacement(model, point);
  for (std::size_t n = 0; n < result.size(); ++n) {
    const double rate = static_cast<double>(n) * angular_frequency;
    result[n] *= -rate * rate;
  }
  return result;
}

}  // namespace microslip
