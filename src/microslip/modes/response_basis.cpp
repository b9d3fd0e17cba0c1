// SPDX-License-Identifier: MIT
#include "microslip/modes/response_basis.hpp"

#include <complex>

#include "microslip/algebra/qr.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

Index numerators_of(Numerators kind) { return kind == Numerators::kReal ? 1 : 2; }

Complex differentiated(double x, int derivatives) { return std::pow(Complex(0.0, x), derivatives); }

Complex stiffness_at(const ResponsePole& pole, double x, DampingLaw law) {
  const double w = pole.frequency();
  return modal_stiffness({.angular_frequency = w, .loss_factor = pole.loss()}, x, law);
}

/// b's factor in the numerator over a's.
Complex second_factor(const ResponsePole& pole, double x, DampingLaw law) {
  return law == DampingLaw::kViscous ? Complex(0.0, x / pole.frequency()) : Complex(0.0, 1.0);
}

}  // namespace

MatrixXd parts_of_complex(const Eigen::MatrixXcd& values) {
  MatrixXd both(2 * values.rows(), values.cols());
  both << values.real(), values.imag();
  return both;
}

MatrixXd response_basis(const ResponseGroup& group, std::span<const ResponsePole> poles,
                        DampingLaw law, Numerators kind) {
  const Index each = numerators_of(kind);
  const Index modes = static_cast<Index>(poles.size());
  Eigen::MatrixXcd columns(group.x.size(), each * modes + 2);
  for (Index i = 0; i < group.x.size(); ++i) {
    const double x = group.x(i);
    const Complex factor = differentiated(x, group.derivatives);
    for (Index r = 0; r < modes; ++r) {
      const ResponsePole& pole = poles[static_cast<std::size_t>(r)];
      columns(i, each * r) = factor / stiffness_at(pole, x, law);
      if (each == 2) columns(i, each * r + 1) = columns(i, each * r) * second_factor(pole, x, law);
    }
    columns(i, each * modes) = -factor / (x * x);
    columns(i, each * modes + 1) = factor;
  }
  return parts_of_complex(columns);
}

MatrixXd response_slopes(const ResponseGroup& group, std::span<const ResponsePole> poles,
                         DampingLaw law) {
  Eigen::MatrixXcd columns(group.x.size(), 4 * static_cast<Index>(poles.size()));
  for (Index i = 0; i < group.x.size(); ++i) {
    const double x = group.x(i);
    const Complex factor = differentiated(x, group.derivatives);
    for (std::size_t r = 0; r < poles.size(); ++r) {
      const double w = poles[r].frequency();
      const Complex stiffness = stiffness_at(poles[r], x, law);
      const Complex lost(0.0, stiffness.imag());
      const double lost_by_frequency = law == DampingLaw::kViscous ? 1.0 : 2.0;
      const Complex by_frequency = 2.0 * w * w + lost_by_frequency * lost;
      const Complex column = -factor / (stiffness * stiffness);
      const Complex second = second_factor(poles[r], x, law);
      const Index at = 4 * static_cast<Index>(r);
      columns(i, at) = column * by_frequency;
      columns(i, at + 1) = column * by_frequency * second;
      columns(i, at + 2) = column * lost;
      columns(i, at + 3) = column * lost * second;
    }
  }
  return parts_of_complex(columns);
}

LinearFit fit_linearly(const ResponseGroup& group, const MatrixXd& basis) {
  const VectorXd norms = basis.colwise().norm().transpose().cwiseMax(1e-300);
  const MatrixXd scaled = basis * norms.cwiseInverse().asDiagonal();
  const Eigen::HouseholderQR<MatrixXd> qr(scaled);
  LinearFit fit;
  fit.basis_directions = qr.householderQ() * MatrixXd::Identity(basis.rows(), basis.cols());
  const auto triangle = qr.matrixQR().topRows(basis.cols()).template triangularView<Eigen::Upper>();
  const MatrixXd projected = fit.basis_directions.transpose() * group.values;
  fit.coefficients = norms.cwiseInverse().asDiagonal() * triangle.solve(projected);
  fit.rest = group.values - fit.basis_directions * projected;
  const MatrixXd inverse_triangle =
      norms.cwiseInverse().asDiagonal() *
      MatrixXd(triangle.solve(MatrixXd::Identity(basis.cols(), basis.cols())));
  fit.inverse = inverse_triangle * inverse_triangle.transpose();
  return fit;
}

}  // namespace microslip
