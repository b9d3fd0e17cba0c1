// SPDX-License-Identifier: MIT
#include "microslip/identify/records/record_inversion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/interpolation.hpp"
#include "microslip/base/random.hpp"
#include "microslip/identify/methods/diagnostics.hpp"
#include "microslip/identify/methods/identification.hpp"
#include "microslip/identify/records/record_model.hpp"
#include "microslip/identify/records/record_start.hpp"
#include "support/densities.hpp"
#include "support/effort.hpp"
#include "support/figures.hpp"
#include "support/force_records.hpp"
#include "support/messages.hpp"

namespace microslip::record_inversion_test {
namespace {

using testing::error_of_density;
using testing::random_motion;
using testing::record_joint;
using testing::reference_record;
using testing::simulated_record;

const std::vector<std::string> kReferences = {"random", "earthquake", "sines"};

std::vector<RecordEvidence> references(PathStart start = PathStart::kVirgin) {
  std::vector<RecordEvidence> all;
  for (const std::string& name : kReferences) all.emplace_back(reference_record(name), start);
  return all;
}

/// What each of them tells alone, found once.
const std::vector<RecordInversionResult>& found_of_each() {
  static const std::vector<RecordInversionResult> found = [] {
    std::vector<RecordInversionResult> all;
    for (const RecordEvidence& evidence : references()) {
      all.push_back(invert_records({&evidence, 1}));
    }
    return all;
  }();
  return found;
}

double largest_force(const Joint& joint, const std::vector<double>& path) {
  double largest = 0.0;
  for (const double force : testing::forces_on(joint, path)) {
    largest = std::max(largest, std::abs(force));
  }
  return largest;
}

double reach_of(const RecordInversionResult& result) {
  return result.stiffness.value * result.slip_displacement.back();
}

/// Share of 5 to 90 % of the range at which the band of φ contains the truth.
double coverage(const RecordInversionResult& result, const Joint& truth) {
  const DensityBand band = result.density_band();
  std::vector<double> slip_force = result.slip_displacement;
  for (double& f : slip_force) f *= result.stiffness.value;
  int covered = 0;
  constexpr int kPoints = 200;
  for (int i = 0; i <= kPoints; ++i) {
    const double f = reach_of(result) * (0.05 + 0.85 * i / kPoints);
    const double expected = truth.density().density(f);
    const bool inside = expected >= interpolate(slip_force, band.lower, f) &&
                        expected <= interpolate(slip_force, band.upper, f);
    covered += inside ? 1 : 0;
  }
  return static_cast<double>(covered) / (kPoints + 1);
}

/// The codes of the detected departures, between blanks.
std::string broken(const RecordInversionResult& found) {
  std::string codes;
  for (const RecordVerdict& verdict : found.records.front().verdicts) {
    if (!verdict.broken) continue;
    codes += (codes.empty() ? "" : " ") + std::string(to_string(verdict.departure));
  }
  return codes;
}

void expect_within(const Estimate& estimate) {
  ASSERT_LE(estimate.lower, estimate.value);
  ASSERT_GE(estimate.upper, estimate.value);
}

void expect_sound(const RecordInversionResult& result) {
  EXPECT_TRUE(result.summary.converged()) << result.summary.full();
  ASSERT_EQ(result.density.size(), result.slip_displacement.size());
  for (const StiffnessDraw& draw : result.draws) {
    ASSERT_GE(std::ranges::min(draw.density), -1e-9 * std::ranges::max(draw.density));
    const double slipping = integral(result.slip_displacement, draw.density);
    ASSERT_LE(slipping, draw.stiffness * (1.0 + 1e-9));
  }
  expect_within(result.stiffness);
  expect_within(result.elastic_stiffness);
  const DensityBand band = result.density_band();
  const double k = result.stiffness.value;
  for (std::size_t j = 0; j < result.density.size(); ++j) {
    ASSERT_LE(result.lower[j], result.density[j]);
    ASSERT_GE(result.upper[j], result.density[j]);
    ASSERT_LE(band.lower[j], result.density[j] / (k * k));
    ASSERT_GE(band.upper[j], result.density[j] / (k * k));
  }
}

// The bounds are those of a certification: density to 6 %, k to 1 %.
TEST(RecordInversion, FindsTheJointOfEachIndependentRecord) {
  const Joint truth = record_joint();
  for (const RecordInversionResult& found : found_of_each()) {
    expect_sound(found);
    const double error = error_of_density(found.joint(), truth, reach_of(found));
    EXPECT_LE(error, 0.06);
    test::record_largest("density [1]", error);
    EXPECT_NEAR(found.stiffness.value / truth.stiffness(), 1.0, 0.01);
    test::record_deviation("stiffness", found.stiffness.value, truth.stiffness());
    EXPECT_LT(found.stiffness.lower, truth.stiffness());
    EXPECT_GT(found.stiffness.upper, truth.stiffness());
    EXPECT_GE(coverage(found, truth), 0.9);
    // The noise of a sample, by the program that made the records: 4e-3 of the largest force.
    EXPECT_NEAR(found.records.front().offset.front(), 0.42, 0.1);
  }
}

/// Errors of k of one path with noise anew, for each smoothing of a grid where the scatter is
/// known.
struct KnownSmoothing {
  std::vector<double> lambda;
  std::vector<double> square;  ///< Σ of squared relative errors, one per λ

