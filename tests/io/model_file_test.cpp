// SPDX-License-Identifier: MIT
#include "microslip/documents/structure/model_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "io/damage.hpp"
#include "io/support.hpp"
#include "io/toml_pairs.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/kinds/file_kind.hpp"

namespace microslip::model_file_test {
namespace {

using test::message_of;
using test::Pair;
using test::pairs_of;

const std::string kOneMass = MICROSLIP_EXAMPLES "/one_mass/model.toml";

/// All keys there are; lines and columns are those of the messages below.
const std::string kText =
    "schema = \"microslip.model/1\"\n"
    "[structure]\n"
    "frequency_Hz = [50, 120.5]\n"
    "damping_ratio = [1e-3, 2e-3]\n"
    "[[structure.point]]\n"
    "name = \"tip\"\n"
    "shape = [1.5, -0.5]\n"
    "[[structure.point]]\n"
    "name = \"root\"\n"
    "shape = [0.1, 0.9]\n"
    "[[joint]]\n"
    "name = \"left\"\n"
    "file = \"joints/a.json\"\n"
    "shape = [0.2, 0.3]\n"
    "spring_in_modes_N_per_m = 1e5\n"
    "series_compliance_m_per_N = 2e-9\n"
    "shortening_per_kg_m = [3, 0.5, 0.5, 4]\n"
    "[[joint]]\n"
    "file = \"b.json\"\n"
    "shape = [0, -0.4]\n"
    "[[excitation]]\n"
    "point = \"tip\"\n"
    "harmonics = [1.0, 0.05]\n"
    "phase_rad = [0, 1.2]\n"
    "[[excitation]]\n"
    "point = \"root\"\n"
    "[response]\n"
    "point = \"root\"\n";

std::string joint_text(double stiffness) {
  return fmt::format(
      R"({{"schema": "microslip.joint/1", "stiffness_N_per_m": {},
          "density": [{{"type": "uniform", "from_N": 0, "to_N": 5, "weight": 1}}]}})",
      stiffness);
}

/// A folder with the joints of kText and of the model of one mass.
class ModelFolder {
 public:
  ModelFolder() {
    std::filesystem::create_directory(folder_.file("joints"));
    test::put(folder_.file("joints/a.json"), joint_text(1e5));
    test::put(folder_.file("b.json"), joint_text(2e5));
    test::put(folder_.file("joint.json"), joint_text(0.25));
  }

  [[nodiscard]] ModelFile parse(const std::string& text,
                                JointsToFind to_find = JointsToFind::kRefused) const {
    return parse_model(text, folder_.file("model.toml"), to_find);
  }

  /// Of the error, from the name of the file on, without its folder.
  [[nodiscard]] std::string message(const std::string& text) const {
    std::string message = message_of<Error>([&] { return parse(text); });
    const std::string folder = folder_.file("");
    for (std::size_t at; (at = message.find(folder)) != std::string::npos;) {
      message.erase(at, folder.size());
    }
    return message;
  }

  [[nodiscard]] std::string file(const std::string& name) const { return folder_.file(name); }

 private:
  test::TemporaryFolder folder_;
};

/// The text with the first `before` in it replaced.
std::string edited(std::string text, const std::string& before, const std::string& after) {
  const std::size_t at = text.find(before);
  EXPECT_NE(at, std::string::npos) << before;
  return text.replace(at, before.size(), after);
}

void expect_contains(const std::string& text, const std::string& part, const std::string& input) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' in: " << text << "\n" << input;
}

std::vector<double> list(std::span<const double> values) { return {values.begin(), values.end()}; }

// ---- What is read. ----

