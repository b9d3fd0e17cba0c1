// SPDX-License-Identifier: MIT
#include "microslip/structure/beam_modes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/algebra/core.hpp"
#include "microslip/base/error.hpp"
#include "structure/beams.hpp"
#include "structure/exact_beam.hpp"
#include "structure/hermite_beam.hpp"
#include "support/effort.hpp"
#include "support/figures.hpp"
#include "support/reference_csv.hpp"

namespace microslip::beam_modes_test {
namespace {

using std::numbers::pi;
using testing::ExactBeam;
using testing::kInfinity;
using testing::random_beam;
using testing::reference_beam;
using testing::unit_beam;

const auto kBeams = static_cast<std::uint64_t>(test::cases_of(60));  // random ones

/// λ_i = √ω_i of a unit beam.
double lambda(const BeamModes& modes, std::size_t i) {
  return std::sqrt(modes.angular_frequencies()[i]);
}

/// The root of an increasing function between a and b.
template <typename Function>
double root_between(long double a, long double b, const Function& f) {
  for (int i = 0; i < 100; ++i) {
    const long double middle = (a + b) / 2.0L;
    (f(middle) < 0.0L ? a : b) = middle;
  }
  return static_cast<double>(a);
}

struct WeightedPoint {
  double x;
  double weight;  // m
};

/// A rule of the test's own for ∫₀ᴸ: 20 Gauss points on each of 12 parts between two masses,
/// enough for one wave per part to rounding.
std::vector<WeightedPoint> quadrature(const Beam& beam) {
  using Rule = boost::math::quadrature::gauss<double, 20>;
  constexpr int kParts = 12;
  std::vector<double> ends = {0.0, beam.length};
  for (const PointMass& m : beam.masses) ends.push_back(m.position);
  std::ranges::sort(ends);
  std::vector<WeightedPoint> points;
  for (std::size_t span = 0; span + 1 < ends.size(); ++span) {
    const double half = (ends[span + 1] - ends[span]) / (2 * kParts);
    for (int part = 0; part < kParts; ++part) {
      const double centre = ends[span] + (2 * part + 1) * half;
      for (std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
        points.push_back({centre - half * Rule::abscissa()[k], half * Rule::weights()[k]});
        points.push_back({centre + half * Rule::abscissa()[k], half * Rule::weights()[k]});
      }
    }
  }
  return points;
}

/// Largest deviation of ∫ρAφφdx + Σmφφ from δ_ij.
double orthonormality_error(const Beam& beam, const BeamModes& modes) {
  std::vector<WeightedPoint> points = quadrature(beam);
  for (WeightedPoint& point : points) point.weight *= beam.mass_per_length;
  for (const PointMass& m : beam.masses) points.push_back({m.position, m.mass});
  const auto n = static_cast<Eigen::Index>(modes.size());
  Eigen::MatrixXd product = -Eigen::MatrixXd::Identity(n, n);
  for (const auto& [x, weight] : points) {
    const std::vector<double> shapes = modes.shapes(x);
    const Eigen::Map<const Eigen::VectorXd> phi(shapes.data(), n);
    product += weight * phi * phi.transpose();
  }
  return product.cwiseAbs().maxCoeff();
}

// ---- Against results of another program. ----

// 583 Hermite elements in double precision. The elements are fine enough for 1e-7, but rounding
// leaves the frequencies 3.2e-5, and useless ones with the stiffest spring: 77.65 Hz, by the closed
// form of the clamped beam, are 79.38 Hz there. The frequencies are tested to 1e-13 below; shapes
// and integrals suffer less. Shapes are compared on the scale of the largest one, 2 kg^−½.
TEST(BeamModes, AgreeWithFiniteElements) {
  const auto table = testing::reference_table("beam_modes.csv");
  ASSERT_EQ(table.rows(), 56U);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto value = [&](const char* name) { return table[name][row]; };
    const double spring = value("torsional_stiffness [N m/rad]");
    const Beam beam = reference_beam(spring, value("sensor_masses [1]") != 0.0);
    const BeamModes modes(beam, 7);
    const auto mode = static_cast<std::size_t>(value("mode [1]")) - 1;
    SCOPED_TRACE(::testing::Message() << "row " << row);
    if (spring < 1e6) {
      const double frequency = value("frequency [Hz]");
      EXPECT_NEAR(modes.frequency(mode), frequency, 4e-5 * frequency);
    }
    EXPECT_NEAR(modes.shapes(0.55)[mode], value("shape_0.55 [kg^-1/2]"), 2e-5);
    EXPECT_NEAR(modes.shapes(0.35)[mode], value("shape_0.35 [kg^-1/2]"), 2e-5);
    EXPECT_NEAR(modes.shapes(0.18)[mode], value("shape_0.18 [kg^-1/2]"), 2e-5);
    test::record_largest("shape [1]",
                         std::abs(modes.shapes(0.35)[mode] - value("shape_0.35 [kg^-1/2]")) / 2.0);
    const double slope = value("tip_slope [kg^-1/2/m]");
    EXPECT_NEAR(modes.tip_slopes()[mode], slope, 1e-5 * std::abs(slope));
    test::record_deviation("slope", modes.tip_slopes()[mode], slope);
    const double integral = value("slope_integral [1/(kg m)]");
    EXPECT_NEAR(modes.slope_integral(mode, mode), integral, 1e-5 * integral);
  }
}

// ---- Against closed forms. ----

// tan λ = tanh λ; the root nearest to (i + 5/4)π. Tolerance: rounding of λ.
TEST(BeamModes, OfTheClampedAndPinnedBeam) {
  const BeamModes modes(unit_beam(0.0), 200);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const long double middle =
        (static_cast<long double>(i) + 1.25L) * std::numbers::pi_v<long double>;
    const double exact = root_between(middle - 0.1L, middle + 0.1L,
                                      [](long double x) { return std::tan(x) - std::tanh(x); });
    ASSERT_NEAR(lambda(modes, i), exact, 1e-15 * exact) << i;
    test::record_largest("frequency [1]", std::abs(std::pow(lambda(modes, i) / exact, 2) - 1.0));
  }
}

