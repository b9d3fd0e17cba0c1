// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "microslip/base/units.hpp"
#include "microslip/signal/decay/ring_down_options.hpp"
#include "microslip/signal/decay/ring_down_result.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Amplitude, frequency and damping of one mode from its free decay, as functions of time.
///
/// A mode of mass m has a restoring force of Masing's kind: after a reversal at (x_r, f_r) it is
/// f_r − 2F((x_r − x)/2), F the virgin curve of all restoring elements, joint and linear springs.
/// From a peak A + e to the next, −(A − e), it runs through a branch of the steady loop of
/// amplitude A that is shifted by e along x and, the reversal lying on F up to e², by F′(A)e along
/// f. At both peaks nothing moves, so the work in between vanishes: 2A·F′(A)e = D(A)/2. With 4e,
/// the decrease of A over a cycle,
///
///     D = A F′(A)·4e = A·[what a cycle takes off F(A)].
///
/// At a peak the force is that of inertia, F(A) = mω²A, so the decay of ω²A counts, that of the
/// acceleration:
///
///     D = −(2π/ω) m A d(ω²A)/dt = 2πζω² m A²,     ζ = (δ − 2ω̇/ω)/ω,     δ = −Ȧ/A,     k_eq = mω²,
///
/// up to terms of the order ζ². In a softening mode ω rises while A falls: ω̇ takes several per
/// cent off δω where the joint has lost a tenth of the mode's stiffness. Viscous losses add to D.
/// Where the frequency moves for another reason than friction (a geometric softening has δ −
/// ω̇/(2ω), by its action ½mωA²) D is wrong by up to 3/2·ω̇/(δω). The amplitudes here are of the
/// first harmonic, which stands for the peak within some tenths of a per cent; where D(A) has a
/// kink, at the beginning of macro-slip, a window rounds it off.
///
/// Where slip moves the mode's shape (RingDownOptions::shapes), so does m = 1/φ², and the modal
/// amplitude q = A/φ takes the place of A: (d ln φ/d ln ω) ω̇/ω² is added to ζ.

namespace microslip {

/// Follows the decay of a signal.
/// @param signal    evenly sampled, in SI. Its first sample is at time 0.
/// @param rate      of the samples, Hz.
/// @param measured  the quantity: kLength, kVelocity or kAcceleration.
/// @param options   which mode, when, and how it is followed.
/// @throws InputError  for options out of range; where the signal is not finite, too short,
///                     clipped, or holds no decay above the noise, where no peak is near the
///                     frequency, and where a higher peak beside the chosen one is followed.
[[nodiscard]] RingDown ring_down(std::span<const double> signal, double rate,
                                 const Dimension& measured, const RingDownOptions& options = {});

/// Follows the decay of a channel; its unit determines the quantity.
/// @throws InputError  also where the channel is missing, not evenly sampled over time or of no
///                     motion.
[[nodiscard]] RingDown ring_down(const Recording& recording, std::string_view channel,
                                 const RingDownOptions& options = {});

/// Follows one decay by several sensors. The first determines the mode: in the others a peak near
/// its frequency is sought, and a sensor whose frequency is off by more than 1 % is left out. The
/// one that determines ζ best leads: in its windows all are fitted. ζ, ω and A are weighted means;
/// amplitude and modal mass are those of the first sensor, to which the mean ratios of amplitudes
/// bring the others. A weight is 1/(σ² + s²/r²): σ the sensor's own, r its amplitude over the
/// largest, and s the scatter between sensors beyond their σ, over the windows within half a window
/// [R. DerSimonian, N. Laird, Control. Clin. Trials 7 (1986) 177, there with r = 1]: disturbances
/// count more where the amplitude of the mode is small.
/// @param recording  of the decay.
/// @param channels   one at least, no two the same. One that cannot be followed, or follows another
///                   mode than the first, is left out with a warning.
/// @param options    which mode, when, and how it is followed.
/// @throws InputError  as for one; where the first cannot be followed.
[[nodiscard]] RingDown ring_down(const Recording& recording, std::span<const std::string> channels,
                                 const RingDownOptions& options = {});

}  // namespace microslip
