/* SPDX-License-Identifier: MIT */
#include <microslip.h>
#include <stdio.h>

int main(void) {
  const double x = 5e-5;
  double force = 0.0;
  microslip_part part;
  microslip_joint* joint = NULL;
  if (microslip_part_defaults(&part, sizeof part) != MICROSLIP_OK) return 1;
  part.kind = MICROSLIP_PART_UNIFORM; /* on [0, 10 N]: F = kx - (kx)^2/20 N */
  part.to = 10.0;
  part.weight = 1.0;
  if (microslip_joint_create(1e5, &part, 1, &joint) != MICROSLIP_OK) return 1;
  if (microslip_virgin_force(joint, 1, &x, &force) != MICROSLIP_OK) return 1;
  microslip_joint_destroy(joint);
  printf("microslip %s: %g N\n", microslip_version(), force);
  return 0;
}
