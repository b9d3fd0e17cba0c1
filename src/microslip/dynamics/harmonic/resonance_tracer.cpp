// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/resonance_tracer.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/dynamics/harmonic/amplitude_continuation.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kSameResponse = 1e-9;  // relative

bool same(double one, double other) { return std::abs(one / other - 1.0) <= kSameResponse; }

/// Whether x lies between two values, or beyond one by no more than half of their difference.
bool lies_near(double x, double from, double to) {
  const double margin = 0.5 * std::abs(to - from) + 1e-6 * std::abs(from);
  return x >= std::min(from, to) - margin && x <= std::max(from, to) + margin;
}

}  // namespace

ResonanceTracer::ResonanceTracer(const JointedStructure& structure, const ResponsePoint& response,
                                 const HarmonicBalanceOptions& options, Forcing forcing)
    : equations_(structure, response, options.harmonics, options.samples, forcing),
      options_{{options.tolerance, options.max_iterations},
               options.largest_change,
               options.least_points,
               options.max_points} {}

void ResonanceTracer::count(const NewtonResult& result) {
  iterations_ += result.iterations;
  if (result.converged) residual_ = std::max(residual_, result.residual);
}

std::optional<ResonanceTracer::Place> ResonanceTracer::at_rest(double stuck_frequency,
                                                               double most) {
  AmplitudeContinuation walk(equations_, options_.newton, kPhaseResonance, Quantity::kResponse);
  const NewtonResult result = walk.start(stuck_frequency, most);
  count(result);
  if (!result.converged) return std::nullopt;
  equations_.evaluate(walk.z());
  return Place{walk.z(), walk.level()};
}

std::optional<ResonanceTracer::Place> ResonanceTracer::near(const VectorXd& z, double response) {
  Place place{z, response};
  const NewtonResult result = newton(
      equations_, kPhaseResonance, Target{Quantity::kResponse, response}, options_.newton, place.z);
  count(result);
  if (!result.converged) return std::nullopt;
  return place;
}

ResonanceTracer::Piece ResonanceTracer::follow(const Place& from, double to,
                                               const Progress& progress) {
  Piece piece;
  if (same(from.response, to)) {
    piece.places = {{from.z, to}};
    piece.complete = true;
    return piece;
  }
  ResponseCurve curve;
  Continuation(equations_, options_, kPhaseResonance, Quantity::kResponse, from.response, to)
      .run(from.z, curve, progress);
  iterations_ += curve.summary.iterations;
  residual_ = std::max(residual_, curve.summary.residual);
  for (const SteadyVibration& point : curve.points) {
    piece.places.push_back({equations_.unknowns(point), point.response});
  }
  piece.complete = curve.summary.converged();
  piece.reason = curve.summary.reason;
  if (piece.places.empty()) return piece;
  piece.places.front().response = from.response;
  if (piece.complete) piece.places.back().response = to;
  const bool up = to > from.response;
  const double last = piece.places.back().response;
  piece.returned = !piece.complete && piece.places.size() > 2 &&
                   (up ? last <= from.response * (1.0 + kSameResponse)
                       : last >= from.response * (1.0 - kSameResponse));
  locate_folds(piece);
  if (piece.returned) cut_return(piece);
  return piece;
}

/// Cuts the part beyond the farthest response, which leads back on the other side of the fold.
void ResonanceTracer::cut_return(Piece& piece) const {
  const double from = piece.places.front().response;
  const auto farthest = std::ranges::max_element(piece.places, {}, [&](const Place& place) {
    return std::abs(std::log(place.response / from));
  });
  piece.places.erase(farthest + 1, piece.places.end());
}

/// On the plane across the chord of two places, at a share of it.
bool ResonanceTracer::correct(const Place& from, const Place& to, double share, Place& place) {
  equations_.evaluate(from.z);
  const VectorXd scale = equations_.scale();
  const VectorXd chord = to.z - from.z;
  place.z = from.z + share * chord;
  const VectorXd relative = chord.cwiseQuotient(scale).normalized();
  const microslip::Place plane{place.z, relative.cwiseQuotient(scale).transpose()};
  const NewtonResult result = newton(equations_, kPhaseResonance, plane, options_.newton, place.z);
  count(result);
  if (!result.converged) return false;
  place.response = equations_.value(Quantity::kResponse);
  return true;
}

