// SPDX-License-Identifier: LGPL-2.1-or-later
// Quantities derived from a solution without solving again: elastic energy, frictional power and
// where on the profiles it is dissipated. Signs as everywhere: tractions and forces on the wheel,
// slip of the wheel relative to the rail.
#pragma once

#include "result/result.hpp"
#include "scene/geometry.hpp"

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

/// The same of a load point on its grid, from ContactFields::work; empty where there is none.
Field pass_work(const ContactGrid& grid, const PointResult& point);

/// -d/dx of a field by central differences, 0 at the ends of the rows. With it a symmetric
/// operator that is the same everywhere, u = A p, has sum p . D u = 0, as in the continuum.
Field slope_along(const ContactGrid& grid, const Field& values);

/// Sets ContactFields::work and `max_pass_work` of a load point for this work of its rows (N/mm).
/// In a row, elements have -p_t . w of their own. What is missing belongs to a slip zone that they
/// do not resolve, at the trailing edge: it is shared by the elements that slip as their traction,
/// or goes to the last element in contact. A row that has too much is reduced in proportion.
void set_pass_work(const ContactGrid& grid, const Field& rows, PointResult& point);

/// Sets `frictional_work`, its distribution and `creepage_work` of a solution on elements in steady
/// rolling. `rigid_slip` is the slip without the slope of the displacement, `extra_slip` that
/// beyond the creepages. Slopes are central differences: the solver's upwind differences lose the
/// work of slip zones thinner than an element. How much a row misses depends on where the edges of
/// the patch lie within an element, so neighbouring rows are evened out. `half_spaces`:
/// `creepage_work` has the part of the pressure too, with which it equals `frictional_work`; the
/// pressure of other bodies also moves by their shape.
void set_works(const ContactGrid& grid, const PatchShape& shape, const TangentialField& rigid_slip,
               const TangentialField& extra_slip, bool half_spaces, PointResult& point);

/// Sets `frictional_work` and its distribution from a slip by central differences on a plane grid.
void set_works(const ContactGrid& grid, const TangentialField& central_slip, PointResult& point);

/// Approach of bodies under Hertz's pressure p, mm: 7/6 of the mean of u_n = delta - A x^2 - B y^2
/// with the weight p^3, which edges hardly reach, because A a^2 + B b^2 = delta.
double approach_of_ellipsoid(const ContactFields& fields);

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
