// SPDX-License-Identifier: MIT
#include "microslip/joint/jenkins_network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/base/vector_clones.hpp"
#include "microslip/joint/continuous_moments.hpp"
#include "microslip/joint/path.hpp"

namespace microslip {
namespace {

constexpr std::size_t kMostElements = 100'000'000;

void require(bool holds, std::size_t element, std::string_view field, double value) {
  if (!holds) {
    throw InputError(fmt::format("elements[{}].{}", element, field), value,
                     "must be positive and finite");
  }
}

// ---- Discretisation. ----

/// The density without its atoms, by the weight below a slip force.
class ContinuousPart {
 public:
  explicit ContinuousPart(const SlipDensity& density)
      : density_(density), total_(moments(density.largest_slip_force())) {}

  [[nodiscard]] double weight() const { return total_.zeroth; }

  [[nodiscard]] PartialMoments moments(double s) const { return continuous_moments(density_, s); }

  /// The slip force below which the weight is `weight`.
  [[nodiscard]] double quantile(double weight) const {
    const double end = density_.largest_slip_force();
    if (!(weight < total_.zeroth)) return end;
    const auto excess = [&](double s) { return moments(s).zeroth - weight; };
    std::uintmax_t iterations = 200;
    const auto [low, high] = boost::math::tools::toms748_solve(
        excess, 0.0, end, -weight, total_.zeroth - weight,
        boost::math::tools::eps_tolerance<double>(52), iterations);
    return 0.5 * (low + high);
  }

 private:
  const SlipDensity& density_;
  PartialMoments total_;
};

/// Two elements with the three moments of the weight between two slip forces. Of equal weight at
/// mean ± standard deviation where both lie in the bin; else one at the upper edge
/// (Gauss–Radau), which always does. In a bin as narrow as rounding the moments contradict its
/// edges: the edges take precedence.
void add_pair(const PartialMoments& moments, double upper, double lower, double k,
              std::vector<JenkinsElement>& elements) {
  const double mean = std::clamp(moments.first / moments.zeroth, lower, upper);
  const double variance = std::clamp(moments.second / moments.zeroth - mean * mean, 0.0,
                                     (mean - lower) * (upper - mean));
  const double deviation = std::sqrt(variance);
  const auto add = [&](double weight, double f) { elements.push_back({k * weight, weight * f}); };
  if (mean + deviation <= upper && mean - deviation > lower) {
    add(0.5 * moments.zeroth, mean - deviation);
    add(0.5 * moments.zeroth, mean + deviation);
    return;
  }
  const double gap = upper - mean;
  const double share = variance / (gap * gap + variance);
  add((1.0 - share) * moments.zeroth, mean - variance / gap);
  add(share * moments.zeroth, upper);
}

void add_bins(const ContinuousPart& part, std::size_t count, double k,
              std::vector<JenkinsElement>& elements) {
  PartialMoments below{};
  double lower = 0.0;
  for (std::size_t done = 0; done < count;) {
    const std::size_t step = std::min<std::size_t>(2, count - done);
    done += step;
    const double share = static_cast<double>(done) / static_cast<double>(count);
    const double upper = std::max(lower, part.quantile(share * part.weight()));
    const PartialMoments up_to = part.moments(upper);
    const PartialMoments bin{up_to.zeroth - below.zeroth, up_to.first - below.first,
                             up_to.second - below.second};
    if (!(bin.zeroth > 0.0)) continue;  // narrower than rounding: the next bin takes its share
    if (step == 2) {
      add_pair(bin, upper, lower, k, elements);
    } else {
      elements.push_back({k * bin.zeroth, bin.first});
    }
    below = up_to;
    lower = upper;
  }
}

// ---- Marching: the loops over the elements. ----

// Each lane has a sum of its own, so that the additions come in one order whatever the vector
// width.
constexpr std::size_t kLanes = 8;

double sum_of(const double (&lanes)[kLanes]) {
  return ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) +
         ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]));
}

/// Slider positions follow x within ± slip displacement (play operator). @return Σ κ(x − z).
MICROSLIP_VECTOR_CLONES
double advance_sliders(std::size_t n, const double* stiffness, const double* slip, double* position,
                       double x) {
  double lanes[kLanes] = {};
  for (std::size_t i = 0; i < n; i += kLanes) {
#pragma omp simd
    for (std::size_t j = 0; j < kLanes; ++j) {
      const double lowest = x - slip[i + j];
      const double highest = x + slip[i + j];
      double z = position[i + j];
      z = z < lowest ? lowest : z;
      z = z > highest ? highest : z;
      position[i + j] = z;
      lanes[j] += stiffness[i + j] * (x - z);
    }
  }
  return sum_of(lanes);
}

