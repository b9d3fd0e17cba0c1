// SPDX-License-Identifier: MIT
// That each option, key and column reaches the outputs that tests/data/effects.txt says.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "arguments/command.hpp"
#include "cli/effects_table.hpp"
#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "documents/description.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/observe/sensor_drift.hpp"
#include "support/effort.hpp"
#include "support/jointed_records.hpp"
#include "support/tested_chain.hpp"

namespace microslip::cli_test::effects_test {
namespace {

using Files = std::map<std::string, std::string>;

constexpr const char* kAddRow =
    " has no row in tests/data/effects.txt; add one, the top of the file says how";

/// Whether the program has the command that a row calls: `modes` is left out where MUMPS is.
bool can_run(const EffectRow& row) {
  static const bool has_modes = [] {
    app::Call call;
    const auto is_modes = [](const CLI::App* command) { return command->get_name() == "modes"; };
    return !app::make_program(call)->get_subcommands(is_modes).empty();
  }();
  return has_modes || !row.base.starts_with("modes ");
}

/// What a call leaves.
struct Run {
  Outcome outcome;
  Files files;
};

Arguments words(const std::string& text) {
  Arguments result;
  std::istringstream in(text);
  for (std::string word; in >> word;) result.push_back(word);
  return result;
}

void put_all(const std::string& folder, const Files& files) {
  for (const auto& [name, content] : files) {
    const std::filesystem::path path = std::filesystem::path(folder) / name;
    std::filesystem::create_directories(path.parent_path());
    test::put(path, content);
  }
}

/// Whether a text names a file, or the folder that it is in.
bool is_named(const std::string& text, const std::string& file) {
  return text.find(file.substr(0, file.find('/'))) != std::string::npos;
}

/// The files that a call may come upon: those that it names, and those that these name. To write
/// and to read again all of the inputs takes longer than most calls.
Files reached(const Files& inputs, const std::string& call) {
  Files found;
  std::vector<std::string> texts{call};
  while (!texts.empty()) {
    const std::string text = texts.back();
    texts.pop_back();
    for (const auto& [name, content] : inputs) {
      if (!is_named(text, name) || !found.emplace(name, content).second) continue;
      if (name.ends_with(".toml") || name.ends_with(".json")) texts.push_back(content);
    }
  }
  return found;
}

Run run(const Files& inputs, const Arguments& arguments) {
  const Sandbox box;
  put_all(box.path(), reached(inputs, fmt::format("{}", fmt::join(arguments, " "))));
  Run result;
  result.outcome = box.run(arguments);
  for (const auto& [path, content] : box.content()) {
    result.files[std::filesystem::path(path).lexically_relative(box.path())] = content;
  }
  return result;
}

/// Levels whose columns are all there: by ringdown or reduce, and with what they do not have.
std::string full_levels() {
  std::string text =
      "amplitude [m],amplitude_std [m],dissipation [J],dissipation_std [J],secant_stiffness [N/m],"
      "secant_stiffness_std [N/m],linear_dissipation [J],reversals [1],flags\n";
  const Joint joint = sample_joint();
  for (int i = 1; i <= 12; ++i) {
    const double a = 2e-5 * i;
    const double d = dissipation(joint, a) * (1.0 + 0.01 * std::sin(7.0 * i));
    const double k = secant_stiffness(joint, a) * (1.0 + 0.002 * std::sin(5.0 * i));
    text += fmt::format("{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{},{}\n", a,
                        0.003 * a, d, 0.01 * d * (1.0 + 0.5 * std::sin(i)), k, 300.0 + 20.0 * i,
                        0.4 * d, i == 7 ? 4 : 2, i == 3 ? "dissipation_in_noise" : "");
  }
  return text;
}

std::string first_lines(const std::string& text, int count) {
  std::size_t end = 0;
  while (count-- > 0) end = text.find('\n', end) + 1;
  return text.substr(0, end);
}

/// Of three assemblies whose k and slip forces differ; with repeated levels that turn inside.
std::string assembled_levels() {
  std::string text =
      "assembly,stiffness [N/m],amplitude [m],dissipation [J],secant_stiffness [N/m],reversals [1]";
  const Joint joint = sample_joint();
  for (int j = 0; j < 3; ++j) {
    const double k = 1.7e5 * (1.0 + 0.04 * j);
    for (int i = 1; i <= 8; ++i) {
      const double a = 2.5e-5 * i;
      const double moved = a * (1.0 + 0.06 * j);
      const double d = dissipation(joint, moved) * (1.0 + 0.01 * std::sin(7.0 * i + j));
      text += fmt::format("\n{},{:.12g},{:.12g},{:.12g},{:.12g},{}", "abc"[j], k, a, d,
                          secant_stiffness(joint, moved) * k / 1.7e5, i == 7 ? 4 : 2);
    }
  }
  return text + '\n';
}

/// Levels with a frequency in each of these columns: of the drive, which wanders, and of resonance.
std::string heard_levels(const std::vector<std::string>& columns) {
  const Joint joint = sample_joint();
  std::string text = "amplitude [m],dissipation [J]";
  for (const std::string& column : columns) text += fmt::format(",{} [Hz]", column);
  for (int i = 1; i <= 12; ++i) {
    const double a = 2e-5 * i;
    text += fmt::format("\n{:.12g},{:.12g}", a, dissipation(joint, a));
    for (const std::string& column : columns) {
      const double wander = column == "frequency" ? 0.1 * std::sin(3.0 * i) : 0.0;
      text += fmt::format(",{:.12g}", 55.0 - 0.02 * i + wander);
    }
  }
  return text + "\n";
}

/// Levels of a joint whose macro-slip begins at once, at 40 N.
std::string atom_levels() {
  const Joint joint = parse_joint(R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 1.7e5,
      "density": [{"type": "uniform", "from_N": 0, "to_N": 40, "weight": 0.5},
                  {"type": "atoms", "slip_force_N": [40], "weight": [0.3]}]})",
                                  "atom.json")
                          .joint;
  std::string text = "amplitude [m],dissipation [J]\n";
  for (int i = 1; i <= 40; ++i) {
    const double a = 1e-5 * i;
    text += fmt::format("{:.12g},{:.12g}\n", a,
                        dissipation(joint, a) * (1.0 + 0.001 * std::sin(7.0 * i)));
  }
  return text;
}

