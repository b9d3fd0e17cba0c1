// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/prediction.hpp"
#include "arguments/printed_text.hpp"
#include "arguments/progress_bar.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/response/load_file.hpp"
#include "microslip/documents/response/power_density_file.hpp"
#include "microslip/documents/response/required_spectrum_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/workflow/predict/load_synthesis.hpp"
#include "microslip/workflow/text/quantity_text.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip::app {
namespace {

constexpr std::uint64_t kMostSeed = 1'000'000'000'000'000'000;

struct LoadOptions {
  std::string shape;
  std::string model;
  std::string out;
  std::string peak;
  std::string frequency;
  std::string cycles;
  std::string pulse;
  std::string begin;
  std::string density;
  std::string spectrum;
  std::string damping_ratio;
  std::string per_octave;
  std::string tolerance;
  std::string seed;
  std::string duration;
  std::string sampling_rate;
  bool logarithmic = false;
};

LoadShape parse_shape(const std::string& text) {
  for (const LoadShape shape : {LoadShape::kSine, LoadShape::kSweep, LoadShape::kHalfSine,
                                LoadShape::kNoise, LoadShape::kShock}) {
    if (text == to_string(shape)) return shape;
  }
  throw InputError("shape", in_quotes(text), "must be sine, sweep, half-sine, noise or shock");
}

double parse_positive(std::string_view option, const std::string& text, const Dimension& unit) {
  const double value = parse_quantity(option, text, unit);
  if (value > 0.0) return value;
  throw InputError(option, value, fmt::format("must be above 0 {}", si_unit(unit)));
}

/// Which options a shape needs, and which it may have.
struct KnownOptions {
  LoadShape shape;
  std::vector<std::string_view> needed;
  std::vector<std::string_view> allowed = {};
};

/// Refuses options that have no effect on the shape.
void check_options(const LoadOptions& options, LoadShape shape) {
  static const std::array<KnownOptions, 5> kKnown{{
      {LoadShape::kSine, {"--peak", "--frequency"}, {"--cycles"}},
      {LoadShape::kSweep, {"--peak", "--frequency"}, {"--log"}},
      {LoadShape::kHalfSine, {"--peak", "--pulse"}, {"--at"}},
      {LoadShape::kNoise, {"--density"}, {"--seed"}},
      {LoadShape::kShock,
       {"--spectrum"},
       {"--damping-ratio", "--per-octave", "--tolerance", "--pulse", "--at", "--seed"}},
  }};
  const KnownOptions& known = *std::ranges::find(kKnown, shape, &KnownOptions::shape);
  const std::array<std::pair<std::string_view, bool>, 12> given{{
      {"--peak", !options.peak.empty()},
      {"--frequency", !options.frequency.empty()},
      {"--cycles", !options.cycles.empty()},
      {"--log", options.logarithmic},
      {"--pulse", !options.pulse.empty()},
      {"--at", !options.begin.empty()},
      {"--density", !options.density.empty()},
      {"--spectrum", !options.spectrum.empty()},
      {"--damping-ratio", !options.damping_ratio.empty()},
      {"--per-octave", !options.per_octave.empty()},
      {"--tolerance", !options.tolerance.empty()},
      {"--seed", !options.seed.empty()},
  }};
  for (const auto& [option, is_given] : given) {
    const bool needed = std::ranges::find(known.needed, option) != known.needed.end();
    const bool allowed = std::ranges::find(known.allowed, option) != known.allowed.end();
    if (needed && !is_given) {
      throw InputError(option, InputState{"missing"},
                       fmt::format("must be given for a {}", to_string(shape)));
    }
    if (is_given && !needed && !allowed) {
      throw InputError(
          option, InputState{"given"},
          fmt::format("must be left out: it does not apply to a {}", to_string(shape)));
    }
  }
}

/// "3" or "3dB".
double parse_decibels(const std::string& text) {
  constexpr std::string_view kUnit = "dB";
  const std::string number =
      text.ends_with(kUnit) ? text.substr(0, text.size() - kUnit.size()) : text;
  if (!number.ends_with('%')) return parse_quantity("--tolerance", number, kDimensionless);
  throw InputError("--tolerance", text, "must be in dB", "For instance: --tolerance 3dB");
}

/// Options that only a shock has.
void set_shock(const LoadOptions& options, LoadPlan& plan) {
  plan.required = read_required_spectrum(options.spectrum);
  if (!options.damping_ratio.empty()) {
    plan.shock.damping_ratio =
        parse_quantity("--damping-ratio", options.damping_ratio, kDimensionless);
  }
  if (!options.per_octave.empty()) {
    plan.shock.per_octave = parse_quantity("--per-octave", options.per_octave, kDimensionless);
  }
  if (!options.tolerance.empty()) plan.shock.tolerance = parse_decibels(options.tolerance);
}

LoadPlan plan_of(const LoadOptions& options, LoadShape shape, const Dimension& unit) {
  LoadPlan plan{.shape = shape};
  if (!options.peak.empty()) plan.peak = parse_positive("--peak", options.peak, unit);
  if (shape == LoadShape::kSweep) {
    std::tie(plan.frequency, plan.last_frequency) =
        parse_frequencies("--frequency", options.frequency);
  } else if (!options.frequency.empty()) {
    plan.frequency = parse_positive("--frequency", options.frequency, kFrequency);
  }
  if (!options.cycles.empty()) {
    plan.cycles = parse_positive("--cycles", options.cycles, kDimensionless);
  }
  plan.logarithmic = options.logarithmic;
  if (!options.pulse.empty()) plan.pulse = parse_positive("--pulse", options.pulse, kTime);
  if (!options.begin.empty()) plan.begin = parse_quantity("--at", options.begin, kTime);
  if (!options.density.empty()) plan.density = read_power_density(options.density, unit);
  if (shape == LoadShape::kShock) set_shock(options, plan);
  if (!options.seed.empty()) plan.seed = parse_whole_number("--seed", options.seed, 0, kMostSeed);
  plan.duration = parse_positive("--duration", options.duration, kTime);
  if (!options.sampling_rate.empty()) {
    plan.sampling_rate = parse_positive("--sampling-rate", options.sampling_rate, kFrequency);
  }
  return plan;
}

int run(const LoadOptions& options, const Call& call) {
  check_output(options.out);
  const LoadShape shape = parse_shape(options.shape);
  check_options(options, shape);
  const ModelFile model = read_model(options.model, JointsToFind::kAllowed);
  const Dimension unit = model.structure.base_driven() ? kAcceleration : kForce;
  const LoadPlan plan = plan_of(options, shape, unit);
  const SynthesisedLoad load =
      synthesise_load(model.structure, plan, progress_bar("spectrum of the shock", call.quiet));
  std::string heading = heading_of(call.command_line);
  const std::string comment = load_comment(plan, load);
  if (!comment.empty()) heading += '\n' + comment;
  write_file(options.out, format_loads(load.history, model.structure, heading));
  if (!call.quiet) {
    print_text(options.out == "-" ? stderr : stdout,
               fmt::format("A {} on {}\n{}", to_string(shape), options.model,
                           describe_load(model.structure, load)));
  } else if (!load.converged()) {
    print_text(
        stderr,
        fmt::format("microslip: {}: not converged: {}; the result so far is written and marked\n",
                    input_name(options.model), load.shock->summary.reason));
  }
  return load.converged() ? kDone : kNotConverged;
}

void add_shape_options(CLI::App& command, LoadOptions& options) {
  command.add_option("--peak", options.peak,
                     "Amplitude of a sine, sweep or half-sine: in N, or in m/s^2 where a base is "
                     "driven, or with a unit");
  command.add_option("--frequency", options.frequency,
                     "Frequency of a sine; FROM:TO of a sweep; in Hz or with units");
  command.add_option("--cycles", options.cycles,
                     "Number of periods after which a sine ends; default: it does not end");
  command.add_flag("--log", options.logarithmic, "Logarithmic instead of linear sweep");
  command.add_option("--pulse", options.pulse,
                     "Length of a half-sine, or of a shock (default: the shortest, three "
                     "half-cycles of its lowest frequency), in s or with a unit");
  command.add_option("--at", options.begin, "Start time of a half-sine or a shock (0 s)");
  command
      .add_option(
          "--density", options.density,
          "Power spectral density of noise: frequency [Hz], density [N^2/Hz], or [(m/s^2)^2/Hz] or "
          "[g^2/Hz] where a base is driven; log-log interpolation between its rows")
      ->type_name(kCsvValue);
  command.add_option("--seed", options.seed,
                     "Seed of noise or of a shock; the same seed gives the same noise (1)");
}

void add_shock_options(CLI::App& command, LoadOptions& options) {
  command
      .add_option(
          "--spectrum", options.spectrum,
          "Required shock response spectrum of a shock: frequency [Hz], maximax [m/s^2] or [g]; "
          "log-log interpolation between its rows. The output of the command spectrum can be used")
      ->type_name(kCsvValue);
  command.add_option("--damping-ratio", options.damping_ratio,
                     "Damping ratio of the oscillators of that spectrum: 1/(2Q) (0.05)");
  command.add_option("--per-octave", options.per_octave,
                     "Natural frequencies per octave at which a shock is checked, 6 to 48 (12)");
  command.add_option("--tolerance", options.tolerance,
                     "Tolerance of its spectrum above and below (1dB)");
}

}  // namespace

