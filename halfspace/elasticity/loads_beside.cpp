#include "halfspace/elasticity/loads_beside.hpp"

#include "contact/base/pi.hpp"

#include <cmath>

namespace rollfem::halfspace {

using contact::CombinedMaterial;
using contact::ContactGrid;
using contact::Field;
using contact::LoadBeside;
using contact::TangentialField;

double displacement_beside(const std::vector<LoadBeside>& loads, const CombinedMaterial& material,
                           double x, double y) {
  double sum = 0.0;
  for (const LoadBeside& load : loads) sum += load.normal / std::hypot(x - load.x, y - load.y);
  return sum / (contact::pi * material.contact_modulus);
}

Field displacement_beside(const std::vector<LoadBeside>& loads, const CombinedMaterial& material,
                          const ContactGrid& grid) {
  if (loads.empty()) return {};
  return grid.sample(
      [&](double x, double y) { return displacement_beside(loads, material, x, y); });
}

TangentialField slip_beside(const std::vector<LoadBeside>& loads, const CombinedMaterial& material,
                            const ContactGrid& grid) {
  if (loads.empty()) return {};
  const double nu = material.poisson_ratio;
  TangentialField slip{Field::Zero(grid.size()), Field::Zero(grid.size())};
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      for (const LoadBeside& load : loads) {
        const double x = grid.x(i) - load.x, y = grid.y(j) - load.y;
        const double square = x * x + y * y;
        const double cube = square * std::sqrt(square);
        const double xx = x * x / square, yy = y * y / square;
        // Derivatives by x of ((1 - nu) + nu x^2/r^2)/r, nu x y/r^3 and ((1 - nu) + nu y^2/r^2)/r.
        const double along = x / cube * (nu * (2.0 - 3.0 * xx) - (1.0 - nu));
        const double mixed = nu * y / cube * (1.0 - 3.0 * xx);
        const double across = -x / cube * ((1.0 - nu) + 3.0 * nu * yy);
        const int k = grid.index(i, j);
        slip.x[k] -= along * load.longitudinal + mixed * load.lateral;
        slip.y[k] -= mixed * load.longitudinal + across * load.lateral;
      }
  const double factor = 1.0 / (contact::pi * material.shear_modulus);
  return {factor * slip.x, factor * slip.y};
}

}  // namespace rollfem::halfspace
