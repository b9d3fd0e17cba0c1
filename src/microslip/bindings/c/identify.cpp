// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/bindings/c/errors.hpp"
#include "microslip/bindings/c/handles.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/workflow/identify/identification_text.hpp"
#include "microslip/workflow/identify/smoothing_text.hpp"
#include "microslip/workflow/reduce/level_table.hpp"

namespace c = microslip::c;

namespace microslip::c {
namespace {

constexpr const char* kDefaultCommand = "microslip_identify";

std::vector<double>& column_of(Levels& levels, microslip_level_column column) {
  switch (column) {
    case MICROSLIP_LEVEL_AMPLITUDE_STD:
      return levels.amplitude_std;
    case MICROSLIP_LEVEL_DISSIPATION_STD:
      return levels.dissipation_std;
    case MICROSLIP_LEVEL_SECANT_STIFFNESS:
      return levels.secant_stiffness;
    case MICROSLIP_LEVEL_SECANT_STIFFNESS_STD:
      return levels.secant_stiffness_std;
    case MICROSLIP_LEVEL_LINEAR_DISSIPATION:
      return levels.linear_dissipation;
    case MICROSLIP_LEVEL_FREQUENCY:
      return levels.frequency;
    case MICROSLIP_LEVEL_FREQUENCY_STD:
      return levels.frequency_std;
  }
  throw_unknown(column, "column");
}

microslip_identify_options identify_defaults() {
  microslip_identify_options all{};
  all.method = "inversion";
  all.smoothing = "gcv";
  all.fit = "none";
  all.edges = 1;
  const BandOptions bands;
  all.confidence = bands.confidence;
  all.seed = bands.seed;
  all.command = kDefaultCommand;
  return all;
}

IdentificationMethod method_of(std::string_view text) {
  if (const auto method = find_identification_method(text)) return *method;
  throw InputError("options->method", fmt::format("'{}'", text),
                   "must be inversion, spline or differences");
}

std::optional<ParametricModel> model_of(std::string_view text) {
  if (text == "none") return std::nullopt;
  if (const auto model = find_parametric_model(text)) return model;
  throw InputError("options->fit", fmt::format("'{}'", text),
                   "must be none, four_parameter, power_law or uniform");
}

std::string_view text_or(const char* text, std::string_view otherwise) {
  return text == nullptr ? otherwise : text;
}

std::optional<BandOptions> bands_of(const microslip_identify_options& options) {
  if (options.bands == 0) return std::nullopt;
  if (options.threads < 0) {
    throw InputError("options->threads", static_cast<double>(options.threads), "must be 0 or more");
  }
  BandOptions bands;
  bands.samples = options.bands;
  bands.confidence = options.confidence;
  bands.seed = options.seed;
  bands.progress = progress_of(options.progress, options.user);
  bands.execution = options.threads == 1
                        ? Execution::serial()
                        : Execution::threads(static_cast<std::size_t>(options.threads));
  return bands;
}

/// Translates names of the library to members of the options.
template <typename Check>
void check_member(const Check& check, std::string_view instead = {}) {
  try {
    check();
  } catch (const InputError& error) {
    const std::string_view member = instead.empty() ? std::string_view(error.name()) : instead;
    throw error.renamed(fmt::format("options->{}", member));
  }
}

/// The limit of the program.
void check_draws(std::size_t bands) {
  constexpr std::size_t kMost = 1'000'000;  // more memory than use
  if (bands <= kMost) return;
  throw InputError("options->bands", fmt::format("{}", bands), "must be at most 1000000",
                   "1000 give smooth bands.");
}

/// Checked before the levels, whose file would be blamed.
void check_options(const LevelsIdentification& all) {
  check_member([&] { all.errors.check(); });
  if (!all.options.bands) return;
  const BandOptions& bands = *all.options.bands;
  check_draws(bands.samples);
  check_member([&] { BandOptions{.samples = bands.samples}.check(); }, "bands");
  check_member([&] { bands.check(); });
}

/// The range of the program: beyond it, products leave the range of doubles.
double stiffness_of(const microslip_identify_options& options) {
  const double k = positive(options.stiffness, "options->stiffness");
  if (k >= kSmallestStiffness && k <= kLargestStiffness) return k;
  throw InputError(
      "options->stiffness", k,
      fmt::format("must be from {:g} to {:g} N/m", kSmallestStiffness, kLargestStiffness),
      "Check its unit.");
}

LevelsIdentification levels_identification(const microslip_identify_options& options) {
  LevelsIdentification all;
  all.stiffness = stiffness_of(options);
  all.texts.smoothing = text_or(options.smoothing, "gcv");
  if (options.smoothing_unit != nullptr) all.texts.smoothing_unit = options.smoothing_unit;
  all.errors = {options.dissipation_gain_std, options.amplitude_gain_std, options.loss_factor_std};
  all.options.method = method_of(text_or(options.method, "inversion"));
  all.options.fit = model_of(text_or(options.fit, "none"));
  all.options.inversion.linear_damping = options.linear_damping != 0;
  all.options.inversion.atom = options.atom != 0;
  all.options.inversion.edges = options.edges != 0;
  all.options.bands = bands_of(options);
  set_smoothing(all.texts.smoothing, all.texts.smoothing_unit, all.options);
  check_options(all);
  return all;
}

/// Checks that levels have the column that an option needs, in a message that names the option.
void check_linear_loss(const Levels& levels, double loss_factor_std) {
  if (loss_factor_std == 0.0 || !levels.linear_dissipation.empty()) return;
  throw InputError("options->loss_factor_std", loss_factor_std,
                   "needs the linear loss of the levels",
                   "It is the column linear_dissipation of a file, or set as "
                   "MICROSLIP_LEVEL_LINEAR_DISSIPATION.");
}

/// The command goes into joint.json, which is UTF-8, and from there into lines of other files.
std::string command_of(const microslip_identify_options& options) {
  std::string command(text_or(options.command, kDefaultCommand));
  if (printable(command) == command) return command;
  throw InputError("options->command", in_quotes(command), "must be a line of printable UTF-8");
}

/// Levels of a file carry its name in messages and its warnings.
Identification found_in(const microslip_levels& levels, const LevelsIdentification& options) {
  if (levels.of_file) return identify_table(levels.table, options).found;
  return identify(LevelEvidence(levels.table.used.levels, options.errors), options.stiffness,
                  options.options);
}

microslip_identification* identified(const microslip_levels& levels,
                                     const microslip_identify_options& options) {
  const LevelsIdentification all = levels_identification(options);
  const std::string command = command_of(options);
  check_linear_loss(levels.table.used.levels, options.loss_factor_std);
  Identification found = found_in(levels, all);
  std::vector<NamedInput> inputs;
  if (levels.of_file && !levels.changed) inputs.push_back(levels.table.input);
  JointFile file = identified_joint(all, found, inputs, command);
  Ending ending(found.summary, found.warnings,
                describe_identification(found, levels.table.used.levels.size()));
  return new microslip_identification{
      std::move(found), std::make_shared<const JointFile>(std::move(file)), std::move(ending)};
}

const std::vector<double>& values_of(const Identification& found,
                                     microslip_identified_values what) {
  switch (what) {
    case MICROSLIP_IDENTIFIED_SLIP_FORCE:
      return found.slip_force;
    case MICROSLIP_IDENTIFIED_DENSITY:
      return found.density;
    case MICROSLIP_IDENTIFIED_LOWER:
      return found.lower;
    case MICROSLIP_IDENTIFIED_UPPER:
      return found.upper;
  }
  throw_unknown(what, "what");
}

double number_of(const Identification& found, microslip_identified_number what) {
  switch (what) {
    case MICROSLIP_IDENTIFIED_COVERED_FROM:
      return found.covered_from;
    case MICROSLIP_IDENTIFIED_COVERED_TO:
      return found.covered_to;
    case MICROSLIP_IDENTIFIED_LINEAR_DAMPING:
      return found.linear_damping.value_or(std::numeric_limits<double>::quiet_NaN());
  }
  throw_unknown(what, "what");
}

}  // namespace
}  // namespace microslip::c

