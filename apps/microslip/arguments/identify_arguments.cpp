// SPDX-License-Identifier: MIT
#include "arguments/identify_arguments.hpp"
#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

#include "arguments/command.hpp"
#include "arguments/progress_bar.hpp"
#include "arguments/stiffness_argument.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/workflow/identify/smoothing_text.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

/// Names in the order of the help.
template <typename All>
std::vector<std::string> names_of(const All& all) {
  std::vector<std::string> names;
  for (const auto one : all) names.emplace_back(to_string(one));
  std::ranges::sort(names);
  return names;
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

/// Number of posterior draws of levels, by the current or the former name of the option.
struct DrawCount {
  std::string_view option;
  std::string text;
  [[nodiscard]] bool none() const { return text == "0"; }
};

DrawCount draws_of_levels(const IdentifyArguments& options) {
  if (!options.samples) return {"--bands", options.bands};
  if (options.bands != "0") {
    throw InputError("--bands", in_quotes(options.bands), "gives the same number as --samples",
                     "Leave one of them out.");
  }
  return {"--samples", *options.samples};
}

/// Refuses options that affect only the band where no band is requested.
void check_unused(const IdentifyArguments& options, const CommonErrors& errors) {
  const auto refuse = [](std::string_view option, const std::string& text) {
    throw InputError(option, in_quotes(text), "requires a band, and --bands is 0",
                     "Ask for samples, for instance --samples 1000, or leave it out.");
  };
  if (!options.samples_out.empty()) refuse("--samples-out", options.samples_out);
  if (options.seed) refuse("--seed", *options.seed);
  if (errors.dissipation_gain_std > 0.0) refuse("--dissipation-gain-std", options.dissipation_gain);
  if (errors.amplitude_gain_std > 0.0) refuse("--amplitude-gain-std", options.amplitude_gain);
  if (errors.loss_factor_std > 0.0) refuse("--loss-factor-std", options.loss_factor);
}

CommonErrors errors_of(const IdentifyArguments& options) {
  return {.dissipation_gain_std = relative_std("--dissipation-gain-std", options.dissipation_gain),
          .amplitude_gain_std = relative_std("--amplitude-gain-std", options.amplitude_gain),
          .loss_factor_std = relative_std("--loss-factor-std", options.loss_factor)};
}

std::uint64_t seed_of(const IdentifyArguments& options) {
  return parse_whole_number("--seed", options.seed.value_or("1"), 0,
                            std::numeric_limits<std::uint64_t>::max());
}

/// Options of the band of the free density; nothing where no band was requested.
std::optional<BandOptions> bands_of(const IdentifyArguments& options, bool quiet) {
  constexpr std::uint64_t kFewest = 20;
  constexpr std::uint64_t kMost = 1'000'000;  // more memory than use
  BandOptions bands;
  bands.seed = seed_of(options);
  const DrawCount draws = draws_of_levels(options);
  if (draws.none()) return std::nullopt;
  bands.samples = parse_whole_number(draws.option, draws.text, kFewest, kMost,
                                     "1000 give a smooth band, 0 gives none.");
  bands.progress = progress_bar("bands", quiet);
  return bands;
}

/// Refuses options that only the inversion supports with other methods.
void check_method(const IdentifyArguments& options) {
  const bool fit = options.fit != "none";
  const auto refuse = [&](std::string_view option) {
    const bool by_fit = options.method == "inversion";
    throw InputError(
        by_fit ? "--fit" : "--method", in_quotes(by_fit ? options.fit : options.method),
        fmt::format(
            "cannot be combined with {}, which requires the free density of --method inversion",
            option),
        "Leave one of them out.");
  };
  if (options.method == "inversion" && !fit) return;
  if (options.atom) refuse("--atom");
  if (const DrawCount draws = draws_of_levels(options); !draws.none()) refuse(draws.option);
  if (options.linear_damping == "fit" && !fit) refuse("--linear-damping fit");
}

IdentificationOptions library_options(const IdentifyArguments& options, bool quiet) {
  IdentificationOptions all;
  all.bands = bands_of(options, quiet);
  check_method(options);
  all.method = find_identification_method(options.method).value();
  all.inversion.linear_damping = options.linear_damping == "fit";
  all.inversion.edges = options.edges == "sought";
  all.inversion.atom = options.atom;
  all.fit = find_parametric_model(options.fit);  // nothing for none
  set_smoothing(options.smoothing, options.smoothing_unit, all);
  return all;
}

/// Refuses options of the other kind of evidence where they are given.
class Foreign {
 public:
  explicit Foreign(std::string_view rule) : rule_(rule) {}

  void refuse(std::string_view option, const std::string& value, std::string_view usual,
              std::string_view remedy = "Leave it out.") const {
    if (value != usual) throw InputError(option, in_quotes(value), rule_, remedy);
  }
  void refuse(std::string_view option, bool given,
              std::string_view remedy = "Leave it out.") const {
    if (given) throw InputError(option, InputState{"given"}, rule_, remedy);
  }

 private:
  std::string rule_;
};

void refuse_options_of_recordings(const IdentifyArguments& options) {
  const Foreign of_records("applies to records of force and displacement, and these are levels");
  of_records.refuse("--force", options.force, "");
  of_records.refuse("--displacement", options.displacement, "");
  of_records.refuse("--start", options.start, "auto");
  of_records.refuse("--viscous", options.viscous, "none",
                    "--linear-damping fit identifies a linear damping from one table of levels.");
  of_records.refuse("--drift", options.drift, "none");
  of_records.refuse("--assume-units", !options.reading.assumed_units.empty());
  of_records.refuse("--allow-truncated", options.reading.allow_truncated);
  of_records.refuse("--rate", options.reading.rate, "");
}

void refuse_options_of_levels(const IdentifyArguments& options, const EvidenceFiles& files) {
  const Foreign of_levels(files.levels.empty()
                              ? "applies to levels, and this is a record of force and displacement"
                              : "applies to a single table of levels only");
  of_levels.refuse("--method", options.method, "inversion");
  of_levels.refuse("--smoothing", options.smoothing, "gcv",
                   "The smoothing is sampled with the density.");
  of_levels.refuse("--smoothing-unit", options.smoothing_unit.has_value());
  of_levels.refuse("--linear-damping", options.linear_damping, "none",
                   "--viscous fit identifies a viscous part from a record.");
  of_levels.refuse("--atom", options.atom);
  of_levels.refuse("--edges", options.edges, "sought");
  of_levels.refuse("--bands", options.bands, "0", "Use --samples N, which applies to both.");
  of_levels.refuse("--dissipation-gain-std", options.dissipation_gain, "0");
  of_levels.refuse("--amplitude-gain-std", options.amplitude_gain, "0");
  of_levels.refuse("--loss-factor-std", options.loss_factor, "0");
  of_levels.refuse("--fit", options.fit, "none");
  if (files.levels.empty()) {
    of_levels.refuse("--inner-reversals", options.inner_reversals, "leave-out");
  }
}

/// Treatment of the column `assembly` where levels are of one joint.
AssemblyColumn assembly_column(const IdentifyArguments& options) {
  return options.assemblies ? AssemblyColumn::kIgnored : AssemblyColumn::kUnsaid;
}

std::uint64_t draws_of_posterior(const IdentifyArguments& options) {
  constexpr std::uint64_t kFewest = 100;
  constexpr std::uint64_t kMost = 100'000;  // more memory than use
  return parse_whole_number("--samples", options.samples.value_or("1000"), kFewest, kMost);
}

std::optional<PathStart> start_of(const IdentifyArguments& options) {
  if (options.start == "auto") return std::nullopt;
  return options.start == "virgin" ? PathStart::kVirgin : PathStart::kUnknown;
}

void add_output_options(CLI::App& command, IdentifyArguments& options) {
  command
      .add_option("--out", options.out,
                  "Joint model to write, joint.json; - is standard output. With --assemblies a "
                  "folder: joint.json of the mean assembly, joint_samples.h5 for the next "
                  "assembly, assembly_NAME.json of each, assemblies.csv and densities.csv")
      ->required()
      ->type_name(kJsonValue);
  command
      .add_option("--density-csv", options.density_csv,
                  "Density as CSV: slip_force [N], density [1/N], lower [1/N], upper [1/N]")
      ->type_name(kCsvValue);
}

void add_method_options(CLI::App& command, IdentifyArguments& options) {
  command.add_option("--method", options.method, "Identification method of the density")
      ->check(CLI::IsMember(names_of(kIdentificationMethods)))
      ->capture_default_str();
  command
      .add_option("--smoothing", options.smoothing,
                  "gcv (chosen by cross-validation), lambda=X, or p=X of csaps (spline only)")
      ->capture_default_str();
  command.add_option(
      "--smoothing-unit", options.smoothing_unit,
      "Unit of the amplitude for which p or lambda of the spline was chosen: um, mm, m");
  command
      .add_option("--linear-damping", options.linear_damping,
                  "fit: D contains a linear damping beta*A^2 that was not subtracted")
      ->check(CLI::IsMember({"none", "fit"}))
      ->capture_default_str();
  command
      .add_option("--inner-reversals", options.inner_reversals,
                  "Levels whose joint reverses more than twice per cycle (column reversals)")
      ->check(CLI::IsMember({"leave-out", "use"}))
      ->capture_default_str();
  command
      .add_option("--edges", options.edges,
                  "sought: jumps of the density at slip forces that the levels make very likely, "
                  "and a trend of its smoothness; none: neither")
      ->check(CLI::IsMember({"sought", "none"}))
      ->capture_default_str();
  command.add_flag("--atom", options.atom,
                   "Identify an atom of the density at the onset of macro-slip");
  command
      .add_option("--fit", options.fit,
                  "Fit and write this parametric model instead of the free density")
      ->check(CLI::IsMember(names_of(kParametricModels)));
}

void add_band_options(CLI::App& command, IdentifyArguments& options) {
  command
      .add_option("--samples", options.samples,
                  "Number of posterior draws of the density, which give its 95 % band. Levels: "
                  "default none, 1000 for a smooth band; records: default 1000")
      ->type_name("UINT");
  command
      .add_option("--samples-out", options.samples_out,
                  "Posterior draws of the joint to write: joint_samples.h5, HDF5")
      ->type_name(kHdf5Value);
  command.add_option("--bands", options.bands, "Levels: the former name of --samples; 0 for none")
      ->type_name("UINT")
      ->capture_default_str();
  command.add_option("--seed", options.seed, "Seed of the draws; default 1")->type_name("UINT");
  command
      .add_option("--dissipation-gain-std", options.dissipation_gain,
                  "Relative gain error of D common to all levels, for the band [1]; also in %")
      ->type_name("FLOAT")
      ->capture_default_str();
  command
      .add_option("--amplitude-gain-std", options.amplitude_gain,
                  "Relative gain error of A common to all levels, for the band [1]; also in %")
      ->type_name("FLOAT")
      ->capture_default_str();
  command
      .add_option(
          "--loss-factor-std", options.loss_factor,
          "Relative error of the structure's loss factor, and thus of the linear loss that was "
          "subtracted from D, for the band [1]; also in %; needs the column linear_dissipation [J]")
      ->type_name("FLOAT")
      ->capture_default_str();
}

void add_record_options(CLI::App& command, IdentifyArguments& options) {
  command.add_option("--force", options.force,
                     "Records: channel of the force; not needed if there is only one");
  command.add_option("--displacement", options.displacement,
                     "Records: channel of the displacement; not needed if there is only one");
  command
      .add_option("--start", options.start,
                  "Records: state at the first sample. virgin: no slip yet, and no force but an "
                  "offset; unknown: initial state not known; auto: detected")
      ->check(CLI::IsMember({"auto", "virgin", "unknown"}))
      ->capture_default_str();
  command
      .add_option(
          "--viscous", options.viscous,
          "Records: fit identifies a viscous force c times velocity in addition to the friction")
      ->check(CLI::IsMember({"none", "fit"}))
      ->capture_default_str();
  command
      .add_option("--drift", options.drift,
                  "Records: fit finds slow drifts of the zeros of both sensors with the joint, and "
                  "subtracts them")
      ->check(CLI::IsMember({"none", "fit"}))
      ->capture_default_str();
  add_recording_arguments(command, options.reading);
}

}  // namespace

