// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/base/units.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/rig/reduction/reduction.hpp"
#include "microslip/rig/setup/rig.hpp"
#include "microslip/signal/harmonic/fourier_series.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Predicted against recorded response of a test, by a joint that was identified. [AR14 Fig. 11]

namespace microslip {

/// One channel of a record and its prediction.
struct ChannelComparison {
  std::string name;     ///< of the channel
  Dimension dimension;  ///< of its signal
  /// Series over the axis of the record. That of the prediction has mean and trend of the recorded
  /// one: neither the model nor an accelerometer gives them.
  FourierSeries recorded;
  FourierSeries predicted;           ///< by the model
  std::vector<double> recorded_std;  ///< of the real and of the imaginary part of c_n, from n = 1

  /// rms(x − predicted)/rms(x − mean − trend) over the samples x of the whole record, 1.
  double nrmse = 0.0;
  /// NRMSE of the recorded series in place of the prediction: the lower bound of every prediction
  /// with this number of harmonics, the noise, 1. NRMSE² − this² is the share of wrong harmonics,
  /// except for an incomplete last cycle.
  double noise_share = 0.0;

  // Samples of a few cycles, at the times of Verification::history.
  std::vector<double> recorded_history;   ///< samples
  std::vector<double> predicted_history;  ///< at the same times
};

/// Prediction of the model at the frequency and the response amplitude of a record.
struct PredictedLevel {
  double force_amplitude = 0.0;     ///< |F_1|, N
  double amplitude = 0.0;           ///< A of the joint, m
  double input_energy = 0.0;        ///< W_ext, J
  double linear_dissipation = 0.0;  ///< W_lin, J
  double dissipation = 0.0;         ///< D of the joint, J; its linear damping included
  /// Offset of the resonance of the model from that of the record, Hz: the frequency at which the
  /// model has the recorded phase between force and response, less that of the record. None where
  /// there is no such frequency within 20 %.
  std::optional<double> frequency_offset = {};
};

/// The quantities of a record that set a prediction, also of other models.
struct RecordedSetting {
  double angular_frequency = 0.0;  ///< ω, rad/s
  double response = 0.0;           ///< |A_1| at the exciter, m/s²
  double force = 0.0;              ///< |F_1|, N
  double phase_lag = 0.0;          ///< of the displacement at the exciter behind the force, rad
  /// s_1, s_2, … of the force: see Excitation.
  std::vector<std::complex<double>> force_shape = {};
  std::size_t harmonics = 1;  ///< fewest harmonics of the prediction
};

/// Vibration of a model at the setting of a record.
struct PredictedVibration {
  SteadyVibration vibration;  ///< at the recorded frequency and response
  PredictedLevel level;       ///< of it
  Summary summary;            ///< of the harmonic balance
};

/// Where a model vibrates with the recorded force and phase: its resonance where the record is of
/// one.
struct PredictedPeak {
  double frequency = 0.0;  ///< Hz
  double response = 0.0;   ///< |A_1| at the exciter, m/s²
};

/// Predicted against recorded: one record.
struct Verification {
  ReducedLevel recorded;                    ///< the reduction of the record, with its flags
  RecordedSetting setting;                  ///< what of it is given to the model
  PredictedLevel predicted;                 ///< what the model does instead
  SteadyVibration vibration;                ///< the same, whole
  std::vector<ChannelComparison> channels;  ///< force, accelerometers, vibrometer
  std::optional<std::size_t> drive_point =
      {};                       ///< which of them is the accelerometer at the exciter
  std::vector<double> history;  ///< times of the histories, on the axis of the record, s
  /// The phase of the drive-point acceleration's first harmonic at the zero of that axis, rad:
  /// c_n e^{−in·phase} are the harmonics with the zero of time where it is largest.
  double phase = 0.0;
  /// Summary of the harmonic balance. Not converged: `predicted` and `channels` are the best found.
  Summary summary;
  /// `beyond_identification`: the joint moves more than the levels that it was identified by.
  /// `stiffness_differs`: see stiffness_warning(). `resonance_off`: the frequency offset is above a
  /// tenth of the half-power width. `force_off`: the NRMSE of the force is above 2 % and above
  /// three times its noise.
  std::vector<Warning> warnings = {};

