/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "mex_commands.h"

static void whole(const mxArray* from, const char* field, size_t* to) {
  const mxArray* value = mx_optional(from, field);
  if (value != NULL) *to = mx_whole(value, field);
}

static void number(const mxArray* from, const char* field, double* to) {
  const mxArray* value = mx_optional(from, field);
  if (value != NULL) *to = mx_number(value, field);
}

static microslip_response response_of(const char* kind) {
  static const char* const kinds[] = {"displacement", "velocity", "acceleration"};
  int i;
  for (i = 0; i < 3; ++i) {
    if (strcmp(kind, kinds[i]) == 0) return (microslip_response)i;
  }
  mx_fail("input", "Kind = '%s'; must be displacement, velocity or acceleration", kind);
  return MICROSLIP_DISPLACEMENT;
}

static microslip_frf_options options_of(const mxArray* from) {
  static const char* const known[] = {"Force",     "Response", "Frequency", "Point",     "Kind",
                                      "Harmonics", "Samples",  "Tolerance", "Accuracy",  "At",
                                      "Mode",      "Forcing",  "Judge",     "MaxPoints", NULL};
  microslip_frf_options options;
  size_t points;
  mx_struct(from, "options", known);
  mx_must(microslip_frf_options_defaults(&options, sizeof options));
  whole(from, "Harmonics", &options.harmonics);
  whole(from, "Samples", &options.samples);
  number(from, "Tolerance", &options.tolerance);
  number(from, "Accuracy", &options.accuracy);
  points = (size_t)options.max_points;
  whole(from, "MaxPoints", &points);
  mx_require(points <= 1000000000, "MaxPoints", "be 1e9 or less");
  options.max_points = (int)points;
  if (mx_optional(from, "At") != NULL)
    options.at = mx_numbers(mx_optional(from, "At"), "At", &options.at_count);
  if (mx_optional(from, "Kind") != NULL)
    options.response = response_of(mx_text(mx_optional(from, "Kind"), "Kind"));
  if (mx_optional(from, "Forcing") != NULL) {
    const char* forcing = mx_text(mx_optional(from, "Forcing"), "Forcing");
    options.modal_forcing = strcmp(forcing, "modal") == 0;
    mx_require(options.modal_forcing || strcmp(forcing, "excitation") == 0, "Forcing",
               "be excitation or modal");
  }
  if (mx_optional(from, "Judge") != NULL)
    options.judge = mx_number(mx_optional(from, "Judge"), "Judge") != 0.0;
  options.progress = mx_go_on;
  return options;
}

static const char* point_of(const mxArray* from) {
  const mxArray* point = mx_optional(from, "Point");
  return point == NULL ? NULL : mx_text(point, "Point");
}

static void set_columns(mxArray* to, const microslip_curve* curve) {
  static const struct {
    const char* field;
    microslip_curve_values_of what;
  } columns[] = {{"frequency_Hz", MICROSLIP_CURVE_FREQUENCY},
                 {"force_N", MICROSLIP_CURVE_FORCE},
                 {"displacement_m", MICROSLIP_CURVE_DISPLACEMENT},
                 {"real_m", MICROSLIP_CURVE_REAL},
                 {"imaginary_m", MICROSLIP_CURVE_IMAGINARY},
                 {"phase_rad", MICROSLIP_CURVE_PHASE},
                 {"damping_ratio", MICROSLIP_CURVE_DAMPING_RATIO},
                 {"dissipation_J", MICROSLIP_CURVE_DISSIPATION},
                 {"linear_dissipation_J", MICROSLIP_CURVE_LINEAR_DISSIPATION},
                 {"energy_imbalance", MICROSLIP_CURVE_IMBALANCE}};
  size_t i;
  for (i = 0; i < sizeof columns / sizeof columns[0]; ++i) {
    const double* values;
    size_t count;
    mx_must(microslip_curve_values(curve, columns[i].what, &values, &count));
    mx_set(to, columns[i].field, mx_column(values, count));
  }
}