TEST(ModelFile, ReadsTheOneMass) {
  const ModelFile file = read_model(kOneMass);
  const ModalModel& linear = file.structure.linear();
  ASSERT_EQ(linear.size(), 1U);
  EXPECT_DOUBLE_EQ(linear.modes()[0].angular_frequency, std::sqrt(0.75));
  EXPECT_DOUBLE_EQ(linear.modes()[0].loss_factor, 0.01 / std::sqrt(0.75));
  EXPECT_EQ(file.structure.damping(), DampingLaw::kViscous);
  ASSERT_EQ(linear.points().size(), 1U);
  EXPECT_EQ(linear.points()[0].name, "mass");
  EXPECT_EQ(linear.points()[0].shape, std::vector<double>{1.0});
  ASSERT_EQ(file.structure.joints().size(), 1U);
  const StructuralJoint& joint = file.structure.joints()[0];
  EXPECT_EQ(joint.name, "joint");
  EXPECT_EQ(joint.joint.stiffness(), 0.25);
  EXPECT_EQ(joint.shape, std::vector<double>{1.0});
  ASSERT_EQ(file.structure.excitations().size(), 1U);
  EXPECT_EQ(file.structure.excitations()[0].point, "mass");
  EXPECT_EQ(file.structure.excitations()[0].harmonics, std::vector<std::complex<double>>{1.0});
  EXPECT_EQ(file.response, "mass");
  EXPECT_EQ(file.joint_files, std::vector<std::string>{MICROSLIP_EXAMPLES "/one_mass/joint.json"});
  EXPECT_EQ(file_kind(test::get(kOneMass)), kModelKind);
}

void expect_joints(const ModelFile& file) {
  ASSERT_EQ(file.structure.joints().size(), 2U);
  const StructuralJoint& left = file.structure.joints()[0];
  EXPECT_EQ(left.name, "left");
  EXPECT_EQ(left.joint.stiffness(), 1e5);
  EXPECT_EQ(left.shape, (std::vector<double>{0.2, 0.3}));
  EXPECT_EQ(left.spring_in_modes, 1e5);
  EXPECT_EQ(left.series_compliance, 2e-9);
  EXPECT_EQ(left.shortening, (std::vector<double>{3.0, 0.5, 0.5, 4.0}));
  const StructuralJoint& second = file.structure.joints()[1];
  EXPECT_EQ(second.name, "joint2");
  EXPECT_EQ(second.joint.stiffness(), 2e5);
  EXPECT_EQ(second.shape, (std::vector<double>{0.0, -0.4}));
  EXPECT_EQ(second.spring_in_modes, 0.0);
  EXPECT_EQ(second.series_compliance, 0.0);
  EXPECT_TRUE(second.shortening.empty());
}

TEST(ModelFile, ReadsAllKeys) {
  const ModelFolder folder;
  const ModelFile file = folder.parse(kText);
  const ModalModel& linear = file.structure.linear();
  ASSERT_EQ(linear.size(), 2U);
  EXPECT_EQ(linear.modes()[0].angular_frequency, 2.0 * std::numbers::pi * 50.0);
  EXPECT_EQ(linear.modes()[1].angular_frequency, 2.0 * std::numbers::pi * 120.5);
  EXPECT_EQ(linear.modes()[1].loss_factor, 4e-3) << "twice the damping ratio";
  EXPECT_EQ(list(linear.shape("tip")), (std::vector<double>{1.5, -0.5}));
  EXPECT_EQ(list(linear.shape("root")), (std::vector<double>{0.1, 0.9}));
  expect_joints(file);
  ASSERT_EQ(file.structure.excitations().size(), 2U);
  const Excitation& first = file.structure.excitations()[0];
  EXPECT_EQ(first.point, "tip");
  EXPECT_EQ(first.harmonics, (std::vector<std::complex<double>>{1.0, std::polar(0.05, 1.2)}));
  EXPECT_EQ(file.structure.excitations()[1].point, "root");
  EXPECT_EQ(file.response, "root");
  EXPECT_EQ(file.joint_files,
            (std::vector<std::string>{folder.file("joints/a.json"), folder.file("b.json")}));
}

TEST(ModelFile, ALossFactorIsHystereticAndOneValueServesAllModes) {
  const ModelFolder folder;
  const ModelFile file =
      folder.parse(edited(kText, "damping_ratio = [1e-3, 2e-3]", "loss_factor = [3e-3]"));
  EXPECT_EQ(file.structure.damping(), DampingLaw::kHysteretic);
  EXPECT_EQ(file.structure.linear().modes()[0].loss_factor, 3e-3);
  EXPECT_EQ(file.structure.linear().modes()[1].loss_factor, 3e-3);
}

