/* SPDX-License-Identifier: LGPL-2.1-or-later */
/* rollfem for multibody programs: prepare a wheel and a rail once, then solve for any number of states (position,
   velocities, load). Each call finds the patches of the true profiles, their loads and creepages, and the tractions by
   half-spaces after Kalker. docs/c_interface.md has examples and states accuracy and time.

   Frame: x along the track, y to the right, z down; the origin is midway between the rails at their top. Forces and
   moments are those of the rail on the wheel. Angles are in rad, time in s; lengths, forces and stresses are in the
   units of rollfem_units.

   Structures: each begins with struct_size, which the caller sets to its sizeof:
       rollfem_result result = {.struct_size = sizeof result};
   Later versions append members and use reserved ones. The library accepts the shorter structures of programs compiled
   with an earlier header: missing members take their defaults, and nothing is written beyond struct_size. It refuses
   longer structures. Reserved members are 0.

   Errors: functions return a status or NULL and write the reason to `message` (may be NULL), cut to `size` characters
   including the final 0. NULL for any other argument is refused with a message. All functions are thread-safe, also
   with the same pair or table. */
#ifndef ROLLFEM_H
#define ROLLFEM_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Version of this header. Before 1.0 it fits libraries of the same major and minor version. */
#define ROLLFEM_VERSION_MAJOR 0
#define ROLLFEM_VERSION_MINOR 1
#define ROLLFEM_VERSION_PATCH 0
#define ROLLFEM_VERSION_NUMBER (10000 * ROLLFEM_VERSION_MAJOR + 100 * ROLLFEM_VERSION_MINOR + ROLLFEM_VERSION_PATCH)

/* Version of the library: "0.1.0", 100. */
const char* rollfem_version(void);
int rollfem_version_number(void);

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

/* How friction falls with the slip velocity s, from friction_coefficient mu at s = 0 (docs/friction.md): mu_kin +
   mu_1 f(s/s_h1) + mu_2 f(s/s_h2), mu_1 = mu - mu_kin - mu_2. */
typedef enum {
  ROLLFEM_CONSTANT = 0,   /* not at all */
  ROLLFEM_LINEAR = 1,     /* f(r) = max(0, 1 - r/2) */
  ROLLFEM_RATIONAL = 2,   /* 1/(1 + r) in the first part, 1/(1 + r^2) in the second */
  ROLLFEM_EXPONENTIAL = 3, /* 2^-r */
  ROLLFEM_TEMPERATURE = 4  /* follows the temperature of the surfaces instead (docs/heat.md): friction_coefficient up to
                              law_constants[0] (degC; 0: 20), law_constants[2] from law_constants[1] (degC) on, linear
                              between */
} rollfem_law;

/* How a body takes the heat of friction, in these units whatever the others. 0: of steel. */
typedef struct {
  double conductivity;  /* W/(m K) */
  double heat_capacity; /* J/(kg K) */
  double density;       /* kg/m3 */
  double temperature;   /* degC, before contact */
} rollfem_heat;