  /// The channel with the largest NRMSE.
  [[nodiscard]] const ChannelComparison& worst() const;
};

/// How Verifier predicts.
struct VerificationOptions {
  /// The fit of the records, whose harmonics are all compared. `modes`, of a beam, are also those
  /// of the model.
  ReductionOptions reduction = {.modes = 7};
  /// Options of the prediction. It has at least as many harmonics as the fit. A harmonic that meets
  /// a lightly damped mode (the 11th of 55.3 Hz and the fourth mode of the reference rig) shows
  /// only where it is among them.
  HarmonicBalanceOptions balance = {.harmonics = 9};
  /// Drives the model by the first harmonic of the force alone. Otherwise by the recorded
  /// harmonics too, those above four standard errors, in the recorded proportion to the first.
  bool sine = false;
  /// kA of the highest level that the joint was identified by, N; above 0. Nothing: not known.
  std::optional<double> covered_to = {};
  double history_cycles = 2.0;  ///< kept as histories; 0 or more
  /// β of the joint, J/m²: see StructuralJoint; 0 or more, finite.
  double linear_damping = 0.0;
};

/// Compares records of a rig with the predictions of a joint, in the manner of [AR14 Fig. 11]: the
/// structure of rig_structure() vibrates at the frequency of the record with the recorded first
/// harmonic of the acceleration at the exciter (HarmonicBalance); the force that this takes and the
/// motion of the other channels are the prediction.
///
/// The record gives the phase as well: the prediction is shifted in time until the first harmonic
/// of that acceleration has the recorded phase. So three numbers of a record are given to the
/// model, all of the drive point's acceleration: of it only the harmonics from the second are
/// predicted, and its NRMSE is small for every joint. The force is predicted completely, and there
/// the joint has an effect: its part in phase with the velocity is the energy dissipated, its part
/// in phase with the displacement the stiffness. Near resonance the second is a small difference of
/// large numbers: with δf the error of the resonance frequency and η the loss factor, the force is
/// wrong by 2 δf/(η f), a third for δf/f = 0.2 % and η = 1.2 %. The frequency offset distinguishes
/// this error from one of the energies.
///
/// Where no accelerometer is at the exciter, its acceleration is that of the observed motion
/// (ModalObserver), as in the reduction.
///
/// Shared by threads.
class Verifier {
 public:
  /// @param rig      a test.
  /// @param joint    see rig_structure().
  /// @param options  of reduction, prediction and comparison.
  /// @throws InputError  as Reducer and rig_structure(), and naming an option out of range.
  Verifier(Rig rig, Joint joint, VerificationOptions options = {});

  /// Compares one record.
  /// @throws InputError  as Reducer::reduce(). Not converging is a status.
  [[nodiscard]] Verification verify(const Recording& recording) const;

  /// The balance of the rig with its joint at a record; the response point is the exciter.
  /// @throws InputError  as rig_structure().
  [[nodiscard]] HarmonicBalance balance(const RecordedSetting& setting) const;

  /// The reducer of the records, with the rig.
  [[nodiscard]] const Reducer& reducer() const { return reducer_; }
  /// The joint of the prediction.
  [[nodiscard]] const Joint& joint() const { return joint_; }
  /// The options, as given.
  [[nodiscard]] const VerificationOptions& options() const { return options_; }

 private:
  Reducer reducer_;
  Joint joint_;
  VerificationOptions options_;
};

/// Predicts the vibration of a model at the frequency and the response of a record.
/// @param balance  of the model.
/// @param setting  of the record.
/// @param start    a vibration near it, where one is known.
[[nodiscard]] PredictedVibration predict_at(const HarmonicBalance& balance,
                                            const RecordedSetting& setting,
                                            const SteadyVibration* start = nullptr);

/// The vibration of a model with the force and the phase of a record; none where there is none
/// within 20 % of its frequency.
/// @param balance  of the model.
/// @param setting  of the record.
/// @param start    a vibration near it.
[[nodiscard]] std::optional<PredictedPeak> predict_peak(const HarmonicBalance& balance,
                                                        const RecordedSetting& setting,
                                                        const SteadyVibration& start);

}  // namespace microslip
