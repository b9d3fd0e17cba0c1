// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "io/support.hpp"
#include "microslip/io/csv.hpp"
#include "microslip/io/model_file.hpp"
#include "support/replaced.hpp"
#include "support/tested_chain.hpp"

namespace microslip::cli_test::tested_modes_test {
namespace {

using test::TestedChain;

/// Below 100 Hz are all modes of the chain.
const std::vector<double> kBand = test::even_frequencies(5.0, 0.25, 400);

const std::string kStructure =
    "schema = \"microslip.structure/1\"\n"
    "[test]\nfrfs = \"frf.uff\"\ndrive = { node = 2, direction = \"z\" }\n"
    "[[point]]\nname = \"drive\"\nnode = 2\ndirection = \"z\"\n"
    "[[point]]\nname = \"tip\"\nnode = 5\ndirection = \"-z\"\n"
    "[excitation]\npoint = \"drive\"\n"
    "[response]\npoint = \"tip\"\n";

/// The spring between masses 3 and 4, of 1.21e5 N/m, as a joint of which it is a part.
const std::string kJoint =
    "[[joint]]\nname = \"lap\"\nfrom = { node = 3 }\nto = { node = 4 }\ndirection = \"z\"\n"
    "stiffness_N_per_m = 1e5\n[modes]\njoints = \"stuck\"\n";

const Arguments kModes{"modes", "s.toml", "--out", "model.toml"};

Sandbox sandbox(const std::string& structure, const std::string& responses) {
  return Sandbox{{"s.toml", structure}, {"frf.uff", responses}};
}

std::string responses(int derivatives = 2, double noise = 0.0) {
  return test::response_datasets({}, kBand, 1, derivatives, noise);
}

// From matrices to responses by a solution at each frequency, to a model, to its response: against
// that solution, at the resonances and between them. Beside the rounding of a file of
// 13 digits nothing is lost; the bound is that of the digits that frf writes and reads.
TEST(tested_modes, LeadToTheResponsesOfTheStructure) {
  const Sandbox box = sandbox(kStructure, responses());
  const Outcome run = expect_done(box, kModes);
  EXPECT_EQ(run.err, "");
  EXPECT_NE(run.out.find("5 degrees of freedom, 5 modes"), std::string::npos) << run.out;
  EXPECT_NE(box.get("model.toml")
                .find("# modes of a test: 5 frequency responses (dataset 58) of "
                      "frf.uff to a force at node 2 z"),
            std::string::npos);
  const TestedChain chain;
  for (Eigen::Index r = 0; r < 5; ++r) {
    const double resonance = std::sqrt(chain.modes().eigenvalues()(r)) / (2.0 * std::numbers::pi);
    const std::vector<double> hertz = test::even_frequencies(0.98 * resonance, 0.01 * resonance, 5);
    expect_done(box, {"frf", "model.toml", "--force", "2", "--frequency",
                      fmt::format("{}:{}", hertz.front(), hertz.back()), "--out", "f.csv"});
    const CsvTable table(box.get("f.csv"), "f.csv");
    const std::vector<double> frequency = table.numbers("frequency", kFrequency);
    const std::vector<double> displacement = table.numbers("displacement", kLength);
    const Eigen::MatrixXcd exact = chain.responses(frequency, 1, 0);
    double highest = 0.0;
    for (std::size_t i = 0; i < frequency.size(); ++i) {
      highest = std::max(highest, displacement[i]);
      EXPECT_NEAR(displacement[i] / (2.0 * std::abs(exact(static_cast<Eigen::Index>(i), 4))), 1.0,
                  1e-4)
          << frequency[i];
    }
    EXPECT_GT(highest, 0.0);
    std::filesystem::remove(box.file("f.csv"));
  }
}

// A point against the direction of its sensor moves the other way.
TEST(tested_modes, HaveTheSignsOfTheirDirections) {
  const Sandbox box = sandbox(kStructure, responses(0));
  expect_done(box, kModes);
  const ModelFile model = read_model(box.file("model.toml"));
  const auto exact = TestedChain{}.modes();
  for (std::size_t r = 0; r < 5; ++r) {
    const Eigen::VectorXd shape = exact.eigenvectors().col(static_cast<Eigen::Index>(r));
    EXPECT_NEAR(
        model.structure.linear().shape("tip")[r] / model.structure.linear().shape("drive")[r],
        -shape(4) / shape(1), 1e-8);
  }
}

// The joint's spring is in the modes: taken out, what is left is the chain with a softer spring.
TEST(tested_modes, KeepTheSpringOfAJointThatWasStuck) {
  const Sandbox box = sandbox(kStructure + kJoint, responses());
  const Outcome run = box.run(kModes);
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.err.find("a test has no matrices, so that joint 'lap'"), std::string::npos)
      << run.err;
  EXPECT_NE(box.get("model.toml").find("# warning: no_attachment: "), std::string::npos);
  const ModelFile model = read_model(box.file("model.toml"), JointsToFind::kAllowed);
  EXPECT_EQ(model.structure.joints()[0].spring_in_modes, 1e5);
  const std::vector<double> stuck = model.structure.stuck_frequencies();
  for (std::size_t r = 0; r < 5; ++r) {
    const double omega =
        std::sqrt(TestedChain{}.modes().eigenvalues()(static_cast<Eigen::Index>(r)));
    EXPECT_NEAR(stuck[r] / omega, 1.0, 1e-6);
  }
}

TEST(tested_modes, OfAFreeJointHaveNoSpringInThem) {
  const Sandbox box = sandbox(
      kStructure + test::replaced(kJoint, "joints = \"stuck\"", "joints = \"free\""), responses());
  const Outcome run = box.run(kModes);
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.err.find("frequencies with it come out too high"), std::string::npos) << run.err;
  const ModelFile model = read_model(box.file("model.toml"), JointsToFind::kAllowed);
  EXPECT_EQ(model.structure.joints()[0].spring_in_modes, 0.0);
}

