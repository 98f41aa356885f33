// Hooke's law in finite elements, in one place: stress from the displacement gradient.
#pragma once

#include "contact/case.hpp"

#include <deal.II/base/tensor.h>

#include <array>

namespace rollfem::fem {

/// Stress xx yy zz xy yz xz in MPa of a displacement gradient g[i][j] = du_i / dx_j.
inline std::array<double, 6> hooke(const contact::Material& material,
                                   const dealii::Tensor<2, 3>& g) {
  const double nu = material.poisson_ratio;
  const double mu = material.young_modulus / (2 * (1 + nu));
  const double spherical = 2 * mu * nu / (1 - 2 * nu) * dealii::trace(g);
  return {spherical + 2 * mu * g[0][0], spherical + 2 * mu * g[1][1], spherical + 2 * mu * g[2][2],
          mu * (g[0][1] + g[1][0]),     mu * (g[1][2] + g[2][1]),     mu * (g[0][2] + g[2][0])};
}

}  // namespace rollfem::fem
