// SPDX-License-Identifier: MIT
// Records of laws that are no Masing joint, each the force of a motion by its own equations.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/identify/records/record_inversion.hpp"
#include "microslip/identify/records/record_start.hpp"

namespace microslip::record_departures_test {
namespace {

constexpr int kPerCycle = 200;
constexpr int kCycles = 8;

enum class Motion { kSteady, kGrowing };

/// Sines of amplitude 1, or that grow to it.
std::vector<double> path_of(Motion motion) {
  std::vector<double> path;
  for (int i = 0; i <= kCycles * kPerCycle; ++i) {
    const double cycles = static_cast<double>(i) / kPerCycle;
    const double size = motion == Motion::kSteady ? 1.0 : std::max(0.06, cycles / kCycles);
    path.push_back(size * std::sin(2.0 * std::numbers::pi * cycles));
  }
  return path;
}

/// A joint of 60 sliders, moved one by one: slip displacements even up to `reach`, 80 % of k = 1.
class Sliders {
 public:
  explicit Sliders(double reach) : reach_(reach), stretch_(60, 0.0) {}

  /// Moves by a step. @param load  of the contact, over the first. @return the force.
  double move(double step, double load = 1.0) {
    place_ += step;
    double sum = 0.2 * place_;
    const auto n = static_cast<double>(stretch_.size());
    for (std::size_t j = 0; j < stretch_.size(); ++j) {
      const double limit = load * reach_ * (static_cast<double>(j) + 0.5) / n;
      stretch_[j] = std::clamp(stretch_[j] + step, -limit, limit);
      sum += 0.8 / n * stretch_[j];
    }
    return sum;
  }

