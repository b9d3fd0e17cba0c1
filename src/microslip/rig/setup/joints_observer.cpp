// SPDX-License-Identifier: MIT
#include "microslip/rig/setup/joints_observer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/algebra/lu.hpp"
#include "microslip/algebra/svd.hpp"
#include "microslip/base/error.hpp"

namespace microslip {
namespace {

using JointsComplex = std::complex<double>;
using Eigen::Index;

/// Noise over what a joint can do, above which a combination of joints is not seen.
constexpr double kLeastSeen = 3.0;

/// Least noise of an accelerometer over the largest of all, where a record has none: that of
/// rounding.
constexpr double kRoundingNoise = 1e-12;

/// Without loss the structure has no response at a natural frequency. This share of the largest
/// stiffness is used as loss there.
constexpr double kLeastLoss = 1e-13;

JointsComplex entry(const FourierSeries& series, Index n) {
  return series.c(static_cast<std::size_t>(n) + 1);
}

FourierSeries empty_series(double omega, Index harmonics) {
  FourierSeries series;
  series.omega = omega;
  series.harmonic.assign(static_cast<std::size_t>(harmonics), 0.0);
  return series;
}

Eigen::VectorXd shape_vector(std::span<const double> shape) {
  return Eigen::Map<const Eigen::VectorXd>(shape.data(), static_cast<Index>(shape.size()));
}

void require_scales(const JointsObserverScales& scales, std::size_t joints, std::size_t sensors,
                    std::size_t harmonics) {
  const auto require = [](bool good, std::string_view name, std::size_t found, std::size_t wanted) {
    if (good) return;
    throw InputError(name, static_cast<double>(found), fmt::format("must be {}", wanted));
  };
  require(scales.force_std.size() == harmonics, "number of force_std", scales.force_std.size(),
          harmonics);
  require(scales.acceleration_std.size() == sensors, "number of acceleration_std",
          scales.acceleration_std.size(), sensors);
  for (const std::vector<double>& std : scales.acceleration_std) {
    require(std.size() == harmonics, "number of acceleration_std[]", std.size(), harmonics);
  }
  require(scales.joint_force.size() == joints, "number of joint_force", scales.joint_force.size(),
          joints);
  for (const double force : scales.joint_force) {
    if (force > 0.0 && std::isfinite(force)) continue;
    throw InputError("joint_force", force, "must be above 0 and finite");
  }
}

}  // namespace

/// Tables that do not change from cycle to cycle.
struct JointsObserver::Tables {
  /// One harmonic: the linear maps from F_n and A_n.
  struct HarmonicTable {
    Eigen::MatrixXcd modal;           ///< mode × (1 + joints): q per F and per h
    Eigen::MatrixXcd acceleration;    ///< sensor × (1 + joints)
    Eigen::MatrixXcd joint_estimate;  ///< joints × sensors: h per A − bF
    Eigen::RowVectorXcd force_step;   ///< 1 × sensors: correction of F, per A − bF
    Eigen::MatrixXcd unseen;          ///< joints × unseen directions, each of size s
  };

  double omega = 0.0;
  Index harmonics = 0;
  Eigen::MatrixXd joints;            ///< mode × joint: Ψ
  Eigen::MatrixXd sensors;           ///< sensor × mode: S
  Eigen::VectorXd excitation;        ///< φ
  Eigen::VectorXd stuck;             ///< k′, one per joint
  Eigen::VectorXd compliance;        ///< c, one per joint
  std::vector<HarmonicTable> table;  ///< one per harmonic
  std::vector<UnseenDirection> unseen;
  std::vector<Index> unseen_column;  ///< of the direction in its table
  JointsObserverScales scales;

  Tables(const JointedStructure& structure, std::span<const std::string> accelerometers,
         double omega_of_cycle, std::size_t count, const JointsObserverScales& given);

