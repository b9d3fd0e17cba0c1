// SPDX-License-Identifier: MIT
#include "microslip/modes/symmetric_factor.hpp"

#include <dmumps_c.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

// Jobs and controls as the manual of MUMPS 5.5 has them, section 5: ICNTL(i) is icntl[i − 1].
constexpr MUMPS_INT kStart = -1;
constexpr MUMPS_INT kEnd = -2;
constexpr MUMPS_INT kAnalyse = 1;
constexpr MUMPS_INT kFactorise = 2;
constexpr MUMPS_INT kSolve = 3;
constexpr MUMPS_INT kGeneralSymmetric = 2;
constexpr MUMPS_INT kCommunicatorOfWorld = -987654;

constexpr int kMorePercent = 13;     // ICNTL(14): memory beyond the estimate of the analysis
constexpr int kColumnsAtOnce = 26;   // ICNTL(27): right-hand sides that are solved together
constexpr int kError = 0;            // INFOG(1)
constexpr int kNegativePivots = 11;  // INFOG(12)

// INFOG(1): the estimated memory was too small; request more. The matrix is not at fault.
bool lacks_room(MUMPS_INT error) {
  return error == -8 || error == -9 || error == -14 || error == -20;
}
bool is_singular(MUMPS_INT error) { return error == -6 || error == -10; }

InputError failure(MUMPS_INT error, MUMPS_INT detail) {
  if (is_singular(error)) {
    return {"matrix", fmt::format("singular (pivot {})", detail),
            "must have an inverse to be factorised"};
  }
  return {"factorisation", fmt::format("error {} ({}) of MUMPS", error, detail),
          "must have enough memory", "Take a coarser mesh, or a machine with more memory."};
}

}  // namespace

class SymmetricFactor::Impl {
 public:
  explicit Impl(const Eigen::SparseMatrix<double>& lower) : size_(lower.rows()) {
    if (lower.rows() != lower.cols()) {
      throw InputError("matrix", fmt::format("{} × {}", lower.rows(), lower.cols()),
                       "must be square");
    }
    if (size_ == 0 || size_ > std::numeric_limits<MUMPS_INT>::max()) {
      throw InputError("rows of the matrix", static_cast<double>(size_),
                       "must be 1 or more, and counted by 32 bits");
    }
    take_entries(lower);
    start();
    try {
      factorise();
    } catch (...) {
      run(kEnd);
      throw;
    }
  }
  ~Impl() { run(kEnd); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  Impl(Impl&&) = delete;
  Impl& operator=(Impl&&) = delete;

  void solve(Eigen::Ref<Eigen::MatrixXd> right_sides) {
    if (right_sides.cols() == 0) return;
    mumps_.rhs = right_sides.data();
    mumps_.nrhs = static_cast<MUMPS_INT>(right_sides.cols());
    mumps_.lrhs = static_cast<MUMPS_INT>(right_sides.outerStride());
    run(kSolve);
    if (mumps_.infog[kError] < 0) throw failure(mumps_.infog[kError], mumps_.infog[1]);
  }

  [[nodiscard]] std::size_t negative_eigenvalues() const {
    return static_cast<std::size_t>(mumps_.infog[kNegativePivots]);
  }
  [[nodiscard]] Eigen::Index size() const { return size_; }

 private:
  void take_entries(const Eigen::SparseMatrix<double>& lower) {
    const auto most = static_cast<std::size_t>(lower.nonZeros());
    row_.reserve(most);
    column_.reserve(most);
    value_.reserve(most);
    for (Eigen::Index j = 0; j < lower.outerSize(); ++j) {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, j); entry; ++entry) {
        if (entry.row() < entry.col()) continue;
        row_.push_back(static_cast<MUMPS_INT>(entry.row() + 1));
        column_.push_back(static_cast<MUMPS_INT>(entry.col() + 1));
        value_.push_back(entry.value());
      }
    }
  }

  void start() {
    mumps_.sym = kGeneralSymmetric;
    mumps_.par = 1;
    mumps_.comm_fortran = kCommunicatorOfWorld;
    run(kStart);
    for (int i = 0; i < 4; ++i) mumps_.icntl[i] = i == 3 ? 0 : -1;  // prints nothing
    mumps_.icntl[kColumnsAtOnce] = 32;
    mumps_.n = static_cast<MUMPS_INT>(size_);
    mumps_.nnz = static_cast<MUMPS_INT8>(value_.size());
    mumps_.irn = row_.data();
    mumps_.jcn = column_.data();
    mumps_.a = value_.data();
  }

  void factorise() {
    run(kAnalyse);
    check();
    for (MUMPS_INT more = 20; more <= 640; more *= 2) {
      mumps_.icntl[kMorePercent] = more;
      run(kFactorise);
      if (!lacks_room(mumps_.infog[kError])) break;
    }
    check();
    // A factor needs its matrix no more.
    row_ = {};
    column_ = {};
    value_ = {};
    mumps_.irn = nullptr;
    mumps_.jcn = nullptr;
    mumps_.a = nullptr;
  }

  void run(MUMPS_INT job) {
    mumps_.job = job;
    dmumps_c(&mumps_);
  }

  void check() const {
    if (mumps_.infog[kError] < 0) throw failure(mumps_.infog[kError], mumps_.infog[1]);
  }

  Eigen::Index size_;
  std::vector<MUMPS_INT> row_;
  std::vector<MUMPS_INT> column_;
  std::vector<double> value_;
  DMUMPS_STRUC_C mumps_ = {};
};

SymmetricFactor::SymmetricFactor(const Eigen::SparseMatrix<double>& lower)
    : impl_(std::make_unique<Impl>(lower)) {}
SymmetricFactor::~SymmetricFactor() = default;
SymmetricFactor::SymmetricFactor(SymmetricFactor&&) noexcept = default;
SymmetricFactor& SymmetricFactor::operator=(SymmetricFactor&&) noexcept = default;

void SymmetricFactor::solve(Eigen::Ref<Eigen::MatrixXd> right_sides) const {
  impl_->solve(right_sides);
}

std::size_t SymmetricFactor::negative_eigenvalues() const { return impl_->negative_eigenvalues(); }

Eigen::Index SymmetricFactor::size() const { return impl_->size(); }

}  // namespace microslip
