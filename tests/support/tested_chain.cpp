// SPDX-License-Identifier: MIT
#include "support/tested_chain.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/algebra/eigenvalues.hpp"
#include "microslip/algebra/lu.hpp"

namespace microslip::test {

Eigen::MatrixXd TestedChain::mass() const {
  Eigen::VectorXd diagonal(size());
  for (Eigen::Index i = 0; i < size(); ++i) diagonal(i) = 1.0 + 0.1 * static_cast<double>(i);
  return diagonal.asDiagonal();
}

Eigen::MatrixXd TestedChain::stiffness() const {
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(size(), size());
  for (Eigen::Index i = 0; i < size(); ++i) {
    const double spring = 1e5 * (1.0 + 0.07 * static_cast<double>(i));
    k(i, i) += spring;
    if (i == 0) continue;
    k(i - 1, i - 1) += spring;
    k(i - 1, i) -= spring;
    k(i, i - 1) -= spring;
  }
  return k;
}

Eigen::MatrixXd TestedChain::damping() const {
  Eigen::MatrixXd c = mass_damping * mass() + stiffness_damping * stiffness();
  c(size() - 1, size() - 1) += damper_at_end;
  return c;
}

Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> TestedChain::modes() const {
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(stiffness(), mass());
}

double TestedChain::loss_of(double omega) const {
  if (loss_factor > 0.0) return loss_factor;
  return mass_damping / omega + stiffness_damping * omega;
}

Eigen::MatrixXcd TestedChain::responses(const std::vector<double>& hertz, std::size_t drive,
                                        int derivatives) const {
  using Complex = std::complex<double>;
  const Eigen::MatrixXcd k = stiffness().cast<Complex>() * Complex(1.0, loss_factor);
  const Eigen::MatrixXcd m = mass().cast<Complex>();
  const Eigen::MatrixXcd c = damping().cast<Complex>() * (loss_factor > 0.0 ? 0.0 : 1.0);
  const Eigen::VectorXcd force = Eigen::VectorXcd::Unit(size(), static_cast<Eigen::Index>(drive));
  Eigen::MatrixXcd all(static_cast<Eigen::Index>(hertz.size()), size());
  for (std::size_t i = 0; i < hertz.size(); ++i) {
    const Complex iw(0.0, 2.0 * std::numbers::pi * hertz[i]);
    const Eigen::MatrixXcd dynamic = k + iw * iw * m + iw * c;
    all.row(static_cast<Eigen::Index>(i)) =
        (std::pow(iw, derivatives) * dynamic.partialPivLu().solve(force)).transpose();
  }
  return all;
}

std::vector<double> even_frequencies(double from, double step, std::size_t count) {
  std::vector<double> hertz;
  for (std::size_t i = 0; i < count; ++i) hertz.push_back(from + step * static_cast<double>(i));
  return hertz;
}

void add_noise(double share, std::uint64_t seed, Eigen::MatrixXcd& responses) {
  RandomStream random(seed, 0);
  for (Eigen::Index j = 0; j < responses.cols(); ++j) {
    const double rms = responses.col(j).norm() / std::sqrt(static_cast<double>(responses.rows()));
    const double sigma = share * rms / std::numbers::sqrt2;
    for (Eigen::Index i = 0; i < responses.rows(); ++i) {
      responses(i, j) += std::complex<double>(sigma * random.normal(), sigma * random.normal());
    }
  }
}

std::string response_dataset(const UffResponse& of, const std::vector<double>& hertz,
                             const Eigen::VectorXcd& values) {
  constexpr std::array<int, 3> kTypes = {8, 11, 12};
  const auto p = static_cast<std::size_t>(of.derivatives);
  std::string text = "    -1\n    58\nNONE\nNONE\nNONE\nNONE\nNONE\n";
  text += fmt::format("{:5d}{:10d}{:5d}{:10d} {:<10}{:10d}{:4d} {:<10}{:10d}{:4d}\n",
                      of.function_type, 1, 1, 0, "NONE", of.response, of.response_direction, "NONE",
                      of.reference, of.reference_direction);
  text += fmt::format("{:10d}{:10d}{:10d}{:13.5E}{:13.5E}{:13.5E}\n", 6, hertz.size(), 1, hertz[0],
                      hertz[1] - hertz[0], 0.0);
  const auto quantity = [](int type, const std::string& label, const std::string& unit) {
    return fmt::format("{:10d}{:5d}{:5d}{:5d} {:<20} {:<20}\n", type, 0, 0, 0, label, unit);
  };
  text += quantity(18, "Frequency", "Hz") + quantity(kTypes[p], "Response", of.units[p]) +
          quantity(13, "Force", of.force_unit) + quantity(0, "NONE", "NONE");
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    text += fmt::format("{:20.12E}{:20.12E}{}", values(i).real(), values(i).imag(),
                        i % 2 == 1 || i + 1 == values.size() ? "\n" : "");
  }
  return text + "    -1\n";
}

