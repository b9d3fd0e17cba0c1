/* SPDX-License-Identifier: MIT */
#include "mex_commands.h"

static void set_column(microslip_levels* levels, const mxArray* from, const char* field,
                       microslip_level_column column, size_t count) {
  const mxArray* values = mx_optional(from, field);
  if (values == NULL) return;
  mx_must(microslip_levels_set(levels, column, count, mx_numbers_of(values, field, count)));
}

/* Of a path, or of a struct with columns. */
static microslip_levels* levels_of(const mxArray* from) {
  static const char* const known[] = {"amplitude",          "dissipation",
                                      "amplitude_std",      "dissipation_std",
                                      "secant_stiffness",   "secant_stiffness_std",
                                      "linear_dissipation", "frequency",
                                      "frequency_std",      NULL};
  microslip_levels* levels = NULL;
  const double* amplitude;
  size_t count;
  if (mxIsChar(from)) {
    mx_must(microslip_levels_read(mx_text(from, "levels"), &levels));
    mx_keep(MX_LEVELS, levels);
    return levels;
  }
  mx_struct(from, "levels", known);
  amplitude = mx_numbers(mx_needed(from, "amplitude", "levels"), "amplitude", &count);
  mx_must(microslip_levels_create(
      count, amplitude,
      mx_numbers_of(mx_needed(from, "dissipation", "levels"), "dissipation", count), &levels));
  mx_keep(MX_LEVELS, levels);
  set_column(levels, from, "amplitude_std", MICROSLIP_LEVEL_AMPLITUDE_STD, count);
  set_column(levels, from, "dissipation_std", MICROSLIP_LEVEL_DISSIPATION_STD, count);
  set_column(levels, from, "secant_stiffness", MICROSLIP_LEVEL_SECANT_STIFFNESS, count);
  set_column(levels, from, "secant_stiffness_std", MICROSLIP_LEVEL_SECANT_STIFFNESS_STD, count);
  set_column(levels, from, "linear_dissipation", MICROSLIP_LEVEL_LINEAR_DISSIPATION, count);
  set_column(levels, from, "frequency", MICROSLIP_LEVEL_FREQUENCY, count);
  set_column(levels, from, "frequency_std", MICROSLIP_LEVEL_FREQUENCY_STD, count);
  return levels;
}

static void number(const mxArray* from, const char* field, const char* shown, double* to) {
  const mxArray* value = mx_optional(from, field);
  if (value != NULL) *to = mx_number(value, shown);
}

static void flag(const mxArray* from, const char* field, const char* shown, int* to) {
  const mxArray* value = mx_optional(from, field);
  if (value != NULL) *to = mx_number(value, shown) != 0.0;
}

static void text(const mxArray* from, const char* field, const char* shown, const char** to) {
  const mxArray* value = mx_optional(from, field);
  if (value != NULL) *to = mx_text(value, shown);
}

static microslip_identify_options options_of(const mxArray* from) {
  static const char* const known[] = {"Stiffness",
                                      "Method",
                                      "Smoothing",
                                      "SmoothingUnit",
                                      "Fit",
                                      "LinearDamping",
                                      "Atom",
                                      "Edges",
                                      "Bands",
                                      "Confidence",
                                      "Seed",
                                      "DissipationGainStd",
                                      "AmplitudeGainStd",
                                      "LossFactorStd",
                                      "Threads",
                                      "Command",
                                      NULL};
  microslip_identify_options options;
  mx_struct(from, "options", known);
  mx_must(microslip_identify_options_defaults(&options, sizeof options));
  options.command = "microslip.identify";
  number(from, "Stiffness", "Stiffness", &options.stiffness);
  text(from, "Method", "Method", &options.method);
  text(from, "Smoothing", "Smoothing", &options.smoothing);
  text(from, "SmoothingUnit", "SmoothingUnit", &options.smoothing_unit);
  text(from, "Fit", "Fit", &options.fit);
  flag(from, "LinearDamping", "LinearDamping", &options.linear_damping);
  flag(from, "Atom", "Atom", &options.atom);
  flag(from, "Edges", "Edges", &options.edges);
  if (mx_optional(from, "Bands") != NULL)
    options.bands = mx_whole(mx_optional(from, "Bands"), "Bands");
  number(from, "Confidence", "Confidence", &options.confidence);
  if (mx_optional(from, "Seed") != NULL) options.seed = mx_whole(mx_optional(from, "Seed"), "Seed");
  number(from, "DissipationGainStd", "DissipationGainStd", &options.dissipation_gain_std);
  number(from, "AmplitudeGainStd", "AmplitudeGainStd", &options.amplitude_gain_std);
  number(from, "LossFactorStd", "LossFactorStd", &options.loss_factor_std);
  if (mx_optional(from, "Threads") != NULL)
    options.threads = (int)mx_whole(mx_optional(from, "Threads"), "Threads");
  text(from, "Command", "Command", &options.command);
  options.progress = mx_go_on;
  return options;
}

static void set_values(mxArray* to, const char* field, const microslip_identification* found,
                       microslip_identified_values what) {
  const double* values;
  size_t count;
  mx_must(microslip_identification_values(found, what, &values, &count));
  mx_set(to, field, mx_column(values, count));
}

static void set_value(mxArray* to, const char* field, const microslip_identification* found,
                      microslip_identified_number what) {
  double value;
  mx_must(microslip_identification_number(found, what, &value));
  mx_set_number(to, field, value);
}

static microslip_status warning_of(const void* found, size_t index, const char** code,
                                   const char** text) {
  return microslip_identification_warning(found, index, code, text);
}

static void set_ending(mxArray* to, const microslip_identification* found) {
  microslip_outcome outcome;
  outcome.struct_size = sizeof outcome;
  mx_must(microslip_identification_outcome(found, &outcome));
  mx_set_ending(to, &outcome, found, warning_of);
}

/* (levels, options) */
mxArray* mex_identify(const mxArray** arguments) {
  const microslip_levels* levels = levels_of(arguments[0]);
  const microslip_identify_options options = options_of(arguments[1]);
  microslip_identification* found = NULL;
  microslip_joint* joint = NULL;
  microslip_status status;
  mxArray* result;
  mx_begin_listening();
  status = microslip_identify(levels, &options, &found);
  mx_end_listening();
  mx_must(status);
  mx_keep(MX_IDENTIFICATION, found);
  mx_must(microslip_identification_joint(found, &joint));
  mx_keep(MX_JOINT, joint);
  result = mx_new_struct();
  mx_set(result, "joint", mx_joint_struct(joint, 1));
  set_values(result, "slip_force_N", found, MICROSLIP_IDENTIFIED_SLIP_FORCE);
  set_values(result, "density_per_N", found, MICROSLIP_IDENTIFIED_DENSITY);
  set_values(result, "lower_per_N", found, MICROSLIP_IDENTIFIED_LOWER);
  set_values(result, "upper_per_N", found, MICROSLIP_IDENTIFIED_UPPER);
  set_value(result, "covered_from_N", found, MICROSLIP_IDENTIFIED_COVERED_FROM);
  set_value(result, "covered_to_N", found, MICROSLIP_IDENTIFIED_COVERED_TO);
  set_value(result, "linear_damping_J_per_m2", found, MICROSLIP_IDENTIFIED_LINEAR_DAMPING);
  set_ending(result, found);
  return result;
}
