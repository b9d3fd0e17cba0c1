// SPDX-License-Identifier: MIT
#include "microslip/identify/assemblies/assemblies_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "microslip/base/interpolation.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/identify/posterior/effective_draws.hpp"
#include "microslip/identify/posterior/quantiles.hpp"
#include "microslip/identify/posterior/spread_prior.hpp"
#include "microslip/identify/smoothing/eigen_view.hpp"

namespace microslip {
namespace {

/// Streams of the deviations of the next assemblies come after those of the chains.
constexpr std::uint64_t kNextStreams = std::uint64_t{1} << 33U;
/// Points of a density between two knots, so that little is lost where scales move knots.
constexpr std::size_t kPointsOfKnot = 2;
/// Fewer independent draws than this determine interval bounds only roughly.
constexpr double kFewestEffective = 100.0;
/// Fewer assemblies than this determine a spread to a factor of two or worse.
constexpr std::size_t kFewAssemblies = 6;

/// Densities of draws as numbers on one axis of slip forces.
class DensityReader {
 public:
  DensityReader(const AssemblyModel& model, double unit, std::vector<double> slip_force)
      : knots_{0.0}, unit_(unit), slip_force_(std::move(slip_force)) {
    for (const double s : model.knots()) knots_.push_back(unit * s);
  }

  [[nodiscard]] const std::vector<double>& slip_force() const { return slip_force_; }

  /// φ(f) = p(f/(S F))/(S F), 1/N, 0 above the last knot; area ≤ 1.
  [[nodiscard]] std::vector<double> read(const Eigen::VectorXd& p, double scale) const {
    std::vector<double> values{p(0)};
    values.insert(values.end(), p.begin(), p.end());
    std::vector<double> density;
    for (const double f : slip_force_) {
      const double at = f / scale;
      const bool beyond = at > knots_.back() * (1.0 + 1e-12);
      density.push_back(beyond ? 0.0 : interpolate(knots_, values, at) / (scale * unit_));
    }
    const double area = integral(slip_force_, density);
    if (area > 1.0) {
      for (double& value : density) value /= area;
    }
    return density;
  }

