/* SPDX-License-Identifier: LGPL-2.1-or-later */
/* side: 0 left, 1 right. NULL if it failed. */
void* wheel_create(int side, double friction);

/* motion: shift m, yaw rad, speed m/s, rotation rad/s, vertical force N; force: x, y, z in the track frame, N. Returns 0
   if all is well. */
int wheel_force(void* pair, const double* motion, double* force);
