/* SPDX-License-Identifier: MIT */
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "mex_commands.h"

/* A number of a part, and where it is kept. */
typedef struct part_number {
  const char* field;
  size_t offset;
} part_number;

/* The name of a kind of part in joint.json, and its fields. */
typedef struct part_form {
  const char* type;
  microslip_part_kind kind;
  part_number numbers[5]; /* ends with NULL */
  const char* values;     /* beside slip_force_N; NULL where it has no arrays */
} part_form;

static const part_form forms[] = {
    {"uniform",
     MICROSLIP_PART_UNIFORM,
     {{"from_N", offsetof(microslip_part, from)},
      {"to_N", offsetof(microslip_part, to)},
      {"weight", offsetof(microslip_part, weight)},
      {NULL, 0}},
     NULL},
    {"power_law",
     MICROSLIP_PART_POWER_LAW,
     {{"coefficient", offsetof(microslip_part, coefficient)},
      {"exponent", offsetof(microslip_part, exponent)},
      {"from_N", offsetof(microslip_part, from)},
      {"to_N", offsetof(microslip_part, to)},
      {NULL, 0}},
     NULL},
    {"piecewise_linear", MICROSLIP_PART_PIECEWISE_LINEAR, {{NULL, 0}}, "density_per_N"},
    {"atoms", MICROSLIP_PART_ATOMS, {{NULL, 0}}, "weight"},
    {"four_parameter",
     MICROSLIP_PART_FOUR_PARAMETER,
     {{"macroslip_force_N", offsetof(microslip_part, macroslip_force)},
      {"chi", offsetof(microslip_part, chi)},
      {"beta", offsetof(microslip_part, beta)},
      {NULL, 0}},
     NULL},
};
enum { form_count = sizeof forms / sizeof forms[0] };

static double* number_in(microslip_part* part, size_t offset) {
  return (double*)((char*)part + offset);
}

static const part_form* form_of(const char* type, const char* name) {
  size_t i;
  for (i = 0; i < form_count; ++i) {
    if (strcmp(type, forms[i].type) == 0) return &forms[i];
  }
  mx_fail("input",
          "%s.type = '%s'; must be uniform, power_law, piecewise_linear, atoms or four_parameter",
          name, type);
  return NULL;
}

static void check_fields(const mxArray* item, const part_form* form, const char* name) {
  const char* known[8];
  size_t n = 0;
  size_t i;
  known[n++] = "type";
  for (i = 0; form->numbers[i].field != NULL; ++i) known[n++] = form->numbers[i].field;
  if (form->values != NULL) {
    known[n++] = "slip_force_N";
    known[n++] = form->values;
  }
  known[n] = NULL;
  mx_struct(item, name, known);
}

static void read_part(const mxArray* item, const char* name, microslip_part* part) {
  static const char* const any[] = {
      "type", "from_N", "to_N",         "weight",        "coefficient",       "exponent",
      "chi",  "beta",   "slip_force_N", "density_per_N", "macroslip_force_N", NULL};
  const part_form* form;
  size_t i;
  mx_struct(item, name, any);
  form = form_of(mx_text(mx_needed(item, "type", name), mx_name(name, "type")), name);
  check_fields(item, form, name);
  mx_must(microslip_part_defaults(part, sizeof *part));
  part->kind = form->kind;
  for (i = 0; form->numbers[i].field != NULL; ++i) {
    const char* field = form->numbers[i].field;
    *number_in(part, form->numbers[i].offset) =
        mx_number(mx_needed(item, field, name), mx_name(name, field));
  }
  if (form->values == NULL) return;
  part->slip_force = mx_numbers(mx_needed(item, "slip_force_N", name),
                                mx_name(name, "slip_force_N"), &part->count);
  part->value =
      mx_numbers_of(mx_needed(item, form->values, name), mx_name(name, form->values), part->count);
}

/* The message in the words of the struct: "parts[0].weight" is "density{1}.weight". */
static void must_be_joint(microslip_status status, const char* name) {
  const char* text = microslip_last_error();
  unsigned long index;
  int length = 0;
  if (status == MICROSLIP_INPUT && sscanf(text, "parts[%lu]%n", &index, &length) == 1 &&
      length > 0) {
    mx_fail("input", "%s.density{%lu}%s", name, index + 1, text + length);
  }
  mx_must(status);
}

static microslip_joint* joint_of_parts(double stiffness, const mxArray* density, const char* name) {
  const char* list = mx_name(name, "density");
  const size_t count = mx_count_of(density, list);
  microslip_part* parts = (microslip_part*)mxCalloc(count + 1, sizeof *parts);
  microslip_joint* joint = NULL;
  size_t i;
  for (i = 0; i < count; ++i) read_part(mx_item(density, i), mx_item_name(list, i), &parts[i]);
  must_be_joint(microslip_joint_create(stiffness, parts, count, &joint), name);
  mx_keep(MX_JOINT, joint);
  return joint;
}

static int same_values(const double* one, const double* other, size_t count) {
  return count == 0 || memcmp(one, other, count * sizeof(double)) == 0;
}

static int same_part(const microslip_part* one, const microslip_part* other) {
  return one->kind == other->kind && one->from == other->from && one->to == other->to &&
         one->weight == other->weight && one->coefficient == other->coefficient &&
         one->exponent == other->exponent && one->macroslip_force == other->macroslip_force &&
         one->chi == other->chi && one->beta == other->beta && one->count == other->count &&
         same_values(one->slip_force, other->slip_force, one->count) &&
         same_values(one->value, other->value, one->count);
}

static void get_part(const microslip_joint* joint, size_t index, microslip_part* part) {
  mx_must(microslip_part_defaults(part, sizeof *part));
  mx_must(microslip_joint_part(joint, index, part));
}