 private:
  std::vector<double> knots_;
  double unit_;
  std::vector<double> slip_force_;
};

/// Slip forces from 0 to `top`, spaced as the knots.
std::vector<double> axis_of(const AssemblyModel& model, double top) {
  std::vector<double> axis{0.0};
  double before = 0.0;
  for (const double s : model.knots()) {
    for (std::size_t i = 1; i <= kPointsOfKnot; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(kPointsOfKnot);
      axis.push_back(top * (before + share * (s - before)));
    }
    before = s;
  }
  axis.back() = top;
  return axis;
}

Spread spread_of(std::vector<double> values, double confidence) {
  const auto [lower, upper] = quantile_pair(values, confidence);
  return {quantile(values, 0.5), lower, upper};
}

Estimate estimate_of_assembly(std::vector<double> values, double confidence) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  const auto [lower, upper] = quantile_pair(values, confidence);
  return {mean, lower, upper};
}

/// The band of the densities of all draws, on one axis.
BandedDensity band_of(const std::vector<std::vector<double>>& densities, double confidence,
                      bool median) {
  BandedDensity band;
  std::vector<double> values(densities.size());
  for (std::size_t i = 0; i < densities.front().size(); ++i) {
    double sum = 0.0;
    for (std::size_t d = 0; d < densities.size(); ++d) {
      values[d] = densities[d][i];
      sum += values[d];
    }
    const auto [lower, upper] = quantile_pair_above_zero(values, confidence);
    const double mean = sum / static_cast<double>(values.size());
    band.density.push_back(median ? quantile(values, 0.5) : mean);
    band.lower.push_back(lower);
    band.upper.push_back(upper);
  }
  return band;
}

template <typename Read>
std::vector<double> of_draws(const DrawnAssemblies& drawn, const Read& read) {
  std::vector<double> values;
  for (const AssemblyDraw& draw : drawn.draws) values.push_back(read(draw));
  return values;
}

void read_spreads(const DrawnAssemblies& drawn, const std::vector<double>& stiffness_spread,
                  AssembliesResult& result) {
  const double confidence = drawn.options.confidence;
  const auto force = of_draws(drawn, [](const AssemblyDraw& d) { return d.spread.slip_force; });
  const auto shape = of_draws(drawn, [](const AssemblyDraw& d) { return d.spread.shape; });
  result.slip_force_spread = spread_of(force, confidence);
  result.shape_spread = spread_of(shape, confidence);
  result.effective_draws =
      std::min(effective_draws(force, drawn.chain), effective_draws(shape, drawn.chain));
  if (drawn.stiffness.from != AssemblyStiffness::kCommon) {
    result.stiffness_spread = spread_of(stiffness_spread, confidence);
  }
  double scatter = 0.0;
  for (const AssemblyDraw& draw : drawn.draws) scatter += draw.dissipation_scatter;
  result.scatter = scatter / static_cast<double>(drawn.draws.size());
  result.scatter_is_relative = !drawn.assemblies.front().levels.dissipation_std_given();
}

/// k of an assembly where it was given, of itself or of all.
std::optional<double> known_stiffness(const DrawnAssemblies& drawn, Eigen::Index j) {
  if (drawn.stiffness.from == AssemblyStiffness::kSought) return std::nullopt;
  const std::optional<double> own = drawn.assemblies[static_cast<std::size_t>(j)].stiffness;
  return own ? own : drawn.stiffness.middle;
}

AssemblyFit read_assembly(const DrawnAssemblies& drawn, const DensityReader& reader,
                          Eigen::Index j) {
  const AssemblyModel& model = drawn.start.model;
  const double confidence = drawn.options.confidence;
  const LevelEvidence& levels = drawn.assemblies[static_cast<std::size_t>(j)].levels;
  AssemblyFit fit;
  fit.name = drawn.assemblies[static_cast<std::size_t>(j)].name;
  std::vector<double> stiffness;
  std::vector<double> scale;
  std::vector<double> shape;
  std::vector<std::vector<double>> densities;
  const Eigen::VectorXd amplitude = view_of(levels.levels().amplitude);
  Eigen::VectorXd dissipation = Eigen::VectorXd::Zero(amplitude.size());
  for (const AssemblyDraw& draw : drawn.draws) {
    const AssemblyDeviations& all = draw.deviations;
    stiffness.push_back(drawn.stiffness.middle * std::exp(model.log_stiffness(all, j)));
    scale.push_back(std::exp(all(j, model.force_column())));
    const Eigen::VectorXd terms = all.row(j).tail(model.shapes().cols()).transpose();
    shape.push_back((model.shapes() * terms).norm() /
                    std::sqrt(static_cast<double>(model.shapes().rows())));
    densities.push_back(reader.read(model.density(draw.middle, all, j), scale.back()));
    dissipation += model.dissipation(draw.middle, all, j, amplitude);
  }
  fit.stiffness = estimate_of_assembly(stiffness, confidence);
  // Not to rounding where it is known.
  if (const std::optional<double> known = known_stiffness(drawn, j)) {
    fit.stiffness = {*known, *known, *known};
  }
  fit.slip_force_scale = estimate_of_assembly(scale, confidence);
  fit.shape = estimate_of_assembly(shape, confidence);
  fit.density = band_of(densities, confidence, false);
  fit.covered_from = fit.stiffness.value * amplitude(0);
  fit.covered_to = fit.stiffness.value * amplitude(amplitude.size() - 1);
  dissipation /= static_cast<double>(drawn.draws.size());
  fit.value.dissipation.assign(dissipation.begin(), dissipation.end());
  return fit;
}

/// Deviation of the next assembly from the middle of the measured ones.
struct NextDeviation {
  double log_stiffness;
  double log_force;
  Eigen::VectorXd terms;
};

NextDeviation next_deviation(const DrawnAssemblies& drawn, std::size_t number,
                             double stiffness_spread) {
  const AssemblyModel& model = drawn.start.model;
  const AssemblySpread& spread = drawn.draws[number].spread;
  const double more = std::sqrt(1.0 + 1.0 / static_cast<double>(model.assemblies()));
  RandomStream random(drawn.options.seed, kNextStreams + number);
  NextDeviation next;
  next.log_stiffness = more * stiffness_spread * random.normal();
  next.log_force = more * spread.slip_force * random.normal();
  next.terms.resize(model.shapes().cols());
  for (double& value : next.terms) value = more * spread.shape * random.normal();
  return next;
}

void read_next(const DrawnAssemblies& drawn, const DensityReader& reader,
               const std::vector<double>& stiffness_spread, AssembliesResult& result) {
  const AssemblyModel& model = drawn.start.model;
  const double middle = drawn.stiffness.middle;
  for (const double f : reader.slip_force()) result.slip_displacement.push_back(f / middle);
  std::vector<std::vector<double>> densities;
  for (std::size_t i = 0; i < drawn.draws.size(); ++i) {
    const NextDeviation next = next_deviation(drawn, i, stiffness_spread[i]);
    Eigen::VectorXd p =
        drawn.draws[i].middle.cwiseProduct((model.shapes() * next.terms).array().exp().matrix());
    const double area = model.area(p);
    if (area > 1.0) p /= area;
    const double kappa = std::exp(next.log_stiffness);
    const double scale = std::exp(next.log_force);
    densities.push_back(reader.read(p, scale));
    // ψ(x) = k²φ(kx) at x = f/kₘ: that of a joint of slip forces S/κ at f.
    AssemblyJoint& joint = result.draws.emplace_back();
    joint.stiffness = middle * kappa;
    joint.density = reader.read(p, scale / kappa);
    for (double& value : joint.density) value *= middle * joint.stiffness;
  }
  result.next = band_of(densities, drawn.options.confidence, true);
}

std::string in_words(const Spread& spread) {
  return fmt::format("{} ({} to {})", percent_text(spread.median), percent_text(spread.lower),
                     percent_text(spread.upper));
}

void warn_of_assemblies(const DrawnAssemblies& drawn, AssembliesResult& result) {
  const std::size_t count = drawn.assemblies.size();
  if (count < kFewAssemblies) {
    result.warnings.push_back(
        {"few_assemblies",
         fmt::format("{} assemblies determine a spread only roughly: that of slip forces is {}. "
                     "The band of the next one is wide for that reason, and assumes spreads of any "
                     "order of magnitude from {} to {} equally likely.",
                     count, in_words(result.slip_force_spread), percent_text(SpreadPrior::kNone),
                     percent_text(SpreadPrior::kUsual))});
  }
  if (drawn.stiffness.from == AssemblyStiffness::kCommon) {
    result.warnings.push_back(
        {"stiffness_spread_unknown",
         "All assemblies, and the next one, are assumed to have the same k: levels of D do not "
         "determine it. Give k of each assembly, or measure k_eq."});
  }
  if (drawn.stiffness.from == AssemblyStiffness::kSought) {
    result.warnings.push_back(
        {"stiffness_by_secant",
         fmt::format("k_eq determines the ratios of k between assemblies; its level is not used, "
                     "and the geometric mean of k is {:.6g} N/m as given.",
                     result.stiffness)});
  }
  if (result.effective_draws < kFewestEffective) {
    result.warnings.push_back(
        {"few_effective_draws", fmt::format("{} draws are worth {:.0f} independent ones: interval "
                                            "bounds are rough. Take more draws.",
                                            drawn.draws.size(), result.effective_draws)});
  }
}

/// σ of ln k of each draw: by given k as it is drawn, else from the chain.
std::vector<double> stiffness_spreads(const DrawnAssemblies& drawn) {
  std::vector<double> all(drawn.draws.size(), 0.0);
  const auto count = static_cast<double>(drawn.assemblies.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (drawn.stiffness.from == AssemblyStiffness::kSought) {
      all[i] = drawn.draws[i].spread.stiffness;
    } else if (drawn.stiffness.from == AssemblyStiffness::kGiven) {
      RandomStream random(drawn.options.seed, 2 * kNextStreams + i);
      all[i] = SpreadPrior::draw(count - 1.0, drawn.stiffness.log_stiffness.squaredNorm(), random);
    }
  }
  return all;
}

}  // namespace

