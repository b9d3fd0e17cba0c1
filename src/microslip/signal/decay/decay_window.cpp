// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/decay_window.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/signal/decay/tapered_transform.hpp"
#include "microslip/signal/decay/window_nodes.hpp"

namespace microslip {
namespace {

constexpr int kParameters = 7;
using Parameters = Eigen::Matrix<double, kParameters, 1>;  // u, δh, p, φ, ωh, αh², βh³; h = T/2
using Matrix = Eigen::Matrix<double, kParameters, kParameters>;
constexpr int kExponent = 2;

constexpr double kLargestExponent = 4.0;
constexpr double kLargestBend = 0.9;  // of |pδT/2|; at 1 the curve ends inside of the window

/// ln(1 + q)/q and its derivative.
struct LogRatio {
  double value;
  double slope;
};

LogRatio log_ratio(double q) {
  if (std::abs(q) < 1e-3) {  // the next terms are below 1e-15
    return {1.0 + q * (-1.0 / 2 + q * (1.0 / 3 + q * (-1.0 / 4 + q * (1.0 / 5 - q / 6)))),
            -1.0 / 2 + q * (2.0 / 3 + q * (-3.0 / 4 + q * (4.0 / 5 - q * 5.0 / 6)))};
  }
  const double log = std::log1p(q);
  return {log / q, (q / (1.0 + q) - log) / (q * q)};
}

/// The model at s = τ/h less a phase that turns with the carrier, and the derivatives of its real
/// and its imaginary part.
struct ModelValue {
  std::complex<double> value;
  Parameters real;
  Parameters imaginary;
};

/// @param carrier  ω₀h
void model(const Parameters& p, double s, double carrier, ModelValue& at) {
  const double move = p[1] * s;
  const LogRatio log = log_ratio(p[kExponent] * move);
  const double envelope = std::exp(p[0] - move * log.value);
  const double phase = p[3] + s * (p[4] - carrier + s * (p[5] / 2.0 + s * p[6] / 6.0));
  const double x = envelope * std::cos(phase);
  const double y = envelope * std::sin(phase);
  const double by_decay = -s / (1.0 + p[kExponent] * move);
  const double by_exponent = -move * move * log.slope;
  at.value = {x, y};
  at.real << x, x * by_decay, x * by_exponent, -y, -y * s, -y * s * s / 2.0, -y * s * s * s / 6.0;
  at.imaginary << y, y * by_decay, y * by_exponent, x, x * s, x * s * s / 2.0, x * s * s * s / 6.0;
}

/// The values of a window, over an amplitude that makes them of order 1.
class Samples {
 public:
  Samples(const WindowNodes& nodes, double scale)
      : nodes_(nodes),
        scale_(1.0 / scale),
        carrier_(0.5 * nodes.carrier() * nodes.length()),
        model_{0.0, Parameters::Zero(), Parameters::Zero()} {}

  /// Calls visit(weight, residual, slopes) for each real number.
  template <typename Visit>
  void visit(const Parameters& p, const Visit& visit) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      model(p, nodes_.place(i), carrier_, model_);
      const std::complex<double> value = nodes_.value(i) * scale_;
      visit(nodes_.weight(i), value.real() - model_.value.real(), model_.real);
      if (!nodes_.is_complex()) continue;
      visit(nodes_.weight(i), value.imag() - model_.value.imag(), model_.imaginary);
    }
  }

  /// Residual of the fit at the nodes, in the unit of the signal.
  [[nodiscard]] std::vector<std::complex<double>> residual(const Parameters& p) {
    std::vector<std::complex<double>> residual(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      model(p, nodes_.place(i), carrier_, model_);
      const std::complex<double> modelled =
          nodes_.is_complex() ? model_.value : std::complex<double>(model_.value.real());
      residual[i] = nodes_.value(i) - modelled / scale_;
    }
    return residual;
  }

  /// Samples of white noise that one of the real numbers stands for.
  [[nodiscard]] double samples() const { return nodes_.samples(); }

 private:
  const WindowNodes& nodes_;
  double scale_;
  double carrier_;
  ModelValue model_;
};

struct NormalEquations {
  Matrix matrix = Matrix::Zero();
  Parameters gradient = Parameters::Zero();
  double cost = 0.0;
};

