/* SPDX-License-Identifier: LGPL-2.1-or-later */
/* One wheel for programs that pass plain arrays: Fortran (wheel.f90), MATLAB. Add members as you need them. */
#include "wheel.h"

#include <rollfem/rollfem.h>
#include <stdio.h>

void* wheel_create(int side, double friction) {
  char message[512];
  rollfem_definition definition = {.struct_size = sizeof definition};
  rollfem_defaults(&definition, ROLLFEM_M_N);
  definition.side = side == 0 ? ROLLFEM_LEFT : ROLLFEM_RIGHT;
  definition.friction_coefficient = friction;
  void* pair = rollfem_create(&definition, message, sizeof message);
  if (pair == NULL) fprintf(stderr, "%s\n", message);
  return pair;
}

int wheel_force(void* pair, const double* motion, double* force) {
  char message[512];
  rollfem_state state = {.struct_size = sizeof state, .lateral_shift = motion[0], .yaw = motion[1],
                         .forward_speed = motion[2], .rotation_speed = motion[3], .vertical_force = motion[4]};
  rollfem_result result = {.struct_size = sizeof result};
  rollfem_status status = rollfem_solve(pair, &state, &result, message, sizeof message);
  if (status != ROLLFEM_OK) fprintf(stderr, "%s\n", message);
  for (int k = 0; k < 3; ++k) force[k] = result.force[k];
  return status;
}
