// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include "microslip/base/random.hpp"

namespace microslip {
namespace {

/// Of the noise of readings, apart from those of structures and joints, which are lower.
constexpr std::uint64_t kNoiseStreams = std::uint64_t{0x100} << 48U;
/// Of what an estimate of it may be off by.
constexpr std::uint64_t kNoiseScaleStreams = std::uint64_t{0x101} << 48U;

/// Calls work(curve, i, n) for each value, n its number in the test.
template <typename Curves, typename Work>
void for_each_value(Curves& curves, const Work& work) {
  std::size_t n = 0;
  for (auto& curve : curves) {
    for (std::size_t i = 0; i < curve.size(); ++i) work(curve, i, n++);
  }
}

double noise_at(const ComparedCurve& curve, std::size_t i) {
  if (curve.measured_std.empty() || !std::isfinite(curve.measured_std[i])) return 0.0;
  return curve.measured_std[i];
}

/// Possible standard deviations over an estimate of ν degrees of freedom, √(ν/χ²_ν).
double noise_scale(std::size_t freedom, RandomStream& random) {
  if (freedom == 0) return 1.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < freedom; ++i) squares += std::pow(random.normal(), 2);
  return std::sqrt(static_cast<double>(freedom) / squares);
}

/// Values of a draw as they would be measured.
std::vector<double> with_noise(std::vector<double> values, const ComparedTest& test,
                               std::uint64_t seed, std::size_t draw) {
  RandomStream random(seed, kNoiseStreams + draw);
  RandomStream of_scale(seed, kNoiseScaleStreams + draw);
  double scale = 1.0;  // of the curve
  for_each_value(test.curves, [&](const ComparedCurve& curve, std::size_t i, std::size_t n) {
    if (i == 0) scale = noise_scale(curve.std_freedom, of_scale);
    const double z = random.normal();  // used up also where there is no noise
    values[n] += scale * noise_at(curve, i) * z;
  });
  return values;
}

/// How many values of a curve lie in its band, those that compare alone.
std::size_t inside_of(const ComparedCurve& curve, const std::vector<double>& values,
                      std::size_t first) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double value = values[first + i];
    if (curve.compares(i) && value >= curve.lower[i] && value <= curve.upper[i]) ++count;
  }
  return count;
}

/// @param draws  values of each; empty where it failed.
double chance_of(const ComparedCurve& curve, const std::vector<std::vector<double>>& draws,
                 std::size_t first) {
  const std::size_t inside = curve.inside();
  std::size_t taken = 0;
  std::size_t as_few = 0;
  for (const std::vector<double>& values : draws) {
    if (values.empty()) continue;
    ++taken;
    if (inside_of(curve, values, first) <= inside) ++as_few;
  }
  return static_cast<double>(as_few) / static_cast<double>(taken);
}

std::string name_of(const ComparedCurve& curve) {
  std::string name = curve.quantity;
  std::ranges::replace(name, '_', ' ');
  return curve.part == TestPart::kPeak ? name + " at the peak" : name;
}

void add_few_draws(const DrawsTaken& taken, std::vector<Warning>& warnings) {
  const double beyond = 0.5 * (1.0 - taken.options.confidence) *
                        static_cast<double>(taken.options.count - taken.failed());
  if (beyond >= kFewBeyond) return;
  warnings.push_back(
      {"draws_few",
       fmt::format("only {:.2g} draws lie beyond each edge of the bands, so that the edges are "
                   "inaccurate: use {:.0f} draws or more.",
                   beyond, std::ceil(2.0 * kFewBeyond / (1.0 - taken.options.confidence)))});
}

/// Where all values err together as few as 1 − P of the draws are all outside, but for the two
/// draws that the edges are drawn between.
void add_few_inside(ComparedTest& test) {
  const double confidence = test.taken->options.confidence;
  const double taken = static_cast<double>(test.taken->options.count - test.taken->failed());
  for (ComparedCurve& curve : test.curves) {
    if (curve.compared() < 2 || curve.chance > 1.0 - confidence + 2.0 / taken) continue;
    curve.few_inside = true;
    test.warnings.push_back(
        {"few_inside",
         fmt::format(
             "{} of {} values of {} lie inside the band, {:.1f} are expected; p-value {:.2g} %. "
             "The uncertainty does not cover the test: check the model, its spread and the test.",
             curve.inside(), curve.compared(), name_of(curve),
             confidence * static_cast<double>(curve.compared()), 100.0 * curve.chance)});
  }
}

