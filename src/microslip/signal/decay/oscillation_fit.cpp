// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/oscillation_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "microslip/algebra/cholesky.hpp"

namespace microslip {
namespace {

using Complex = std::complex<double>;

double polynomial(std::span<const double> coefficients, double s) {
  double sum = 0.0;
  for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * s + coefficients[i];
  return sum;
}

/// δ(x) and ω(x) − ω₀ by the parameters of a model, in units of the mean decay rate; x = ln A less
/// that of the first value.
struct ModeCourse {
  OscillationModel model;
  std::span<const double> p;
  double fall;

  [[nodiscard]] double share(double x) const { return std::clamp(-x / fall, 0.0, 1.0); }
  [[nodiscard]] double decay(double x) const {
    constexpr double kLargest = 6.0;  // of |ln δ|: no course falls so fast or slowly
    const double sum = polynomial(p.first(static_cast<std::size_t>(model.decays)), share(x));
    return model.joint ? std::exp(std::clamp(sum, -kLargest, kLargest)) : sum;
  }
  [[nodiscard]] double omega(double x) const {
    const auto own =
        p.subspan(static_cast<std::size_t>(model.decays), static_cast<std::size_t>(model.omegas));
    if (!model.joint) return polynomial(own, share(x));
    const double power = std::exp(std::clamp(own[3], 0.05, 4.0) * std::min(x, 0.0));
    return own[0] - own[1] * power - own[2] * power * power;
  }
};

/// ẋ = −δ(x), θ̇ = ω(x), in steps of Runge and Kutta.
struct CourseStep {
  const ModeCourse& course;
  double unit;  ///< mean decay rate, 1/s