// cos λ cosh λ = 1, near (i + 3/2)π, where cos λ alone is solved for: cos λ = 1/cosh λ.
TEST(BeamModes, OfTheBeamClampedAtBothEnds) {
  const BeamModes modes(unit_beam(kInfinity), 200);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const long double middle =
        (static_cast<long double>(i) + 1.5L) * std::numbers::pi_v<long double>;
    const long double sign = i % 2 == 0 ? 1.0L : -1.0L;
    const double exact = root_between(middle - 0.1L, middle + 0.1L, [&](long double x) {
      return sign * (std::cos(x) - 1.0L / std::cosh(x));
    });
    ASSERT_NEAR(lambda(modes, i), exact, 1e-15 * exact) << i;
    ASSERT_EQ(modes.tip_slopes()[i], 0.0);
  }
}

// ω² = k/m with k the static stiffness of the beam at the mass, x = a from the clamp:
// 12 EI L³/(a³ (L − a)² (4L − a)); the beam adds its share of the mass, which is small.
TEST(BeamModes, OfAHeavyMassOnALightBeam) {
  for (const double a : {0.1, 0.37, 0.5, 0.95}) {
    Beam beam = unit_beam(0.0);
    beam.masses = {{a, 1e13}};
    const BeamModes modes(beam, 1);
    const double stiffness = 12.0 / (a * a * a * (1.0 - a) * (1.0 - a) * (4.0 - a));
    const double exact = std::sqrt(stiffness / 1e13);
    EXPECT_NEAR(modes.angular_frequencies()[0], exact, 1e-12 * exact) << a;
  }
}

// ---- Against the textbook determinant in 50 digits. ----