microslip_status microslip_levels_create(std::size_t count, const double* amplitude,
                                         const double* dissipation, microslip_levels** levels) {
  return c::done([&] {
    c::require_pointer(levels, "levels");
    const auto a = c::values(count, amplitude, "amplitude");
    const auto d = c::values(count, dissipation, "dissipation");
    microslip::Levels all{.amplitude = {a.begin(), a.end()}, .dissipation = {d.begin(), d.end()}};
    microslip::check_levels(all);
    auto made = std::make_unique<microslip_levels>();
    made->table.used.levels = std::move(all);
    *levels = made.release();
  });
}

microslip_status microslip_levels_set(microslip_levels* levels, microslip_level_column column,
                                      std::size_t count, const double* values) {
  return c::done([&] {
    c::require_pointer(levels, "levels");
    microslip::Levels& all = levels->table.used.levels;
    c::require_count(count, all.size(), "count", "levels");
    const auto given = c::values(count, values, "values");
    microslip::Levels changed = all;
    c::column_of(changed, column).assign(given.begin(), given.end());
    microslip::check_levels(changed);
    all = std::move(changed);
    levels->changed = true;
  });
}

microslip_status microslip_levels_read(const char* path, microslip_levels** levels) {
  return c::done([&] {
    c::require_pointer(levels, "levels");
    auto made = std::make_unique<microslip_levels>();
    made->table = microslip::read_level_table(
        &c::at(path, "path"), {.linear_dissipation = microslip::LinearLossColumn::kUsed,
                               .assemblies = microslip::AssemblyColumn::kRefused});
    made->of_file = true;
    *levels = made.release();
  });
}

