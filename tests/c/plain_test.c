/* SPDX-License-Identifier: MIT */
/* The header in C99, and a hundred thousand calls: nothing is left behind, as the sanitizers see. */
#include <math.h>
#include <microslip.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

static void check(int holds, const char* what) {
  if (holds) return;
  fprintf(stderr, "failed: %s; last error: %s\n", what, microslip_last_error());
  ++failures;
}

static microslip_joint* spring_with_slip(void) {
  microslip_part part;
  microslip_joint* joint = NULL;
  check(microslip_part_defaults(&part, sizeof part) == MICROSLIP_OK, "defaults of a part");
  part.kind = MICROSLIP_PART_UNIFORM;
  part.to = 10.0;
  part.weight = 1.0;
  check(microslip_joint_create(1e5, &part, 1, &joint) == MICROSLIP_OK, "a joint");
  return joint;
}

/* F = kx - (kx)^2/(2 to) of a uniform density on [0, to]. */
static void check_force(const microslip_joint* joint) {
  const double x = 5e-5;
  double force = 0.0;
  check(microslip_virgin_force(joint, 1, &x, &force) == MICROSLIP_OK, "a force");
  check(fabs(force - (5.0 - 25.0 / 20.0)) < 1e-14, "F = kx - (kx)^2/(2 to)");
}

static void check_many_calls(const microslip_joint* joint) {
  int i = 0;
  for (i = 0; i < 100000; ++i) {
    microslip_memory* memory = NULL;
    double force = 0.0;
    if (microslip_memory_create(joint, &memory) != MICROSLIP_OK) break;
    if (microslip_memory_advance(memory, 1e-5 * (i % 7), &force) != MICROSLIP_OK) break;
    /* Errors leave nothing behind either; under the sanitizers they take their time. */
    if (i % 100 == 0 && microslip_memory_advance(memory, NAN, &force) != MICROSLIP_INPUT) break;
    microslip_memory_destroy(memory);
  }
  check(i == 100000, "a hundred thousand memories");
}

static int stop(size_t done, size_t total, void* user) {
  (void)done;
  (void)total;
  ++*(int*)user;
  return 0;
}

static void check_cancelled(void) {
  double amplitude[30];
  double dissipation[30];
  int i = 0;
  int calls = 0;
  microslip_levels* levels = NULL;
  microslip_identification* found = NULL;
  microslip_identify_options options;
  for (i = 0; i < 30; ++i) {
    amplitude[i] = 1e-6 * (i + 1);
    dissipation[i] = 1e10 * pow(amplitude[i], 3.0);
  }
  check(microslip_levels_create(30, amplitude, dissipation, &levels) == MICROSLIP_OK, "levels");
  check(microslip_identify_options_defaults(&options, sizeof options) == MICROSLIP_OK, "defaults");
  options.stiffness = 1e5;
  options.bands = 20;
  options.progress = stop;
  options.user = &calls;
  check(microslip_identify(levels, &options, &found) == MICROSLIP_CANCELLED, "cancelled");
  check(found == NULL && calls == 1, "called once, and nothing left");
  microslip_levels_destroy(levels);
}

int main(void) {
  microslip_joint* joint = spring_with_slip();
  check(strcmp(microslip_version(), MICROSLIP_VERSION) == 0, "versions of header and library");
  check_force(joint);
  check_many_calls(joint);
  check_cancelled();
  microslip_joint_destroy(joint);
  if (failures == 0) puts("C99: all is well");
  return failures == 0 ? 0 : 1;
}