TEST(BeamModes, AreRootsOfTheTextbookDeterminant) {
  std::vector<Beam> beams;
  for (const double spring : {0.0, 50.0, 153.0, 1e9, kInfinity}) {
    beams.push_back(reference_beam(spring, false));
    beams.push_back(reference_beam(spring, true));
  }
  for (std::uint64_t seed = 0; seed < kBeams; ++seed) beams.push_back(random_beam(seed));
  for (std::size_t b = 0; b < beams.size(); ++b) {
    const BeamModes modes(beams[b], 8);
    const ExactBeam exact(beams[b]);
    for (const double omega : modes.angular_frequencies()) {
      EXPECT_TRUE(exact.has_root_near(omega, 1e-14)) << "beam " << b << ", " << omega << " rad/s";
    }
  }
}

// Shape and slope at many places; those of the textbook are scaled to the library's where it is
// largest. Close frequencies and heavy masses cost some digits.
TEST(BeamModes, HaveTheShapesOfTheTextbook) {
  for (std::uint64_t seed = 0; seed < test::draws_of(5, 3); ++seed) {
    const Beam beam = random_beam(seed);
    const BeamModes modes(beam, 6);
    const ExactBeam exact(beam);
    std::vector<double> places;
    for (int k = 0; k <= 15; ++k) places.push_back(k * beam.length / 15.0);
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const auto expected = exact.shape(exact.root(modes.angular_frequencies()[i], 1e-13), places);
      const auto largest =
          std::ranges::max_element(expected, {}, [](const auto& y) { return abs(y[0]); }) -
          expected.begin();
      const auto at = static_cast<std::size_t>(largest);
      const double size = std::abs(modes.shapes(places[at])[i]);
      const ExactBeam::Real scale = modes.shapes(places[at])[i] / expected[at][0];
      for (std::size_t k = 0; k < places.size(); ++k) {
        EXPECT_NEAR(modes.shapes(places[k])[i], static_cast<double>(expected[k][0] * scale),
                    1e-12 * size)
            << "beam " << seed << ", mode " << i << ", place " << k;
        EXPECT_NEAR(modes.slopes(places[k])[i], static_cast<double>(expected[k][1] * scale),
                    2e-11 * size / beam.length)
            << "beam " << seed << ", mode " << i << ", place " << k;
      }
      if (std::isinf(beam.tip_stiffness)) continue;
      const auto tip = static_cast<double>(expected.back()[1] * scale);
      EXPECT_NEAR(modes.tip_slopes()[i], tip, 1e-11 * std::abs(tip)) << "beam " << seed;
    }
  }
}

// ---- None is missed. ----

// Hermite elements see all modes of a random beam, from above. Masses are moved to nodes.
// Tolerance: the elements' own error, (λh)⁴/720 for λ of the eighth mode up to 27, and their
// rounding.
TEST(BeamModes, AreThoseOfHermiteElementsToTheLastOne) {
  constexpr int kElements = 100;
  for (std::uint64_t seed = 0; seed < kBeams; ++seed) {
    Beam beam = random_beam(seed);
    for (PointMass& m : beam.masses) {
      m.position = beam.length * std::round(m.position / beam.length * kElements) / kElements;
    }
    if (!std::isinf(beam.tip_stiffness)) {  // rounding of the elements grows with the spring
      beam.tip_stiffness = std::min(beam.tip_stiffness, 1e3 * beam.bending_stiffness / beam.length);
    }
    const std::vector<double> elements = testing::hermite_frequencies(beam, kElements);
    const BeamModes modes(beam, 8);
    for (std::size_t i = 0; i < modes.size(); ++i) {
      EXPECT_NEAR(modes.angular_frequencies()[i], elements[i], 1e-5 * elements[i])
          << "beam " << seed << ", mode " << i;
    }
  }
}

