// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

#include "microslip/joint/density.hpp"
#include "support/quadrature.hpp"

namespace microslip::testing {

/// A density read from the definitions of its parts, in long double: nothing of what SlipDensity
/// makes of them is used.
class ExactDensity {
 public:
  explicit ExactDensity(const SlipDensity& density) {
    for (const DensityPart& part : density.parts())
      std::visit([this](const auto& p) { add(p); }, part);
  }

  /// φ(f*) without atoms.
  [[nodiscard]] long double operator()(long double f) const {
    long double sum = 0.0L;
    for (const Piece& piece : pieces_) {
      if (f < piece.from || f >= piece.to) continue;
      sum += piece.coefficient * std::pow(f, piece.exponent);
      sum += piece.value + piece.slope * (f - piece.from);
    }
    return sum;
  }

  /// ∫₀ˢ w(f*) φ df*, the atoms at s included, by quadrature.
  template <typename Weight>
  [[nodiscard]] long double integral(const Weight& w, long double s) const {
    const auto integrand = [&](long double f) { return w(f) * (*this)(f); };
    long double sum = integrate(integrand, 0.0L, s, kinks());
    for (const Atom& atom : atoms_) {
      if (atom.slip_force <= s) sum += atom.weight * w(atom.slip_force);
    }
    return sum;
  }

  /// Where φ is not smooth, and the atoms, N.
  [[nodiscard]] std::vector<double> kinks() const {
    std::vector<double> all;
    for (const Piece& piece : pieces_) {
      all.push_back(static_cast<double>(piece.from));
      all.push_back(static_cast<double>(piece.to));
    }
    for (const Atom& atom : atoms_) all.push_back(static_cast<double>(atom.slip_force));
    return all;
  }

 private:
  /// φ = coefficient·f^exponent + value + slope·(f − from) on [from, to).
  struct Piece {
    long double from;
    long double to;
    long double coefficient;
    long double exponent;
    long double value;
    long double slope;
  };
  struct Atom {
    long double slip_force;
    long double weight;
  };

  void add(const UniformPart& p) {
    const long double width = static_cast<long double>(p.to) - p.from;
    pieces_.push_back({p.from, p.to, 0.0L, 0.0L, p.weight / width, 0.0L});
  }
  void add(const PowerLawPart& p) {
    pieces_.push_back({p.from, p.to, p.coefficient, p.exponent, 0.0L, 0.0L});
  }
  void add(const PiecewiseLinearPart& p) {
    for (std::size_t i = 0; i + 1 < p.slip_force.size(); ++i) {
      const long double width = static_cast<long double>(p.slip_force[i + 1]) - p.slip_force[i];
      const long double rise = static_cast<long double>(p.density[i + 1]) - p.density[i];
      pieces_.push_back(
          {p.slip_force[i], p.slip_force[i + 1], 0.0L, 0.0L, p.density[i], rise / width});
    }
  }
  void add(const AtomsPart& p) {
    for (std::size_t i = 0; i < p.slip_force.size(); ++i) {
      atoms_.push_back({p.slip_force[i], p.weight[i]});
    }
  }
  // Rψ^χ dψ on [0, ψ_max] and S at ψ_max, in N/m, over K_T are φ df* and an atom, f* = K_T ψ.
  void add(const FourParameterPart& p) {
    const long double k = p.stiffness;
    const long double chi = p.chi;
    const long double shape = p.beta + (chi + 1.0L) / (chi + 2.0L);
    const long double psi_max = p.macroslip_force * (1.0L + p.beta) / (k * shape);
    const long double r =
        p.macroslip_force * (chi + 1.0L) / (std::pow(psi_max, chi + 2.0L) * shape);
    const long double s = p.macroslip_force * static_cast<long double>(p.beta) / (psi_max * shape);
    pieces_.push_back({0.0L, k * psi_max, r / (k * k * std::pow(k, chi)), chi, 0.0L, 0.0L});
    atoms_.push_back({k * psi_max, s / k});
  }

  std::vector<Piece> pieces_;
  std::vector<Atom> atoms_;
};

}  // namespace microslip::testing