TEST(ModelFile, JointsMayBeNone) {
  const std::string text =
      kText.substr(0, kText.find("[[joint]]")) + "[excitation]\npoint = \"tip\"\n";
  const ModelFile file = parse_model(text, "model.toml");
  EXPECT_TRUE(file.structure.joints().empty());
  EXPECT_EQ(file.response, "tip") << "where the structure is driven";
}

TEST(ModelFile, JointFilesMayBeAbsolute) {
  const ModelFolder folder;
  const std::string text = edited(kText, "b.json", folder.file("joint.json"));
  EXPECT_EQ(folder.parse(text).structure.joints()[1].joint.stiffness(), 0.25);
}

// ---- Each value of the text in turn is left out or replaced. ----

TEST(ModelFile, AJointToBeFoundHasAStiffnessAndNoFile) {
  const ModelFolder folder;
  const std::string text = edited(kText, "file = \"b.json\"", "stiffness_N_per_m = 9e5");
  const ModelFile file = folder.parse(text, JointsToFind::kAllowed);
  EXPECT_EQ(file.to_find, std::vector<std::size_t>{1});
  EXPECT_EQ(file.joint_files[1], "");
  const Joint& spring = file.structure.joints()[1].joint;
  EXPECT_EQ(spring.stiffness(), 9e5);
  EXPECT_EQ(spring.density().total().zeroth, 0.0);
  EXPECT_TRUE(folder.parse(kText, JointsToFind::kAllowed).to_find.empty());

  expect_contains(folder.message(text), "Identify it first with calibrate", text);
  const std::string both =
      edited(kText, "file = \"b.json\"", "file = \"b.json\"\nstiffness_N_per_m = 9e5");
  expect_contains(folder.message(both), "expected file or stiffness_N_per_m, found both", both);
  for (const std::string value : {"0", "-1", "1e16", "nan", "\"k\""}) {
    const std::string wrong = edited(kText, "file = \"b.json\"", "stiffness_N_per_m = " + value);
    EXPECT_THROW((void)folder.parse(wrong, JointsToFind::kAllowed), InputError) << value;
  }
}

// Whoever predicts leaves them alone.
TEST(ModelFile, MayTellTheChannelsOfRecordings) {
  const ModelFolder folder;
  EXPECT_EQ(folder.parse(kText).force_channels, (std::vector<std::string>{"", ""}));
  EXPECT_TRUE(folder.parse(kText).accelerometers.empty());
  const std::string sensors =
      edited(kText, "harmonics = [1.0, 0.05]", "channel = \"force\"\nharmonics = [1.0, 0.05]") +
      "[[accelerometer]]\nchannel = \"acc1\"\npoint = \"tip\"\n"
      "[[accelerometer]]\nchannel = \"acc2\"\npoint = \"root\"\n";
  const ModelFile file = folder.parse(sensors);
  EXPECT_EQ(file.force_channels, (std::vector<std::string>{"force", ""}));
  ASSERT_EQ(file.accelerometers.size(), 2U);
  EXPECT_EQ(file.accelerometers[1].channel, "acc2");
  EXPECT_EQ(file.accelerometers[1].point, "root");
  const auto refused = [&](const std::string& before, const std::string& after,
                           const std::string& part) {
    const std::string wrong = edited(sensors, before, after);
    expect_contains(folder.message(wrong), part, wrong);
  };
  refused("\"acc2\"", "\"acc1\"", "accelerometer[1].channel = 'acc1'; must be a channel");
  refused("\"acc2\"", "\"force\"", "accelerometer[1].channel = 'force'");
  refused("\"acc2\"", "\"\"", "accelerometer[1].channel");
  refused("\"acc2\"\npoint = \"root\"", "\"acc2\"\npoint = \"rot\"", "Did you mean 'root'?");
  refused("\"acc2\"\n", "\"acc2\"\nposition_m = 1\n", "position_m");
  refused("channel = \"acc1\"\n", "", "channel");
}