// The error of the elements against the exact frequencies falls by 2⁴ as their number doubles.
TEST(BeamModes, AreWhatHermiteElementsConvergeToWithOrderFour) {
  Beam beam = reference_beam(153.0, false);
  beam.masses = {{0.25 * beam.length, 0.03}, {0.75 * beam.length, 0.2}};
  const BeamModes modes(beam, 4);
  const std::vector<double> coarse = testing::hermite_frequencies(beam, 8);
  const std::vector<double> fine = testing::hermite_frequencies(beam, 16);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const double exact = modes.angular_frequencies()[i];
    EXPECT_NEAR(std::log2((coarse[i] - exact) / (fine[i] - exact)), 4.0, 0.15) << i;
  }
}

TEST(NaturalFrequenciesBelow, CountsTheModes) {
  for (std::uint64_t seed = 0; seed < kBeams; ++seed) {
    const Beam beam = random_beam(seed);
    const BeamModes modes(beam, 12);
    const auto omega = modes.angular_frequencies();
    EXPECT_EQ(natural_frequencies_below(beam, 0.0), 0U);
    for (std::size_t i = 0; i < modes.size(); ++i) {
      EXPECT_EQ(natural_frequencies_below(beam, omega[i] * (1.0 - 1e-12)), i) << seed;
      EXPECT_EQ(natural_frequencies_below(beam, omega[i] * (1.0 + 1e-12)), i + 1) << seed;
    }
  }
}

// The count never falls as ω rises, and changes by one where the textbook's determinant changes its
// sign.
TEST(NaturalFrequenciesBelow, HasTheParityOfTheTextbookDeterminant) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Beam beam = random_beam(seed);
    const ExactBeam exact(beam);
    const double step = BeamModes(beam, 10).angular_frequencies().back() / 40.5;
    std::size_t previous = 0;
    for (int i = 1; i <= 40; ++i) {
      const std::size_t below = natural_frequencies_below(beam, i * step);
      EXPECT_GE(below, previous);
      const int sign = exact.determinant(i * step).sign() * exact.determinant(1e-3 * step).sign();
      EXPECT_EQ(sign, below % 2 == 0 ? 1 : -1) << seed << ", " << i;
      previous = below;
    }
  }
}

// Two masses m a distance d apart clamp the beam between them but for a share of the order d and
// 1/(m d²): it falls apart into two equal halves, whose modes come in pairs.
TEST(BeamModes, AreTwoWhereTwoFrequenciesAreClose) {
  for (const double d : {1e-2, 1e-4, 1e-6, 1e-8}) {
    Beam beam = unit_beam(kInfinity);
    beam.masses = {{0.5 - d, std::pow(d, -3)}, {0.5 + d, std::pow(d, -3)}};
    const BeamModes modes(beam, 12);
    const testing::ExactBeamIn<100> exact(beam);
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const double omega = modes.angular_frequencies()[i];
      EXPECT_TRUE(exact.has_root_near(omega, 1e-13)) << d << ", " << i;
      EXPECT_EQ(natural_frequencies_below(beam, omega * (1.0 - 1e-12)), i) << d;
      EXPECT_EQ(natural_frequencies_below(beam, omega * (1.0 + 1e-12)), i + 1) << d;
    }
    for (std::size_t i = 2; i < modes.size(); i += 2) {  // the first two are those of the masses
      EXPECT_NEAR(lambda(modes, i), lambda(modes, i + 1), 10.0 * d * lambda(modes, i));
    }
    EXPECT_LT(orthonormality_error(beam, modes), 1e-11) << d;
  }
}

// ---- Normalisation, integrals, sensitivity. ----

TEST(BeamModes, AreOrthonormalWithTheMasses) {
  for (std::uint64_t seed = 0; seed < kBeams; ++seed) {
    const Beam beam = random_beam(seed);
    EXPECT_LT(orthonormality_error(beam, BeamModes(beam, 10)), 1e-11) << seed;
  }
}

