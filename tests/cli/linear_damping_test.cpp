// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/tables/csv.hpp"
#include "support/replaced.hpp"

/// @file
/// The linear damping that an identification found beside a joint reaches every prediction by it.

namespace microslip::cli_test::linear_damping_test {
namespace {

namespace fs = std::filesystem;

const std::string kExample = MICROSLIP_EXAMPLES "/reference_rig/";

/// The joint of the reference rig; identified, with or without linear damping of some 5 % of k.
std::string joint_text(const std::string& damping) {
  std::string text = test::get(kExample + "joint.json");
  const std::string identification =
      damping.empty() ? R"(, "identification": {"method": "inversion"})"
                      : R"(, "identification": {"linear_damping_J_per_m2": )" + damping + "}";
  return text.insert(text.rfind('}'), identification);
}

/// What each command starts from: the reference rig, as a test and as a model.
class Start : public Sandbox {
 public:
  explicit Start(const std::string& damping) {
    put("joint.json", joint_text(damping));
    put("rig.toml", test::replaced(test::get(kExample + "rig.toml"), "count = 90", "count = 2"));
    for (const char* name : {"model.toml", "recordings/level_05.csv"}) {
      fs::copy_file(kExample + name, file(fs::path(name).filename().string()));
    }
  }
};

/// The largest of a column.
double largest(const std::string& text, const std::string& column) {
  const CsvTable table(text, "out.csv");
  for (const CsvColumn& one : table.columns()) {
    if (one.name != column) continue;
    const std::optional<Unit> unit = find_unit(one.unit.value_or(""));
    if (!unit) break;
    return std::ranges::max(table.numbers(column, unit->dimension));
  }
  ADD_FAILURE() << "no column " << column << " in\n" << text.substr(0, 500);
  return 0.0;
}

struct Effect {
  Arguments call;
  std::string out;                  ///< the table that it writes
  std::vector<std::string> larger;  ///< columns whose largest value linear damping raises
  std::vector<std::string> smaller;
  std::vector<std::string> same;
  std::string says;  ///< a comment of the table
};

const std::vector<Effect> kEffects{
    {{"frf", "model.toml", "--force", "1", "--frequency", "54:57", "--out", "out.csv"},
     "out.csv",
     {},
     {"displacement", "linear_dissipation", "amplitude_contact"},
     {"force"},
     "# linear damping of 'contact': 8500 J/m^2 beside slip, as identified\n"},
    {{"frf", "model.toml", "--response", "0.1mm", "--frequency", "54:57", "--out", "out.csv"},
     "out.csv",
     {"dissipation", "dissipation_contact"},
     {},
     {"displacement"},
     "# linear damping of 'contact': 8500 J/m^2 beside slip, as identified\n"},
    {{"backbone", "model.toml", "--response", "1um:0.1mm:5", "--out", "out.csv"},
     "out.csv",
     {"force", "damping_ratio", "dissipation", "dissipation_contact"},
     {},
     {"displacement"},
     "# linear damping of 'contact': 8500 J/m^2 beside slip, as identified\n"},
    {{"dissipation", "joint.json", "--amplitude", "1um:200um:5", "--out", "out.csv"},
     "out.csv",
     {"dissipation", "loss_factor"},
     {},
     {"amplitude", "force", "secant_stiffness"},
     "# linear damping of the joint: 8500 J/m^2 beside slip\n"},
    {{"loop", "joint.json", "--amplitude", "200um", "--out", "out.csv"},
     "out.csv",
     {},
     {},
     {"displacement", "force"},
     "# warning: linear_damping_left_out: The joint was identified with a linear damping of 8500 "
     "J/m^2 beside slip, which "
     "is not in the force"},
    {{"measure", "rig.toml", "--out", "test", "--no-shaker"},
     "test/truth.csv",
     {"force_amplitude", "dissipation", "input_energy"},
     {},
     {"response_amplitude"},
     "# linear damping of the joint: 8500 J/m^2 beside slip\n"},
    {{"verify", "rig.toml", "joint.json", "level_05.csv", "--out", "out.csv"},
     "out.csv",
     {"predicted_input_energy", "NRMSE"},
     {},
     {"input_energy", "predicted_joint_amplitude"},
     "# linear damping of the joint: 8500 J/m^2 beside slip\n"},
};

/// Of the first harmonic the amplitude is given, others hardly differ.
constexpr double kSame = 1e-3;
constexpr double kDiffers = 0.01;

std::string table_of(const Effect& effect, const std::string& damping, bool quiet) {
  const Start box(damping);
  Arguments call = effect.call;
  if (quiet) call.emplace_back("--quiet");
  const Outcome run = box.run(call);
  EXPECT_EQ(run.status, 0) << typed(call) << "\n" << run.err;
  return box.get(effect.out);
}

TEST(linear_damping, ReachesEveryPrediction) {
  for (const Effect& effect : kEffects) {
    SCOPED_TRACE(typed(effect.call));
    const std::string without = table_of(effect, "", false);
    const std::string with = table_of(effect, "8500", true);
    for (const std::string& column : effect.larger) {
      EXPECT_GT(largest(with, column), (1.0 + kDiffers) * largest(without, column)) << column;
    }
    for (const std::string& column : effect.smaller) {
      EXPECT_LT(largest(with, column), (1.0 - kDiffers) * largest(without, column)) << column;
    }
    for (const std::string& column : effect.same) {
      const double expected = largest(without, column);
      EXPECT_NEAR(largest(with, column), expected, kSame * std::abs(expected)) << column;
    }
    EXPECT_NE(with.find(effect.says), std::string::npos) << with.substr(0, 1000);
    EXPECT_EQ(without.find("linear damping"), std::string::npos) << without.substr(0, 500);
    EXPECT_EQ(table_of(effect, "0", true).find("linear damping"), std::string::npos);
  }
}

/// The rows of a table, without comments.
std::string rows(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    if (text[at] != '#') result += text.substr(at, end - at);
    at = end;
  }
  return result;
}

// D is given in two parts: its column of slip and linear damping, and the part that is not slip.
TEST(linear_damping, IsAColumnBesideTheDissipation) {
  const Start box("8500");
  expect_done(box, {"backbone", "model.toml", "--response", "1um:0.1mm:5", "--out", "b.csv"});
  const CsvTable backbone(box.get("b.csv"), "b.csv");
  const std::vector<double> a = backbone.numbers("amplitude_contact", kLength);
  const std::vector<double> linear = backbone.numbers("linear_dissipation_contact", kEnergy);
  const std::vector<double> all = backbone.numbers("dissipation_contact", kEnergy);
  expect_done(box, {"dissipation", "joint.json", "--amplitude", "1um:50um:5", "--out", "d.csv"});
  const CsvTable curve(box.get("d.csv"), "d.csv");
  for (std::size_t i = 0; i < a.size(); ++i) {
    // The mean and harmonics of the shortening are no part of βA².
    EXPECT_NEAR(linear[i], 8500.0 * a[i] * a[i], 1e-3 * linear[i]);
    EXPECT_LT(linear[i], all[i]);
  }
  const std::vector<double> x = curve.numbers("amplitude", kLength);
  const std::vector<double> part = curve.numbers("joint_linear_dissipation", kEnergy);
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(part[i], 8500.0 * x[i] * x[i], 1e-12 * part[i]);
  }
}