  void add(const RecordEvidence& evidence, const Joint& truth, double scatter) {
    const ScaledRecords records({.records = {&evidence, 1}}, {},
                                RecordInversionOptions{}.coefficients);
    RecordPass pass;
    pass.scatter = {scatter / (records.stiffness * records.length)};
    pass.correlation = {0.0};
    const RecordModel model(records, pass);
    if (lambda.empty()) {
      lambda = model.problem().lambda_grid(25);
      square.assign(lambda.size(), 0.0);
    }
    const Eigen::VectorXd k = records.stiffness * (model.area_row() + model.elastic_row());
    const std::vector<SmoothingPoint> path = model.problem().path(lambda);
    for (std::size_t i = 0; i < path.size(); ++i) {
      square[i] += std::pow(k.dot(path[i].solution.x) / truth.stiffness() - 1.0, 2);
    }
  }
};

// The noise of a record moves k whatever the method. Here it is compared with the best uniform
// smoothing of a path: chosen by the truth, the scatter known. Over 60 records, random, earthquake
// and sines, the rms were 0.47, 0.37 and 0.52 %, with that smoothing 0.38, 0.34 and 0.51 %, and
// with the mean of the draws, the former estimate, 0.69, 0.69 and 0.88 %. Of 20 records a rms is
// known to 1/√40 of it: 1.3 is within two of these of all, and 1.5 is beyond.
TEST(RecordInversion, FindsKAsWellAsTheBestSmoothing) {
  MICROSLIP_STUDY();
  const Joint truth = record_joint();
  constexpr int kRecords = 20;
  constexpr double kForceNoise = 4e-3;  // of the largest, as in the reference records
  for (const RecordEvidence& reference : references()) {
    const std::vector<double>& path = reference.path().displacement;
    const double scatter = kForceNoise * largest_force(truth, path);
    double square = 0.0;
    KnownSmoothing known;
    for (std::uint64_t i = 0; i < kRecords; ++i) {
      const RecordEvidence evidence(simulated_record(truth, path, 500 + i, {.force = kForceNoise},
                                                     reference.measured().time_step),
                                    PathStart::kVirgin);
      const RecordInversionResult found = invert_records({&evidence, 1}, {}, {.draws = 100});
      square += std::pow(found.stiffness.value / truth.stiffness() - 1.0, 2);
      known.add(evidence, truth, scatter);
    }
    const double rms = std::sqrt(square / kRecords);
    const double best = std::sqrt(std::ranges::min(known.square) / kRecords);
    EXPECT_LE(rms, 1.3 * best);
    test::record_largest("k [1]", rms);
    test::record_largest("k of the best smoothing [1]", best);
  }
}

TEST(RecordInversion, TakesRecordsTogether) {
  const Joint truth = record_joint();
  const std::vector<RecordEvidence> all = references();
  const RecordInversionResult found = invert_records(all);
  expect_sound(found);
  const double error = error_of_density(found.joint(), truth, reach_of(found));
  EXPECT_LE(error, 0.04);
  test::record_largest("density [1]", error);
  EXPECT_NEAR(found.stiffness.value / truth.stiffness(), 1.0, 0.005);
  test::record_deviation("stiffness", found.stiffness.value, truth.stiffness());
  EXPECT_EQ(found.records.size(), 3U);
}

TEST(RecordInversion, FindsTheJointFromAnUnknownState) {
  const Joint truth = record_joint();
  for (const std::string& name : kReferences) {
    if (name != "random" && !test::in_studies()) continue;
    ForceRecord later = reference_record(name);
    const auto cut = static_cast<std::ptrdiff_t>(later.size() / 4);
    later.displacement.erase(later.displacement.begin(), later.displacement.begin() + cut);
    later.force.erase(later.force.begin(), later.force.begin() + cut);
    const RecordEvidence evidence(later, PathStart::kUnknown);
    const RecordInversionResult found = invert_records({&evidence, 1});
    EXPECT_LE(error_of_density(found.joint(), truth, reach_of(found)), 0.08) << name;
    EXPECT_NEAR(found.stiffness.value / truth.stiffness(), 1.0, 0.015) << name;
  }
}

TEST(RecordInversion, SeesWhetherAJointHadSlipped) {
  for (const std::string& name : kReferences) {
    ForceRecord record = reference_record(name);
    const RecordStart whole = shown_start(RecordEvidence(record, PathStart::kVirgin));
    EXPECT_EQ(whole.start, PathStart::kVirgin) << name << ' ' << whole.early_misfit;
    EXPECT_TRUE(whole.shown);
    const auto cut = static_cast<std::ptrdiff_t>(record.size() / 2);
    record.displacement.erase(record.displacement.begin(), record.displacement.begin() + cut);
    record.force.erase(record.force.begin(), record.force.begin() + cut);
    const RecordStart later = shown_start(RecordEvidence(record, PathStart::kVirgin));
    EXPECT_EQ(later.start, PathStart::kUnknown) << name << ' ' << later.early_misfit;
  }
}

// A thousand samples in one row, or more, determine its force far more accurately than the path is
// known.
TEST(RecordInversion, TakesAJointThatRestedForVirgin) {
  std::vector<double> path(4000, 0.0);
  const std::vector<double> motion = random_motion(16000, testing::kLargestAmplitude, 13, 3);
  path.insert(path.end(), motion.begin(), motion.end());
  const ForceRecord record =
      simulated_record(testing::decaying_power_law(), path, 14, {.force = 2e-3});
  const RecordStart start = shown_start(RecordEvidence(record, PathStart::kVirgin));
  EXPECT_EQ(start.start, PathStart::kVirgin) << start.early_misfit;
  EXPECT_TRUE(start.shown);
}

/// rms of the residual force of a record with a joint beyond an offset, N.
double missed(const Joint& joint, const RecordEvidence& record) {
  const std::vector<double> predicted = testing::forces_on(joint, record.path().displacement);
  std::vector<double> left = record.measured().force;
  double mean = 0.0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    left[i] -= predicted[i];
    mean += left[i] / static_cast<double>(left.size());
  }
  double sum = 0.0;
  for (const double value : left) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(left.size()));
}

