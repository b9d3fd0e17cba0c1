// SPDX-License-Identifier: MIT
#include "microslip/modes/natural_modes.hpp"

#include <Spectra/SymGEigsShiftSolver.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/base/stopwatch.hpp"
#include "microslip/modes/definite_pencil.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Up to here a dense solution takes less time than is noticed.
constexpr Index kDenseRows = 300;
/// More than are wanted, so that a gap between eigenvalues lies behind the last.
constexpr Index kSpareModes = 8;
/// Tolerance of θ = 1/(ω² − σ), relative; Rayleigh–Ritz squares the error of a shape.
constexpr double kLanczosTolerance = 1e-11;
constexpr Index kMostRestarts = 300;
constexpr int kMostSearches = 8;
constexpr int kMostShifts = 4;
/// Of −σ over the ω² of a typical row, at first.
constexpr double kFirstShift = 1e-10;
/// Of −σ over ω² of the first mode that strains.
constexpr double kNearShift = 0.01;
/// Of −σ over what rounding makes of the ω² of rigid bodies, a bound.
constexpr double kBeyondRounding = 4.0;
/// Of the bound of what rounding makes of the ω² of a rigid body: more is hardly rounding.
constexpr double kHardlyRounding = 1.0 / 16.0;
/// Of the squared norm in M of a shape: less lies in the span of others but for rounding.
constexpr double kDependent = 1e-10;
/// Between eigenvalues, relative: less is one multiple eigenvalue.
constexpr double kGap = 1e-6;
/// Larger residuals are reported, unless they are rounding.
constexpr double kResidualAllowed = 1e-6;

double trace_ratio(const VibratingSystem& system) {
  const double stiffness = system.stiffness.diagonal().sum();
  const double mass = system.mass.diagonal().sum();
  if (stiffness > 0.0 && mass > 0.0) return stiffness / mass;
  throw InputError("trace of the stiffness and of the mass matrix",
                   fmt::format("{:.6g} and {:.6g}", stiffness, mass), "must be positive");
}

MatrixXd random_block(Index rows, Index columns, std::uint64_t stream) {
  RandomStream random(1, stream);
  MatrixXd block(rows, columns);
  for (double& value : block.reshaped()) value = random.normal();
  return block;
}

/// x less what of it lies along modes that are known already.
class Deflation {
 public:
  Deflation(const Eigen::SparseMatrix<double>& mass, const MatrixXd& known)
      : known_(known), momenta_(mass * known) {}

  void project(Eigen::Ref<VectorXd> x) const {
    if (known_.cols() > 0) x -= known_ * (momenta_.transpose() * x);
  }

 private:
  const MatrixXd& known_;
  MatrixXd momenta_;
};

/// (K − σM)⁻¹, for Spectra.
class InverseOperator {
 public:
  using Scalar = double;
  InverseOperator(const ShiftedFactor& factor, const Deflation& deflation, Index size,
                  const std::function<void()>& counted)
      : factor_(factor), deflation_(deflation), size_(size), counted_(counted) {}

  [[nodiscard]] Index rows() const { return size_; }
  [[nodiscard]] Index cols() const { return size_; }
  void set_shift(double /*shift*/) {}  // the factor is there
  void perform_op(const double* in, double* out) const {
    counted_();
    VectorXd x = factor_.solve(Eigen::Map<const VectorXd>(in, size_));
    deflation_.project(x);
    Eigen::Map<VectorXd>(out, size_) = x;
  }

 private:
  const ShiftedFactor& factor_;
  const Deflation& deflation_;
  Index size_;
  const std::function<void()>& counted_;
};

/// M, for Spectra.
class MassOperator {
 public:
  using Scalar = double;
  explicit MassOperator(const Eigen::SparseMatrix<double>& mass) : mass_(mass) {}

  [[nodiscard]] Index rows() const { return mass_.rows(); }
  [[nodiscard]] Index cols() const { return mass_.cols(); }
  void perform_op(const double* in, double* out) const {
    Eigen::Map<VectorXd>(out, rows()).noalias() = mass_ * Eigen::Map<const VectorXd>(in, rows());
  }

 private:
  const Eigen::SparseMatrix<double>& mass_;
};

/// The columns of a Gram matrix with unit diagonal that do not depend on those before: pivots of
/// its Cholesky factor.
std::vector<Index> independent_columns(const MatrixXd& gram) {
  std::vector<Index> kept;
  MatrixXd lower = MatrixXd::Zero(gram.rows(), gram.cols());
  for (Index j = 0; j < gram.cols(); ++j) {
    const auto before = static_cast<Index>(kept.size());
    const double pivot = gram(j, j) - lower.row(j).head(before).squaredNorm();
    if (!(pivot > kDependent)) continue;
    const Index below = gram.rows() - j;
    lower.col(before).tail(below) =
        (gram.col(j).tail(below) -
         lower.bottomLeftCorner(below, before) * lower.row(j).head(before).transpose()) /
        std::sqrt(pivot);
    kept.push_back(j);
  }
  return kept;
}

