// SPDX-License-Identifier: LGPL-2.1-or-later
/* A multibody client that gives poses: a wheel comes down on a turning roller, bounces until its damper has settled it,
   and is spun up by the creep force until it turns with the roller's surface. No track and no gauge: the pose is that of
   the wheel in the coordinates of the roller's profile. Prints time, depth, forces and the slip, which
   is not 0 at the end: rolling freely, slip ahead and behind of the middle of the patch balance.
   Call: roller [SECONDS]. */
#include <rollfem/rollfem.h>
#include <stdio.h>
#include <stdlib.h>

static const double mass = 800.0;        /* kg, of the wheel and its part of the rig */
static const double inertia = 60.0;      /* kg m^2, of the wheel about its axle */
static const double weight = 30e3;       /* N, of the rig's ram */
static const double damping = 400e3;     /* N s/m */
static const double speed = 10.0;        /* m/s, of the roller's surface */
static const double radius = 0.460;      /* m, of the wheel */
static const double dt = 1e-4;           /* s */

int main(int count, char** words) {
  const double end = count > 1 ? atof(words[1]) : 0.05;
  char message[512];
  rollfem_definition definition = {.struct_size = sizeof definition};
  rollfem_defaults(&definition, ROLLFEM_M_N);
  definition.side = ROLLFEM_RIGHT;
  definition.gauge = 0.0; /* poses instead of a track */
  definition.rolling_radius = radius;
  definition.rail_rolling_radius = 0.5;
  rollfem_pair* pair = rollfem_create(&definition, message, sizeof message);
  if (pair == NULL) {
    fprintf(stderr, "%s\n", message);
    return 2;
  }
  double depth = -0.1e-3, sinking = 0.0; /* m below the touch, m/s down */
  double rotation = 0.999 * speed / radius; /* 1/s */
  double slip = 0.0;
  for (int k = 0; k * dt < end; ++k) {
    rollfem_result result = {.struct_size = sizeof result};
    const rollfem_state state = {.struct_size = sizeof state,
                                 .forward_speed = speed,
                                 .rotation_speed = rotation,
                                 .given = ROLLFEM_PENETRATION,
                                 .penetration = depth};
    if (rollfem_solve(pair, &state, &result, message, sizeof message) != ROLLFEM_OK) {
      fprintf(stderr, "at %g s: %s\n", k * dt, message);
      return 1;
    }
    slip = result.patch_count > 0 ? result.patch[0].longitudinal_creepage : slip;
    if (k % 25 == 0)
      printf("%8.4f s  depth %8.4f mm  load %8.0f N  F_x %8.1f N  slip %9.2e\n", k * dt, 1e3 * depth,
             -result.force[2], result.force[0], slip);
    /* Forces on the wheel, z down; semi-implicit Euler. */
    sinking += dt * (weight + result.force[2] - damping * sinking) / mass;
    depth += dt * sinking;
    rotation += dt * -result.force[0] * radius / inertia;
  }
  printf("it rolls freely at a slip of %.1e\n", slip);
  rollfem_destroy(pair);
  return 0;
}
