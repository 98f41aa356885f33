// SPDX-License-Identifier: LGPL-2.1-or-later
// Symmetric tensors, stress or strain of any model and either body: products and sums, rotation
// into other axes, and the scalar measures of a stress state. Tension is positive; stress in MPa.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace rollfem::contact {

/// Its components xx yy zz xy yz xz (not engineering shear), in the global frame (x rolling, y
/// lateral, z into the wheel) if nothing else is said.
using SymmetricTensor = std::array<double, 6>;
namespace component {
enum : std::size_t { xx, yy, zz, xy, yz, xz };
}

inline double trace(const SymmetricTensor& a) {
  return a[0] + a[1] + a[2];
}
/// a : b.
inline double product(const SymmetricTensor& a, const SymmetricTensor& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2.0 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}
/// sqrt(a : a).
inline double norm(const SymmetricTensor& a) {
  return std::sqrt(product(a, a));
}
/// a + factor b.
inline SymmetricTensor sum(const SymmetricTensor& a, double factor, const SymmetricTensor& b) {
  SymmetricTensor c;
  for (std::size_t i = 0; i < c.size(); ++i) c[i] = a[i] + factor * b[i];
  return c;
}

/// Mean stress (xx + yy + zz)/3, negative in compression: minus the hydrostatic pressure.
double hydrostatic(const SymmetricTensor& stress);

/// sqrt(3 J2), the uniaxial stress of the same distortion energy.
double von_mises(const SymmetricTensor& stress);

/// Principal stresses, largest first. Absolute error about 1e-15 of the largest.
std::array<double, 3> principal(const SymmetricTensor& stress);

/// Largest difference of principal stresses (Tresca's equivalent stress).
double tresca(const SymmetricTensor& stress);

/// Shear stress on the plane parallel to the surface, sqrt(xz^2 + yz^2). Its largest value below
/// the patch is the maximum orthogonal shear of rolling fatigue (Lundberg & Palmgren).
double orthogonal_shear(const SymmetricTensor& stress);

/// The measures whose largest values are reported.
struct StressMeasure {
  const char* name;
  double (*value)(const SymmetricTensor&);
};
/// von_mises, tresca, orthogonal_shear, principal_1 (the largest principal stress, tension).
const std::array<StressMeasure, 4>& reported_measures();

/// Three orthogonal unit vectors.
using Axes = std::array<std::array<double, 3>, 3>;

/// Displacement or stress along the axes from components in x, y, z.
std::array<double, 3> into_axes(const Axes& axes, const std::array<double, 3>& vector);
SymmetricTensor into_axes(const Axes& axes, const SymmetricTensor& stress);

/// Components in x, y, z from components along the axes.
std::array<double, 3> out_of_axes(const Axes& axes, const std::array<double, 3>& vector);
SymmetricTensor out_of_axes(const Axes& axes, const SymmetricTensor& stress);

}  // namespace rollfem::contact
