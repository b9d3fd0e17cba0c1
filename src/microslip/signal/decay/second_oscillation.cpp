// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/second_oscillation.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/base/median.hpp"
#include "microslip/signal/decay/oscillation_fit.hpp"
#include "microslip/signal/decay/tapered_transform.hpp"

namespace microslip {
namespace {

using Complex = std::complex<double>;

constexpr double kMostLines = 2.7;  // between the two: beyond it the windows part them

/// Transform of cos⁴ over T of e^{(−δ + iΔ)τ}, over that of a constant.
Complex gain_of(double decay, double omega, double length) {
  constexpr int kPoints = 64;
  Complex sum = 0.0;
  double weight = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double s = (static_cast<double>(i) + 0.5) / kPoints - 0.5;
    const double w = std::pow(std::cos(std::numbers::pi * s), 4);
    sum += w * std::exp(Complex(-decay, omega) * (s * length));
    weight += w;
  }
  return sum / weight;
}

/// The shortest windows that suppress the known others as far as the noise requires, up to those of
/// the walk: the shorter they are, the farther off a second oscillation is seen.
/// @param shorter  least share of the windows of the walk.
double length_of_windows(const DecayTask& task, std::span<const DecayWindow> windows,
                         double shorter) {
  constexpr double kKeptOut = 1e-3;  // of the mode
  double longest = windows.front().length;
  for (const DecayWindow& window : windows) longest = std::min(longest, window.length);
  double length = std::max(shorter * longest, std::min(task.shortest, longest));
  const double mode = windows.front().omega / (2.0 * std::numbers::pi);
  const auto leaks = [&](double at) {
    double sum = 0.0;
    for (const SpectralPeak& other : task.others) {
      const double d = std::max(2.5, std::abs(other.frequency - mode) * at);
      sum += other.height * side_lobe(d);
    }
    return sum;
  };
  while (length < longest && leaks(length) > kKeptOut) length *= 1.1;
  return std::min(length, longest);
}

double middle_omega(std::span<const DecayWindow> windows) {
  std::vector<double> all;
  for (const DecayWindow& window : windows) all.push_back(window.omega);
  return median(std::move(all));
}

/// The rate at which ln|Z| falls by a third at first; 0 where it never does.
double early_decay(const Baseband& band) {
  constexpr double kFall = 1.0 / 3.0;
  for (Eigen::Index i = 1; i < band.value.size(); ++i) {
    const double fall = std::log(std::abs(band.value[0]) / std::abs(band.value[i]));
    if (fall > kFall) return fall / (static_cast<double>(i) * band.hop);
  }
  return 0.0;
}

/// How a decay becomes values.
struct BandChoice {
  double end = 0.0;      ///< s: no window reaches beyond
  double shorter = 0.4;  ///< as of length_of_windows()
  double most = 2000.0;  ///< values
};

Baseband baseband_of(const DecayTask& task, std::span<const DecayWindow> windows,
                     double noise_variance, const BandChoice& choice) {
  // Neither model is exact: allowed deviation of a decay from it, of its amplitude.
  constexpr double kModel = 3e-4;
  Baseband band;
  band.length = length_of_windows(task, windows, choice.shorter);
  constexpr double kHops = 8.0;  // in a window
  band.hop = std::max(band.length / kHops, (choice.end - task.from) / choice.most);
  const DecayWindow& first = windows.front();
  const DecayWindow& last = windows.back();
  band.begin = std::max(task.from, first.centre - first.length / 2.0) + band.length / 2.0;
  band.omega = middle_omega(windows);
  const double fallen = std::log(first.amplitude / last.amplitude);
  const double walked = last.centre - first.centre;
  const double least = 0.1 / first.length;
  band.decay = std::max(least, windows.size() > 2 ? fallen / walked : first.decay);
  std::vector<Complex> values;
  std::vector<double> roots;
  double quietest = HUGE_VAL;  // of what can be seen
  for (double at = band.begin; at + band.length / 2.0 <= choice.end; at += band.hop) {
    const TaperedWindow window(task.signal, task.rate, at, band.length);
    const Complex value = window.transform(band.omega);
    const double noise = noise_variance * window.noise_gain();
    quietest = std::min(quietest, std::max(std::abs(value), std::sqrt(noise)));
    const double model = kModel * std::abs(value);
    roots.push_back(1.0 / std::sqrt(0.5 * (noise + model * model) + 1e-300));
    values.push_back(value * std::polar(1.0, -band.omega * (at - band.begin)));
  }
  const auto n = static_cast<Eigen::Index>(values.size());
  if (n == 0) return band;
  band.fall = std::max(0.1, std::log(std::abs(values.front()) / std::max(quietest, 1e-300)));
  band.value = Eigen::Map<const Eigen::VectorXcd>(values.data(), n);
  band.root = Eigen::Map<const Eigen::VectorXd>(roots.data(), n);
  return band;
}

/// A model with its parameters.
struct Fitted {
  OscillationModel model = {};
  Eigen::VectorXd p = {};
  double chi_square = HUGE_VAL;
  bool converged = false;
  Complex first = 0.0;
  Complex second = 0.0;
};

Fitted fitted(const Baseband& band, const OscillationModel& model, Eigen::VectorXd start) {
  OscillationFit fit(band, model);
  Fitted found{.model = model, .p = std::move(start)};
  found.converged = fit.minimise(found.p);
  found.chi_square = fit.chi_square();
  found.first = fit.first_amplitude();
  found.second = fit.second_amplitude();
  return found;
}

/// The mode alone, with one coefficient more at a time.
Fitted mode_alone(const Baseband& band, int coefficients) {
  Eigen::VectorXd start = Eigen::VectorXd::Zero(2);
  start[0] = 1.0;
  Fitted best = fitted(band, {.decays = 1, .omegas = 1}, start);
  for (int n = 2; n <= coefficients; ++n) {
    Eigen::VectorXd more = Eigen::VectorXd::Zero(2 * n);
    more.head(n - 1) = best.p.head(n - 1);
    more.segment(n, n - 1) = best.p.tail(n - 1);
    best = fitted(band, {.decays = n, .omegas = n}, more);
  }
  return best;
}

/// Candidates of a second oscillation beside the mode, best first: (Δ, δ₂) over the mean decay
/// rate.
std::vector<Eigen::Vector2d> places_of_second(const Baseband& band, const Fitted& alone,
                                              std::size_t most) {
  struct Place {
    Eigen::Vector2d at;
    double squares;
  };
  OscillationFit fit(band, alone.model);
  const Eigen::VectorXcd mode = fit.mode(alone.p);
  const double reach = 2.0 * std::numbers::pi * kMostLines / band.length / band.decay;
  constexpr double kStep = 0.4;  // of the mean decay rate: a fraction of the width of a line
  const int steps = static_cast<int>(std::ceil(reach / kStep));
  std::vector<Place> places;
  for (int i = -steps; i <= steps; ++i) {
    Place best{Eigen::Vector2d::Zero(), HUGE_VAL};
    for (const double decay : {0.0, 0.4, 0.9, 1.6, 3.0}) {
      const double turn = kStep * i + 0.05;  // never the mode's own frequency
      const Eigen::VectorXcd beside = fit.second(turn * band.decay, decay * band.decay);
      const double squares = fit.residual_of(mode, beside).squaredNorm();
      if (squares < best.squares) best = {{turn, decay}, squares};
    }
    places.push_back(best);
  }
  std::vector<Place> lowest;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool low = (i == 0 || places[i].squares <= places[i - 1].squares) &&
                     (i + 1 == places.size() || places[i].squares <= places[i + 1].squares);
    if (low) lowest.push_back(places[i]);
  }
  std::ranges::sort(lowest, {}, &Place::squares);
  if (lowest.size() > most) lowest.resize(most);
  std::vector<Eigen::Vector2d> found;
  for (const Place& place : lowest) found.push_back(place.at);
  return found;
}

