// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/resonance_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <numbers>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/dynamics/harmonic/balance_run.hpp"
#include "microslip/dynamics/harmonic/bordered_factors.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::RowVectorXd;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr double kHertz = 1.0 / (2.0 * pi);
constexpr double kAlikeResponse = 1e-9;  // responses, relative
constexpr std::size_t kMostInVain = 12;  // responses without a phase resonance
constexpr double kHalfWidths = 3.0;      // of the mode: so near to it lies its phase resonance
constexpr double kLeastWidth = 0.01;     // of the frequency
constexpr double kLargestWidth = 0.3;

double width_about(double damping) {
  return std::min(kHalfWidths * damping + kLeastWidth, kLargestWidth);
}

/// |w_1| of all points that are driven, weighted by the first harmonic of what drives them.
double driven_displacement(const JointedStructure& structure, const SteadyVibration& vibration) {
  std::complex<double> sum = 0.0;
  for (const Excitation& excitation : structure.excitations()) {
    if (excitation.harmonics.empty()) continue;
    sum +=
        excitation.harmonics[0] * vibration.worked_on(structure.linear(), excitation.point).at(1);
  }
  return std::abs(sum);
}

/// From a lag to the next one on a curve, in (−π, π].
double turned(double from, double to) { return std::remainder(to - from, 2.0 * pi); }

const ResonanceTracer::Place& highest_of(const ResonanceTracer::Piece& piece) {
  return *std::ranges::max_element(piece.places, {}, &ResonanceTracer::Place::response);
}

const ResonanceTracer::Place& lowest_of(const ResonanceTracer::Piece& piece) {
  return *std::ranges::min_element(piece.places, {}, &ResonanceTracer::Place::response);
}

double hertz_of(const ResonanceTracer::Place& place) {
  return kHertz * place.z[place.z.size() - 2];
}

/// d lag/d ln ω of the response at constant response amplitude, rad: positive where the phase
/// passes as it does through a resonance, negative where it goes back, as at an antiresonance.
double lag_rise(BalanceEquations& equations) {
  const VectorXd scale = equations.scale();
  const Index frequency = equations.balance_count();
  const Index unknowns = equations.unknown_count();
  BorderedFactors factors;
  factors.compute(equations, scale, equations.log_response_gradient() * scale.asDiagonal(),
                  RowVectorXd::Unit(unknowns, frequency));
  const VectorXd change = factors.solve(VectorXd::Unit(unknowns, unknowns - 1));
  const RowVectorXd lag = equations.lag_gradient() * scale.asDiagonal();
  return lag * change;
}

}  // namespace

ResonanceCurve::ResonanceCurve(const JointedStructure& structure, const ResponsePoint& response,
                               const HarmonicBalanceOptions& options, std::size_t mode,
                               double stuck_frequency)
    : structure_(structure),
      response_(response),
      options_(options),
      mode_(mode),
      stuck_frequency_(stuck_frequency),
      tracer_(structure, response, options, options.forcing) {}

Progress ResonanceCurve::ticking() const {
  if (!progress_) return {};
  return [this](std::size_t, std::size_t) { return progress_(0, count_); };
}

ResponseCurve ResonanceCurve::at(std::span<const double> responses, const Progress& progress) {
  progress_ = progress;
  count_ = responses.size();
  highest_ = responses.back();
  begin(responses.front());
  if (options_.forcing == Forcing::kExcitation) find_more(responses);
  ResponseCurve curve;
  curve.summary.method = options_.forcing == Forcing::kModal
                             ? "harmonic balance, backbone, modal forcing"
                             : "harmonic balance, backbone";
  for (const Piece& piece : pieces_) {
    ResonanceTracer::Rows rows = tracer_.rows(piece, responses, progress);
    for (const std::size_t fold : rows.folds) {
      curve.turning_points.push_back(curve.points.size() + fold);
    }
    std::ranges::move(rows.points, std::back_inserter(curve.points));
  }
  conclude(responses, curve);
  return curve;
}

/// From where the joints stick, as far as it goes.
void ResonanceCurve::begin(double lowest) {
  const std::optional<Place> rest = tracer_.at_rest(stuck_frequency_, lowest);
  if (!rest) return;
  if (options_.forcing == Forcing::kExcitation) {
    const double damping = tracer_.equations().vibration().damping_ratio();
    if (!is_resonance(*rest, stuck_frequency_, damping)) return;
  }
  Piece piece = tracer_.follow(*rest, highest_, ticking());
  if (piece.places.empty()) return;
  piece.from_rest = true;
  pieces_.push_back(std::move(piece));
  reached_ = highest_of(pieces_.back()).response;
}

/// Whether a place is a resonance of the mode of this frequency, not an antiresonance.
bool ResonanceCurve::is_resonance(const Place& place, double frequency, double damping) {
  BalanceEquations& equations = tracer_.equations();
  equations.evaluate(place.z);
  const double offset = std::abs(equations.value(Quantity::kAngularFrequency) / frequency - 1.0);
  return offset <= width_about(damping) && lag_rise(equations) > 0.0;
}

