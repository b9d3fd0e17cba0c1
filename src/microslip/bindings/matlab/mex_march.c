/* SPDX-License-Identifier: MIT */
#include "mex_commands.h"

static microslip_march_options options_of(const mxArray* from) {
  static const char* const known[] = {"Points",
                                      "Step",
                                      "Every",
                                      "EstimateError",
                                      "LargestError",
                                      "LargestImbalance",
                                      "StartDisplacement",
                                      "StartVelocity",
                                      NULL};
  microslip_march_options options;
  size_t count;
  mx_struct(from, "options", known);
  mx_must(microslip_march_options_defaults(&options, sizeof options));
  if (mx_optional(from, "Step") != NULL)
    options.step = mx_number(mx_optional(from, "Step"), "Step");
  if (mx_optional(from, "Every") != NULL)
    options.every = mx_whole(mx_optional(from, "Every"), "Every");
  if (mx_optional(from, "EstimateError") != NULL) {
    options.estimate_error = mx_number(mx_optional(from, "EstimateError"), "EstimateError") != 0.0;
  }
  if (mx_optional(from, "LargestError") != NULL) {
    options.largest_error = mx_number(mx_optional(from, "LargestError"), "LargestError");
  }
  if (mx_optional(from, "LargestImbalance") != NULL) {
    options.largest_imbalance =
        mx_number(mx_optional(from, "LargestImbalance"), "LargestImbalance");
  }
  if (mx_optional(from, "StartDisplacement") != NULL) {
    options.start_displacement = mx_numbers(mx_optional(from, "StartDisplacement"),
                                            "StartDisplacement", &options.start_modes);
  }
  if (mx_optional(from, "StartVelocity") != NULL) {
    options.start_velocity =
        mx_numbers(mx_optional(from, "StartVelocity"), "StartVelocity", &count);
    mx_require(options.start_displacement == NULL || options.start_modes == count, "StartVelocity",
               "have as many values as StartDisplacement");
    options.start_modes = count;
  }
  options.progress = mx_go_on;
  return options;
}

static mxArray* motion(const microslip_marched* marched, size_t point, microslip_response what) {
  const double* values;
  size_t count;
  mx_must(microslip_marched_point(marched, point, what, &values, &count));
  return mx_column(values, count);
}

static mxArray* points_of(const microslip_marched* marched, const microslip_structure* structure) {
  static const char* fields[] = {"name", "displacement_m", "velocity_m_per_s",
                                 "acceleration_m_per_s2"};
  mxArray* points;
  size_t count;
  size_t i;
  mx_must(microslip_structure_counts(structure, &count, NULL));
  points = mxCreateStructMatrix(count, count > 0 ? 1 : 0, 4, fields);
  for (i = 0; i < count; ++i) {
    const char* name;
    mx_must(microslip_structure_point(structure, i, &name));
    mxSetField(points, i, "name", mxCreateString(name));
    mxSetField(points, i, "displacement_m", motion(marched, i, MICROSLIP_DISPLACEMENT));
    mxSetField(points, i, "velocity_m_per_s", motion(marched, i, MICROSLIP_VELOCITY));
    mxSetField(points, i, "acceleration_m_per_s2", motion(marched, i, MICROSLIP_ACCELERATION));
  }
  return points;
}

static mxArray* joints_of(const microslip_marched* marched, const microslip_structure* structure) {
  static const char* fields[] = {"name", "displacement_m", "force_N"};
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
    mx_must(
        microslip_marched_joint(marched, i, MICROSLIP_MARCHED_JOINT_DISPLACEMENT, &values, &size));
    mxSetField(joints, i, "displacement_m", mx_column(values, size));
    mx_must(microslip_marched_joint(marched, i, MICROSLIP_MARCHED_JOINT_FORCE, &values, &size));
    mxSetField(joints, i, "force_N", mx_column(values, size));
  }
  return joints;
}

