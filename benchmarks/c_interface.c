/* What a call of rollfem_solve costs and how far it is off: S1002 on 60E1, both wheels at shifts of
   -4 to 10 mm, against 48 elements across. Milliseconds are of CPU, the best of five calls;
   allocations are those of a call after the first. Call: benchmark_c_interface [ELEMENTS_ACROSS] */
#define _GNU_SOURCE
#include <math.h>
#include <rollfem/rollfem.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { FINE = 48, REPEATS = 5 };

static long allocations, bytes;

extern void* __libc_malloc(size_t size);
void* malloc(size_t size) {
  ++allocations;
  bytes += (long)size;
  return __libc_malloc(size);
}

static double cpu_seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static rollfem_pair* make(int side, int across) {
  char message[512];
  rollfem_definition definition;
  rollfem_defaults(&definition, ROLLFEM_MM_N);
  definition.side = side == 0 ? ROLLFEM_LEFT : ROLLFEM_RIGHT;
  definition.elements_across = across;
  rollfem_pair* pair = rollfem_create(&definition, message, sizeof message);
  if (pair == NULL) {
    fprintf(stderr, "%s\n", message);
    exit(2);
  }
  return pair;
}

static double larger(double a, double b) {
  return fabs(b) > a ? fabs(b) : a;
}

int main(int count, char** words) {
  const int across = count > 1 ? atoi(words[1]) : 12;
  double force = 0.0, pressure = 0.0, ordinary = 0.0, area = 0.0, sum = 0.0, slowest = 0.0;
  int states = 0;
  printf("%8s %5s %8s %9s %9s %8s %8s %7s\n", "shift mm", "side", "patches", "Fx/mu N %",
         "Fy/mu N %", "p0 %", "area %", "ms");
  rollfem_pair *quick[2] = {make(0, across), make(1, across)},
               *fine[2] = {make(0, FINE), make(1, FINE)};
  for (double y = -4.0; y <= 10.0; y += 0.5)
    for (int side = 0; side < 2; ++side) {
      const rollfem_state state = {y,    0.0008 * y, -0.000025 * y * fabs(y),           20e3,
                                   30.0, 0.0,        20e3 / 460.0 * (1.0 + 0.0003 * y), 50e3};
      char message[512];
      rollfem_result exact, result;
      double least = 1e9;
      if (rollfem_solve(fine[side], &state, &exact, message, sizeof message) != ROLLFEM_OK) {
        printf("%8.1f %5s %s\n", y, side == 0 ? "left" : "right", message);
        continue;
      }
      for (int k = 0; k < REPEATS; ++k) {
        const double begin = cpu_seconds();
        allocations = bytes = 0;
        if (rollfem_solve(quick[side], &state, &result, message, sizeof message) != ROLLFEM_OK) {
          fprintf(stderr, "%s\n", message);
          return 1;
        }
        const double took = 1e3 * (cpu_seconds() - begin);
        if (took < least) least = took;
      }
      double normal = 0.0;
      for (int k = 0; k < exact.patches; ++k) normal += exact.patch[k].normal_force;
      const double fx = 100.0 * (result.force[0] - exact.force[0]) / (0.3 * normal);
      const double fy = 100.0 * (result.force[1] - exact.force[1]) / (0.3 * normal);
      const double p0 = 100.0 * (result.patch[0].max_pressure / exact.patch[0].max_pressure - 1.0);
      const double of_area = 100.0 * (result.patch[0].area / exact.patch[0].area - 1.0);
      printf("%8.1f %5s %8d %9.2f %9.2f %8.2f %8.2f %7.2f\n", y, side == 0 ? "left" : "right",
             exact.patches, fx, fy, p0, of_area, least);
      force = larger(larger(force, fx), fy);
      pressure = larger(pressure, p0);
      if (fabs(y) > 1.0) ordinary = larger(ordinary, p0);
      area = larger(area, of_area);
      sum += least;
      slowest = larger(slowest, least);
      ++states;
    }
  printf(
      "%d states, %d elements across: forces within %.2f %% of mu N, p0 %.2f %% (%.2f %% beyond 1 "
      "mm), area %.2f %%\n",
      states, across, force, pressure, ordinary, area);
  printf("%.2f ms a call, %.2f the slowest; %ld allocations, %.1f MB in the last\n", sum / states,
         slowest, allocations, 1e-6 * (double)bytes);
  for (int side = 0; side < 2; ++side) {
    rollfem_destroy(quick[side]);
    rollfem_destroy(fine[side]);
  }
  return 0;
}
