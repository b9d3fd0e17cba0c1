// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "command.hpp"
#include "identification_report.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/version.hpp"
#include "microslip/identify/identification.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/input_file.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/io/levels_file.hpp"
#include "microslip/io/output_files.hpp"
#include "microslip/io/sha256.hpp"
#include "microslip/io/text.hpp"
#include "microslip/workflow/quantity_text.hpp"
#include "microslip/workflow/recorded_options.hpp"
#include "microslip/workflow/smoothing_text.hpp"
#include "progress_bar.hpp"

namespace microslip::app {
namespace {

struct IdentifyOptions {
  std::string levels;
  std::string stiffness;
  std::string out;
  std::string density_csv;
  std::string method = "inversion";
  std::string smoothing = "gcv";
  std::optional<std::string> smoothing_unit;
  std::string linear_damping = "none";
  bool atom = false;
  std::string bands = "0";
  std::optional<std::string> seed;
  std::string dissipation_gain = "0";
  std::string amplitude_gain = "0";
  std::string loss_factor = "0";
  std::string fit = "none";
  std::string inner_reversals = "leave-out";
};

const std::map<std::string, IdentificationMethod> kMethods{
    {"inversion", IdentificationMethod::kInversion},
    {"spline", IdentificationMethod::kSpline},
    {"differences", IdentificationMethod::kDifferences}};

const std::map<std::string, ParametricModel> kModels{
    {"four_parameter", ParametricModel::kFourParameter},
    {"power_law", ParametricModel::kPowerLaw},
    {"uniform", ParametricModel::kUniform}};

template <typename Map>
std::vector<std::string> names_of(const Map& map) {
  std::vector<std::string> names;
  for (const auto& [name, value] : map) names.push_back(name);
  return names;
}

// Far beyond every joint, see check_sizes().
constexpr double kSmallestStiffness = 1e-6;  // N/m
constexpr double kLargestStiffness = 1e15;

double stiffness_of(const IdentifyOptions& options) {
  const double k = parse_quantity("--stiffness", options.stiffness, kStiffness);
  if (k > 0.0 && !(k >= kSmallestStiffness && k <= kLargestStiffness)) {
    throw InputError("--stiffness", k, "must be from 1e-6 to 1e15 N/m", "Check its unit.");
  }
  if (!(k > 0.0)) {
    throw InputError("--stiffness", k, "must be above 0 N/m",
                     "Give the stiffness of the stuck joint, for instance from a low-level test.");
  }
  return k;
}

/// A standard deviation of a gain or of the loss factor, as a share of it.
double relative_std(std::string_view option, const std::string& text) {
  constexpr double kLargest = 0.3;
  const double gain = parse_quantity(option, text, kDimensionless);
  if (!(gain >= 0.0 && gain < kLargest)) {
    throw InputError(option, in_quotes(text), "must be 0 or more and below 0.3, as a share of 1");
  }
  return gain;
}

/// What only a band shows is refused without one, not ignored.
void check_unused(const IdentifyOptions& options, const CommonErrors& errors) {
  const auto refuse = [](std::string_view option, const std::string& text) {
    throw InputError(option, in_quotes(text), "belongs to a band, and --bands is 0",
                     "Ask for samples, for instance --bands 1000, or leave it out.");
  };
  if (options.seed) refuse("--seed", *options.seed);
  if (errors.dissipation_gain_std > 0.0) refuse("--dissipation-gain-std", options.dissipation_gain);
  if (errors.amplitude_gain_std > 0.0) refuse("--amplitude-gain-std", options.amplitude_gain);
  if (errors.loss_factor_std > 0.0) refuse("--loss-factor-std", options.loss_factor);
}

CommonErrors errors_of(const IdentifyOptions& options) {
  return {.dissipation_gain_std = relative_std("--dissipation-gain-std", options.dissipation_gain),
          .amplitude_gain_std = relative_std("--amplitude-gain-std", options.amplitude_gain),
          .loss_factor_std = relative_std("--loss-factor-std", options.loss_factor)};
}

/// What belongs to the band of the free density; nothing where none was asked for.
std::optional<BandOptions> bands_of(const IdentifyOptions& options, bool quiet) {
  constexpr std::uint64_t kFewest = 20;
  constexpr std::uint64_t kMost = 1'000'000;  // more memory than use
  BandOptions bands;
  bands.seed = parse_whole_number("--seed", options.seed.value_or("1"), 0,
                                  std::numeric_limits<std::uint64_t>::max());
  if (options.bands == "0") return std::nullopt;
  bands.samples = parse_whole_number("--bands", options.bands, kFewest, kMost,
                                     "1000 give a smooth band, 0 gives none.");
  bands.progress = progress_bar("bands", quiet);
  return bands;
}

/// What only the inversion can do is refused elsewhere, not ignored.
void check_method(const IdentifyOptions& options) {
  const bool fit = options.fit != "none";
  const auto refuse = [&](std::string_view option) {
    const bool by_fit = options.method == "inversion";
    throw InputError(by_fit ? "--fit" : "--method",
                     in_quotes(by_fit ? options.fit : options.method),
                     fmt::format("does not go with {}, which belongs to the free density of "
                                 "--method inversion",
                                 option),
                     "Leave one of them out.");
  };
  if (options.method == "inversion" && !fit) return;
  if (options.atom) refuse("--atom");
  if (options.bands != "0") refuse("--bands");
  if (options.linear_damping == "fit" && !fit) refuse("--linear-damping fit");
}

IdentificationOptions library_options(const IdentifyOptions& options, bool quiet) {
  IdentificationOptions all;
  all.bands = bands_of(options, quiet);
  check_method(options);
  all.method = kMethods.at(options.method);
  all.inversion.linear_damping = options.linear_damping == "fit";
  all.inversion.atom = options.atom;
  if (options.fit != "none") all.fit = kModels.at(options.fit);
  set_smoothing(options.smoothing, options.smoothing_unit, all);
  return all;
}

/// Values of a column from the first to the second limit; 0 too where that has a meaning.
struct Sizes {
  double from;
  double to;
  bool or_zero = true;
};

void check_size(const LevelsFile& file, const std::vector<double>& values, std::string_view name,
                const Sizes& sizes, const Dimension& dimension) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] >= sizes.from && values[i] <= sizes.to) continue;
    if (values[i] == 0.0 && sizes.or_zero) continue;
    throw FormatError({.file = file.file, .line = file.line[i], .column = 0},
                      fmt::format("{} {}from {:g} to {:g} {}", name, sizes.or_zero ? "0 or " : "",
                                  sizes.from, sizes.to, si_unit(dimension)),
                      fmt::format("{:g}", values[i]),
                      "Check the value and the unit of the column.");
  }
}