/// Rayleigh–Ritz in the span of some columns.
ModalPairs ritz_pairs(const VibratingSystem& system, double shift, MatrixXd basis) {
  for (Index i = 0; i < basis.cols(); ++i) {
    basis.col(i) /= std::sqrt(basis.col(i).dot(system.mass * basis.col(i)));
  }
  const std::vector<Index> kept = independent_columns(basis.transpose() * (system.mass * basis));
  if (static_cast<Index>(kept.size()) < basis.cols()) basis = basis(Eigen::all, kept).eval();
  ModalPairs pairs = definite_pairs(basis.transpose() * system.stiffness_times(basis),
                                    basis.transpose() * (system.mass * basis), shift);
  pairs.shapes = basis * pairs.shapes;
  return pairs;
}

MatrixXd inverse_iterated(const VibratingSystem& system, const ShiftedFactor& factor,
                          const MatrixXd& shapes) {
  return factor.solve(system.mass * shapes);
}

/// All modes of a small system.
ModalPairs dense_pairs(const VibratingSystem& system, double shift) {
  const MatrixXd unit = MatrixXd::Identity(system.size(), system.size());
  return definite_pairs(system.stiffness_times(unit), MatrixXd(system.mass), shift);
}

/// Seeks modes from one shift, and keeps what is found.
class Search {
 public:
  Search(const VibratingSystem& system, const ModeRange& range, const Progress& progress)
      : system_(system), range_(range), progress_(progress) {}

  NaturalModes run() {
    factorise(-std::max(kFirstShift, kBeyondRounding * system_.possible_entry_error()) *
              trace_ratio(system_));
    wanted_ = wanted_modes();
    find_lowest(wanted_ + kSpareModes);
    approach();
    refine();
    seek_missed();
    return result();
  }

 private:
  void factorise(double shift) {
    shift_ = shift;
    factor_ = std::make_shared<const ShiftedFactor>(system_, shift);
    if (const std::size_t negative = factor_->eigenvalues_below(); negative > 0) {
      refuse_negative_stiffness(negative);
    }
  }

  [[nodiscard]] Index wanted_modes() {
    if (range_.count) {
      return std::min(static_cast<Index>(*range_.count), system_.size());
    }
    const double highest = 2.0 * std::numbers::pi * range_.highest_frequency.value();
    const std::size_t below =
        ShiftedFactor(system_, highest * highest * (1.0 + 1e-12)).eigenvalues_below();
    if (below > kMostModes) {
      throw InputError("modes in the range", static_cast<double>(below),
                       fmt::format("must be at most {}", kMostModes));
    }
    if (below > 0) return static_cast<Index>(below);
    find_lowest(1);
    throw InputError(
        "highest frequency", *range_.highest_frequency,
        fmt::format("must be above the first mode, {:.6g} Hz",
                    std::sqrt(std::max(pairs_.eigenvalues(0), 0.0)) / (2.0 * std::numbers::pi)));
  }

  void find_lowest(Index count) {
    whole_ = false;
    if (system_.size() <= kDenseRows || 3 * count > system_.size()) {
      pairs_ = dense_pairs(system_, shift_);
      whole_ = pairs_.eigenvalues.size() <= count;
      keep_lowest(count);
    } else {
      pairs_ = ritz_pairs(system_, shift_, lanczos(count, MatrixXd(system_.size(), 0)));
    }
  }

  /// The others would take their digits in a span of all.
  void keep_lowest(Index count) {
    const Index kept = std::min(count, pairs_.eigenvalues.size());
    pairs_.eigenvalues.conservativeResize(kept);
    pairs_.shapes.conservativeResize(Eigen::NoChange, kept);
  }