TEST(ModelFileFault, EachMissingKey) {
  const ModelFolder folder;
  const std::set<std::string> optional{"joint[0].name",
                                       "joint[0].spring_in_modes_N_per_m",
                                       "joint[0].series_compliance_m_per_N",
                                       "joint[0].shortening_per_kg_m",
                                       "excitation[0].harmonics",
                                       "excitation[0].phase_rad"};
  for (const Pair& pair : pairs_of(kText)) {
    std::string text = test::without(kText, pair);
    if (pair.key == "harmonics") text = edited(text, "phase_rad = [0, 1.2]", "phase_rad = [1.2]");
    const std::string found = folder.message(text);
    if (optional.count(pair.path) > 0) {
      EXPECT_EQ(found, "no error") << pair.path;
      continue;
    }
    expect_contains(found, "model.toml:", text);
    expect_contains(found, pair.key, text);
    const std::string table = pair.path.substr(0, pair.path.rfind('.'));
    if (table != pair.path) expect_contains(found, table, text);
  }
}

TEST(ModelFileFault, EachReplacedValue) {
  const ModelFolder folder;
  const std::set<std::pair<std::string, std::string>> harmless{
      {"structure.frequency_Hz", "[0, 0]"},      // a free body
      {"structure.damping_ratio", "[0, 0]"},     // no damping
      {"joint[0].shape", "[0, 0]"},              // it moves by its shortening
      {"excitation[0].harmonics", "[1, 2, 3]"},  // what is at fault are its phases
      {"excitation[0].phase_rad", "[0, 0]"}};
  std::size_t cases = 0;
  for (const Pair& pair : pairs_of(kText)) {
    for (const std::string value :
         {"\"\"", "-1", "[]", "nan", "-inf", "1e99", "true", "[[1]]", "{}", "2014-06-01", "[\"a\"]",
          "[nan, 1]", "[1, inf]", "[1, 2, 3]", "[0, 0]"}) {
      if (harmless.count({pair.path, value}) > 0) continue;
      std::string text = kText;
      text.replace(pair.value_start, pair.end - pair.value_start, value);
      const std::string found = folder.message(text);
      expect_contains(found, "model.toml:", text);
      if (pair.key != "frequency_Hz" || value != "[1, 2, 3]") {
        expect_contains(found, fmt::format("model.toml:{}:", pair.line), text);
        expect_contains(found, pair.path, text);
      }
      ++cases;
    }
  }
  EXPECT_GT(cases, 250U);
}

TEST(ModelFileFault, EachMisspeltKey) {
  const ModelFolder folder;
  for (const Pair& pair : pairs_of(kText)) {
    if (pair.key == "schema") continue;  // without it nothing else is looked at
    std::string text = kText;
    text.insert(pair.start + 1, "x");
    const std::string found = folder.message(text);
    expect_contains(found, fmt::format("model.toml:{}:", pair.line), text);
    expect_contains(found, fmt::format("Did you mean '{}'?", pair.key), text);
  }
}

TEST(ModelFileFault, EachMissingHeader) {  // its keys belong to the table before it then
  const ModelFolder folder;
  for (std::size_t at = kText.find("\n["); at != std::string::npos;
       at = kText.find("\n[", at + 1)) {
    std::string text = kText;
    text.erase(at + 1, text.find('\n', at + 1) - at);
    expect_contains(folder.message(text), "model.toml:", text);
  }
}

// ---- Whole messages. ----

struct Fault {
  std::string before;
  std::string after;
  std::string message;
};

void expect_faults(const std::vector<Fault>& faults) {
  const ModelFolder folder;
  for (const Fault& fault : faults) {
    EXPECT_EQ(folder.message(edited(kText, fault.before, fault.after)), fault.message)
        << fault.after;
  }
}

TEST(ModelFileFault, NoFile) {
  EXPECT_EQ(message_of<FileError>([] { return read_model("no-such-model.toml"); }),
            "no-such-model.toml: cannot be read: No such file or directory. Check the path.");
}