static mxArray* joints_of(const microslip_curve* curve, const microslip_structure* structure) {
  static const char* fields[] = {"name", "amplitude_m", "dissipation_J"};
  mxArray* joints;
  size_t count;
  size_t i;
  mx_must(microslip_structure_counts(structure, NULL, &count));
  joints = mxCreateStructMatrix(count, count > 0 ? 1 : 0, 3, fields);
  for (i = 0; i < count; ++i) {
    const char* name;
    const double* values;
    size_t size;
    mx_must(microslip_structure_joint(structure, i, &name));
    mxSetField(joints, i, "name", mxCreateString(name));
    mx_must(microslip_curve_joint(curve, i, MICROSLIP_CURVE_JOINT_AMPLITUDE, &values, &size));
    mxSetField(joints, i, "amplitude_m", mx_column(values, size));
    mx_must(microslip_curve_joint(curve, i, MICROSLIP_CURVE_JOINT_DISSIPATION, &values, &size));
    mxSetField(joints, i, "dissipation_J", mx_column(values, size));
  }
  return joints;
}

/* Indices from 1. */
static mxArray* peaks_of(const microslip_curve* curve) {
  const size_t* peaks;
  mxArray* column;
  size_t count;
  size_t i;
  mx_must(microslip_curve_peaks(curve, &peaks, &count));
  column = mxCreateDoubleMatrix(count, count > 0 ? 1 : 0, mxREAL);
  for (i = 0; i < count; ++i) mxGetPr(column)[i] = (double)peaks[i] + 1.0;
  return column;
}

static microslip_status warning_of(const void* curve, size_t index, const char** code,
                                   const char** text) {
  return microslip_curve_warning(curve, index, code, text);
}

static void set_ending(mxArray* to, const microslip_curve* curve) {
  microslip_outcome outcome;
  outcome.struct_size = sizeof outcome;
  mx_must(microslip_curve_outcome(curve, &outcome));
  mx_set_ending(to, &outcome, curve, warning_of);
}

static mxArray* curve_struct(const microslip_curve* curve, const microslip_structure* structure) {
  mxArray* result = mx_new_struct();
  set_columns(result, curve);
  mx_set(result, "peaks", peaks_of(curve));
  mx_set(result, "joints", joints_of(curve, structure));
  set_ending(result, curve);
  return result;
}

/* (model, options) */
mxArray* mex_frf(const mxArray** arguments) {
  const microslip_structure* structure = mx_structure_of(arguments[0]);
  const mxArray* given = arguments[1];
  const microslip_frf_options options = options_of(given);
  const mxArray* force = mx_optional(given, "Force");
  const mxArray* response = mx_optional(given, "Response");
  const mxArray* frequency = mx_optional(given, "Frequency");
  const char* point = point_of(given);
  const double* range;
  microslip_curve* curve = NULL;
  microslip_status status;
  double value;
  mx_require((force == NULL) != (response == NULL), "Force", "be given, or Response, and not both");
  mx_require(frequency != NULL, "Frequency", "be given: [FROM TO], Hz");
  range = mx_numbers_of(frequency, "Frequency", 2);
  value = force != NULL ? mx_number(force, "Force") : mx_number(response, "Response");
  mx_require(value > 0.0, force != NULL ? "Force" : "Response", "be positive");
  mx_require(range[0] > 0.0 && range[1] > 0.0 && range[0] != range[1], "Frequency",
             "be two different positive numbers");
  mx_begin_listening();
  status = microslip_frf(structure, point,
                         force != NULL ? MICROSLIP_KEEP_FORCE : MICROSLIP_KEEP_RESPONSE, value,
                         range[0], range[1], &options, &curve);
  mx_end_listening();
  mx_must(status);
  mx_keep(MX_CURVE, curve);
  return curve_struct(curve, structure);
}

/* (model, responses, options) */
mxArray* mex_backbone(const mxArray** arguments) {
  const microslip_structure* structure = mx_structure_of(arguments[0]);
  const microslip_frf_options options = options_of(arguments[2]);
  const char* point = point_of(arguments[2]);
  size_t mode = 1;
  size_t count;
  const double* responses = mx_numbers(arguments[1], "responses", &count);
  microslip_curve* curve = NULL;
  microslip_status status;
  whole(arguments[2], "Mode", &mode);
  mx_require(mode >= 1, "Mode", "be 1 or more");
  mx_begin_listening();
  status = microslip_backbone(structure, point, mode - 1, count, responses, &options, &curve);
  mx_end_listening();
  mx_must(status);
  mx_keep(MX_CURVE, curve);
  return curve_struct(curve, structure);
}