TEST(BeamModes, GiveTheIntegralsOfTheSlopes) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Beam beam = random_beam(seed);
    const BeamModes modes(beam, 8);
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(8, 8);
    for (const auto& [x, weight] : quadrature(beam)) {
      const std::vector<double> slopes = modes.slopes(x);
      const Eigen::Map<const Eigen::VectorXd> slope(slopes.data(), 8);
      expected += weight * slope * slope.transpose();
    }
    const double scale = expected.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < 8; ++i) {
      for (Eigen::Index j = 0; j < 8; ++j) {
        const double found =
            modes.slope_integral(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
        EXPECT_NEAR(found, expected(i, j), 1e-13 * scale) << seed;
      }
    }
  }
}

TEST(BeamModes, MeetTheConditionsAtBothEnds) {
  for (std::uint64_t seed = 0; seed < kBeams; ++seed) {
    const Beam beam = random_beam(seed);
    const BeamModes modes(beam, 5);
    const double largest = 5.0 / std::sqrt(beam.mass_per_length * beam.length);
    for (std::size_t i = 0; i < modes.size(); ++i) {
      EXPECT_EQ(modes.shapes(0.0)[i], 0.0);
      EXPECT_EQ(modes.slopes(0.0)[i], 0.0);
      EXPECT_NEAR(modes.shapes(beam.length)[i], 0.0, 1e-12 * largest);
      EXPECT_NEAR(modes.slopes(beam.length)[i], modes.tip_slopes()[i],
                  1e-12 * largest * 30.0 / beam.length);
      EXPECT_LE(modes.tip_slopes()[i], 0.0);
    }
    EXPECT_GT(modes.shapes(0.5 * beam.length)[0], 0.0);
  }
}

// ∂ω²/∂k_θ = φ′(L)² against central differences; error of the order step² relative, and rounding of
// ω² over the step.
TEST(BeamModes, ChangeWithTheSpringAsTheTipSlopesSay) {
  for (std::uint64_t seed = 0; seed < kBeams; ++seed) {
    Beam beam = random_beam(seed);
    const double unit = beam.bending_stiffness / beam.length;
    if (!(beam.tip_stiffness > 0.1 * unit && beam.tip_stiffness < 1e3 * unit)) {
      beam.tip_stiffness = 3.0 * unit;
    }
    const BeamModes modes(beam, 5);
    const double step = 1e-4 * beam.tip_stiffness;
    Beam softer = beam;
    softer.tip_stiffness -= step;
    Beam stiffer = beam;
    stiffer.tip_stiffness += step;
    const BeamModes low(softer, 5);
    const BeamModes high(stiffer, 5);
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const double a = low.angular_frequencies()[i];
      const double b = high.angular_frequencies()[i];
      const double difference = (b - a) * (b + a) / (2.0 * step);
      const double derivative = modes.tip_slopes()[i] * modes.tip_slopes()[i];
      EXPECT_NEAR(derivative, difference, 1e-7 * derivative + 1e-15 * b * b / step)
          << seed << ", " << i;
    }
  }
}

// ---- Masses. ----

TEST(BeamModes, DoNotMindHowMassesAreWritten) {
  Beam beam = unit_beam(3.0);
  beam.masses = {{0.3, 0.5}, {0.7, 2.0}};
  const BeamModes modes(beam, 6);
  Beam other = unit_beam(3.0);
  other.masses = {{0.7, 1.5}, {0.0, 7.0}, {0.3, 0.5}, {1.0, 9.0}, {0.7, 0.5}, {0.6, 0.0}};
  const BeamModes same(other, 6);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    EXPECT_DOUBLE_EQ(modes.angular_frequencies()[i], same.angular_frequencies()[i]);
    EXPECT_NEAR(modes.shapes(0.4)[i], same.shapes(0.4)[i], 1e-13);
  }
}

// Two masses a distance d apart are one but for a change of the order d, however small it is.
TEST(BeamModes, AreContinuousWhereTwoMassesMeet) {
  Beam together = unit_beam(3.0);
  together.masses = {{0.3, 5.0}};
  const BeamModes modes(together, 6);
  for (const double distance : {1e-4, 1e-8, 1e-12, 1e-16}) {
    Beam apart = unit_beam(3.0);
    apart.masses = {{0.3, 2.5}, {0.3 + distance, 2.5}};
    const BeamModes close(apart, 6);
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const double omega = modes.angular_frequencies()[i];
      EXPECT_NEAR(close.angular_frequencies()[i], omega, omega * (20.0 * distance + 2e-15))
          << distance << ", " << i;
    }
    EXPECT_LT(orthonormality_error(apart, close), 1e-11);
  }
}

