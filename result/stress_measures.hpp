// SPDX-License-Identifier: LGPL-2.1-or-later
// Scalar measures of a stress state: hydrostatic, von Mises, Tresca, principal and orthogonal shear
// stress; rotation into other axes. For any model and either body. Tension is positive; units MPa.
#pragma once

#include <array>

namespace rollfem::contact {

/// Symmetric stress tensor in the global frame (x rolling, y lateral, z into the wheel), MPa.
struct Stress {
  double xx = 0.0;
  double yy = 0.0;
  double zz = 0.0;
  double xy = 0.0;
  double yz = 0.0;
  double xz = 0.0;

  /// In the order of BodyField::stress: xx yy zz xy yz xz.
  std::array<double, 6> as_array() const { return {xx, yy, zz, xy, yz, xz}; }
  static Stress from_array(const std::array<double, 6>& s) {
    return {s[0], s[1], s[2], s[3], s[4], s[5]};
  }
};

/// Mean stress (xx + yy + zz)/3, negative in compression: minus the hydrostatic pressure.
double hydrostatic(const Stress& stress);

/// sqrt(3 J2), the uniaxial stress of the same distortion energy.
double von_mises(const Stress& stress);

/// Principal stresses, largest first. Absolute error about 1e-15 of the largest.
std::array<double, 3> principal(const Stress& stress);

/// Largest difference of principal stresses (Tresca's equivalent stress).
double tresca(const Stress& stress);

/// Shear stress on the plane parallel to the surface, sqrt(xz^2 + yz^2). Its largest value below
/// the patch is the maximum orthogonal shear of rolling fatigue (Lundberg & Palmgren).
double orthogonal_shear(const Stress& stress);

/// The measures whose largest values are reported.
struct StressMeasure {
  const char* name;
  double (*value)(const Stress&);
};
/// von_mises, tresca, orthogonal_shear, principal_1 (the largest principal stress, tension).
const std::array<StressMeasure, 4>& reported_measures();

/// Three orthogonal unit vectors.
using Axes = std::array<std::array<double, 3>, 3>;

/// Displacement or stress along the axes from components in x, y, z.
std::array<double, 3> into_axes(const Axes& axes, const std::array<double, 3>& vector);
Stress into_axes(const Axes& axes, const Stress& stress);

/// Components in x, y, z from components along the axes.
std::array<double, 3> out_of_axes(const Axes& axes, const std::array<double, 3>& vector);
Stress out_of_axes(const Axes& axes, const Stress& stress);

}  // namespace rollfem::contact
