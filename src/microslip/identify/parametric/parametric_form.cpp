// SPDX-License-Identifier: MIT
#include "microslip/identify/parametric/parametric_form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "microslip/identify/smoothing/infinity.hpp"
#include "microslip/joint/dissipation.hpp"

namespace microslip {
namespace {

using Vector = std::vector<double>;

/// Past these a coordinate stands at its bound to all digits.
constexpr double kFarthest = 30.0;

/// Scales of a joint from the levels.
struct Range {
  double stiffness;   ///< N/m
  double amplitude;   ///< A_max, m
  double loss;        ///< D at A_max, J
  Vector amplitudes;  ///< rising, m

  Range(const Levels& levels, double k) : stiffness(k), amplitudes(levels.amplitude) {
    std::ranges::sort(amplitudes);
    const auto last = std::ranges::max_element(levels.amplitude) - levels.amplitude.begin();
    amplitude = levels.amplitude[static_cast<std::size_t>(last)];
    loss = levels.dissipation[static_cast<std::size_t>(last)];
  }

  [[nodiscard]] double force() const { return stiffness * amplitude; }
};

/// q = ψ_max [m], χ, β. In ψ_max rather than F_S the share of the power law is 1/(1 + β) whatever
/// the rest: F_S = K_T ψ_max (β + (χ+1)/(χ+2))/(1 + β).
class FourParameterForm final : public ParametricForm {
 public:
  explicit FourParameterForm(const Range& range) : range_(range) {}

  [[nodiscard]] std::vector<Name> names() const override {
    return {{"macroslip_force", "N"}, {"chi", "1"}, {"beta", "1"}};
  }

  [[nodiscard]] std::vector<Coordinate> coordinates() const override {
    return {{0.0, kInfinity, range_.amplitude, false, false},
            {-1.0, 0.0, 1.0, false, true},
            {0.0, kInfinity, 1.0, true, false}};
  }

  [[nodiscard]] Joint joint(std::span<const double> q) const override {
    const Vector p = parameters(q);
    return Joint::four_parameter(p[0], range_.stiffness, p[1], p[2]);
  }

  [[nodiscard]] Vector parameters(std::span<const double> q) const override {
    const double c = (q[1] + 1.0) / (q[1] + 2.0);
    return {range_.stiffness * q[0] * (q[2] + c) / (1.0 + q[2]), q[1], q[2]};
  }

  [[nodiscard]] std::vector<Vector> grid() const override {
    std::vector<Vector> result;
    for (const double chi : {-0.9, -0.7, -0.5, -0.3, -0.1}) {
      for (const double beta : {0.05, 0.5, 3.0}) {
        for (const double share : {0.1, 0.3, 0.6, 0.85, 1.05, 1.5, 3.0}) {
          result.push_back({share * range_.amplitude, chi, beta});
        }
        if (range_.loss > 0.0) result.push_back({reach_by_loss(chi, beta), chi, beta});
      }
    }
    return result;
  }

  /// At the atom D has a corner: as ψ_max passes a level the sum of squares may have a minimum on
  /// either side. One start between any two levels, with the power law below it unchanged.
  [[nodiscard]] std::vector<Vector> neighbours(std::span<const double> q) const override {
    std::vector<Vector> result;
    for (std::size_t i = 0; i + 1 < range_.amplitudes.size(); ++i) {
      const double psi = 0.5 * (range_.amplitudes[i] + range_.amplitudes[i + 1]);
      const double share = std::pow(psi / q[0], q[1] + 1.0) / (1.0 + q[2]);
      result.push_back({psi, q[1], std::max(1.0 / share - 1.0, 1e-3)});
    }
    return result;
  }

  [[nodiscard]] std::vector<Warning> limits(std::span<const double> q) const override {
    const double psi = q[0];
    const double a = range_.amplitude;
    if (psi <= a) return {};
    // The same power law may end anywhere between A_max and where it contains all the stiffness,
    // with the rest of the stiffness in the atom.
    const double p = q[1] + 1.0;
    const double share = 1.0 / (1.0 + q[2]);  // of the power law, at ψ_max
    const double share_at_a = share * std::pow(a / psi, p);
    const double least = range_.stiffness * a * (share_at_a * p / (p + 1.0) + (1.0 - share_at_a));
    const double farthest = psi * std::pow(1.0 / share, 1.0 / p);
    const double most = range_.stiffness * farthest * p / (p + 1.0);
    return {{"macroslip_not_reached",
             fmt::format(
                 "the fit puts macro-slip at {:.4g} m, beyond the largest amplitude {:.4g} m; "
                 "there the levels determine nothing: macroslip_force from {:.4g} to {:.4g} N fits "
                 "them equally well, each with a beta of its own. Measure up to macro-slip.",
                 psi, a, std::min(least, most), std::max(least, most))}};
  }

 private:
  /// ψ_max beyond A_max with the measured loss at A_max: D =
  /// 4K_T(χ+1)A^{χ+3}/((1+β)(χ+2)(χ+3)ψ_max^{χ+1}).
  [[nodiscard]] double reach_by_loss(double chi, double beta) const {
    const double a = range_.amplitude;
    const double scale = 4.0 * range_.stiffness * (chi + 1.0) * a * a /
                         ((1.0 + beta) * (chi + 2.0) * (chi + 3.0) * range_.loss);
    return a * std::clamp(std::pow(scale, 1.0 / (chi + 1.0)), 1e-6, 1e9);
  }