void add_identify_arguments(CLI::App& command, IdentifyArguments& arguments) {
  command.add_option("--stiffness", arguments.stiffness,
                     "k of the stuck joint, in N/m or with a unit: slip forces are k times A. "
                     "Required for levels alone; identified from records");
  add_output_options(command, arguments);
  add_method_options(command, arguments);
  add_band_options(command, arguments);
  command
      .add_option(
          "--assemblies", arguments.assemblies,
          "Levels of several assemblies of a joint, three or more. column: the column assembly "
          "gives the assembly of each level; files: one assembly per file; none: all levels are of "
          "one joint, the default unless a column names several. Identifies what they have in "
          "common, the spread of k, slip forces and density shape between them, and posterior "
          "draws for the next assembly. k is a column stiffness [N/m], or --stiffness")
      ->check(CLI::IsMember({"column", "files", "none"}));
  add_record_options(command, arguments);
}

EvidenceFiles evidence_files(const IdentifyArguments& arguments) {
  EvidenceFiles files;
  for (const std::string& path : arguments.evidence) {
    TestFile file = open_test(path);
    if (evidence_kind(file) == EvidenceKind::kLevels) {
      files.levels.push_back(path);
    } else {
      files.records.push_back(std::move(file));
    }
  }
  return files;
}

