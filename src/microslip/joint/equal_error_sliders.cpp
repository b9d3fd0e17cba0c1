// SPDX-License-Identifier: MIT
#include "microslip/joint/equal_error_sliders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/joint/continuous_moments.hpp"

namespace microslip {
namespace {

constexpr std::size_t kMostSliders = 100'000;
/// Of the weight of a density: less is rounding.
constexpr double kNoWeight = 1e-12;
/// Of the largest force: by less F itself is rounded.
constexpr double kLeastError = 1e-14;

/// A kink of a polygon: there its slope falls by `weight`.
struct Kink {
  double slip_force;  ///< s = kx, N
  double weight;      ///< 1
};

/// The sliders that are no atoms and slip up to a largest elastic force, over s = kx.
class ContinuousSliders {
 public:
  ContinuousSliders(const SlipDensity& density, double largest)
      : density_(density),
        end_(std::min(largest, density.largest_slip_force())),
        total_(continuous_moments(density, end_)) {}

  [[nodiscard]] double weight() const { return total_.zeroth; }
  /// The force when all of them slip, N.
  [[nodiscard]] double largest_force() const { return total_.first; }
  /// The largest slip force, N.
  [[nodiscard]] double end() const { return end_; }

  /// F(s) and F′(s).
  [[nodiscard]] std::pair<double, double> curve(double s) const {
    const PartialMoments m = continuous_moments(density_, s);
    const double slope = std::max(0.0, total_.zeroth - m.zeroth);
    return {m.first + s * slope, slope};
  }
  [[nodiscard]] double force(double s) const { return curve(s).first; }

 private:
  const SlipDensity& density_;
  double end_;
  PartialMoments total_;
};

/// Where a function changes its sign; an end of the range where it does not.
template <class Function>
double sign_change(const Function& f, double low, double high) {
  const double at_low = f(low);
  const double at_high = f(high);
  if (!(at_low * at_high < 0.0)) return std::abs(at_low) < std::abs(at_high) ? low : high;
  std::uintmax_t iterations = 200;
  const auto [a, b] = boost::math::tools::toms748_solve(
      f, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(50), iterations);
  return 0.5 * (a + b);
}

/// The polygon with the fewest kinks within F ± ε that begins with the slope of F and ends with its
/// largest force: each line is as long as the band allows.
class Polygon {
 public:
  Polygon(const ContinuousSliders& of, double error) : of_(of), error_(error) {}

  /// @param most  kinks; more are not sought. @return nothing where there are more.
  [[nodiscard]] std::vector<Kink> kinks(std::size_t most) const {
    std::vector<Kink> kinks;
    Line line{0.0, 0.0, of_.weight()};
    while (kinks.size() < most) {
      const double end = end_of(line);
      const bool is_last = end >= level_reached(line);
      const Line next = is_last ? Line{end, of_.largest_force(), 0.0} : line_from(end);
      kinks.push_back({end, line.slope - next.slope});
      if (is_last) return kinks;
      line = next;
    }
    return {};
  }

 private:
  struct Line {
    double from;  ///< s, N
    double force;
    double slope;
  };

  /// Where a line reaches the largest force of all.
  [[nodiscard]] double level_reached(const Line& line) const {
    return line.from + (of_.largest_force() - line.force) / line.slope;
  }

  /// Where it leaves the band through F + ε, or reaches the largest force before.
  [[nodiscard]] double end_of(const Line& line) const {
    const auto room = [&](double s) {
      return of_.force(s) + error_ - line.force - line.slope * (s - line.from);
    };
    const double level = level_reached(line);
    if (room(level) >= 0.0) return level;
    return sign_change(room, touching(line.from), level);
  }

  /// Where the line from F + ε at `from` touches F − ε: F′(s)(s − a) = F(s) − F(a) − 2ε.
  [[nodiscard]] double touching(double from) const {
    if (from == 0.0) return 0.0;
    const double start = of_.force(from);
    return sign_change(
        [&](double s) {
          const auto [force, slope] = of_.curve(s);
          return force - start - 2.0 * error_ - slope * (s - from);
        },
        from, of_.end());
  }

