// Closed forms of the elastic half-space: point loads (Boussinesq, Cerruti), line loads (Flamant)
// and the uniformly loaded rectangle (Love). One body, z >= 0 into it, loads and displacements
// positive along the axes, stresses positive in tension (Johnson 1985, sections 2.2, 3.2 and 3.6).
#pragma once

#include <array>

namespace rollfem::halfspace {

/// A half-space: shear modulus in MPa and Poisson's ratio.
struct ElasticHalfspace {
  double shear_modulus = 0.0;
  double poisson_ratio = 0.0;
};

/// A point in mm; z is the depth.
struct Position {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

using Displacement = std::array<double, 3>;  ///< u_x, u_y, u_z in mm

/// MPa, positive in tension.
struct Stress {
  double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, yz = 0.0, xz = 0.0;
};

/// Force in N into the half-space at the origin; not at the origin itself. The displacement
/// vanishes at infinity.
Displacement boussinesq_displacement(const ElasticHalfspace& body, double force,
                                     const Position& at);
Stress boussinesq_stress(const ElasticHalfspace& body, double force, const Position& at);

/// Force in N along x at the origin. One along y: exchange x and y in position and result.
Displacement cerruti_displacement(const ElasticHalfspace& body, double force, const Position& at);
Stress cerruti_stress(const ElasticHalfspace& body, double force, const Position& at);

/// Load on the line x = z = 0 in N/mm: into the body and along x. Plane strain.
struct LineLoad {
  double normal = 0.0;
  double tangential = 0.0;
};
/// Displacement up to a rigid translation: that of a point load summed along y, with ln r in mm.
Displacement line_load_displacement(const ElasticHalfspace& body, const LineLoad& load, double x,
                                    double z);
Stress line_load_stress(const ElasticHalfspace& body, const LineLoad& load, double x, double z);

/// Normal displacement of the surface at (x, y) from the middle of a rectangle of length_x by
/// length_y under uniform pressure (Love 1929).
double love_displacement(const ElasticHalfspace& body, double pressure, double length_x,
                         double length_y, double x, double y);

}  // namespace rollfem::halfspace
