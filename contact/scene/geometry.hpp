// SPDX-License-Identifier: LGPL-2.1-or-later
// The geometry of a contact, independent of the solver: undeformed distance, rigid slip, and the
// shape of the surface on which the contact grid lies. Covers radii, true profiles, quadratic
// forms and values from files; conventions: docs/theory.md.
#pragma once

#include "contact/base/grid.hpp"
#include "contact/base/material.hpp"
#include "contact/scene/contact_surface.hpp"

#include <string>

namespace rollfem::contact {

/// Rollers without ends across, in plane strain.
struct LineContact {
  double width = 1.0;      ///< mm across that all forces are of
  double reference = 0.0;  ///< mm, ContactGrid::line_reference
};

/// What wheel and rail are to the contact: their surfaces, and what a case gives in their place.
struct Geometry {
  Geometry() = default;
  Geometry(
      const Case& input);  // NOLINT(google-explicit-constructor): a case is a geometry's source

  ContactSurface surface;  ///< radii or true profiles; flat where the case gives none
  std::optional<std::array<double, 2>> quadratic;  ///< A, B in 1/mm, in place of the surfaces
  std::optional<Lattice> distance_values;          ///< h in mm, in place of the surfaces
  ExtraSlip extra_slip = ExtraSlip::automatic;
  std::optional<Lattice> extra_slip_values;  ///< columns s_x, s_y; for ExtraSlip::file
  std::optional<LineContact> line;           ///< else a point contact

  bool has_profiles() const { return surface.profiles != nullptr; }
  /// The surfaces themselves say the distance: no quadratic form or file does.
  bool has_surfaces() const { return !quadratic && !distance_values; }
};

/// How the contact grid lies on the contact.
enum class Chart {
  plane,      ///< in the tangent plane at the origin; distance along z
  projected,  ///< over the projection of the common surface on that plane; distance along its
              ///< normal
  arc,        ///< along the common surface: the grid's y is arc length; distance along its normal
};

/// Undeformed distance h = A x^2 + B y^2 of the radii, or as the case gives it; of profiles that of
/// the osculating paraboloids at the contact point.
struct Curvatures {
  double A = 0.0;  ///< 1/mm, 1/(2 R_x), along rolling
  double B = 0.0;  ///< 1/mm, (1/R_wheel,y + 1/R_rail,y) / 2, lateral
};
Curvatures relative_curvatures(const Geometry& geometry);

/// h(x, y) >= 0 in mm at touching (approach 0).
double undeformed_distance(const Curvatures& curvatures, double x, double y);

/// A geometry seen through a chart. Fields are those at the element centres of a grid.
class ChartedGeometry {
 public:
  ChartedGeometry(Geometry geometry, Chart chart);

  const Geometry& geometry() const { return geometry_; }
  bool curved() const { return chart_ != Chart::plane; }

  /// y of the patch frame at the grid's lateral coordinate, mm.
  double lateral_place(double grid_y) const;
  /// dz/dy of the surface that the grid lies on; 0 in the plane.
  double climb(double grid_y) const;

  /// Empty in the plane.
  PatchShape shape(const ContactGrid& grid) const;

  /// Distance from rail to wheel, mm, counted from touching (of profiles that hold several patches
  /// at the height under load, PatchGeometry::under_load): along z in the plane, else along the
  /// normal of the common surface; as given where the case gives it. Profiles count with their
  /// means over the elements across (HeightCurve::averaging). Throws InputError when the grid
  /// reaches beyond the points of a file.
  Field undeformed_distance(const ContactGrid& grid) const;
  /// The same into a field that is kept.
  void undeformed_distance(const ContactGrid& grid, Field& distance) const;

  /// Rigid slip of the wheel over the rail, V = 1, along x and the lateral tangent, from the
  /// velocities of two rigid bodies: the wheel turns with omega = (1 - xi)/rho(0) about its axle e,
  /// at y its surface has the radius rho(y), and the tilt of the axle makes omega e_z of the spin
  /// phi by itself. With beyond = phi - omega e_z and the climb tan(alpha):
  ///   s_x = xi + omega (rho(0) - rho(y)) - beyond y,
  ///   s_y = (eta + beyond x) cos(alpha) + omega x (e_z cos(alpha) - e_y sin(alpha)).
  /// A flat wheel leaves (xi - phi y, eta + phi x). ExtraSlip::none leaves that for any surface,
  /// ExtraSlip::file adds the file's values to it. Throws as undeformed_distance does.
  TangentialField rigid_slip(const Creepage& creepage, const ContactGrid& grid) const;

  /// What rigid_slip has beyond (xi - phi y, eta + phi x), y that of the grid.
  TangentialField extra_slip(const Creepage& creepage, const ContactGrid& grid) const;

 private:
  bool is_this_contact(double y) const;
  /// Adds what the means of profiles over the elements change their distance by, mm.
  void add_averaging(const ContactGrid& grid, Field& distance) const;

  Geometry geometry_;
  Chart chart_;
  HeightCurve place_;  ///< y over arc length; Chart::arc
};

/// (xi - phi y, eta + phi x) at the element centres; as well a rigid shift in mm and rad.
TangentialField uniform_slip(const Creepage& creepage, const ContactGrid& grid);

/// The largest extra slip along x that the surface brings between y_lower and y_upper (mm), 0 where
/// it brings none: what a theory that knows no extra slip leaves out.
double largest_extra_slip(const Geometry& geometry, double y_lower, double y_upper);

// Slip due to the curvature of the wheel's streamlines.

/// On a streamline of radius R(y) a displacement u_r towards the axle brings the slip u_r / R along
/// x, since it shortens the circle; on a surface tilted across -sin u_x / R laterally, as the
/// lateral tangent turns. Together with the difference along the streamline it gives the surface
/// strain, so that a rigid displacement slips nowhere.
class CurvatureSlip {
 public:
  /// On the elements of a grid along y.
  CurvatureSlip(const ContactSurface& surface, const ContactGrid& grid);
  /// The surface at each element: climb and stretch, rolling radius in mm, angle of the axle in rad
  /// (ContactSurface).
  CurvatureSlip(const PatchShape& shape, const Field& rolling_radius, double axle_tilt);

  /// Under displacements of the wheel along x, the lateral tangent and the normal, mm.
  TangentialField operator()(const SurfaceField& displacement) const;

 private:
  /// Of normal and lateral tangent along the way to the axle, over the radius, 1/mm.
  Field normal_, lateral_;
};

/// A sentence with what to do for a potential contact area that ends at y, mm; empty unless both
/// bodies are circles that have ended there: straight flanks as steep as each other touch as far as
/// they go.
std::string why_flanks_touch(const Geometry& geometry, double y);

}  // namespace rollfem::contact