  /// Shapes of the modes nearest to the shift, other than those known.
  [[nodiscard]] MatrixXd lanczos(Index count, const MatrixXd& known) {
    const Deflation deflation(system_.mass, known);
    const Index basis = std::min(system_.size(), std::max<Index>(2 * count + 10, 40));
    expected_ = solves_ + 2 * static_cast<std::size_t>(basis);
    const std::function<void()> counted = [this] { count_solve(); };
    InverseOperator inverse(*factor_, deflation, system_.size(), counted);
    MassOperator mass(system_.mass);
    Spectra::SymGEigsShiftSolver<InverseOperator, MassOperator, Spectra::GEigsMode::ShiftInvert>
        solver(inverse, mass, count, basis, shift_);
    // From where the operator leads: no component without mass, which Lanczos would keep.
    const MatrixXd random = random_block(system_.size(), 1, ++searches_);
    VectorXd start(system_.size());
    inverse.perform_op(VectorXd(system_.mass * random.col(0)).data(), start.data());
    solver.init(start.data());
    solver.compute(Spectra::SortRule::LargestMagn, kMostRestarts, kLanczosTolerance);
    iterations_ += static_cast<int>(solver.num_iterations());
    return solver.eigenvectors();
  }

  void count_solve() {
    ++solves_;
    expected_ = std::max(expected_, solves_);
    if (progress_ && !progress_(solves_, expected_)) throw Cancelled();
  }

  /// |φ|ᵀ|K||φ|: what an error of the entries of K, relative, may add to φᵀKφ.
  [[nodiscard]] double energy_of_sizes(Index mode) const {
    const VectorXd shape = pairs_.shapes.col(mode);
    return shape.cwiseAbs().dot(system_.sizes_times(shape));
  }

  /// The modes whose strain energy is rounding, counted from the lowest.
  struct RigidBodies {
    Index count = 0;
    double rounding = 0.0;  ///< the largest bound of their ω²
    double doubtful = 0.0;  ///< NaturalModes::doubtful
  };
  [[nodiscard]] RigidBodies rigid_bodies() const {
    RigidBodies found;
    for (; found.count < pairs_.eigenvalues.size(); ++found.count) {
      const double square = pairs_.eigenvalues(found.count);
      const double sizes = energy_of_sizes(found.count);
      const double certain = system_.entry_error() * sizes;
      const double possible = system_.possible_entry_error() * sizes;
      if (square < -possible) refuse_negative_stiffness(std::nullopt);
      if (square > possible) break;
      if (square > certain) {
        found.doubtful = std::max(found.doubtful, possible);
        break;
      }
      const double bound = square < -certain ? possible : certain;
      found.rounding = std::max(found.rounding, bound);
      if (square < -certain || square > kHardlyRounding * bound) {
        found.doubtful = std::max(found.doubtful, bound);
      }
    }
    return found;
  }

  /// Brings the shift near to the first mode that strains: from afar, as stiff springs that fix
  /// rows put it, modes are not distinguished. Near the eigenvalue 0 of rigid bodies, others lose
  /// the digits by which theirs is nearer.
  void approach() {
    for (int i = 0; i < kMostShifts; ++i) {
      const RigidBodies rigid = rigid_bodies();
      if (rigid.count == pairs_.eigenvalues.size()) return;
      const double first = pairs_.eigenvalues(rigid.count);
      const double near = std::max(kNearShift * first, kBeyondRounding * rigid.rounding);
      const bool inside = -shift_ <= 1.5 * near;
      if (inside && (rigid.count == 0 || i > 0)) return;
      const bool far = -shift_ > std::max(first, near);
      factorise(-near);
      if (!far) return;
      find_lowest(wanted_ + kSpareModes);
    }
  }

  void refine() {
    pairs_ = ritz_pairs(system_, shift_, inverse_iterated(system_, *factor_, pairs_.shapes));
  }

  /// How many modes there are to the last gap, and the middle of it.
  struct Checked {
    Index count;
    double eigenvalue;
  };
  [[nodiscard]] std::optional<Checked> last_gap() const {
    for (Index i = std::min(wanted_, pairs_.eigenvalues.size() - 1); i < pairs_.eigenvalues.size();
         ++i) {
      const double below = i == 0 ? 0.0 : pairs_.eigenvalues(i - 1);
      const double above = pairs_.eigenvalues(i);
      if (above - below > kGap * above) return Checked{i, 0.5 * (below + above)};
    }
    return std::nullopt;
  }

  void seek_missed() {
    if (whole_ && pairs_.eigenvalues.size() <= wanted_) {
      sturm_ = "all modes of the system";
      missing_ = false;
      return;
    }
    for (int search = 0; search < kMostSearches; ++search) {
      if (const Index fewer = wanted_ + 1 - pairs_.eigenvalues.size(); fewer > 0) {
        add(lanczos(fewer, pairs_.shapes));
      }
      const std::optional<Checked> checked = last_gap();
      if (!checked) {
        sturm_ = "not counted: no gap behind the last mode";
        return;
      }
      const auto below =
          static_cast<Index>(ShiftedFactor(system_, checked->eigenvalue).eigenvalues_below());
      missing_ = below != checked->count;
      sturm_ =
          fmt::format("{} modes counted below {:.6g} Hz, {} found", below,
                      std::sqrt(checked->eigenvalue) / (2.0 * std::numbers::pi), checked->count);
      if (below <= checked->count) return;
      add(lanczos(below - checked->count + 2, pairs_.shapes));
    }
  }

