// SPDX-License-Identifier: LGPL-2.1-or-later
// The geometry of a contact, independent of the solver: undeformed distance, rigid slip, and the
// shape of the surface on which the contact grid lies. Covers radii, true profiles, quadratic
// forms and values from files; conventions: docs/theory.md.
#pragma once

#include "base/grid.hpp"
#include "base/material.hpp"
#include "scene/contact_surface.hpp"

#include <string>

namespace rollfem::contact {

/// Endless rollers in plane strain.
struct LineContact {
  double width = 1.0;      ///< mm, width to which all forces refer
  double reference = 0.0;  ///< mm, ContactGrid::line_reference
};

/// Contact geometry of wheel and rail: their surfaces, or the data given instead.
struct Geometry {
  Geometry() = default;
  Geometry(
      const Case& input);  // NOLINT(google-explicit-constructor): a case is a geometry's source

  ContactSurface surface;  ///< radii or true profiles; flat if the case gives none
  std::optional<std::array<double, 2>> quadratic;  ///< A, B in 1/mm, instead of the surfaces
  std::optional<Lattice> distance_values;          ///< h in mm, instead of the surfaces
  ExtraSlip extra_slip = ExtraSlip::automatic;
  std::optional<Lattice> extra_slip_values;  ///< columns s_x, s_y; for ExtraSlip::file
  std::optional<LineContact> line;           ///< otherwise a point contact

  bool has_profiles() const { return surface.profiles != nullptr; }
  /// Whether the surfaces determine the distance, rather than a quadratic form or a file.
  bool has_surfaces() const { return !quadratic && !distance_values; }
};

/// Position of the contact grid on the contact surface.
enum class Chart {
  plane,      ///< in the tangent plane at the origin; distance along z
  projected,  ///< over the projection of the common surface on that plane; distance along its
              ///< normal
  arc,        ///< along the common surface: the grid's y is arc length; distance along its normal
};

/// Undeformed distance h = A x^2 + B y^2 of the radii, or as given in the case; for profiles, of
/// the osculating paraboloids at the contact point.
struct Curvatures {
  double A = 0.0;  ///< 1/mm, 1/(2 R_x), along rolling
  double B = 0.0;  ///< 1/mm, (1/R_wheel,y + 1/R_rail,y) / 2, lateral
};
Curvatures relative_curvatures(const Geometry& geometry);

/// h(x, y) >= 0 in mm at touching (approach 0).
double undeformed_distance(const Curvatures& curvatures, double x, double y);

/// A geometry in the coordinates of a chart. Fields are evaluated at the element centres of a grid.
class ChartedGeometry {
 public:
  ChartedGeometry(Geometry geometry, Chart chart);

  const Geometry& geometry() const { return geometry_; }
  bool curved() const { return chart_ != Chart::plane; }

  /// y of the patch frame at the grid's lateral coordinate, mm.
  double lateral_place(double grid_y) const;
  /// dz/dy of the grid's surface; 0 in the plane.
  double climb(double grid_y) const;

  /// Empty in the plane.
  PatchShape shape(const ContactGrid& grid) const;

  /// Undeformed distance from rail to wheel, mm, measured from first touch (for profiles with
  /// several patches at the height under load, PatchGeometry::under_load): along z in the plane,
  /// otherwise along the normal of the common surface; a distance given in the case is used as
  /// given. Profiles enter with their lateral means over the elements (HeightCurve::averaging).
  /// Throws InputError when the grid extends beyond the points of a file.
  Field undeformed_distance(const ContactGrid& grid) const;
  /// The same into an existing field.
  void undeformed_distance(const ContactGrid& grid, Field& distance) const;

  /// Rigid slip of the wheel over the rail, V = 1, along x and the lateral tangent, from the
  /// velocities of two rigid bodies: the wheel turns with omega = (1 - xi)/rho(0) about its axle e,
  /// at y its surface has the radius rho(y), and the tilt of the axle contributes omega e_z to the
  /// spin phi. With beyond = phi - omega e_z and the climb tan(alpha):
  ///   s_x = xi + omega (rho(0) - rho(y)) - beyond y,
  ///   s_y = (eta + beyond x) cos(alpha) + omega x (e_z cos(alpha) - e_y sin(alpha)).
  /// A roller turns with 1/R_r about its axle g: 1 becomes rho_r(0)/R_r in omega and adds
  ///   (rho_r(y) - rho_r(0))/R_r to s_x, x (g_z cos(alpha) - g_y sin(alpha))/R_r to s_y, and
  ///   beyond = phi - omega e_z - g_z/R_r; V is the speed of its surface at the radius R_r.
  /// A flat wheel on a straight rail leaves (xi - phi y, eta + phi x). ExtraSlip::none uses this
  /// for any surface, ExtraSlip::file adds the file's values to it. Throws as undeformed_distance.
  TangentialField rigid_slip(const Creepage& creepage, const ContactGrid& grid) const;
  /// The same into an existing field.
  void rigid_slip(const Creepage& creepage, const ContactGrid& grid, TangentialField& slip) const;

  /// rigid_slip less (xi - phi y, eta + phi x), with y of the grid.
  TangentialField extra_slip(const Creepage& creepage, const ContactGrid& grid) const;

 private:
  bool is_this_contact(double y) const;
  /// Adds the change of the distance by averaging profiles over the elements, mm.
  void add_averaging(const ContactGrid& grid, Field& distance) const;

  Geometry geometry_;
  Chart chart_;
  HeightCurve place_;  ///< y over arc length; Chart::arc
};

/// (xi - phi y, eta + phi x) at the element centres; also a rigid shift in mm and rad.
TangentialField uniform_slip(const Creepage& creepage, const ContactGrid& grid);

/// The largest extra slip along x from the surface between y_lower and y_upper (mm), 0 if none:
/// neglected by a theory without extra slip.
double largest_extra_slip(const Geometry& geometry, double y_lower, double y_upper);

// Slip due to the curvature of the wheel's streamlines.

/// On a streamline of radius R(y) a displacement u_r towards the axle causes the slip u_r / R along
/// x, since it shortens the circle; on a surface tilted across -sin u_x / R laterally, as the
/// lateral tangent turns. Together with the difference along the streamline it gives the surface
/// strain, so that a rigid displacement causes no slip.
class CurvatureSlip {
 public:
  /// On the elements of a grid along y. Of a roller, whose axle lies below: under displacements of
  /// the rail, to be subtracted.
  CurvatureSlip(const ContactSurface& surface, const ContactGrid& grid, bool wheel = true);
  /// The surface at each element: climb and stretch, rolling radius in mm, angle of the axle in rad
  /// (ContactSurface).
  CurvatureSlip(const PatchShape& shape, const Field& rolling_radius, double axle_tilt);

  /// Under displacements of the wheel along x, the lateral tangent and the normal, mm.
  TangentialField operator()(const SurfaceField& displacement) const;

 private:
  /// Components of normal and lateral tangent towards the axle, divided by the radius, 1/mm.
  Field normal_, lateral_;
};

/// Advice for a potential contact area that ends at y, mm; empty unless both circles have ended
/// there: equally steep straight flanks touch along their whole length.
std::string why_flanks_touch(const Geometry& geometry, double y);

}  // namespace rollfem::contact
