// SPDX-License-Identifier: LGPL-2.1-or-later
/* Cost and error of a call of rollfem_solve against 48 elements across, for four sets of states of
   S1002 on 60E1: both wheels at shifts of -4 to 10 mm; the S-curve of examples/wheelset_in_c; random positions,
   motions and loads; the right wheel where its flange reaches the rail, with contacts in different planes that
   share the load and with conformal ones. Milliseconds are CPU time, the least of five calls;
   allocations are those of a call after the first.
   Call: benchmark_c_interface [ELEMENTS_ACROSS [all]]; `all` prints every state. */
#define _GNU_SOURCE
#include <math.h>
#include <rollfem/rollfem.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { FINE = 48, REPEATS = 5, MOST_STATES = 200 };

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

static int across = 12, tells_all = 0;
static rollfem_pair *quick[2], *fine[2];

static rollfem_pair* make(int side, int elements) {
  char message[512];
  rollfem_definition definition = {.struct_size = sizeof definition};
  rollfem_defaults(&definition, ROLLFEM_MM_N);
  definition.side = side == 0 ? ROLLFEM_LEFT : ROLLFEM_RIGHT;
  definition.elements_across = elements;
  rollfem_pair* pair = rollfem_create(&definition, message, sizeof message);
  if (pair == NULL) {
    fprintf(stderr, "%s\n", message);
    exit(2);
  }
  return pair;
}

/* At 20 m/s; mm, rad, mm/s, N. */
static rollfem_state state_of(double shift, double yaw, double roll, double lateral, double turn, double rotation,
                              double force) {
  return (rollfem_state){.struct_size = sizeof(rollfem_state),
                         .lateral_shift = shift,
                         .yaw = yaw,
                         .roll = roll,
                         .forward_speed = 20e3,
                         .lateral_velocity = lateral,
                         .yaw_rate = turn,
                         .rotation_speed = rotation,
                         .vertical_force = force};
}

/* Largest differences, and the cost of every call. */
typedef struct {
  int states;
  double force, moment, pressure, area;
  int sharp;    /* states with an error of p0 above 1 % */
  int unbarred; /* with an error of p0 above its bar */
  int several;  /* with several patches */
  double ms[MOST_STATES], allocations[MOST_STATES];
} tally;

static double larger(double a, double b) {
  return fabs(b) > a ? fabs(b) : a;
}

static int by_size(const void* a, const void* b) {
  const double difference = *(const double*)a - *(const double*)b;
  return difference > 0.0 ? 1 : difference < 0.0 ? -1 : 0;
}

/* Compares one state; returns 0 if there is no solution. */
static int take(int side, const rollfem_state* state, tally* sum, rollfem_result* result) {
  char message[512];
  rollfem_result exact = {.struct_size = sizeof exact};
  double least = 1e9;
  long most = 0;
  for (int k = 0; k < REPEATS; ++k) {
    const double begin = cpu_seconds();
    allocations = 0;
    if (rollfem_solve(quick[side], state, result, message, sizeof message) != ROLLFEM_OK) {
      if (tells_all) printf("%s\n", message);
      return 0;
    }
    most = allocations;
    least = fmin(least, 1e3 * (cpu_seconds() - begin));
  }
  if (rollfem_solve(fine[side], state, &exact, message, sizeof message) != ROLLFEM_OK) return 0;
  double normal = 0.0;
  for (int k = 0; k < exact.patch_count; ++k) normal += exact.patch[k].normal_force;
  const rollfem_patch *a = &result->patch[0], *b = &exact.patch[0];
  const double bound = 0.3 * normal, radius = 0.25 * (b->length + b->width);
  const double fx = 100.0 * (result->force[0] - exact.force[0]) / bound,
               fy = 100.0 * (result->force[1] - exact.force[1]) / bound,
               mz = 100.0 * (a->spin_moment - b->spin_moment) / (bound * radius),
               p0 = 100.0 * (a->max_pressure / b->max_pressure - 1.0),
               area = 100.0 * (a->area / b->area - 1.0);
  if (tells_all)
    printf("%8.3f %5s %8d %9.2f %9.2f %9.2f %8.2f %8.2f %7.2f %6ld\n", state->lateral_shift,
           side == 0 ? "left" : "right", exact.patch_count, fx, fy, mz, p0, area, least, most);
  sum->force = larger(larger(sum->force, fx), fy);
  sum->moment = larger(sum->moment, mz);
  sum->pressure = larger(sum->pressure, p0);
  sum->area = larger(sum->area, area);
  sum->sharp += fabs(p0) > 1.0;
  sum->unbarred += fabs(a->max_pressure - b->max_pressure) > a->max_pressure_bar;
  sum->several += result->patch_count > 1;
  sum->ms[sum->states] = least;
  sum->allocations[sum->states++] = (double)most;
  return 1;
}