/// Stretches grow by dx and stay within ± limit·slip displacement. @return Σ κ·stretch.
MICROSLIP_VECTOR_CLONES
double advance_stretches(std::size_t n, const double* stiffness, const double* slip,
                         double* stretch, double dx, double limit) {
  double lanes[kLanes] = {};
  for (std::size_t i = 0; i < n; i += kLanes) {
#pragma omp simd
    for (std::size_t j = 0; j < kLanes; ++j) {
      const double largest = limit * slip[i + j];
      double e = stretch[i + j] + dx;
      e = e > largest ? largest : e;
      e = e < -largest ? -largest : e;
      stretch[i + j] = e;
      lanes[j] += stiffness[i + j] * e;
    }
  }
  return sum_of(lanes);
}

}  // namespace

JenkinsNetwork::JenkinsNetwork(std::span<const JenkinsElement> elements, double elastic_stiffness)
    : size_(elements.size()), elastic_stiffness_(elastic_stiffness) {
  if (!(std::isfinite(elastic_stiffness) && elastic_stiffness >= 0.0)) {
    throw InputError("elastic_stiffness", elastic_stiffness, "must be 0 or more, and finite");
  }
  if (elements.empty() && elastic_stiffness == 0.0) {
    throw InputError("elements", "none", "a network needs at least one element or a spring");
  }
  stiffness_.reserve(elements.size());
  slip_displacement_.reserve(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto [stiffness, slip_force] = elements[i];
    require(std::isfinite(stiffness) && stiffness > 0.0, i, "stiffness", stiffness);
    require(std::isfinite(slip_force) && slip_force > 0.0, i, "slip_force", slip_force);
    stiffness_.push_back(stiffness);
    slip_displacement_.push_back(slip_force / stiffness);
  }
  // Elements without stiffness fill the last group of lanes.
  const std::size_t padded = (size_ + kLanes - 1) / kLanes * kLanes;
  stiffness_.resize(padded, 0.0);
  slip_displacement_.resize(padded, 0.0);
}

JenkinsNetwork JenkinsNetwork::discretise(const Joint& joint, std::size_t n) {
  const SlipDensity& density = joint.density();
  const AtomsPart& atoms = density.atoms();
  const ContinuousPart continuous(density);
  const bool has_continuous = continuous.weight() > 1e-12;
  const std::size_t needed = std::max<std::size_t>(1, atoms.weight.size() + has_continuous);
  if (n < needed) {
    throw InputError(
        "number of elements", static_cast<double>(n),
        fmt::format("must be at least {} for this density: one per atom, and one for the rest",
                    needed));
  }
  if (n > kMostElements) {
    throw InputError("number of elements", static_cast<double>(n),
                     fmt::format("must be at most {}", kMostElements));
  }
  const double k = joint.stiffness();
  std::vector<JenkinsElement> elements;
  elements.reserve(n);
  if (has_continuous) add_bins(continuous, n - atoms.weight.size(), k, elements);
  for (std::size_t i = 0; i < atoms.weight.size(); ++i) {
    elements.push_back({k * atoms.weight[i], atoms.weight[i] * atoms.slip_force[i]});
  }
  std::erase_if(elements, [](const JenkinsElement& e) { return !(e.stiffness > 0.0); });
  return JenkinsNetwork(elements, k * density.elastic_remainder());
}

NetworkMemory::NetworkMemory(const JenkinsNetwork& network, NormalLoadLaw law)
    : network_(&network), law_(law), state_(network.stiffness_.size(), 0.0) {}

double NetworkMemory::advance(double x) { return advance(x, 1.0); }

double NetworkMemory::advance(double x, double p) {
  double force = 0.0;  // of this step alone
  check_path({&x, 1}, {&p, 1}, {&force, 1});
  return move_to(x, p);
}

double NetworkMemory::move_to(double x, double p) {
  const double* stiffness = network_->stiffness_.data();
  const double* slip = network_->slip_displacement_.data();
  const std::size_t n = state_.size();
  if (law_ == NormalLoadLaw::kTotal) {
    x_ = x;
    const double sliders = advance_sliders(n, stiffness, slip, state_.data(), x);
    return p * (sliders + network_->elastic_stiffness() * x);
  }
  const double mean_load = load_known_ ? 0.5 * (p_ + p) : p;
  const double dx = mean_load * (x - x_);
  spring_ += dx;
  x_ = x;
  p_ = p;
  load_known_ = true;
  return advance_stretches(n, stiffness, slip, state_.data(), dx, p) +
         network_->elastic_stiffness() * spring_;
}

void NetworkMemory::march(std::span<const double> x, std::span<double> force) {
  check_path(x, force);
  for (std::size_t i = 0; i < x.size(); ++i) force[i] = move_to(x[i], 1.0);
}

void NetworkMemory::march(std::span<const double> x, std::span<const double> normal_load,
                          std::span<double> force) {
  check_path(x, normal_load, force);
  for (std::size_t i = 0; i < x.size(); ++i) force[i] = move_to(x[i], normal_load[i]);
}

}  // namespace microslip