static int same_joint(const microslip_joint* one, const microslip_joint* other) {
  double k[2];
  size_t count[2];
  size_t i;
  mx_must(microslip_joint_stiffness(one, &k[0]));
  mx_must(microslip_joint_stiffness(other, &k[1]));
  mx_must(microslip_joint_part_count(one, &count[0]));
  mx_must(microslip_joint_part_count(other, &count[1]));
  if (k[0] != k[1] || count[0] != count[1]) return 0;
  for (i = 0; i < count[0]; ++i) {
    microslip_part part[2];
    get_part(one, i, &part[0]);
    get_part(other, i, &part[1]);
    if (!same_part(&part[0], &part[1])) return 0;
  }
  return 1;
}

microslip_joint* mx_joint_of(const mxArray* structure, const char* name) {
  static const char* const known[] = {
      "schema", "stiffness_N_per_m", "density", "provenance", "identification", "json", NULL};
  microslip_joint* joint;
  microslip_joint* recorded = NULL;
  const mxArray* json;
  mx_struct(structure, name, known);
  joint = joint_of_parts(mx_number(mx_needed(structure, "stiffness_N_per_m", name),
                                   mx_name(name, "stiffness_N_per_m")),
                         mx_needed(structure, "density", name), name);
  json = mx_optional(structure, "json");
  if (json == NULL) return joint;
  mx_must(microslip_joint_parse(mx_text(json, mx_name(name, "json")), &recorded));
  mx_keep(MX_JOINT, recorded);
  return same_joint(joint, recorded) ? recorded : joint;
}

static mxArray* part_struct(microslip_part* part) {
  mxArray* item = mx_new_struct();
  const part_form* form = forms;
  size_t i;
  while (form->kind != part->kind) ++form;
  mx_set_text(item, "type", form->type);
  for (i = 0; form->numbers[i].field != NULL; ++i) {
    mx_set_number(item, form->numbers[i].field, *number_in(part, form->numbers[i].offset));
  }
  if (form->values != NULL) {
    mx_set(item, "slip_force_N", mx_column(part->slip_force, part->count));
    mx_set(item, form->values, mx_column(part->value, part->count));
  }
  return item;
}

mxArray* mx_joint_struct(const microslip_joint* joint, int with_text) {
  mxArray* all = mx_new_struct();
  mxArray* density;
  double stiffness;
  size_t count;
  size_t i;
  mx_must(microslip_joint_stiffness(joint, &stiffness));
  mx_must(microslip_joint_part_count(joint, &count));
  density = mxCreateCellMatrix(1, count);
  for (i = 0; i < count; ++i) {
    microslip_part part;
    get_part(joint, i, &part);
    mxSetCell(density, i, part_struct(&part));
  }
  mx_set_text(all, "schema", "microslip.joint/1");
  mx_set_number(all, "stiffness_N_per_m", stiffness);
  mx_set(all, "density", density);
  if (with_text) {
    const char* text;
    mx_must(microslip_joint_text(joint, &text));
    mx_set_text(all, "json", text);
  }
  return all;
}

/* (stiffness, density) */
mxArray* mex_joint(const mxArray** arguments) {
  const double stiffness = mx_number(arguments[0], "stiffness");
  return mx_joint_struct(joint_of_parts(stiffness, arguments[1], "joint"), 0);
}

/* (path) */
mxArray* mex_read_joint(const mxArray** arguments) {
  microslip_joint* joint = NULL;
  mx_must(microslip_joint_read(mx_text(arguments[0], "path"), &joint));
  mx_keep(MX_JOINT, joint);
  return mx_joint_struct(joint, 1);
}

/* (joint, path) */
mxArray* mex_write_joint(const mxArray** arguments) {
  microslip_joint* joint = mx_joint_of(arguments[0], "joint");
  mx_must(microslip_joint_write(joint, mx_text(arguments[1], "path")));
  return NULL;
}

static mxArray* alike(const mxArray* array) {
  return mxCreateDoubleMatrix(mxGetM(array), mxGetN(array), mxREAL);
}

/* (joint, path): from virgin rest */
mxArray* mex_force(const mxArray** arguments) {
  const microslip_joint* joint = mx_joint_of(arguments[0], "joint");
  microslip_memory* memory = NULL;
  size_t count;
  const double* path = mx_numbers(arguments[1], "path", &count);
  mxArray* force = alike(arguments[1]);
  mx_must(microslip_memory_create(joint, &memory));
  mx_keep(MX_MEMORY, memory);
  mx_must(microslip_memory_march(memory, count, path, mxGetPr(force)));
  return force;
}

/* (name of the curve, joint, its argument) */
mxArray* mex_curve_of_joint(const mxArray** arguments) {
  typedef microslip_status (*curve)(const microslip_joint*, size_t, const double*, double*);
  static const struct {
    const char* name;
    curve of;
  } curves[] = {{"virgin_force", microslip_virgin_force},
                {"tangent_stiffness", microslip_tangent_stiffness},
                {"dissipation", microslip_dissipation},
                {"secant_stiffness", microslip_secant_stiffness},
                {"density", microslip_density}};
  const char* name = mx_text(arguments[0], "curve");
  const microslip_joint* joint = mx_joint_of(arguments[1], "joint");
  size_t count;
  size_t i;
  const double* at = mx_numbers(arguments[2], "values", &count);
  mxArray* result = alike(arguments[2]);
  for (i = 0; i < sizeof curves / sizeof curves[0]; ++i) {
    if (strcmp(name, curves[i].name) != 0) continue;
    mx_must(curves[i].of(joint, count, at, mxGetPr(result)));
    return result;
  }
  mx_fail("internal", "no curve '%s'", name);
  return NULL;
}