// The residual of the true joint on the same smoothed path is the noise of the force and the
// remaining noise of the path.
TEST(RecordInversion, PredictsOneRecordFromAnother) {
  const Joint truth = record_joint();
  const std::vector<RecordEvidence> all = references();
  for (const RecordInversionResult& result : found_of_each()) {
    const Joint found = result.joint();
    for (const RecordEvidence& to : all) {
      const double over_noise = missed(found, to) / missed(truth, to);
      EXPECT_LE(over_noise, 1.3);
      test::record_largest("missed over noise [1]", over_noise);
    }
  }
}

// Remaining errors and their causes are in docs/theory.md 4.4: densities that end abruptly, and
// steep poles. Every third of the joints, but in the studies.
TEST(RecordInversion, FindsOtherJoints) {
  const std::vector<testing::NamedJoint> truths = testing::all_truths();
  for (std::size_t i = 0; i < truths.size(); i += test::in_studies() ? 1U : 3U) {
    const auto& [name, joint] = truths[i];
    const std::vector<double> path = random_motion(8000, testing::kLargestAmplitude, 5);
    const RecordEvidence evidence(simulated_record(joint, path, 6), PathStart::kVirgin);
    const RecordInversionResult found = invert_records({&evidence, 1});
    expect_sound(found);
    EXPECT_LE(error_of_density(found.joint(), joint, reach_of(found)), 0.08) << name;
    EXPECT_NEAR(found.stiffness.value / joint.stiffness(), 1.0, 0.025) << name;
    EXPECT_EQ(broken(found), "") << name;
  }
}