/// What predictions use of an identification.
constexpr const char* kIdentification =
    "],\n\"identification\": {\"linear_damping_J_per_m2\": 2000.0, \"covered_to_N\": 50.0}\n}";

/// The first column of a table and its second, with what is made of it and of that of another.
template <class F>
std::string combined(const std::string& table, const std::string& other, const char* header,
                     const F& text_of) {
  std::istringstream lines(table);
  std::istringstream others(other);
  std::string line;
  std::string beside;
  std::getline(lines, line);
  std::getline(others, beside);
  std::string result = header;
  while (std::getline(lines, line) && std::getline(others, beside)) {
    const std::size_t comma = line.find(',');
    result +=
        line.substr(0, comma) + "," +
        text_of(std::stod(line.substr(comma + 1)), std::stod(beside.substr(beside.find(',') + 1))) +
        "\n";
  }
  return result;
}

/// A decay that two accelerometers see.
std::string two_channels(const std::string& decay) {
  return combined(decay, decay, "time [s],acc1 [m/s^2],acc2 [m/s^2]\n",
                  [](double x, double) { return fmt::format("{:.17g},{:.17g}", x, 0.7 * x); });
}

/// Two modes in one channel.
std::string two_modes(const std::string& decay) {
  SampleDecay second;
  second.frequency = 120.0;
  second.amplitude = 1e-5;
  second.damping = 0.005;
  return combined(decay, sample_decay_text(second), "time [s],acc1 [m/s^2]\n",
                  [](double x, double y) { return fmt::format("{:.17g}", x + y); });
}

/// Two sensors of each quantity at a joint: the second ones read 10 % more.
std::string two_records() {
  const ForceRecord record = sample_record();
  std::string text = "time [s],u1 [m],u2 [m],f1 [N],f2 [N]\n";
  for (std::size_t i = 0; i < record.size(); ++i) {
    const double u = record.displacement[i];
    const double f = record.force[i];
    text += fmt::format("{:.6f},{:.9g},{:.9g},{:.9g},{:.9g}\n",
                        record.time_step * static_cast<double>(i), u, 1.1 * u, f, 1.1 * f);
  }
  return text;
}

/// A displacement whose zero moves by 30 µm in the course of the record.
std::string drifting_record() {
  return record_text(without_drift(sample_record(), {.displacement = {-3e-5}}));
}

/// A structure with two joints, of the stiffness 1.7e5 and 4e5 N/m.
std::string two_laps() {
  std::string text =
      "schema = \"microslip.model/1\"\n[structure]\nfrequency_Hz = [16.0]\nloss_factor = [0.004]\n"
      "[[structure.point]]\nname = \"first\"\nshape = [0.707]\n";
  for (const auto* joint : {"joint", "joint400"}) {
    text += fmt::format("[[joint]]\nname = \"{0}\"\nfile = \"{0}.json\"\nshape = [0.01]\n", joint);
  }
  return text + "[excitation]\npoint = \"first\"\n";
}