/// Two oscillations of constant frequency and decay; the stronger is the first.
Fitted two_oscillations(const Baseband& band, const Fitted& alone) {
  constexpr std::size_t kStarts = 5;
  const OscillationModel model{.second = true};
  Fitted best;
  for (const Eigen::Vector2d& place : places_of_second(band, alone, kStarts)) {
    Eigen::VectorXd start(4);
    start << alone.p[0], alone.p[1], place;
    const Fitted found = fitted(band, model, start);
    if (found.chi_square < best.chi_square) best = found;
  }
  if (best.p.size() == 0) return best;
  OscillationFit fit(band, model);
  const double first = std::abs(best.first) * fit.second(0.0, best.p[0] * band.decay).norm();
  const double second = std::abs(best.second) * fit.second(0.0, best.p[3] * band.decay).norm();
  if (second > first) {
    best.p = Eigen::Vector4d(best.p[3], best.p[2], best.p[1], best.p[0]);
    (void)fit.residual(best.p);
    best.chi_square = fit.chi_square();
    best.first = fit.first_amplitude();
    best.second = fit.second_amplitude();
  }
  return best;
}

/// Nothing where the two are none: one grows, they lie too far apart, or at one frequency, where
/// they are a smooth decay too, fast at first and then slow.
std::optional<SecondOscillation> oscillation_of(const Baseband& band, const Fitted& found) {
  constexpr double kApart = 0.15;      // of the mode's decay rate
  constexpr double kLeastGain = 0.05;  // cos⁴ lets nothing through at 3, 4, … lines
  const OscillationFit fit(band, found.model);
  SecondOscillation second;
  second.begin = band.begin;
  second.length = band.length;
  second.steady = found.model.steady;
  second.omega = band.omega + fit.second_omega(found.p);
  second.decay = fit.second_decay(found.p);
  second.beside_joint = found.model.joint;
  second.mode_omega = band.omega + fit.first_omega(found.p);
  second.mode_decay = fit.first_decay(found.p);
  const double lines = std::abs(second.omega - band.omega) * band.length / (2.0 * std::numbers::pi);
  if (second.decay < 0.0 || !(second.mode_decay > 0.0) || lines > kMostLines) return std::nullopt;
  const bool apart = std::abs(second.omega - second.mode_omega) > kApart * second.mode_decay;
  if (!second.steady && !apart) return std::nullopt;
  const double own =
      std::abs(gain_of(second.mode_decay, second.mode_omega - band.omega, band.length));
  const Complex passed = gain_of(second.decay, second.omega - band.omega, band.length);
  const double beside = std::abs(passed);
  if (!(own > kLeastGain && beside > kLeastGain)) return std::nullopt;
  second.phase = std::arg(found.second / passed);
  second.mode_amplitude = 2.0 * std::abs(found.first) / own;
  second.amplitude = 2.0 * std::abs(found.second) / beside;
  second.ratio = second.amplitude / second.mode_amplitude;
  return second;
}