/// Far beyond every joint something else was measured or labelled, and products of such numbers
/// leave the range of doubles.
void check_sizes(const LevelsFile& file) {
  constexpr Sizes kEnergies{1e-30, 1e12};
  constexpr Sizes kDeviations{1e-24, 1e6};
  constexpr Sizes kStiffnesses{kSmallestStiffness, kLargestStiffness, false};
  const Levels& levels = file.levels;
  check_size(file, levels.amplitude, "amplitude", {1e-15, 1e6, false}, kLength);
  check_size(file, levels.amplitude_std, "amplitude_std", kDeviations, kLength);
  check_size(file, levels.dissipation, "dissipation", kEnergies, kEnergy);
  check_size(file, levels.dissipation_std, "dissipation_std", kEnergies, kEnergy);
  check_size(file, levels.linear_dissipation, "linear_dissipation", kEnergies, kEnergy);
  check_size(file, levels.secant_stiffness, "secant_stiffness", kStiffnesses, kStiffness);
  check_size(file, levels.secant_stiffness_std, "secant_stiffness_std",
             {kSmallestStiffness, kLargestStiffness}, kStiffness);
}

/// D of a level whose joint turns more than twice a cycle is not that of [AR14 (7)].
LevelsFile usable_levels(LevelsFile file, const IdentifyOptions& options) {
  if (options.inner_reversals == "use") return file;
  LevelsFile usable = without_inner_reversals(file);
  if (usable.levels.size() > 0) return usable;
  throw FormatError({.file = file.file, .line = file.line.front(), .column = 0},
                    "a level with 2 reversals a cycle",
                    fmt::format("inner reversals in all {}", file.levels.size()),
                    "--inner-reversals use takes them all the same.");
}