/// The extremes of the response take the places next to them.
void ResonanceTracer::locate_folds(Piece& piece) {
  constexpr int kBits = 26;
  for (std::size_t i = 1; i + 1 < piece.places.size(); ++i) {
    const Place before = piece.places[i - 1];
    const Place after = piece.places[i + 1];
    Place best = piece.places[i];
    const double rise = best.response - before.response;
    if (rise * (after.response - best.response) >= 0.0) continue;
    const double sign = rise > 0.0 ? 1.0 : -1.0;
    const auto height = [&](double share) {
      Place place;
      if (!correct(before, after, share, place)) return HUGE_VAL;
      if (sign * (place.response - best.response) > 0.0) best = place;
      return -sign * place.response / best.response;
    };
    std::uintmax_t most = 40;
    (void)boost::math::tools::brent_find_minima(height, 0.0, 1.0, kBits, most);
    piece.places[i] = best;
  }
}

std::optional<ResonanceTracer::Place> ResonanceTracer::between(const Place& from, const Place& to,
                                                               double response) {
  if (same(from.response, response)) return Place{from.z, response};
  if (same(to.response, response)) return Place{to.z, response};
  const double share = (response - from.response) / (to.response - from.response);
  const Index n = equations_.balance_count();
  const auto place = near(from.z + share * (to.z - from.z), response);
  if (place && lies_near(place->z[n], from.z[n], to.z[n]) &&
      lies_near(place->z[n + 1], from.z[n + 1], to.z[n + 1])) {
    return place;
  }
  return bisected(from, to, response);
}

/// Along the chord, where next to a fold Newton's method has two solutions.
std::optional<ResonanceTracer::Place> ResonanceTracer::bisected(const Place& from, const Place& to,
                                                                double response) {
  constexpr int kMostSteps = 100;
  double low = 0.0;
  double high = 1.0;
  const double sign = to.response > from.response ? 1.0 : -1.0;
  for (int step = 0; step < kMostSteps; ++step) {
    const double middle = 0.5 * (low + high);
    Place place;
    if (!correct(from, to, middle, place)) return std::nullopt;
    const double above = sign * (place.response / response - 1.0);
    if (std::abs(above) <= 1e-12 || high - low < 1e-15) return Place{place.z, response};
    (above > 0.0 ? high : low) = middle;
  }
  return std::nullopt;
}

ResonanceTracer::Rows ResonanceTracer::rows(const Piece& piece, std::span<const double> responses,
                                            const Progress& progress) {
  Rows rows;
  std::size_t done = 0;
  const auto add = [&](const VectorXd& z) {
    equations_.evaluate(z);
    rows.points.push_back(equations_.vibration());
    done = std::min(done + 1, responses.size());
    if (progress && !progress(done, responses.size())) throw Cancelled();
  };
  const auto add_at = [&](const Place& from, const Place& to, double response) {
    if (const auto place = between(from, to, response)) {
      add(place->z);
    } else {
      rows.missed.push_back(response);
    }
  };
  const std::vector<Place>& places = piece.places;
  if (places.empty()) return rows;
  const bool listed = std::ranges::any_of(
      responses, [&](double response) { return same(response, places.front().response); });
  if (listed || piece.begins_at_fold) add(places.front().z);
  if (piece.begins_at_fold) rows.folds.push_back(0);
  const auto below = [](double response, double limit) { return response < limit; };
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Place& from = places[i - 1];
    const Place& to = places[i];
    const bool up = to.response > from.response;
    // Without the response at `from`, and with that at `to`.
    const double low = std::min(from.response, to.response) * (1.0 - kSameResponse);
    const double high = std::max(from.response, to.response) * (1.0 + kSameResponse);
    auto first = std::lower_bound(responses.begin(), responses.end(), low, below);
    auto last = std::lower_bound(first, responses.end(), high, below);
    while (up && first != last && same(*first, from.response)) ++first;
    while (!up && first != last && same(*(last - 1), from.response)) --last;
    if (up) {
      for (; first != last; ++first) add_at(from, to, *first);
    } else {
      while (last != first) add_at(from, to, *--last);
    }
    const bool folds = i + 1 < places.size() && (places[i + 1].response > to.response) != up;
    const bool ends = i + 1 == places.size() && piece.returned;
    const bool within = to.response >= responses.front() && to.response <= responses.back();
    if (!(folds || ends) || !within) continue;
    if (!same(rows.points.empty() ? 0.0 : rows.points.back().response, to.response)) add(to.z);
    rows.folds.push_back(rows.points.size() - 1);
  }
  return rows;
}

std::optional<ResonanceTracer::Place> ResonanceTracer::first_at(const Piece& piece,
                                                                double response) {
  const std::vector<Place>& places = piece.places;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (same(places[i].response, response)) return places[i];
    if (i == 0) continue;
    const double before = places[i - 1].response;
    if ((before - response) * (places[i].response - response) < 0.0) {
      return between(places[i - 1], places[i], response);
    }
  }
  return std::nullopt;
}

}  // namespace microslip
