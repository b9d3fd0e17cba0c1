// SPDX-License-Identifier: MIT
#include "microslip/rig/setup/modal_observer.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "microslip/algebra/core.hpp"
#include "microslip/base/error.hpp"

namespace microslip {
namespace {

using Complex = std::complex<double>;
using RowVector = Eigen::RowVectorXd;

/// Where the accelerometers hardly show the joint in a harmonic, noise would become a large g: g is
/// damped below this share of their motion without cancellation. Above it g is that of least
/// squares without a bias, for close to a resonance ψ g all but cancels φ(S) F: a millionth of it
/// would be much of the motion.
constexpr double kLeastVisible = 1e-3;

/// Without loss, a mode at its own frequency would move without a bound. Closer to it, as a share
/// of ω_i², the frequency is taken as this far off: g absorbs the change of the force.
constexpr double kLeastDetuning = 1e-10;

/// The shortening is a small correction; each pass gains some two digits.
constexpr int kShorteningPasses = 4;

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Eigen::RowVectorXcd harmonics_of(const FourierSeries& series, Eigen::Index count) {
  Eigen::RowVectorXcd harmonics(count);
  for (Eigen::Index n = 0; n < count; ++n) harmonics[n] = series.c(static_cast<std::size_t>(n) + 1);
  return harmonics;
}

Complex receptance_of(double omega_square, double loss_factor, double frequency) {
  const Complex stiffness(omega_square - frequency * frequency, loss_factor * omega_square);
  const double least = kLeastDetuning * omega_square;
  return 1.0 / (std::abs(stiffness) < least ? Complex(least) : stiffness);
}

FourierSeries series_of(const Eigen::RowVectorXcd& harmonics, double omega) {
  FourierSeries series;
  series.omega = omega;
  series.harmonic.assign(harmonics.begin(), harmonics.end());
  return series;
}

}  // namespace

/// Tables that do not change from cycle to cycle. Columns are harmonics.
struct ModalObserver::Tables {
  double omega = 0.0;
  Eigen::Index harmonics = 0;
  Eigen::VectorXd excitation;
  Eigen::VectorXd joint;
  Eigen::MatrixXd accelerometer;  ///< sensor × mode
  Eigen::MatrixXd shortening;     ///< Γ; empty without one
  double stiffness = 0.0;
  double axial_compliance = 0.0;
  Eigen::MatrixXcd receptance;  ///< mode × n: 1/[ω_i²(1 + iη_i) − (nω)²]
  Eigen::MatrixXcd visible;     ///< sensor × n: displacement there per g_n
  RowVector least_size;         ///< n: below it Σ_j |visible|² counts as this
  RowVector to_displacement;    ///< n: −1/(nω)²
  Eigen::MatrixXcd wave;        ///< n × point: e^{inωt} over one period

  Tables(const StickState& state, double omega, std::size_t harmonics);