// ---- Invalid input. ----

std::string message(const Beam& beam, std::size_t modes = 1) {
  return test::message_of<InputError>([&] { return BeamModes(beam, modes); });
}

TEST(BeamModes, NameWhatIsWrongWithTheBeam) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto with = [](auto member, double value) {
    Beam beam = unit_beam(0.0);
    beam.*member = value;
    return message(beam);
  };
  EXPECT_EQ(with(&Beam::length, 0.0), "length = 0; must be positive and finite");
  EXPECT_EQ(with(&Beam::length, -1.5), "length = -1.5; must be positive and finite");
  EXPECT_EQ(with(&Beam::bending_stiffness, kNan),
            "bending_stiffness = nan; must be positive and finite");
  EXPECT_EQ(with(&Beam::mass_per_length, kInfinity),
            "mass_per_length = inf; must be positive and finite");
  const std::string ends = "must be 0 or more. 0 is a pinned end, infinity a clamped one.";
  EXPECT_EQ(with(&Beam::tip_stiffness, -2.0), "tip_stiffness = -2; " + ends);
  EXPECT_EQ(with(&Beam::tip_stiffness, kNan), "tip_stiffness = nan; " + ends);
}

TEST(BeamModes, NameWhatIsWrongWithAMass) {
  const auto with = [](double position, double mass) {
    Beam beam = unit_beam(0.0);
    beam.masses = {{0.5, 1.0}, {position, mass}};
    return message(beam);
  };
  EXPECT_EQ(with(1.1, 1.0), "masses[1].position = 1.1; must be on the beam, from 0 to 1 m");
  EXPECT_EQ(with(-0.1, 1.0), "masses[1].position = -0.1; must be on the beam, from 0 to 1 m");
  EXPECT_EQ(with(std::nan(""), 1.0),
            "masses[1].position = nan; must be on the beam, from 0 to 1 m");
  const std::string most = "must be 0 or more, and at most 1e+50 times the mass of the beam";
  EXPECT_EQ(with(0.5, -1.0), "masses[1].mass = -1; " + most);
  EXPECT_EQ(with(0.5, kInfinity), "masses[1].mass = inf; " + most);
}

TEST(BeamModes, NameTheNumberOfModes) {
  EXPECT_EQ(message(unit_beam(0.0), 0), "modes = 0; must be from 1 to 1000");
  EXPECT_EQ(message(unit_beam(0.0), 1001), "modes = 1001; must be from 1 to 1000");
}

TEST(BeamModes, AnswerOnlyOnTheBeamAndForTheirModes) {
  const BeamModes modes(unit_beam(0.0), 2);
  for (const double x : {-1e-9, 1.0 + 1e-9, std::nan("")}) {
    EXPECT_THROW((void)modes.shapes(x), InputError);
    EXPECT_THROW((void)modes.slopes(x), InputError);
  }
  EXPECT_THROW((void)modes.frequency(2), InputError);
  EXPECT_THROW((void)modes.slope_integral(0, 2), InputError);
  EXPECT_THROW((void)modes.slope_integral(2, 0), InputError);
}

TEST(NaturalFrequenciesBelow, RejectsAFrequencyThatIsNone) {
  for (const double omega : {-1.0, std::nan(""), kInfinity, 1.1e8}) {
    EXPECT_THROW((void)natural_frequencies_below(unit_beam(0.0), omega), InputError) << omega;
  }
  EXPECT_EQ(natural_frequencies_below(unit_beam(0.0), 1e8), 3182U);  // λ/π − 1/4
}

}  // namespace
}  // namespace microslip::beam_modes_test
