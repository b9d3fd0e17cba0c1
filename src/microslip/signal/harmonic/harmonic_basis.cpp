// SPDX-License-Identifier: MIT
#include "microslip/signal/harmonic/harmonic_basis.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace microslip {
namespace {

using Complex = std::complex<double>;

/// Long enough that the sines of its start do not count, short enough for the first cache.
constexpr Eigen::Index kPiece = 128;

/// The real columns Re z_1, Im z_1, … as complex ones; an array of complex numbers is one of pairs.
Eigen::MatrixXcd as_complex(const Eigen::MatrixXd& pairs) {
  const Eigen::Index order = pairs.rows() / 2;
  return Eigen::Map<const Eigen::MatrixXcd>(reinterpret_cast<const Complex*>(pairs.data()), order,
                                            pairs.cols());
}

/// Row l: z_k = e^{−ikΩ distance(l)}. Powers of the first: their rounding errors stay below K ε.
void fill_row(double angle, Eigen::Index row, Eigen::MatrixXd& pairs) {
  const Complex first = std::polar(1.0, -angle);
  Complex power = first;
  for (Eigen::Index k = 0; k < pairs.cols() / 2; ++k) {
    pairs(row, 2 * k) = power.real();
    pairs(row, 2 * k + 1) = power.imag();
    power *= first;
  }
}

/// Σ_l d_l^q z_k(l) for the distances d from the start of a piece; k = 0 first.
Eigen::MatrixXcd moments_of_piece(const Eigen::VectorXd& distance, const Eigen::MatrixXd& pairs,
                                  Eigen::Index degree) {
  Eigen::MatrixXd powers(distance.size(), degree + 1);
  powers.col(0).setOnes();
  for (Eigen::Index q = 1; q <= degree; ++q) {
    powers.col(q) = powers.col(q - 1).cwiseProduct(distance);
  }
  Eigen::MatrixXcd result(degree + 1, pairs.cols() / 2 + 1);
  result.col(0) = powers.colwise().sum().transpose().cast<Complex>();
  const Eigen::MatrixXd sums = pairs.transpose() * powers;
  result.rightCols(pairs.cols() / 2) = as_complex(sums).transpose();
  return result;
}

/// From moments about the start of a piece to those about s = 0: (s₀ + d)^q by the binomials.
Eigen::MatrixXd shift_of_moments(double s0, Eigen::Index degree) {
  Eigen::MatrixXd shift = Eigen::MatrixXd::Zero(degree + 1, degree + 1);
  shift(0, 0) = 1.0;
  for (Eigen::Index q = 1; q <= degree; ++q) {
    for (Eigen::Index p = 0; p <= q; ++p) {
      shift(q, p) = s0 * shift(q - 1, p) + (p > 0 ? shift(q - 1, p - 1) : 0.0);
    }
  }
  return shift;
}

}  // namespace

RecordTimes::RecordTimes(const Axis& axis, std::size_t points)
    : axis_(axis), points_(static_cast<Eigen::Index>(points)) {
  if (axis.even()) {
    half_width_ = 0.5 * axis.step * static_cast<double>(points - 1);
    middle_ = axis.start + half_width_;
  } else {
    half_width_ = 0.5 * (axis.values.back() - axis.values.front());
    middle_ = axis.values.front() + half_width_;
  }
}

double RecordTimes::s(Eigen::Index i) const {
  if (even()) return 2.0 * static_cast<double>(i) / static_cast<double>(points_ - 1) - 1.0;
  return (axis_.values[static_cast<std::size_t>(i)] - middle_) / half_width_;
}

HarmonicBasis::HarmonicBasis(const RecordTimes& times, double big_omega, Eigen::Index order)
    : times_(times), big_omega_(big_omega), order_(order) {
  if (!times.even()) return;
  table_.resize(std::min(kPiece, times.points()), 2 * order);
  const double step = 2.0 / static_cast<double>(times.points() - 1);
  for (Eigen::Index l = 0; l < table_.rows(); ++l) {
    fill_row(big_omega * step * static_cast<double>(l), l, table_);
  }
}