/// Whether the residual of a fit is only noise.
bool leaves_noise(const Baseband& band, const Fitted& found) {
  constexpr double kNoise = 2.0;  // χ² of what is left, over its expected value
  constexpr double kMore = 30.0;  // of χ², for few values
  return found.chi_square < kNoise * band.independent() + kMore;
}

/// Whether two oscillations explain the values, and no smooth decay of one mode does.
bool are_two(const Baseband& band, const Fitted& two) {
  constexpr int kCubic = 4;        // coefficients
  constexpr double kSure = 16.0;   // of χ²: the one mode has more unknowns and should leave less
  constexpr double kUnsure = 4.0;  // times as much where its fit did not converge
  if (!leaves_noise(band, two)) return false;
  const Fitted alone = mode_alone(band, kCubic);
  const double left = std::max(1.0, two.chi_square / band.independent());
  const double most = two.chi_square + kSure * left;
  return alone.chi_square > (alone.converged ? most : kUnsure * most);
}

/// The mode with a joint, from the course of its polynomials.
Fitted jointed_mode(const Baseband& band, const Fitted& cubic) {
  constexpr double kLeast = 0.05;  // of the mean decay rate
  const auto sum = [](const auto& coefficients) { return coefficients.sum(); };
  const double first = std::max(kLeast, cubic.p[0]);
  const double last = std::max(kLeast, sum(cubic.p.head(4)));
  Eigen::VectorXd start = Eigen::VectorXd::Zero(8);
  start[0] = std::log(first);
  start[1] = std::log(last / first);
  start[4] = sum(cubic.p.tail(4));
  start[5] = start[4] - cubic.p[4];
  start[7] = 1.0;
  return fitted(band, {.decays = 4, .omegas = 4, .joint = true}, start);
}

/// (Δ, δ₂) over the mean decay rate of what there is in the last third, which may outlast the mode.
Eigen::Vector2d place_at_last(const Baseband& band) {
  const Eigen::Index last = band.value.size() / 3;
  const Complex turn = band.value.tail(last).head(last - 1).dot(band.value.tail(last - 1));
  const double before = band.value.tail(last).head(last - 1).squaredNorm();
  const Complex step = turn / before;  // e^{(−δ₂ + iΔ)h}
  return Eigen::Vector2d(std::arg(step), -std::log(std::abs(step))) / (band.hop * band.decay);
}