/// Adds w·vvᵀ to the lower triangle of a sum; for so few rows Eigen's takes several times as long.
void add_square(Matrix& sum, const Parameters& v, double w) {
  for (int column = 0; column < kParameters; ++column) {
    const double factor = w * v[column];
    for (int row = column; row < kParameters; ++row) sum(row, column) += factor * v[row];
  }
}

NormalEquations normal_equations(Samples& samples, const Parameters& p) {
  NormalEquations sum;
  samples.visit(p, [&](double weight, double residual, const Parameters& slopes) {
    add_square(sum.matrix, slopes, weight);
    sum.gradient += weight * residual * slopes;
    sum.cost += weight * residual * residual;
  });
  sum.matrix = sum.matrix.selfadjointView<Eigen::Lower>();
  return sum;
}

/// Where the exponent is at its bound it is no unknown.
bool exponent_bound(const Parameters& p) {
  return std::abs(p[kExponent]) >= kLargestExponent ||
         std::abs(p[kExponent] * p[1]) >= kLargestBend * (1.0 - 1e-12);
}

void clamp_exponent(Parameters& p) {
  const double most = std::min(kLargestExponent, kLargestBend / std::max(std::abs(p[1]), 1e-300));
  p[kExponent] = std::clamp(p[kExponent], -most, most);
}

/// Where a step of Levenberg and Marquardt goes; without damping it is one of Gauss and Newton.
struct Move {
  Parameters to;
  double size = HUGE_VAL;  ///< largest, in units of radians and of ln A

  Move(const NormalEquations& at, const Parameters& from, double damping) {
    // A decay near 0 leaves the exponent free: the small term keeps the matrix regular.
    const Parameters diagonal = at.matrix.diagonal();
    Matrix damped = at.matrix;
    damped.diagonal() += damping * diagonal + Parameters::Constant(1e-14 * diagonal[0]);
    to = from + damped.ldlt().solve(at.gradient);
    if (!to.allFinite()) return;
    clamp_exponent(to);
    // Along the exponent the step counts by what it does to the envelope.
    Parameters effect = to - from;
    effect[kExponent] *= from[1] * from[1];
    size = effect.lpNorm<Eigen::Infinity>();
  }
};

/// The last steps, which the cost cannot resolve: it is flat over √ε where the gradient is not.
void polish(Samples& samples, const NormalEquations& at, Parameters& p) {
  constexpr double kFlat = 1e-6;  // as Move::size
  constexpr double kSame = 1e-12;
  const Move move(at, p, 0.0);
  if (!move.to.allFinite() || move.size > kFlat) return;
  if (normal_equations(samples, move.to).cost <= at.cost * (1.0 + kSame)) p = move.to;
}

/// Levenberg–Marquardt. @return  whether it converged.
bool minimise(Samples& samples, Parameters& p) {
  constexpr int kMostSteps = 60;
  constexpr double kRest = 1e-8;  // as Move::size: far below any noise
  double damping = 1e-3;
  NormalEquations now = normal_equations(samples, p);
  for (int i = 0; i < kMostSteps; ++i) {
    const Move move(now, p, damping);
    if (!move.to.allFinite()) return false;
    const NormalEquations there = normal_equations(samples, move.to);
    if (there.cost < now.cost) {
      p = move.to;
      now = there;
      damping = std::max(damping / 10.0, 1e-12);
    } else {
      damping *= 10.0;
    }
    // Beyond that damping no lower cost is to be had in doubles.
    if (move.size < kRest || damping > 1e12) {
      polish(samples, now, p);
      return true;
    }
  }
  return false;
}

