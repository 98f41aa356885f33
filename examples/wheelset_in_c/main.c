// SPDX-License-Identifier: LGPL-2.1-or-later
/* A wheelset rolls through an S-curve. Both wheels are solved at every step, and the wheelset turns as their rolling
   radii make it (Klingel's kinematics); prints the trajectory, the patches and the creep forces.
   Call: wheelset_in_c [STEPS], of half a metre; prints a line every ten steps: s, shift, yaw, and for each wheel the
   number of patches and the forces along and across. */
#include <math.h>
#include <rollfem/rollfem.h>
#include <stdio.h>
#include <stdlib.h>

static const double speed = 20.0;    /* m/s */
static const double load = 50e3;     /* N on each wheel */
static const double radius = 0.460;  /* m */
static const double curve = 1500.0;  /* m, radius of both halves of the S */
static const double length = 100.0;  /* m, of the whole S */
static const double ds = 0.5;        /* m; the wheelset swings over some ten metres */

/* 1/m, first to the right; two half sines, so that the curvature has no jump. */
static double curvature(double s) {
  return sin(2.0 * 3.14159265358979 * s / length) / curve;
}

static rollfem_pair* make_pair(rollfem_side side) {
  char message[512];
  rollfem_definition definition = {.struct_size = sizeof definition};
  rollfem_defaults(&definition, ROLLFEM_M_N);
  definition.side = side;
  definition.rolling_radius = radius;
  rollfem_pair* pair = rollfem_create(&definition, message, sizeof message);
  if (pair == NULL) {
    fprintf(stderr, "%s\n", message);
    exit(2);
  }
  return pair;
}

int main(int count, char** words) {
  const int steps = count > 1 ? atoi(words[1]) : (int)(length / ds);
  rollfem_pair* wheel[2] = {make_pair(ROLLFEM_LEFT), make_pair(ROLLFEM_RIGHT)};
  double shift = 0.0, yaw = 0.0, turn = 0.0, largest = 0.0;
  printf("%8s %9s %9s %4s %9s %9s %4s %9s %9s\n", "s m", "shift mm", "yaw mrad", "left", "Fx N", "Fy N", "right",
         "Fx N", "Fy N");
  for (int k = 0; k < steps; ++k) {
    rollfem_result result[2] = {{.struct_size = sizeof *result}, {.struct_size = sizeof *result}};
    for (int side = 0; side < 2; ++side) {
      const rollfem_state state = {.struct_size = sizeof state,
                                   .lateral_shift = shift,
                                   .yaw = yaw,
                                   .forward_speed = speed,
                                   .lateral_velocity = speed * yaw,
                                   .yaw_rate = speed * turn,
                                   .rotation_speed = speed / radius,
                                   .vertical_force = load};
      char message[512];
      if (rollfem_solve(wheel[side], &state, &result[side], message, sizeof message) != ROLLFEM_OK) {
        fprintf(stderr, "at %g m: %s\n", k * ds, message);
        return 1;
      }
    }
    if (k % 10 == 0)
      printf("%8.2f %9.3f %9.3f %4d %9.0f %9.0f %4d %9.0f %9.0f\n", k * ds, 1e3 * shift, 1e3 * yaw, result[0].patch_count,
             result[0].force[0], result[0].force[1], result[1].patch_count, result[1].force[0], result[1].force[1]);
    /* The wheel on the larger radius runs further, so the wheelset turns away from it relative to the ground; its yaw
       is relative to the track, which turns too. */
    const rollfem_patch *left = &result[0].patch[0], *right = &result[1].patch[0];
    turn = (left->rolling_radius - right->rolling_radius) / (radius * (right->position[1] - left->position[1]));
    yaw += ds * (turn - curvature(k * ds));
    shift += ds * yaw;
    if (fabs(shift) > largest) largest = fabs(shift);
  }
  printf("largest shift %.3f mm\n", 1e3 * largest);
  for (int side = 0; side < 2; ++side) rollfem_destroy(wheel[side]);
  return 0;
}
