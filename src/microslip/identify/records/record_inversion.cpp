// SPDX-License-Identifier: MIT
#include "microslip/identify/records/record_inversion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/interpolation.hpp"
#include "microslip/base/random.hpp"
#include "microslip/base/stopwatch.hpp"
#include "microslip/identify/posterior/chi_squared.hpp"
#include "microslip/identify/posterior/posterior_chain.hpp"
#include "microslip/identify/posterior/quantiles.hpp"
#include "microslip/identify/records/draw_reader.hpp"
#include "microslip/identify/records/level_agreement.hpp"
#include "microslip/identify/records/record_departures.hpp"
#include "microslip/identify/records/record_model.hpp"
#include "microslip/identify/records/record_polarity.hpp"
#include "microslip/identify/records/record_settling.hpp"
#include "microslip/identify/smoothing/fewer_rows.hpp"
#include "microslip/identify/smoothing/signed_density.hpp"
#include "microslip/observe/record_force.hpp"

namespace microslip {
namespace {

constexpr std::size_t kFewestReversals = 2;
constexpr std::size_t kFewestDraws = 100;
/// Stream of the order of draws; those of the priors come before it.
constexpr std::uint64_t kOrderStream = 64;
/// Share of the force that a departure explains from which on the joint is fitted to the force as
/// it is, and not as residuals of noise would be.
constexpr double kFarDeparture = 0.05;

/// Where limits or the smoothing act, nearly all draws may lie on one side of the estimate: the
/// limits that it is at hold in truth to within its own deviation alone.
Estimate within_band(double value, double deviation, std::vector<double> draws, double confidence) {
  const auto [lower, upper] = shortest_interval(draws, confidence);
  const double reach = deviation * std::sqrt(ChiSquared(1.0).quantile(confidence));
  return {value, std::min(lower, std::max(0.0, value - reach)), std::max(upper, value + reach)};
}

/// Standard deviation of a linear function of the coefficients that are free.
double deviation_of(const SettledRecords& settled, const Eigen::VectorXd& function) {
  const SmoothingProblem& problem = settled.model.problem();
  const SmoothingPoint& best = settled.best;
  const std::vector<Eigen::Index> free = free_coefficients(best.solution);
  const Eigen::VectorXd own = function(free);
  const Eigen::MatrixXd hessian = problem.hessian(best.lambda)(free, free);
  const double freedom = std::max(1.0, static_cast<double>(problem.rows()) - best.edf);
  return std::sqrt(own.dot(hessian.llt().solve(own)) * best.residual / freedom);
}

/// λ stays between the ends of a path.
ChainTarget chain_target(const SettledRecords& settled) {
  const SmoothingProblem& problem = settled.model.problem();
  Eigen::MatrixXd rows(problem.rows(), problem.size() + 1);
  rows << problem.design(), problem.data();
  const Eigen::MatrixXd fewer = fewer_rows(rows);
  ChainTarget target;
  const double alike = settled.settings.alike_rows;
  target.rows.push_back({.design = fewer.leftCols(problem.size()) / std::sqrt(alike),
                         .data = fewer.rightCols(1) / std::sqrt(alike),
                         .count = static_cast<double>(problem.rows()) / alike});
  target.penalty = problem.penalty();
  target.limits = {problem.size(), problem.area()};
  const std::vector<double> ends = problem.lambda_grid(2);
  target.least_lambda = std::min(ends.back(), settled.best.lambda);
  target.most_lambda = std::max(ends.front(), settled.best.lambda);
  return target;
}

/// Continues a draw below the resolution of the records with another exponent, where k is found:
/// what slips there is in no force but that of the first samples behind a turn.
/// @param displacement  of the density of a draw, m.
void continue_below(const SettledRecords& settled, std::span<const double> displacement,
                    double exponent, StiffnessDraw& draw) {
  if (settled.records->stiffness_known) return;
  const double lowest = settled.records->length * settled.records->lowest;
  const double before = settled.settings.exponent;
  const auto area_below = [&] {
    double sum = 0.0;
    for (std::size_t j = 1; j < displacement.size() && displacement[j - 1] < lowest; ++j) {
      sum +=
          0.5 * (displacement[j] - displacement[j - 1]) * (draw.density[j] + draw.density[j - 1]);
    }
    return sum;
  };
  draw.stiffness -= area_below();
  for (std::size_t j = 0; displacement[j] < lowest; ++j) {
    const double share = std::max(displacement[j], displacement[1]) / lowest;
    draw.density[j] *= std::pow(share, exponent - before);
  }
  draw.stiffness += area_below();
}

/// Draws with one prior until there are so many.
void draw_of_prior(const SettledRecords& settled, std::size_t end, RandomStream& random,
                   const RecordInversionOptions& options, std::vector<double>& elastic,
                   RecordInversionResult& result) {
  if (result.draws.size() >= end) return;
  const DrawReader reader(settled.model, *settled.records);
  const ChainTarget target = chain_target(settled);
  PosteriorChain chain(target, {settled.best.solution.x, settled.best.lambda, {1.0}});
  chain.settle(random);
  while (result.draws.size() < end) {
    chain.next(random);
    const QuadraticProgram::Solution drawn = chain.projected(random);
    if (!drawn.optimal() && drawn.kkt_residual >= result.summary.residual) {
      read_optimality(drawn, "optimality conditions of a draw", result.summary);
    }
    result.draws.push_back(reader.read(drawn.x));
    const std::span<const double> exponents = tried_exponents();
    const double place = random.uniform() * static_cast<double>(exponents.size());
    continue_below(settled, result.slip_displacement, exponents[static_cast<std::size_t>(place)],
                   result.draws.back());
    elastic.push_back(reader.elastic(drawn.x));
    if (options.progress && !options.progress(result.draws.size(), options.draws)) {
      throw Cancelled();
    }
  }
}

/// Any number of the first draws is to stand for all.
void shuffle_draws(std::uint64_t seed, std::vector<double>& elastic,
                   std::vector<StiffnessDraw>& draws) {
  RandomStream random(seed, kOrderStream);
  for (std::size_t i = draws.size(); i > 1; --i) {
    const auto other =
        std::min(i - 1, static_cast<std::size_t>(random.uniform() * static_cast<double>(i)));
    std::swap(draws[i - 1], draws[other]);
    std::swap(elastic[i - 1], elastic[other]);
  }
}

/// Posterior draws of the joint, with each prior that the data leave possible, and K_e of each.
std::vector<double> draw_all(const SettledRecords& settled, const RecordInversionOptions& options,
                             RecordInversionResult& result) {
  const std::vector<PossiblePrior> priors = possible_priors(settled);
  std::vector<double> elastic;
  double share = 0.0;
  for (std::size_t p = 0; p < priors.size(); ++p) {
    share += priors[p].weight;
    const double until = p + 1 < priors.size() ? share : 1.0;
    const auto end =
        static_cast<std::size_t>(std::lround(until * static_cast<double>(options.draws)));
    RandomStream random(options.seed, p);
    draw_of_prior(priors[p].settled, end, random, options, elastic, result);
  }
  if (priors.size() > 1) shuffle_draws(options.seed, elastic, result.draws);
  return elastic;
}

/// The estimate is the likeliest joint, the bands are those of the draws.
void read_joint(const SettledRecords& settled, const DrawReader& reader,
                const RecordInversionOptions& options, RecordInversionResult& result) {
  const StiffnessDraw best = reader.read(settled.best.solution.x);
  std::vector<double> values(result.draws.size());
  const auto read_draws = [&](const auto& read) {
    std::ranges::transform(result.draws, values.begin(), read);
  };
  for (std::size_t j = 0; j < result.slip_displacement.size(); ++j) {
    read_draws([j](const StiffnessDraw& draw) { return draw.density[j]; });
    const auto [lower, upper] = quantile_pair_above_zero(values, options.confidence);
    result.density.push_back(best.density[j]);
    result.lower.push_back(std::min(lower, best.density[j]));
    result.upper.push_back(std::max(upper, best.density[j]));
  }
  read_draws([](const StiffnessDraw& draw) { return draw.stiffness; });
  result.stiffness = within_band(best.stiffness, deviation_of(settled, reader.stiffness_row()),
                                 values, options.confidence);
  if (!options.viscous) return;
  read_draws([](const StiffnessDraw& draw) { return draw.viscous; });
  result.viscous = within_band(best.viscous, deviation_of(settled, reader.viscous_row()), values,
                               options.confidence);
}

std::vector<std::vector<RecordVerdict>> verdicts_of(const SettledRecords& settled,
                                                    const ScaledRecords& records) {
  std::vector<std::vector<RecordVerdict>> verdicts;
  for (std::size_t r = 0; r < records.records.size(); ++r) {
    verdicts.push_back(judge_record(settled, records, r));
  }
  return verdicts;
}

/// Whether so much departs from any joint that residuals are no noise.
bool departs_far(const std::vector<std::vector<RecordVerdict>>& verdicts) {
  return std::ranges::any_of(verdicts, [](const std::vector<RecordVerdict>& of_record) {
    return std::ranges::any_of(of_record, [](const RecordVerdict& verdict) {
      return verdict.broken && verdict.share > kFarDeparture;
    });
  });
}

/// What the joint leaves of the force of a record where its state is known whatever it was at the
/// start, as a comparison with another record would find; of all where it is nowhere.
double unexplained_by(const RecordInversionResult& result, const RecordEvidence& record) {
  const double viscous = result.viscous ? result.viscous->value : 0.0;
  const RecordEvidence unknown = record.from(PathStart::kUnknown);
  const RecordEvidence& judged = unknown.rows().rows.empty() ? record : unknown;
  return unexplained_share(judged.measured().force, found_force(judged, result.joint(), viscous));
}

void read_records(const SettledRecords& settled, const ScaledRecords& records,
                  const std::vector<std::vector<RecordVerdict>>& verdicts, const Eigen::VectorXd& x,
                  RecordInversionResult& result) {
  const double force = records.stiffness * records.length;
  for (std::size_t r = 0; r < records.records.size(); ++r) {
    RecordFit fit;
    fit.start = records.records[r].start();
    fit.scatter = force * settled.settings.scatter[r];
    fit.correlation = settled.settings.correlation[r];
    const Eigen::VectorXd left = force * settled.model.residual(r, x);
    fit.residual.assign(left.begin(), left.end());
    fit.unexplained = unexplained_by(result, records.records[r]);
    const Eigen::VectorXd offset = force * settled.model.offsets(r, x);
    fit.offset.assign(offset.begin(), offset.end());
    fit.verdicts = verdicts[r];
    result.records.push_back(std::move(fit));
  }
}

void read_levels(const SettledRecords& settled, const JointEvidence& evidence,
                 const Eigen::VectorXd& x, std::optional<double> stiffness,
                 const RecordInversionOptions& options, RecordInversionResult& result) {
  for (std::size_t t = 0; t < evidence.levels.size(); ++t) {
    LevelFit fit;
    fit.scatter = settled.settings.levels[t].scatter;
    fit.scatter_is_relative = !evidence.levels[t].dissipation_std_given();
    fit.value = settled.model.levels_of(t, x);
    fit.deviation = settled.model.level_deviations(t);
    const LevelAgreement agreement =
        agreement_of_levels(evidence, t, stiffness, options.coefficients);
    fit.dissipation_verdict = agreement.dissipation;
    fit.secant_verdict = agreement.secant;
    result.levels.push_back(std::move(fit));
  }
}

/// Levels alone determine neither k nor a viscous part.
void check_evidence(const JointEvidence& evidence, std::optional<double> stiffness,
                    const RecordInversionOptions& options) {
  if (!evidence.records.empty() || evidence.levels.empty()) {
    check_records(evidence.records, options);
    return;
  }
  if (!stiffness) {
    throw InputError("stiffness", InputState{"missing"},
                     "must be given with levels alone: slip forces are k times A",
                     "Give k, or a record of force and displacement, which determines it.");
  }
  if (options.viscous) {
    throw InputError("viscous part", InputState{"sought"}, "needs a record of force over time");
  }
}

void summarise(const JointEvidence& evidence, const SmoothingPoint& best, Summary& summary) {
  summary.method = evidence.levels.empty()    ? "posterior of force–displacement records"
                   : evidence.records.empty() ? "posterior of tables of levels"
                                              : "posterior of records and levels";
  summary.iterations = best.solution.exchanges;
  read_optimality(best.solution, "optimality conditions", summary);
}

}  // namespace

void RecordInversionOptions::check() const {
  if (coefficients < 10) throw InputError("coefficients", coefficients, "must be 10 or more");
  if (draws < kFewestDraws) {
    throw InputError("number of draws", static_cast<double>(draws),
                     fmt::format("must be {} or more", kFewestDraws), "1000 give smooth bands.");
  }
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw InputError("confidence", confidence, "must be between 0 and 1");
  }
}