TEST(linear_damping, IsWhatTheModelSays) {
  const Arguments frf{"frf",         "model.toml", "--force", "1",
                      "--frequency", "54:57",      "--out",   "o.csv"};
  const auto table = [&](const std::string& in_joint, const std::string& in_model) {
    const Start box(in_joint);
    if (!in_model.empty()) {
      box.put("model.toml",
              test::replaced(box.get("model.toml"), "[[joint]]\n",
                             "[[joint]]\nlinear_damping_J_per_m2 = " + in_model + "\n"));
    }
    const Outcome run = expect_done(box, frf);
    EXPECT_EQ(run.out.find("linear damping ") == std::string::npos,
              in_joint.empty() && in_model.empty())
        << run.out;
    return box.get("o.csv");
  };
  const std::string none = table("", "");
  const std::string identified = table("8500", "");
  EXPECT_NE(rows(none), rows(identified));
  EXPECT_EQ(rows(table("8500", "8500")), rows(identified));
  EXPECT_EQ(rows(table("", "8500")), rows(identified));
  EXPECT_EQ(rows(table("100", "8500")), rows(identified));
  const std::string left_out = table("8500", "0");
  EXPECT_EQ(rows(left_out), rows(none));
  EXPECT_NE(
      left_out.find("# linear damping of 'contact': none, as the model specifies; identified are "
                    "8500 J/m^2\n"),
      std::string::npos)
      << left_out.substr(0, 500);
  EXPECT_NE(table("", "70").find(
                "# linear damping of 'contact': 70 J/m^2 beside slip, as the model specifies\n"),
            std::string::npos);
}