void read_assemblies(const DrawnAssemblies& drawn, AssembliesResult& result) {
  const AssemblyModel& model = drawn.start.model;
  const double middle = drawn.stiffness.middle;
  result.stiffness = middle;
  result.stiffness_from = drawn.stiffness.from;
  result.confidence = drawn.options.confidence;
  double unit = 0.0;
  double top = 0.0;
  result.covered_from = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < drawn.assemblies.size(); ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    const std::vector<double>& amplitude = drawn.assemblies[j].levels.levels().amplitude;
    const double k = middle * std::exp(drawn.stiffness.log_stiffness(row));
    const double scale = std::exp(drawn.start.start.deviations(row, model.force_column()));
    top = std::max(top, k * amplitude.back());
    result.covered_from = std::min(result.covered_from, k * amplitude.front() / scale);
    result.covered_to = std::max(result.covered_to, k * amplitude.back() / scale);
  }
  unit = result.covered_to / drawn.start.covered;
  const DensityReader reader(model, unit, axis_of(model, std::max(top, result.covered_to)));
  result.slip_force = reader.slip_force();
  std::vector<std::vector<double>> middles;
  for (const AssemblyDraw& draw : drawn.draws) middles.push_back(reader.read(draw.middle, 1.0));
  result.common = band_of(middles, drawn.options.confidence, false);
  const std::vector<double> spreads = stiffness_spreads(drawn);
  for (Eigen::Index j = 0; j < model.assemblies(); ++j) {
    result.assemblies.push_back(read_assembly(drawn, reader, j));
  }
  read_spreads(drawn, spreads, result);
  read_next(drawn, reader, spreads, result);
  warn_of_assemblies(drawn, result);
  result.summary.method = "posterior of several assemblies";
  result.summary.stop = Stop::kConverged;
  result.summary.reason = "all draws were made";
  result.summary.iterations = static_cast<int>(drawn.draws.size());
}

}  // namespace microslip
