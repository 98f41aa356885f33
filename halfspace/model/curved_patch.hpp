// Curved contact in the half-space: contact elements along the arc of the common surface of wheel
// and rail, distance along its normal, slip of the local rolling radius, forces by local normals;
// the compliance is that of the surface rolled out flat (docs/theories.md, "Curved contact").
#pragma once

#include "contact/base/grid.hpp"
#include "contact/case/case.hpp"

#include <memory>

namespace rollfem::halfspace {

/// The common surface: mean of both sections at x = 0, by arc length s from the origin, which is
/// the grid's y. Its normal is (0, -sin, cos) of the angle whose tangent is `climb`.
class CurvedPatch {
 public:
  /// Of the patch, or of the radii (true circles). Throws contact::InputError for what a case of
  /// [halfspace] surface = "curved" cannot have.
  explicit CurvedPatch(const contact::Case& input);

  double y(double s) const { return y_.at(s).value; }  ///< mm, of the patch frame
  double climb(double s) const;                        ///< dz/dy

  /// Cosine of the angle at the elements.
  contact::Field cosine(const contact::ContactGrid& grid) const;
  /// For integrate_tractions: elements lie along the surface.
  contact::PatchShape shape(const contact::ContactGrid& grid) const;
  /// Distance from rail to wheel along the local normal, mm.
  contact::Field undeformed_distance(const contact::ContactGrid& grid) const;
  /// Rigid slip along x and along the local tangent, V = 1. The wheel turns with 1 - xi about its
  /// axle (e), at the radius rho(s): s_x = 1 - (1 - xi) rho / rho_0 - (phi - phi_g) y with the
  /// geometric spin phi_g = (1 - xi) e_z / rho_0, and across
  /// (eta + (phi - phi_g) x) cos + (1 - xi) x (e . n) / rho_0: the spin about the local normal.
  contact::TangentialField rigid_slip(const contact::Creepage& creepage,
                                      const contact::ContactGrid& grid) const;

 private:
  double way_along_normal(bool wheel, double x, double s) const;

  std::shared_ptr<const contact::PatchGeometry> patch_;
  contact::HeightCurve y_;  ///< y over s
};

}  // namespace rollfem::halfspace