/// The files from which every call starts: those of docs/file_formats.md, records of their rig, and
/// what the options are about that only files with a fault need.
/// structure.toml with joints that slip.
JointedStructure slipping_structure(const std::string& model_text) {
  const ModelFile model = parse_model(model_text, "structure.toml", JointsToFind::kAllowed);
  std::vector<StructuralJoint> joints(model.structure.joints().begin(),
                                      model.structure.joints().end());
  for (StructuralJoint& joint : joints) {
    joint.joint = testing::humped_joint(joint.joint.stiffness(), 20.0, 0.01);
  }
  return JointedStructure(
      model.structure.linear(), joints,
      {model.structure.excitations().begin(), model.structure.excitations().end()},
      model.structure.damping());
}

/// Its steady vibration in the second mode.
std::string steady_record(const JointedStructure& structure) {
  const VibrationResult vibration =
      HarmonicBalance(structure, {"tip"}).solve(kPhaseResonance, {Quantity::kResponse, 3e-5}, 1);
  const Recording record =
      testing::record_of(structure, vibration.vibration, {"tip", "end"}, 1,
                         {.rate = 2048.0, .force_noise = 2e-4, .acceleration_noise = 5e-4});
  CsvWriter writer;
  std::vector<double> time;
  for (std::size_t i = 0; i < record.size(); ++i) time.push_back(record.axis.at(i));
  writer.add_numbers("time", kTime, time);
  writer.add_numbers("force", kForce, record.channels[0].values);
  writer.add_numbers("acc1", kAcceleration, record.channels[1].values);
  writer.add_numbers("acc2", kAcceleration, record.channels[2].values);
  return writer.str();
}

/// Its decay from a deflection in the first and the second mode.
std::string free_decay(const JointedStructure& structure) {
  LoadHistory loads;
  for (int i = 0; i < 4096; ++i) loads.time.push_back(i / 1024.0);
  MarchOptions options{.points = {"tip", "end"}, .estimate_error = false};
  options.start.displacement = {2e-4, 2e-5, 0.0};
  const MarchResult decay = march(structure, loads, options);
  CsvWriter writer;
  writer.add_numbers("time", kTime, decay.time);
  writer.add_numbers("acc1", kAcceleration, decay.points[0].acceleration);
  writer.add_numbers("acc2", kAcceleration, decay.points[1].acceleration);
  return writer.str();
}

/// A table with more columns at its end, of as many rows.
std::string beside(const std::string& table,
                   const std::vector<std::pair<std::string, std::vector<double>>>& columns) {
  std::istringstream lines(table);
  std::string result;
  std::string line;
  std::getline(lines, line);
  for (const auto& column : columns) line += "," + column.first;
  result = line + "\n";
  for (std::size_t row = 0; std::getline(lines, line); ++row) {
    for (const auto& column : columns) line += fmt::format(",{:.12g}", column.second.at(row));
    result += line + "\n";
  }
  return result;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

/// Levels of two joints with all that may be measured beside: of the true vibration.
std::string sensed_levels(const std::string& levels, const std::string& true_levels) {
  const CsvTable truth(true_levels, "truth.csv");
  const std::vector<double> amplitude = truth.numbers("amplitude_joint1", kLength);
  const std::vector<double> loss = truth.numbers("dissipation_joint2", kEnergy);
  return beside(levels,
                {{"displacement_std [m]", scaled(truth.numbers("displacement", kLength), 0.002)},
                 {"frequency_std [Hz]", scaled(truth.numbers("frequency", kFrequency), 1e-4)},
                 {"amplitude_joint1 [m]", amplitude},
                 {"amplitude_joint1_std [m]", scaled(amplitude, 0.002)},
                 {"dissipation_joint2 [J]", loss},
                 {"dissipation_joint2_std [J]", scaled(loss, 0.02)}});
}

/// Levels by damping ratios, as a calibration of them has them: those that it found.
std::string damped_levels(const std::string& levels, const std::string& calibration) {
  const CsvTable table(calibration, "calibration.csv");
  const std::vector<double> found = table.numbers("level", kDimensionless);
  const std::vector<double> ratio = table.numbers("damping_ratio", kDimensionless);
  std::istringstream lines(
      edited(edited(levels, "dissipation removed"), "dissipation_std removed"));
  std::string kept;
  int level = 0;
  for (std::string line; std::getline(lines, line); ++level) {
    if (level == 0 || std::ranges::count(found, level) > 0) kept += line + "\n";
  }
  return beside(kept,
                {{"damping_ratio [1]", ratio}, {"damping_ratio_std [1]", scaled(ratio, 0.002)}});
}

/// Accelerances of a chain to a force at its second mass, with these labels of units.
std::string tested_responses(const std::array<std::string, 3>& units, const std::string& force) {
  const std::vector<double> hertz = test::even_frequencies(5.0, 0.25, 280);
  const Eigen::MatrixXcd values = test::TestedChain{}.responses(hertz, 1, 2);
  std::string text;
  for (Eigen::Index j = 0; j < values.cols(); ++j) {
    text += test::response_dataset(
        {.response = j + 1, .reference = 2, .units = units, .force_unit = force}, hertz,
        values.col(j));
  }
  return text;
}

/// A campaign of one table of levels.
std::string campaign_of(const std::string& levels) {
  return fmt::format(R"(schema = "microslip.campaign/1"
structure = "beam.toml"
[identification]
stiffness_N_per_m = 1.7e5
atom = false
inner_reversals = "leave-out"
[[test]]
name = "only"
file = "{}"
use = "identify"
)",
                     levels);
}

