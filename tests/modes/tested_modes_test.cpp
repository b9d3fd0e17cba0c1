// SPDX-License-Identifier: MIT
#include "microslip/modes/tested_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/io/responses/uff_responses.hpp"
#include "microslip/io/uff/uff55.hpp"
#include "support/tested_chain.hpp"

namespace microslip::tested_modes_test {
namespace {

using test::TestedChain;

/// z of the masses.
Eigen::MatrixXd along_z(const TestedModes& tested) {
  Eigen::MatrixXd shapes(static_cast<Eigen::Index>(tested.freedoms.size() / 3),
                         tested.shapes.cols());
  for (Eigen::Index i = 0; i < shapes.rows(); ++i) shapes.row(i) = tested.shapes.row(3 * i + 2);
  return shapes;
}

/// Shapes are given by six digits of a file.
constexpr double kDigits = 2e-5;

void expect_shapes(const Eigen::MatrixXd& found, const TestedChain& chain, double bound) {
  const auto exact = chain.modes();
  for (Eigen::Index r = 0; r < found.cols(); ++r) {
    const Eigen::VectorXd truth = exact.eigenvectors().col(r);
    const double sign = truth.dot(found.col(r)) > 0.0 ? 1.0 : -1.0;
    EXPECT_LT((sign * found.col(r) - truth).cwiseAbs().maxCoeff(), bound) << "mode " << r + 1;
  }
}

TestedStructure read_shapes(const std::string& content) {
  const test::TemporaryFolder folder;
  test::put(folder.file("t.uff"), content);
  return {.file = "t.uff", .shapes = read_mode_shapes_uff(folder.file("t.uff")).shapes};
}

double hertz_of(const TestedChain& chain, Eigen::Index mode) {
  return std::sqrt(chain.modes().eigenvalues()(mode)) / (2.0 * std::numbers::pi);
}

/// Shapes as a laboratory has them: mode r scaled by 3 + r, and modal masses of that, kg.
std::string scaled_shapes(const TestedChain& chain, double mass_unit, double damping = 0.004) {
  std::string text;
  for (Eigen::Index r = 0; r < 3; ++r) {
    const double scale = 3.0 + static_cast<double>(r);
    text += test::shape_dataset(
        {.number = static_cast<int>(r) + 1,
         .reals = {hertz_of(chain, r), scale * scale / mass_unit, damping, 0.0}},
        scale * chain.modes().eigenvectors().col(r));
  }
  return text;
}

TEST(TestedModes, AreScaledByTheModalMassOfTheFile) {
  const TestedChain chain;
  const TestedModes tested =
      modes_of_shapes(read_shapes(test::units_dataset(1.0, 1.0) + scaled_shapes(chain, 1.0)), {});
  EXPECT_EQ(tested.freedoms.size(), 15U);
  expect_shapes(along_z(tested), chain, kDigits);
  for (std::size_t r = 0; r < 3; ++r) {
    EXPECT_NEAR(tested.modes[r].angular_frequency / (2.0 * std::numbers::pi),
                hertz_of(chain, static_cast<Eigen::Index>(r)), 1e-3);
    EXPECT_DOUBLE_EQ(tested.modes[r].loss_factor, 0.008);
  }
  EXPECT_EQ(tested.law, DampingLaw::kViscous);
  EXPECT_TRUE(tested.warnings.empty());
}

// In mm and N a modal mass is in tonnes: 1000 kg; in lengths of feet and pounds, 14.59 kg.
TEST(TestedModes, TakeTheUnitsOfTheFile) {
  const TestedChain chain;
  for (const auto& [metre, newton] : {std::pair{1000.0, 1.0}, {1.0 / 0.3048, 1.0 / 4.4482216}}) {
    const TestedModes tested = modes_of_shapes(
        read_shapes(test::units_dataset(metre, newton) + scaled_shapes(chain, metre / newton)), {});
    expect_shapes(along_z(tested), chain, kDigits);
  }
  TestedStructure scaled = read_shapes(scaled_shapes(chain, 1000.0));
  scaled.units = UnitSystem{.length = 1e-3};
  expect_shapes(along_z(modes_of_shapes(scaled, {})), chain, kDigits);
}

// Modal masses of the key stand in place of those of the file, which has 0: they are kg.
TEST(TestedModes, TakeModalMassesThatAreGiven) {
  const TestedChain chain;
  std::string text = test::units_dataset(1000.0, 1.0);
  text += test::shape_dataset({.reals = {hertz_of(chain, 0), 0.0, 0.0, 0.01}},
                              2.0 * chain.modes().eigenvectors().col(0));
  TestedStructure test = read_shapes(text);
  test.modal_mass = {4.0};
  const TestedModes tested = modes_of_shapes(test, {});
  expect_shapes(along_z(tested), chain, kDigits);
  EXPECT_EQ(tested.law, DampingLaw::kHysteretic);
  EXPECT_DOUBLE_EQ(tested.modes[0].loss_factor, 0.01);
}

// With λ = −ζω + iω_d and any complex ψ = cφ: a = ψᵀ(2λM + C)ψ = 2iω_d c² of proportional damping.
TEST(TestedModes, OfComplexModesAreScaledByModalA) {
  const TestedChain chain;
  std::string text = test::units_dataset(1.0, 1.0);
  const std::complex<double> factor(1.2, 0.7);
  for (Eigen::Index r = 0; r < 3; ++r) {
    const double omega = std::sqrt(chain.modes().eigenvalues()(r));
    const double ratio = 0.5 * chain.loss_of(omega);
    const std::complex<double> pole(-ratio * omega, omega * std::sqrt(1.0 - ratio * ratio));
    const Eigen::VectorXd shape = chain.modes().eigenvectors().col(r);
    const Eigen::MatrixXcd inner = (2.0 * pole) * chain.mass().cast<std::complex<double>>() +
                                   chain.damping().cast<std::complex<double>>();
    const Eigen::VectorXcd scaled = factor * shape.cast<std::complex<double>>();
    const std::complex<double> a = (scaled.transpose() * inner * scaled)(0);
    text += test::shape_dataset(
        {.analysis = 3, .reals = {pole.real(), pole.imag(), a.real(), a.imag(), 0.0, 0.0}}, scaled);
  }
  const TestedModes tested = modes_of_shapes(read_shapes(text), {});
  ASSERT_EQ(tested.modes.size(), 3U);
  expect_shapes(along_z(tested), chain, kDigits);
  for (const Mode& mode : tested.modes) {
    EXPECT_NEAR(mode.loss_factor / chain.loss_of(mode.angular_frequency), 1.0, 1e-3);
  }
  EXPECT_TRUE(tested.warnings.empty());
}

TEST(TestedModes, SayThatAShapeIsComplex) {
  const TestedChain chain;
  Eigen::VectorXcd shape = chain.modes().eigenvectors().col(1);
  for (Eigen::Index i = 0; i < 3; ++i) shape(i) *= std::polar(1.0, 0.5);
  const TestedModes tested = modes_of_shapes(
      read_shapes(test::units_dataset(1.0, 1.0) +
                  test::shape_dataset({.analysis = 3, .reals = {-1.0, 250.0, 0.0, 500.0, 0.0, 0.0}},
                                      shape)),
      {});
  ASSERT_FALSE(tested.warnings.empty());
  EXPECT_EQ(tested.warnings[0].code, "mode_complex");
}

TEST(TestedModes, OfShapesRefuseByName) {
  const TestedChain chain;
  const Eigen::VectorXd shape = chain.modes().eigenvectors().col(0);
  const std::string si = test::units_dataset(1.0, 1.0);
  const auto refused = [&](const std::string& content, const std::string& part) {
    const std::string message =
        test::message_of<InputError>([&] { (void)modes_of_shapes(read_shapes(content), {}); });
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_NE(message.find("t.uff"), std::string::npos) << message;
  };
  const auto one = [&](const test::UffShape& of) { return test::shape_dataset(of, shape); };
  refused(si + one({.reals = {13.0, 0.0, 0.01, 0.0}}),
          "modal mass of t.uff: mode 1 (13 Hz) = 0; must be above 0");
  refused(si + one({.reals = {13.0}}), "modal mass of t.uff: mode 1 (13 Hz) = not in the file");
  refused(si + one({.reals = {13.0, -2.0, 0.01, 0.0}}), "= -2; must be above 0");
  refused(si + one({.reals = {13.0, 1.0}}), "damping of t.uff: mode 1 (13 Hz) = not in the file");
  refused(si + one({.reals = {13.0, 1.0, 0.0, 0.0}}), "damping of t.uff");
  refused(si + one({.reals = {13.0, 1.0, -0.1, 0.0}}), "must not be negative");
  refused(si + one({.reals = {13.0, 1.0, 0.01, 0.05}}), "must be one of them, or the same");
  refused(si + one({.reals = {13.0, 1.0, 0.01, 0.0}}) + one({.reals = {14.0, 1.0, 0.0, 0.01}}),
          "viscous with hysteretic");
  refused(one({.reals = {13.0, 1.0, 0.01, 0.0}}), "must have dataset 164 before it");
  refused(si + one({.reals = {13.0, 1.0, 0.01, 0.0}}) + one({.reals = {13.0, 2.0, 0.01, 0.0}}),
          "of the shape of t.uff: mode 1 (13 Hz); must be a different mode");
  refused(si + one({.specific_type = 12, .reals = {13.0, 1.0, 0.01, 0.0}}), "data type 12");
  refused(si + one({.analysis = 5, .reals = {13.0}}), "must have normal or complex modes");
  refused(si + one({.analysis = 3, .reals = {-1.0, 80.0}}), "modal A of t.uff");
  refused(si + one({.analysis = 3, .reals = {-1.0, 80.0, 0.0, 0.0}}), "modal A of t.uff");
  refused(si + one({.reals = {13.0, 1.0, 0.01, 0.0}}) +
              test::shape_dataset({.reals = {14.0, 1.0, 0.01, 0.0}}, shape.head(3)),
          "must have the nodes and directions of");
}

TestedStructure read_responses(const std::string& content) {
  const test::TemporaryFolder folder;
  test::put(folder.file("t.uff"), content);
  return {.file = "t.uff",
          .responses = read_responses_uff(folder.file("t.uff")).responses,
          .drive = DegreeOfFreedom{2, NodalDirection::kZ}};
}

const std::vector<double> kBand = test::even_frequencies(5.0, 0.25, 400);

// Through a file of 13 digits.
TEST(TestedModes, OfResponsesAreScaledByTheDrivePoint) {
  const TestedChain chain;
  for (const int derivatives : {0, 1, 2}) {
    const TestedModes tested = modes_of_responses(
        read_responses(test::response_datasets(chain, kBand, 1, derivatives)), {});
    ASSERT_EQ(tested.modes.size(), 5U);
    expect_shapes(tested.shapes, chain, 1e-8);
    EXPECT_TRUE(tested.warnings.empty());
  }
}

// A hammer that goes round while one sensor stays: H_jk = H_kj.
TEST(TestedModes, TakeResponsesOfARovingHammer) {
  const TestedChain chain;
  const Eigen::MatrixXcd values = chain.responses(kBand, 1, 2);
  std::string text;
  for (Eigen::Index j = 0; j < 5; ++j) {
    text += test::response_dataset({.response = 2, .reference = j + 1}, kBand, values.col(j));
  }
  const TestedModes tested = modes_of_responses(read_responses(text), {});
  Eigen::MatrixXd shapes(5, 5);
  for (Eigen::Index j = 0; j < 5; ++j) {
    shapes.row(tested.freedoms[static_cast<std::size_t>(j)].node - 1) = tested.shapes.row(j);
  }
  expect_shapes(shapes, chain, 1e-8);
}

/// A response with a direction, unit or sign of its own beside the others.
std::string with_third(const test::UffResponse& of, double factor) {
  const TestedChain chain;
  const Eigen::MatrixXcd values = chain.responses(kBand, 1, 2);
  std::string text;
  for (Eigen::Index j = 0; j < 5; ++j) {
    const bool third = j == 2;
    test::UffResponse its = third ? of : test::UffResponse{};
    its.response = j + 1;
    its.reference = 2;
    text += test::response_dataset(its, kBand, (third ? factor : 1.0) * values.col(j));
  }
  return text;
}

TEST(TestedModes, TakeUnitsAndSignsOfResponses) {
  const TestedChain chain;
  const auto expect_same = [&](const std::string& text) {
    expect_shapes(modes_of_responses(read_responses(text), {}).shapes, chain, 1e-8);
  };
  expect_same(with_third({.response_direction = -3}, -1.0));
  expect_same(with_third({.reference_direction = -3}, -1.0));
  expect_same(with_third({.units = {"", "", "g"}}, 1.0 / 9.80665));
  expect_same(with_third({.units = {"", "", "mm/s^2"}, .force_unit = "kN"}, 1e6));
}

bool warns(const TestedModes& tested, const std::string& code) {
  for (const Warning& warning : tested.warnings) {
    if (warning.code == code) return true;
  }
  return false;
}

TEST(TestedModes, OfResponsesSayWhatIsDoubtful) {
  const TestedChain chain;
  EXPECT_TRUE(warns(
      modes_of_responses(read_responses(test::response_datasets(chain, kBand, 1, 2, 0.2)), {}),
      "fit_poor"));
  const TestedChain damper{.damper_at_end = 60.0};
  const TestedModes complex =
      modes_of_responses(read_responses(test::response_datasets(damper, kBand, 1, 2)), {});
  EXPECT_TRUE(warns(complex, "mode_phase") || warns(complex, "mode_complex"));

  // The same pair from the other side, half as large.
  const std::string exchanged = test::response_dataset({.response = 2, .reference = 4}, kBand,
                                                       0.5 * chain.responses(kBand, 1, 2).col(3));
  const std::string all = test::response_datasets(chain, kBand, 1, 2);
  EXPECT_TRUE(warns(modes_of_responses(read_responses(all + exchanged), {}), "not_reciprocal"));

  const std::vector<double> other = test::even_frequencies(5.0, 0.5, 200);
  const std::string coarse = test::response_dataset({.response = 7, .reference = 2}, other,
                                                    chain.responses(other, 1, 2).col(3));
  const TestedModes lines = modes_of_responses(read_responses(all + coarse), {});
  EXPECT_TRUE(warns(lines, "lines_differ"));
  EXPECT_LT((lines.shapes.row(5) - lines.shapes.row(3)).norm(), 1e-8);
}

TEST(TestedModes, OfResponsesRefuseByName) {
  const TestedChain chain;
  const auto refused = [&](const std::string& content, const std::string& part) {
    const std::string message = test::message_of<InputError>(
        [&] { (void)modes_of_responses(read_responses(content), {}); });
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  const Eigen::MatrixXcd values = chain.responses(kBand, 1, 2);
  const auto one = [&](const test::UffResponse& of, double factor = 1.0) {
    return test::response_dataset(of, kBand, factor * values.col(1));
  };
  refused(one({.response = 1, .reference = 2}),
          "test.drive = node 2 z; must have a response to its own force in t.uff");
  refused(one({.response = 2, .reference = 2}, -1.0), "must be positive");
  refused(one({.response = 2, .reference = 2}) + one({.response = 2, .reference = 2}),
          "there already, as dataset 1");
  refused(one({.response = 2, .reference = 2}, 0.0), "0 throughout the band");
  refused(one({.response = 2, .reference = 2, .units = {"", "", "V"}}), "without unit");
  refused(one({.response = 2, .reference = 2, .units = {"", "", "Pa"}}),
          "must be a displacement, velocity or acceleration over a force");
  refused(one({.response = 0, .reference = 2}), "response of dataset 1 = node 0, direction 3");
  refused(one({.response = 2, .reference = 2, .reference_direction = 0}),
          "reference of dataset 1 = node 2, direction 0");
}

}  // namespace
}  // namespace microslip::tested_modes_test