/// What was left out, for the summary; empty if nothing.
std::string describe_left_out(const LevelsFile& file, const IdentifyOptions& options) {
  const std::vector<std::size_t> lines = file.lines_with_inner_reversals();
  if (lines.empty()) return {};
  const bool used = options.inner_reversals == "use";
  return fmt::format("  {:<20} {} level{} (line{} {}){}\n", "inner reversals", lines.size(),
                     lines.size() == 1 ? "" : "s", lines.size() == 1 ? "" : "s",
                     fmt::join(lines, ", "),
                     used ? ", used all the same" : ", left out; --inner-reversals use takes them");
}

/// The same for the files.
void add_left_out(const LevelsFile& file, const IdentifyOptions& options,
                  std::vector<Warning>& warnings) {
  const std::vector<std::size_t> lines = file.lines_with_inner_reversals();
  if (lines.empty()) return;
  const bool used = options.inner_reversals == "use";
  warnings.push_back(
      {used ? "inner_reversals_used" : "levels_left_out",
       fmt::format("{} of {} levels ({} {} of {}) have inner reversals; they were {}.",
                   lines.size(), file.levels.size(), lines.size() == 1 ? "line" : "lines",
                   fmt::join(lines, ", "), printable(file.file),
                   used ? "used all the same" : "left out")});
}

/// Flags that the levels used carry.
void add_levels_flags(const LevelsFile& file, std::vector<Warning>& warnings) {
  std::map<std::string, std::size_t> levels_with;
  for (const std::string& flags : file.flags) {
    std::istringstream words(flags);
    std::set<std::string> of_level;
    for (std::string flag; words >> flag;) of_level.insert(flag);
    for (const std::string& flag : of_level) ++levels_with[flag];
  }
  std::string text;
  for (const auto& [flag, count] : levels_with) {
    text += fmt::format("{}{} ({} of {})", text.empty() ? "" : ", ", printable(flag), count,
                        file.levels.size());
  }
  if (text.empty()) return;
  warnings.push_back(
      {"levels_flagged", "levels carry flags: " + text +
                             "; the summary of the command that wrote them says what they mean."});
}

/// The options were checked before: what is left to complain of are the levels.
Identification identify_file(const LevelsFile& file, const CommonErrors& errors, double stiffness,
                             const IdentificationOptions& options) {
  check_sizes(file);
  try {
    return identify(LevelEvidence(file.levels, errors), stiffness, options);
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", file.file, error.name()));
  }
}

int run(const IdentifyOptions& options, const Call& call) {
  check_output(options.out, kJointKind);
  if (!options.density_csv.empty()) check_output(options.density_csv, kDensityKind);
  const CommonErrors errors = errors_of(options);
  if (options.bands == "0") check_unused(options, errors);
  const IdentificationOptions library = library_options(options, call.quiet);
  const double stiffness = stiffness_of(options);
  const std::string text = read_file(options.levels);
  const LevelsFile all = parse_levels(text, input_name(options.levels),
                                      {.linear_dissipation = errors.loss_factor_std > 0.0});
  const LevelsFile file = usable_levels(all, options);
  Identification found = identify_file(file, errors, stiffness, library);
  add_levels_flags(file, found.warnings);
  const std::string summary =
      describe_identification(found, file.levels.size()) + describe_left_out(all, options);
  add_left_out(all, options, found.warnings);  // for the files: the summary has a line of its own

  Provenance provenance;
  provenance.version = kVersion;
  provenance.command = call.command_line;
  provenance.inputs.push_back({options.levels, sha256(text)});
  provenance.options = record_of_options(
      library, {options.smoothing, options.smoothing_unit, options.inner_reversals, errors});
  if (library.bands) provenance.seed = library.bands->seed;
  OutputFiles outputs;
  outputs.add(options.out, format_joint({found.joint, provenance, record_of(found)}));
  if (!options.density_csv.empty()) {
    outputs.add(options.density_csv, density_csv(found));
  }
  outputs.commit();
  if (!call.quiet) {
    const bool data_on_stdout = options.out == "-" || options.density_csv == "-";
    fmt::print(data_on_stdout ? stderr : stdout, "{}", summary);
  }
  return found.summary.converged() ? kDone : kNotConverged;
}