  /// The line that begins on F + ε. Where the band is as wide as all that is left of F, to its end.
  [[nodiscard]] Line line_from(double from) const {
    const double force = of_.force(from) + error_;
    const double s = touching(from);
    double slope = (of_.force(s) - error_ - force) / (s - from);
    const double least = (of_.largest_force() - force) / (of_.end() - from);
    slope = std::max(slope, least);
    return {from, force, slope};
  }

  const ContinuousSliders& of_;
  double error_;
};

/// With the smallest ε of which `count` kinks suffice.
std::pair<std::vector<Kink>, double> fewest_wrong(const ContinuousSliders& of, std::size_t count) {
  // One kink is off by no more than the largest force.
  double high = of.largest_force();
  double low = kLeastError * high;
  std::vector<Kink> found = Polygon(of, high).kinks(count);
  constexpr int kHalvings = 60;
  constexpr double kNear = 1e-6;
  for (int i = 0; i < kHalvings && high > low * (1.0 + kNear); ++i) {
    const double middle = std::sqrt(low * high);
    std::vector<Kink> kinks = Polygon(of, middle).kinks(count);
    if (kinks.empty()) {
      low = middle;
    } else {
      high = middle;
      found = std::move(kinks);
    }
  }
  return {std::move(found), high};
}

}  // namespace

std::size_t atoms_within(const Joint& joint, double reach) {
  return static_cast<std::size_t>(
      std::ranges::count_if(joint.density().atoms().slip_force,
                            [&](double f) { return f <= joint.stiffness() * reach; }));
}

EqualErrorSliders equal_error_sliders(const Joint& joint, std::size_t n, double reach) {
  if (!(reach > 0.0)) throw InputError("reach", reach, "must be above 0 m");
  const SlipDensity& density = joint.density();
  const AtomsPart& atoms = density.atoms();
  const std::size_t count = atoms_within(joint, reach);
  const ContinuousSliders continuous(density, joint.stiffness() * reach);
  const bool has_continuous = continuous.weight() > kNoWeight;
  const std::size_t needed = std::max<std::size_t>(1, count + has_continuous);
  if (n < needed || n > kMostSliders) {
    throw InputError("number of sliders", static_cast<double>(n),
                     fmt::format("must be from {} to {}: one per atom of this density, and one for "
                                 "the rest",
                                 needed, kMostSliders));
  }
  const double k = joint.stiffness();
  std::vector<JenkinsElement> elements;
  double error = 0.0;
  if (has_continuous) {
    const auto [kinks, largest] = fewest_wrong(continuous, n - count);
    error = largest;
    for (const Kink& kink : kinks) {
      elements.push_back({k * kink.weight, kink.weight * kink.slip_force});
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    elements.push_back({k * atoms.weight[i], atoms.weight[i] * atoms.slip_force[i]});
  }
  std::erase_if(elements, [](const JenkinsElement& e) { return !(e.stiffness > 0.0); });
  std::ranges::sort(elements, {},
                    [](const JenkinsElement& e) { return e.slip_force / e.stiffness; });
  const double stuck = density.total().zeroth - density.moments(k * reach).zeroth;
  return {JenkinsNetwork(elements, k * (density.elastic_remainder() + std::max(0.0, stuck))),
          error};
}

Joint joint_of(const JenkinsNetwork& network) {
  if (network.size() == 0) return Joint(network.elastic_stiffness(), SlipDensity());
  double k = network.elastic_stiffness();
  for (const double stiffness : network.stiffness()) k += stiffness;
  AtomsPart atoms;
  for (std::size_t i = 0; i < network.size(); ++i) {
    atoms.slip_force.push_back(k * network.slip_displacement()[i]);
    atoms.weight.push_back(network.stiffness()[i] / k);
  }
  return Joint(k, SlipDensity({std::move(atoms)}));
}

}  // namespace microslip