microslip_status microslip_levels_count(const microslip_levels* levels, std::size_t* count) {
  return c::done([&] { c::at(count, "count") = c::at(levels, "levels").table.used.levels.size(); });
}

void microslip_levels_destroy(microslip_levels* levels) { delete levels; }

microslip_status microslip_identify_options_defaults(microslip_identify_options* options,
                                                     std::size_t struct_size) {
  return c::done([&] { c::write_struct(c::identify_defaults(), options, struct_size, "options"); });
}

microslip_status microslip_identify(const microslip_levels* levels,
                                    const microslip_identify_options* options,
                                    microslip_identification** identification) {
  return c::guarded([&] {
    c::require_pointer(levels, "levels");
    c::require_pointer(options, "options");
    c::require_pointer(identification, "identification");
    *identification =
        c::identified(*levels, c::read_struct(options, c::identify_defaults(), "options"));
    return c::status_of((*identification)->ending.summary);
  });
}

void microslip_identification_destroy(microslip_identification* identification) {
  delete identification;
}

microslip_status microslip_identification_joint(const microslip_identification* identification,
                                                microslip_joint** joint) {
  return c::done([&] {
    const auto& file = c::at(identification, "identification").file;
    c::require_pointer(joint, "joint");
    *joint = new microslip_joint(file);
  });
}

microslip_status microslip_identification_values(const microslip_identification* identification,
                                                 microslip_identified_values what,
                                                 const double** values, std::size_t* count) {
  return c::done([&] {
    c::hand_out(c::values_of(c::at(identification, "identification").found, what), values, count);
  });
}

microslip_status microslip_identification_number(const microslip_identification* identification,
                                                 microslip_identified_number what, double* value) {
  return c::done([&] {
    c::at(value, "value") = c::number_of(c::at(identification, "identification").found, what);
  });
}

microslip_status microslip_identification_outcome(const microslip_identification* identification,
                                                  microslip_outcome* outcome) {
  return c::done(
      [&] { c::write_outcome(c::at(identification, "identification").ending, outcome); });
}

microslip_status microslip_identification_warning(const microslip_identification* identification,
                                                  std::size_t index, const char** code,
                                                  const char** text) {
  return c::done(
      [&] { c::write_warning(c::at(identification, "identification").ending, index, code, text); });
}
