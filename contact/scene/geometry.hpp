// What follows from a case without solving anything: relative curvatures, undeformed distance and
// rigid slip at a point. Conventions: docs/theory.md.
#pragma once

#include "contact/base/grid.hpp"
#include "contact/base/material.hpp"
#include "contact/case/case.hpp"

namespace rollfem::contact {

/// Undeformed distance h = A x^2 + B y^2 of the case's radii, or as the case gives it; with `patch`
/// that of the osculating paraboloids at the contact point.
struct Curvatures {
  double A = 0.0;  ///< 1/mm, 1/(2 R_x), along rolling
  double B = 0.0;  ///< 1/mm, (1/R_wheel,y + 1/R_rail,y) / 2, lateral
};
Curvatures relative_curvatures(const Case& input);

/// Undeformed distance h(x, y) >= 0 in mm at touching (approach 0).
double undeformed_distance(const Curvatures& curvatures, double x, double y);

/// Undeformed distance of the case at the element centres, mm: of its radii, its quadratic form,
/// its file or its patch (along z of the patch frame). Throws InputError when the grid reaches
/// beyond the points of the file.
Field undeformed_distance(const Case& input, const ContactGrid& grid);

/// Rigid slip of the wheel surface relative to the rail, V = 1:
/// (xi - phi y, eta + phi x) + extra rigid slip: (-z(y)/R, 0) with the drop z of the rail surface,
/// with a patch that of the local rolling radius beyond the geometric spin, or that of a file, when
/// the case asks for it. Throws InputError when the grid reaches beyond the points of the file.
TangentialField rigid_slip(const Case& input, const Creepage& creepage, const ContactGrid& grid);

/// Extra rigid slip alone.
TangentialField extra_slip(const Case& input, const ContactGrid& grid);

/// Rigid shift of a step over the rail, mm: (xi' - phi' y, eta' + phi' x), where the primed values
/// are the shifts of the step.
TangentialField rigid_shift(const HistoryStep& step, const ContactGrid& grid);

}  // namespace rollfem::contact