TEST(linear_damping, IsWrittenIntoTheModelOfARig) {
  const Arguments call{"model", "rig.toml", "joint.json", "--out", "new.toml"};
  const Start with("8500");
  const Outcome run = expect_done(with, call);
  EXPECT_NE(run.out.find("linear damping       'contact': 8500 J/m^2 beside slip, as identified"),
            std::string::npos)
      << run.out;
  EXPECT_NE(with.get("new.toml").find("\nlinear_damping_J_per_m2 = 8500\n"), std::string::npos);
  const Start without("");
  expect_done(without, call);
  EXPECT_EQ(without.get("new.toml").find("linear_damping"), std::string::npos);
}

// By each method to identify with it.
TEST(linear_damping, GoesFromIdentifyToThePrediction) {
  Levels levels = sample_levels();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    levels.dissipation[i] += 8500.0 * levels.amplitude[i] * levels.amplitude[i];
  }
  const std::vector<Arguments> methods{{}, {"--fit", "power_law"}, {"--fit", "four_parameter"}};
  for (const Arguments& method : methods) {
    const Start box("");
    box.put("levels.csv", levels_table(levels).str());
    const auto loss = [&](const std::string& damping) {
      Arguments call{"identify", "levels.csv", "--stiffness", "1.7e5",  "--linear-damping",
                     damping,    "--out",      "found.json",  "--quiet"};
      call.insert(call.end(), method.begin(), method.end());
      EXPECT_EQ(box.run(call).status, 0) << typed(call);
      box.put("model.toml",
              test::replaced(test::get(kExample + "model.toml"), "joint.json", "found.json"));
      expect_done(box, {"backbone", "model.toml", "--response", "1um:0.2mm:5", "--out", "b.csv"});
      return box.get("b.csv");
    };
    EXPECT_GT(largest(loss("fit"), "linear_dissipation_contact"), 0.0) << typed(method);
    EXPECT_EQ(loss("none").find("linear_dissipation_contact"), std::string::npos) << typed(method);
  }
}

TEST(linear_damping, IsRefusedWhereItIsNone) {
  const Arguments dissipation{"dissipation", "joint.json", "--amplitude",
                              "1um:2um:2",   "--out",      "out.csv"};
  for (const std::string value : {"-1", "1e16", "\"4672\"", "null", "[1]"}) {
    const Start box(value);
    expect_refused(box, dissipation,
                   {"joint.json: identification.linear_damping_J_per_m2 = ", "must be"});
  }
  for (const std::string value : {"-1.0", "nan", "inf", "1e16"}) {
    const Start box("8500");
    box.put("model.toml", test::replaced(box.get("model.toml"), "[[joint]]\n",
                                         "[[joint]]\nlinear_damping_J_per_m2 = " + value + "\n"));
    expect_refused(box, {"backbone", "model.toml", "--response", "1um:2um:2", "--out", "o.csv"},
                   {"model.toml:", "linear_damping_J_per_m2 = ", "must be"});
  }
}

// The mode has the loss factor that the joint's damping is: who carries it over by hand has it
// twice.
TEST(linear_damping, IsWarnedOfWhereTheModeHasItToo) {
  const Sandbox box{{"joint.json", joint_text("850")},
                    {"model.toml", R"(schema = "microslip.model/1"
[structure]
frequency_Hz = [100.0]
loss_factor = [0.0016]
[[structure.point]]
name = "drive"
shape = [1.5238]
[[joint]]
file = "joint.json"
shape = [1.5238]
spring_in_modes_N_per_m = 1.7e5
[excitation]
point = "drive"
)"}};
  const Arguments call{"backbone", "model.toml", "--response", "1um:2um:2", "--out", "o.csv"};
  const Outcome run = expect_done(box, call);
  EXPECT_NE(run.out.find("  warning: mode 1 has a loss factor of 0.0016, and joint 'joint'"),
            std::string::npos)
      << run.out;
  EXPECT_NE(box.get("o.csv").find("# warning: damping_twice: mode 1 has a loss factor of 0.0016"),
            std::string::npos);
}

}  // namespace
}  // namespace microslip::cli_test::linear_damping_test