Joint RecordInversionResult::joint() const {
  return joint_of_stiffness_density(slip_displacement, density, stiffness.value);
}

DensityBand RecordInversionResult::density_band() const {
  std::vector<std::vector<double>> densities(slip_displacement.size());
  for (const StiffnessDraw& draw : draws) {
    const double k = draw.stiffness;
    for (std::size_t j = 0; j < slip_displacement.size(); ++j) {
      const double at = slip_displacement[j] * stiffness.value / k;
      densities[j].push_back(interpolate(slip_displacement, draw.density, at) / (k * k));
    }
  }
  DensityBand band;
  for (std::size_t j = 0; j < densities.size(); ++j) {
    const auto [from, to] = quantile_pair_above_zero(densities[j], confidence);
    const double found = density[j] / (stiffness.value * stiffness.value);
    band.lower.push_back(std::min(from, found));
    band.upper.push_back(std::max(to, found));
  }
  return band;
}

void check_records(std::span<const RecordEvidence> evidence,
                   const RecordInversionOptions& options) {
  if (evidence.empty()) throw InputError("number of records", 0.0, "must be 1 or more");
  for (const RecordEvidence& one : evidence) {
    const auto reversals = static_cast<double>(one.rows().reversals);
    if (one.rows().reversals < kFewestReversals) {
      throw InputError(
          "number of reversals of the displacement", reversals,
          fmt::format("must be {} or more: slip shows at reversals of the path", kFewestReversals),
          "Record at least one cycle.");
    }
    if (one.rows().rows.size() < kFewestRecordSamples) {
      throw InputError("number of samples after the first reversals",
                       static_cast<double>(one.rows().rows.size()),
                       fmt::format("must be {} or more", kFewestRecordSamples),
                       "Record more cycles, or begin with a joint that has not slipped.");
    }
    check_polarity(one);
    if (options.viscous && one.measured().time_step == 0.0) {
      throw InputError(
          "time step", 0.0, "must be known to find a viscous part",
          "Give evenly spaced times: `microslip convert IN OUT --resample` makes them.");
    }
  }
}

