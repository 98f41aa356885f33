// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/elasticity/neighbours.hpp"

#include "base/pi.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::halfspace {

using contact::CombinedMaterial;
using contact::ContactGrid;
using contact::Field;
using contact::NeighbourLoad;
using contact::TangentialField;

namespace {

using Term = CornerChange::Term;

/// Coefficients of turn, turn^2, ... turn^5 of the two numbers of a term.
struct TermOfTurn {
  std::array<double, 5> a, b;
};

// Least squares over wedges of 80 to 270 degrees that were solved by finite elements in the
// section and a Fourier integral along the edge (benchmarks/corner.py).
constexpr TermOfTurn nn_of{{0.205, -0.315, -0.090, -0.102, -0.072},
                           {-0.150, -0.034, 0.099, 0.048, 0.003}};
constexpr TermOfTurn tn_of{{-0.803, -0.499, -0.053, -0.066, -0.039},
                           {0.099, 0.301, 0.132, 0.016, 0.001}};
constexpr TermOfTurn xn_of{{-0.080, -0.178, -0.061, -0.042, -0.022},
                           {0.096, 0.123, 0.065, 0.053, 0.023}};
constexpr TermOfTurn xx_of{{0.275, 0.054, 0.035, 0.022, 0.003},
                           {0.221, 0.080, 0.024, 0.010, -0.001}};
constexpr TermOfTurn tt_of{{1.159, -0.014, -0.031, 0.063, 0.001},
                           {-0.743, -0.195, 0.052, -0.007, -0.004}};
constexpr TermOfTurn xt_of{{0.581, 0.206, 0.031, 0.034, 0.010},
                           {-0.417, -0.188, -0.057, -0.037, -0.008}};
/// Largest turn of those wedges, rad.
constexpr double largest_turn = contact::pi / 1.8;

double polynomial(const std::array<double, 5>& of, double turn) {
  double sum = 0.0;
  for (std::size_t n = of.size(); n-- > 0;) sum = (sum + of[n]) * turn;
  return sum;
}

/// d/dx of (a + b xi^2)/rho times rho^2, xi = x/rho.
double slope_even(const Term& term, double xi) {
  return xi * (2.0 * term.b - term.a - 3.0 * term.b * xi * xi);
}

/// d/dx of (a + b xi^2) xi/rho times rho^2.
double slope_odd(const Term& term, double xi) {
  const double square = xi * xi;
  return term.a + (3.0 * term.b - 2.0 * term.a) * square - 4.0 * term.b * square * square;
}

/// The part of the half-space and that of the corner, times pi G.
double displacement_under(const NeighbourLoad& load, const CornerChange& corner, double flat,
                          double x, double y) {
  const double rho = std::hypot(x, y), xi = x / rho, towards = y < 0.0 ? -1.0 : 1.0;
  const auto at = [&](const Term& term) { return term.a + term.b * xi * xi; };
  return ((flat + at(corner.nn)) * load.normal + towards * at(corner.tn) * load.lateral +
          xi * at(corner.xn) * load.longitudinal) /
         rho;
}

/// -du/dx of the corner's part, times pi G.
std::array<double, 2> corner_slip(const NeighbourLoad& load, const CornerChange& corner, double x,
                                  double y) {
  const double square = x * x + y * y, xi = x / std::sqrt(square);
  const double towards = y < 0.0 ? -1.0 : 1.0, across = towards * load.lateral;
  const double along = slope_even(corner.xx, xi) * load.longitudinal +
                       slope_odd(corner.xt, xi) * across - slope_odd(corner.xn, xi) * load.normal;
  const double off = slope_odd(corner.xt, xi) * load.longitudinal +
                     slope_even(corner.tt, xi) * across - slope_even(corner.tn, xi) * load.normal;
  return {-along / square, -towards * off / square};
}

/// -du/dx of the half-space, times pi G.
std::array<double, 2> flat_slip(const NeighbourLoad& load, double nu, double x, double y) {
  const double square = x * x + y * y;
  const double cube = square * std::sqrt(square);
  const double xx = x * x / square, yy = y * y / square;
  // Derivatives by x of ((1 - nu) + nu x^2/r^2)/r, nu x y/r^3 and ((1 - nu) + nu y^2/r^2)/r.
  const double along = x / cube * (nu * (2.0 - 3.0 * xx) - (1.0 - nu));
  const double mixed = nu * y / cube * (1.0 - 3.0 * xx);
  const double across = -x / cube * ((1.0 - nu) + 3.0 * nu * yy);
  return {-along * load.longitudinal - mixed * load.lateral,
          -mixed * load.longitudinal - across * load.lateral};
}

}  // namespace