TEST(ModelFileFault, AnotherFile) {
  const ModelFolder folder;
  EXPECT_EQ(folder.message(""), "model.toml: expected TOML, found an empty file");
  EXPECT_EQ(folder.message(joint_text(1.0)),
            "model.toml: expected TOML, found a joint (joint.json). Is it the right file?");
  EXPECT_EQ(folder.message("schema = \"microslip.rig/1\"\nsurprise = 1\n"),
            "model.toml:1:10: expected the schema 'microslip.model/1', found 'microslip.rig/1'. "
            "This is the description of a frictional-support test (rig.toml), not a model. "
            "Make a model of it: microslip model RIG.toml JOINT.json.");
  EXPECT_EQ(
      folder.message("schema = \"microslip.plan/1\"\n"),
      "model.toml:1:10: expected the schema 'microslip.model/1', found 'microslip.plan/1'. Is "
      "it a model, and of this version of the program?");
}

// Each eigenvalue of the matrix becomes a mode at ten times 120.5 Hz: φ_a = ω_a √λ v.
TEST(ModelFile, AResidualBecomesModes) {
  const ModelFolder folder;
  const std::string residual =
      "[structure.residual]\npoints = [\"root\"]\njoints = [\"left\"]\n"
      "compliance_m_per_N = [3e-7, 1e-7, 1e-7, 2e-7]\n";
  const std::string spread = "frequency_std = [0.01]\n";
  const ModelFile model =
      folder.parse(edited(kText, "[[structure.point]]", spread + residual + "[[structure.point]]"));
  EXPECT_EQ(model.static_attachments, std::optional<std::size_t>(2));
  const JointedStructure& structure = model.structure;
  ASSERT_EQ(structure.linear().size(), 4U);
  EXPECT_EQ(structure.linear().static_modes(), 2U);
  EXPECT_EQ(model.spread.frequency, (std::vector<double>{0.01, 0.01, 0.0, 0.0}));
  EXPECT_EQ(list(structure.linear().shape("tip")), (std::vector<double>{1.5, -0.5, 0.0, 0.0}));
  EXPECT_EQ(structure.joints()[1].shape[2], 0.0);
  EXPECT_EQ(structure.joints()[0].shortening.size(), 16U);
  double own = 0.0;
  double between = 0.0;
  for (std::size_t i = 2; i < 4; ++i) {
    const Mode& mode = structure.linear().modes()[i];
    EXPECT_DOUBLE_EQ(mode.angular_frequency, 10.0 * 2.0 * std::numbers::pi * 120.5);
    EXPECT_EQ(mode.loss_factor, 4e-3);
    const double at_joint = structure.joints()[0].shape[i] / mode.angular_frequency;
    own += at_joint * at_joint;
    between += at_joint * structure.linear().shape("root")[i] / mode.angular_frequency;
  }
  EXPECT_NEAR(own, 2e-7, 1e-20);
  EXPECT_NEAR(between, 1e-7, 1e-20);
}

TEST(ModelFileFault, Residual) {
  const auto with = [](const std::string& lines) { return lines + "[[structure.point]]"; };
  expect_faults({
      {"[[structure.point]]",
       with("[structure.residual]\npoints = [\"root\"]\ncompliance_m_per_N = [1, 2]\n"),
       "model.toml: compliance of the residual = 2 values; must have 1, by rows, one per point and "
       "joint that it names"},
      {"[[structure.point]]",
       with("[structure.residual]\njoints = [\"root\"]\ncompliance_m_per_N = [1]\n"),
       "model.toml: joint of the residual = 'root'; must be a joint of the model"},
      {"[[structure.point]]", with("[structure.residual]\npoints = [\"root\"]\n"),
       "model.toml:5:1: expected the key 'compliance_m_per_N' in structure.residual, found the "
       "keys 'points'"},
      {"[[structure.point]]", with("static_attachments = 2\n"),
       "model.toml:5:22: structure.static_attachments = 2; must be below the number of modes, 2"},
      {"[50, 120.5]", "[120.5, 50]\nstatic_attachments = 1",
       "model.toml:4:22: structure.static_attachments = 1; must be of the last modes, which must "
       "be above the others in frequency"},
      {"[[structure.point]]",
       with("static_attachments = 1\n[structure.residual]\ncompliance_m_per_N = [1]\n"),
       "model.toml:6:1: structure.residual = given with static_attachments; must not be given: the "
       "residual would count twice"},
  });
}

