// SPDX-License-Identifier: LGPL-2.1-or-later
// Creepage (or shift) at which the contact transmits a prescribed tangential force: a bracketed
// secant method for one component, Broyden's method for two, on forces made nearly linear by the
// inverse of Vermeulen and Johnson's law (1964), |F| = mu F_z (1 - (1 - tau/3)^3). This removes
// most of the difficulty near full sliding, where the force hardly grows.
#pragma once

#include "scene/scene.hpp"

#include <Eigen/Core>

#include <functional>

namespace rollfem::contact {

/// F_x, F_y on the wheel (N) at a creepage (xi, eta), and the largest force friction allows there.
struct TransmittedForce {
  Eigen::Vector2d force;
  double bound = 0.0;  ///< mu F_z, N
};
using ForceLaw = std::function<TransmittedForce(const Eigen::Vector2d& creepage)>;

struct ForceSearch {
  Eigen::Vector2d start;      ///< prescribed components, and a guess of the unknown ones
  Eigen::Vector2d stiffness;  ///< -dF_x/dxi, -dF_y/deta without slip, N: the scale of the steps
  double tolerance = 1e-6;    ///< on the force, relative to mu F_z
  int max_evaluations = 100;
  bool has_peak =
      false;  ///< beyond some creepage the force may fall: steady rolling, falling friction
};

struct FoundCreepage {
  Eigen::Vector2d creepage;
  TransmittedForce transmitted;
  int evaluations = 0;
};

/// tau(F / bound), at most 3 in magnitude: creepage that the force needs by Vermeulen and Johnson's
/// law, in units of bound / stiffness.
double creepage_of_force(double relative_force);

/// Creepage (shift) for a force by that law with the stiffness of the case without slip; prescribed
/// components are kept.
Eigen::Vector2d first_creepage(const PrescribedForce& wanted, const Eigen::Vector2d& given,
                               const Eigen::Vector2d& stiffness, double bound);

/// Throws SolveError unless |F| < mu F_z, counting the prescribed components.
void refuse_force_beyond_friction(const PrescribedForce& wanted, double bound);

/// The last call of `law` is at the returned creepage. Throws SolveError when the force exceeds
/// friction, when no creepage transmits it, or when the search does not converge.
FoundCreepage find_creepage(const ForceLaw& law, const PrescribedForce& wanted,
                            const ForceSearch& search);

}  // namespace rollfem::contact
