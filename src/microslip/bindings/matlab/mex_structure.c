/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdio.h>

#include "mex_commands.h"

static microslip_model* begin_model(const mxArray* structure, size_t* modes) {
  static const char* const known[] = {"frequency_Hz", "damping_ratio", "loss_factor", "point",
                                      NULL};
  const mxArray* ratio;
  const mxArray* loss;
  const double* frequency;
  const double* given;
  double* eta;
  size_t count;
  size_t i;
  microslip_model* model = NULL;
  mx_struct(structure, "model.structure", known);
  frequency = mx_numbers(mx_needed(structure, "frequency_Hz", "model.structure"),
                         "model.structure.frequency_Hz", modes);
  ratio = mx_optional(structure, "damping_ratio");
  loss = mx_optional(structure, "loss_factor");
  mx_require((ratio == NULL) != (loss == NULL), "model.structure",
             "have damping_ratio or loss_factor, and not both");
  given = mx_numbers(ratio != NULL ? ratio : loss, "model.structure damping", &count);
  mx_require(count == 1 || count == *modes, "model.structure damping",
             "have one value, or one per mode");
  eta = (double*)mxCalloc(*modes + 1, sizeof(double));
  for (i = 0; i < *modes; ++i) eta[i] = (ratio != NULL ? 2.0 : 1.0) * given[count == 1 ? 0 : i];
  mx_must(microslip_model_create(*modes, frequency, eta,
                                 ratio != NULL ? MICROSLIP_VISCOUS : MICROSLIP_HYSTERETIC, &model));
  mx_keep(MX_MODEL, model);
  return model;
}

static void add_points(microslip_model* model, const mxArray* points, size_t modes) {
  static const char* const known[] = {"name", "shape", NULL};
  const char* list = "model.structure.point";
  const size_t count = mx_count_of(points, list);
  size_t i;
  for (i = 0; i < count; ++i) {
    const mxArray* point = mx_item(points, i);
    const char* name = mx_item_name(list, i);
    mx_struct(point, name, known);
    mx_must(microslip_model_add_point(
        model, mx_text(mx_needed(point, "name", name), mx_name(name, "name")), modes,
        mx_numbers_of(mx_needed(point, "shape", name), mx_name(name, "shape"), modes)));
  }
}

static void joint_number(const mxArray* joint, const char* field, const char* name, double* to) {
  const mxArray* value = mx_optional(joint, field);
  if (value != NULL) *to = mx_number(value, mx_name(name, field));
}

/* As in model.toml a joint without a name has that of its number, where there are several. */
static const char* joint_name(const mxArray* joint, size_t index, size_t count, const char* name) {
  char* made;
  if (mx_optional(joint, "name") != NULL)
    return mx_text(mx_optional(joint, "name"), mx_name(name, "name"));
  if (count == 1) return "joint";
  made = (char*)mxMalloc(32);
  snprintf(made, 32, "joint%lu", (unsigned long)index + 1);
  return made;
}

static microslip_joint* joint_in(const mxArray* item, const char* name) {
  const mxArray* joint = mx_optional(item, "joint");
  microslip_joint* read = NULL;
  if (joint != NULL) return mx_joint_of(joint, mx_name(name, "joint"));
  mx_must(
      microslip_joint_read(mx_text(mx_needed(item, "file", name), mx_name(name, "file")), &read));
  mx_keep(MX_JOINT, read);
  return read;
}

