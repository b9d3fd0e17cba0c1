// SPDX-License-Identifier: MIT
#include "microslip/signal/harmonic/frequency_descent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace microslip {
namespace {

constexpr double kStepInDeviations = 1e-4;
constexpr double kRelativeStep = 1e-13;
constexpr double kLargestStep = 1.0;  // rad at the ends of the record: within the main lobe
constexpr int kHalvings = 12;
/// Steps so small that the linearisation holds and rounding may hide that they lower the loss are
/// taken as they are: below this many standard errors of Ω, or rad at the ends of the record.
constexpr double kTrustedDeviations = 0.1;
constexpr double kTrustedStep = 1e-5;

struct Step {
  double value = 0.0;
  double rounding =
      0.0;  ///< how far rounding may move it, and the phase Ω at the ends of the record
};

Step gauss_newton_step(const HarmonicRegression& regression, const HarmonicFit& fit) {
  const Eigen::ArrayXd squares = regression.floored(fit.squares).array();
  const double curvature = (fit.curvature.array() / squares).sum();
  if (!(curvature > 0.0)) return {};
  const double gradient = (fit.gradient.array() / squares).sum();
  const double rounding = (fit.rounding.array() / squares).sum();
  return {-gradient / curvature,
          rounding / curvature + std::numeric_limits<double>::epsilon() * fit.big_omega};
}

double deviation(const HarmonicRegression& regression, const HarmonicFit& fit) {
  return 1.0 / std::sqrt(information(regression, fit));
}

/// The negligible step: far below the standard error, or below rounding.
double tolerance(const HarmonicRegression& regression, const HarmonicFit& fit, const Step& step) {
  return std::max({kRelativeStep * fit.big_omega, step.rounding,
                   kStepInDeviations * deviation(regression, fit)});
}

/// Takes the step, or the first of its halves that lowers the loss; false where none does.
bool advance(const HarmonicRegression& regression, double step, Descent& state) {
  const double trusted =
      std::max(kTrustedStep, kTrustedDeviations * deviation(regression, state.fit));
  const double before = loss(regression, state.fit);
  for (int i = 0; i < kHalvings; ++i, step *= 0.5) {
    HarmonicFit trial = regression.fit(state.fit.big_omega + step, state.fit.order);
    ++state.iterations;
    if (!trial.determined) continue;
    if (std::abs(step) > trusted && !(loss(regression, trial) < before)) continue;
    state.fit = std::move(trial);
    return true;
  }
  return false;
}

}  // namespace

double loss(const HarmonicRegression& regression, const HarmonicFit& fit) {
  const Eigen::ArrayXd ratio =
      regression.floored(fit.squares).array() / regression.square().array();
  return 0.5 * ratio.log().sum();
}

double information(const HarmonicRegression& regression, const HarmonicFit& fit) {
  const double freedom = static_cast<double>(regression.times().points() - fit.unknowns()) - 1.0;
  return freedom * (fit.curvature.array() / regression.floored(fit.squares).array()).sum();
}

Descent descend(const HarmonicRegression& regression, double big_omega, Eigen::Index order,
                OmegaRange range, int max_iterations) {
  Descent state;
  state.fit = regression.fit(std::clamp(big_omega, range.lowest, range.highest), order);
  state.iterations = 1;
  while (state.fit.determined) {
    const Step wanted = gauss_newton_step(regression, state.fit);
    const double limited = std::clamp(wanted.value, -kLargestStep, kLargestStep);
    const double here = state.fit.big_omega;
    state.step = std::clamp(here + limited, range.lowest, range.highest) - here;
    state.converged = std::abs(wanted.value) <= tolerance(regression, state.fit, wanted);
    if (state.converged || state.step == 0.0 || state.iterations >= max_iterations) break;
    if (!advance(regression, state.step, state)) break;
  }
  return state;
}

}  // namespace microslip