LevelsIdentification levels_options(const IdentifyArguments& arguments, bool quiet) {
  refuse_options_of_recordings(arguments);
  LevelsIdentification all;
  all.levels = arguments.evidence.front();
  all.texts = {arguments.smoothing, arguments.smoothing_unit, arguments.samples_out};
  all.errors = errors_of(arguments);
  if (draws_of_levels(arguments).none()) check_unused(arguments, all.errors);
  all.options = library_options(arguments, quiet);
  all.stiffness = parse_stiffness(arguments.stiffness);
  all.use_inner_reversals = arguments.inner_reversals == "use";
  all.assemblies = assembly_column(arguments);
  return all;
}

RecordsIdentification records_options(const IdentifyArguments& arguments,
                                      const EvidenceFiles& files, bool quiet) {
  refuse_options_of_levels(arguments, files);
  if (files.records.empty()) refuse_options_of_recordings(arguments);
  RecordsIdentification all;
  for (const TestFile& file : files.records) all.records.push_back(file.path);
  all.opened = files.records;
  all.levels = files.levels;
  all.use_inner_reversals = arguments.inner_reversals == "use";
  all.assemblies = assembly_column(arguments);
  all.channels = {arguments.force, arguments.displacement};
  if (arguments.stiffness || files.records.empty())
    all.stiffness = parse_stiffness(arguments.stiffness);
  all.start = start_of(arguments);
  all.options.viscous = arguments.viscous == "fit";
  all.fit_drift = arguments.drift == "fit";
  all.options.draws = draws_of_posterior(arguments);
  all.options.seed = seed_of(arguments);
  all.samples_out = arguments.samples_out;
  all.options.progress = progress_bar("draws", quiet);
  all.reading = read_options(arguments.reading, progress_bar("reading", quiet));
  all.assumed_units = arguments.reading.assumed_units;
  return all;
}