/// A recording without its times.
std::string without_first_column(const std::string& table) {
  return std::regex_replace(table, std::regex("(^|\n)[^#,\n][^,\n]*,"), "$1");
}

/// The decay and the loops that kinds.toml names, as its document makes them: by the model of the
/// campaign, whose folder stays; and that campaign with other files and kinds.
void add_kinds(Files& all) {
  const Files found = run(all, words("campaign campaign.toml --out campaigned --quiet")).files;
  for (const auto& [name, content] : found) {
    if (name.starts_with("campaigned/")) all[name] = content;
  }
  const Files model = {{"campaigned/model.toml", found.at("campaigned/model.toml")},
                       {"campaigned/joint.json", found.at("campaigned/joint.json")}};
  const std::string marched =
      run(model, words("march campaigned/model.toml --release 1:250um --duration 2s "
                       "--sampling-rate 2048Hz --no-error-estimate --out march.csv --quiet"))
          .files.at("march.csv");
  // The last row is off the raster.
  all["decaying.csv"] = marched.substr(0, marched.rfind('\n', marched.size() - 2) + 1);
  all["loops.csv"] =
      edited(edited(all["decaying.csv"], "contact displacement -> u"), "contact force -> f");
  all["bare_decaying.csv"] =
      std::regex_replace(all["decaying.csv"], std::regex(" \\[[^\\]]*\\]"), "");
  all["cut_decaying.uff"] =
      run(all, words("convert decaying.csv cut.uff --quiet")).files.at("cut.uff");
  all["cut_decaying.uff"].resize(all["cut_decaying.uff"].size() * 7 / 8);
  all["untimed_decaying.csv"] = without_first_column(all["decaying.csv"]);
  const std::string kinds = all.at("kinds.toml");
  all["bare_kinds.toml"] = edited(kinds, "decaying.csv -> bare_decaying.csv");
  all["cut_kinds.toml"] = edited(kinds, "decaying.csv -> cut_decaying.uff");
  all["untimed_kinds.toml"] = edited(kinds, "decaying.csv -> untimed_decaying.csv");
  all["second_mode.toml"] = edited(kinds, "use = \"both\" -> use = \"predict\"");
  all["swept_kind.toml"] =
      edited(all.at("campaign.toml"), "use = \"predict\" -> use = \"predict\"\nkind = \"sweep\"");
}

/// Fewer draws and tests than the documents show: what a row compares is there with few, too.
void take_few(Files& all) {
  const auto take = [&all](const char* name, const char* edit) {
    all[name] = edited(all.at(name), edit);
  };
  take("predict.toml", "draws = 40 -> draws = 10");
  take("design.toml", "count = 20 -> count = 4");
  take("bootstrap.toml", "count = 40 -> count = 10");
  take("campaign.toml", "draws = 100 -> draws = 40");
}

/// Eight levels, of two modes: the fewest from which two joints are found.
std::string eight_levels(const std::string& table) {
  std::istringstream lines(table);
  std::string result;
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line); ++number) {
    if (number == 0 || (number % 6 == 4 && !line.starts_with("3,"))) result += line + "\n";
  }
  return result;
}

/// The example of two joints, measured on three days, and what a campaign of it says otherwise.
void add_days(Files& all) {
  const std::string folder = MICROSLIP_EXAMPLES "/two_joints/";
  all["unknown.toml"] = test::get(folder + "unknown.toml");
  std::istringstream levels(test::get(folder + "levels.csv"));
  const std::array<std::string, 3> names{"first_day.csv", "second_day.csv", "third_day.csv"};
  std::size_t row = 0;
  for (std::string line; std::getline(levels, line);) {
    if (line.starts_with("#")) continue;
    if (line.starts_with("mode")) {
      for (const std::string& name : names) all[name] = line + "\n";
    } else {
      if (row % 2 == 0) all[names.at(row / 2 % names.size())] += line + "\n";
      ++row;
    }
  }
  all["absolute_joints.toml"] = edited(edited(all.at("joints.toml"), "\"change\" -> \"absolute\""),
                                       "session_offsets = true -> session_offsets = false");
}

