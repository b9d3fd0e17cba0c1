// SPDX-License-Identifier: MIT
#include "microslip/joint/virgin_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "microslip/base/error.hpp"
#include "microslip/base/vector_clones.hpp"

namespace microslip {
namespace {

constexpr std::size_t kMostBucketsPerKnot = 64;
constexpr std::size_t kBlock = 64;  // samples

}  // namespace

VirginCurve::VirginCurve(const SlipDensity& density)
    : power_laws_(density.power_laws().begin(), density.power_laws().end()) {
  double force = 0.0;
  for (const SlipDensity::LinearSegment& segment : density.segments()) {
    if (!cubics_.empty()) {
      const Cubic& c = cubics_.back();
      const double t = segment.start - c.start;
      force = c.force + t * (c.slope - t * (c.half_p + t * c.sixth_q));
    }
    const double stuck = std::max(0.0, 1.0 - segment.moments.zeroth);
    cubics_.push_back({segment.start, force, stuck, segment.p / 2.0, segment.q / 6.0});
  }
  if (power_laws_.empty() && density.elastic_remainder() == 0.0) cubics_.back().slope = 0.0;
  fill_buckets();
  cubics_.push_back({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0, 0.0, 0.0});
}

// The table grows until no bucket contains two knots, or until its size stops being worth it; a
// crowded bucket is searched.
void VirginCurve::fill_buckets() {
  const std::size_t knots = cubics_.size();
  const double end = cubics_.back().start;
  double narrowest = end;
  for (std::size_t j = 1; j < knots; ++j) {
    narrowest = std::min(narrowest, cubics_[j].start - cubics_[j - 1].start);
  }
  const double wanted = end > 0.0 ? std::ceil(1.01 * end / narrowest) : 0.0;
  const auto most = static_cast<double>(kMostBucketsPerKnot * knots);
  crowded_ = wanted > most;
  last_bucket_ = std::min(wanted, most);
  buckets_per_newton_ = end > 0.0 ? last_bucket_ / end : 0.0;

  buckets_.resize(static_cast<std::size_t>(last_bucket_) + 1);
  std::size_t cubic = 0;
  for (std::size_t bucket = 0; bucket < buckets_.size(); ++bucket) {
    // A little below the lower edge: the product in Lookup may round either way.
    const double edge = (static_cast<double>(bucket) - 1e-6) / buckets_per_newton_;
    while (cubic + 1 < knots && cubics_[cubic + 1].start <= edge) ++cubic;
    buckets_[bucket] = static_cast<std::uint32_t>(cubic);
  }
}

// A block at a time, in three loops: what has the same form for all samples runs on vectors, the
// search of the segment and its cubic does not.
void VirginCurve::branch_forces(const Branch& branch, std::span<const double> x,
                                std::span<double> force) const {
  if (force.size() != x.size()) {
    throw InputError("length of force", static_cast<double>(force.size()),
                     fmt::format("must be that of the displacements, {}", x.size()));
  }
  const double origin = branch.force;
  const double scale = branch.scale;
  const Lookup find = lookup();
  std::array<double, kBlock> s;
  std::array<std::int32_t, kBlock> bucket;
  for (std::size_t begin = 0; begin < x.size(); begin += kBlock) {
    const std::size_t n = std::min(kBlock, x.size() - begin);
    elastic_forces(n, x.data() + begin, branch, s.data());
    find_buckets(n, s.data(), find, bucket.data());
    double* out = force.data() + begin;
    for (std::size_t i = 0; i < n; ++i) out[i] = linear_force(find.cubic(s[i], bucket[i]), s[i]);
    if (!power_laws_.empty()) {
      for (std::size_t i = 0; i < n; ++i) out[i] -= power_law_deficit(s[i]);
    }
    for (std::size_t i = 0; i < n; ++i) out[i] = origin + scale * out[i];
  }
}

MICROSLIP_VECTOR_CLONES
void VirginCurve::elastic_forces(std::size_t n, const double* x, const Branch& branch, double* s) {
  const double displacement = branch.displacement;
  const double newtons_per_metre = branch.newtons_per_metre;
  for (std::size_t i = 0; i < n; ++i) {
    const double elastic = newtons_per_metre * std::abs(x[i] - displacement);
    s[i] = elastic < 0.0 ? 0.0 : elastic;
  }
}

MICROSLIP_VECTOR_CLONES
void VirginCurve::find_buckets(std::size_t n, const double* s, const Lookup& find,
                               std::int32_t* bucket) {
  const double per_newton = find.buckets_per_newton;
  const double last = find.last_bucket;
  for (std::size_t i = 0; i < n; ++i) {
    const double position = s[i] * per_newton;
    bucket[i] = static_cast<std::int32_t>(position < last ? position : last);
  }
}

double VirginCurve::power_law_deficit(double s) const {
  double sum = 0.0;
  for (const PowerLawCurve& part : power_laws_) sum += part.force_deficit(s);
  return sum;
}

double VirginCurve::slope(double s) const {
  const Lookup find = lookup();
  s = std::max(s, 0.0);
  double slope = linear_slope(find.cubic(s, find.bucket(s)), s);
  for (const PowerLawCurve& part : power_laws_) slope -= part.weight(s);
  return std::clamp(slope, 0.0, 1.0);
}

VirginCurve::Response VirginCurve::response(double s) const {
  const Lookup find = lookup();
  s = std::max(s, 0.0);
  const Cubic& cubic = find.cubic(s, find.bucket(s));
  double slope = linear_slope(cubic, s);
  double deficit = 0.0;
  for (const PowerLawCurve& part : power_laws_) {
    const PowerLawSlip slip = part.slip(s);
    slope -= slip.weight;
    deficit += slip.force_deficit;
  }
  return {linear_force(cubic, s) - deficit, std::clamp(slope, 0.0, 1.0)};
}

}  // namespace microslip
