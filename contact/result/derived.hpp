// SPDX-License-Identifier: LGPL-2.1-or-later
// Quantities derived from a solution without solving again: elastic energy, frictional power and
// where on the profiles it is dissipated. Signs as everywhere: tractions and forces on the wheel,
// slip of the wheel relative to the rail.
#pragma once

#include "contact/result/result.hpp"
#include "contact/scene/geometry.hpp"

#include <string>

namespace rollfem::contact {

/// Elastic energy of both bodies, 1/2 sum (p_x u_x + p_y u_y + p_n u_n) dx dy in N mm, u the
/// displacement difference caused by these tractions. Throws InputError when the fields do not
/// match the grid (a theory without displacement has no energy).
double elastic_energy(const ContactGrid& grid, const SurfaceField& traction,
                      const SurfaceField& displacement);

/// Tractions per unit of area of the grid.
SurfaceField times_stretch(const SurfaceField& traction, const PatchShape& shape);

/// Frictional work per pass and area in every row of the grid, N/mm (N mm/mm^2), -sum (p_t . w) dx:
/// what a strip of wheel or rail receives while the contact passes over it once in steady rolling.
/// The sum over the rows, times their widths along the surface, is the frictional work per mm
/// rolled. Throws InputError when the fields do not match the grid.
Field pass_work(const ContactGrid& grid, const SurfaceField& traction, const TangentialField& slip);

/// The same of a load point of a result; empty where there is none.
Field pass_work(const ModelResult& model, const PointResult& point);

/// The rows of a result on the profiles (ModelResult::rows) with its grid in the chart of
/// `geometry`, and for every load point with work where the largest one lies, and the work per
/// revolution of the wheel.
void place_pass_work(const ChartedGeometry& geometry, const std::optional<ContactPlace>& place,
                     ModelResult& result);

/// The powers of friction and of the creep forces in rolling with the speed V (mm/s). They are
/// equal in steady rolling of like half-spaces.
struct PowerBalance {
  /// N mm/s (mW), V sum pass_work dy, from tractions and slip at the same points; not negative for
  /// a solution of Coulomb's law.
  double friction = 0.0;
  /// N mm/s, -V (xi F_x + eta F_y + phi M_z), M_z about the origin; by `extra_slip` (empty: none)
  /// also -V sum (p_t . s_extra) dx dy.
  double creepage = 0.0;
  double difference = 0.0;  ///< |friction - creepage| / max of the two; 0 when both vanish
};
PowerBalance power_balance(const ContactGrid& grid, const SurfaceField& traction,
                           const TangentialField& slip, const Creepage& creepage, double speed,
                           const TangentialField& extra_slip = {});

/// Whether a creepage or shift, by name, is a result: found for a prescribed force. Its statement
/// of the error tells.
bool found_for_force(const PointResult& point, const std::string& name);

}  // namespace rollfem::contact
