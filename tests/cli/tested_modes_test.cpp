// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "io/support.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/io/tables/csv.hpp"
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
  EXPECT_NE(run.err.find("frequencies with it are predicted too high"), std::string::npos)
      << run.err;
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

// The same digits in other records: the same model, but for the number of the dataset that it
// tells.
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

void expect_same_modes(const Sandbox& one, const Sandbox& other, double bound) {
  const ModelFile first = read_model(one.file("model.toml"));
  const ModelFile second = read_model(other.file("model.toml"));
  ASSERT_EQ(first.structure.linear().size(), second.structure.linear().size());
  for (std::size_t r = 0; r < first.structure.linear().size(); ++r) {
    const Mode& mode = first.structure.linear().modes()[r];
    const Mode& its = second.structure.linear().modes()[r];
    EXPECT_NEAR(mode.angular_frequency / its.angular_frequency, 1.0, bound);
    EXPECT_NEAR(mode.loss_factor / its.loss_factor, 1.0, bound);
    for (const char* point : {"drive", "tip"}) {
      const double shape = first.structure.linear().shape(point)[r];
      EXPECT_NEAR(shape / second.structure.linear().shape(point)[r], 1.0, bound);
    }
  }
}

std::string naming(const std::string& file, const std::string& more = "") {
  return test::replaced(test::replaced(kStructure, "frf.uff", file), "[[point]]",
                        more + "[[point]]");
}

// The numbers of MATLAB and HDF5 files are those of the universal file, bit for bit; frequencies of
// CSV come from equal steps to rounding, 1e-16, which the fit of the last digits multiplies by the
// number of lines at most.
TEST(tested_modes, OfTheSameResponsesInAnyFormatAreTheSame) {
  const Sandbox uff = sandbox(kStructure, responses());
  expect_done(uff, kModes);
  for (const auto& [file, bound] :
       {std::pair<std::string, double>{"frf.mat", 0.0}, {"frf.h5", 0.0}, {"frf.csv", 1e-12}}) {
    const Sandbox box = sandbox(naming(file), responses());
    expect_done(box, {"convert", "frf.uff", file});
    EXPECT_EQ(expect_done(box, kModes).err, "");
    EXPECT_NE(box.get("model.toml").find("5 frequency responses (channels) of " + file),
              std::string::npos);
    expect_same_modes(uff, box, bound);
  }
}

/// The responses of the masses as an own program writes them: no word of where they were measured.
std::string plain_csv(const std::string& unit) {
  const Eigen::MatrixXcd exact = TestedChain{}.responses(kBand, 1, 2);
  std::string text = "frequency [Hz]";
  for (int j = 1; j <= 5; ++j) text += fmt::format(",H{0}.real{1},H{0}.imag{1}", j, unit);
  for (Eigen::Index i = 0; i < exact.rows(); ++i) {
    text += fmt::format("\n{}", kBand[static_cast<std::size_t>(i)]);
    for (Eigen::Index j = 0; j < 5; ++j) {
      const double sign = j == 4 ? -1.0 : 1.0;  // the last sensor points the other way
      text += fmt::format(",{:.17g},{:.17g}", sign * exact(i, j).real(), sign * exact(i, j).imag());
    }
  }
  return text + "\n";
}

std::string channel_table(int mass, const std::string& direction, const std::string& more = "") {
  return fmt::format("[[test.response]]\nchannel = \"H{0}\"\nnode = {0}\ndirection = \"{1}\"\n{2}",
                     mass, direction, more);
}

std::string all_channels(const std::string& more = "") {
  std::string text;
  for (int mass = 1; mass <= 5; ++mass) {
    text += channel_table(mass, mass == 5 ? "-z" : "z", more);
  }
  return text;
}