/// H⁻¹BH⁻¹ with H = JᵀWJ and B = JᵀW²J, for weights that are no inverse variances.
Matrix covariance_of(Samples& samples, const Parameters& p) {
  Matrix h = Matrix::Zero();
  Matrix b = Matrix::Zero();
  samples.visit(p, [&](double weight, double, const Parameters& slopes) {
    add_square(h, slopes, weight);
    add_square(b, slopes, weight * weight);
  });
  h = h.selfadjointView<Eigen::Lower>();
  b = b.selfadjointView<Eigen::Lower>();
  if (exponent_bound(p)) {
    h.row(kExponent).setZero();
    h.col(kExponent).setZero();
    h(kExponent, kExponent) = 1.0;
    b.row(kExponent).setZero();
    b.col(kExponent).setZero();
  }
  // The exponent's slopes go with δ²: scaled to a unit diagonal the matrix is as regular as any.
  const Parameters scale = h.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Matrix scaled = scale.asDiagonal() * h * scale.asDiagonal();
  const Matrix inverse =
      scale.asDiagonal() * scaled.ldlt().solve(Matrix::Identity()) * scale.asDiagonal();
  return inverse * b * inverse.transpose() / samples.samples();
}

/// Amplitude, frequency and decay of the two halves, as a start.
Parameters start(const WindowNodes& nodes, double scale) {
  const double h = nodes.length() / 2.0;
  const double omega = nodes.strongest();
  const std::complex<double> first = nodes.half_transform(0, omega);
  const std::complex<double> second = nodes.half_transform(1, omega);
  const std::complex<double> whole = nodes.transform(nodes.values(), omega);
  // The halves' centres lie h apart.
  const double turn = std::arg(second * std::conj(first));
  const double ratio = std::abs(first) / std::max(std::abs(second), 1e-300);
  Parameters p;
  p << std::log(std::max(2.0 * std::abs(whole) / scale, 1e-300)),
      std::clamp(std::log(std::max(ratio, 1e-300)), -3.0, 3.0), 0.3, std::arg(whole),
      omega * h + turn, 0.0, 0.0;
  clamp_exponent(p);
  return p;
}

/// What a fit leaves of a window.
class Residual {
 public:
  Residual(const TaperedWindow& window, const WindowNodes& nodes,
           std::vector<std::complex<double>> values)
      : window_(window), nodes_(nodes), values_(std::move(values)) {}

  /// Far from the mode, where the nodes do not reach, the taper has suppressed the mode itself.
  [[nodiscard]] std::complex<double> transform(double omega) const {
    return nodes_.holds(omega) ? nodes_.transform(values_, omega) : window_.transform(omega);
  }
  [[nodiscard]] double noise_gain() const { return window_.noise_gain(); }
  /// Variance of a sample by all that the fit leaves, other modes included, over its degrees of
  /// freedom; infinite where it has none left.
  [[nodiscard]] double mean_square() const {
    const double freedom = 1.0 - kParameters * noise_gain();
    if (!(freedom > 0.0)) return HUGE_VAL;
    double squares = 0.0;
    double weights = 0.0;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      squares += nodes_.weight(i) * std::norm(values_[i]);
      weights += nodes_.weight(i);
    }
    return squares / weights / freedom;
  }
  [[nodiscard]] double length() const { return window_.length(); }

 private:
  const TaperedWindow& window_;
  const WindowNodes& nodes_;
  std::vector<std::complex<double>> values_;
};

/// Mean square of the noise from the residual beside the mode, outside of the fit and of known
/// modes. The lower quartile keeps unknown ones among the lines from counting.
double noise_beside(const Residual& residual, double rate, double omega,
                    std::span<const SpectralPeak> others) {
  constexpr double kNear = 3.5;  // lines: where the taper lets another mode through
  const double line = 2.0 * std::numbers::pi / residual.length();
  const auto usable = [&](double at) {
    return at > 2.0 * line && at < 0.9 * std::numbers::pi * rate &&
           std::ranges::none_of(others, [&](const SpectralPeak& other) {
             return std::abs(2.0 * std::numbers::pi * other.frequency - at) < kNear * line;
           });
  };
  std::vector<double> power;
  for (int k = 4; k <= 16; ++k) {
    for (const double at : {omega - k * line, omega + k * line}) {
      if (usable(at)) power.push_back(std::norm(residual.transform(at)));
    }
  }
  if (power.empty()) {
    return others.empty() ? residual.mean_square() : noise_beside(residual, rate, omega, {});
  }
  const std::size_t rank = power.size() / 4;
  std::ranges::nth_element(power, power.begin() + static_cast<std::ptrdiff_t>(rank));
  // Mean of that order statistic of as many exponential variables of mean 1.
  double mean = 0.0;
  for (std::size_t i = 0; i <= rank; ++i) mean += 1.0 / static_cast<double>(power.size() - i);
  return power[rank] / mean / residual.noise_gain();
}

