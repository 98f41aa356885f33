/* SPDX-License-Identifier: LGPL-2.1-or-later */
/* rollfem for multibody programs: prepare a wheel and a rail once, then solve for any number of states (position,
   velocities, load). Each call finds the patches of the true profiles, their loads and creepages, and the tractions by
   half-spaces after Kalker; docs/c_interface.md states accuracy and time.

   Track frame: x along the track, y to the right, z down, origin between the rails at their top. Forces and moments
   act on the wheel. Angles are in rad, time in s; lengths, forces and stresses are in the units of
   rollfem_units. Each member below states its reference, sign or frame where its name does not. */
#ifndef ROLLFEM_H
#define ROLLFEM_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Units of all lengths, forces, moments and stresses of a pair, inputs and outputs. */
typedef enum {
  ROLLFEM_MM_N = 0,  /* mm, N, N mm, MPa */
  ROLLFEM_M_N = 1,   /* m, N, N m, Pa */
  ROLLFEM_MM_KN = 2  /* mm, kN, kN mm, GPa */
} rollfem_units;

typedef enum {
  ROLLFEM_OK = 0,
  ROLLFEM_FAILED = 1, /* valid input without solution: the wheel has left its rail, ... */
  ROLLFEM_REFUSED = 2 /* a value or file is invalid */
} rollfem_status;

typedef enum { ROLLFEM_LEFT = 0, ROLLFEM_RIGHT = 1 } rollfem_side;

/* Constant data of a pair. Fill it with rollfem_defaults, then change members. */
typedef struct {
  rollfem_units units;
  rollfem_side side;
  const char* wheel_profile;   /* built in ("S1002") or a file */
  const char* rail_profile;    /* built in ("60E1") or a file */
  double rolling_radius;       /* of the wheel at its running circle */
  double gauge;                /* between the rails */
  double gauge_height;         /* depth below the top of the rails at which the gauge is measured */
  double inclination;          /* of the rails towards the middle of the track, as a tangent (1/40) */
  double flange_back_distance; /* between the backs of the flanges */
  double flange_back_position; /* y of the back in the wheel's profile coordinates */
  double wheel_young_modulus;
  double wheel_poisson_ratio;
  double rail_young_modulus;
  double rail_poisson_ratio;
  double friction_coefficient;
  int elements_across; /* across each patch */
} rollfem_definition;

/* Position of the wheelset, its motion relative to the ground, and the load on this wheel. */
typedef struct {
  double lateral_shift;    /* positive to the right */
  double yaw;              /* positive to the right (from x to y) */
  double roll;             /* positive with the right wheel lower (from y to z); NAN: both wheels touch */
  double forward_speed;    /* > 0 */
  double lateral_velocity; /* positive to the right */
  double yaw_rate;         /* 1/s, positive to the right */
  double rotation_speed;   /* 1/s, about the axle, positive when rolling forward */
  double vertical_force;   /* > 0, on the wheel, friction included */
} rollfem_state;

enum { ROLLFEM_MOST_PATCHES = 4 };

typedef struct {
  double position[3];   /* of the contact point, track frame */
  double contact_angle; /* of the contact plane, > 0 where it falls towards the middle of the track, as at a flange */
  double rolling_radius;
  double longitudinal_creepage, lateral_creepage; /* patch frame */
  double spin;                                    /* 1/length */
  double normal_force, longitudinal_force, lateral_force, spin_moment; /* patch frame */
  double lateral_pressure; /* part of lateral_force from the pressure on a curved patch; the rest is friction */
  double force[3];            /* on the wheel, track frame */
  double length, width, area; /* of the patch: extent along and across rolling, area */
  double max_pressure;
  double max_pressure_bar; /* estimated error; large near a jump of profile radius, where the peak is narrow */
  double adhesion_area;
} rollfem_patch;

typedef struct {
  int patches;
  rollfem_patch patch[ROLLFEM_MOST_PATCHES]; /* the most loaded first */
  double force[3];                           /* sum over patches, track frame */
  double moment[3];                          /* about the middle of the axle, track frame */
  double height; /* z of the middle of the axle plus rolling radius where this wheel just touches, unloaded */
} rollfem_result;

