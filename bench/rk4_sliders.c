/* SPDX-License-Identifier: MIT */
#include "rk4_sliders.h"

#include <stdlib.h>

/* Sum of kappa (x - z), the sliders dragged along to x: play operators. They stay where they are, at
 * the start of the step, from which each of its stages goes. */
static double trial_force(size_t n, const double* restrict kappa, const double* restrict slip,
                          const double* restrict z, double x) {
  double lanes[RK4_LANES] = {0.0};
  for (size_t i = 0; i < n; i += RK4_LANES) {
    for (size_t j = 0; j < RK4_LANES; ++j) {
      double stretch = x - z[i + j];
      const double most = slip[i + j];
      stretch = stretch > most ? most : stretch;
      stretch = stretch < -most ? -most : stretch;
      lanes[j] += kappa[i + j] * stretch;
    }
  }
  double sum = 0.0;
  for (size_t j = 0; j < RK4_LANES; ++j) sum += lanes[j];
  return sum;
}

/* The same, and the sliders go there. */
static double move(size_t n, const double* restrict kappa, const double* restrict slip,
                   double* restrict z, double x) {
  double lanes[RK4_LANES] = {0.0};
  for (size_t i = 0; i < n; i += RK4_LANES) {
    for (size_t j = 0; j < RK4_LANES; ++j) {
      double stretch = x - z[i + j];
      const double most = slip[i + j];
      stretch = stretch > most ? most : stretch;
      stretch = stretch < -most ? -most : stretch;
      z[i + j] = x - stretch;
      lanes[j] += kappa[i + j] * stretch;
    }
  }
  double sum = 0.0;
  for (size_t j = 0; j < RK4_LANES; ++j) sum += lanes[j];
  return sum;
}

/* Modal accelerations at (q, v); `moves`: at the end of a step, the sliders go there. */
static void accelerate(const struct rk4_structure* s, const double* restrict q,
                       const double* restrict v, double force, int moves, double* restrict z,
                       double* restrict a) {
  const size_t m = s->modes;
  for (size_t i = 0; i < m; ++i) {
    a[i] = s->drive[i] * force - s->damping[i] * v[i] - s->stiffness[i] * q[i];
  }
  for (size_t j = 0; j < s->joints; ++j) {
    const double* restrict shape = s->shapes + j * m;
    const size_t first = j * s->elements;
    double x = 0.0;
    for (size_t i = 0; i < m; ++i) x += shape[i] * q[i];
    double f = s->elastic[j] * x;
    if (moves) {
      f += move(s->elements, s->kappa + first, s->slip + first, z + first, x);
    } else {
      f += trial_force(s->elements, s->kappa + first, s->slip + first, z + first, x);
    }
    for (size_t i = 0; i < m; ++i) a[i] -= shape[i] * f;
  }
}

int RK4_MARCH(const struct rk4_structure* s, const double* force, size_t samples, double spacing,
              size_t steps, double* displacement) {
  const size_t m = s->modes;
  double* memory = calloc(8 * m + s->joints * s->elements, sizeof *memory);
  if (memory == NULL) return -1;
  double* restrict q = memory;
  double* restrict v = q + m;
  double* restrict q_stage = v + m;
  double* restrict v_stage = q_stage + m;
  double* restrict a1 = v_stage + m;
  double* restrict a2 = a1 + m;
  double* restrict a3 = a2 + m;
  double* restrict a4 = a3 + m;
  double* restrict z = a4 + m;
  const double h = spacing / (double)steps;
  displacement[0] = 0.0;
  /* The first stage of a step is where the one before ended. */
  accelerate(s, q, v, force[0], 1, z, a1);
  for (size_t k = 1; k < samples; ++k) {
    const double rise = (force[k] - force[k - 1]) / (double)steps;
    for (size_t step = 0; step < steps; ++step) {
      const double f = force[k - 1] + rise * (double)step;
      for (size_t i = 0; i < m; ++i) {
        q_stage[i] = q[i] + 0.5 * h * v[i];
        v_stage[i] = v[i] + 0.5 * h * a1[i];
      }
      accelerate(s, q_stage, v_stage, f + 0.5 * rise, 0, z, a2);
      for (size_t i = 0; i < m; ++i) {
        q_stage[i] += 0.25 * h * h * a1[i];
        v_stage[i] = v[i] + 0.5 * h * a2[i];
      }
      accelerate(s, q_stage, v_stage, f + 0.5 * rise, 0, z, a3);
      for (size_t i = 0; i < m; ++i) {
        q_stage[i] = q[i] + h * v[i] + 0.5 * h * h * a2[i];
        v_stage[i] = v[i] + h * a3[i];
      }
      accelerate(s, q_stage, v_stage, f + rise, 0, z, a4);
      for (size_t i = 0; i < m; ++i) {
        q[i] += h * v[i] + h * h / 6.0 * (a1[i] + a2[i] + a3[i]);
        v[i] += h / 6.0 * (a1[i] + 2.0 * (a2[i] + a3[i]) + a4[i]);
      }
      accelerate(s, q, v, f + rise, 1, z, a1);
    }
    double w = 0.0;
    for (size_t i = 0; i < m; ++i) w += s->drive[i] * q[i];
    displacement[k] = w;
  }
  free(memory);
  return 0;
}