TEST(ModelFileFault, Structure) {
  expect_faults({
      {"[50, 120.5]", "[50, -1]",
       "model.toml:3:21: structure.frequency_Hz[1] = -1; must be from 0 to 1e+09"},
      {"[50, 120.5]", "[]",
       "model.toml:3:16: structure.frequency_Hz = 0 values; must have one per mode, at least 1"},
      {"[1e-3, 2e-3]", "[1e-3, 2e-3, 3e-3]",
       "model.toml:4:17: structure.damping_ratio = 3 values; must have 2, one per mode of "
       "structure.frequency_Hz, or 1 for all"},
      {"damping_ratio = [1e-3, 2e-3]\n", "",
       "model.toml:3:16: expected in structure one of the keys damping_ratio and loss_factor, "
       "found neither"},
      {"[[structure.point]]", "loss_factor = [0]\n[[structure.point]]",
       "model.toml:5:15: expected in structure one of the keys damping_ratio and loss_factor, "
       "found both"},
      {"[1.5, -0.5]", "[1.5]",
       "model.toml:7:9: structure.point[0].shape = 1 value; must have 2, one per mode of "
       "structure.frequency_Hz"},
      {"[1.5, -0.5]", "[0, 1e-12]",
       "model.toml:7:9: structure.point[0].shape = 0 in all modes; must be 1e-09 or more in at "
       "least one mode"},
      {"\"root\"", "\"tip\"",
       "model.toml:9:8: structure.point[1].name = 'tip'; must differ from structure.point[0].name"},
      {"\"root\"", "\"root [m]\"",
       "model.toml:9:8: structure.point[1].name = 'root [m]'; must be a text, without [ ] , ; \" # "
       "and tabs"},
  });
}

TEST(ModelFileFault, Joints) {
  expect_faults({
      {"shape = [0.2, 0.3]\n", "shape = [0.2, 0.3]\nstiffness = 1\n",
       "model.toml:15:1: expected in joint[0] the keys file, stiffness_N_per_m, shape, name, "
       "spring_in_modes_N_per_m, series_compliance_m_per_N, shortening_per_kg_m, "
       "linear_damping_J_per_m2, samples, normal_load_std, found the unknown key 'stiffness'. Did "
       "you mean 'stiffness_N_per_m'?"},
      {"\"left\"", "\"joint2\"",
       "model.toml:18:1: joint[1].name = 'joint2'; must differ from "
       "joint[0].name"},
      {"1e5\n", "-1e5\n",
       "model.toml:15:27: joint[0].spring_in_modes_N_per_m = -100000; must be from 0 to 1e+15"},
      {"[0, -0.4]", "[0, 0]",
       "model.toml:20:9: joint[1].shape = 0 in all modes; must be 1e-09 or more in at least one "
       "mode"},
      {"[3, 0.5, 0.5, 4]", "[3, 0.5, 4]",
       "model.toml:17:23: joint[0].shortening_per_kg_m = 3 values; must have 4, the rows of a "
       "symmetric matrix with one row per mode"},
      {"[3, 0.5, 0.5, 4]", "[3, 0.5, 0.6, 4]",
       "model.toml: shortening[1, 0] of joint 'left' = 0.6; must be that of [0, 1], 0.5"},
      {"\"b.json\"", "\"c.json\"",
       "model.toml:19:8: joint[1].file: c.json: cannot be read: No such file or directory. Check "
       "the path."},
      {"\"b.json\"", "\"joints\"",
       "model.toml:19:8: joint[1].file: joints: is a folder. Name a file in it."},
      {"\"b.json\"", "\"\"",
       "model.toml:19:8: joint[1].file = ''; must be the path of a joint file, without control "
       "characters"},
      {"\"b.json\"", "\"b.json\\u0000.toml\"",
       "model.toml:19:8: joint[1].file = 'b.json\\x00.toml'; must be the path of a joint file, "
       "without control characters"},
      {"[[joint]]\nname", "[joint]\nname",
       "model.toml:18:1: expected TOML, found '[[joint]]'. The parser says 'Error while parsing "
       "table header: cannot redefine existing table 'joint' as array-of-tables'. Quote strings; "
       "write numbers with a decimal point and no unit; give each key once per table; write "
       "[[table]] for each of several tables."},
  });
}