 private:
  double reach_;
  std::vector<double> stretch_;
  double place_ = 0.0;
};

/// The force of each sample by a law that is given the step and the time from 0 to 1.
std::vector<double> forces(const std::vector<double>& path,
                           const std::function<double(double, double)>& law) {
  std::vector<double> force;
  double before = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    force.push_back(
        law(path[i] - before, static_cast<double>(i) / static_cast<double>(path.size() - 1)));
    before = path[i];
  }
  return force;
}

/// Bouc–Wen, F = αu + (1 − α)z, dz = (1 − (γ + β sgn(z u̇))|z/0.3|ⁿ) du [Wen, J. Eng. Mech. Div.
/// ASCE 102 (1976) 249], with α = 0.1, by the midpoint rule in 20 steps a sample.
std::vector<double> bouc_wen(const std::vector<double>& path, double beta, double gamma) {
  double u = 0.0;
  double z = 0.0;
  return forces(path, [=](double step, double) mutable {
    constexpr int kSteps = 20;
    const auto slope = [&](double at) {
      return 1.0 - (gamma + beta * (at * step > 0.0 ? 1.0 : -1.0)) * std::abs(at / 0.3);
    };
    for (int k = 0; k < kSteps; ++k) {
      z += step / kSteps * slope(z + 0.5 * step / kSteps * slope(z));
    }
    u += step;
    return 0.1 * u + 0.9 * z;
  });
}

/// Masing's branches drawn half way to their chords: the same virgin curve with half of the loss,
/// as sands show [Phillips & Hashash, Soil Dyn. Earthq. Eng. 29 (2009) 1143]. Growing sines alone:
/// a branch starts from the virgin curve and ends there.
std::vector<double> half_the_loss(const std::vector<double>& path) {
  const auto virgin = [](double h) {
    Sliders joint(0.6);
    return joint.move(h);
  };
  double turn = 0.0;  // where the branch began; 0 on the virgin curve
  double before = 0.0;
  double direction = 0.0;
  std::vector<double> force;
  for (const double u : path) {
    const double now = u >= before ? 1.0 : -1.0;
    if (direction != 0.0 && now != direction) turn = before;
    direction = now;
    before = u;
    if (turn == 0.0 || std::abs(u) > std::abs(turn)) {
      turn = 0.0;
      force.push_back(u < 0.0 ? -virgin(-u) : virgin(u));
      continue;
    }
    const double h = 0.5 * std::abs(u - turn);
    const double a = std::abs(turn);
    const double masing = virgin(a) - 2.0 * virgin(h);
    const double chord = virgin(a) * (1.0 - 2.0 * h / a);
    force.push_back((turn > 0.0 ? 1.0 : -1.0) * 0.5 * (masing + chord));
  }
  return force;
}

/// A joint in series with a play of ±0.1: it is without force while the play is passed.
std::vector<double> behind_play(const std::vector<double>& path) {
  constexpr double kPlay = 0.1;
  Sliders joint(0.6);
  double gap = 0.0;
  double force = 0.0;
  return forces(path, [=](double step, double) mutable {
    constexpr int kSteps = 20;
    for (int k = 0; k < kSteps; ++k) {
      double part = step / kSteps;
      if (force * part >= 0.0) {
        const double to = std::clamp(gap + part, -kPlay, kPlay);
        part -= to - gap;
        gap = to;
      }
      // Unloading, it is in contact until no force is left.
      const double by = joint.move(part);
      force = part != 0.0 && by * force >= 0.0 ? by : part != 0.0 ? 0.0 : force;
    }
    return force;
  });
}

/// A bolt that slips at a force of 0.1 and bears on its hole from ±0.3 on: the contact yields at a
/// stretch of 0.05, and closes farther out from then on.
std::vector<double> bearing_bolt(const std::vector<double>& path) {
  double u = 0.0;
  double friction = 0.0;
  double right = 0.3;
  double left = 0.3;
  return forces(path, [=](double step, double) mutable {
    u += step;
    friction = std::clamp(friction + 5.0 * step, -0.1, 0.1);
    right = std::max(right, u - 0.05);
    left = std::max(left, -u - 0.05);
    return friction + 5.0 * (std::max(0.0, u - right) - std::max(0.0, -u - left));
  });
}

std::string first_of(const std::vector<double>& path, const std::vector<double>& force) {
  constexpr double kLength = 1e-5;    // m
  constexpr double kStiffness = 1e7;  // N/m
  ForceRecord record;
  record.time_step = 1e-2;
  for (std::size_t i = 0; i < path.size(); ++i) {
    record.displacement.push_back(kLength * path[i]);
    record.force.push_back(kStiffness * kLength * force[i]);
  }
  const RecordEvidence evidence(std::move(record), PathStart::kVirgin);
  const RecordInversionResult found = invert_records({&evidence, 1}, {}, {.draws = 100});
  const RecordVerdict& first = found.records.front().verdicts.front();
  return first.broken ? std::string(to_string(first.departure)) : "";
}

// Growing, they were said to drift, with γ > β to have a dead zone.
TEST(RecordDepartures, SmoothHystereticLinksAreNotMasing) {
  const std::vector<double> growing = path_of(Motion::kGrowing);
  EXPECT_EQ(first_of(growing, bouc_wen(growing, 0.5, 0.5)), "not_masing");
  EXPECT_EQ(first_of(growing, bouc_wen(growing, 0.1, 0.9)), "not_masing");
  const std::vector<double> steady = path_of(Motion::kSteady);
  EXPECT_EQ(first_of(steady, bouc_wen(steady, 0.3, 0.7)), "not_masing");
}

TEST(RecordDepartures, NarrowerLoopsOnTheSameVirginCurveAreNotMasing) {
  const std::vector<double> growing = path_of(Motion::kGrowing);
  EXPECT_EQ(first_of(growing, half_the_loss(growing)), "not_masing");
}

TEST(RecordDepartures, PlayAndBearingAreADeadZone) {
  const std::vector<double> growing = path_of(Motion::kGrowing);
  EXPECT_EQ(first_of(growing, behind_play(growing)), "dead_zone");
  EXPECT_EQ(first_of(growing, bearing_bolt(growing)), "dead_zone");
}

// Of a load that falls by a fifth over steady cycles, and of growing ones of the same joint.
TEST(RecordDepartures, AChangingLoadIsADrift) {
  const std::vector<double> steady = path_of(Motion::kSteady);
  Sliders joint(0.6);
  EXPECT_EQ(first_of(steady, forces(steady,
                                    [&](double step, double time) {
                                      return joint.move(step, 1.0 - 0.2 * time);
                                    })),
            "drifts");
  const std::vector<double> growing = path_of(Motion::kGrowing);
  Sliders constant(0.6);
  EXPECT_EQ(
      first_of(growing, forces(growing, [&](double step, double) { return constant.move(step); })),
      "");
}

// A virgin joint whose force drifts was taken for one that had slipped: offsets of its own state
// hid the drift.
TEST(RecordDepartures, ADriftIsNoUnknownState) {
  const std::vector<double> growing = path_of(Motion::kGrowing);
  Sliders joint(0.6);
  ForceRecord record;
  record.displacement = growing;
  record.force =
      forces(growing, [&](double step, double time) { return joint.move(step) + 0.04 * time; });
  record.time_step = 1e-2;
  EXPECT_EQ(shown_start({record, PathStart::kVirgin}).start, PathStart::kVirgin);
}

// The noise of a force on a path to one side was taken for a difference of the two directions: it
// explained itself in columns made of the measured force.
TEST(RecordDepartures, NoiseOnAPathToOneSideIsNoAsymmetry) {
  std::vector<double> path;
  for (int i = 0; i <= kCycles * kPerCycle; ++i) {
    path.push_back(0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * i / kPerCycle));
  }
  Sliders joint(3.0);
  RandomStream random(5, 0);
  const std::vector<double> force =
      forces(path, [&](double step, double) { return joint.move(step) + 0.01 * random.normal(); });
  EXPECT_EQ(first_of(path, force), "");
}

}  // namespace
}  // namespace microslip::record_departures_test
