// SPDX-License-Identifier: MIT
#pragma once

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/policies/policy.hpp>
#include <cmath>

namespace microslip {

/// Double precision throughout: draws need no more.
using DrawPolicy = boost::math::policies::policy<boost::math::policies::promote_double<false>,
                                                 boost::math::policies::digits10<10>>;

/// χ² of m degrees of freedom; beyond some thousands by the cube root, which is normal to 1e-6
/// there [Wilson & Hilferty].
class ChiSquared {
 public:
  explicit ChiSquared(double count) : count_(count) {}

  /// Probability below a value.
  [[nodiscard]] double below(double value) const {
    if (count_ < kMany) return cdf(Exact(count_), value);
    return cdf(Normal(), (std::cbrt(value / count_) - middle()) / deviation());
  }

  /// The value below which a share lies. @param share  in (0, 1).
  [[nodiscard]] double quantile(double share) const {
    if (count_ < kMany) return boost::math::quantile(Exact(count_), share);
    return count_ * std::pow(middle() + deviation() * boost::math::quantile(Normal(), share), 3);
  }

 private:
  using Exact = boost::math::chi_squared_distribution<double, DrawPolicy>;
  using Normal = boost::math::normal_distribution<double, DrawPolicy>;
  static constexpr double kMany = 5000.0;

  [[nodiscard]] double middle() const { return 1.0 - 2.0 / (9.0 * count_); }
  [[nodiscard]] double deviation() const { return std::sqrt(2.0 / (9.0 * count_)); }

  double count_;
};

}  // namespace microslip