Files made_inputs() {
  Files all = documented_files();
  take_few(all);
  all["full_levels.csv"] = full_levels();
  all["assembled_levels.csv"] = assembled_levels();
  for (const char* name : {"first.csv", "second.csv", "third.csv"}) {
    all[name] = all.at("full_levels.csv");
  }
  all["watched/levels.csv"] = full_levels();
  // Too few to plan the next level, which takes longest.
  all["early/levels.csv"] = first_lines(full_levels(), 7);
  all["driven_levels.csv"] = heard_levels({"frequency"});
  all["heard_levels.csv"] = heard_levels({"frequency", "resonance_frequency"});
  all["decay.csv"] = sample_decay_text();
  const JointedStructure slipping = slipping_structure(all.at("structure.toml"));
  all["steady.csv"] = steady_record(slipping);
  all["blow.csv"] = free_decay(slipping);
  add_days(all);
  const std::string two_joints = MICROSLIP_TEST_DATA "/two_joints/";
  all["two_joints.toml"] = test::get(two_joints + "model.toml");
  all["two_joints.csv"] = eight_levels(test::get(two_joints + "modal_levels.csv"));
  all["sensed_joints.csv"] =
      sensed_levels(all.at("two_joints.csv"), eight_levels(test::get(two_joints + "truth.csv")));
  const Files found = run(all, words("calibrate two_joints.toml two_joints.csv --samples 100 "
                                     "--out c --quiet"))
                          .files;
  all["damped_joints.csv"] = damped_levels(all.at("two_joints.csv"), found.at("c/calibration.csv"));
  all["frf.uff"] = tested_responses({"m", "m/s", "m/s^2"}, "N");
  all["responses.csv"] =
      run({{"frf.uff", all.at("frf.uff")}}, {"convert", "frf.uff", "responses.csv"})
          .files.at("responses.csv");
  all["bare.uff"] = tested_responses({"", "", ""}, "");
  all["bare.toml"] = edited(all.at("tested.toml"), "frf.uff -> bare.uff");
  all["noise.csv"] = "time [s], nothing [V]\n0,1\n1,2\n2,3\n";
  all["shock.csv"] = "time [s],acceleration of table [m/s^2]\n0,0\n0.005,20\n0.01,0\n0.1,0\n";
  all["shaken.csv"] = "time [s],jolt [m/s^2]\n0,0\n0.005,20\n0.01,0\n0.1,0\n";
  all["other_force.csv"] = "time [s],force [N]\n0,0\n0.01,50\n0.02,0\n";
  all["damped.json"] = edited(all.at("joint.json"), std::string("]\n}") + " -> " + kIdentification);
  all["damped_rig.toml"] = edited(all.at("rig.toml"), "joint.json -> damped.json");
  all["damped_model.toml"] = edited(edited(all.at("model.toml"), "four.json -> damped.json"),
                                    "linear_damping_J_per_m2 -> # J/m2");
  all["joint400.json"] = edited(all.at("joint.json"), "1.7e5 -> 4e5");
  all["modes400.toml"] = edited(all.at("modes.toml"), "5.08e5 -> 4e5");
  all["atom_levels.csv"] = atom_levels();
  all["atom_plan.toml"] =
      edited(edited(all.at("bootstrap.toml"), "\"levels.csv\" -> \"atom_levels.csv\""),
             "linear_damping = true -> linear_damping = false");
  all["atom_campaign.toml"] = campaign_of("atom_levels.csv");
  all["reversing_campaign.toml"] = campaign_of("full_levels.csv");
  add_kinds(all);
  all["failing.toml"] = edited(all.at("sweep.toml"), "from = 4e5 -> from = -4e5");
  all["failing.toml"] = edited(all["failing.toml"], "[sweep] -> most_failed = 1.0\n[sweep]");
  all["beats.csv"] = two_modes(all.at("decay.csv"));
  all["two.csv"] = two_channels(all.at("decay.csv"));
  Files made = run(all, words("measure rig.toml --out test --quiet")).files;
  for (const char* name : {"level_01.csv", "level_02.csv"}) {
    all[name] = made.at(std::string("test/") + name);
  }
  all["unitless.csv"] = std::regex_replace(all["level_01.csv"], std::regex(" \\[[^\\]]*\\]"), "");
  Files written = run(all, words("convert level_01.csv level.uff --format uff --quiet")).files;
  all["cut.uff"] = written.at("level.uff").substr(0, written.at("level.uff").size() * 7 / 8);
  all["several.uff"] = written.at("level.uff");
  written = run(all, words("convert level_02.csv level.uff --format uff --quiet")).files;
  all["several.uff"] += written.at("level.uff");
  written = run(all, words("convert decay.csv decay.uff --format uff --quiet")).files;
  all["cut_decay.uff"] = written.at("decay.uff").substr(0, written.at("decay.uff").size() * 7 / 8);
  all["unitless_decay.csv"] =
      std::regex_replace(all["decay.csv"], std::regex(" \\[[^\\]]*\\]"), "");
  all["untimed.csv"] = without_first_column(all["level_01.csv"]);
  all["untimed_decay.csv"] = without_first_column(all["decay.csv"]);
  all["record.csv"] = record_text(sample_record());
  all["untimed_record.csv"] = without_first_column(all["record.csv"]);
  all["two_records.csv"] = two_records();
  all["drifting_record.csv"] = drifting_record();
  all["unitless_record.csv"] = record_text(sample_record(), "time [s],u,f");
  all["cut_record.csv"] = all.at("record.csv").substr(0, all.at("record.csv").rfind(','));
  all["other_record.csv"] = record_text(sample_record(2));
  written = run(all, words("identify record.csv other_record.csv --samples 100 --out "
                           "identified_record.json --quiet"))
                .files;
  all["identified_record.json"] = written.at("identified_record.json");
  all["lab/joint.json"] = written.at("identified_record.json");
  written =
      run(all, words("frf model.toml --force 50 --frequency 10:20 --out frf.csv --quiet")).files;
  all["frf.csv"] = written.at("frf.csv");
  written = run(all, words("march model.toml --release 1:1mm --duration 4 --sampling-rate 1024 "
                           "--out released.csv --quiet"))
                .files;
  all["released.csv"] = written.at("released.csv");
  all["two_modes.csv"] =
      "mode [1],displacement [m],displacement_std [m],frequency [Hz],frequency_std [Hz],"
      "damping_ratio [1],damping_ratio_std [1],dissipation [J],dissipation_std [J]\n"
      "1,5e-4,1e-6,15.5,0.01,0.004,0.0001,0.01,0.0001\n1,1e-3,1e-6,15,0.01,0.01,0.0001,0.02,"
      "0.0001\n2,5e-4,1e-6,27,0.01,0.004,0.0001,0.01,0.0001\n";
  all["two_laps.toml"] = two_laps();
  written = run(all, words("identify levels.csv --stiffness 1.7e5 --out identified.json "
                           "--density-csv density.csv --samples 100 --samples-out "
                           "joint_samples.h5 --quiet"))
                .files;
  all["joint_samples.h5"] = written.at("joint_samples.h5");
  all["identified.json"] = written.at("identified.json");
  for (const char* call :
       {"frf drawn_model.toml --force 50 --frequency 10:20 --draws 40 --out drawn_frf.csv",
        "backbone drawn_model.toml --response 0.1mm:1mm:5 --draws 40 --out drawn_backbone.csv",
        "march drawn_model.toml --force-file other_force.csv --draws 40 --out drawn_march.csv",
        "dissipation identified.json --amplitude 1um:300um:5 --draws 40 --samples "
        "joint_samples.h5 --out drawn_curve.csv",
        "loop identified.json --amplitude 100um --points 10 --draws 40 --samples "
        "joint_samples.h5 --out drawn_loop.csv"}) {
    const std::string text(call);
    const std::string name = text.substr(text.rfind(' ') + 1);
    all[name] = run(all, words(text + " --quiet")).files.at(name);
    all["curves/" + name.substr(name.find('_') + 1)] = all.at(name);
  }
  all["curves/levels.csv"] = all.at("levels.csv");
  for (const char* name : {"levels.csv", "joint.json", "level_01.csv", "level_02.csv"}) {
    all[std::string("folder/") + name] = all.at(name);
  }
  all["folder/rig.toml"] = made.at("test/rig.toml");
  all["compared/comparison.csv"] =
      run(all, words("verify drawn_model.toml frf.csv --draws 40 --out comparison.csv --quiet"))
          .files.at("comparison.csv");
  Files whole = all;  // without leaving out, which takes longest and counts for nothing here
  whole["joints.toml"] = edited(all.at("joints.toml"), "\"tests\" -> \"none\"");
  written = run(whole, words("campaign joints.toml --out jointed --quiet")).files;
  for (const auto& [name, content] : written) {
    if (name.starts_with("jointed/")) all[name] = content;
  }
  return all;
}

