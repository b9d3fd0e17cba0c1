// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "support/figures.hpp"

/// @file
/// Frequency responses of random structures with joints of three kinds. MICROSLIP_RANDOM_RESPONSES
/// is how many of each kind are drawn; without it a few.

namespace microslip::random_responses_test {
namespace {

enum class Kind { kSmooth, kBeta, kAtoms };

class Draw {
 public:
  Draw(Kind kind, std::uint64_t seed)
      : kind_(kind), random_(seed, 10 + static_cast<std::uint64_t>(kind)) {}

  double between(double low, double high) { return low + (high - low) * random_.uniform(); }
  double ratio(double low, double high) { return low * std::pow(high / low, random_.uniform()); }
  std::size_t whole(std::size_t low, std::size_t high) {
    return low + static_cast<std::size_t>(random_.uniform() * static_cast<double>(high - low + 1));
  }

  /// A joint of 1 N or so in macro-slip.
  Joint joint(double stiffness) {
    if (kind_ == Kind::kAtoms) return {stiffness, SlipDensity({atoms()})};
    const double chi = between(-0.9, 0.0);
    if (kind_ == Kind::kBeta) {
      return Joint::four_parameter(ratio(0.5, 2.0), stiffness, chi, ratio(0.02, 5.0));
    }
    switch (whole(0, 2)) {
      case 0:
        return Joint::four_parameter(ratio(0.5, 2.0), stiffness, chi, 0.0);
      case 1:
        return {stiffness, SlipDensity({UniformPart{0.0, ratio(1.0, 4.0), between(0.5, 1.0)}})};
      default:
        return {stiffness,
                SlipDensity({PiecewiseLinearPart{{0.0, 0.5, 2.0}, {between(0.2, 0.6), 0.5, 0.0}}})};
    }
  }

 private:
  AtomsPart atoms() {
    AtomsPart part;
    double left = between(0.5, 1.0);
    double slip = ratio(0.3, 1.0);
    const std::size_t count = whole(1, 3);
    for (std::size_t i = 0; i < count; ++i) {
      const double weight = i + 1 == count ? left : left * between(0.2, 0.9);
      part.slip_force.push_back(slip);
      part.weight.push_back(weight);
      left -= weight;
      slip *= ratio(1.05, 3.0);
    }
    return part;
  }

