/* SPDX-License-Identifier: MIT */
#ifndef MICROSLIP_BENCH_RK4_SLIDERS_H
#define MICROSLIP_BENCH_RK4_SLIDERS_H

#include <stddef.h>

/* What march() is measured against: the classical Runge-Kutta scheme of fourth order on the modes
 * of a structure, each joint a number of Jenkins elements side by side. Plain C. */

#ifdef __cplusplus
extern "C" {
#endif

/* Elements come in groups of this many, so that a loop over them has as many sums as the processor
 * keeps under way; a group is filled up with elements of no stiffness. */
#define RK4_LANES 16

struct rk4_structure {
  size_t modes;
  size_t joints;
  size_t elements;         /* of each joint, a multiple of RK4_LANES */
  const double* stiffness; /* omega_i^2, rad^2/s^2 */
  const double* damping;   /* eta_i omega_i, rad/s */
  const double* drive;     /* shape of the driven point, kg^-1/2 */
  const double* shapes;    /* of the joints, kg^-1/2; joints x modes */
  const double* kappa;     /* stiffness of each element, N/m; joints x elements */
  const double* slip;      /* stretch at which each slips, m; joints x elements */
  const double* elastic;   /* what never slips, N/m; one per joint */
};

/* From rest in equal steps, the force linear between the samples.
 * force, displacement  at the driven point, `samples` values each `spacing` seconds, N and m
 * steps                between two samples
 * Returns 0; -1 where there is no memory. */
typedef int rk4_marching(const struct rk4_structure* structure, const double* force, size_t samples,
                         double spacing, size_t steps, double* displacement);

rk4_marching rk4_march;        /* compiled as C is, -O3 */
rk4_marching rk4_march_native; /* with all that the processor has, sums in any order */

#ifdef __cplusplus
}
#endif

#endif