/// Sines of amplitudes that rise to the largest.
std::vector<double> rising_sines(std::size_t count, double largest, double cycles) {
  std::vector<double> path(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count);
    path[i] = largest * share * std::sin(2.0 * std::numbers::pi * cycles * share);
  }
  return path;
}

// Twelve densities, four records each: 95 % bands should contain ψ at 0.90 to 0.98 of the range, k
// and K_e in 0.90 to 0.99 of the records. 0.94 of the range, 41 and 42 of 48 were found when this
// was written. With draws of the truncated posterior it was two thirds of 78 such records: where in
// truth nothing slips at one end of the range, something did in each of them. Not among these: a
// pole with narrow populations on it, of which k is too low (docs/theory.md 4.4).
TEST(RecordInversion, BandsHoldTheTruthAsOftenAsTheySay) {
  MICROSLIP_STUDY();
  std::vector<testing::NamedJoint> truths = testing::all_truths();
  for (testing::NamedJoint& one : testing::unseen_truths()) truths.push_back(std::move(one));
  std::erase_if(truths, [](const auto& one) { return one.name == "power_law_and_three_bumps"; });
  truths.push_back({"record_joint", record_joint()});
  constexpr std::uint64_t kRecords = 48;
  double of_density = 0.0;
  int of_k = 0;
  int of_elastic = 0;
  for (std::uint64_t i = 0; i < kRecords; ++i) {
    RandomStream random(43, i);
    const double noise = std::pow(10.0, -3.0 + 1.477 * random.uniform());  // 0.1 to 3 %
    const Joint& truth = truths[i % truths.size()].joint;
    const bool sines = i / truths.size() % 2 == 1;
    const std::vector<double> path =
        sines ? rising_sines(4000, testing::kLargestAmplitude, 10.0 + 10.0 * random.uniform())
              : random_motion(4000, testing::kLargestAmplitude, 3000 + i);
    const testing::RecordNoise of{.displacement = 0.03 * noise, .force = noise};
    const RecordEvidence evidence(simulated_record(truth, path, 4000 + i, of), PathStart::kVirgin);
    const RecordInversionResult found = invert_records({&evidence, 1}, {}, {.draws = 200});
    const auto covered = [](const Estimate& band, double value) {
      return band.lower <= value && value <= band.upper;
    };
    of_density += coverage(found, truth) / kRecords;
    of_k += covered(found.stiffness, truth.stiffness()) ? 1 : 0;
    const double elastic = truth.tangent_stiffness(found.slip_displacement.back());
    of_elastic += covered(found.elastic_stiffness, elastic) ? 1 : 0;
  }
  EXPECT_GE(of_density, 0.90);
  EXPECT_LE(of_density, 0.98);
  test::record_smallest("covered by the band [1]", of_density);
  EXPECT_GE(of_k, 40);
  EXPECT_GE(of_elastic, 40);
}

TEST(RecordVerdicts, NameTheAssumptionThatIsBroken) {
  for (const auto& [name, code] :
       std::vector<std::pair<std::string, std::string>>{{"not_masing_asymmetric", "asymmetric"},
                                                        {"not_masing_backlash", "dead_zone"},
                                                        {"not_masing_viscous", "rate_dependent"},
                                                        {"not_masing_wear", "drifts"},
                                                        {"random", ""},
                                                        {"earthquake", ""},
                                                        {"sines", ""}}) {
    const RecordEvidence evidence(reference_record(name), PathStart::kVirgin);
    EXPECT_EQ(broken(invert_records({&evidence, 1}, {}, {.draws = 100})), code) << name;
  }
}