// The universal file has 13 digits, those here 17.
TEST(tested_modes, TakeTheNodesOfChannelsFromTheirTables) {
  const Sandbox uff = sandbox(kStructure, responses());
  expect_done(uff, kModes);
  const Sandbox labelled{{"s.toml", naming("own.csv", all_channels())},
                         {"own.csv", plain_csv(" [m/s^2/N]")}};
  expect_done(labelled, kModes);
  expect_same_modes(uff, labelled, 1e-9);
  const Sandbox bare{{"s.toml", naming("own.csv", all_channels("unit = \"mm/s^2/kN\"\n"))},
                     {"own.csv", plain_csv("")}};
  expect_done(bare, kModes);  // a millionth of the force: shapes a thousandth
  const double tip = read_model(labelled.file("model.toml")).structure.linear().shape("tip")[0];
  EXPECT_NEAR(read_model(bare.file("model.toml")).structure.linear().shape("tip")[0] / tip, 1e-3,
              1e-9);
}

TEST(tested_modes, OfChannelsRefuseByName) {
  const auto refused = [](const std::string& tables, const std::string& csv,
                          const std::string& part) {
    const Sandbox box{{"s.toml", naming("own.csv", tables)}, {"own.csv", csv}};
    expect_refused(box, kModes, {part});
  };
  const std::string csv = plain_csv(" [m/s^2/N]");
  refused("", csv, "Give channel, node and direction of each in a [[test.response]]");
  refused(all_channels() + channel_table(6, "z"), csv, "'H6'");
  refused(all_channels() + channel_table(1, "z"), csv, "must be measured at one point");
  refused(channel_table(1, "z"), csv, "must have a response to its own force");
  refused(all_channels(), plain_csv(""), "must have the unit of a motion over a force");
  refused(all_channels(), plain_csv(" [N]"), "a displacement, velocity or acceleration over");
  refused(all_channels("unit = \"m/N\"\n"), csv, "must have no unit if one is assumed");
  refused(all_channels("unit = \"parsec\"\n"), csv, "must be the unit of a motion over a force");
  refused(all_channels("weight = 1\n"), csv, "unknown key 'weight'");
  refused("length_unit = \"mm\"\n", csv, "test.length_unit is given");
  refused(channel_table(2, "z"), "time [s],H1 [m]\n0,1\n1,2\n", "'H2'");
  refused(channel_table(1, "z"), "time [s],H1 [m/N]\n0,1\n1,2\n", "must be complex");
  refused(channel_table(1, "z"), "time [s],H1.real [m/N],H1.imag [m/N]\n0,1,1\n1,2,1\n",
          "must be over frequency");
  refused(channel_table(1, "q"), csv, "direction");
  expect_refused(sandbox(naming("frf.uff", channel_table(1, "z")), responses()), kModes,
                 {"test.response is given"});
  expect_refused(sandbox(naming("none.csv"), responses()), kModes, {"none.csv"});
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
  refused("joints = \"stuck\"", "", "state of the joints in the test");
  refused("joints = \"stuck\"", "joints = \"stuck\"\nattachment = true", "static shapes need");
  refused("[modes]\n", "[modes]\ncount = 9\n", "as count requests");
  refused("[[joint]]", "[[base]]\nname = \"table\"\n[[joint]]", "unknown key 'base'");
  refused("node = 5\n", "row = 5\n", "unknown key 'row'");
  refused("[test]\n", "[matrices]\nmass = \"m\"\n[test]\n", "one of the tables matrices and test");
  refused("frfs = ", "shapes = \"frf.uff\"\nfrfs = ", "one of the keys shapes and frfs");
  refused("\"frf.uff\"", "\"no.uff\"", "test.frfs: no.uff: cannot be read");
  refused("\"frf.uff\"\n", "\"frf.uff\"\nband_Hz = [60.0, 5.0]\n", "test.band_Hz");
  refused("\"frf.uff\"\n", "\"frf.uff\"\nband_Hz = [200.0, 300.0]\n", "lines in the band");
  refused("\"frf.uff\"\n", "\"frf.uff\"\nmodal_mass_kg = [1.0]\n", "test.modal_mass_kg is given");
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
          shapes(si), "test.band_Hz is given");
}

}  // namespace
}  // namespace microslip::cli_test::tested_modes_test
