// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/sweep_resonance.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "support/figures.hpp"
#include "support/messages.hpp"

namespace microslip::sweep_resonance_test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180.0;
constexpr double kFrequency = 80.0;  // Hz, with all stuck
constexpr double kMass = 2.0;        // kg

/// One step of a sweep, by its lag.
void append(double omega, double force, double displacement, double lag, SteppedSine& sweep) {
  sweep.frequency.push_back(omega / (2.0 * kPi));
  sweep.force.push_back(force);
  sweep.acceleration.push_back(omega * omega * displacement);
  sweep.phase.push_back(kPi - lag);  // of the acceleration
}

/// Lags at so many degrees from each other between 15 and 165°, the resonance at a share of one of
/// the distances.
std::vector<double> lags(double step, double share) {
  std::vector<double> all;
  for (double lag = 90.0 - (share + 8.0) * step; lag < 165.0; lag += step) {
    if (lag > 15.0) all.push_back(lag * kDegree);
  }
  return all;
}

// ---- A mass on a spring and a viscous damper, in closed form. ----

constexpr double kZeta = 0.005;

/// The frequency of a lag: tan(lag) = 2ζω₀ω/(ω₀² − ω²).
double omega_of(double lag) {
  const double w0 = 2.0 * kPi * kFrequency;
  const double b = kZeta * w0 / std::tan(lag);
  return -b + std::sqrt(b * b + w0 * w0);
}

// Frequency to rounding: K is straight over ω². F/A = 2ζω₀m/ω, whose logarithm lies beside its
// chord over ω² by (δω/ω)²/4 at most: 8e-6 with 60° between two steps, δω = 2ζω₀ tan 30°.
TEST(SweepResonance, IsExactForALinearMode) {
  const double w0 = 2.0 * kPi * kFrequency;
  for (const bool held_force : {true, false}) {
    for (const double step : {10.0, 20.0, 34.0, 60.0}) {
      for (const double share : {0.1, 0.4, 0.5, 0.9}) {
        SteppedSine sweep;
        for (const double lag : lags(step, share)) {
          const double w = omega_of(lag);
          const double stiffness =
              std::hypot(kMass * (w0 * w0 - w * w), 2.0 * kZeta * w0 * w * kMass);
          const double x = held_force ? 1.0 / stiffness : 1e-4;
          append(w, stiffness * x, x, lag, sweep);
        }
        const SweepResonance found = resonance_of(sweep).value();
        EXPECT_NEAR(found.frequency / kFrequency, 1.0, 1e-12);
        EXPECT_NEAR(found.force / found.acceleration / (2.0 * kZeta * kMass), 1.0, 1e-5)
            << step << "° a step, " << share;
      }
    }
  }
}

// ---- A mass on a spring with a joint, by the harmonic balance. ----

/// The constant quantity.
enum class Held { kForce, kResponse, kNeither };

/// All its damping, but a linear part, and all its softening are the joint's.
HarmonicBalance jointed(const SlipDensity& density) {
  const double shape = 1.0 / std::sqrt(kMass);
  const Joint joint(4e5, density);
  JointedStructure structure(
      ModalModel({{2.0 * kPi * kFrequency, 0.002}}, {{"mass", {shape}}}),
      {{.name = "joint", .joint = joint, .shape = {shape}, .spring_in_modes = 4e5}},
      {{.point = "mass"}});
  return {std::move(structure), {"mass"}, {.harmonics = 3}};
}

HarmonicBalance jointed(double exponent) {
  return jointed(
      SlipDensity({PowerLawPart{2e-4 * std::pow(100.0, -exponent + 0.2), exponent, 0.0, 150.0}}));
}

/// The constant quantity at a lag. Where it is neither force nor response, the force falls to seven
/// tenths at resonance, as that of a shaker does.
Target kept_at(double lag, Held held, const SteadyVibration& peak) {
  if (held == Held::kResponse) return {Quantity::kResponse, peak.response};
  const double dip = held == Held::kNeither ? 1.0 + 0.3 / 0.7 * std::pow(std::cos(lag), 2) : 1.0;
  return {Quantity::kForceAmplitude, dip * peak.force_amplitude};
}

