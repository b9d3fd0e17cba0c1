// SPDX-License-Identifier: MIT
#include "microslip/workflow/text/flag_meanings.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace microslip {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 53> kMeanings = {{
    {"amplitude_drift", "no steady state: the amplitude wanders"},
    {"amplitude_rises", "the decay was left where its amplitude rises"},
    {"beats", "a second oscillation near the mode moves the damping by more than 2 %"},
    {"beyond_identification", "the joint moves more than in the levels it was identified by"},
    {"clipped", "a channel is cut off at its extremes"},
    {"coarse_steps",
     "the phase goes on by more than 30° between the two steps of the sweep beside the resonance"},
    {"decay_within_window", "the decay is too fast for the frequency resolution of its windows"},
    {"dissipation_above_bound",
     "D > kA², more than a joint of stiffness k can take: a unit is wrong"},
    {"dissipation_in_noise", "D is below three standard deviations"},
    {"dissipation_negative", "the input is below the linear loss: the level is left out"},
    {"dropout", "a channel was lost for some time"},
    {"energies_differ",
     "energies that must agree do not: the input by Fourier coefficients and by samples, or the "
     "joints together by their forces and by the balance"},
    {"far_from_first_mode", "the drive is more than a factor 1.5 off the first mode of the rig"},
    {"far_from_mode", "the drive is more than a fifth off the mode with stuck joints"},
    {"few_cycles", "the record has fewer than 10 cycles"},
    {"few_samples", "a cycle of fewer than 40 samples: chords of them make D too small"},
    {"force_distortion",
     "harmonics of the force above 1 % of the fundamental: D is right all the same, damping by "
     "half-power and predictions for a sine are not"},
    {"force_not_controlled", "the force control did not reach what was asked for"},
    {"force_off", "the predicted force is off by more than 2 % and three times its noise"},
    {"frequency_moves",
     "the frequency of the decay moves by more than 2 %: its shape is not fixed"},
    {"implausible_value",
     "a displacement above 1 m, or a loss above 1 MJ a cycle: a unit is wrong"},
    {"inner_reversals", "the joint turns more than twice a cycle: D is not that of one loop"},
    {"joint_in_noise", "D of a joint is below three standard deviations"},
    {"joint_not_seen",
     "the accelerometers do not show all that the joints do: there they are taken to stick"},
    {"linear_loss_exceeds_all", "levels whose loss is below the linear one were left out"},
    {"macro_slip", "all that can slip does: D tells no more of the density"},
    {"mean_moves", "the means of cycles alike move to one side"},
    {"mode_lost", "the decay was left where its mode was lost"},
    {"model_misfit", "the modes leave more than 5 % of an accelerometer unexplained"},
    {"modes_modulate",
     "other modes of the decay move the joints by more than a tenth of what this one does"},
    {"neighbour_leaks", "other modes move the damping by more than 2 %"},
    {"not_closed", "the force does not come back with the displacement: drift, rate or wear"},
    {"off_resonance",
     "the drive was off the resonance by more than three standard deviations; the frequency is "
     "that of the resonance"},
    {"order_reduced", "fewer harmonics were fitted than asked for"},
    {"other_peaks", "the spectrum has other peaks near the mode"},
    {"phase_unsteady", "no steady state: samples are missing, or the drive wanders"},
    {"prediction_not_converged", "the steady vibration was not found"},
    {"resonance_not_found", "no phase resonance is near: the frequency is that of the drive"},
    {"resonance_off",
     "the predicted resonance is off by more than a tenth of its half-power width"},
    {"secant_above_stuck", "k_eq above 1.1 k"},
    {"secant_not_positive", "k_eq was not above 0, and is left out"},
    {"sensor_left_out", "the mode of the first sensor cannot be followed at another"},
    {"sensors_differ",
     "damping or frequency of two sensors differs by more than twice its standard deviation"},
    {"several_resonances", "the phase of the sweep passes resonance more than once"},
    {"shape_assumed",
     "no sensor is at the response point: the ratio is that of the shape with stuck joints"},
    {"shape_moves", "a ratio of amplitudes between sensors is not the same all along"},
    {"signal_constant", "a channel does not move"},
    {"spike", "single samples are far off"},
    {"steady_tone", "a tone that does not decay moves the damping by more than 2 %"},
    {"stiffness_differs", "the stiffness of the joint is not that of the contact of the rig"},
    {"transfer_not_measured", "the force control did not learn what the shaker answers"},
    {"uneven_sampling", "the samples are not at even times"},
    {"vibrometer_mismatch", "vibrometer and kinematics differ by more than 20 %"},
}};

}  // namespace

std::string_view flag_meaning(std::string_view code) {
  const auto* found =
      std::ranges::find(kMeanings, code, [](const auto& pair) { return pair.first; });
  return found == kMeanings.end() ? std::string_view() : found->second;
}

}  // namespace microslip
