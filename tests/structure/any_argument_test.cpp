// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/structure/beam.hpp"
#include "microslip/structure/beam_modes.hpp"
#include "microslip/structure/modal_model.hpp"

/// @file
/// Each public function of structure/ with invalid arguments: a documented value or InputError.

namespace microslip::any_argument_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(AnyArgument, OfBeams) {
  const Beam good{.length = 1.0, .bending_stiffness = 10.0, .mass_per_length = 1.0};
  for (const double bad : {kNaN, -kInfinity, -1.0}) {
    for (double Beam::*member :
         {&Beam::length, &Beam::bending_stiffness, &Beam::mass_per_length, &Beam::tip_stiffness}) {
      Beam beam = good;
      beam.*member = bad;
      EXPECT_THROW(check_beam(beam), InputError);
      EXPECT_THROW(BeamModes(beam, 2), InputError);
      EXPECT_THROW((void)natural_frequencies_below(beam, 1.0), InputError);
      EXPECT_THROW((void)spring_for_first_frequency(beam, 1.0), InputError);
    }
    Beam beam = good;
    beam.masses = {{bad, 1.0}};
    EXPECT_THROW(BeamModes(beam, 2), InputError);
    beam.masses = {{0.5, bad}};
    EXPECT_THROW(BeamModes(beam, 2), InputError);
    EXPECT_THROW((void)natural_frequencies_below(good, bad), InputError);
    EXPECT_THROW((void)spring_for_first_frequency(good, bad), InputError);
  }
  EXPECT_THROW((void)natural_frequencies_below(good, kInfinity), InputError);
  EXPECT_THROW((void)spring_for_first_frequency(good, kInfinity), InputError);
  EXPECT_THROW(BeamModes(good, 0), InputError);
  EXPECT_THROW(BeamModes(good, static_cast<std::size_t>(-1)), InputError);
  const BeamModes modes(good, 2);
  for (const double x : {kNaN, kInfinity, -kInfinity, -1e-9, 1.0001}) {
    EXPECT_THROW((void)modes.shapes(x), InputError);
    EXPECT_THROW((void)modes.slopes(x), InputError);
  }
  for (const std::size_t mode : {std::size_t{2}, static_cast<std::size_t>(-1)}) {
    EXPECT_THROW((void)modes.frequency(mode), InputError);
    EXPECT_THROW((void)modes.slope_integral(mode, 0), InputError);
    EXPECT_THROW((void)modes.slope_integral(0, mode), InputError);
  }
}

TEST(AnyArgument, OfModalModels) {
  EXPECT_THROW(ModalModel({}, {}), InputError);
  for (const double bad : {kNaN, kInfinity, -kInfinity, -1.0}) {
    EXPECT_THROW(ModalModel({{bad, 0.1}}, {}), InputError);
    EXPECT_THROW(ModalModel({{1.0, bad}}, {}), InputError);
  }
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    EXPECT_THROW(ModalModel({{1.0, 0.1}}, {{"a", {bad}}}), InputError);
  }
  EXPECT_THROW(ModalModel({{1.0, 0.1}}, {{"a", {}}}), InputError);
  EXPECT_THROW(ModalModel({{1.0, 0.1}}, {{"", {1.0}}}), InputError);
  EXPECT_THROW(ModalModel({{1.0, 0.1}}, {{"a", {1.0}}, {"a", {1.0}}}), InputError);
  const ModalModel model({{1.0, 0.1}}, {{"a", {1.0}}});
  EXPECT_THROW((void)model.shape("b"), InputError);
  EXPECT_THROW((void)model.shape(""), InputError);
  for (const double bad : {kNaN, kInfinity, -1.0}) {
    EXPECT_THROW((void)model.receptance("a", "a", bad), InputError);
  }
}

}  // namespace
}  // namespace microslip::any_argument_test
