// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "microslip/dynamics/steady_vibration.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/report/figure.hpp"
#include "microslip/rig/reduction.hpp"
#include "microslip/rig/virtual_measurement.hpp"
#include "microslip/workflow/experiment_results.hpp"

/// @file
/// The pictures of a frictional-support test.

namespace microslip {

/// The resonance frequency over the response at the exciter, and that of the drive. [AR14 Fig. 6]
/// @param title   of the figure.
/// @param levels  one at least.
/// @param unit    of the response: "m/s²", "g".
/// @throws InputError  for a unit that is none of acceleration.
[[nodiscard]] Figure resonance_figure(const std::string& title,
                                      std::span<const ReducedLevel> levels,
                                      const std::string& unit = "m/s²");

/// Input energy, linear loss and dissipation of the joint, mJ, over its amplitude, µm.
/// [AR14 Fig. 8]
/// @param title   of the figure.
/// @param levels  one at least with D above 0; others are not drawn.
/// @param truth   the joint, where it is known; its D at these amplitudes is drawn too.
[[nodiscard]] Figure energies_figure(const std::string& title, std::span<const ReducedLevel> levels,
                                     const Joint* truth = nullptr);

/// W_lin/W_ext, the share of the linear loss in what is put in, %, over the amplitude of the joint,
/// µm. [AR14 Fig. 8]
/// @param title   of the figure.
/// @param levels  one at least.
[[nodiscard]] Figure linear_share_figure(const std::string& title,
                                         std::span<const ReducedLevel> levels);

/// Before and after the force control: the force of the highest level over a cycle, its harmonics,
/// and over the level the largest harmonic of the force, these over the first, %. [AR14 Fig. 7]
/// @param title      of the figure.
/// @param levels     with a shaker; one at least.
/// @param harmonics  that were controlled, from 2.
/// @param unit       of the response: "m/s²", "g".
/// @throws InputError  for a unit that is none of acceleration.
[[nodiscard]] FigureGrid force_control_figure(const std::string& title,
                                              std::span<const VirtualLevel> levels,
                                              std::size_t harmonics,
                                              const std::string& unit = "m/s²");

/// The same of what files hold, without the force over time.
/// @param title   of the figure.
/// @param levels  one at least.
/// @param unit    of the response: "m/s²", "g".
[[nodiscard]] FigureGrid force_control_figure(const std::string& title,
                                              std::span<const ForceControlLevel> levels,
                                              const std::string& unit = "m/s²");

/// A frequency response at constant response.
struct NamedResponse {
  std::string name;         ///< of the response: "1 g"
  ResponseCurve predicted;  ///< by the model
  ResponseCurve expected;   ///< may be empty
};

/// The amplitude of the response, in the kind of the response point, over that of the force, over
/// the frequency, Hz, at constant responses; what is expected is dotted. [AR14 Fig. 4]
/// @param title      of the figure.
/// @param responses  one at least.
/// @param unit       of response over force: "m/s²/N".
[[nodiscard]] Figure constant_response_figure(const std::string& title,
                                              std::span<const NamedResponse> responses,
                                              const std::string& unit);

}  // namespace microslip
