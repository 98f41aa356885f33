// SPDX-License-Identifier: LGPL-2.1-or-later
/* A wheelset on its track as a slave for co-simulation, FMI 2.0: rigid, with lateral shift, yaw and rotation of its own
   under the forces of the springs, which are inputs. Within a communication step inputs stay as they are; the step is
   integrated by ROS2 (Verwer et al. 1999), linearly implicit with the derivatives of rollfem_linearise. */
#include "fmi2.h"
#include "laws.h"
#include "variables.h"

#include <math.h>
#include <rollfem/rollfem.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXPORT __attribute__((visibility("default")))
enum { UNKNOWNS = 5, TEXT = 1024, MOST_STEPS = 100000 /* some minutes */ };

/* What a step changes, and what fmi2GetFMUstate keeps. */
typedef struct { double value[V_COUNT]; } saved;

typedef struct {
  saved now;
  char text[3][TEXT]; /* profile of the wheel, of the rail, friction law */
  char name[TEXT], message[TEXT];
  rollfem_pair* wheel[2]; /* left, right */
  fmi2CallbackFunctions of_master;
} slave;

static fmi2Status fail(slave* s, fmi2Status status, const char* text) {
  if (s != NULL && s->of_master.logger != NULL)
    s->of_master.logger(s->of_master.componentEnvironment, s->name, status, "logStatusError", "%s", text);
  return status;
}

/* Leaves the function where the instance is NULL, or a list of `count` entries. */
#define NEED(s) \
  if ((s) == NULL) return fmi2Error
#define NEED_LISTS(s, count, which, values) \
  NEED(s);                                  \
  if ((count) > 0 && ((which) == NULL || (values) == NULL)) return fail(s, fmi2Error, "a list is NULL; do: give it")

static void set_state(const slave* s, int side, const double* at, double roll, rollfem_state* state) {
  const double* v = s->now.value;
  *state = (rollfem_state){.struct_size = sizeof *state,
                           .lateral_shift = at[0],
                           .lateral_velocity = at[1],
                           .yaw = at[2],
                           .yaw_rate = at[3] + v[V_speed] * v[V_curvature],
                           .roll = roll,
                           .forward_speed = v[V_speed],
                           .rotation_speed = v[V_speed] / v[V_rolling_radius] + at[4],
                           .vertical_force = v[side == 0 ? V_left_load : V_right_load]};
}

/* Rates of the unknowns; `result` has both wheels, and `by`, if asked for, the derivatives of the rates. */
static int rates(slave* s, const double* at, double* rate, rollfem_result* result, double (*by)[UNKNOWNS]) {
  static const int column[UNKNOWNS] = {ROLLFEM_BY_LATERAL_SHIFT, ROLLFEM_BY_LATERAL_VELOCITY, ROLLFEM_BY_YAW,
                                       ROLLFEM_BY_YAW_RATE, ROLLFEM_BY_ROTATION_SPEED};
  const double* v = s->now.value;
  double sum[3] = {v[V_lateral_force], v[V_yaw_moment], v[V_axle_torque]}, roll = NAN;
  const double inertia[3] = {v[V_mass], v[V_yaw_inertia], v[V_spin_inertia]};
  if (by != NULL) memset(by, 0, UNKNOWNS * sizeof *by);
  for (int side = 0; side < 2; ++side) {
    rollfem_derivatives slope = {.struct_size = sizeof slope};
    rollfem_state state;
    result[side] = (rollfem_result){.struct_size = sizeof *result};
    set_state(s, side, at, by != NULL ? NAN : roll, &state);
    const rollfem_status status =
        by != NULL ? rollfem_linearise(s->wheel[side], &state, &result[side], &slope, s->message, TEXT)
                   : rollfem_solve(s->wheel[side], &state, &result[side], s->message, TEXT);
    if (status != ROLLFEM_OK) return 0;
    roll = result[side].roll;
    sum[0] += result[side].force[1];
    sum[1] += result[side].moment[2];
    sum[2] -= result[side].moment[1];
    for (int k = 0; by != NULL && k < UNKNOWNS; ++k) {
      by[1][k] += slope.force[1][column[k]] / inertia[0];
      by[3][k] += slope.moment[2][column[k]] / inertia[1];
      by[4][k] -= slope.moment[1][column[k]] / inertia[2];
    }
  }
  if (by != NULL) by[0][1] = by[2][3] = 1.0;
  rate[0] = at[1];
  rate[1] = sum[0] / inertia[0];
  rate[2] = at[3];
  rate[3] = sum[1] / inertia[1];
  rate[4] = sum[2] / inertia[2];
  return 1;
}