RecordInversionResult invert_records(std::span<const RecordEvidence> evidence,
                                     std::optional<double> stiffness,
                                     const RecordInversionOptions& options) {
  return invert_together({.records = evidence}, stiffness, options);
}

RecordInversionResult invert_together(const JointEvidence& evidence,
                                      std::optional<double> stiffness,
                                      const RecordInversionOptions& options) {
  Stopwatch watch;
  options.check();
  if (stiffness) check_stiffness(*stiffness);
  check_evidence(evidence, stiffness, options);
  const ScaledRecords records(evidence, stiffness, options.coefficients);
  SettledRecords settled = settle_records(records, options.viscous);
  const std::vector<std::vector<RecordVerdict>> verdicts = verdicts_of(settled, records);
  if (departs_far(verdicts)) settled = nearest_in_force(settled);

  RecordInversionResult result;
  summarise(evidence, settled.best, result.summary);
  result.summary.timings.push_back(watch.lap("noise and smoothing"));
  result.confidence = options.confidence;
  result.stiffness_known = stiffness.has_value();
  result.resolved_from = records.length * settled.records->lowest;
  result.reference_exponent = settled.settings.exponent;
  result.slip_displacement = slip_displacements(settled);
  const Eigen::VectorXd& best = settled.best.solution.x;
  const DrawReader reader(settled.model, *settled.records);
  std::vector<double> elastic = draw_all(settled, options, result);
  read_joint(settled, reader, options, result);
  result.elastic_stiffness =
      within_band(reader.elastic(best), deviation_of(settled, reader.elastic_row()),
                  std::move(elastic), options.confidence);
  result.summary.timings.push_back(watch.lap("draws"));
  read_records(settled, records, verdicts, best, result);
  read_levels(settled, evidence, best, stiffness, options, result);
  result.summary.timings.push_back(watch.lap("verdicts"));
  result.summary.wall_seconds = watch.seconds();
  return result;
}

}  // namespace microslip