/// The folder that ctest keeps them in, as EffectInputs made them, for the processes of all
/// subjects; empty where a subject is run by hand.
std::string kept_inputs() {
  const char* folder = std::getenv("MICROSLIP_EFFECT_INPUTS");
  return folder != nullptr ? folder : "";
}

Files files_below(const std::string& folder) {
  Files result;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    result[entry.path().lexically_relative(folder)] = test::get(entry.path());
  }
  return result;
}

const Files& inputs() {
  static const Files files = kept_inputs().empty() ? made_inputs() : files_below(kept_inputs());
  return files;
}

/// Each call once.
const Run& base_run(const std::string& arguments) {
  static std::map<std::string, Run> runs;
  const auto known = runs.find(arguments);
  if (known != runs.end()) return known->second;
  return runs.emplace(arguments, run(inputs(), words(arguments))).first->second;
}

std::string output(const Run& run, const std::string& name, const std::string& part) {
  if (name == "out") return content_of(run.outcome.out, part);
  if (name == "err") return run.outcome.err;
  if (name == "status") return fmt::format("{}", run.outcome.status);
  const auto file = run.files.find(name);
  return file == run.files.end() ? "" : content_of(file->second, part);
}

/// `FILE`, `FILE:PART`, …: what must differ, or with `=` before it must not.
void expect_effect(const std::string& effect, const Run& base, const Run& changed) {
  if (effect.starts_with("refused:")) {
    EXPECT_EQ(changed.outcome.status, 2);
    EXPECT_NE(changed.outcome.err.find(trimmed(effect.substr(8))), std::string::npos)
        << changed.outcome.err;
    return;
  }
  EXPECT_TRUE(changed.outcome.status == 0 || changed.outcome.status == 3) << changed.outcome.err;
  if (effect.starts_with("+")) {
    EXPECT_FALSE(base.files.contains(effect.substr(1)));
    EXPECT_TRUE(changed.files.contains(effect.substr(1)));
    return;
  }
  const bool same = effect.starts_with("=");
  const std::string place = effect.substr(same ? 1 : 0);
  const std::string name = place.substr(0, place.find(':'));
  const std::string part = name == place ? "" : place.substr(name.size() + 1);
  const std::string before = output(base, name, part);
  const std::string after = output(changed, name, part);
  if (same) {
    EXPECT_EQ(after, before);
    EXPECT_FALSE(after.empty());
  } else {
    EXPECT_NE(after, before);
  }
}