/* Constant data of a pair. Fill it with rollfem_defaults, then change members. */
typedef struct {
  size_t struct_size;
  rollfem_units units;
  rollfem_side side;
  const char* wheel_profile;   /* built in ("S1002") or a file, in mm */
  const char* rail_profile;    /* built in ("60E1") or a file, in mm */
  double rolling_radius;       /* of the wheel at its running circle */
  double gauge;                /* between the rails; 0: a wheel by itself, see rollfem_state */
  double gauge_height;         /* depth below the top of the rails at which the gauge is measured */
  double inclination;          /* of the rails towards the middle of the track, as a tangent (1/40) */
  double flange_back_distance; /* between the backs of the flanges */
  double flange_back_position; /* y of the back in the wheel's profile coordinates */
  double wheel_young_modulus;
  double wheel_poisson_ratio;
  double rail_young_modulus;
  double rail_poisson_ratio;
  double friction_coefficient;
  int elements_across; /* across each patch; above 20 a call takes 0.1 to 7 s */
  /* 0: not given */
  double kinetic_coefficient;  /* mu_kin; required, as half_velocity, by every friction_law but the constant one */
  double half_velocity;        /* s_h1, length per s */
  double second_part;          /* mu_2 */
  double second_half_velocity; /* s_h2 */
  double memory_distance;      /* sliding distance d_c over which friction follows the slip velocity; 0: at once */
  double memory_velocity;      /* s_0, below which it follows as if sliding at s_0; 0: 1 mm/s */
  double layer_thickness;      /* of a layer between wheel and rail that gives way to shear; 0: none */
  double layer_shear_modulus;  /* only thickness over modulus counts */
  rollfem_law friction_law;
  double layer_yield_stress;   /* shear stress at which the layer yields; 0: it does not */
  double layer_hardening;      /* its rise per length by which a particle has yielded; below 0 the layer softens */
  double law_constants[4];     /* that the law alone has, in its order; 0: their defaults */
  int threads;                 /* of a call; 0 or 1: the caller's alone. Results are the same */
  double rail_rolling_radius;  /* of a roller in place of the rail, < 0 a ring around the wheel; 0: a straight rail */
  int has_heat;                /* 1: results have temperatures, as under ROLLFEM_TEMPERATURE */
  rollfem_heat wheel_heat, rail_heat; /* rollfem_defaults: at 20 degC */
} rollfem_definition;

/* Which member of a state gives the load on the wheel. */
typedef enum {
  ROLLFEM_VERTICAL_FORCE = 0,
  ROLLFEM_HEIGHT = 1,
  ROLLFEM_PENETRATION = 2
} rollfem_given;

/* Position of the wheelset, its motion relative to the ground, and the load on this wheel. With gauge = 0 all are those
   of the wheel, whose middle is the origin of its profile, in the coordinates of the rail's profile (y to the field, which
   is at the right: ROLLFEM_RIGHT; z down), as are positions and forces of the result. On a roller forward_speed is that of
   its surface. */
typedef struct {
  size_t struct_size;
  double lateral_shift;    /* positive to the right */
  double yaw;              /* positive to the right (from x to y) */
  double roll;             /* positive with the right wheel lower (from y to z); NAN: both wheels touch, at a higher cost; 0 with gauge = 0 */
  double forward_speed;    /* > 0 */
  double lateral_velocity; /* positive to the right */
  double yaw_rate;         /* 1/s, positive to the right; in a curve it includes the turning of the track */
  double rotation_speed;   /* 1/s, about the axle, positive when rolling forward */
  double vertical_force;   /* > 0, upwards on the wheel, friction included; read with ROLLFEM_VERTICAL_FORCE */
  rollfem_given given;     /* default 0: the force */
  double height;           /* z of the middle of the axle plus rolling_radius; read with ROLLFEM_HEIGHT */
  double penetration;      /* height minus touching_height; read with ROLLFEM_PENETRATION */
} rollfem_state;

/* Largest number of patches in a result. If there are more, the most loaded ones are listed, patches_unlisted counts the
   others, and force, moment and creepage_work include them all. */
enum { ROLLFEM_MAX_PATCHES = 4 };

/* Loaded regions that share a plane form one patch. Longitudinal, lateral and normal are the axes of the patch
   frame (docs/frames_and_signs.md): x along the track, z the common normal into the wheel; y points to the field on the
   left wheel and to the middle of the track on the right. lateral_force is thus the F_y of the patch; the lateral force
   in the track frame (lateral_force_track of the program's files) is force[1], of a patch and of the wheel. */