// In the modes the spring has more compliance than a spring of 1e6 N/m alone.
TEST(tested_modes, RefuseAJointStifferThanTheyAllow) {
  const Sandbox box = sandbox(kStructure + test::replaced(kJoint, "= 1e5", "= 1e6"), responses());
  expect_refused(box, kModes, {"stiffness of joint 'lap' = 1000000", "more than its own spring"});
}

TEST(tested_modes, TakeTheDampingThatIsTold) {
  const Sandbox box =
      sandbox(kStructure + "[modes]\nup_to_Hz = 70\nloss_factor = [0.02, 0.03]\n", responses());
  expect_done(box, kModes);
  const ModelFile model = read_model(box.file("model.toml"));
  ASSERT_EQ(model.structure.linear().size(), 3U);
  EXPECT_EQ(model.structure.linear().modes()[2].loss_factor, 0.03);
  EXPECT_EQ(model.structure.damping(), DampingLaw::kHysteretic);
}

/// Mode shapes 1 to 3, of modal mass 4 in tonnes.
/// @param write  as dataset 55 or 2414.
std::string shapes(const std::string& units, double mass = 4e-3,
                   std::string (*write)(const test::UffShape&,
                                        const Eigen::VectorXcd&) = test::shape_dataset) {
  const auto exact = TestedChain{}.modes();
  std::string text = units;
  for (Eigen::Index r = 0; r < 3; ++r) {
    const double omega = std::sqrt(exact.eigenvalues()(r));
    text += write({.number = static_cast<int>(r) + 1,
                   .reals = {omega / (2.0 * std::numbers::pi), mass,
                             0.5 * TestedChain{}.loss_of(omega), 0.0}},
                  2.0 * exact.eigenvectors().col(r));
  }
  return text;
}

const std::string kShapes =
    test::replaced(kStructure, "frfs = \"frf.uff\"\ndrive = { node = 2, direction = \"z\" }\n",
                   "shapes = \"frf.uff\"\n");

TEST(tested_modes, OfShapesInMillimetresAreThoseOfTheResponses) {
  const Sandbox box = sandbox(kShapes, shapes(test::units_dataset(1000.0, 1.0)));
  const Outcome run = expect_done(box, kModes);
  EXPECT_EQ(run.err, "");
  const Sandbox fitted = sandbox(kStructure, responses());
  expect_done(fitted, kModes);
  const ModelFile one = read_model(box.file("model.toml"));
  const ModelFile other = read_model(fitted.file("model.toml"));
  for (std::size_t r = 0; r < 3; ++r) {
    const ModalModel& first = one.structure.linear();
    const ModalModel& second = other.structure.linear();
    EXPECT_NEAR(first.modes()[r].angular_frequency / second.modes()[r].angular_frequency, 1.0,
                1e-5);
    EXPECT_NEAR(first.modes()[r].loss_factor / second.modes()[r].loss_factor, 1.0, 1e-5);
    EXPECT_NEAR(std::abs(first.shape("tip")[r] / second.shape("tip")[r]), 1.0, 1e-4);
  }
}

// The same digits in other records: the same model, but for the number of the dataset that it tells.
TEST(tested_modes, OfDataset2414AreThoseOfDataset55) {
  const std::string units = test::units_dataset(1000.0, 1.0);
  const Sandbox old = sandbox(kShapes, shapes(units));
  const Sandbox box = sandbox(kShapes, shapes(units, 4e-3, test::analysis_dataset));
  expect_done(old, kModes);
  expect_done(box, kModes);
  const std::string model = box.get("model.toml");
  EXPECT_NE(model.find("3 shapes (dataset 2414) of frf.uff"), std::string::npos) << model;
  EXPECT_EQ(test::replaced(model, "(dataset 2414)", "(dataset 55)"), old.get("model.toml"));
}

