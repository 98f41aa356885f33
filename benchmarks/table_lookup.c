// SPDX-License-Identifier: LGPL-2.1-or-later
/* Cost of a look-up in a table of creep forces: at random places and creepages of a table over
   axis ratios or over lateral shifts, nanoseconds of CPU (the best of five rounds) and
   allocations. Call: benchmark_table_lookup TABLE FIRST LAST [shift], the ends of the first axis,
   a/b or mm */
#define _GNU_SOURCE
#include <math.h>
#include <rollfem/rollfem.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { LOOKUPS = 200000, ROUNDS = 5 };

static long allocations;

extern void* __libc_malloc(size_t size);
void* malloc(size_t size) {
  ++allocations;
  return __libc_malloc(size);
}

static double cpu_seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static double even(double low, double high) {
  return low + (high - low) * rand() / (double)RAND_MAX;
}

/* The sum of the forces over mu F_n, to keep the compiler from optimising the look-ups away. */
static double of_ellipse(const rollfem_table* table, double ratio) {
  char message[512];
  const rollfem_ellipse ellipse = {
      sizeof ellipse, 5.0 * sqrt(ratio), 5.0 / sqrt(ratio),  80e3, 15e3, even(-0.01, 0.01),
      even(-0.01, 0.01), even(-0.002, 0.002), 0.0};
  rollfem_creep_forces forces = {.struct_size = sizeof forces};
  if (rollfem_table_forces(table, &ellipse, &forces, message, sizeof message) != ROLLFEM_OK) {
    fprintf(stderr, "%s\n", message);
    exit(2);
  }
  return (forces.longitudinal_force + forces.lateral_force) / 15e3;
}

static double of_wheel(const rollfem_table* table, double shift) {
  char message[512];
  const rollfem_shifted_wheel wheel = {
      sizeof wheel, ROLLFEM_MM_N, shift, 0.0, even(-0.01, 0.01), even(-0.01, 0.01), even(-0.002, 0.002), 0.0, 0.0};
  rollfem_wheel_forces forces = {.struct_size = sizeof forces};
  if (rollfem_table_wheel_forces(table, &wheel, &forces, message, sizeof message) != ROLLFEM_OK) {
    fprintf(stderr, "%s\n", message);
    exit(2);
  }
  return (forces.longitudinal_force + forces.lateral_force) / forces.friction_bound;
}

int main(int count, char** words) {
  char message[512];
  if (count < 4) {
    fprintf(stderr, "call: benchmark_table_lookup TABLE FIRST LAST [shift]\n");
    return 2;
  }
  rollfem_table* table = rollfem_table_open(words[1], message, sizeof message);
  if (table == NULL) {
    fprintf(stderr, "%s\n", message);
    return 2;
  }
  const double first = atof(words[2]), last = atof(words[3]);
  double best = 1e9, sum = 0.0;
  allocations = 0;
  for (int round = 0; round < ROUNDS; ++round) {
    const double begin = cpu_seconds();
    for (int k = 0; k < LOOKUPS; ++k)
      sum += count > 4 ? of_wheel(table, even(first, last)) : of_ellipse(table, even(first, last));
    best = fmin(best, cpu_seconds() - begin);
  }
  printf("%.0f ns of CPU per look-up, %ld allocations in %d (mean of the forces %.3g)\n",
         1e9 * best / LOOKUPS, allocations, ROUNDS * LOOKUPS, sum / (ROUNDS * LOOKUPS));
  rollfem_table_close(table);
  return 0;
}