typedef struct {
  double position[3];   /* of the contact point, track frame */
  double contact_angle; /* of the contact plane, > 0 where it falls towards the middle of the track, as at a flange */
  double rolling_radius;
  double longitudinal_creepage, lateral_creepage; /* velocity of the wheel's surface over the rail, per speed */
  double spin;                                    /* 1/length */
  double normal_force;
  double longitudinal_force, lateral_force; /* on the wheel: against positive creepage they are negative */
  double spin_moment;                       /* about the normal at the contact point */
  double lateral_pressure; /* part of lateral_force from the pressure on a curved patch; the rest is friction */
  double force[3];            /* on the wheel, track frame */
  double length, width, area; /* of the patch: extent along and across rolling, area */
  double adhesion_area;
  double max_pressure;
  double max_pressure_bar; /* estimated error; large near a jump of profile radius, where the peak is narrow */
  double creepage_work;    /* T-gamma, a force: power of the creep forces over the speed, including spin and extra slip */
  double max_temperature;  /* degC, of both surfaces in contact; 0 without heat, like the next two */
  double heat_wheel, heat_rail; /* heat per length rolled, a force */
  double reserved[1];
} rollfem_patch;

typedef struct {
  size_t struct_size;
  int patch_count;        /* entries of `patch`; 0: the wheel does not touch at the given height */
  int patches_unlisted;
  double force[3];        /* sum over patches, track frame; a carried wheel has force[2] < 0 */
  double moment[3];       /* about the middle of the axle, track frame */
  double creepage_work;   /* T-gamma, sum over patches */
  double roll;            /* given, or found: then also valid for the other wheel */
  double touching_height; /* height at which the wheel just touches, unloaded */
  double penetration;     /* depth of the wheel below touching_height; negative: above the rail */
  rollfem_patch patch[ROLLFEM_MAX_PATCHES]; /* the most loaded first */
} rollfem_result;

/* Columns of rollfem_derivatives: variables of the state. */
enum {
  ROLLFEM_BY_LATERAL_SHIFT = 0,
  ROLLFEM_BY_YAW = 1,
  ROLLFEM_BY_ROLL = 2, /* 0 if the roll is NAN */
  ROLLFEM_BY_FORWARD_SPEED = 3,
  ROLLFEM_BY_LATERAL_VELOCITY = 4,
  ROLLFEM_BY_YAW_RATE = 5,
  ROLLFEM_BY_ROTATION_SPEED = 6,
  ROLLFEM_BY_LOAD = 7, /* vertical_force, height or penetration, whichever is given */
  ROLLFEM_STATE_VARIABLES = 8
};

/* Partial derivatives of force and moment of a result by the state; 0 if the wheel does not touch. */
typedef struct {
  size_t struct_size;
  double force[3][ROLLFEM_STATE_VARIABLES];
  double moment[3][ROLLFEM_STATE_VARIABLES];
  double stiffness; /* contact stiffness: derivative of the upward force by the height, friction included */
} rollfem_derivatives;

typedef struct rollfem_pair rollfem_pair;

/* Sets steel, S1002 on 60E1 at 1:40, gauge 1435 mm, radius 460 mm, friction 0.3, 12 elements across. Set struct_size
   first: without it nothing is written, and rollfem_create refuses the definition. */
void rollfem_defaults(rollfem_definition* definition, rollfem_units units);

/* Reads the profiles and prepares a pair. Returns NULL for an invalid definition. */
rollfem_pair* rollfem_create(const rollfem_definition* definition, char* message, size_t size);

/* Solves for one state, in 2 to 3 ms for a patch on the tread. The result does not depend on earlier calls, so steps may
   be repeated. The pair keeps working memory per concurrent call. Unless the status is ROLLFEM_OK, the result is zero. A
   wheel held above the rail by its height or penetration is no failure: its forces are zero. */
rollfem_status rollfem_solve(const rollfem_pair* pair, const rollfem_state* state, rollfem_result* result,
                             char* message, size_t size);

/* Also returns derivatives. Columns of the velocities solve the linearised friction problem; the column of the load
   compares two solutions on the same elements; shift, yaw, roll and, under falling friction, the forward speed use
   central differences (0.02 mm, 2e-5 rad, 2e-5 of the speed). States that need the full solver (docs/c_interface.md) use
   differences for all columns. Forces have a kink where a patch begins, and change steeply with the shift where the
   contact jumps along the profile. */