  void operator()(double& x, double& theta, double h) const {
    const auto rate = [&](double at) { return -unit * course.decay(at); };
    const auto turn = [&](double at) { return unit * course.omega(at); };
    constexpr double kFarthest = 30.0;  // of ln A: beyond it no course is a decay
    const double a = rate(x);
    const double b = rate(x + 0.5 * h * a);
    const double c = rate(x + 0.5 * h * b);
    const double d = rate(x + h * c);
    const double middle = x + 0.5 * h * b;
    const double end = std::clamp(x + h * (a + 2.0 * b + 2.0 * c + d) / 6.0, -kFarthest, 5.0);
    theta += h * (turn(x) + 4.0 * turn(middle) + turn(end)) / 6.0;
    x = end;
  }
};

ModeCourse mode_course_of(const OscillationModel& model, const Eigen::VectorXd& p,
                          const Baseband& band) {
  return {model, std::span(p.data(), static_cast<std::size_t>(model.of_mode())), band.fall};
}

}  // namespace

double Baseband::independent() const {
  // Independent values of white noise over a window's length: 1/(T Σw²/(Σw)²) of cos⁴ is 1.94.
  constexpr double kFreedom = 1.94;
  return 2.0 * kFreedom * static_cast<double>(value.size()) * hop / length;
}

double OscillationFit::first_decay(const Eigen::VectorXd& p) const {
  return band_.decay * mode_course_of(model_, p, band_).decay(0.0);
}

double OscillationFit::first_omega(const Eigen::VectorXd& p) const {
  return band_.decay * mode_course_of(model_, p, band_).omega(0.0);
}

double OscillationFit::second_omega(const Eigen::VectorXd& p) const {
  return p[model_.of_mode()] * band_.decay;
}

double OscillationFit::second_decay(const Eigen::VectorXd& p) const {
  return model_.steady ? 0.0 : p[model_.of_mode() + 1] * band_.decay;
}

Eigen::VectorXcd OscillationFit::mode(const Eigen::VectorXd& p) const {
  const ModeCourse course = mode_course_of(model_, p, band_);
  const CourseStep step{course, band_.decay};
  Eigen::VectorXcd history(band_.value.size());
  double x = 0.0;
  double theta = 0.0;
  for (Complex& each : history) {
    each = std::polar(std::exp(x), theta);
    step(x, theta, band_.hop);
  }
  return history;
}

Eigen::VectorXcd OscillationFit::second(double omega, double decay) const {
  constexpr double kLargest = 1e6;  // a larger growth is no oscillation beside the mode
  Eigen::VectorXcd history(band_.value.size());
  const Complex step = std::exp(Complex(-decay, omega) * band_.hop);
  Complex value = 1.0;
  for (Complex& each : history) {
    each = value;
    value *= step;
    if (std::norm(value) > kLargest * kLargest) value = kLargest;
  }
  return history;
}

Eigen::VectorXd OscillationFit::residual(const Eigen::VectorXd& p) {
  return residual_of(mode(p),
                     model_.second ? second(second_omega(p), second_decay(p)) : Eigen::VectorXcd());
}

Eigen::VectorXd OscillationFit::residual_of(const Eigen::VectorXcd& mode,
                                            const Eigen::VectorXcd& beside) {
  const Eigen::VectorXcd y = band_.value.cwiseProduct(band_.root);
  const Eigen::VectorXcd a = mode.cwiseProduct(band_.root);
  const double own = a.squaredNorm();
  first_ = a.dot(y) / own;
  Eigen::VectorXcd rest = y - first_ * a;
  if (beside.size() > 0) {
    // Gram–Schmidt.
    Eigen::VectorXcd b = beside.cwiseProduct(band_.root);
    const Complex along = a.dot(b) / own;
    const double whole = b.squaredNorm();
    b -= along * a;
    const double left = b.squaredNorm();
    constexpr double kSame = 1e-12;
    second_ = left > kSame * whole ? Complex(b.dot(rest) / left) : Complex(0.0);
    rest -= second_ * b;
    first_ -= second_ * along;
  }
  const Eigen::Index n = rest.size();
  Eigen::VectorXd both(2 * n);
  both.head(n) = rest.real();
  both.tail(n) = rest.imag();
  chi_square_ = both.squaredNorm() * band_.independent() / (2.0 * static_cast<double>(n));
  return both;
}

bool OscillationFit::minimise(Eigen::VectorXd& p) {
  constexpr int kMostSteps = 80;
  constexpr double kRest = 1e-7;   // of a step, over the mean decay rate
  constexpr double kFlat = 1e-9;   // of the sum of squares
  constexpr double kStiff = 1e10;  // damping beyond which no lower sum is to be had
  double damping = 1e-3;
  Eigen::VectorXd now = residual(p);
  double cost = now.squaredNorm();
  bool rests = false;
  for (int i = 0; i < kMostSteps && !rests; ++i) {
    const Eigen::MatrixXd slopes = jacobian(p, now);
    const Eigen::MatrixXd normal = slopes.transpose() * slopes;
    const Eigen::VectorXd gradient = slopes.transpose() * now;
    rests = true;
    for (; damping < kStiff; damping *= 10.0) {
      Eigen::MatrixXd damped = normal;
      damped.diagonal() *= 1.0 + damping;
      damped.diagonal().array() += 1e-12 * normal.diagonal().maxCoeff() + 1e-300;
      const Eigen::VectorXd step = damped.ldlt().solve(gradient);
      const Eigen::VectorXd to = p - step;
      const Eigen::VectorXd there = residual(to);
      const double next = there.squaredNorm();
      if (!(next < cost)) continue;
      rests = step.lpNorm<Eigen::Infinity>() < kRest || cost - next < kFlat * next;
      p = to;
      now = there;
      cost = next;
      damping = std::max(damping / 10.0, 1e-9);
      break;
    }
  }
  (void)residual(p);
  return rests && std::isfinite(chi_square_);
}

Eigen::MatrixXd OscillationFit::jacobian(const Eigen::VectorXd& p, const Eigen::VectorXd& now) {
  constexpr double kStep = 1e-6;
  Eigen::MatrixXd slopes(now.size(), p.size());
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    Eigen::VectorXd moved = p;
    moved[i] += kStep;
    slopes.col(i) = (residual(moved) - now) / kStep;
  }
  return slopes;
}

}  // namespace microslip
