// SPDX-License-Identifier: LGPL-2.1-or-later
// Displacements under a contact due to the loads of the other contacts of its wheel. Contacts in
// one plane displace each other as point loads on the half-space (Boussinesq, Cerruti; Johnson
// 1985, 3.2 and 3.6). Between contacts in different planes each body is a wedge, bounded by both
// planes: around a convex edge a load no longer presses the other plane in but pushes it out, and
// in a re-entrant corner it hardly moves it (docs/theory.md#around-a-corner).
#pragma once

#include "base/material.hpp"
#include "scene/geometry.hpp"
#include "scene/scene.hpp"

#include <vector>

namespace rollfem::halfspace {

/// A wedge's displacement under a point load less that of the half-space, along the axes of load
/// and point: x along the edge, t from the load towards the point across the edge, n into the body.
/// Dimensionless, times 1/(2 pi G rho) for one body, rho the distance on the rolled-out surface.
/// The first letter is the load's direction, the second the displacement's; of the others tx = xt,
/// nt = -tn, nx = -xn.
struct CornerChange {
  /// a + b (x/rho)^2, for xn and xt times x/rho.
  struct Term {
    double a = 0.0, b = 0.0;
  };
  Term nn, tn, xn, xx, tt, xt;
};

/// The change of both bodies together, weighted by their parts of 1/G; tn and xn of the rail are
/// subtracted from those of the wheel, as their tractions are opposite. `turn`: see NeighbourLoad;
/// 0 for contacts in one plane. Fitted for nu = 0.3 and distances from the edge in ratios up
/// to 2.5: within 0.04 (nn) of the wedge up to 60 degrees, 0.2 at 90; turns beyond 100 degrees
/// count as 100.
CornerChange corner_change(double turn, const contact::CombinedMaterial& material);

/// The tractions of a patch as point loads, one for each block of `along` by `across` elements with
/// pressure, at the centre of its pressure. `friction`: empty without.
void lump(const contact::ContactGrid& grid, const contact::Field& pressure,
          const contact::TangentialField& friction, double along, double across,
          std::vector<contact::NeighbourLoad>& loads);

/// Moves a load from its place on the grid of the contact `there` to the one beside `here`.
void place_beside(const contact::ContactPlace& here, const contact::ContactPlace& there,
                  contact::NeighbourLoad& load);

/// Normal displacement difference (wheel minus rail, mm) at the element centres: an extra distance;
/// empty without loads.
contact::Field neighbour_displacement(const std::vector<contact::NeighbourLoad>& loads,
                                      const contact::CombinedMaterial& material,
                                      const contact::ContactGrid& grid);

/// Slip of steady rolling by the loads, along x and y: -du/dx at the element centres; empty without
/// loads.
contact::TangentialField neighbour_slip(const std::vector<contact::NeighbourLoad>& loads,
                                        const contact::CombinedMaterial& material,
                                        const contact::ContactGrid& grid);

// The same, added to a field of the grid.
void add_displacement(const std::vector<contact::NeighbourLoad>& loads,
                      const contact::CombinedMaterial& material, const contact::ContactGrid& grid,
                      contact::Field& displacement);
void add_slip(const std::vector<contact::NeighbourLoad>& loads,
              const contact::CombinedMaterial& material, const contact::ContactGrid& grid,
              contact::TangentialField& slip);

}  // namespace rollfem::halfspace