/// The vibration of a lag, through those of lags 3° apart.
SteadyVibration at_lag(const HarmonicBalance& balance, double lag, Held held,
                       const SteadyVibration& peak) {
  const double away = lag - 0.5 * kPi;
  const auto count = static_cast<int>(std::ceil(std::abs(away) / (3.0 * kDegree)));
  SteadyVibration vibration = peak;
  for (int i = 1; i <= count; ++i) {
    const double there = 0.5 * kPi + away * i / count;
    const VibrationResult found =
        balance.solve({Quantity::kPhaseLag, there}, kept_at(there, held, peak), vibration);
    EXPECT_TRUE(found.summary.converged()) << found.summary.reason;
    vibration = found.vibration;
  }
  return vibration;
}

/// A sweep by lags about the resonance at a displacement.
SteppedSine swept(const HarmonicBalance& balance, Held held, double displacement,
                  const std::vector<double>& lags) {
  const SteadyVibration peak =
      balance.solve(kPhaseResonance, {Quantity::kResponse, displacement}).vibration;
  SteppedSine sweep;
  for (const double lag : lags) {
    const SteadyVibration step = at_lag(balance, lag, held, peak);
    append(step.angular_frequency, step.force_amplitude, step.response, step.phase_lag, sweep);
  }
  return sweep;
}

/// Of the phase resonance that a coarse sweep gives against that of the structure at the same
/// response.
struct Miss {
  double force = 0.0;       ///< relative, 1
  double frequency = 0.0;   ///< Hz
  double half_width = 0.0;  ///< of the half-power band there, Hz
};

Miss miss_of(const HarmonicBalance& balance, const SweepResonance& found) {
  const double w = 2.0 * kPi * found.frequency;
  const SteadyVibration there =
      balance.solve(kPhaseResonance, {Quantity::kResponse, found.acceleration / (w * w)}).vibration;
  return {std::abs(found.force / there.force_amplitude - 1.0),
          std::abs(found.frequency - there.frequency()), there.damping_ratio() * there.frequency()};
}

/// Where between two steps the resonance may lie.
constexpr std::array kShares{0.2, 0.5, 0.8};

/// Calls check(found, miss) for sweeps at steps of so many degrees: densities that fall and rise, D
/// of slip with X^2.5 to X^3.2; much and little linear damping beside it; of each every constant
/// quantity.
template <typename Check>
void for_each_sweep(double step, const Check& check) {
  for (const double exponent : {-0.5, 0.0, 0.2}) {
    const HarmonicBalance balance = jointed(exponent);
    for (const double displacement : {4e-5, 2e-4}) {
      for (const Held held : {Held::kForce, Held::kResponse, Held::kNeither}) {
        for (const double share : kShares) {
          const SweepResonance found =
              resonance_of(swept(balance, held, displacement, lags(step, share))).value();
          check(found, miss_of(balance, found));
        }
      }
    }
  }
}

void check_and_record(double step, const std::string& name) {
  for_each_sweep(step, [&](const SweepResonance& found, const Miss& miss) {
    // The stated error includes that, but not the effect of the third harmonic along a sweep.
    EXPECT_LE(miss.force, found.damping_std + 2e-6);
    EXPECT_LE(miss.frequency, found.frequency_std + 2e-6 * miss.half_width);
    test::record_largest("force, " + name + " [1]", miss.force);
    test::record_largest("frequency, " + name + " [1]", miss.frequency / miss.half_width);
  });
}

// Against the phase resonance of the same structure, solved by itself. Straight lines of ln F and
// ln A over the phase, which were the rule, make F/A 0.4 % too large with 11° between two steps,
// 4.6 % with 34°, 16 % with 60°.
TEST(SweepResonance, BetweenCoarseStepsIsThatOfTheJoint) {
  check_and_record(11.0, "up to 34 degrees");
  check_and_record(20.0, "up to 34 degrees");
  check_and_record(34.0, "up to 34 degrees");
  check_and_record(60.0, "60 degrees");
}