/// Searches the responses above the highest reached, until there is no more.
void ResonanceCurve::find_more(std::span<const double> responses) {
  const auto next_above = [&] {
    return std::ranges::upper_bound(responses, reached_ * (1.0 + kAlikeResponse));
  };
  const auto all = static_cast<std::size_t>(responses.end() - next_above());
  const std::size_t stride = (all + kMostInVain - 1) / kMostInVain;
  for (auto next = next_above(); next != responses.end();) {
    if (progress_ && !progress_(0, count_)) throw Cancelled();
    const double response = *next;
    std::string evidence;
    if (const auto place = find(response, evidence)) {
      trace_from(*place, responses.front());
      reached_ = std::max(reached_, response);
      next = next_above();
      continue;
    }
    in_vain_.push_back({response, std::move(evidence)});
    reached_ = response;
    const auto left = static_cast<std::size_t>(responses.end() - next);
    if (left == 1) return;
    const std::size_t step = std::min(stride, left - 1);  // the last is examined
    next += static_cast<std::ptrdiff_t>(step);
  }
}

/// Up, and down to where the piece before it ends.
void ResonanceCurve::trace_from(const Place& place, double lowest) {
  for (const Piece& piece : pieces_) lowest = std::max(lowest, highest_of(piece).response);
  Piece up = tracer_.follow(place, highest_, ticking());
  Piece down;
  if (lowest < place.response) down = tracer_.follow(place, lowest, ticking());
  if (up.places.empty()) return;
  if (down.places.size() > 1) {
    up.places.insert(up.places.begin(), down.places.rbegin(), std::prev(down.places.rend()));
    up.begins_at_fold = down.returned;
  }
  reached_ = std::max(reached_, highest_of(up).response);
  pieces_.push_back(std::move(up));
}

std::optional<ResonanceCurve::Mode> ResonanceCurve::mode_at(double response) {
  if (!guide_) {
    guide_.emplace(structure_, response_, options_, Forcing::kModal);
    if (const auto rest = guide_->at_rest(stuck_frequency_, response)) {
      guide_piece_ = guide_->follow(*rest, highest_, ticking());
    }
  }
  const auto place = guide_->first_at(guide_piece_, response);
  if (!place) return std::nullopt;
  guide_->equations().evaluate(place->z);
  SteadyVibration vibration = guide_->equations().vibration();
  const double damping = vibration.damping_ratio();
  return Mode{std::move(vibration), guide_->equations().value(Quantity::kAngularFrequency),
              damping};
}

std::optional<ResonanceCurve::Place> ResonanceCurve::find(double response, std::string& evidence) {
  const std::optional<Mode> mode = mode_at(response);
  if (!mode) {
    judged_ = false;
    evidence = at_response(response) + " the mode by itself was not found";
    return std::nullopt;
  }
  if (auto place = from_mode(*mode, response)) return place;
  return sweep(*mode, response, evidence);
}

/// With the motion of the mode and the force that feeds it.
std::optional<ResonanceCurve::Place> ResonanceCurve::from_mode(const Mode& mode, double response) {
  VectorXd z = tracer_.equations().unknowns(mode.vibration);
  const double driven = driven_displacement(structure_, mode.vibration);
  if (!(driven > 0.0)) return std::nullopt;
  z[z.size() - 1] = mode.vibration.input_energy / (pi * driven);
  auto place = tracer_.near(z, response);
  if (place && is_resonance(*place, mode.frequency, mode.damping)) return place;
  return std::nullopt;
}

/// Over the frequencies about the mode, at this response: does the lag rise through π/2?
std::optional<ResonanceCurve::Place> ResonanceCurve::sweep(const Mode& mode, double response,
                                                           std::string& evidence) {
  const double width = width_about(mode.damping);
  const double from = mode.frequency * (1.0 - width);
  const double to = mode.frequency * (1.0 + width);
  const ResponseCurve curve =
      follow_from_stuck(structure_, response_, options_, {Quantity::kResponse, response},
                        Quantity::kAngularFrequency, from, to, 0, ticking());
  double nearest = pi;  // distance from π/2
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const SteadyVibration& here = curve.points[i];
    nearest = std::min(nearest, std::abs(std::remainder(here.phase_lag - 0.5 * pi, pi)));
    if (i == 0) continue;
    const SteadyVibration& before = curve.points[i - 1];
    const double a = std::cos(before.phase_lag);
    const double b = std::cos(here.phase_lag);
    const double turn = turned(before.phase_lag, here.phase_lag) *
                        (here.angular_frequency - before.angular_frequency);
    if (a * b >= 0.0 || turn <= 0.0) continue;
    const VectorXd z = tracer_.equations().unknowns(before);
    const VectorXd next = tracer_.equations().unknowns(here);
    auto place = tracer_.near(z + (next - z) * (a / (a - b)), response);
    if (place && is_resonance(*place, mode.frequency, mode.damping)) return place;
    if (!place) judged_ = false;
  }
  judged_ = judged_ && curve.summary.converged();
  evidence = curve.summary.converged()
                 ? fmt::format(
                       "{}, from {:.6g} to {:.6g} Hz, the lag comes no "
                       "nearer to pi/2 than {:.2g} rad; the mode by itself has {:.6g} Hz and "
                       "a damping ratio of {:.3g} there",
                       at_response(response), kHertz * from, kHertz * to, nearest,
                       kHertz * mode.frequency, mode.damping)
                 : fmt::format("{}: {}", at_response(response), curve.summary.reason);
  return std::nullopt;
}