// A file in mm that is taken for µm, a force sensor of another gain, and the same joint.
TEST(RecordVerdicts, TellRecordsThatContradict) {
  const auto of_two = [](double length, double force) {
    ForceRecord other = reference_record("sines");
    for (double& value : other.displacement) value *= length;
    for (double& value : other.force) value *= force;
    const std::vector<RecordEvidence> both{{reference_record("random"), PathStart::kVirgin},
                                           {other, PathStart::kVirgin}};
    return invert_records(both, {}, {.draws = 100});
  };
  for (const auto& [length, force] :
       std::vector<std::pair<double, double>>{{1e3, 1.0}, {1.0, 1e3}, {1.0, 1.2}}) {
    EXPECT_EQ(broken(of_two(length, force)), "records_contradict") << length << ' ' << force;
  }
  const RecordInversionResult same = of_two(1.0, 1.0);
  EXPECT_EQ(broken(same), "");
  EXPECT_EQ(same.records.front().verdicts.size(), kRecordDepartures.size());
}

// A spring of 1e5 N/m, its force to 0.1 %: there is no friction to be found.
TEST(RecordVerdicts, SayThatNothingSlips) {
  ForceRecord record = reference_record("sines");
  RandomStream random(8, 0);
  const double largest = std::ranges::max(record.displacement);
  for (std::size_t i = 0; i < record.force.size(); ++i) {
    record.force[i] = 1e5 * (record.displacement[i] + 1e-3 * largest * random.normal());
  }
  const std::vector<RecordEvidence> spring{{record, PathStart::kVirgin}};
  const std::vector<Warning> warnings =
      diagnose(invert_records(spring, {}, {.draws = 200}), {.records = spring});
  EXPECT_TRUE(std::ranges::any_of(
      warnings, [](const Warning& warning) { return warning.code == "no_slip"; }));
  const std::vector<RecordEvidence> joint{{reference_record("sines"), PathStart::kVirgin}};
  EXPECT_TRUE(diagnose(invert_records(joint, {}, {.draws = 200}), {.records = joint}).empty());
}

TEST(RecordVerdicts, AreNoneWhereTheViscousPartIsSought) {
  const RecordEvidence evidence(reference_record("not_masing_viscous"), PathStart::kVirgin);
  EXPECT_EQ(broken(invert_records({&evidence, 1}, {}, {.viscous = true, .draws = 100})), "");
}

/// Cycles of a sine whose force is given by displacement and velocity over ω, both over A.
template <typename Force>
RecordEvidence steady_record(const Force& force, double centre) {
  constexpr double kAmplitude = 0.0185;  // m
  RandomStream random(5, 0);
  ForceRecord record;
  record.time_step = 1.0 / 300.0;
  for (int i = 0; i < 1500; ++i) {
    const double phase = 2.0 * std::numbers::pi * 1.053 * i * record.time_step;
    record.displacement.push_back(centre + kAmplitude * std::cos(phase) + 1e-8 * random.normal());
    record.force.push_back(force(std::cos(phase), -std::sin(phase)) + 0.3 * random.normal());
  }
  return {std::move(record), PathStart::kUnknown};
}

// A hydraulic damper of 280 N at the peak of its velocity, beside a spring: steady cycles do not
// drift, and nothing is missing about zero. It was said to drift by a third of its force.
TEST(RecordVerdicts, NameTheVelocityOfASteadyDamper) {
  const auto damper = [](double u, double v) {
    return 280.0 * v + 64.0 * u + 88.0 * std::tanh(v / 0.0245) - 50.0;
  };
  const RecordEvidence evidence = steady_record(damper, 0.031);
  EXPECT_EQ(broken(invert_records({&evidence, 1}, {}, {.draws = 100})), "rate_dependent");
}