  Kind kind_;
  RandomStream random_;
};

struct Case {
  HarmonicBalance balance;
  double force;
  double from;
  double to;
};

/// One or two modes and joints, hardly to well damped, forces from stick to macro-slip, ranges
/// about the resonance, some of them with the superharmonic ones.
Case random_case(Kind kind, std::uint64_t seed) {
  Draw draw(kind, seed);
  const std::size_t count = draw.whole(1, 2);
  std::vector<Mode> modes;
  std::vector<double> shape;
  for (std::size_t i = 0; i < count; ++i) {
    const double omega = i == 0 ? draw.ratio(0.1, 1.0) : draw.between(1.5, 4.0);
    modes.push_back({omega, draw.ratio(5e-4, 3e-2)});
    shape.push_back(i == 0 ? draw.between(0.5, 1.5) : draw.between(-1.0, 1.0));
  }
  std::vector<StructuralJoint> joints;
  const std::size_t joint_count = draw.whole(1, count);
  for (std::size_t j = 0; j < joint_count; ++j) {
    std::vector<double> at = shape;
    if (j > 0) at.back() = draw.between(-1.0, 1.0);
    const double stiffness = draw.ratio(0.3, 3.0);
    joints.push_back({"joint " + std::to_string(j), draw.joint(stiffness), at});
  }
  const JointedStructure structure(ModalModel(modes, {{"a", shape}}), std::move(joints), {{"a"}});
  const double stuck = structure.stuck_frequencies().front();
  const std::vector<std::size_t> harmonics{3, 5, 7, 11};
  const bool low = draw.whole(0, 2) == 0;
  const double from = stuck * (low ? draw.between(0.15, 0.4) : draw.between(0.4, 0.7));
  return {
      HarmonicBalance(structure, {"a"}, {.harmonics = harmonics[draw.whole(0, 3)], .samples = 256}),
      draw.ratio(0.02, 2.0), from, stuck * draw.between(1.1, 2.0)};
}

/// How far the polygon lies beside the curve at a third and two thirds of the way between each row
/// and the next, over the top; the nearer of the solutions from either end, as there may be two.
double polygon_deviation(const Case& it, const ResponseCurve& curve) {
  const auto& points = curve.points;
  const double top = std::ranges::max(points, {}, &SteadyVibration::response).response;
  double most = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double run = points[i + 1].angular_frequency - points[i].angular_frequency;
    if (std::abs(run) < 1e-7 * points[i].angular_frequency) continue;
    for (const double share : {1.0 / 3.0, 2.0 / 3.0}) {
      const double omega = points[i].angular_frequency + share * run;
      const double chord =
          points[i].response + share * (points[i + 1].response - points[i].response);
      double nearest = HUGE_VAL;
      for (const std::size_t end : {i, i + 1}) {
        const VibrationResult found =
            it.balance.solve({Quantity::kAngularFrequency, omega},
                             {Quantity::kForceAmplitude, it.force}, points[end]);
        if (!found.summary.converged()) continue;
        nearest = std::min(nearest, std::abs(found.vibration.response - chord));
      }
      if (std::isfinite(nearest)) most = std::max(most, nearest / top);
    }
  }
  return most;
}

std::size_t draws() {
  const char* text = std::getenv("MICROSLIP_RANDOM_RESPONSES");
  return text == nullptr ? 6 : static_cast<std::size_t>(std::strtoul(text, nullptr, 10));
}

class RandomResponse : public ::testing::TestWithParam<Kind> {};

TEST_P(RandomResponse, ReachesItsEndWithItsPeaksAmongItsPoints) {
  std::size_t unfinished = 0;
  for (std::uint64_t seed = 1; seed <= draws(); ++seed) {
    const Case it = random_case(GetParam(), seed);
    const auto start = std::chrono::steady_clock::now();
    const ResponseCurve curve = it.balance.frequency_response(it.force, it.from, it.to);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const std::string name = fmt::format("seed {}", seed);
    if (!curve.summary.converged()) ++unfinished;
    EXPECT_TRUE(curve.summary.converged()) << name << ": " << curve.summary.reason;
    for (const Warning& warning : curve.warnings) ADD_FAILURE() << name << ": " << warning.text;
    if (curve.points.empty()) continue;
    const double top = std::ranges::max(curve.points, {}, &SteadyVibration::response).response;
    double highest = std::max(curve.points.front().response, curve.points.back().response);
    ASSERT_EQ(curve.peaks.size(), curve.peak_points.size());
    for (std::size_t i = 0; i < curve.peaks.size(); ++i) {
      highest = std::max(highest, curve.peaks[i].response);
      EXPECT_EQ(curve.points[curve.peak_points[i]].response, curve.peaks[i].response) << name;
    }
    EXPECT_LE(top, highest * (1.0 + 1e-9)) << name << ": the highest point is no peak";
    const double deviation = polygon_deviation(it, curve);
    EXPECT_LE(deviation, 0.002) << name;
    EXPECT_LE(seconds, 5.0) << name;
    test::record_largest("deviation of the polygon [1]", deviation);
    test::record_largest("time of a curve [s]", seconds);
    test::record_largest("points of a curve [1]", static_cast<double>(curve.points.size()));
  }
  test::record_largest("curves that do not reach their end [1]", static_cast<double>(unfinished));
}

INSTANTIATE_TEST_SUITE_P(, RandomResponse,
                         ::testing::Values(Kind::kSmooth, Kind::kBeta, Kind::kAtoms),
                         [](const auto& it) {
                           return std::string(it.param == Kind::kSmooth ? "Smooth"
                                              : it.param == Kind::kBeta ? "Beta"
                                                                        : "Atoms");
                         });

// Draws beyond those few: a superharmonic resonance between points whose middle is on the chord;
// bumps at which shorter steps once left the wrong way.
TEST(FrequencyResponse, IsDrawnCloselyAtNarrowBumps) {
  struct Drawn {
    Kind kind;
    std::uint64_t seed;
  };
  for (const auto& [kind, seed] :
       {Drawn{Kind::kSmooth, 167}, Drawn{Kind::kBeta, 45}, Drawn{Kind::kAtoms, 39}}) {
    const Case it = random_case(kind, seed);
    const ResponseCurve curve = it.balance.frequency_response(it.force, it.from, it.to);
    EXPECT_TRUE(curve.summary.converged()) << seed << ": " << curve.summary.reason;
    for (const Warning& warning : curve.warnings) ADD_FAILURE() << seed << ": " << warning.text;
    EXPECT_LE(polygon_deviation(it, curve), 0.002) << seed;
  }
}

/// One mass on a weak spring and a joint of atoms that holds it.
JointedStructure held_mass(double frequency, double damping, double shape, double stiffness,
                           AtomsPart atoms) {
  constexpr double kTurn = 6.283185307179586;
  return JointedStructure(ModalModel({{kTurn * frequency, damping}}, {{"mass", {shape}}}),
                          {{"joint", Joint(stiffness, SlipDensity({std::move(atoms)})), {shape}}},
                          {{"mass"}});
}

constexpr double kHertz = 6.283185307179586;

// Sliders as others export them: 400 of them leave the curve of the density that they are drawn
// from, to 1/400² in the first harmonic, with hardly more points. Each of them a corner, it had
// 1021 points for 83, and of some thousand atoms no end.
TEST(FrequencyResponse, GoesPastManyAtoms) {
  const auto curve_of = [](DensityPart part) {
    const Joint joint(1e6, SlipDensity({std::move(part)}));
    const JointedStructure structure(ModalModel({{kHertz * 100.0, 0.002}}, {{"mass", {1.0}}}),
                                     {{"joint", joint, {1.0}}}, {{"mass"}});
    return HarmonicBalance(structure, {"mass"})
        .frequency_response(30.0, kHertz * 80.0, kHertz * 200.0);
  };
  constexpr std::size_t kCount = 400;
  AtomsPart atoms{std::vector<double>(kCount), std::vector<double>(kCount, 0.8 / kCount)};
  for (std::size_t i = 0; i < kCount; ++i) {
    atoms.slip_force[i] = 100.0 * (static_cast<double>(i) + 0.5) / kCount;
  }
  const ResponseCurve by_atoms = curve_of(std::move(atoms));
  const ResponseCurve by_density = curve_of(UniformPart{0.0, 100.0, 0.8});
  EXPECT_TRUE(by_atoms.summary.converged()) << by_atoms.summary.reason;
  EXPECT_EQ(by_atoms.warnings.size(), 0U);
  EXPECT_LE(by_atoms.points.size(), 5 * by_density.points.size() / 4);
  ASSERT_EQ(by_atoms.peaks.size(), 1U);
  EXPECT_NEAR(by_atoms.peaks[0].response, by_density.peaks[0].response,
              2e-5 * by_density.peaks[0].response);
}

// The joint slips first where the third harmonic is near resonance: there the frequency response
// has a corner of more than a right angle.
TEST(FrequencyResponse, GoesOnBehindASharpCorner) {
  const HarmonicBalance balance(held_mass(1.6, 0.002, 1.0, 7500.0, {{30.0}, {0.8}}), {"mass"},
                                {.harmonics = 7});
  const ResponseCurve curve = balance.frequency_response(30.0, kHertz * 3.0, kHertz * 18.0);
  EXPECT_TRUE(curve.summary.converged()) << curve.summary.reason;
  EXPECT_EQ(curve.warnings.size(), 0U);
  EXPECT_NEAR(curve.points.back().angular_frequency, kHertz * 18.0, 1e-9);
  // No piece is gone over twice.
  for (std::size_t i = 2; i < curve.points.size(); ++i) {
    EXPECT_NE(curve.points[i].angular_frequency, curve.points[i - 2].angular_frequency);
  }
}

// With a geometric stiffness, though it is next to nothing, the determinant does not tell which way
// a curve goes. Where the first atom begins to slip it is turned round here: it ends there, and
// neither goes back all its way nor holds the points gone over again.
TEST(FrequencyResponse, EndsWhereItGoesBackOverItself) {
  const std::vector<double> shape{1.0, 0.1356};
  const SlipDensity density({AtomsPart{{0.65, 1.92, 4.8}, {0.591, 0.014, 0.04}}});
  const JointedStructure structure(
      ModalModel({{0.1924, 0.006917}, {3.106, 2.1722e-4}}, {{"a", shape}}),
      {{.name = "joint",
        .joint = Joint(2.352, density),
        .shape = shape,
        .shortening = {1e-12, 0.0, 0.0, 1e-12}}},
      {{"a"}});
  const HarmonicBalance balance(structure, {"a"}, {.harmonics = 9, .accuracy = 0.0});
  const ResponseCurve curve = balance.frequency_response(1.349, 0.43406, 2.429);
  EXPECT_FALSE(curve.summary.converged());
  EXPECT_NE(curve.summary.reason.find("goes back over itself"), std::string::npos)
      << curve.summary.reason;
  ASSERT_GE(curve.points.size(), 5U);
  // From the fold on at most the one step back that could still be another branch.
  const auto farthest =
      std::ranges::max_element(curve.points, {}, &SteadyVibration::angular_frequency);
  EXPECT_GT(farthest->angular_frequency, 0.6);
  EXPECT_GT(curve.points.back().angular_frequency, 0.9 * farthest->angular_frequency);
}

// Three atoms, hardly damped, many harmonics: corners close to each other.
TEST(FrequencyResponse, PassesCornersCloseToEachOther) {
  const HarmonicBalance balance(
      held_mass(33.0, 5e-4, 0.835, 94500.0, {{1.01, 2.6, 2.78}, {0.392, 0.579, 0.004}}), {"mass"},
      {.harmonics = 11});
  const ResponseCurve curve = balance.frequency_response(2.19, kHertz * 13.0, kHertz * 63.0);
  EXPECT_TRUE(curve.summary.converged()) << curve.summary.reason;
  EXPECT_EQ(curve.warnings.size(), 0U);
  EXPECT_LE(curve.turning_points.size(), 20U);
}

}  // namespace
}  // namespace microslip::random_responses_test
