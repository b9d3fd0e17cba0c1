/* SPDX-License-Identifier: MIT */
/* An Iwan joint inside of someone's implicit integrator: a mass on a spring and a damper, with a joint to
 * the wall beside them,
 *
 *     m x'' + c x' + k x + F(x) = f(t),
 *
 * by Newmark's rule of average acceleration [N. M. Newmark, J. Eng. Mech. Div. 85 (1959) 67], each step
 * by Newton's method. The joint is asked at each iteration (trial) and moved once a step (advance).
 *
 * Usage: newmark [FILE.csv]; the file gets time, force and displacement of each step. */
#include <math.h>
#include <microslip.h>
#include <stdio.h>
#include <stdlib.h>

static const double kMass = 1.0;      /* kg */
static const double kDamper = 0.01;   /* N s/m */
static const double kSpring = 0.75;   /* N/m */
static const double kAmplitude = 0.1; /* of the force, N */
static const double kPeriod = 6.8;    /* of the force, s: near resonance */
static const int kPeriods = 10;
static const int kStepsPerPeriod = 2000;

/* State of the integrator before the step. */
typedef struct state {
  double time, x, v, a, force;
} state;

/* Where the energy went, J. */
typedef struct energies {
  double input, damper, joint;
} energies;

static void must(microslip_status status) {
  if (status == MICROSLIP_OK) return;
  fprintf(stderr, "microslip: %s\n", microslip_last_error());
  exit(1);
}

/* Segalman's four parameters. */
static microslip_joint* make_joint(void) {
  microslip_part part;
  microslip_joint* joint;
  must(microslip_part_defaults(&part, sizeof part));
  part.kind = MICROSLIP_PART_FOUR_PARAMETER;
  part.macroslip_force = 0.2; /* N */
  part.chi = -0.5;
  part.beta = 0.0;
  must(microslip_joint_create(0.25, &part, 1, &joint)); /* N/m */
  return joint;
}

static double force_at(double time) {
  return kAmplitude * sin(2.0 * 3.14159265358979324 * time / kPeriod);
}

/* The end of a step of h: x by Newton's method on the residual of the equation of motion. */
static state solve(const microslip_memory* memory, const state* s, double h) {
  state n = *s;
  int i;
  n.time = s->time + h;
  n.force = force_at(n.time);
  for (i = 0; i < 50; ++i) {
    double f, tangent, residual, change;
    n.a = 4.0 * (n.x - s->x) / (h * h) - 4.0 * s->v / h - s->a;
    n.v = 2.0 * (n.x - s->x) / h - s->v;
    must(microslip_memory_trial(memory, n.x, &f,
                                &tangent)); /* asks, and leaves the joint as it is */
    residual = kMass * n.a + kDamper * n.v + kSpring * n.x + f - n.force;
    change = residual / (4.0 * kMass / (h * h) + 2.0 * kDamper / h + kSpring + tangent);
    if (fabs(change) <= 1e-14) return n;
    n.x -= change;
  }
  fprintf(stderr, "no equilibrium at %g s\n", n.time);
  exit(1);
}

/* Takes the step: the joint moves, and its loss over the step is added up. */
static void commit(microslip_memory* memory, const state* s, const state* n, energies* e) {
  double lost;
  must(microslip_memory_dissipation(memory, n->x, &lost));
  must(microslip_memory_advance(memory, n->x, NULL));
  e->joint += lost;
  e->input += 0.5 * (s->force + n->force) * (n->x - s->x);
  e->damper += kDamper * 0.5 * (s->v + n->v) * (n->x - s->x);
}

static void fail_on_file(const char* path) {
  perror(path);
  exit(1);
}

int main(int argc, char** argv) {
  const double h = kPeriod / kStepsPerPeriod;
  FILE* table = argc > 1 ? fopen(argv[1], "w") : NULL;
  microslip_joint* joint = make_joint();
  microslip_memory* memory;
  state s = {0.0, 0.0, 0.0, 0.0, 0.0};
  energies e = {0.0, 0.0, 0.0};
  double peak = 0.0, stored, final;
  int i;
  if (argc > 1 && table == NULL) fail_on_file(argv[1]);
  must(microslip_memory_create(joint, &memory));
  microslip_joint_destroy(joint); /* the memory holds what it needs */
  if (table != NULL) fprintf(table, "time [s],force [N],displacement [m]\n0,0,0\n");
  for (i = 1; i <= kPeriods * kStepsPerPeriod; ++i) {
    const state n = solve(memory, &s, h);
    commit(memory, &s, &n, &e);
    s = n;
    s.time = i * h; /* no sum of roundings */
    if (fabs(s.x) > peak) peak = fabs(s.x);
    if (table != NULL) fprintf(table, "%.17g,%.17g,%.17g\n", s.time, s.force, s.x);
  }
  if (table != NULL && fclose(table) != 0) fail_on_file(argv[1]);
  must(microslip_memory_stored_energy(memory, &stored));
  microslip_memory_destroy(memory);
  final = 0.5 * kMass * s.v * s.v + 0.5 * kSpring * s.x * s.x + stored;
  printf("largest displacement  %.6f m\n", peak);
  printf("work of the force     %.6f J\n", e.input);
  printf("lost in the joint     %.6f J\n", e.joint);
  printf("lost in the damper    %.6f J\n", e.damper);
  printf("energy at the end     %.6f J\n", final);
  printf("imbalance             %.1e of the work\n",
         fabs(e.input - e.joint - e.damper - final) / e.input);
  return 0;
}