// A population of sliders that ends at 60 N, below the 80, 120 and 160 N of the peaks: D grows with
// A^3 below and with A above, and ln C over ln X has a bend at the end that no power
// has. Coarse steps on either side of it state the error that the steps beside these show of that
// bend, within its double.
TEST(SweepResonance, KnowsThatAPopulationEndsBetweenItsSteps) {
  const HarmonicBalance balance =
      jointed(SlipDensity({UniformPart{.from = 0.0, .to = 60.0, .weight = 0.1}}));
  for (const double displacement : {2e-4, 3e-4, 4e-4}) {
    for (const double step : {35.0, 45.0, 55.0}) {
      for (const double share : kShares) {
        const SweepResonance found =
            resonance_of(swept(balance, Held::kForce, displacement, lags(step, share))).value();
        // 2e-6 is what the third harmonic changes along a sweep.
        EXPECT_LE(miss_of(balance, found).force, 2.0 * found.damping_std + 2e-6)
            << displacement << " m, " << step << " deg, " << share;
      }
    }
  }
}

// Readings with noise of 1 % in the force and as much across it, 0.01 rad: F/A and frequency of 200
// sweeps miss by as much as each says, within what the rms of 200 is known to, four times 1/√400.
// The stated error of each reading is 1 % and 0.01 rad, each with the deviation of the clean course
// from a straight line.
TEST(SweepResonance, KnowsHowMuchItsStepsScatter) {
  constexpr std::size_t kSweeps = 200;
  const HarmonicBalance balance = jointed(0.0);
  const SteppedSine clean = swept(balance, Held::kForce, 2e-4, lags(11.0, 0.4));
  const SweepResonance smooth = resonance_of(clean).value();
  RandomStream random(1, 1);
  double of_force = 0.0;
  double of_frequency = 0.0;
  double of_amplitude = 0.0;
  double of_phase = 0.0;
  for (std::size_t i = 0; i < kSweeps; ++i) {
    SteppedSine sweep = clean;
    for (double& force : sweep.force) force *= 1.0 + 0.01 * random.normal();
    for (double& phase : sweep.phase) phase += 0.01 * random.normal();
    const SweepResonance found = resonance_of(sweep).value();
    const Miss miss = miss_of(balance, found);
    of_force += std::pow(miss.force / found.damping_std, 2) / kSweeps;
    of_frequency += std::pow(miss.frequency / found.frequency_std, 2) / kSweeps;
    of_amplitude += std::pow(found.amplitude_std, 2) / kSweeps;
    of_phase += std::pow(found.phase_std, 2) / kSweeps;
    EXPECT_NEAR(static_cast<double>(found.scatter_freedom), 7.5, 1.0);  // 10 or 11 such steps
  }
  EXPECT_NEAR(std::sqrt(of_force), 1.0, 0.2);
  EXPECT_NEAR(std::sqrt(of_frequency), 1.0, 0.2);
  EXPECT_NEAR(std::sqrt(of_amplitude) / std::hypot(0.01, smooth.amplitude_std), 1.0, 0.2);
  EXPECT_NEAR(std::sqrt(of_phase) / std::hypot(0.01, smooth.phase_std), 1.0, 0.2);
}

// Noise of one of the two is distinguished from that of the other, by the half that the steps' 30°
// to 150° and three unknowns leave of it in the other.
TEST(SweepResonance, TellsNoiseOfAmplitudesFromThatOfPhases) {
  constexpr std::size_t kSweeps = 50;
  const HarmonicBalance balance = jointed(0.0);
  const SteppedSine clean = swept(balance, Held::kForce, 2e-4, lags(5.0, 0.4));
  RandomStream random(1, 2);
  double along = 0.0;
  double across = 0.0;
  for (std::size_t i = 0; i < kSweeps; ++i) {
    SteppedSine sweep = clean;
    for (double& phase : sweep.phase) phase += 0.02 * random.normal();
    const SweepResonance found = resonance_of(sweep).value();
    along += std::pow(found.amplitude_std, 2) / kSweeps;
    across += std::pow(found.phase_std, 2) / kSweeps;
  }
  EXPECT_NEAR(std::sqrt(across), 0.02, 0.2 * 0.02);
  EXPECT_LT(std::sqrt(along), 0.5 * 0.02);
}