rollfem_status rollfem_linearise(const rollfem_pair* pair, const rollfem_state* state, rollfem_result* result,
                                 rollfem_derivatives* derivatives, char* message, size_t size);

void rollfem_destroy(rollfem_pair* pair);

/* A table of creep forces written by `rollfem table`, for ellipses of any size or for a wheel over the lateral shift of
   its wheelset (docs/tables.md). */
typedef struct rollfem_table rollfem_table;

/* Hertzian contact, in consistent units: mm, N, MPa or m, N, Pa; mm, N, MPa for a table of friction that depends on speed
   or load, whose load is friction_bound over its coefficient. */
typedef struct {
  size_t struct_size;
  double semi_axis_x;    /* of the ellipse, along rolling */
  double semi_axis_y;    /* of the ellipse, across rolling */
  double shear_modulus;  /* combined: 1/G = (1/G1 + 1/G2)/2 */
  double friction_bound; /* coefficient of friction times normal force */
  double longitudinal_creepage, lateral_creepage;
  double spin;  /* 1/length */
  double speed; /* length per s, of a table with several or with heat; 0: its only one, or that of its case */
} rollfem_ellipse;

/* Forces on the wheel. Bars: errors of the force vector and of the moment, from the table and its interpolation. */
typedef struct {
  size_t struct_size;
  double longitudinal_force, lateral_force, spin_moment;
  double force_bar, moment_bar;
  /* K, largest rise of the temperature in contact by friction; NAN without heat in the table, or with a shear modulus
     other than its own. Needs mm, N, MPa and, if it is not that of the table, the speed. */
  double temperature_rise;
} rollfem_creep_forces;

/* Opens a file table.h5 or the folder that holds it. Returns NULL for an invalid table. */
rollfem_table* rollfem_table_open(const char* path, char* message, size_t size);

/* Interpolates, in microseconds. Allocates nothing unless it fails. Unless the status is ROLLFEM_OK, the forces are zero. */
rollfem_status rollfem_table_forces(const rollfem_table* table, const rollfem_ellipse* ellipse,
                                    rollfem_creep_forces* forces, char* message, size_t size);

/* A wheel of a table over lateral shifts, with the creepages of its main (most loaded) contact. */
typedef struct {
  size_t struct_size;
  rollfem_units units;
  double lateral_shift;  /* of the wheelset, positive to the right */
  double friction_bound; /* coefficient of friction times normal force of all contacts; 0: value of the table */
  double longitudinal_creepage, lateral_creepage;
  double spin;  /* 1/length */
  double load;  /* force under [load], of a table with several; 0: its only one */
  double speed; /* length per s, likewise */
} rollfem_shifted_wheel;

/* Friction on the wheel, summed over all contacts, in the frame of the main contact. */
typedef struct {
  size_t struct_size;
  double longitudinal_force, lateral_force;
  double force_along_normal; /* nonzero on a curved surface and with contacts in other planes */
  double spin_moment;
  double force_bar, moment_bar; /* errors; at a jump they include the full difference */
  double friction_bound;        /* used here */
  double normal_force;          /* of the table, all contacts */
  double contact_angle, rolling_radius; /* of the main contact */
  int jumps; /* 1: contact jumps between the neighbouring shifts; the values are those of the nearer one */
  double temperature_rise; /* K, as of an ellipse, largest of all contacts */
} rollfem_wheel_forces;

/* Works like rollfem_table_forces. */
rollfem_status rollfem_table_wheel_forces(const rollfem_table* table, const rollfem_shifted_wheel* wheel,
                                          rollfem_wheel_forces* forces, char* message, size_t size);

void rollfem_table_close(rollfem_table* table);

#ifdef __cplusplus
}
#endif

#endif
