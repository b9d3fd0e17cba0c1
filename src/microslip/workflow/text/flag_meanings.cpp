// SPDX-License-Identifier: MIT
#include "microslip/workflow/text/flag_meanings.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace microslip {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 54> kMeanings = {{
    {"amplitude_drift", "no steady state: the amplitude drifts"},
    {"amplitude_rises", "the decay was cut off where its amplitude rises"},
    {"beats", "a second oscillation near the mode changes the damping by more than 2 %"},
    {"beyond_identification",
     "the joint moves more than in the levels from which it was identified"},
    {"clipped", "a channel is clipped, or in a decay flattened by macro-slip"},
    {"coarse_steps",
     "the phase changes by more than 30° between the two sweep steps next to the resonance"},
    {"decay_within_window", "the decay is too fast for the frequency resolution of its windows"},
    {"dissipation_above_bound",
     "D > kA², more than a joint of stiffness k can dissipate: a unit is wrong"},
    {"dissipation_in_noise", "D is below three standard deviations"},
    {"dissipation_negative", "the input is below the linear loss: the level is left out"},
    {"dropout", "a channel dropped out for some time"},
    {"energies_differ",
     "energies that must agree do not: the input from Fourier coefficients and from samples, or "
     "the sum over the joints from their forces and from the balance"},
    {"far_from_first_mode",
     "the drive frequency is more than a factor 1.5 from the first mode of the rig"},
    {"far_from_mode", "the drive frequency is more than a fifth from the mode with stuck joints"},
    {"few_cycles", "the record has fewer than 10 cycles"},
    {"few_samples", "a cycle has fewer than 40 samples: linear interpolation makes D too small"},
    {"force_distortion",
     "harmonics of the force above 1 % of the fundamental: D is still correct, half-power damping "
     "and predictions for a sine are not"},
    {"force_not_controlled", "the force control did not reach its target"},
    {"force_off", "the predicted force differs by more than 2 % and three times its noise"},
    {"frequency_moves",
     "the frequency of the decay changes by more than 2 %: its shape is not constant"},
    {"implausible_value",
     "a displacement above 1 m, or a loss above 1 MJ per cycle: a unit is wrong"},
    {"inner_reversals", "the joint reverses more than twice per cycle: D is not that of one loop"},
    {"joint_in_noise", "D of a joint is below three standard deviations"},
    {"joint_not_seen",
     "the accelerometers do not determine all joint motions: the undetermined part is assumed "
     "stuck"},
    {"linear_loss_exceeds_all", "levels whose loss is below the linear loss were left out"},
    {"macro_slip", "all that can slip does: D contains no more information on the density"},
    {"mean_moves",
     "the means of equal cycles drift to one side: where it is the displacement sensor that does, "
     "D "
     "is wrong by the force at a turn times the drift per cycle"},
    {"mode_lost", "the decay was cut off where its mode was lost"},
    {"model_misfit", "the modes leave more than 5 % of an accelerometer unexplained"},
    {"modes_modulate",
     "other modes of the decay move the joints by more than a tenth of the motion of this one"},
    {"neighbour_leaks", "other modes change the damping by more than 2 %"},
    {"not_closed",
     "the force does not return with the displacement: drift, rate dependence or wear"},
    {"off_resonance",
     "the drive frequency differed from the resonance by more than three standard deviations; the "
     "frequency given is that of the resonance"},
    {"one_loop",
     "the record is one loop from tip to tip: whether the joint repeats it is not measured"},
    {"order_reduced", "fewer harmonics were fitted than specified"},
    {"other_peaks", "the spectrum has other peaks near the mode"},
    {"phase_unsteady", "no steady state: samples are missing, or the drive drifts"},
    {"prediction_not_converged", "the steady-state vibration did not converge"},
    {"resonance_not_found", "no phase resonance nearby: the frequency is that of the drive"},
    {"resonance_off",
     "the predicted resonance differs by more than a tenth of its half-power width"},
    {"secant_above_stuck", "k_eq above 1.1 k"},
    {"secant_not_positive", "k_eq was not above 0, and is left out"},
    {"sensor_left_out", "the mode of the first sensor cannot be tracked at another sensor"},
    {"sensors_differ",
     "damping or frequency of two sensors differs by more than twice its standard deviation"},
    {"several_resonances", "the phase of the sweep passes resonance more than once"},
    {"shape_assumed", "no sensor is at the response point: the ratio is that of the model's shape"},
    {"shape_moves", "an amplitude ratio between sensors is not constant"},
    {"signal_constant", "a channel is constant"},
    {"spike", "single samples are outliers"},
    {"steady_tone", "a tone that does not decay changes the damping by more than 2 %"},
    {"stiffness_differs", "the stiffness of the joint is not that of the contact of the rig"},
    {"transfer_not_measured", "the force control did not measure the shaker response"},
    {"uneven_sampling", "the samples are not evenly spaced in time"},
    {"vibrometer_mismatch", "vibrometer and kinematics differ by more than 20 %"},
}};

}  // namespace

std::string_view flag_meaning(std::string_view code) {
  const auto* found =
      std::ranges::find(kMeanings, code, [](const auto& pair) { return pair.first; });
  return found == kMeanings.end() ? std::string_view() : found->second;
}

}  // namespace microslip