static void tell(const char* what, tally* sum) {
  const int n = sum->states;
  double all = 0.0;
  int slow = 0;
  for (int k = 0; k < n; ++k) {
    all += sum->ms[k];
    slow += sum->ms[k] > 5.0;
  }
  qsort(sum->ms, (size_t)n, sizeof(double), by_size);
  qsort(sum->allocations, (size_t)n, sizeof(double), by_size);
  printf("%s: %d states, %d of several patches, %d elements across\n", what, n, sum->several, across);
  printf("  largest errors: forces %.2f %% of mu N, spin moment %.2f %% of mu N times the mean half axis, ", sum->force,
         sum->moment);
  printf("p0 %.1f %% (%d states by more than 1 %%, %d by more than the bar), area %.1f %%\n", sum->pressure, sum->sharp,
         sum->unbarred, sum->area);
  printf("  ms of CPU: mean %.2f, median %.2f, largest %.2f, %d above 5; allocations: median %.0f, largest %.0f\n",
         all / n, sum->ms[n / 2], sum->ms[n - 1], slow, sum->allocations[n / 2], sum->allocations[n - 1]);
}

static void shifts(void) {
  tally sum = {0};
  for (double y = -4.0; y <= 10.0; y += 0.5)
    for (int side = 0; side < 2; ++side) {
      const rollfem_state state =
          state_of(y, 0.0008 * y, -0.000025 * y * fabs(y), 30.0, 0.0, 20e3 / 460.0 * (1.0 + 0.0003 * y), 50e3);
      rollfem_result result = {.struct_size = sizeof result};
      take(side, &state, &sum, &result);
    }
  tell("shifts of -4 to 10 mm", &sum);
}

/* The motion of the example, radius 1500 m, comparing every second step. */
static void s_curve(void) {
  tally sum = {0};
  const double speed = 20e3, radius = 460.0, ds = 500.0;
  double shift = 0.0, yaw = 0.0, turn = 0.0;
  for (int k = 0; k < 200; ++k) {
    rollfem_result result[2] = {{.struct_size = sizeof *result}, {.struct_size = sizeof *result}};
    for (int side = 0; side < 2; ++side) {
      const rollfem_state state = state_of(shift, yaw, 0.0, speed * yaw, speed * turn, speed / radius, 50e3);
      char message[512];
      const int known = k % 2 == 0
                            ? take(side, &state, &sum, &result[side])
                            : rollfem_solve(quick[side], &state, &result[side], message, sizeof message) == ROLLFEM_OK;
      if (!known) {
        fprintf(stderr, "no solution in the S-curve at step %d\n", k);
        exit(1);
      }
    }
    const rollfem_patch *left = &result[0].patch[0], *right = &result[1].patch[0];
    turn = (left->rolling_radius - right->rolling_radius) / (radius * (right->position[1] - left->position[1]));
    yaw += ds * (turn - sin(2.0 * 3.14159265358979 * k * ds / 100e3) / 1500e3);
    shift += ds * yaw;
  }
  tell("S-curve of 1500 m", &sum);
}

static double between(double lower, double upper) {
  static unsigned long long state = 20261123u;
  state = state * 6364136223846793005ull + 1442695040888963407ull;
  return lower + (upper - lower) * (double)(state >> 11) / 9007199254740992.0;
}

static void random_states(void) {
  tally sum = {0};
  for (int k = 0; k < 100; ++k) {
    const double shift = between(-6.0, 6.0), yaw = between(-0.004, 0.004), roll = between(-0.001, 0.001),
                 lateral = between(-60.0, 60.0), turn = between(-0.1, 0.1), faster = between(-0.005, 0.005);
    const rollfem_state state =
        state_of(shift, yaw, roll, lateral, turn, 20e3 / 460.0 * (1.0 + faster), between(20e3, 120e3));
    rollfem_result result = {.struct_size = sizeof result};
    take(k % 2, &state, &sum, &result);
  }
  tell("random, shifts to 6 mm, loads of 20 to 120 kN, creepages to 0.5 %", &sum);
}

static void flange(void) {
  tally sum = {0};
  const double shift_and_yaw[][2] = {{5.85, -0.03}, {5.9, -0.03}, {5.95, -0.03}, {6.05, -0.015}, {6.1, -0.015},
                                     {6.2, 0.0},    {6.25, 0.0},  {6.3, 0.0},    {6.15, 0.008},  {6.2, 0.008},
                                     {6.05, 0.015}, {6.1, 0.015}, {6.15, 0.015}, {5.85, 0.03},   {5.87, 0.03},
                                     {5.9, 0.03},   {5.95, 0.03}};
  for (size_t k = 0; k < sizeof shift_and_yaw / sizeof *shift_and_yaw; ++k) {
    const double y = shift_and_yaw[k][0];
    const rollfem_state state =
        state_of(y, shift_and_yaw[k][1], -0.000025 * y * y, 30.0, 0.0, 20e3 / 460.0 * 1.0005, 50e3);
    rollfem_result result = {.struct_size = sizeof result};
    take(1, &state, &sum, &result);
  }
  tell("flange of the right wheel at the rail", &sum);
}

int main(int count, char** words) {
  if (count > 1) across = atoi(words[1]);
  tells_all = count > 2 && strcmp(words[2], "all") == 0;
  for (int side = 0; side < 2; ++side) {
    quick[side] = make(side, across);
    fine[side] = make(side, FINE);
  }
  if (tells_all)
    printf("%8s %5s %8s %9s %9s %9s %8s %8s %7s %6s\n", "shift mm", "side", "patches", "Fx %", "Fy %", "Mz %", "p0 %",
           "area %", "ms", "malloc");
  shifts();
  s_curve();
  random_states();
  flange();
  for (int side = 0; side < 2; ++side) {
    rollfem_destroy(quick[side]);
    rollfem_destroy(fine[side]);
  }
  return 0;
}