TEST(ModelFileFault, JointFilesThatAreBroken) {
  const ModelFolder folder;
  test::put(folder.file("b.json"), "{\"schema\": \"microslip.joint/1\"");
  expect_contains(folder.message(kText), "b.json:1:", "cut short");
  test::put(folder.file("b.json"), joint_text(-1.0));
  expect_contains(folder.message(kText), "b.json: stiffness_N_per_m = -1; must be", "negative");
  test::put(folder.file("b.json"), kText);
  expect_contains(folder.message(kText),
                  "b.json: expected JSON, found a structure with joints (model.toml)", "TOML");
}

TEST(ModelFileFault, ExcitationAndResponse) {
  expect_faults({
      {"point = \"tip\"", "point = \"tipp\"",
       "model.toml:22:9: excitation[0].point = 'tipp'; must be the name of a point: "
       "'tip, root'. Did you mean 'tip'?"},
      {"[response]\npoint = \"root\"", "[response]\npoint = \"engine\"",
       "model.toml:28:9: response.point = 'engine'; must be the name of a point: "
       "'tip, root'"},
      {"[1.0, 0.05]", "[0, 0]",
       "model.toml:23:13: excitation[0].harmonics = no harmonic; must have at least one that is "
       "not 0"},
      {"[0, 1.2]", "[0]",
       "model.toml:24:13: excitation[0].phase_rad = 1 value; must have 2, one per harmonic"},
  });
  const ModelFolder folder;
  const std::string head = kText.substr(0, kText.find("[[excitation]]"));
  EXPECT_EQ(folder.message(edited(head, "[structure]", "excitation = []\n[structure]")),
            "model.toml:2:14: excitation = an empty array; must have at least one excitation. "
            "Write [excitation] with point.");
  EXPECT_EQ(folder.message(edited(head, "[structure]", "excitation = \"tip\"\n[structure]")),
            "model.toml:2:14: excitation = 'tip'; must be an array of tables. Write "
            "[[excitation]].");
}

// ---- Damage. ----

void expect_structure(const ModelFile& file) {
  for (const double omega : file.structure.stuck_frequencies()) {
    EXPECT_TRUE(std::isfinite(omega) && omega >= 0.0);
  }
  EXPECT_NO_THROW((void)file.structure.linear().shape(file.response));
  EXPECT_EQ(file.joint_files.size(), file.structure.joints().size());
}

TEST(ModelFileDamage, OfEveryKey) {
  const ModelFolder folder;
  const std::string name = folder.file("model.toml");
  // Little of the text itself can be changed without harm.
  test::damage(kText + "# " + std::string(300, '-') + "\n", 31, name,
               [&](const std::string& text) { expect_structure(parse_model(text, name)); });
}

TEST(ModelFileDamage, OfTheOneMass) {
  const ModelFolder folder;
  const std::string name = folder.file("model.toml");
  test::damage(test::get(kOneMass), 32, name,
               [&](const std::string& text) { expect_structure(parse_model(text, name)); });
}

TEST(ModelFileDamage, CutAtEachByte) {
  const ModelFolder folder;
  for (std::size_t size = 0; size <= kText.size(); ++size) {
    try {
      expect_structure(folder.parse(kText.substr(0, size)));
      EXPECT_GT(size, kText.find("[[excitation]]")) << "all before it is needed";
    } catch (const Error& error) {
      test::expect_clear(error.what(), folder.file("model.toml"));
    }
  }
}

}  // namespace
}  // namespace microslip::model_file_test