// The joint of a record that no joint explains is the nearest in force. A spring and forty sliders
// by non-negative least squares leave 0.232 of this one; the bound is half as much again.
TEST(RecordInversion, IsNearestInForceWhereNoJointFits) {
  const auto damper = [](double u, double v) {
    return 280.0 * v + 64.0 * u + 88.0 * std::tanh(v / 0.0245) - 50.0;
  };
  const RecordEvidence evidence = steady_record(damper, 0.031);
  const RecordInversionResult found = invert_records({&evidence, 1}, {}, {.draws = 100});
  EXPECT_LE(found.records.front().unexplained, 0.35);
}

/// Triangles of 400 samples of a joint of 300 sliders, moved one by one: slip displacements even up
/// to 0.8 of the amplitude, 80 % of k. Noise of 0.1 % of the amplitude, and of 0.05 % of the force.
/// @param first  error of the first displacement, in deviations.
ForceRecord triangles(double first, std::uint64_t seed) {
  constexpr std::size_t kSliders = 300;
  constexpr double kAmplitude = 5e-6;  // m
  constexpr double kStiffness = 1e7;   // N/m
  std::vector<double> stretch(kSliders, 0.0);
  RandomStream random(seed, 23);
  ForceRecord record;
  record.time_step = 1e-2;
  double before = 0.0;
  for (int i = 0; i <= 1200; ++i) {
    const double phase = std::fmod(i / 400.0 + 0.25, 1.0);
    const double u = kAmplitude * (1.0 - std::abs(4.0 * phase - 2.0));
    double force = 0.2 * kStiffness * u;
    for (std::size_t j = 0; j < kSliders; ++j) {
      const double limit = 0.8 * kAmplitude * (static_cast<double>(j) + 0.5) / kSliders;
      stretch[j] = std::clamp(stretch[j] + u - before, -limit, limit);
      force += 0.8 * kStiffness / kSliders * stretch[j];
    }
    before = u;
    const double error = i == 0 ? first : random.normal();
    record.displacement.push_back(u + 1e-3 * kAmplitude * error);
    record.force.push_back(force + 0.01 * random.normal());
  }
  return record;
}

// A virgin joint is without force at its first sample, of which the error is in all of the first
// branch: with one of four deviations 0.6 % of the force was said to be missing about zero.
TEST(RecordVerdicts, AreNoneWhereTheFirstSampleIsWrong) {
  for (const double first : {-4.0, 4.0}) {
    const RecordEvidence evidence(triangles(first, 1), PathStart::kVirgin);
    const RecordInversionResult found = invert_records({&evidence, 1}, {}, {.draws = 200});
    EXPECT_EQ(broken(found), "") << first;
    EXPECT_LE(found.stiffness.lower, 1e7) << first;
    EXPECT_GE(found.stiffness.upper, 1e7) << first;
  }
}

/// A slider, or some of evenly spread slip displacements of the same mean, in gross slip of a
/// stroke a hundred times as long; four sines of 600 samples.
ForceRecord gross_slip(std::size_t sliders, std::uint64_t seed) {
  constexpr double kStiffness = 5e7;      // N/m
  constexpr double kSlip = 0.228e-6;      // m
  constexpr double kAmplitude = 24.5e-6;  // m
  std::vector<double> stretch(sliders, 0.0);
  RandomStream random(seed, 17);
  ForceRecord record;
  record.time_step = 1e-5;
  double before = 0.0;
  const auto n = static_cast<double>(sliders);
  for (int i = 0; i < 2400; ++i) {
    const double u = kAmplitude * std::sin(2.0 * std::numbers::pi * i / 600.0);
    double force = 0.0;
    for (std::size_t j = 0; j < sliders; ++j) {
      const double limit = 2.0 * kSlip * (static_cast<double>(j) + 0.5) / n;
      stretch[j] = std::clamp(stretch[j] + u - before, -limit, limit);
      force += kStiffness / n * stretch[j];
    }
    before = u;
    record.displacement.push_back(u + 1e-8 * random.normal());
    record.force.push_back(force + 0.1 * random.normal());
  }
  return record;
}