static void set_number(mxArray* to, const char* field, const microslip_marched* marched,
                       microslip_marched_number what) {
  double value;
  mx_must(microslip_marched_value(marched, what, &value));
  mx_set_number(to, field, value);
}

static mxArray* energy_of(const microslip_marched* marched) {
  mxArray* energy = mx_new_struct();
  set_number(energy, "initial_J", marched, MICROSLIP_MARCHED_INITIAL);
  set_number(energy, "input_J", marched, MICROSLIP_MARCHED_INPUT);
  set_number(energy, "kinetic_J", marched, MICROSLIP_MARCHED_KINETIC);
  set_number(energy, "elastic_J", marched, MICROSLIP_MARCHED_ELASTIC);
  set_number(energy, "linear_J", marched, MICROSLIP_MARCHED_LINEAR);
  set_number(energy, "joint_stored_J", marched, MICROSLIP_MARCHED_JOINT_STORED);
  set_number(energy, "joint_dissipation_J", marched, MICROSLIP_MARCHED_JOINT_DISSIPATION);
  set_number(energy, "joint_linear_J", marched, MICROSLIP_MARCHED_JOINT_LINEAR);
  set_number(energy, "imbalance", marched, MICROSLIP_MARCHED_IMBALANCE);
  return energy;
}

static microslip_status warning_of(const void* marched, size_t index, const char** code,
                                   const char** text) {
  return microslip_marched_warning(marched, index, code, text);
}

static void set_ending(mxArray* to, const microslip_marched* marched) {
  microslip_outcome outcome;
  outcome.struct_size = sizeof outcome;
  mx_must(microslip_marched_outcome(marched, &outcome));
  mx_set_ending(to, &outcome, marched, warning_of);
}

static mxArray* marched_struct(const microslip_marched* marched,
                               const microslip_structure* structure) {
  mxArray* result = mx_new_struct();
  const double* time;
  size_t count;
  mx_must(microslip_marched_time(marched, &time, &count));
  mx_set(result, "time_s", mx_column(time, count));
  mx_set(result, "points", points_of(marched, structure));
  mx_set(result, "joints", joints_of(marched, structure));
  mx_set(result, "energy", energy_of(marched));
  set_number(result, "reached_s", marched, MICROSLIP_MARCHED_REACHED);
  set_number(result, "error_estimate", marched, MICROSLIP_MARCHED_ERROR);
  set_ending(result, marched);
  return result;
}

/* (model, time, loads: one column each, options); options.Points names the places of the loads. */
mxArray* mex_march(const mxArray** arguments) {
  const microslip_structure* structure = mx_structure_of(arguments[0]);
  const microslip_march_options options = options_of(arguments[3]);
  const mxArray* points = mx_optional(arguments[3], "Points");
  size_t times;
  size_t values;
  size_t loads;
  size_t i;
  const double* time = mx_numbers(arguments[1], "time", &times);
  const double* force = mx_numbers(arguments[2], "force", &values);
  const double** columns;
  const char** places = NULL;
  microslip_marched* marched = NULL;
  microslip_status status;
  mx_require(values == 0 || (times > 0 && values % times == 0), "force",
             "have one value per time, in a column for each point");
  loads = values == 0 ? 0 : values / times;
  mx_require(points != NULL || loads <= 1, "Points", "name the point of each column of force");
  columns = (const double**)mxCalloc(loads + 1, sizeof *columns);
  for (i = 0; i < loads; ++i) columns[i] = force + i * times;
  if (points != NULL) {
    mx_require(mxIsCell(points) && mxGetNumberOfElements(points) == loads, "Points",
               "be a cell array of names, one per column of force");
    places = (const char**)mxCalloc(loads + 1, sizeof *places);
    for (i = 0; i < loads; ++i)
      places[i] = mx_text(mxGetCell(points, i), mx_item_name("Points", i));
  }
  mx_begin_listening();
  status = microslip_march(structure, times, time, loads, places, columns, &options, &marched);
  mx_end_listening();
  mx_must(status);
  mx_keep(MX_MARCHED, marched);
  return marched_struct(marched, structure);
}