void take_bands(const TestPredictor& predictor, const TestDraws& draws, ComparedTest& test) {
  const DrawOptions& options = draws.options;
  options.check();
  options.check_size(test.size(), "Compare fewer tests, or shorter ones, at once.");
  std::vector<std::vector<double>> values(options.count);
  const auto take = [&](std::size_t i) {
    TestPrediction drawn = predictor.draw(i);
    if (drawn.failure.empty()) {
      values[i] = with_noise(std::move(drawn.values), test, options.seed, i);
    }
    return drawn.failure;
  };
  test.taken = take_draws(options, take, draws.execution, draws.progress);
  const Band band = band_of(values, options.confidence);
  std::size_t first = 0;
  for (ComparedCurve& curve : test.curves) {
    const auto part = [&](const std::vector<double>& all) {
      const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
      return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(curve.size()));
    };
    curve.lower = part(band.lower);
    curve.upper = part(band.upper);
    curve.chance = chance_of(curve, values, first);
    first += curve.size();
  }
  std::ranges::move(draw_warnings(*test.taken), std::back_inserter(test.warnings));
  add_few_draws(*test.taken, test.warnings);
  add_few_inside(test);
}

}  // namespace

std::string_view to_string(TestKind kind) {
  switch (kind) {
    case TestKind::kSweep:
      return "sweep";
    case TestKind::kConstantResponse:
      return "constant-response";
    case TestKind::kRingDown:
      return "ringdown";
    case TestKind::kModalLevels:
      return "modal-levels";
    case TestKind::kLoops:
      break;
  }
  return "loops";
}

bool is_of_sweeps(TestKind kind) {
  return kind == TestKind::kSweep || kind == TestKind::kConstantResponse;
}

std::string_view to_string(TestPart part) {
  switch (part) {
    case TestPart::kCurve:
      return "curve";
    case TestPart::kPeak:
      return "peak";
    case TestPart::kRecord:
      break;
  }
  return "record";
}

std::string verdict_of(const ComparedCurve& curve, std::size_t i) {
  if (!std::isfinite(curve.measured[i])) return "";
  if (!curve.compares(i)) return "not_found";
  if (!curve.has_band()) return "";
  return curve.inside(i) ? "inside" : "outside";
}

bool ComparedCurve::compares(std::size_t i) const {
  return std::isfinite(measured.at(i)) && std::isfinite(predicted.at(i));
}

bool ComparedCurve::inside(std::size_t i) const {
  return measured.at(i) >= lower.at(i) && measured.at(i) <= upper.at(i);
}

std::size_t ComparedCurve::compared() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < size(); ++i) count += compares(i) ? 1 : 0;
  return count;
}

std::size_t ComparedCurve::inside() const {
  std::size_t count = 0;
  for (std::size_t i = 0; has_band() && i < size(); ++i) {
    count += compares(i) && inside(i) ? 1 : 0;
  }
  return count;
}

double ComparedCurve::deviation() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    if (!compares(i)) continue;
    const double miss =
        dimension == kAngle ? predicted[i] - measured[i] : predicted[i] / measured[i] - 1.0;
    sum += miss * miss;
  }
  return std::sqrt(sum / static_cast<double>(compared()));
}

double ComparedCurve::normalised_deviation() const {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    const double noise = noise_at(*this, i);
    if (!compares(i) || noise <= 0.0) continue;
    sum += std::pow((measured[i] - predicted[i]) / noise, 2);
    count += 1.0;
  }
  return std::sqrt(sum / count);
}

bool ComparedTest::converged() const {
  return failure.empty() && !(taken && taken->too_many_failed());
}

std::size_t ComparedTest::size() const {
  std::size_t count = 0;
  for (const ComparedCurve& curve : curves) count += curve.size();
  return count;
}

void compare(const TestPredictor& predictor, const std::optional<TestDraws>& draws,
             ComparedTest& test) {
  for (ComparedCurve& curve : test.curves) curve.predicted.resize(curve.size());
  for_each_value(test.curves, [&](ComparedCurve& curve, std::size_t i, std::size_t n) {
    curve.predicted[i] = predictor.nominal.values.at(n);
  });
  test.failure = predictor.nominal.failure;
  if (!test.failure.empty()) {
    test.warnings.push_back({"not_converged", test.failure});
    return;  // draws about a curve that is not whole would be no band of it
  }
  if (draws && predictor.draw) take_bands(predictor, *draws, test);
}

}  // namespace microslip