/* x with matrix x = x, by elimination; the matrix is lost. */
static void solve(double (*matrix)[UNKNOWNS], double* x) {
  for (int k = 0; k < UNKNOWNS; ++k) {
    int pivot = k;
    for (int i = k + 1; i < UNKNOWNS; ++i)
      if (fabs(matrix[i][k]) > fabs(matrix[pivot][k])) pivot = i;
    for (int j = 0; j < UNKNOWNS; ++j) {
      const double swapped = matrix[k][j];
      matrix[k][j] = matrix[pivot][j];
      matrix[pivot][j] = swapped;
    }
    const double swapped = x[k];
    x[k] = x[pivot];
    x[pivot] = swapped;
    for (int i = 0; i < UNKNOWNS; ++i) {
      if (i == k) continue;
      const double factor = matrix[i][k] / matrix[k][k];
      for (int j = k; j < UNKNOWNS; ++j) matrix[i][j] -= factor * matrix[k][j];
      x[i] -= factor * x[k];
    }
  }
  for (int k = 0; k < UNKNOWNS; ++k) x[k] /= matrix[k][k];
}

static void set_outputs(slave* s, const double* at, const rollfem_result* result) {
  double* v = s->now.value;
  memcpy(&v[V_shift], at, UNKNOWNS * sizeof *at); /* in the order of variables.cmake */
  v[V_roll] = result[0].roll;
  for (int d = 0; d < 2; ++d) {
    v[V_left_fx + d] = result[0].force[d];
    v[V_right_fx + d] = result[1].force[d];
  }
  v[V_left_t_gamma] = result[0].creepage_work;
  v[V_right_t_gamma] = result[1].creepage_work;
  for (int side = 0; side < 2; ++side) {
    double* hottest = &v[V_left_temperature + side];
    *hottest = result[side].patch[0].max_temperature; /* without a patch: 0 */
    for (int k = 1; k < result[side].patch_count; ++k) *hottest = fmax(*hottest, result[side].patch[k].max_temperature);
  }
}

static int advance(slave* s, double step) {
  const double gamma = 1.0 - sqrt(0.5);
  double at[UNKNOWNS], moved[UNKNOWNS], first[UNKNOWNS], second[UNKNOWNS], by[UNKNOWNS][UNKNOWNS];
  double system[UNKNOWNS][UNKNOWNS], matrix[UNKNOWNS][UNKNOWNS];
  rollfem_result result[2];
  memcpy(at, &s->now.value[V_shift], sizeof at);
  const double steps = fmax(1.0, ceil(step / s->now.value[V_largest_step] - 1e-9));
  if (!(steps <= MOST_STEPS)) {
    snprintf(s->message, TEXT, "a step of %g s has %.3g of largest_step = %g s; allowed: %d; do: correct one of them",
             step, steps, s->now.value[V_largest_step], MOST_STEPS);
    return 0;
  }
  const int count = (int)steps;
  const double h = step / count;
  for (int n = 0; n < count; ++n) {
    if (!rates(s, at, first, result, n == 0 ? by : NULL)) return 0;
    if (n == 0)
      for (int i = 0; i < UNKNOWNS; ++i)
        for (int k = 0; k < UNKNOWNS; ++k) system[i][k] = (i == k) - gamma * h * by[i][k];
    memcpy(matrix, system, sizeof system);
    solve(matrix, first);
    for (int k = 0; k < UNKNOWNS; ++k) moved[k] = at[k] + h * first[k];
    if (!rates(s, moved, second, result, NULL)) return 0;
    for (int k = 0; k < UNKNOWNS; ++k) second[k] -= 2.0 * first[k];
    memcpy(matrix, system, sizeof system);
    solve(matrix, second);
    for (int k = 0; k < UNKNOWNS; ++k) at[k] += h * (1.5 * first[k] + 0.5 * second[k]);
  }
  if (!rates(s, at, first, result, NULL)) return 0;
  set_outputs(s, at, result);
  return 1;
}

static void drop_wheels(slave* s) {
  for (int side = 0; side < 2; ++side) {
    rollfem_destroy(s->wheel[side]);
    s->wheel[side] = NULL;
  }
}

static int is_initialised(const slave* s) {
  return s->wheel[0] != NULL && s->wheel[1] != NULL;
}

static fmi2Status refuse_parameter(slave* s) {
  return fail(s, fmi2Error, "parameters are fixed after the initialisation; do: set them before, or call fmi2Reset");
}

EXPORT const char* fmi2GetTypesPlatform(void) {
  return "default";
}

EXPORT const char* fmi2GetVersion(void) {
  return "2.0";
}