std::vector<BesideMode> modes_beside(const Residual& residual, const DecayWindow& found,
                                     std::span<const SpectralPeak> others) {
  constexpr double kMeasurable = 4.0;  // lines
  const double two_pi = 2.0 * std::numbers::pi;
  std::vector<BesideMode> beside;
  for (const SpectralPeak& other : others) {
    const double distance = std::abs(other.frequency - found.omega / two_pi);
    const double height = 2.0 * std::abs(residual.transform(two_pi * other.frequency));
    const bool measurable = distance * found.length >= kMeasurable;
    beside.push_back({distance, measurable ? height / found.amplitude : other.height});
  }
  return beside;
}

}  // namespace

double relative_leakage(const DecayWindow& window) {
  return decay_leakage(window.beside, window.length) / (std::abs(window.decay) * window.length);
}

namespace {

/// The fitted parameters of a window.
struct WindowFit {
  TaperedWindow window;
  WindowNodes nodes;
  double scale;
  Parameters p;
  DecayWindow found;
};

std::optional<WindowFit> fit_parameters(std::span<const double> signal, double rate, double centre,
                                        double length, double from, double to) {
  const double two_pi = 2.0 * std::numbers::pi;
  const TaperedWindow window(signal, rate, centre, length);
  WindowFit fit{.window = window,
                .nodes = WindowNodes(window, two_pi * from, two_pi * to),
                .scale = window.largest(),
                .p = Parameters::Zero(),
                .found = {}};
  // Of fewer samples the model explains the noise, too.
  constexpr std::size_t kFewestSamples = 3 * kParameters;
  if (!(fit.scale > 0.0) || window.size() < kFewestSamples) return std::nullopt;
  Samples samples(fit.nodes, fit.scale);
  fit.p = start(fit.nodes, fit.scale);
  if (!minimise(samples, fit.p)) return std::nullopt;
  const double h = length / 2.0;
  fit.found = {.centre = centre,
               .length = length,
               .amplitude = std::exp(fit.p[0]) * fit.scale,
               .decay = fit.p[1] / h,
               .exponent = fit.p[kExponent],
               .omega = fit.p[4] / h,
               .chirp = fit.p[5] / (h * h),
               .beside = {}};
  const double line = two_pi / length;
  const double omega = fit.found.omega;
  const double highest = std::min(two_pi * to + line, std::numbers::pi * rate);
  if (!(omega > two_pi * from - line && omega < highest)) return std::nullopt;
  if (!std::isfinite(fit.found.amplitude)) return std::nullopt;
  return fit;
}

}  // namespace

std::optional<DecayWindow> fit_decay_values(std::span<const double> signal, double rate,
                                            double centre, double length, double from, double to) {
  std::optional<WindowFit> fit = fit_parameters(signal, rate, centre, length, from, to);
  if (!fit) return std::nullopt;
  return std::move(fit->found);
}

std::optional<DecayWindow> fit_decay_window(std::span<const double> signal, double rate,
                                            double centre, double length, double from, double to,
                                            std::span<const SpectralPeak> others) {
  std::optional<WindowFit> fit = fit_parameters(signal, rate, centre, length, from, to);
  if (!fit) return std::nullopt;
  DecayWindow& found = fit->found;
  const double h = length / 2.0;
  Samples samples(fit->nodes, fit->scale);
  const Eigen::Vector4d unit(1.0, 1.0 / h, 1.0 / h, 1.0 / (h * h));
  const Matrix all = covariance_of(samples, fit->p) / (fit->scale * fit->scale);
  constexpr int kKept[] = {0, 1, 4, 5};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j)
      found.covariance(i, j) = unit[i] * all(kKept[i], kKept[j]) * unit[j];
  }
  const Residual residual(fit->window, fit->nodes, samples.residual(fit->p));
  found.noise_variance = noise_beside(residual, rate, found.omega, others);
  found.beside = modes_beside(residual, found, others);
  if (!found.covariance.allFinite()) return std::nullopt;
  return std::move(found);
}

}  // namespace microslip