  void set_visible();
  void set_wave();
  [[nodiscard]] Eigen::RowVectorXcd joint_load(const Eigen::MatrixXcd& displacement,
                                               const Eigen::MatrixXcd& known) const;
  /// Values over the period of harmonics, and back; a row each.
  [[nodiscard]] Eigen::MatrixXd over_time(const Eigen::MatrixXcd& harmonic) const {
    return (harmonic * wave).real();
  }
  [[nodiscard]] Eigen::MatrixXcd harmonics_over(const Eigen::MatrixXd& values) const {
    return values * wave.adjoint() * (2.0 / static_cast<double>(wave.cols()));
  }
};

ModalObserver::Tables::Tables(const StickState& state, double omega_of_cycle, std::size_t count)
    : omega(omega_of_cycle),
      harmonics(static_cast<Eigen::Index>(count)),
      excitation(vector_of(state.excitation)),
      joint(vector_of(state.joint)),
      stiffness(state.stiffness),
      axial_compliance(state.axial_compliance) {
  const auto modes = static_cast<Eigen::Index>(state.modes());
  accelerometer.resize(static_cast<Eigen::Index>(state.accelerometer.size()), modes);
  for (Eigen::Index j = 0; j < accelerometer.rows(); ++j) {
    accelerometer.row(j) = vector_of(state.accelerometer[static_cast<std::size_t>(j)]);
  }
  if (!state.shortening.empty()) {
    shortening = Eigen::Map<const Eigen::MatrixXd>(state.shortening.data(), modes, modes);
  }
  receptance.resize(modes, harmonics);
  to_displacement.resize(harmonics);
  for (Eigen::Index n = 0; n < harmonics; ++n) {
    const double frequency = static_cast<double>(n + 1) * omega;
    to_displacement[n] = -1.0 / (frequency * frequency);
    for (Eigen::Index i = 0; i < modes; ++i) {
      const auto mode = static_cast<std::size_t>(i);
      const double square = state.omega[mode] * state.omega[mode];
      receptance(i, n) = receptance_of(square, state.loss_factor[mode], frequency);
    }
  }
  set_visible();
  set_wave();
}

void ModalObserver::Tables::set_visible() {
  const Eigen::MatrixXd shapes = accelerometer * joint.asDiagonal();
  visible = shapes * receptance;
  const Eigen::MatrixXd uncancelled = shapes.cwiseAbs() * receptance.cwiseAbs();
  least_size = kLeastVisible * kLeastVisible * uncancelled.colwise().squaredNorm();
}

/// Enough points for a product of two series to be right up to harmonic H.
void ModalObserver::Tables::set_wave() {
  const Eigen::Index points = 4 * harmonics + 4;
  wave.resize(harmonics, points);
  for (Eigen::Index n = 0; n < harmonics; ++n) {
    for (Eigen::Index p = 0; p < points; ++p) {
      const auto turns = static_cast<double>((n + 1) * p % points) / static_cast<double>(points);
      wave(n, p) = std::polar(1.0, 2.0 * std::numbers::pi * turns);
    }
  }
}

/// g_n by least squares. @param known  mode × n: the modal forces other than ψ g.
Eigen::RowVectorXcd ModalObserver::Tables::joint_load(const Eigen::MatrixXcd& displacement,
                                                      const Eigen::MatrixXcd& known) const {
  const Eigen::MatrixXcd unexplained =
      displacement - accelerometer * known.cwiseProduct(receptance);
  const Eigen::RowVectorXcd match = visible.conjugate().cwiseProduct(unexplained).colwise().sum();
  const RowVector size = visible.colwise().squaredNorm().cwiseMax(least_size);
  return match.cwiseQuotient(size.cast<Complex>());
}

ModalObserver::ModalObserver(const StickState& state, double omega, std::size_t harmonics) {
  if (!(omega > 0.0)) throw InputError("omega", omega, "must be above 0");
  if (harmonics == 0) throw InputError("harmonics", 0.0, "must be 1 or more");
  tables_ = std::make_unique<const Tables>(state, omega, harmonics);
  if (!(tables_->least_size.minCoeff() > 0.0)) {
    throw InputError(
        "accelerometer", "at rest when the joint moves",
        "must be where one mode at least has a shape that is not 0, as it must have at "
        "the joint");
  }
}

ModalObserver::~ModalObserver() = default;
ModalObserver::ModalObserver(ModalObserver&&) noexcept = default;
ModalObserver& ModalObserver::operator=(ModalObserver&&) noexcept = default;

ModalMotion ModalObserver::observe(const FourierSeries& force,
                                   std::span<const FourierSeries> accelerations) const {
  const Tables& t = *tables_;
  if (static_cast<Eigen::Index>(accelerations.size()) != t.accelerometer.rows()) {
    throw InputError("accelerations", static_cast<double>(accelerations.size()),
                     "must be as many as the rig has accelerometers");
  }
  if (force.omega != t.omega) {
    throw InputError("omega of the force", force.omega, "must be that of the observer");
  }
  Eigen::MatrixXcd displacement(t.accelerometer.rows(), t.harmonics);
  for (Eigen::Index j = 0; j < displacement.rows(); ++j) {
    displacement.row(j) = harmonics_of(accelerations[static_cast<std::size_t>(j)], t.harmonics)
                              .cwiseProduct(t.to_displacement.cast<Complex>());
  }
  const Eigen::MatrixXcd exciting = t.excitation * harmonics_of(force, t.harmonics);
  Eigen::MatrixXcd known = exciting;
  Eigen::RowVectorXcd load;
  Eigen::MatrixXcd modal;
  Eigen::RowVectorXcd rotation;
  Eigen::RowVectorXcd tension;  // N
  Eigen::RowVectorXcd kinematic;
  ModalMotion result;
  const int passes = t.shortening.size() > 0 ? kShorteningPasses : 1;
  for (int pass = 0; pass < passes; ++pass) {
    load = t.joint_load(displacement, known);
    modal = (known + t.joint * load).cwiseProduct(t.receptance);
    rotation = t.joint.transpose() * modal;
    tension = load - t.stiffness * rotation;
    kinematic = rotation + t.axial_compliance * tension;
    if (t.shortening.size() == 0) break;
    const Eigen::MatrixXd motion = t.over_time(modal);
    const Eigen::MatrixXd slopes = t.shortening * motion;  // Γ q
    const RowVector pull = t.over_time(tension);
    known = exciting - t.harmonics_over(slopes * pull.asDiagonal());
    const RowVector shortening = -0.5 * motion.cwiseProduct(slopes).colwise().sum();
    kinematic += t.harmonics_over(shortening);
    result.mean_shortening = shortening.mean();
  }

  for (Eigen::Index i = 0; i < modal.rows(); ++i) {
    result.modal.push_back(series_of(modal.row(i), t.omega));
  }
  result.rotation = series_of(rotation, t.omega);
  result.kinematic = series_of(kinematic, t.omega);
  result.joint_force = series_of(-tension, t.omega);
  result.softening = (load[0] / rotation[0]).real();
  const Eigen::MatrixXcd left = displacement - t.accelerometer * modal;
  for (Eigen::Index j = 0; j < left.rows(); ++j) {
    result.misfit.push_back(left.row(j).norm() / displacement.row(j).norm());
  }
  return result;
}

}  // namespace microslip