/// The values less a second oscillation, as strong as all is in the last third: it may outlast the
/// mode. @param place  (Δ, δ₂) over the mean decay rate.
Baseband without_last(const Baseband& band, const Eigen::Vector2d& place) {
  const OscillationFit fit(band, {.second = true});
  const Eigen::VectorXcd second = fit.second(place[0] * band.decay, place[1] * band.decay);
  const Eigen::Index last = band.value.size() / 3;
  const Complex amplitude =
      second.tail(last).dot(band.value.tail(last)) / second.tail(last).squaredNorm();
  Baseband rest = band;
  rest.value -= amplitude * second;
  return rest;
}

/// Whether the two beat: their phases turn by half a period against each other while the second is
/// not small beside the mode. Otherwise it may be a part of the mode's own decay.
bool beats(const Baseband& band, const Fitted& two) {
  constexpr double kSmall = 0.1;  // of the largest ratio
  const OscillationFit fit(band, two.model);
  const Eigen::VectorXcd mode = fit.mode(two.p);
  const Eigen::VectorXcd ratio =
      fit.second(fit.second_omega(two.p), fit.second_decay(two.p)).cwiseQuotient(mode);
  const double least = kSmall * ratio.cwiseAbs().maxCoeff();
  double turned = 0.0;
  for (Eigen::Index i = 1; i < ratio.size(); ++i) {
    if (std::abs(ratio[i]) < least) continue;
    turned += std::abs(std::arg(ratio[i] * std::conj(ratio[i - 1])));
  }
  return turned > std::numbers::pi;
}

/// A mode with a joint and an oscillation beside it, where that explains nearly all that the mode
/// alone leaves.
std::optional<SecondOscillation> beside_jointed_mode(Baseband band) {
  constexpr Eigen::Index kFewest = 32;
  constexpr std::size_t kStarts = 5;
  // χ² of a mode with a joint alone, over its expected value: joints of other kinds than the fitted
  // leave some ten.
  constexpr double kMuch = 50.0;
  constexpr double kNearlyAll = 20.0;  // times less of χ² with the other, and only noise left
  constexpr double kAll = 1000.0;      // or so much less
  constexpr double kLeastAmplitude = 0.02;  // of the mode's
  constexpr double kFarthest = 4.0;         // between the two, of the mode's decay rate
  constexpr int kCubic = 4;
  if (band.value.size() < kFewest) return std::nullopt;
  // What outlasts the mode makes the walk slow.
  band.decay = std::max(band.decay, early_decay(band));
  if (leaves_noise(band, mode_alone(band, 1))) return std::nullopt;
  const Fitted alone = jointed_mode(band, mode_alone(band, kCubic));
  if (alone.chi_square < kMuch * band.independent()) return std::nullopt;
  const OscillationModel model{.decays = 4, .omegas = 4, .second = true, .joint = true};
  Fitted best;
  std::vector<Eigen::Vector2d> places = places_of_second(band, alone, kStarts);
  places.push_back(place_at_last(band));
  for (const Eigen::Vector2d& place : places) {
    const Baseband rest = without_last(band, place);
    for (const Fitted& mode : {alone, jointed_mode(rest, mode_alone(rest, kCubic))}) {
      Eigen::VectorXd start(10);
      start << mode.p, place;
      const Fitted found = fitted(band, model, start);
      if (found.chi_square < best.chi_square) best = found;
    }
  }
  const double less = alone.chi_square / best.chi_square;
  if (!(less > (leaves_noise(band, best) ? kNearlyAll : kAll))) return std::nullopt;
  const auto found = oscillation_of(band, best);
  if (!found || found->decay > found->mode_decay) return std::nullopt;
  if (!(found->ratio > kLeastAmplitude && found->ratio < 1.0)) return std::nullopt;
  const bool near = std::abs(found->omega - found->mode_omega) < kFarthest * found->mode_decay;
  return near && beats(band, best) ? found : std::nullopt;
}

/// Returns whether other evidence also shows a steady tone.
using ToneCheck = std::function<bool(const SecondOscillation&)>;