// The elastic part of a loop in gross slip is a hundredth of its stroke and has 18 samples a turn.
// What the prior says of it, and the noise of the path there, widens the band of k: with sliders
// moved one by one it contained k in none of 20 draws. One of 95 % may miss of few.
TEST(RecordInversion, BandOfKContainsItInGrossSlip) {
  const std::uint64_t draws = test::draws_of(20, 2);
  for (const std::size_t sliders : {1U, 60U}) {
    std::uint64_t contain = 0;
    for (std::uint64_t i = 0; i < draws; ++i) {
      const RecordEvidence evidence(gross_slip(sliders, i), PathStart::kVirgin);
      const Estimate k = invert_records({&evidence, 1}, {}, {.draws = 200}).stiffness;
      contain += k.lower <= 5e7 && 5e7 <= k.upper ? 1 : 0;
    }
    EXPECT_GE(contain + 1 + draws / 10, draws) << sliders;
  }
}

// 200 such records gave none when this was written; 2 % of them would be too many.
TEST(RecordVerdicts, AreNoneOfGoodRecords) {
  std::vector<testing::NamedJoint> truths = testing::all_truths();
  for (testing::NamedJoint& one : testing::unseen_truths()) truths.push_back(std::move(one));
  const std::uint64_t records = test::draws_of(60, 8);
  int wrong = 0;
  for (std::uint64_t i = 0; i < records; ++i) {
    RandomStream random(41, i);
    const double noise = std::pow(10.0, -3.0 + 1.477 * random.uniform());  // 0.1 to 3 %
    const std::vector<double> path = random_motion(6000, testing::kLargestAmplitude, 1000 + i);
    const testing::RecordNoise of{.displacement = 0.1 * noise, .force = noise};
    const RecordEvidence evidence(
        simulated_record(truths[i % truths.size()].joint, path, 2000 + i, of), PathStart::kVirgin);
    const std::string codes = broken(invert_records({&evidence, 1}, {}, {.draws = 100}));
    if (!codes.empty()) ++wrong;
  }
  EXPECT_LE(wrong, 1);
  test::record_largest_of_draws("false verdicts [1]",
                                static_cast<double>(wrong) / static_cast<double>(records));
}

// A joint whose record has ten samples for one, with the noise of each, is better known, but it is
// the same one: within the band of the coarser.
TEST(RecordInversion, OfMoreSamplesIsTheSame) {
  const Joint truth = testing::reference_joint();
  const auto found_of = [&](std::size_t finer) {
    const std::vector<double> path = random_motion(8000, testing::kLargestAmplitude, 9, finer);
    const RecordEvidence evidence(
        simulated_record(truth, path, 10, {}, 1e-3 / static_cast<double>(finer)),
        PathStart::kVirgin);
    EXPECT_LE(evidence.rows().rows.size(), 3 * RecordEvidence::kMostRows);
    return invert_records({&evidence, 1});
  };
  const RecordInversionResult coarse = found_of(1);
  const RecordInversionResult fine = found_of(10);
  EXPECT_NEAR(fine.stiffness.value / coarse.stiffness.value, 1.0, 0.01);
  EXPECT_LE(error_of_density(fine.joint(), truth, reach_of(fine)),
            error_of_density(coarse.joint(), truth, reach_of(coarse)) + 0.02);
}

// 3000 cycles whose amplitude comes and goes, of twelve single sliders: rows are some 25 µm long,
// as far as sliders are from each other. k was found to 0.6 %; with rows that took the density as
// smooth over their length it was 8 % too high.
TEST(RecordInversion, OfThousandsOfCyclesIsTheSame) {
  AtomsPart sliders;
  constexpr int kSliders = 12;
  for (int i = 1; i <= kSliders; ++i) {
    sliders.slip_force.push_back(0.9 * testing::kReach * std::pow(i / 12.0, 1.5));
    sliders.weight.push_back(0.9 / kSliders);
  }
  const Joint truth = testing::joint_of({sliders});
  constexpr std::size_t kSamples = 120'000;
  constexpr double kPerCycle = 40.0;
  std::vector<double> path(kSamples);
  for (std::size_t i = 0; i < kSamples; ++i) {
    const double cycle = static_cast<double>(i) / kPerCycle;
    const double amplitude = 0.2 + 0.8 * std::abs(std::sin(0.013 * cycle));
    path[i] = testing::kLargestAmplitude * amplitude * std::sin(2.0 * std::numbers::pi * cycle);
  }
  const ForceRecord record =
      simulated_record(truth, path, 8, {.displacement = 1e-4, .force = 2e-3});
  const RecordEvidence evidence(record, PathStart::kVirgin);
  const RecordInversionResult found = invert_records({&evidence, 1}, {}, {.draws = 200});
  EXPECT_NEAR(found.stiffness.value / truth.stiffness(), 1.0, 0.02);
  EXPECT_EQ(broken(found), "");
}