  void add(const MatrixXd& further) {
    MatrixXd all(system_.size(), pairs_.shapes.cols() + further.cols());
    all << pairs_.shapes, further;
    pairs_ = ritz_pairs(system_, shift_, all);
    refine();
  }

  /// Sets residuals, and whether rounding explains those that are large.
  void judge(NaturalModes& modes) {
    const MatrixXd strained = system_.stiffness_times(modes.shapes);
    const MatrixXd moved = (system_.mass * modes.shapes) * modes.eigenvalues.asDiagonal();
    modes.residuals = VectorXd::Zero(modes.eigenvalues.size());
    for (Index i = static_cast<Index>(modes.rigid_bodies); i < modes.residuals.size(); ++i) {
      const double scale = strained.col(i).norm() + moved.col(i).norm();
      modes.residuals(i) = (strained.col(i) - moved.col(i)).norm() / scale;
      if (modes.residuals(i) <= kResidualAllowed) continue;
      const double rounding = system_.rounding_times(modes.shapes.col(i)).norm() / scale;
      inexact_ = inexact_ || modes.residuals(i) > kResidualAllowed + rounding;
    }
  }

  [[nodiscard]] NaturalModes result() {
    NaturalModes modes;
    const Index count = std::min(wanted_, pairs_.eigenvalues.size());
    const RigidBodies rigid = rigid_bodies();
    modes.rigid_bodies = static_cast<std::size_t>(std::min(rigid.count, count));
    modes.rounding = rigid.rounding;
    modes.doubtful = rigid.doubtful;
    modes.eigenvalues = pairs_.eigenvalues.head(count);
    modes.eigenvalues.head(static_cast<Index>(modes.rigid_bodies)).setZero();
    modes.shapes = pairs_.shapes.leftCols(count);
    turn_positive(modes.shapes);
    judge(modes);
    modes.factor = factor_;
    summarise(modes);
    return modes;
  }

  void summarise(NaturalModes& modes) const {
    Summary& summary = modes.summary;
    summary.method = searches_ > 0 ? "shift-invert Lanczos" : "dense eigenvalues";
    summary.residual = modes.residuals.maxCoeff();
    summary.iterations = iterations_;
    summary.wall_seconds = watch_.seconds();
    summary.stop = missing_ || inexact_ ? Stop::kDoubtful : Stop::kConverged;
    summary.reason = sturm_;
    if (inexact_) summary.reason += fmt::format("; a residual is above {:g}", kResidualAllowed);
  }

  const VibratingSystem& system_;
  const ModeRange& range_;
  const Progress& progress_;
  Stopwatch watch_;
  double shift_ = 0.0;
  std::shared_ptr<const ShiftedFactor> factor_;
  Index wanted_ = 0;
  ModalPairs pairs_;
  std::size_t solves_ = 0;
  std::size_t expected_ = 0;
  std::uint64_t searches_ = 0;
  int iterations_ = 0;
  std::string sturm_ = "not all modes were found";
  bool missing_ = true;
  bool inexact_ = false;  ///< a residual is too large
  bool whole_ = false;    ///< all modes of the system are there
};

}  // namespace

void turn_positive(MatrixXd& shapes) {
  for (Index i = 0; i < shapes.cols(); ++i) {
    Index largest = 0;
    shapes.col(i).cwiseAbs().maxCoeff(&largest);
    if (shapes(largest, i) < 0.0) shapes.col(i) *= -1.0;
  }
}

NaturalModes find_natural_modes(const VibratingSystem& system, const ModeRange& range,
                                const Progress& progress) {
  if (range.count.has_value() == range.highest_frequency.has_value()) {
    throw InputError("modes", InputState{"ambiguous"},
                     "must be given by their count or by the highest frequency");
  }
  if (range.count && (*range.count == 0 || *range.count > kMostModes)) {
    throw InputError("count of modes", static_cast<double>(*range.count),
                     fmt::format("must be from 1 to {}", kMostModes));
  }
  if (range.highest_frequency &&
      !(*range.highest_frequency > 0.0 && std::isfinite(*range.highest_frequency))) {
    throw InputError("highest frequency", *range.highest_frequency,
                     "must be positive and finite, Hz");
  }
  return Search(system, range, progress).run();
}

}  // namespace microslip