void add_output_options(CLI::App& command, IdentifyOptions& options) {
  command
      .add_option("--out", options.out, "Joint model to write, joint.json; - is standard output")
      ->required()
      ->type_name(kJsonValue);
  command
      .add_option("--density-csv", options.density_csv,
                  "Density as CSV: slip_force [N], density [1/N], lower [1/N], upper [1/N]")
      ->type_name(kCsvValue);
}

void add_method_options(CLI::App& command, IdentifyOptions& options) {
  command.add_option("--method", options.method, "How the density is found")
      ->check(CLI::IsMember(names_of(kMethods)))
      ->capture_default_str();
  command
      .add_option("--smoothing", options.smoothing,
                  "gcv chooses; lambda=X; p=X of csaps (spline only)")
      ->capture_default_str();
  command.add_option("--smoothing-unit", options.smoothing_unit,
                     "Unit of the amplitude that p or lambda of the spline belongs to: um, mm, m");
  command
      .add_option("--linear-damping", options.linear_damping,
                  "fit: D holds a linear damping beta*A^2 that was not subtracted")
      ->check(CLI::IsMember({"none", "fit"}))
      ->capture_default_str();
  command
      .add_option("--inner-reversals", options.inner_reversals,
                  "Levels whose joint turns more than twice a cycle (column reversals)")
      ->check(CLI::IsMember({"leave-out", "use"}))
      ->capture_default_str();
  command.add_flag("--atom", options.atom, "Seek an atom of the density where macro-slip begins");
  command
      .add_option("--fit", options.fit, "Write this parametric model in place of the free density")
      ->check(CLI::IsMember(names_of(kModels)));
}

void add_band_options(CLI::App& command, IdentifyOptions& options) {
  command
      .add_option("--bands", options.bands,
                  "Samples of the 95 % band; 0 for none, 1000 for a smooth one")
      ->type_name("UINT")
      ->capture_default_str();
  command.add_option("--seed", options.seed, "Seed of the samples; 1 without it")
      ->type_name("UINT");
  command
      .add_option("--dissipation-gain-std", options.dissipation_gain,
                  "Relative gain error of D that all levels share, for the band [1]; also in %")
      ->needs("--bands")
      ->type_name("FLOAT")
      ->capture_default_str();
  command
      .add_option("--amplitude-gain-std", options.amplitude_gain,
                  "Relative gain error of A that all levels share, for the band [1]; also in %")
      ->needs("--bands")
      ->type_name("FLOAT")
      ->capture_default_str();
  command
      .add_option(
          "--loss-factor-std", options.loss_factor,
          "Relative error of the structure's loss factor, and so of the linear loss that was "
          "taken from D, for the band [1]; also in %; needs the column linear_dissipation "
          "[J]")
      ->needs("--bands")
      ->type_name("FLOAT")
      ->capture_default_str();
}

}  // namespace

void add_identify(CLI::App& program, Call& call) {
  auto options = std::make_shared<IdentifyOptions>();
  CLI::App* command = program.add_subcommand(
      "identify", "Slip-force density of a joint from its measured dissipation");
  command
      ->add_option("levels", options->levels,
                   "CSV, one row a level: amplitude [m], dissipation [J]; used when there: "
                   "amplitude_std, dissipation_std, secant_stiffness [N/m], secant_stiffness_std; "
                   "resonance_frequency or frequency [Hz], which the joint is held against")
      ->required()
      ->type_name(kCsvValue);
  command
      ->add_option("--stiffness", options->stiffness,
                   "k of the stuck joint, in N/m or with a unit: slip forces are k times A")
      ->required();
  add_output_options(*command, *options);
  add_method_options(*command, *options);
  add_band_options(*command, *options);
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command, {"microslip identify levels.csv --stiffness 1.7e5 --out joint.json",
                          "microslip identify levels.csv --stiffness 1.7e5 --bands 1000 \\",
                          "          --out joint.json --density-csv density.csv",
                          "microslip identify levels.csv --stiffness 170kN/m --method spline \\",
                          "          --smoothing p=0.99999 --smoothing-unit mm --out joint.json"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