Eigen::MatrixXd HarmonicBasis::uneven_piece(PointRange range, Eigen::Index order) const {
  Eigen::MatrixXd pairs(range.size(), 2 * order);
  const double s0 = times_.s(range.first);
  for (Eigen::Index l = 0; l < range.size(); ++l) {
    fill_row(big_omega_ * (times_.s(range.first + l) - s0), l, pairs);
  }
  return pairs;
}

Eigen::VectorXcd HarmonicBasis::start(Eigen::Index first, Eigen::Index order) const {
  const Complex one = std::polar(1.0, -big_omega_ * times_.s(first));
  Eigen::VectorXcd z(order);
  Complex power = one;
  for (Eigen::Index k = 0; k < order; ++k, power *= one) z(k) = power;
  return z;
}

Eigen::MatrixXcd HarmonicBasis::sums(const Eigen::MatrixXd& columns, PointRange range,
                                     Eigen::Index order) const {
  Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(order, columns.cols());
  Eigen::MatrixXd product(2 * order, columns.cols());
  for (Eigen::Index first = range.first; first < range.last; first += kPiece) {
    const PointRange piece{first, std::min(range.last, first + kPiece)};
    const auto rows = columns.middleRows(first, piece.size());
    if (times_.even()) {
      product.noalias() = table_.topLeftCorner(piece.size(), 2 * order).transpose() * rows;
    } else {
      product.noalias() = uneven_piece(piece, order).transpose() * rows;
    }
    result += start(first, order).asDiagonal() * as_complex(product);
  }
  return result;
}

Eigen::MatrixXcd HarmonicBasis::moments(Eigen::Index degree, PointRange range) const {
  const double step = 2.0 / static_cast<double>(times_.points() - 1);
  const Eigen::VectorXd even_distance =
      Eigen::VectorXd::LinSpaced(kPiece, 0.0, step * static_cast<double>(kPiece - 1));
  Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(degree + 1, order_ + 1);
  Eigen::MatrixXcd of_piece;
  Eigen::Index computed = 0;  // points of the even piece that of_piece is for
  for (Eigen::Index first = range.first; first < range.last; first += kPiece) {
    const PointRange piece{first, std::min(range.last, first + kPiece)};
    const double s0 = times_.s(first);
    if (!times_.even()) {
      Eigen::VectorXd distance(piece.size());
      for (Eigen::Index l = 0; l < piece.size(); ++l) distance(l) = times_.s(first + l) - s0;
      of_piece = moments_of_piece(distance, uneven_piece(piece, order_), degree);
    } else if (computed != piece.size()) {
      computed = piece.size();
      of_piece = moments_of_piece(even_distance.head(computed), table_.topRows(computed), degree);
    }
    Eigen::MatrixXcd shifted = shift_of_moments(s0, degree) * of_piece;
    shifted.rightCols(order_) *= start(first, order_).asDiagonal();
    result += shifted;
  }
  return result;
}

void HarmonicBasis::subtract_series(const Eigen::MatrixXcd& c, Eigen::MatrixXd& columns) const {
  const Eigen::Index order = c.rows();
  // Re(c conj(z)) = Re c Re z + Im c Im z, so with c·conj(start) the pairs of a piece apply.
  for (Eigen::Index first = 0; first < columns.rows(); first += kPiece) {
    const PointRange piece{first, std::min(columns.rows(), first + kPiece)};
    const Eigen::MatrixXcd turned = start(first, order).conjugate().asDiagonal() * c;
    const Eigen::Map<const Eigen::MatrixXd> pairs(reinterpret_cast<const double*>(turned.data()),
                                                  2 * order, c.cols());
    auto rows = columns.middleRows(first, piece.size());
    if (times_.even()) {
      rows.noalias() -= table_.topLeftCorner(piece.size(), 2 * order) * pairs;
    } else {
      rows.noalias() -= uneven_piece(piece, order) * pairs;
    }
  }
}

}  // namespace microslip
