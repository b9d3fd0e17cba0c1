// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "support/figures.hpp"

/// @file Random structures under random forces. MICROSLIP_MARCH_DRAWS models (20) are marched for
/// MICROSLIP_MARCH_SECONDS (2).

namespace microslip::march_random_test {
namespace {

using std::numbers::pi;

double from_environment(const char* name, double otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::atof(text);
}

/// Positive numbers that add up to a share of 1 between 0.6 and 1.
std::vector<double> shares(RandomStream& random, std::size_t count) {
  std::vector<double> result;
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum += result.emplace_back(0.1 + random.uniform());
  const double area = 0.6 + 0.39 * random.uniform();
  for (double& share : result) share *= area / sum;
  return result;
}

enum Kind { kFourParameter, kUniform, kPiecewiseLinear, kFourParameterWithAtom, kAtoms, kKinds };

/// @param slip  the slip force about which its own lie, N.
SlipDensity random_density(RandomStream& random, Kind kind, double slip, double stiffness) {
  switch (kind) {
    case kFourParameter:
      return SlipDensity({FourParameterPart{slip, stiffness, -0.9 * random.uniform(), 0.0}});
    case kFourParameterWithAtom: {
      const double chi = -0.9 * random.uniform();
      return SlipDensity({FourParameterPart{slip, stiffness, chi, 2.0 * random.uniform()}});
    }
    case kUniform:
      return SlipDensity({UniformPart{0.0, 2.0 * slip, 0.5 + 0.5 * random.uniform()}});
    case kPiecewiseLinear: {
      PiecewiseLinearPart part;
      for (const double share : shares(random, 7)) {
        part.slip_force.push_back(2.0 * slip * static_cast<double>(part.slip_force.size()) / 6.0);
        part.density.push_back(share * 6.0 / (2.0 * slip));  // the trapezia leave half of two away
      }
      return SlipDensity({std::move(part)});
    }
    default: {
      AtomsPart part;
      part.weight = shares(random, 1 + static_cast<std::size_t>(5.0 * random.uniform()));
      for (std::size_t i = 0; i < part.weight.size(); ++i) {
        part.slip_force.push_back(slip * (0.1 + 1.9 * random.uniform()));
      }
      return SlipDensity({std::move(part)});
    }
  }
}

/// 2 to 5 modes from 10 to 80 Hz, their shapes at two points and at the joints.
struct RandomLinear {
  explicit RandomLinear(RandomStream& random) {
    const auto count = 2 + static_cast<std::size_t>(4.0 * random.uniform());
    for (std::size_t i = 0; i < count; ++i) {
      modes.push_back({2.0 * pi * 10.0 * std::pow(8.0, random.uniform()),
                       2.0 * (0.002 + 0.01 * random.uniform())});
    }
    std::ranges::sort(modes, {}, &Mode::angular_frequency);
    points = {{"drive", shape(random)}, {"response", shape(random)}};
  }
  [[nodiscard]] std::vector<double> shape(RandomStream& random) const {
    std::vector<double> result(modes.size());
    for (double& value : result) value = 0.7 * random.normal();
    return result;
  }
  std::vector<Mode> modes;
  std::vector<ModalPoint> points;
};

/// One or two joints of a kind; elastic where the slip force is infinite.
JointedStructure with_joints(const RandomLinear& linear, std::uint64_t seed, double slip) {
  RandomStream random(seed, 2);
  std::vector<StructuralJoint> joints;
  for (std::size_t j = 0; j < 1 + seed % 2; ++j) {
    const std::vector<double> shape = linear.shape(random);
    double flexibility = 0.0;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      flexibility += std::pow(shape[i] / linear.modes[i].angular_frequency, 2);
    }
    const double stiffness = (0.2 + 1.8 * random.uniform()) / flexibility;
    const double own = slip * std::pow(4.0, random.uniform() - 0.5);
    const auto kind = static_cast<Kind>(seed / 2 % kKinds);
    joints.push_back({.name = std::string(1, static_cast<char>('A' + j)),
                      .joint = std::isfinite(slip)
                                   ? Joint(stiffness, random_density(random, kind, own, stiffness))
                                   : Joint(stiffness, SlipDensity()),
                      .shape = shape});
  }
  return JointedStructure(ModalModel(linear.modes, linear.points), std::move(joints), {{"drive"}});
}

/// White noise through two low passes of 100 Hz, a value a millisecond.
LoadHistory random_force(RandomStream& random, double seconds) {
  LoadHistory loads{{}, {{"drive", {}}}};
  const double keep = std::exp(-2.0 * pi * 100.0 * 1e-3);
  double first = 0.0;
  double second = 0.0;
  for (std::size_t i = 0; 1e-3 * static_cast<double>(i) <= seconds; ++i) {
    loads.time.push_back(1e-3 * static_cast<double>(i));
    loads.forces[0].force.push_back(100.0 * second);
    first += (1.0 - keep) * (random.normal() - first);
    second += (1.0 - keep) * (first - second);
  }
  return loads;
}

struct RandomMarch {
  JointedStructure structure;
  LoadHistory loads;
};

/// Slip forces from a fifth to five times what the stuck joint carries.
RandomMarch random_march(std::uint64_t seed, double seconds) {
  RandomStream random(seed, 1);
  const RandomLinear linear(random);
  LoadHistory loads = random_force(random, seconds);
  LoadHistory trial = random_force(random, 2.0);
  const MarchResult stuck = march(with_joints(linear, seed, HUGE_VAL), trial);
  double square = 0.0;
  for (const double force : stuck.joints[0].force) square += force * force;
  const double carried = std::sqrt(square / static_cast<double>(stuck.time.size()));
  const double slip = carried * 5.0 * std::pow(25.0, -random.uniform());
  return {with_joints(linear, seed, slip), std::move(loads)};
}

struct Marched {
  MarchResult result;
  double error;
};

/// About the chosen step, and halves of it; the truth has steps of an eighth of the least.
std::vector<Marched> halved(const RandomMarch& one, int halvings) {
  constexpr double kSample = 1e-3;
  const double highest = one.structure.stuck_frequencies().back();
  // An even number of steps per sample, so that each halving doubles them.
  const double twentieth = 2.0 * pi / (20.0 * highest);
  const double step =
      std::exp2(-std::max(1.0, std::ceil(std::log2(kSample / twentieth)))) * kSample;
  const auto with_step = [&](double length, double tolerance, bool estimate) {
    return march(one.structure, one.loads,
                 {.step = length,
                  .points = {"response"},
                  .tolerance = tolerance,
                  .estimate_error = estimate});
  };
  const auto exact =
      with_step(std::ldexp(step, -halvings - 3), 1e-12, false).points[0].displacement;
  std::vector<Marched> all;
  for (int i = 0; i <= halvings; ++i) {
    MarchResult found = with_step(std::ldexp(step, -i), i == 0 ? 1e-8 : 1e-12, true);
    double error = 0.0;
    double largest = 0.0;
    for (std::size_t k = 0; k < found.time.size(); ++k) {
      error = std::max(error, std::abs(found.points[0].displacement[k] - exact[k]));
      largest = std::max(largest, std::abs(exact[k]));
    }
    all.push_back({std::move(found), error / largest});
  }
  return all;
}

// None stops at the default step, and the estimate is within a factor of 5 of the true error. The
// order is that of the smooth densities, whose only kinks are turns and loops that close.
TEST(MarchRandom, EstimatesItsError) {
  const auto draws = static_cast<std::uint64_t>(from_environment("MICROSLIP_MARCH_DRAWS", 20.0));
  const double seconds = from_environment("MICROSLIP_MARCH_SECONDS", 2.0);
  double order = 0.0;
  double smooth = 0.0;
  for (std::uint64_t seed = 1; seed <= draws; ++seed) {
    const RandomMarch one = random_march(seed, seconds);
    const MarchResult chosen = march(one.structure, one.loads, {.points = {"response"}});
    EXPECT_TRUE(chosen.summary.converged()) << seed << ": " << chosen.summary.full();
    EXPECT_EQ(chosen.time.size(), one.loads.time.size()) << seed;
    const bool is_smooth = seed / 2 % kKinds < kFourParameterWithAtom;
    const std::vector<Marched> found = halved(one, is_smooth ? 2 : 0);
    ASSERT_TRUE(found[0].result.error_estimate.has_value()) << seed;
    const double ratio = *found[0].result.error_estimate / found[0].error;
    EXPECT_LT(std::max(ratio, 1.0 / ratio), 5.0) << seed << ", error " << found[0].error;
    test::record_largest("ratio [1]", std::max(ratio, 1.0 / ratio));
    if (!is_smooth) continue;
    order += 0.5 * std::log2(found[0].error / found[2].error);
    smooth += 1.0;
  }
  EXPECT_GT(order / smooth, 3.0);
  test::record_smallest("order [1]", order / smooth);
}

}  // namespace
}  // namespace microslip::march_random_test