EXPORT fmi2Status fmi2Reset(fmi2Component c) {
  slave* s = c;
  NEED(s);
  memcpy(s->now.value, start_values, sizeof start_values);
  snprintf(s->text[0], TEXT, "S1002");
  snprintf(s->text[1], TEXT, "60E1");
  snprintf(s->text[2], TEXT, "constant");
  drop_wheels(s);
  return fmi2OK;
}

EXPORT fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                                     const fmi2CallbackFunctions* of_master, fmi2Boolean visible, fmi2Boolean logging) {
  slave* s = calloc(1, sizeof *s);
  if (s == NULL) return NULL;
  if (of_master != NULL) s->of_master = *of_master;
  snprintf(s->name, TEXT, "%s", name != NULL ? name : "");
  fmi2Reset(s);
  if (type == fmi2CoSimulation && guid != NULL && strcmp(guid, GUID) == 0) return s;
  fail(s, fmi2Error, "the FMU is for co-simulation, its guid is " GUID "; do: import its modelDescription.xml again");
  free(s);
  return NULL;
}

EXPORT void fmi2FreeInstance(fmi2Component c) {
  if (c == NULL) return;
  drop_wheels(c);
  free(c);
}

EXPORT fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
  slave* s = c;
  NEED(s);
  const double* v = s->now.value;
  for (int k = V_mass; k <= V_spin_inertia; ++k)
    if (!(v[k] > 0.0)) return fail(s, fmi2Error, "mass and inertias; allowed: above 0; do: correct them");
  if (!(v[V_largest_step] > 0.0)) return fail(s, fmi2Error, "largest_step; allowed: above 0; do: correct it");
  const int law = number_of_law(s->text[2], s->message, TEXT);
  if (law < 0) return fail(s, fmi2Error, s->message);
  drop_wheels(s);
  for (int side = 0; side < 2; ++side) {
    rollfem_definition definition = {.struct_size = sizeof definition};
    rollfem_defaults(&definition, ROLLFEM_M_N);
    definition.side = side == 0 ? ROLLFEM_LEFT : ROLLFEM_RIGHT;
    definition.wheel_profile = s->text[0];
    definition.rail_profile = s->text[1];
    definition.rolling_radius = v[V_rolling_radius];
    definition.gauge = v[V_gauge];
    definition.inclination = v[V_inclination];
    definition.friction_coefficient = v[V_friction];
    definition.friction_law = (rollfem_law)law;
    definition.kinetic_coefficient = v[V_kinetic_coefficient];
    definition.half_velocity = v[V_half_velocity];
    definition.second_part = v[V_second_part];
    definition.second_half_velocity = v[V_second_half_velocity];
    definition.memory_distance = v[V_memory_distance];
    definition.memory_velocity = v[V_memory_velocity];
    memcpy(definition.law_constants, &v[V_law_constant_1], sizeof definition.law_constants);
    definition.layer_thickness = v[V_layer_thickness];
    definition.layer_shear_modulus = v[V_layer_shear_modulus];
    definition.has_heat = v[V_heat] != 0.0;
    definition.wheel_heat.temperature = v[V_wheel_temperature];
    definition.rail_heat.temperature = v[V_rail_temperature];
    s->wheel[side] = rollfem_create(&definition, s->message, TEXT);
    if (s->wheel[side] == NULL) break;
  }
  const double at[UNKNOWNS] = {v[V_start_shift], 0.0, v[V_start_yaw], 0.0, 0.0};
  double rate[UNKNOWNS];
  rollfem_result result[2];
  if (!is_initialised(s) || !rates(s, at, rate, result, NULL)) {
    drop_wheels(s);
    return fail(s, fmi2Error, s->message);
  }
  set_outputs(s, at, result);
  return fmi2OK;
}

EXPORT fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean is_final) {
  slave* s = c;
  NEED(s);
  if (!is_initialised(s) || !(step > 0.0))
    return fail(s, fmi2Error, "a step must be longer than 0 and follow the initialisation");
  return advance(s, step) ? fmi2OK : fail(s, fmi2Discard, s->message);
}

EXPORT fmi2Status fmi2CancelStep(fmi2Component c) {
  return fail(c, fmi2Error, "steps are not asynchronous");
}

EXPORT fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference* which, size_t count, fmi2Real* values) {
  slave* s = c;
  NEED_LISTS(s, count, which, values);
  for (size_t k = 0; k < count; ++k) {
    if (which[k] >= V_COUNT) return fail(s, fmi2Error, "there is no Real of this value reference");
    values[k] = s->now.value[which[k]];
  }
  return fmi2OK;
}