CornerChange corner_change(double turn, const CombinedMaterial& material) {
  const double rail_turn = std::clamp(turn, -largest_turn, largest_turn);
  const double wheel = material.wheel_share, rail = 1.0 - wheel;
  // Where the rail is convex, the wheel is re-entrant.
  const auto both = [&](const TermOfTurn& of, double sign) {
    return Term{wheel * polynomial(of.a, -rail_turn) + sign * rail * polynomial(of.a, rail_turn),
                wheel * polynomial(of.b, -rail_turn) + sign * rail * polynomial(of.b, rail_turn)};
  };
  return {both(nn_of, 1.0), both(tn_of, -1.0), both(xn_of, -1.0),
          both(xx_of, 1.0), both(tt_of, 1.0),  both(xt_of, 1.0)};
}

void lump(const ContactGrid& grid, const Field& pressure, const TangentialField& friction,
          double along, double across, std::vector<NeighbourLoad>& loads) {
  const auto block = [](int element, double size) {
    return static_cast<std::size_t>(element / size);
  };
  const std::size_t blocks_along = block(grid.nx - 1, along) + 1;
  loads.assign(blocks_along * (block(grid.ny - 1, across) + 1), {});
  const double area = grid.element_area();
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const int k = grid.index(i, j);
      if (!(pressure[k] > 0.0)) continue;
      NeighbourLoad& load = loads[block(j, across) * blocks_along + block(i, along)];
      const double normal = area * pressure[k];
      load.normal += normal;
      load.x += normal * grid.x(i);
      load.y += normal * grid.y(j);
      if (friction.x.size() == 0) continue;
      load.longitudinal += area * friction.x[k];
      load.lateral += area * friction.y[k];
    }
  const auto is_empty = [](const NeighbourLoad& load) { return !(load.normal > 0.0); };
  loads.erase(std::remove_if(loads.begin(), loads.end(), is_empty), loads.end());
  for (NeighbourLoad& load : loads) {
    load.x /= load.normal;
    load.y /= load.normal;
  }
}

void place_beside(const contact::ContactPlace& here, const contact::ContactPlace& there,
                  NeighbourLoad& load) {
  load.x += there.x_track - here.x_track;
  load.y += here.outward() * (there.way_across - here.way_across);
  load.turn = contact::turn_between(here, there);
}

void add_displacement(const std::vector<NeighbourLoad>& loads, const CombinedMaterial& material,
                      const ContactGrid& grid, Field& displacement) {
  const double flat = material.shear_modulus / material.contact_modulus;
  const double factor = 1.0 / (contact::pi * material.shear_modulus);
  for (const NeighbourLoad& load : loads) {
    const CornerChange corner = corner_change(load.turn, material);
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
        displacement[grid.index(i, j)] +=
            factor * displacement_under(load, corner, flat, grid.x(i) - load.x, grid.y(j) - load.y);
  }
}

void add_slip(const std::vector<NeighbourLoad>& loads, const CombinedMaterial& material,
              const ContactGrid& grid, TangentialField& slip) {
  const double factor = 1.0 / (contact::pi * material.shear_modulus);
  for (const NeighbourLoad& load : loads) {
    const CornerChange corner = corner_change(load.turn, material);
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i) {
        const double x = grid.x(i) - load.x, y = grid.y(j) - load.y;
        const auto flat = flat_slip(load, material.poisson_ratio, x, y);
        const auto turned = corner_slip(load, corner, x, y);
        slip.x[grid.index(i, j)] += factor * (flat[0] + turned[0]);
        slip.y[grid.index(i, j)] += factor * (flat[1] + turned[1]);
      }
  }
}

Field neighbour_displacement(const std::vector<NeighbourLoad>& loads,
                             const CombinedMaterial& material, const ContactGrid& grid) {
  if (loads.empty()) return {};
  Field displacement = Field::Zero(grid.size());
  add_displacement(loads, material, grid, displacement);
  return displacement;
}

TangentialField neighbour_slip(const std::vector<NeighbourLoad>& loads,
                               const CombinedMaterial& material, const ContactGrid& grid) {
  if (loads.empty()) return {};
  TangentialField slip{Field::Zero(grid.size()), Field::Zero(grid.size())};
  add_slip(loads, material, grid, slip);
  return slip;
}

}  // namespace rollfem::halfspace