typedef struct rollfem_pair rollfem_pair;

/* Sets steel, S1002 on 60E1 at 1:40, gauge 1435 mm, radius 460 mm, friction 0.3, 12 elements across. */
void rollfem_defaults(rollfem_definition* definition, rollfem_units units);

/* Reads the profiles and prepares a pair. Returns NULL for an invalid definition; `message` (may be NULL) then holds
   the reason, cut to `size`. */
rollfem_pair* rollfem_create(const rollfem_definition* definition, char* message, size_t size);

/* Solves for one state; the result does not depend on earlier calls. Thread-safe: the pair keeps working memory per
   concurrent call. Unless the status is ROLLFEM_OK, the result is zero and `message` (may be NULL) holds the reason. */
rollfem_status rollfem_solve(const rollfem_pair* pair, const rollfem_state* state, rollfem_result* result,
                             char* message, size_t size);

void rollfem_destroy(rollfem_pair* pair);

/* A table of creep forces written by `rollfem table`, for ellipses of any size or for a wheel over the lateral shift of
   its wheelset (docs/tables.md). */
typedef struct rollfem_table rollfem_table;

/* Hertzian contact, in consistent units: mm, N, MPa or m, N, Pa. */
typedef struct {
  double semi_axis_x;    /* of the ellipse, along rolling */
  double semi_axis_y;    /* of the ellipse, across rolling */
  double shear_modulus;  /* combined: 1/G = (1/G1 + 1/G2)/2 */
  double friction_bound; /* coefficient of friction times normal force */
  double longitudinal_creepage, lateral_creepage;
  double spin; /* 1/length */
} rollfem_ellipse;

/* Forces on the wheel. Bars: errors of the force vector and of the moment, from the table and its interpolation. */
typedef struct {
  double longitudinal_force, lateral_force, spin_moment;
  double force_bar, moment_bar;
} rollfem_creep_forces;

/* Opens a file table.h5 or the folder that holds it. Returns NULL for an invalid table, with a message as in
   rollfem_create. */
rollfem_table* rollfem_table_open(const char* path, char* message, size_t size);

/* Interpolates. Allocates nothing unless it fails; thread-safe. Unless the status is ROLLFEM_OK, the forces are zero
   and `message` (may be NULL) holds the reason. */
rollfem_status rollfem_table_forces(const rollfem_table* table, const rollfem_ellipse* ellipse,
                                    rollfem_creep_forces* forces, char* message, size_t size);

/* A wheel of a table over lateral shifts, with the creepages of its main (most loaded) contact. */
typedef struct {
  rollfem_units units;
  double lateral_shift;  /* of the wheelset, positive to the right */
  double friction_bound; /* coefficient of friction times normal force of all contacts; 0: value of the table */
  double longitudinal_creepage, lateral_creepage;
  double spin; /* 1/length */
} rollfem_shifted_wheel;

/* Friction on the wheel, summed over all contacts, in the frame of the main contact. */
typedef struct {
  double longitudinal_force, lateral_force;
  double force_along_normal; /* nonzero on a curved surface and with contacts in other planes */
  double spin_moment;
  double force_bar, moment_bar; /* errors; at a jump they include the full difference */
  double friction_bound;        /* used here */
  double normal_force;          /* of the table, all contacts */
  double contact_angle, rolling_radius; /* of the main contact */
  int jumps; /* 1: contact jumps between the neighbouring shifts; the values are those of the nearer one */
} rollfem_wheel_forces;

/* Works like rollfem_table_forces. */
rollfem_status rollfem_table_wheel_forces(const rollfem_table* table, const rollfem_shifted_wheel* wheel,
                                          rollfem_wheel_forces* forces, char* message, size_t size);

void rollfem_table_close(rollfem_table* table);

/* "0.1.0" */
const char* rollfem_version(void);

#ifdef __cplusplus
}
#endif

#endif
