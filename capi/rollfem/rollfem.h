/* SPDX-License-Identifier: LGPL-2.1-or-later */
/* rollfem for multibody programs: a wheel and a rail are prepared once, then solved for position, velocities and load
   as often as wanted. Each call finds the patches of the true profiles, their loads and creepages, and the
   tractions by half-spaces after Kalker; docs/c_interface.md says how long it takes and how far it is off.

   Track frame: x along the track, y to the right, z down, origin between the rails at their top. Forces and moments
   act on the wheel. Angles are in rad, time in s; lengths, forces and stresses as rollfem_units has them. */
#ifndef ROLLFEM_H
#define ROLLFEM_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of every length, force, moment and stress that goes in or comes out of a pair. */
typedef enum {
  ROLLFEM_MM_N = 0,  /* mm, N, N mm, MPa */
  ROLLFEM_M_N = 1,   /* m, N, N m, Pa */
  ROLLFEM_MM_KN = 2  /* mm, kN, kN mm, GPa */
} rollfem_units;

typedef enum {
  ROLLFEM_OK = 0,
  ROLLFEM_FAILED = 1, /* understood, but no solution: the wheel has left its rail, ... */
  ROLLFEM_REFUSED = 2 /* a value or file is wrong */
} rollfem_status;

typedef enum { ROLLFEM_LEFT = 0, ROLLFEM_RIGHT = 1 } rollfem_side;

/* What is fixed. Fill it with rollfem_defaults, then change what differs. */
typedef struct {
  rollfem_units units;
  rollfem_side side;
  const char* wheel_profile;   /* built in ("S1002") or a file */
  const char* rail_profile;    /* built in ("60E1") or a file */
  double rolling_radius;       /* of the wheel on its running circle */
  double gauge;                /* between the rails */
  double gauge_height;         /* below the top of the rails, at which it is measured */
  double inclination;          /* of the rail towards the middle, as a tangent */
  double flange_back_distance; /* between the backs of the flanges */
  double flange_back_position; /* of the back in the wheel's profile coordinates */
  double wheel_young_modulus;
  double wheel_poisson_ratio;
  double rail_young_modulus;
  double rail_poisson_ratio;
  double friction_coefficient;
  int elements_across; /* of the contact grid over a patch */
} rollfem_definition;

/* Where the wheelset is and how it moves over the ground, and what presses this wheel on its rail. */
typedef struct {
  double lateral_shift;    /* to the right */
  double yaw;              /* to the right: from x to y */
  double roll;             /* right wheel down: from y to z; NAN: such that both wheels touch */
  double forward_speed;    /* > 0 */
  double lateral_velocity; /* to the right */
  double yaw_rate;         /* 1/s, to the right */
  double rotation_speed;   /* 1/s, about the axle, > 0 when rolling forward */
  double vertical_force;   /* on the wheel, friction included, > 0 */
} rollfem_state;

enum { ROLLFEM_MOST_PATCHES = 4 };

typedef struct {
  double position[3];   /* of the contact point, track frame */
  double contact_angle; /* of the rail's tangent, > 0 where it rises to the flange */
  double rolling_radius;
  double longitudinal_creepage, lateral_creepage; /* of the patch frame */
  double spin;                                    /* 1/length */
  double normal_force, longitudinal_force, lateral_force, spin_moment; /* patch frame */
  double lateral_pressure; /* part of lateral_force that the pressure of a curved patch has; friction bounds the rest */
  double force[3];                                                     /* track frame */
  double length, width, area; /* of the patch */
  double max_pressure;
  double max_pressure_bar; /* estimated error; large where a profile changes its radius: a peak narrower than elements */
  double adhesion_area;
} rollfem_patch;

typedef struct {
  int patches;
  rollfem_patch patch[ROLLFEM_MOST_PATCHES]; /* the most loaded first */
  double force[3];                           /* sum over patches, track frame */
  double moment[3];                          /* about the middle of the axle, track frame */
  double height; /* z of the middle of the axle plus the rolling radius, where this wheel touches unloaded */
} rollfem_result;