void add_load(CLI::App& program, Call& call) {
  auto options = std::make_shared<LoadOptions>();
  CLI::App* command = program.add_subcommand(
      "load", "Load histories for march: a sine, a sweep, a half-sine, noise, a shock");
  command->add_option("shape", options->shape, "sine, sweep, half-sine, noise or shock")
      ->required()
      ->check(CLI::IsMember({"sine", "sweep", "half-sine", "noise", "shock"}));
  command
      ->add_option("model", options->model,
                   "Structure, model.toml: its excitation specifies what is driven; a sine has its "
                   "harmonics and phases")
      ->required()
      ->type_name(kTomlValue);
  command
      ->add_option("--out", options->out,
                   "CSV to write: time [s], and force [N], force at POINT [N] or acceleration of "
                   "BASE [m/s^2]; - is standard output")
      ->required()
      ->type_name(kCsvValue);
  command
      ->add_option("--duration", options->duration,
                   "Length of the load history, in s or with a unit")
      ->required();
  command->add_option("--sampling-rate", options->sampling_rate,
                      "Sampling rate of the table, in Hz or with a unit; the load is linear "
                      "between its times. Default: 256 times per period, 200 per half-sine, 32 per "
                      "period of the highest frequency of noise, 20 of a shock");
  add_shape_options(*command, *options);
  add_shock_options(*command, *options);
  command->add_flag("--quiet", call.quiet, "No summary");
  add_examples(*command,
               {"microslip load sine model.toml --peak 20N --frequency 16.2 --cycles 100 \\",
                "          --duration 20s --out force.csv",
                "microslip load half-sine shaken.toml --peak 50g --pulse 11ms --duration 0.5s \\",
                "          --out shock.csv",
                "microslip load noise shaken.toml --density asd.csv --duration 60s --seed 7 \\",
                "          --out noise.csv",
                "microslip load shock shaken.toml --spectrum required.csv --duration 0.5s \\",
                "          --out shock.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
