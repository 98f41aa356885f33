// SPDX-License-Identifier: LGPL-2.1-or-later
// How the surfaces of wheel and rail take heat while they roll: each is a half-space that conducts
// into its depth alone, because a patch moves on by its length long before heat has gone as far
// (Peclet number V a / kappa above 10).
#pragma once

#include "base/grid.hpp"
#include "case/case.hpp"

#include <cmath>
#include <optional>

namespace rollfem::contact {

struct HeatedBody {
  double effusivity = 0.0;   ///< beta = sqrt(lambda rho c), N/(mm K s^0.5)
  double diffusivity = 0.0;  ///< kappa = lambda / (rho c), mm^2/s
  double expansion = 0.0;    ///< alpha, 1/K
  double temperature = 0.0;  ///< degC, before contact
  double limit = 0.0;        ///< degC, above which results warn
};

struct SurfaceHeat {
  HeatedBody wheel, rail;
  double speed = 0.0;  ///< mm/s

  /// Of both surfaces where they touch before friction heats them, degC: bodies at unlike
  /// temperatures meet in between (Carslaw and Jaeger 1959, 2.15).
  double contact_temperature() const {
    return (wheel.effusivity * wheel.temperature + rail.effusivity * rail.temperature) /
           effusivity();
  }
  /// Of both surfaces together, where they touch.
  double effusivity() const { return wheel.effusivity + rail.effusivity; }
  /// Depth (mm) to which heat has gone in a body when it has passed this length (mm).
  double layer(const HeatedBody& body, double length) const {
    return std::sqrt(body.diffusivity * length / speed);
  }
  /// Warming (K mm s/N) of a surface of effusivity 1 by a heat flow of 1 N/(mm s) through each of
  /// `count` elements of length dx that it has passed, its own first, to the middle of which heat
  /// flows for half an element (Carslaw and Jaeger 1959, 2.9).
  Field warming(double dx, int count) const;
};

/// None where neither body gives its heat and friction does not follow it.
std::optional<SurfaceHeat> surface_heat(const Case& input);

}  // namespace rollfem::contact