/// The call with the change: more arguments, others, or an edited file.
Run changed_run(const EffectRow& row) {
  constexpr std::string_view kInstead = "instead:";
  if (row.change.starts_with(kInstead))
    return run(inputs(), words(row.change.substr(kInstead.size())));
  const std::size_t colon = row.change.find(": ");
  const auto file =
      colon == std::string::npos ? inputs().end() : inputs().find(row.change.substr(0, colon));
  if (file == inputs().end()) return run(inputs(), words(row.base + " " + row.change));
  Files edited_inputs = inputs();
  edited_inputs[file->first] = edited(file->second, row.change.substr(colon + 2));
  return run(edited_inputs, words(row.base));
}

/// Whether the call takes a second or more, as finding two joints or planning a level does.
bool is_slow(const EffectRow& row) {
  return std::ranges::any_of(
      std::array{"calibrate ", "campaign ", "watch ", "plan full_levels.csv",
                 "ensemble predict.toml", "ensemble bootstrap.toml", "ensemble atom_plan.toml",
                 "identify record.csv", "identify assembled_levels.csv --assemblies column",
                 "identify first.csv", "verify drawn_model.toml",
                 "verify rig.toml identified.json level_01.csv level_02.csv --draws"},
      [&](const char* call) { return row.base.starts_with(call); });
}

bool is_refusal(const EffectRow& row) { return row.effects.front().starts_with("refused:"); }

/// Whether a slow call is refused with the change: at once, so that the call as it stands, which
/// another row compares, is left to the studies.
bool is_refused_alone(const EffectRow& row) {
  return is_slow(row) && is_refusal(row) && !test::in_studies();
}

void expect_row(const EffectRow& row) {
  if (row.effects.front().starts_with("elsewhere:")) return;
  const Run changed = changed_run(row);
  const Run& base = is_refused_alone(row) ? changed : base_run(row.base);
  const bool is_judged =
      !is_refused_alone(row) && std::ranges::count(row.effects, "status") == 0;  // refusal lifted
  EXPECT_TRUE(!is_judged || base.outcome.status == 0 || base.outcome.status == 3)
      << base.outcome.err;
  for (const std::string& effect : row.effects) {
    SCOPED_TRACE(effect);
    expect_effect(effect, base, changed);
  }
}

std::set<std::string> subjects() {
  std::set<std::string> result;
  for (const EffectRow& row : effect_rows()) {
    if (can_run(row)) result.insert(row.subject);
  }
  return result;
}