/// The piece, other than one that ends there, that has a response.
const ResonanceCurve::Piece* ResonanceCurve::piece_with(double response) const {
  for (const Piece& piece : pieces_) {
    const bool has = lowest_of(piece).response <= response * (1.0 + kAlikeResponse) &&
                     highest_of(piece).response > response * (1.0 + kAlikeResponse);
    if (has) return &piece;
  }
  return nullptr;
}

/// "5.92e-10 m".
std::string ResonanceCurve::text_of(double response) const {
  return fmt::format("{:.6g} {}", response, unit_of(response_.kind));
}

std::string ResonanceCurve::at_response(double response) const {
  return "at the response " + text_of(response);
}

/// Text on why pieces end, and on the responses without phase resonance.
std::string ResonanceCurve::why_not() const {
  std::string text;
  for (const Piece& piece : pieces_) {
    if (piece.complete) continue;
    const Place& end = piece.places.back();
    text += fmt::format("; {}, {:.6g} Hz, ", at_response(end.response), hertz_of(end));
    if (!piece.returned) {
      text += "tracking failed: " + piece.reason;
    } else if (const Piece* next = piece_with(end.response)) {
      text += fmt::format("it turns back and jumps to {:.6g} Hz", hertz_of(next->places.front()));
    } else {
      text +=
          "it turns back: resonance and antiresonance meet, beyond it the other modes "
          "determine the phase";
    }
  }
  std::size_t without = 0;
  std::string evidence;
  for (const InVain& at : in_vain_) {
    if (piece_with(at.response) != nullptr) continue;
    if (++without == 1) evidence = at.evidence;
  }
  if (without == 0) return text;
  return text + fmt::format("; no phase resonance was found at {} of {} responses: {}", without,
                            count_, evidence);
}

std::string ResonanceCurve::what_there_is() const {
  const std::string mode = fmt::format("phase resonance of mode {} at '{}' with this excitation",
                                       mode_ + 1, response_.point);
  if (pieces_.empty()) return mode + (judged_ ? " does not exist" : " was not found");
  std::string text = mode + " exists only";
  for (const Piece& piece : pieces_) {
    if (&piece != &pieces_.front()) text += " and";
    if (!piece.from_rest) text += " from " + text_of(lowest_of(piece).response);
    text += (piece.from_rest ? " up to " : " to ") + text_of(highest_of(piece).response);
  }
  return text;
}

void ResonanceCurve::conclude(std::span<const double> responses, ResponseCurve& curve) {
  Summary& s = curve.summary;
  s.iterations = tracer_.iterations();
  s.residual = tracer_.residual();
  std::vector<double> found;
  for (const SteadyVibration& point : curve.points) found.push_back(point.response);
  std::ranges::sort(found);
  const auto missing = static_cast<std::size_t>(std::ranges::count_if(responses, [&](double r) {
    const auto next = std::ranges::lower_bound(found, r * (1.0 - kAlikeResponse));
    return next == found.end() || *next > r * (1.0 + kAlikeResponse);
  }));
  const bool whole = !pieces_.empty() && missing == 0;
  s.stop = whole ? Stop::kConverged : Stop::kIncomplete;
  if (whole) {
    s.reason = "all responses reached";
    if (pieces_.size() == 1 && !curve.turning_points.empty()) {
      s.reason += fmt::format(
          "; phase resonance turns back {} times, so that responses in between "
          "occur more than once",
          curve.turning_points.size());
    }
    return;
  }
  if (options_.forcing == Forcing::kModal) {
    s.reason = pieces_.empty()
                   ? fmt::format("mode {} was not found where its joints stick", mode_ + 1)
                   : pieces_.front().reason;
    if (s.reason.empty()) s.reason = fmt::format("{} responses were not found", missing);
    return;
  }
  s.reason = what_there_is() + why_not();
  if (missing > 0) s.reason += fmt::format("; {} of {} responses are missing", missing, count_);
  s.reason +=
      "; drive or observe another point, or use modal forcing, where the mode always exists";
}

}  // namespace microslip