// Noise of the response is one of ln X, too, by which K and C are fitted: of a joint that softens
// it would be estimated twice as large. By neighbours it is not, and steps without noise have next
// to none.
TEST(SweepResonance, TellsNoiseOfResponsesByNeighbours) {
  constexpr std::size_t kSweeps = 50;
  const HarmonicBalance balance = jointed(0.0);
  const SteppedSine clean = swept(balance, Held::kForce, 2e-4, lags(5.0, 0.4));
  EXPECT_LT(resonance_of(clean)->amplitude_std, 1e-4);
  EXPECT_LT(resonance_of(clean)->phase_std, 1e-4);
  RandomStream random(1, 3);
  double along = 0.0;
  double across = 0.0;
  for (std::size_t i = 0; i < kSweeps; ++i) {
    SteppedSine sweep = clean;
    for (double& a : sweep.acceleration) a *= 1.0 + 0.02 * random.normal();
    for (double& phase : sweep.phase) phase += 0.01 * random.normal();
    const SweepResonance found = resonance_of(sweep).value();
    along += std::pow(found.amplitude_std, 2) / kSweeps;
    across += std::pow(found.phase_std, 2) / kSweeps;
  }
  EXPECT_NEAR(std::sqrt(along), 0.02, 0.2 * 0.02);
  EXPECT_NEAR(std::sqrt(across), 0.01, 0.2 * 0.01);
}

// Up and down in one table: no cubic goes through two steps of one frequency.
TEST(SweepResonance, TellsScatterOfRepeatedSteps) {
  SteppedSine sweep = swept(jointed(0.0), Held::kForce, 2e-4, lags(5.0, 0.4));
  const std::size_t steps = sweep.frequency.size();
  for (std::vector<double> SteppedSine::*const values :
       {&SteppedSine::frequency, &SteppedSine::force, &SteppedSine::acceleration,
        &SteppedSine::phase}) {
    const std::vector<double> once = sweep.*values;
    (sweep.*values).insert((sweep.*values).end(), once.rbegin(), once.rend());
  }
  ASSERT_EQ(sweep.frequency.size(), 2 * steps);
  EXPECT_GT(resonance_of(sweep)->amplitude_std, 0.0);
  EXPECT_LT(resonance_of(sweep)->amplitude_std, 0.01);
}

// ---- A spring that softens, past a fold. ----

/// K + iC at X of unit scale: k = k0 − 3C X², so that the backbone has a fold.
struct SofteningSpring {
  double stiffness = kMass * std::pow(2.0 * kPi * kFrequency, 2);
  double lossy = 0.008 * stiffness;