// Made once for all subjects, each of which is a process of its own.
TEST(EffectInputs, AreMade) {
  const Files made = made_inputs();
  EXPECT_EQ(made.count("campaigned/model.toml"), 1U);
  if (kept_inputs().empty()) return;
  std::filesystem::remove_all(kept_inputs());
  put_all(kept_inputs(), made);
  EXPECT_EQ(files_below(kept_inputs()), made);
}

class Effects : public ::testing::TestWithParam<std::string> {};

// Of the rows of slow calls every sixth and all refusals, but in the studies: rows of a subject run
// much the same code. Under the sanitizers every third row: what is compared is that of the release
// build.
TEST_P(Effects, AreThere) {
  std::size_t number = 0;
  std::size_t slow = 0;
  for (const EffectRow& row : effect_rows()) {
    if (row.subject != GetParam() || !can_run(row)) continue;
    SCOPED_TRACE(fmt::format("effects.txt:{}: {} {}", row.line, row.subject, row.item));
    ASSERT_FALSE(row.effects.empty()) << "a row has 5 cells";
    const bool few = is_slow(row) && !is_refusal(row) && !test::in_studies();
    if (test::kSanitized ? number++ % 3 != 0 : few && slow++ % 6 != 0) continue;
    expect_row(row);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Effects, ::testing::ValuesIn(subjects()), [](const auto& subject) {
  std::string name = subject.param;
  std::ranges::replace_if(
      name, [](char c) { return c == '.' || c == '-'; }, '_');
  return name;
});

bool has_row(const std::string& subject, const std::string& item) {
  static const std::vector<EffectRow> rows = effect_rows();
  return std::ranges::any_of(
      rows, [&](const EffectRow& r) { return r.subject == subject && r.item == item; });
}

TEST(EffectsTable, HasEveryOption) {
  app::Call call;
  const std::unique_ptr<CLI::App> program = app::make_program(call);
  std::set<std::pair<std::string, std::string>> there;
  for (const app::CommandDescription& command : app::describe(*program, "1").commands) {
    for (const app::ArgumentDescription& option : command.options) {
      const std::string& name = option.names.back();
      if (name == "--help") continue;  // presentation alone: help_test.cpp
      there.insert({subcommand_name(command), name});
      EXPECT_TRUE(has_row(subcommand_name(command), name))
          << subcommand_name(command) << " " << name << kAddRow;
    }
  }
  for (const EffectRow& row : effect_rows()) {
    if (!row.item.starts_with("--") || !can_run(row)) continue;
    EXPECT_TRUE(there.contains({row.subject, row.item}))
        << "effects.txt:" << row.line << ": there is no " << row.subject << " " << row.item;
  }
}

TEST(EffectsTable, HasEveryKeyOfTheDocumentedFiles) {
  const std::map<std::string, std::string> files = documented_files();
  for (const char* name :
       {"rig.toml", "modes.toml", "structure.toml", "frame.toml", "tested.toml", "channels.toml",
        "shapes.toml", "model.toml", "joint.json", "four.json", "about.toml"}) {
    for (const std::string& key : keys_in(files.at(name))) {
      EXPECT_TRUE(has_row(name, key)) << name << " " << key << kAddRow;
    }
  }
  for (const char* name :
       {"predict.toml", "bootstrap.toml", "design.toml", "rig_design.toml", "sweep.toml"}) {
    for (const std::string& key : keys_in(files.at(name))) {
      EXPECT_TRUE(has_row("plan.toml", key)) << name << " " << key << kAddRow;
    }
  }
  for (const char* name : {"campaign.toml", "kinds.toml"}) {
    for (const std::string& key : keys_in(files.at(name))) {
      EXPECT_TRUE(has_row("campaign.toml", key)) << name << " " << key << kAddRow;
    }
  }
  for (const std::string& key : keys_in(files.at("drawn_model.toml"))) {
    EXPECT_TRUE(has_row("model.toml", key)) << "drawn_model.toml " << key << kAddRow;
  }
}

TEST(EffectsTable, HasEveryKeyOfAnIdentificationThatIsUsed) {
  for (const std::string& key : keys_in(std::string(kIdentification).substr(20))) {
    EXPECT_TRUE(has_row("identification", key)) << key << kAddRow;
  }
}

TEST(EffectsTable, HasEveryColumnThatIsRead) {
  const std::map<std::string, std::string> sections{{"levels.csv", "## levels.csv"},
                                                    {"force.csv", "## force.csv"}};
  for (const auto& [file, section] : sections) {
    const std::vector<std::string> columns = documented_columns(section);
    EXPECT_GE(columns.size(), 2U) << section;
    for (const std::string& column : columns) {
      EXPECT_TRUE(has_row(file, column)) << file << " " << column << kAddRow;
    }
  }
}

}  // namespace
}  // namespace microslip::cli_test::effects_test
