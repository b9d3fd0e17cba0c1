// SPDX-License-Identifier: MIT
#include "microslip/structure/modal_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/structure/beam_modes.hpp"
#include "structure/beams.hpp"

namespace microslip::modal_model_test {
namespace {

using Complex = std::complex<double>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

ModalModel two_modes() {
  return {{{10.0, 0.02}, {30.0, 0.01}}, {{"drive", {1.0, 0.5}}, {"joint", {0.2, -0.7}}}};
}

TEST(ModalModel, HoldsWhatItIsGiven) {
  const ModalModel model = two_modes();
  EXPECT_EQ(model.size(), 2U);
  EXPECT_EQ(model.modes()[1].angular_frequency, 30.0);
  EXPECT_EQ(model.modes()[1].loss_factor, 0.01);
  EXPECT_EQ(model.points().size(), 2U);
  EXPECT_EQ(model.shape("joint")[1], -0.7);
}

// The textbook's oscillator m, c, k: φ = 1/√m, η = c/√(km).
TEST(ModalModel, ReceptanceOfOneOscillator) {
  const double m = 2.0;
  const double c = 0.3;
  const double k = 50.0;
  const ModalModel model({{std::sqrt(k / m), c / std::sqrt(k * m)}},
                         {{"mass", {1.0 / std::sqrt(m)}}});
  for (const double omega : {0.0, 1.0, 4.9, 5.0, 5.1, 300.0}) {
    const Complex exact = 1.0 / Complex(k - m * omega * omega, c * omega);
    const Complex found = model.receptance("mass", "mass", omega);
    EXPECT_LT(std::abs(found - exact), 1e-13 * std::abs(exact)) << omega;
    const Complex hysteretic = 1.0 / Complex(k - m * omega * omega, c * 5.0);
    const Complex other = model.receptance("mass", "mass", omega, DampingLaw::kHysteretic);
    EXPECT_LT(std::abs(other - hysteretic), 1e-13 * std::abs(hysteretic)) << omega;
  }
}

TEST(ModalModel, ReceptanceIsReciprocal) {
  const ModalModel model = two_modes();
  for (const double omega : {0.0, 9.0, 10.0, 20.0, 31.0}) {
    EXPECT_EQ(model.receptance("drive", "joint", omega), model.receptance("joint", "drive", omega));
  }
}

// At rest and undamped, the modes of a beam add up to its static flexibility: a load at a on a
// clamped and pinned beam deflects it there by a³(L − a)²(4L − a)/(12 EI L³) = 6.9e-3. The modes
// from the n-th on have φ² ≤ 2.1 and ω > (nπ)², so that they lack at most 2.1/(3π⁴n³).
TEST(ModalModel, StaticReceptanceOfABeam) {
  const double a = 0.4;
  const BeamModes beam(testing::unit_beam(0.0), 200);
  std::vector<Mode> modes;
  for (const double omega : beam.angular_frequencies()) modes.push_back({omega});
  const ModalModel model(modes, {{"load", beam.shapes(a)}});
  const double exact = a * a * a * 0.36 * 3.6 / 12.0;
  const double lacking = exact - model.receptance("load", "load", 0.0).real();
  EXPECT_GT(lacking, 0.0);
  EXPECT_LT(lacking, 2.1 / (3.0 * std::pow(std::numbers::pi, 4) * 8e6));
}

TEST(ModalModel, ReceptanceIsInfiniteAtAnUndampedResonance) {
  const ModalModel model({{10.0}, {0.0}}, {{"a", {1.0, 0.0}}, {"b", {0.0, 1.0}}});
  EXPECT_TRUE(std::isinf(model.receptance("a", "a", 10.0).real()));
  EXPECT_TRUE(std::isinf(model.receptance("b", "b", 0.0).real()));
  EXPECT_EQ(model.receptance("a", "a", 0.0).real(), 0.01);
  EXPECT_EQ(model.receptance("b", "b", 10.0).real(), -0.01);
}

// ---- Invalid input. ----

std::string message(std::vector<Mode> modes, std::vector<ModalPoint> points) {
  return test::message_of<InputError>([&] { return ModalModel(modes, points); });
}

TEST(ModalModel, NamesWhatIsWrong) {
  EXPECT_EQ(message({}, {}), "number of modes = 0; must be at least 1");
  EXPECT_EQ(message({{1.0, 0.1}, {-1.0, 0.1}}, {}),
            "angular_frequency[1] = -1; must be 0 or more, and finite");
  EXPECT_EQ(message({{kNan, 0.1}}, {}),
            "angular_frequency[0] = nan; must be 0 or more, and finite");
  EXPECT_EQ(message({{1.0, -0.1}}, {}), "loss_factor[0] = -0.1; must be 0 or more, and finite");
  EXPECT_EQ(message({{1.0}, {2.0}}, {{"a", {1.0}}}),
            "shape of point 'a' = 1 values; must have one value per mode, 2 in all");
  EXPECT_EQ(message({{1.0}}, {{"a", {kNan}}}), "shape[0] of point 'a' = nan; must be finite");
  const std::string rule = "; must not be empty, and no two the same";
  EXPECT_EQ(message({{1.0}}, {{"a", {1.0}}, {"a", {2.0}}}), "name of a point = 'a'" + rule);
  EXPECT_EQ(message({{1.0}}, {{"", {1.0}}}), "name of a point = ''" + rule);
}

TEST(ModalModel, NamesThePointsThereAre) {
  const ModalModel model = two_modes();
  const std::string expected =
      "point = 'tip'; is not one of the structure. Available points: 'drive', 'joint'.";
  EXPECT_EQ(test::message_of<InputError>([&] { return model.shape("tip"); }), expected);
  EXPECT_EQ(test::message_of<InputError>([&] { return model.receptance("drive", "tip", 1.0); }),
            expected);
  const ModalModel without({{1.0}}, {});
  EXPECT_EQ(test::message_of<InputError>([&] { return without.shape("tip"); }),
            "point = 'tip'; is not one of the structure. Available points: none.");
}

TEST(ModalModel, RejectsAFrequencyThatIsNone) {
  for (const double omega : {-1.0, kNan, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((void)two_modes().receptance("drive", "drive", omega), InputError);
  }
}

}  // namespace
}  // namespace microslip::modal_model_test