  [[nodiscard]] double elastic(double omega, double x) const {
    return stiffness - 3.0 * lossy * x * x - kMass * omega * omega;
  }
  [[nodiscard]] double resonance(double x) const {
    return std::sqrt(elastic(0.0, x) / kMass) / (2.0 * kPi);
  }
  /// The smaller of the amplitudes at F = C, those of an upward sweep, by bisection from below.
  [[nodiscard]] double response(double omega) const {
    const auto misses = [&](double x) { return std::hypot(elastic(omega, x), lossy) * x < lossy; };
    double low = 0.0;
    while (low < 2.0 && misses(low + 1e-3)) low += 1e-3;
    double high = low + 1e-3;
    for (int i = 0; i < 60; ++i) (misses(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
    return low;
  }
};

// An upward sweep jumps over the resonance, from a lag of 30° or so to one of 130°, in a step that
// is short beside what k changes by in it. The frequency is then known to what k may be off the
// straight line over the mass, not over the slope of K across the jump, which is as steep as the
// step is short.
TEST(SweepResonance, KnowsItsFrequencyPastAFold) {
  const SofteningSpring spring;
  for (const double step : {0.01, 0.05}) {
    SteppedSine sweep;
    for (double f = 78.0; f < 81.0; f += step) {
      const double omega = 2.0 * kPi * f;
      const double x = spring.response(omega);
      append(omega, spring.lossy, x, std::atan2(spring.lossy, spring.elastic(omega, x)), sweep);
    }
    const SweepResonance found = resonance_of(sweep).value();
    EXPECT_GT(found.phase_step, 60.0 * kDegree) << step;
    const double x = found.acceleration / std::pow(2.0 * kPi * found.frequency, 2);
    const double miss = std::abs(found.frequency - spring.resonance(x));
    EXPECT_LT(miss, 2.0 * found.frequency_std) << step << " Hz";
    // And it is no better known than to a part of the half-power width, 0.64 Hz, below which it is.
    EXPECT_LT(found.frequency_std, 0.2) << step << " Hz";
  }
}

std::vector<std::string> codes(const SweepResonance& found) {
  std::vector<std::string> all;
  for (const Warning& warning : warnings_of(found)) all.push_back(warning.code);
  return all;
}

TEST(SweepResonance, WarnsOfCoarseSteps) {
  const HarmonicBalance balance = jointed(0.0);
  const auto found = [&](double step) {
    return resonance_of(swept(balance, Held::kForce, 1e-4, lags(step, 0.5))).value();
  };
  EXPECT_NEAR(found(29.0).phase_step, 29.0 * kDegree, 1e-9);
  EXPECT_TRUE(codes(found(29.0)).empty());
  EXPECT_EQ(codes(found(31.0)), std::vector<std::string>{"coarse_steps"});
  test::expect_message(warnings_of(found(60.0)).front().text, "changes by 60°");
}

// Steps of a resonance further up, behind one that is near none.
TEST(SweepResonance, TakesTheScatterOfItsOwnSteps) {
  SteppedSine sweep = swept(jointed(0.0), Held::kForce, 2e-4, lags(20.0, 0.4));
  const SweepResonance alone = resonance_of(sweep).value();
  append(2.0 * kPi * 90.0, 0.1, 1e-7, 170.0 * kDegree, sweep);
  for (const double lag : {120.0, 100.0, 110.0}) {
    append(2.0 * kPi * (100.0 + 0.01 * lag), 0.1, 1e-7 * lag, lag * kDegree, sweep);
  }
  EXPECT_EQ(resonance_of(sweep)->damping_std, alone.damping_std);
  EXPECT_EQ(resonance_of(sweep)->frequency_std, alone.frequency_std);
}

TEST(SweepResonance, TellsNothingOfScatterByThreeSteps) {
  const HarmonicBalance balance = jointed(0.0);
  const SweepResonance found =
      resonance_of(swept(balance, Held::kResponse, 1e-4, lags(60.0, 0.5))).value();
  // The response was held: the rest is the effect of the third harmonic along a sweep.
  EXPECT_LT(found.damping_std, 2e-6);
  EXPECT_EQ(found.amplitude_std, 0.0);
  EXPECT_EQ(found.phase_std, 0.0);
  EXPECT_EQ(found.scatter_freedom, 0U);
}

// At exactly half a turn the force feeds nothing, and at one frequency nothing is between.
TEST(SweepResonance, TakesWhatIsAtTheEdge) {
  SteppedSine sweep{"sweep", {79.0, 81.0}, {1.0, 1.0}, {10.0, 12.0}, {kPi, 0.3}};
  test::expect_message(test::message_or("none", [&] { return resonance_of(sweep); }),
                       "sweep: phase = 3.14 rad beside the resonance, at 79 Hz; must be between");
  sweep.phase = {0.5 * kPi, 0.3};
  EXPECT_NEAR(resonance_of(sweep)->frequency, 79.0, 1e-12);
  EXPECT_NEAR(resonance_of(sweep)->force, 1.0, 1e-12);
  sweep.frequency = {80.0, 80.0};
  sweep.phase = {2.0, 1.0};
  EXPECT_NEAR(resonance_of(sweep)->frequency, 80.0, 1e-12);
  EXPECT_TRUE(std::isfinite(resonance_of(sweep)->damping_std));
  sweep.phase = {2.0, 1.8};
  EXPECT_FALSE(resonance_of(sweep));
}

}  // namespace
}  // namespace microslip::sweep_resonance_test