static void add_joints(microslip_model* model, const mxArray* joints, size_t modes) {
  static const char* const known[] = {"name",
                                      "joint",
                                      "file",
                                      "shape",
                                      "spring_in_modes_N_per_m",
                                      "series_compliance_m_per_N",
                                      "linear_damping_J_per_m2",
                                      NULL};
  const size_t count = mx_count_of(joints, "model.joint");
  size_t i;
  for (i = 0; i < count; ++i) {
    const mxArray* item = mx_item(joints, i);
    const char* name = mx_item_name("model.joint", i);
    microslip_joint_options options;
    mx_struct(item, name, known);
    mx_must(microslip_joint_options_defaults(&options, sizeof options));
    joint_number(item, "spring_in_modes_N_per_m", name, &options.spring_in_modes);
    joint_number(item, "series_compliance_m_per_N", name, &options.series_compliance);
    joint_number(item, "linear_damping_J_per_m2", name, &options.linear_damping);
    mx_must(microslip_model_add_joint(
        model, joint_name(item, i, count, name), joint_in(item, name), modes,
        mx_numbers_of(mx_needed(item, "shape", name), mx_name(name, "shape"), modes), &options));
  }
}

static void add_excitation(microslip_model* model, const mxArray* item, const char* name) {
  static const char* const known[] = {"point", "harmonics", "phase_rad", NULL};
  const mxArray* harmonics;
  const mxArray* phases;
  const double* amplitude;
  const double* phase = NULL;
  double* real;
  double* imaginary;
  size_t count;
  size_t i;
  const char* point;
  mx_struct(item, name, known);
  point = mx_text(mx_needed(item, "point", name), mx_name(name, "point"));
  harmonics = mx_optional(item, "harmonics");
  phases = mx_optional(item, "phase_rad");
  if (harmonics == NULL) {
    mx_must(microslip_model_add_excitation(model, point, 1, NULL, NULL));
    return;
  }
  amplitude = mx_numbers(harmonics, mx_name(name, "harmonics"), &count);
  if (phases != NULL) phase = mx_numbers_of(phases, mx_name(name, "phase_rad"), count);
  real = (double*)mxCalloc(count + 1, sizeof(double));
  imaginary = (double*)mxCalloc(count + 1, sizeof(double));
  for (i = 0; i < count; ++i) {
    real[i] = amplitude[i] * (phase == NULL ? 1.0 : cos(phase[i]));
    imaginary[i] = phase == NULL ? 0.0 : amplitude[i] * sin(phase[i]);
  }
  mx_must(microslip_model_add_excitation(model, point, count, real, imaginary));
}

static void add_loads(microslip_model* model, const mxArray* loads) {
  static const char* const known[] = {"point", "force_N", NULL};
  const size_t count = mx_count_of(loads, "model.static_load");
  size_t i;
  for (i = 0; i < count; ++i) {
    const mxArray* item = mx_item(loads, i);
    const char* name = mx_item_name("model.static_load", i);
    mx_struct(item, name, known);
    mx_must(microslip_model_add_static_load(
        model, mx_text(mx_needed(item, "point", name), mx_name(name, "point")),
        mx_number(mx_needed(item, "force_N", name), mx_name(name, "force_N"))));
  }
}

microslip_structure* mx_structure_of(const mxArray* from) {
  static const char* const known[] = {"schema",     "structure",   "joint",
                                      "excitation", "static_load", NULL};
  microslip_structure* structure = NULL;
  microslip_model* model;
  const mxArray* modes;
  const mxArray* excitations;
  size_t size;
  size_t i;
  if (mxIsChar(from)) {
    mx_must(microslip_structure_read(mx_text(from, "model"), &structure));
    mx_keep(MX_STRUCTURE, structure);
    return structure;
  }
  mx_struct(from, "model", known);
  modes = mx_needed(from, "structure", "model");
  model = begin_model(modes, &size);
  add_points(model, mx_optional(modes, "point"), size);
  add_joints(model, mx_optional(from, "joint"), size);
  excitations = mx_needed(from, "excitation", "model");
  for (i = 0; i < mx_count_of(excitations, "model.excitation"); ++i) {
    add_excitation(model, mx_item(excitations, i), mx_item_name("model.excitation", i));
  }
  add_loads(model, mx_optional(from, "static_load"));
  mx_must(microslip_structure_create(model, &structure));
  mx_keep(MX_STRUCTURE, structure);
  return structure;
}
