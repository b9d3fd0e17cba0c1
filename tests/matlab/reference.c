/* SPDX-License-Identifier: MIT */
/* Writes what the C interface computes as raw doubles, one file a quantity, for same_bits_test.m.
 * Usage: reference EXAMPLES FOLDER */
#include <math.h>
#include <microslip.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char* folder;

static void must(microslip_status status) {
  if (status == MICROSLIP_OK) return;
  fprintf(stderr, "%s\n", microslip_last_error());
  exit(1);
}

static void put(const char* name, const double* values, size_t count) {
  char path[4096];
  FILE* file;
  snprintf(path, sizeof path, "%s/%s.bin", folder, name);
  file = fopen(path, "wb");
  if (file == NULL || fwrite(values, sizeof(double), count, file) != count || fclose(file) != 0)
    exit(1);
}

static void joints(void) {
  static const double knots[] = {0.0, 5.0, 12.0}, density[] = {0.01, 0.03, 0.0};
  static const double atoms[] = {9.0, 3.0}, weights[] = {0.1, 0.2};
  microslip_part parts[4];
  microslip_joint* joint;
  microslip_memory* memory;
  double x[500], f[500];
  int i;
  for (i = 0; i < 4; ++i) must(microslip_part_defaults(&parts[i], sizeof parts[i]));
  parts[0].kind = MICROSLIP_PART_UNIFORM;
  parts[0].from = 1.0;
  parts[0].to = 4.0;
  parts[0].weight = 0.1;
  parts[1].kind = MICROSLIP_PART_POWER_LAW;
  parts[1].coefficient = 0.02;
  parts[1].exponent = -0.5;
  parts[1].to = 10.0;
  parts[2].kind = MICROSLIP_PART_PIECEWISE_LINEAR;
  parts[2].count = 3;
  parts[2].slip_force = knots;
  parts[2].value = density;
  parts[3].kind = MICROSLIP_PART_ATOMS;
  parts[3].count = 2;
  parts[3].slip_force = atoms;
  parts[3].value = weights;
  for (i = 0; i < 500; ++i) x[i] = 1e-4 * sin(0.11 * i) * sin(0.013 * i) + 2e-5 * sin(1.7 * i);
  must(microslip_joint_create(1.7e5, parts, 4, &joint));
  must(microslip_memory_create(joint, &memory));
  must(microslip_memory_march(memory, 500, x, f));
  put("path", x, 500);
  put("force", f, 500);
  for (i = 0; i < 500; ++i) x[i] = fabs(x[i]);
  must(microslip_dissipation(joint, 500, x, f));
  put("dissipation", f, 500);
  must(microslip_secant_stiffness(joint, 500, x, f));
  put("secant_stiffness", f, 500);
  microslip_memory_destroy(memory);
  microslip_joint_destroy(joint);
}

static void put_found(const char* name, const microslip_identification* found,
                      microslip_identified_values what) {
  const double* values;
  size_t count;
  must(microslip_identification_values(found, what, &values, &count));
  put(name, values, count);
}

static void identification(void) {
  double amplitude[30], dissipation[30], std[30];
  microslip_levels* levels;
  microslip_identify_options options;
  microslip_identification* found;
  int i;
  for (i = 0; i < 30; ++i) {
    amplitude[i] = 4e-6 * (i + 1);
    dissipation[i] = 3e10 * pow(amplitude[i], 2.9) * (1.0 + 0.02 * sin(7.0 * i));
    std[i] = 0.02 * dissipation[i];
  }
  put("amplitude", amplitude, 30);
  put("level_dissipation", dissipation, 30);
  put("level_std", std, 30);
  must(microslip_levels_create(30, amplitude, dissipation, &levels));
  must(microslip_levels_set(levels, MICROSLIP_LEVEL_DISSIPATION_STD, 30, std));
  must(microslip_identify_options_defaults(&options, sizeof options));
  options.stiffness = 1e6;
  options.bands = 40;
  options.seed = 7;
  must(microslip_identify(levels, &options, &found));
  put_found("slip_force", found, MICROSLIP_IDENTIFIED_SLIP_FORCE);
  put_found("density", found, MICROSLIP_IDENTIFIED_DENSITY);
  put_found("lower", found, MICROSLIP_IDENTIFIED_LOWER);
  put_found("upper", found, MICROSLIP_IDENTIFIED_UPPER);
  microslip_identification_destroy(found);
  microslip_levels_destroy(levels);
}

static void put_column(const char* name, const microslip_curve* curve,
                       microslip_curve_values_of what) {
  const double* values;
  size_t count;
  must(microslip_curve_values(curve, what, &values, &count));
  put(name, values, count);
}

static void predictions(const char* examples) {
  char path[4096];
  microslip_structure* structure;
  microslip_curve* curve;
  microslip_marched* marched;
  double time[401], force[401];
  const double* loads[1];
  const double responses[] = {1e-3, 2e-3};
  const double* values;
  size_t count;
  int i;
  snprintf(path, sizeof path, "%s/two_joints/model.toml", examples);
  must(microslip_structure_read(path, &structure));
  must(microslip_frf(structure, "second", MICROSLIP_KEEP_FORCE, 2.0, 14.0, 20.0, NULL, &curve));
  put_column("frequency", curve, MICROSLIP_CURVE_FREQUENCY);
  put_column("displacement", curve, MICROSLIP_CURVE_DISPLACEMENT);
  put_column("real", curve, MICROSLIP_CURVE_REAL);
  put_column("imaginary", curve, MICROSLIP_CURVE_IMAGINARY);
  microslip_curve_destroy(curve);
  must(microslip_backbone(structure, "second", 0, 2, responses, NULL, &curve));
  put_column("backbone", curve, MICROSLIP_CURVE_DAMPING_RATIO);
  microslip_curve_destroy(curve);
  for (i = 0; i <= 400; ++i) {
    time[i] = 1e-3 * i;
    force[i] = 30.0 * sin(100.0 * time[i]);
  }
  put("time", time, 401);
  put("load", force, 401);
  loads[0] = force;
  must(microslip_march(structure, 401, time, 1, NULL, loads, NULL, &marched));
  must(microslip_marched_point(marched, 1, MICROSLIP_ACCELERATION, &values, &count));
  put("acceleration", values, count);
  must(microslip_marched_joint(marched, 0, MICROSLIP_MARCHED_JOINT_FORCE, &values, &count));
  put("joint_force", values, count);
  microslip_marched_destroy(marched);
  microslip_structure_destroy(structure);
}

int main(int argc, char** argv) {
  if (argc != 3) return 1;
  folder = argv[2];
  joints();
  identification();
  predictions(argv[1]);
  return 0;
}
