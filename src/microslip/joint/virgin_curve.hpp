// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "microslip/joint/density.hpp"
#include "microslip/joint/power_law_curve.hpp"

namespace microslip {

/// The virgin curve of a density over the elastic force s = kx, N:
///
///     F(s) = Φ1(s) + s[1 − Φ0(s)],    dF/ds = 1 − Φ0(s),    s ≥ 0       [AR14 (2) (4)]
///
/// On a piecewise-linear density F is a cubic spline: its coefficients are tabulated, and a table
/// of equal buckets, fine enough to contain one knot each where the knots are not wildly uneven,
/// finds the segment without a search. Power laws add their closed form.
class VirginCurve {
 public:
  /// Tabulates the curve; the density is not needed any more afterwards.
  explicit VirginCurve(const SlipDensity& density);

  /// F(s), N. @param s  kx, N; ≥ 0, finite. Below 0 it is that of 0; NaN where s is NaN or
  /// infinite.
  [[nodiscard]] double force(double s) const {
    const Lookup find = lookup();
    s = std::max(s, 0.0);  // in this order NaN stays
    const double force = linear_force(find.cubic(s, find.bucket(s)), s);
    return power_laws_.empty() ? force : force - power_law_deficit(s);
  }

  /// One branch of a loop: force + scale·F(newtons_per_metre·|x − displacement|).
  struct Branch {
    double displacement;       ///< m
    double force;              ///< N
    double newtons_per_metre;  ///< N/m
    double scale;              ///< 1
  };

  /// Force on a branch at each x.
  /// @param branch  of any loop.
  /// @param x       m; finite. NaN where it is not.
  /// @param force   N; of the length of x; may be x itself.
  /// @throws InputError  for another length.
  void branch_forces(const Branch& branch, std::span<const double> x,
                     std::span<double> force) const;

  /// dF/ds = 1 − Φ0(s), 1, in [0, 1]. At an atom the value beyond it; s as in force().
  [[nodiscard]] double slope(double s) const;

  /// Force and slope together.
  struct Response {
    double force;  ///< F, N
    double slope;  ///< dF/ds, 1
  };
  /// Force and slope at little more than the cost of one. @param s  as in force().
  [[nodiscard]] Response response(double s) const;

 private:
  /// F = force + t·(slope − t·(half_p + t·sixth_q)), t = s − start.
  struct Cubic {
    double start;
    double force;
    double slope;
    double half_p;
    double sixth_q;
  };

  /// Lookup table of the cubic of an s; small, so that a loop keeps it in registers.
  struct Lookup {
    const Cubic* cubics;
    const std::uint32_t* buckets;
    double buckets_per_newton;
    double last_bucket;
    bool crowded;

    /// The bucket of an s ≥ 0; the last for NaN, by the order of the comparison.
    [[nodiscard]] std::int32_t bucket(double s) const {
      return static_cast<std::int32_t>(std::min(last_bucket, s * buckets_per_newton));
    }

    /// The last cubic with start ≤ s. Inline and without a branch in the common case: it runs once
    /// per sample of every simulation.
    [[nodiscard]] const Cubic& cubic(double s, std::int32_t bucket_of_s) const {
      std::size_t j = buckets[bucket_of_s];
      j += static_cast<std::size_t>(cubics[j + 1].start <= s);  // a sum: no branch to mispredict
      if (crowded) [[unlikely]] {
        while (cubics[j + 1].start <= s) ++j;  // ends at the sentinel
      }
      return cubics[j];
    }
  };

  [[nodiscard]] Lookup lookup() const {
    return {cubics_.data(), buckets_.data(), buckets_per_newton_, last_bucket_, crowded_};
  }

  /// F without the power laws.
  [[nodiscard]] static double linear_force(const Cubic& c, double s) {
    const double t = s - c.start;
    return c.force + t * (c.slope - t * (c.half_p + t * c.sixth_q));
  }

  /// Slope of linear_force().
  [[nodiscard]] static double linear_slope(const Cubic& c, double s) {
    const double t = s - c.start;
    return c.slope - t * (2.0 * c.half_p + 3.0 * t * c.sixth_q);
  }

  static void elastic_forces(std::size_t n, const double* x, const Branch& branch, double* s);
  static void find_buckets(std::size_t n, const double* s, const Lookup& find,
                           std::int32_t* bucket);
  void fill_buckets();
  [[nodiscard]] double power_law_deficit(double s) const;

  std::vector<Cubic> cubics_;  // by rising start; a sentinel at infinity ends it
  std::vector<std::uint32_t>
      buckets_;  // last cubic that starts at or below the bucket's lower edge
  double buckets_per_newton_ = 0.0;
  double last_bucket_ = 0.0;
  bool crowded_ = false;  // some bucket contains more than one knot
  std::vector<PowerLawCurve> power_laws_;
};

}  // namespace microslip