std::optional<SecondOscillation> second_in(const Baseband& band, const ToneCheck& may_be_tone) {
  constexpr Eigen::Index kFewest = 16;
  constexpr double kSteady = 9.0;  // of χ²: three standard deviations
  if (band.value.size() < kFewest) return std::nullopt;
  const Fitted alone = mode_alone(band, 1);
  if (leaves_noise(band, alone)) return std::nullopt;
  const Fitted two = two_oscillations(band, alone);
  if (!are_two(band, two)) return std::nullopt;
  const Fitted tone = fitted(band, {.second = true, .steady = true}, two.p.head(3));
  if (tone.chi_square < two.chi_square + kSteady) {
    const auto found = oscillation_of(band, tone);
    if (found && may_be_tone(*found)) return found;
  }
  return oscillation_of(band, two);
}

/// Whether a tone is also in the record before the blow, where that is conclusive.
bool is_before(const SecondOscillation& tone, std::span<const double> before, double rate,
               double noise_variance) {
  constexpr double kFewestPeriods = 4.0;
  constexpr double kSeen = 4.0;  // standard deviations
  constexpr double kShare = 0.5;
  const double length = (static_cast<double>(before.size()) - 1.0) / rate;
  if (length * tone.omega < kFewestPeriods * 2.0 * std::numbers::pi) return true;
  const TaperedWindow window(before, rate, length / 2.0, length);
  const double noise = 2.0 * std::sqrt(noise_variance * window.noise_gain());
  if (tone.amplitude < kSeen * noise) return true;
  return 2.0 * std::abs(window.transform(tone.omega)) > kShare * tone.amplitude;
}

}  // namespace

double SecondOscillation::value_at(double time) const {
  const double since = time - begin;
  return amplitude * std::exp(-decay * since) * std::cos(phase + omega * since);
}

DecayWindow SecondOscillation::mode_at(double time) const {
  return {.centre = time,
          .length = length,
          .amplitude = mode_amplitude * std::exp(-mode_decay * (time - begin)),
          .decay = mode_decay,
          .omega = mode_omega,
          .beside = {}};
}

std::optional<SecondOscillation> find_second_oscillation(const DecayTask& task,
                                                         std::span<const DecayWindow> windows,
                                                         double noise_variance,
                                                         std::span<const double> before) {
  if (windows.empty()) return std::nullopt;
  // Beyond the windows, where the mode has died away and a tone has not, and where a beat may have
  // ended the walk early; if that is inconclusive, as the end of the record may be disturbed, along
  // the windows alone.
  constexpr double kLonger = 2.0;
  constexpr double kFall = 8.0;  // of ln A
  const double walked = windows.back().centre + windows.back().length / 2.0;
  const double reach = std::max(kLonger * (walked - task.from),
                                kFall / std::max(windows.front().decay, kFall / task.to));
  const double end = std::min(task.to, task.from + reach);
  // A mode that hardly decays looks like a tone, but begins with the blow.
  const ToneCheck may_be_tone = [&](const SecondOscillation& tone) {
    return is_before(tone, before, task.rate, noise_variance);
  };
  const auto band_of = [&](const BandChoice& choice) {
    return baseband_of(task, windows, noise_variance, choice);
  };
  auto found = second_in(band_of({.end = end}), may_be_tone);
  if (!found && end > walked) found = second_in(band_of({.end = walked}), may_be_tone);
  if (!found) found = beside_jointed_mode(band_of({.end = end, .shorter = 0.0, .most = 400.0}));
  return found;
}

double relative_shift(const SecondOscillation& second, const DecayWindow& window,
                      const MeasuredMotion& measured) {
  const double alone = decay_point(second.mode_at(window.centre), measured, 0.0).damping;
  return decay_point(window, measured, 0.0).damping / alone - 1.0;
}

void add_shifts(const SecondOscillation& second, std::span<const DecayWindow> windows,
                const MeasuredMotion& measured, std::span<DecayPoint> points) {
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const DecayPoint alone = decay_point(second.mode_at(windows[i].centre), measured, 0.0);
    DecayPoint& point = points[i];
    point.amplitude_std = std::hypot(point.amplitude_std, point.amplitude - alone.amplitude);
    point.omega_std = std::hypot(point.omega_std, point.omega - alone.omega);
    point.damping_std = std::hypot(point.damping_std, point.damping - alone.damping);
    point.loss_std = std::hypot(point.loss_std, point.loss - alone.loss);
  }
}

}  // namespace microslip