typedef struct rollfem_pair rollfem_pair;

/* Steel, S1002 on 60E1 at 1:40, gauge 1435 mm, radius 460 mm, friction 0.3, 12 elements across. */
void rollfem_defaults(rollfem_definition* definition, rollfem_units units);

/* NULL when it is refused; `message` (may be NULL) then has the reason, cut to `size`. Profiles are read here. */
rollfem_pair* rollfem_create(const rollfem_definition* definition, char* message, size_t size);

/* Solves for one state; earlier calls do not change the result. Threads may solve with the same pair at once: it keeps the
   memory that each works in for later calls. When the status is not ROLLFEM_OK the result is zero and `message` (may be
   NULL) has the reason. */
rollfem_status rollfem_solve(const rollfem_pair* pair, const rollfem_state* state, rollfem_result* result,
                             char* message, size_t size);

void rollfem_destroy(rollfem_pair* pair);

/* A table of creep forces that `rollfem table` has written, for ellipses of any size or for a wheel over the lateral
   shift of its wheelset (docs/tables.md). */
typedef struct rollfem_table rollfem_table;

/* In consistent units: mm, N, MPa or m, N, Pa. */
typedef struct {
  double semi_axis_x;    /* of the ellipse, along rolling */
  double semi_axis_y;    /* across */
  double shear_modulus;  /* combined: 1/G = (1/G1 + 1/G2)/2 */
  double friction_bound; /* coefficient of friction times normal force */
  double longitudinal_creepage, lateral_creepage;
  double spin; /* 1/length */
} rollfem_ellipse;

/* On the wheel. Bars: of the force vector and of the moment, from the table and from interpolation. */
typedef struct {
  double longitudinal_force, lateral_force, spin_moment;
  double force_bar, moment_bar;
} rollfem_creep_forces;

/* A file table.h5, or the folder that holds it; NULL when it is refused, as by rollfem_create. */
rollfem_table* rollfem_table_open(const char* path, char* message, size_t size);

/* Allocates nothing unless it refuses; threads may ask the same table at once. When the status is not ROLLFEM_OK the
   forces are zero and `message` (may be NULL) has the reason. */
rollfem_status rollfem_table_forces(const rollfem_table* table, const rollfem_ellipse* ellipse,
                                    rollfem_creep_forces* forces, char* message, size_t size);

/* A wheel of a table over lateral shifts. Creepages are those of its main contact, the most loaded one. */
typedef struct {
  rollfem_units units;
  double lateral_shift;  /* of the wheelset, to the right */
  double friction_bound; /* coefficient of friction times normal force of all contacts; 0: that of the table */
  double longitudinal_creepage, lateral_creepage;
  double spin; /* 1/length */
} rollfem_shifted_wheel;

/* Of friction, on the wheel, in the frame of the main contact: the sum over all contacts. */
typedef struct {
  double longitudinal_force, lateral_force;
  double force_along_normal; /* not 0 on a curved surface and where contacts in other planes take part */
  double spin_moment;
  double force_bar, moment_bar; /* where contact jumps between two shifts all by which these differ is in them */
  double friction_bound;        /* that was taken */
  double normal_force;          /* under which the table was made, all contacts */
  double contact_angle, rolling_radius; /* of the main contact */
  int jumps; /* 1: contact jumps between the shifts around this one, and the numbers are those of the nearer one */
} rollfem_wheel_forces;

/* As rollfem_table_forces. */
rollfem_status rollfem_table_wheel_forces(const rollfem_table* table, const rollfem_shifted_wheel* wheel,
                                          rollfem_wheel_forces* forces, char* message, size_t size);

void rollfem_table_close(rollfem_table* table);

/* "0.1.0" */
const char* rollfem_version(void);

#ifdef __cplusplus
}
#endif

#endif