  void set_responses(const JointedStructure& structure, HarmonicTable& harmonic, Index n) const;
  void set_estimate(HarmonicTable& harmonic, Index n);
  [[nodiscard]] Eigen::MatrixXcd covariance(const HarmonicTable& harmonic, Index n) const;
  void add_unseen(const Eigen::MatrixXcd& directions, Index n);
  /// @param extra  an unseen direction that is not 0, as a phase factor.
  [[nodiscard]] JointsMotion motion(
      const FourierSeries& force, std::span<const FourierSeries> accelerations,
      std::optional<std::pair<std::size_t, JointsComplex>> extra) const;
  void put(JointsMotion& result, Index n, JointsComplex force,
           const Eigen::VectorXcd& beyond) const;
};

JointsObserver::Tables::Tables(const JointedStructure& structure,
                               std::span<const std::string> accelerometers, double omega_of_cycle,
                               std::size_t count, const JointsObserverScales& given)
    : omega(omega_of_cycle), harmonics(static_cast<Index>(count)), scales(given) {
  const ModalModel& linear = structure.linear();
  const auto modes = static_cast<Index>(linear.size());
  joints.resize(modes, static_cast<Index>(structure.joints().size()));
  stuck.resize(joints.cols());
  compliance.resize(joints.cols());
  for (Index j = 0; j < joints.cols(); ++j) {
    const StructuralJoint& joint = structure.joints()[static_cast<std::size_t>(j)];
    joints.col(j) = shape_vector(joint.shape);
    stuck[j] = joint.stuck_stiffness();
    compliance[j] = joint.series_compliance;
  }
  sensors.resize(static_cast<Index>(accelerometers.size()), modes);
  for (Index s = 0; s < sensors.rows(); ++s) {
    sensors.row(s) = shape_vector(linear.shape(accelerometers[static_cast<std::size_t>(s)]));
  }
  excitation = shape_vector(linear.shape(structure.excitations().front().point));
  for (Index n = 0; n < harmonics; ++n) {
    HarmonicTable& harmonic = table.emplace_back();
    set_responses(structure, harmonic, n);
    set_estimate(harmonic, n);
  }
}

void JointsObserver::Tables::set_responses(const JointedStructure& structure,
                                           HarmonicTable& harmonic, Index n) const {
  const double frequency = static_cast<double>(n + 1) * omega;
  const Index modes = joints.rows();
  Eigen::MatrixXcd stiffness = Eigen::MatrixXcd::Zero(modes, modes);
  double largest = 0.0;
  for (Index i = 0; i < modes; ++i) {
    const Mode& mode = structure.linear().modes()[static_cast<std::size_t>(i)];
    stiffness(i, i) = modal_stiffness(mode, frequency, structure.damping());
    largest = std::max(largest, mode.angular_frequency * mode.angular_frequency);
  }
  for (Index j = 0; j < joints.cols(); ++j) {
    const double added = stuck[j] - structure.joints()[static_cast<std::size_t>(j)].spring_in_modes;
    stiffness += (added * joints.col(j) * joints.col(j).transpose()).cast<JointsComplex>();
  }
  stiffness.diagonal().array() +=
      JointsComplex(0.0, kLeastLoss * std::max(largest, frequency * frequency));
  Eigen::MatrixXcd loads(modes, 1 + joints.cols());
  loads << excitation.cast<JointsComplex>(), joints.cast<JointsComplex>();
  harmonic.modal = stiffness.partialPivLu().solve(loads);
  harmonic.acceleration = -frequency * frequency * (sensors * harmonic.modal);
}

/// Covariance of the residual accelerations: diag(σ_j²) + σ_F² b bᴴ.
Eigen::MatrixXcd JointsObserver::Tables::covariance(const HarmonicTable& harmonic, Index n) const {
  const auto entry_of = static_cast<std::size_t>(n);
  double largest = 0.0;
  for (const std::vector<double>& std : scales.acceleration_std) {
    largest = std::max(largest, std[entry_of]);
  }
  const Eigen::VectorXd sizes = harmonic.acceleration.rightCols(joints.cols()).rowwise().norm();
  const Eigen::Map<const Eigen::VectorXd> forces(scales.joint_force.data(), joints.cols());
  const double least = kRoundingNoise * std::max(largest, sizes.maxCoeff() * forces.maxCoeff());
  const Eigen::VectorXcd b = harmonic.acceleration.col(0);
  const double force_std = scales.force_std[entry_of];
  Eigen::MatrixXcd result = force_std * force_std * b * b.adjoint();
  for (Index s = 0; s < sensors.rows(); ++s) {
    const double std = scales.acceleration_std[static_cast<std::size_t>(s)][entry_of];
    result(s, s) += std * std + least * least;
  }
  return result;
}

void JointsObserver::Tables::set_estimate(HarmonicTable& harmonic, Index n) {
  const Eigen::LLT<Eigen::MatrixXcd> noise(covariance(harmonic, n));
  Eigen::VectorXd most =
      Eigen::Map<const Eigen::VectorXd>(scales.joint_force.data(), joints.cols());
  most /= static_cast<double>(n + 1);
  // Whitened, and in units of what each joint can do.
  const Eigen::MatrixXcd seen_by = harmonic.acceleration.rightCols(joints.cols());
  const Eigen::MatrixXcd whitened =
      noise.matrixL().solve(seen_by) * most.cast<JointsComplex>().asDiagonal();
  const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(whitened, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::VectorXd& sizes = svd.singularValues();
  Index seen = 0;
  while (seen < sizes.size() && sizes[seen] > kLeastSeen) ++seen;
  const Eigen::MatrixXcd scaled_directions =
      most.cast<JointsComplex>().asDiagonal() * svd.matrixV();
  const Eigen::MatrixXcd inverse =
      scaled_directions.leftCols(seen) *
      sizes.head(seen).cwiseInverse().cast<JointsComplex>().asDiagonal() *
      svd.matrixU().leftCols(seen).adjoint();
  const Eigen::MatrixXcd whitening =
      noise.matrixL().solve(Eigen::MatrixXcd::Identity(sensors.rows(), sensors.rows()));
  harmonic.joint_estimate = inverse * whitening;
  const double force_std = scales.force_std[static_cast<std::size_t>(n)];
  const Eigen::VectorXcd weighted = noise.solve(harmonic.acceleration.col(0));
  harmonic.force_step =
      force_std * force_std *
      (weighted.adjoint() * (Eigen::MatrixXcd::Identity(sensors.rows(), sensors.rows()) -
                             seen_by * harmonic.joint_estimate));
  harmonic.unseen = scaled_directions.rightCols(joints.cols() - seen);
  add_unseen(harmonic.unseen, n);
}

void JointsObserver::Tables::add_unseen(const Eigen::MatrixXcd& directions, Index n) {
  for (Index column = 0; column < directions.cols(); ++column) {
    UnseenDirection& direction = unseen.emplace_back();
    direction.harmonic = static_cast<std::size_t>(n) + 1;
    const Eigen::VectorXd shares = directions.col(column).cwiseAbs();
    const double length = shares.norm();
    for (const double share : shares) direction.participant.push_back(share / length);
    unseen_column.push_back(column);
  }
}

/// @param beyond  h_n.
void JointsObserver::Tables::put(JointsMotion& result, Index n, JointsComplex force,
                                 const Eigen::VectorXcd& beyond) const {
  const HarmonicTable& harmonic = table[static_cast<std::size_t>(n)];
  Eigen::VectorXcd loads(1 + beyond.size());
  loads << force, beyond;
  const Eigen::VectorXcd modal = harmonic.modal * loads;
  const Eigen::VectorXcd ends = joints.transpose() * modal;  // with what lies in series
  const auto at = static_cast<std::size_t>(n);
  result.excitation.harmonic[at] = force;
  for (Index i = 0; i < modal.size(); ++i) {
    result.modal[static_cast<std::size_t>(i)].harmonic[at] = modal[i];
  }
  for (Index j = 0; j < beyond.size(); ++j) {
    const JointsComplex restoring = stuck[j] * ends[j] - beyond[j];
    result.force[static_cast<std::size_t>(j)].harmonic[at] = restoring;
    result.displacement[static_cast<std::size_t>(j)].harmonic[at] =
        ends[j] - compliance[j] * restoring;
  }
}

JointsMotion JointsObserver::Tables::motion(
    const FourierSeries& force, std::span<const FourierSeries> accelerations,
    std::optional<std::pair<std::size_t, JointsComplex>> extra) const {
  if (static_cast<Index>(accelerations.size()) != sensors.rows()) {
    throw InputError("accelerations", static_cast<double>(accelerations.size()),
                     fmt::format("must be {}, one per accelerometer", sensors.rows()));
  }
  if (force.omega != omega) {
    throw InputError("omega of the force", force.omega, "must be that of the observer");
  }
  const FourierSeries empty = empty_series(omega, harmonics);
  const auto joint_count = static_cast<std::size_t>(joints.cols());
  JointsMotion result{std::vector(static_cast<std::size_t>(joints.rows()), empty),
                      std::vector(joint_count, empty),
                      std::vector(joint_count, empty),
                      empty,
                      {}};
  Eigen::VectorXd left = Eigen::VectorXd::Zero(sensors.rows());
  Eigen::VectorXd whole = Eigen::VectorXd::Zero(sensors.rows());
  for (Index n = 0; n < harmonics; ++n) {
    const HarmonicTable& harmonic = table[static_cast<std::size_t>(n)];
    Eigen::VectorXcd measured(sensors.rows());
    for (Index s = 0; s < measured.size(); ++s) {
      measured[s] = entry(accelerations[static_cast<std::size_t>(s)], n);
    }
    const JointsComplex drive = entry(force, n);
    const Eigen::VectorXcd unexplained = measured - harmonic.acceleration.col(0) * drive;
    Eigen::VectorXcd beyond = harmonic.joint_estimate * unexplained;
    if (extra && unseen[extra->first].harmonic == static_cast<std::size_t>(n) + 1) {
      beyond += extra->second * harmonic.unseen.col(unseen_column[extra->first]);
    }
    put(result, n, drive + (harmonic.force_step * unexplained).value(), beyond);
    Eigen::VectorXcd loads(1 + beyond.size());
    loads << drive, beyond;
    const Eigen::VectorXcd rest = measured - harmonic.acceleration * loads;
    // Weights of displacements, as for the misfit of one joint.
    const double weight = 1.0 / std::pow(static_cast<double>(n + 1), 4.0);
    left += weight * rest.cwiseAbs2();
    whole += weight * measured.cwiseAbs2();
  }
  for (Index s = 0; s < left.size(); ++s) result.misfit.push_back(std::sqrt(left[s] / whole[s]));
  return result;
}

void check_observable(const JointedStructure& structure, std::size_t accelerometers) {
  if (structure.joints().empty()) {
    throw InputError("joint", InputState{"missing"}, "must be given at least once",
                     "Without a joint there is nothing to identify.");
  }
  for (const StructuralJoint& joint : structure.joints()) {
    if (joint.shortening.empty()) continue;
    throw InputError(fmt::format("shortening of joint '{}'", joint.name), "given",
                     "must not be given: joints with shortening are not observed from a model",
                     "Describe a beam on a rod as a rig with [beam].");
  }
  if (structure.excitations().size() != 1) {
    throw InputError("number of excitations", static_cast<double>(structure.excitations().size()),
                     "must be 1: one force is measured");
  }
  if (accelerometers == 0) {
    throw InputError("accelerometers", "none", "must be at least one");
  }
}

JointsObserver::JointsObserver(const JointedStructure& structure,
                               std::span<const std::string> accelerometers, double omega,
                               std::size_t harmonics, const JointsObserverScales& scales) {
  if (!(omega > 0.0)) throw InputError("omega", omega, "must be above 0");
  if (harmonics == 0) throw InputError("harmonics", 0.0, "must be 1 or more");
  check_observable(structure, accelerometers.size());
  require_scales(scales, structure.joints().size(), accelerometers.size(), harmonics);
  tables_ = std::make_unique<const Tables>(structure, accelerometers, omega, harmonics, scales);
}

JointsObserver::~JointsObserver() = default;
JointsObserver::JointsObserver(JointsObserver&&) noexcept = default;
JointsObserver& JointsObserver::operator=(JointsObserver&&) noexcept = default;

JointsMotion JointsObserver::observe(const FourierSeries& force,
                                     std::span<const FourierSeries> accelerations) const {
  return tables_->motion(force, accelerations, {});
}

std::span<const UnseenDirection> JointsObserver::unseen() const { return tables_->unseen; }

JointsMotion JointsObserver::observe_with(const FourierSeries& force,
                                          std::span<const FourierSeries> accelerations,
                                          std::size_t direction, double phase) const {
  if (direction >= tables_->unseen.size()) {
    throw InputError("direction", static_cast<double>(direction),
                     fmt::format("must be below {}", tables_->unseen.size()));
  }
  return tables_->motion(force, accelerations, {{direction, std::polar(1.0, phase)}});
}

std::vector<double> JointsObserver::displacement_std(std::size_t joint) const {
  const Tables& t = *tables_;
  if (joint >= static_cast<std::size_t>(t.joints.cols())) {
    throw InputError("joint", static_cast<double>(joint), "must be below the number of joints");
  }
  const auto j = static_cast<Index>(joint);
  std::vector<double> result;
  for (Index n = 0; n < t.harmonics; ++n) {
    const auto at = static_cast<std::size_t>(n);
    const Tables::HarmonicTable& harmonic = t.table[at];
    // u per (F, h), then per (F, A).
    Eigen::RowVectorXcd per_load = t.joints.col(j).transpose() * harmonic.modal;
    per_load *= 1.0 - t.compliance[j] * t.stuck[j];
    per_load[1 + j] += t.compliance[j];
    const Eigen::RowVectorXcd per_acceleration =
        per_load.tail(t.joints.cols()) * harmonic.joint_estimate +
        per_load[0] * harmonic.force_step;
    const JointsComplex per_force =
        per_load[0] - (per_acceleration * harmonic.acceleration.col(0)).value();
    double square = std::norm(per_force) * t.scales.force_std[at] * t.scales.force_std[at];
    for (Index s = 0; s < per_acceleration.size(); ++s) {
      const double std = t.scales.acceleration_std[static_cast<std::size_t>(s)][at];
      square += std::norm(per_acceleration[s]) * std * std;
    }
    result.push_back(std::sqrt(square));
  }
  return result;
}

}  // namespace microslip
