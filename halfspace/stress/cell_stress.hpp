// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacement and stress inside an elastic half-space under uniform tractions on a rectangle of
// its surface, as closed integrals of the Boussinesq-Cerruti fields. Love (1929) gave the part of
// the pressure, Kalker (1990, appendix C) that of the tangential tractions; here both come from one
// set of potentials (Johnson 1985, section 3.2) whose integrals over the rectangle are differences
// of a corner function.
//
// Local frame: the half-space is z >= 0, z is the depth, and the loads are those on its surface
// along +x, +y and +z (pressure is positive). subsurface.hpp maps wheel and rail to it.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace rollfem::halfspace {

/// With r the distance from a surface point, phi = 1/r, chi = ln(r + z), omega = z ln(r + z) - r: d
/// omega/dz = chi, d chi/dz = phi, all harmonic. The listed potentials suffice for all fields; the
/// others follow from the Laplace equation. Entries named z_... are multiplied by z, which keeps
/// them bounded on the surface.
enum Potential : int {
  phi,
  chi_x,
  chi_y,
  omega_xx,
  omega_yy,
  omega_xy,
  first_dimensionless,  // those above scale with length when integrated over an area
  phi_x = first_dimensionless,
  phi_y,
  phi_z,
  chi_xx,
  chi_yy,
  chi_xy,
  omega_xxy,
  omega_xyy,
  z_phi_xx,
  z_phi_yy,
  z_phi_xy,
  z_phi_xz,
  z_phi_yz,
  z_chi_xxy,
  z_chi_xyy,
  potential_count
};

/// Indexed by Potential; mm or 1 when integrated over an area.
using Potentials = Eigen::Array<double, potential_count, 1>;

/// Components of a state: displacement and stress.
enum Component : int { u_x, u_y, u_z, s_xx, s_yy, s_zz, s_xy, s_yz, s_xz, component_count };

/// Local displacement (mm) and stress (MPa, tension positive), indexed by Component.
using LocalState = std::array<double, component_count>;

/// Mixed antiderivative in X and Y at a corner; X, Y from the corner to the field point and z >= 0
/// in units of the longer side. Terms that depend on X or on Y alone are dropped: they cancel in
/// the difference over the four corners. Where the stress is infinite, that is on the surface at a
/// loaded edge (xx, yy, xy of tangential tractions) or at a corner (xy of the pressure), the finite
/// part is returned: jumps of a piecewise constant traction make the infinity, a continuous
/// traction has none. On the edge the tractions are the mean of both sides.
Potentials corner_potentials(double X, double Y, double z);

/// Antiderivative in X at an edge of strips without ends, the limit of corner_potentials of strips
/// from -Y to Y: plane strain under p_x and p_z, antiplane shear under p_y. As in
/// ContactGrid::line_reference, displacements are relative to the surface at `reference` from a
/// line load (`finite`: to distant points, in the middle of strips as long as `reference`).
Potentials edge_potentials(double X, double z, double reference, bool finite);

/// Potentials of a unit point source at offset (X, Y), r > 0.
Potentials point_potentials(double X, double Y, double z);

/// Potentials of unit density on a rectangle of dx by dy mm centred at (0, 0), seen from (x, y, z).
/// Near: corner functions. Further than 20 times the longer side: the Gauss rule, because the
/// differences cancel. Relative error below 1e-10 for sides up to 8:1.
Potentials rectangle_potentials(double x, double y, double z, double dx, double dy);

/// Displacement times 4 pi G and stress times 2 pi from the potentials of the three loads: `p_x[i]`
/// is potential i times load along x, summed over the sources, and so on. Linear; Scalar may be
/// complex (spectra).
template <class Scalar>
std::array<Scalar, component_count> assemble_state(const Scalar* p_x, const Scalar* p_y,
                                                   const Scalar* p_z, double nu, double z) {
  const double a = 1.0 - 2.0 * nu;
  const double b = 2.0 * nu;
  std::array<Scalar, component_count> s;
  // Johnson (3.4) with psi_1 = F_x + G_y + H_z and psi its derivative along z, and Hooke's law with
  // div u = 2 (1 - 2 nu) psi_z / (4 pi G).
  s[u_x] = 2.0 * p_x[phi] + b * p_x[omega_xx] - z * p_x[chi_xx]  //
           + b * p_y[omega_xy] - z * p_y[chi_xy]                 //
           - a * p_z[chi_x] - z * p_z[phi_x];
  s[u_y] = b * p_x[omega_xy] - z * p_x[chi_xy]                     //
           + 2.0 * p_y[phi] + b * p_y[omega_yy] - z * p_y[chi_yy]  //
           - a * p_z[chi_y] - z * p_z[phi_y];
  s[u_z] = a * p_x[chi_x] - z * p_x[phi_x]    //
           + a * p_y[chi_y] - z * p_y[phi_y]  //
           + 2.0 * (1.0 - nu) * p_z[phi] - z * p_z[phi_z];
  s[s_xx] = 2.0 * p_x[phi_x] - b * p_x[omega_xyy] + p_x[z_chi_xyy] + p_x[z_phi_xz]  //
            + b * (p_y[phi_y] + p_y[omega_xxy]) - p_y[z_chi_xxy]                    //
            + b * p_z[phi_z] - a * p_z[chi_xx] - p_z[z_phi_xx];
  s[s_yy] = b * (p_x[phi_x] + p_x[omega_xyy]) - p_x[z_chi_xyy]                        //
            + 2.0 * p_y[phi_y] - b * p_y[omega_xxy] + p_y[z_chi_xxy] + p_y[z_phi_yz]  //
            + b * p_z[phi_z] - a * p_z[chi_yy] - p_z[z_phi_yy];
  s[s_zz] = -p_x[z_phi_xz] - p_y[z_phi_yz] + p_z[phi_z] + p_z[z_phi_xx] + p_z[z_phi_yy];
  s[s_xy] = p_x[phi_y] + b * p_x[omega_xxy] - p_x[z_chi_xxy]    //
            + p_y[phi_x] + b * p_y[omega_xyy] - p_y[z_chi_xyy]  //
            - a * p_z[chi_xy] - p_z[z_phi_xy];
  s[s_yz] = -p_x[z_phi_xy] + p_y[phi_z] - p_y[z_phi_yy] - p_z[z_phi_yz];
  s[s_xz] = p_x[phi_z] - p_x[z_phi_xx] - p_y[z_phi_xy] - p_z[z_phi_xz];
  return s;
}

/// Throws contact::InputError unless the constants and the depth are possible.
void check_half_space(double z, double shear_modulus, double poisson_ratio);

}  // namespace rollfem::halfspace