  Range range_;
};

/// q = area up to f_d were the power law not cut, χ. Both without an admissible bound.
class PowerLawForm final : public ParametricForm {
 public:
  explicit PowerLawForm(const Range& range) : range_(range) {}

  [[nodiscard]] std::vector<Name> names() const override {
    return {{"coefficient", "N^-(1+exponent)"}, {"exponent", "1"}};
  }

  [[nodiscard]] std::vector<Coordinate> coordinates() const override {
    return {{0.0, kInfinity, 1.0, false, false}, {-1.0, kInfinity, 1.0, false, false}};
  }

  [[nodiscard]] Joint joint(std::span<const double> q) const override {
    const Vector p = parameters(q);
    const double cut = q[0] > 1.0 ? std::pow(q[0], -1.0 / (p[1] + 1.0)) : 1.0;
    return Joint(range_.stiffness,
                 SlipDensity({PowerLawPart{p[0], p[1], 0.0, cut * range_.force()}}));
  }

  [[nodiscard]] Vector parameters(std::span<const double> q) const override {
    return {q[0] * (q[1] + 1.0) / std::pow(range_.force(), q[1] + 1.0), q[1]};
  }

  [[nodiscard]] std::vector<Vector> grid() const override {
    std::vector<Vector> result;
    for (const double chi : {-0.9, -0.75, -0.6, -0.45, -0.3, -0.15, 0.01, 0.3, 0.7, 1.5}) {
      for (const double area : {0.3, 1.0, 3.0, 30.0}) result.push_back({area, chi});
      // D(A_max) = 4kA²(χ+1)/((χ+2)(χ+3)) times the area as long as that is below 1
      const double of_one =
          4.0 * range_.force() * range_.amplitude * (chi + 1.0) / ((chi + 2.0) * (chi + 3.0));
      result.push_back({std::clamp(range_.loss / of_one, 1e-6, 1e6), chi});
    }
    return result;
  }

  [[nodiscard]] std::vector<Vector> neighbours(std::span<const double> /*q*/) const override {
    return {};
  }

  [[nodiscard]] std::vector<Warning> limits(std::span<const double> /*q*/) const override {
    return {};
  }

 private:
  Range range_;
};

/// q = weight, upper end [N].
class UniformForm final : public ParametricForm {
 public:
  explicit UniformForm(const Range& range) : range_(range) {}

  [[nodiscard]] std::vector<Name> names() const override { return {{"weight", "1"}, {"to", "N"}}; }

  [[nodiscard]] std::vector<Coordinate> coordinates() const override {
    return {{0.0, 1.0, 1.0, false, true}, {0.0, range_.force(), 1.0, false, true}};
  }

  [[nodiscard]] Joint joint(std::span<const double> q) const override {
    return Joint(range_.stiffness, SlipDensity({UniformPart{0.0, q[1], q[0]}}));
  }

  [[nodiscard]] Vector parameters(std::span<const double> q) const override {
    return {q.begin(), q.end()};
  }

  [[nodiscard]] std::vector<Vector> grid() const override {
    std::vector<Vector> result;
    for (const double share : {0.03, 0.1, 0.2, 0.4, 0.6, 0.8, 0.95}) {
      const double to = share * range_.force();
      for (const double weight : {0.03, 0.3, 0.9}) result.push_back({weight, to});
      const double of_one = dissipation(joint(Vector{1.0, to}), range_.amplitude);
      result.push_back({std::clamp(range_.loss / of_one, 1e-6, 0.98), to});
    }
    return result;
  }

  [[nodiscard]] std::vector<Vector> neighbours(std::span<const double> /*q*/) const override {
    return {};
  }

  [[nodiscard]] std::vector<Warning> limits(std::span<const double> q) const override {
    if (q[1] < range_.force()) return {};
    return {{"macroslip_not_reached",
             fmt::format(
                 "slip has not ended at the largest amplitude {:.4g} m: the levels determine only "
                 "weight/to = {:.4g} 1/N; to = {:.4g} N is the largest slip force reached.",
                 range_.amplitude, q[0] / q[1], q[1])}};
  }

 private:
  Range range_;
};

}  // namespace

double Coordinate::value(double u) const {
  const double reach = std::clamp(u, -kFarthest, kFarthest);
  if (upper == kInfinity) return lower + scale * std::exp(reach);
  // From the nearer bound, which keeps the digits of the distance to it.
  const double share = 1.0 / (1.0 + std::exp(std::abs(reach)));
  return reach < 0.0 ? lower + (upper - lower) * share : upper - (upper - lower) * share;
}

double Coordinate::inverse(double q) const {
  if (upper == kInfinity) return std::log((q - lower) / scale);
  return std::log((q - lower) / (upper - q));
}

std::unique_ptr<ParametricForm> make_parametric_form(ParametricModel model, const Levels& levels,
                                                     double stiffness) {
  const Range range(levels, stiffness);
  switch (model) {
    case ParametricModel::kPowerLaw:
      return std::make_unique<PowerLawForm>(range);
    case ParametricModel::kUniform:
      return std::make_unique<UniformForm>(range);
    case ParametricModel::kFourParameter:
      break;
  }
  return std::make_unique<FourParameterForm>(range);
}

}  // namespace microslip