// What is left out stands in the model, too.
TEST(tested_modes, OfDataset2414TellWhatIsLeftOut) {
  const std::string stress =
      test::replaced(shapes(test::units_dataset(1000.0, 1.0), 4e-3, test::analysis_dataset),
                     "         2         8         2", "         2         2         2");
  const Sandbox box = sandbox(kShapes, stress);
  const Outcome run = box.run(kModes);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.err.find("dataset 2 (2414) has result type 2 at nodes"), std::string::npos)
      << run.err;
  const std::string model = box.get("model.toml");
  EXPECT_NE(model.find("# warning: uff_no_motion: "), std::string::npos) << model;
  EXPECT_NE(model.find(": 2 shapes (dataset 2414)"), std::string::npos) << model;
}

TEST(tested_modes, RefuseByName) {
  const auto refused = [](const std::string& from, const std::string& to, const std::string& part) {
    expect_refused(sandbox(test::replaced(kStructure + kJoint, from, to), responses()), kModes,
                   {part});
  };
  refused("node = 2, direction", "node = 3, direction",
          "test.drive = node 3 z; must have a response to its own force in frf.uff");
  refused("drive = { node = 2, direction = \"z\" }\n", "", "the key 'drive'");
  refused("name = \"tip\"\nnode = 5", "name = \"tip\"\nnode = 9",
          "point[1].node = node 9; must be a node of the test. It has nodes 1 to 5");
  refused("node = 5\ndirection = \"-z\"", "node = 5\ndirection = \"x\"",
          "node 5 x; must be measured: of this node the test has z");
  refused("joints = \"stuck\"", "", "whether joints were there in the test");
  refused("joints = \"stuck\"", "joints = \"stuck\"\nattachment = true", "static shapes take");
  refused("[modes]\n", "[modes]\ncount = 9\n", "as count asks for");
  refused("[[joint]]", "[[base]]\nname = \"table\"\n[[joint]]", "unknown key 'base'");
  refused("node = 5\n", "row = 5\n", "unknown key 'row'");
  refused("[test]\n", "[matrices]\nmass = \"m\"\n[test]\n", "one of the tables matrices and test");
  refused("frfs = ", "shapes = \"frf.uff\"\nfrfs = ", "one of the keys shapes and frfs");
  refused("\"frf.uff\"", "\"no.uff\"", "test.frfs: no.uff: cannot be read");
  refused("\"frf.uff\"\n", "\"frf.uff\"\nband_Hz = [60.0, 5.0]\n", "test.band_Hz");
  refused("\"frf.uff\"\n", "\"frf.uff\"\nband_Hz = [200.0, 300.0]\n", "lines in the band");
  refused("\"frf.uff\"\n", "\"frf.uff\"\nmodal_mass_kg = [1.0]\n", "modal_mass_kg beside shapes");
  refused("\"frf.uff\"\n", "\"frf.uff\"\ndamping = \"none\"\n", "must be viscous or hysteretic");
  refused("\"frf.uff\"\n", "\"frf.uff\"\nstart_frequency_Hz = [0.0]\n", "must be above 0");
  refused("\"frf.uff\"\n", "\"frf.uff\"\nstart_frequency_Hz = [300.0]\n", "must be within");
}

TEST(tested_modes, OfShapesRefuseByName) {
  const auto refused = [](const std::string& structure, const std::string& file,
                          const std::string& part) {
    expect_refused(sandbox(structure, file), kModes, {part});
  };
  const std::string si = test::units_dataset(1.0, 1.0);
  refused(kShapes, shapes(si, 0.0), "modal mass of frf.uff: mode 1");
  refused(kShapes, shapes(""), "Give length_unit and force_unit in [test]");
  refused(kShapes, responses(), "mode shapes (dataset 55 or 2414), found none");
  refused(kStructure, shapes(si), "a frequency response (dataset 58");
  refused(kShapes, "", "frf.uff");
  refused(test::replaced(kShapes, "node = 5\ndirection = \"-z\"", "node = 5\ndirection = \"x\""),
          shapes(si), "0 in all modes of the test; must move");
  refused(test::replaced(kShapes, "\"frf.uff\"\n", "\"frf.uff\"\nmodal_mass_kg = [1.0]\n"),
          shapes(si), "modal_mass_kg = 1 values; must be 3");
  refused(test::replaced(kShapes, "\"frf.uff\"\n", "\"frf.uff\"\nband_Hz = [1.0, 2.0]\n"),
          shapes(si), "band_Hz beside frfs");
}

}  // namespace
}  // namespace microslip::cli_test::tested_modes_test