std::string response_datasets(const TestedChain& chain, const std::vector<double>& hertz,
                              std::size_t drive, int derivatives, double noise) {
  Eigen::MatrixXcd responses = chain.responses(hertz, drive, derivatives);
  if (noise > 0.0) add_noise(noise, 1, responses);
  std::string text;
  for (std::size_t j = 0; j < chain.masses; ++j) {
    text += response_dataset({.response = static_cast<long long>(j) + 1,
                              .reference = static_cast<long long>(drive) + 1,
                              .derivatives = derivatives},
                             hertz, responses.col(static_cast<Eigen::Index>(j)));
  }
  return text;
}

std::string units_dataset(double per_metre, double per_newton) {
  return fmt::format(
      "    -1\n   164\n{:10d}{:<20}{:10d}\n{:25.17E}{:25.17E}{:25.17E}\n{:25.17E}\n"
      "    -1\n",
      9, "own", 2, per_metre, per_newton, 1.0, 0.0);
}

std::string shape_dataset(const UffShape& of, const Eigen::VectorXcd& values) {
  const bool complex = values.imag().norm() > 0.0;
  std::string text = "    -1\n    55\nNONE\nNONE\nNONE\nNONE\nNONE\n";
  text += fmt::format("{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}\n", 1, of.analysis, 2, of.specific_type,
                      complex ? 5 : 2, 3);
  text += fmt::format("{:10d}{:10d}{:10d}{:10d}\n", 2, of.reals.size(), 1, of.number);
  for (std::size_t i = 0; i < of.reals.size(); ++i) {
    text += fmt::format("{:13.5E}{}", of.reals[i], i + 1 == of.reals.size() ? "\n" : "");
  }
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    text += fmt::format("{:10d}\n", i + 1);
    const std::string zero = fmt::format("{:13.5E}", 0.0);
    const std::string imaginary = fmt::format("{:13.5E}", values(i).imag());
    const std::string real = fmt::format("{:13.5E}", values(i).real());
    text += complex ? zero + zero + zero + zero + real + imaginary : zero + zero + real;
    text += '\n';
  }
  return text + "    -1\n";
}

std::string analysis_dataset(const UffShape& of, const Eigen::VectorXcd& values) {
  const bool complex = values.imag().norm() > 0.0;
  const auto real = [&](std::size_t i) { return i < of.reals.size() ? of.reals[i] : 0.0; };
  const bool normal = of.analysis == 2;
  std::string text = fmt::format("    -1\n  2414\n{:10d}\n{:<80}\n{:10d}\n", of.number, "mode", 1);
  text += "NONE\nNONE\nNONE\nNONE\nNONE\n";
  text += fmt::format("{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}\n", 1, of.analysis, 2, of.specific_type,
                      complex ? 5 : 2, 3);
  text += fmt::format("{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}\n{:10d}{:10d}\n", 0, 0, 0,
                      0, 1, of.number, 0, 0, 0, 0);
  const double frequency = normal ? real(0) : 0.0;
  text += fmt::format("{:13.5E}{:13.5E}{:13.5E}{:13.5E}{:13.5E}{:13.5E}\n", 0.0, frequency, 0.0,
                      normal ? real(1) : 0.0, normal ? real(2) : 0.0, normal ? real(3) : 0.0);
  for (std::size_t i = 0; i < 6; ++i) text += fmt::format("{:13.5E}", normal ? 0.0 : real(i));
  text += '\n';
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    text += fmt::format("{:10d}\n", i + 1);
    const std::string zero = fmt::format("{:13.5E}", 0.0);
    text += complex ? zero + zero + zero + zero : zero + zero;
    text += fmt::format("{:13.5E}", values(i).real());
    if (complex) text += fmt::format("{:13.5E}", values(i).imag());
    text += '\n';
  }
  return text + "    -1\n";
}

}  // namespace microslip::test