EXPORT fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference* which, size_t count, const fmi2Real* values) {
  slave* s = c;
  NEED_LISTS(s, count, which, values);
  for (size_t k = 0; k < count; ++k) {
    if (which[k] >= V_shift) return fail(s, fmi2Error, "there is no input or parameter of this value reference");
    if (which[k] >= V_mass && is_initialised(s)) return refuse_parameter(s);
    s->now.value[which[k]] = values[k];
  }
  return fmi2OK;
}

EXPORT fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference* which, size_t count, fmi2String* values) {
  slave* s = c;
  NEED_LISTS(s, count, which, values);
  for (size_t k = 0; k < count; ++k) {
    if (which[k] > 2) return fail(s, fmi2Error, "there is no String of this value reference");
    values[k] = s->text[which[k]];
  }
  return fmi2OK;
}

EXPORT fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference* which, size_t count, const fmi2String* values) {
  slave* s = c;
  NEED_LISTS(s, count, which, values);
  for (size_t k = 0; k < count; ++k) {
    if (which[k] > 2 || values[k] == NULL || strlen(values[k]) >= TEXT)
      return fail(s, fmi2Error, "there is no String of this value reference, or it is too long");
    if (is_initialised(s)) return refuse_parameter(s);
    snprintf(s->text[which[k]], TEXT, "%s", values[k]);
  }
  return fmi2OK;
}

EXPORT fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate* place) {
  slave* s = c;
  NEED_LISTS(s, 1, place, place);
  if (*place == NULL) *place = malloc(sizeof(saved));
  if (*place == NULL) return fail(s, fmi2Error, "out of memory");
  memcpy(*place, &s->now, sizeof(saved));
  return fmi2OK;
}

EXPORT fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
  NEED_LISTS(c, 1, state, state);
  memcpy(&((slave*)c)->now, state, sizeof(saved));
  return fmi2OK;
}

EXPORT fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate* place) {
  NEED_LISTS(c, 1, place, place);
  free(*place);
  *place = NULL;
  return fmi2OK;
}

/* What is accepted without any effect. */
#define IGNORED(name, ...) \
  EXPORT fmi2Status name(__VA_ARGS__) { return c != NULL ? fmi2OK : fmi2Error; }
IGNORED(fmi2SetDebugLogging, fmi2Component c, fmi2Boolean on, size_t n, const fmi2String* categories)
IGNORED(fmi2SetupExperiment, fmi2Component c, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real start,
        fmi2Boolean has_stop, fmi2Real stop)
IGNORED(fmi2EnterInitializationMode, fmi2Component c)
IGNORED(fmi2Terminate, fmi2Component c)

/* What this FMU does not have: modelDescription.xml declares none of it. */
#define NONE(name, ...)                                                                                      \
  EXPORT fmi2Status name(fmi2Component c, __VA_ARGS__) { return fail(c, fmi2Error, #name ": is not offered"); }
NONE(fmi2GetInteger, const fmi2ValueReference* r, size_t n, fmi2Integer* v)
NONE(fmi2SetInteger, const fmi2ValueReference* r, size_t n, const fmi2Integer* v)
NONE(fmi2GetBoolean, const fmi2ValueReference* r, size_t n, fmi2Boolean* v)
NONE(fmi2SetBoolean, const fmi2ValueReference* r, size_t n, const fmi2Boolean* v)
NONE(fmi2SerializedFMUstateSize, fmi2FMUstate f, size_t* n)
NONE(fmi2SerializeFMUstate, fmi2FMUstate f, fmi2Byte* b, size_t n)
NONE(fmi2DeSerializeFMUstate, const fmi2Byte* b, size_t n, fmi2FMUstate* f)
NONE(fmi2GetDirectionalDerivative, const fmi2ValueReference* u, size_t nu, const fmi2ValueReference* k, size_t nk,
     const fmi2Real* d, fmi2Real* r)
NONE(fmi2SetRealInputDerivatives, const fmi2ValueReference* r, size_t n, const fmi2Integer* o, const fmi2Real* v)
NONE(fmi2GetRealOutputDerivatives, const fmi2ValueReference* r, size_t n, const fmi2Integer* o, fmi2Real* v)
NONE(fmi2GetStatus, fmi2StatusKind k, fmi2Status* v)
NONE(fmi2GetRealStatus, fmi2StatusKind k, fmi2Real* v)
NONE(fmi2GetIntegerStatus, fmi2StatusKind k, fmi2Integer* v)
NONE(fmi2GetBooleanStatus, fmi2StatusKind k, fmi2Boolean* v)
NONE(fmi2GetStringStatus, fmi2StatusKind k, fmi2String* v)