AssembliesIdentification assemblies_options(const IdentifyArguments& arguments,
                                            const EvidenceFiles& files, const Call& call) {
  const Foreign of_one("applies to a single joint, and these are several assemblies");
  if (!files.records.empty()) {
    throw InputError(
        "--assemblies", in_quotes(*arguments.assemblies),
        fmt::format("takes levels alone, and {} is a record", files.records.front().path),
        "The subcommand levels extracts levels from a record.");
  }
  refuse_options_of_levels(arguments, files);
  refuse_options_of_recordings(arguments);
  of_one.refuse("--density-csv", arguments.density_csv, "",
                "densities.csv in --out contains them.");
  of_one.refuse("--samples-out", arguments.samples_out, "",
                "joint_samples.h5 in --out contains them.");
  AssembliesIdentification all;
  all.levels = files.levels;
  all.by = *arguments.assemblies == "files" ? AssembliesBy::kFiles : AssembliesBy::kColumn;
  if (arguments.stiffness) all.stiffness = parse_stiffness(arguments.stiffness);
  all.use_inner_reversals = arguments.inner_reversals == "use";
  all.options.draws = draws_of_posterior(arguments);
  all.options.seed = seed_of(arguments);
  all.options.progress = progress_bar("draws", call.quiet);
  all.out = arguments.out;
  all.command = call.command_line;
  return all;
}

}  // namespace microslip::app