TEST(RecordInversion, FindsAViscousPart) {
  const Joint truth = testing::reference_joint();
  constexpr double kViscous = 40.0;  // N s/m
  const std::vector<double> path = random_motion(8000, testing::kLargestAmplitude, 11);
  ForceRecord record = simulated_record(truth, path, 12);
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    record.force[i] += kViscous * (path[i + 1] - path[i - 1]) / (2.0 * record.time_step);
  }
  const RecordEvidence evidence(record, PathStart::kVirgin);
  const RecordInversionResult found = invert_records({&evidence, 1}, {}, {.viscous = true});
  ASSERT_TRUE(found.viscous);
  EXPECT_NEAR(found.viscous->value, kViscous, 0.05 * kViscous);
  EXPECT_LT(found.viscous->lower, kViscous);
  EXPECT_GT(found.viscous->upper, kViscous);
}

TEST(RecordInversion, UsesAStiffnessThatIsKnown) {
  const Joint truth = record_joint();
  const RecordEvidence evidence(reference_record("random"), PathStart::kVirgin);
  const RecordInversionResult found = invert_records({&evidence, 1}, truth.stiffness());
  expect_sound(found);
  EXPECT_TRUE(found.stiffness_known);
  EXPECT_EQ(found.stiffness.lower, truth.stiffness());
  EXPECT_LE(error_of_density(found.joint(), truth, reach_of(found)), 0.06);
}

TEST(RecordInversion, RepeatsWithItsSeed) {
  MICROSLIP_OF_RELEASE_ALONE();
  const RecordEvidence evidence(reference_record("sines"), PathStart::kVirgin);
  const auto found = [&](std::uint64_t seed) {
    return invert_records({&evidence, 1}, {}, {.draws = 100, .seed = seed});
  };
  EXPECT_EQ(found(3).upper, found(3).upper);
  EXPECT_NE(found(3).upper, found(4).upper);
  EXPECT_EQ(found(3).density, found(4).density);
}

TEST(RecordInversion, RefusesWhatTellsNothing) {
  const auto refused = [](const ForceRecord& record, const RecordInversionOptions& options = {}) {
    return test::message_or("taken", [&] {
      const RecordEvidence evidence(record, PathStart::kVirgin);
      return invert_records({&evidence, 1}, {}, options);
    });
  };
  test::expect_message(test::message_or("taken", [] { return invert_records({}); }),
                       "number of records");

  ForceRecord ramp = reference_record("random");
  for (std::size_t i = 0; i < ramp.size(); ++i) {
    ramp.displacement[i] = 1e-9 * static_cast<double>(i);
  }
  test::expect_message(refused(ramp), "reversals");

  ForceRecord opposite = reference_record("random");
  for (double& value : opposite.force) value = -value;
  test::expect_message(refused(opposite), "sign of one channel");
  ForceRecord exchanged = reference_record("random");
  std::swap(exchanged.force, exchanged.displacement);
  test::expect_message(refused(exchanged), "may be swapped");

  ForceRecord timeless = reference_record("random");
  timeless.time_step = 0.0;
  test::expect_message(refused(timeless, {.viscous = true}), "time step");
  test::expect_message(refused(reference_record("random"), {.draws = 10}), "draws");
  test::expect_message(refused(reference_record("random"), {.coefficients = 2}), "coefficients");
}

}  // namespace
}  // namespace microslip::record_inversion_test
