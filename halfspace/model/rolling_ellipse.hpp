// SPDX-License-Identifier: LGPL-2.1-or-later
// Steady rolling of a Hertzian ellipse at many creepages, for tables of vehicle dynamics.
// Everything is scaled, so that one value covers contacts of any size, load and stiffness.
#pragma once

#include "case/case.hpp"
#include "halfspace/closed_forms/kalker.hpp"

#include <optional>
#include <vector>

namespace rollfem::halfspace {

/// Friction at mu = G = F_n = c = 1: lengths along the surface over c, displacement, slip times c
/// and the sliding distance over mu F_n/(G c), stress over mu F_n/c^2.
struct ScaledFriction {
  contact::FrictionFall fall{};
  double speed = 0.0;  ///< V mu F_n/(G c^2), in the unit of the velocities of the fall
  std::optional<contact::Layer> layer{};
};

/// Bodies whose temperature in contact rises by `unit` (K) where that of the scaled ellipse is 1.
struct ScaledHeat {
  double temperature = 0.0;  ///< degC, before friction heats them
  double unit = 1.0;
};

/// Hertz's ellipse between bodies of like material.
struct EllipseShape {
  double axis_ratio = 1.0;  ///< a/b, a along rolling
  double poisson_ratio = 0.28;
  ScaledFriction friction{};
  std::optional<ScaledHeat> heat{};  ///< empty: no temperatures
};

/// xi and eta times G c^2 / (mu F_n), phi times G c^3 / (mu F_n), with c = sqrt(a b), the combined
/// shear modulus G and the bound mu F_n of friction.
using ScaledCreepage = contact::Creepage;

/// Forces over mu F_n, the moment over mu F_n c.
using ScaledForces = CreepForces;

/// The limit of the two finest grids.
struct EllipseForces {
  ScaledForces limit;
  ScaledForces correction;  ///< from the finer one to the limit: size of the error, not a bound
  int elements_across = 0;  ///< of the finer one
  /// Largest rise of the temperature over (mu F_n)^2 sqrt(V) / (G beta c^3.5), beta of both bodies
  /// together; on the finer one; 0 without heat.
  double rise = 0.0;
};

struct EllipseAccuracy {
  /// Grids are doubled from 10 across until the correction of the forces is at most this fraction
  /// of mu F_n and that of the moment at most four times this fraction of mu F_n c. 0.003: forces
  /// within 0.2 %, the moment within 1 % (docs/tables.md).
  double largest_correction = 0.003;
  int most_across = 80;  ///< largest grid: 20, 40, 80 or 160
};

/// Forces at all creepages, in their order. Throws contact::InputError for shapes
/// and creepages out of range, contact::SolveError where one does not converge.
std::vector<EllipseForces> roll_ellipse(const EllipseShape& shape,
                                        const std::vector<ScaledCreepage>& creepages,
                                        const EllipseAccuracy& accuracy = {});

}  // namespace rollfem::halfspace
