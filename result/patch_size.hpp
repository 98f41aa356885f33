// SPDX-License-Identifier: LGPL-2.1-or-later
// Size of the contact patch below the element size, from the pressure: at the edge of a smooth
// contact p^2 falls linearly to zero.
#pragma once

#include "base/grid.hpp"
#include "base/members.hpp"

#include <vector>

namespace rollfem::contact {

struct PatchSize {
  double length = 0.0;  ///< mm, extent in x
  double width = 0.0;   ///< mm, extent in y
  double area = 0.0;    ///< mm^2
  /// Error of length and width, mm, from the shape of the pressure at their ends.
  double length_unsure = 0.0, width_unsure = 0.0;
  /// Ends of the patch, mm; of the outermost ones where it falls into several regions.
  double x_lower = 0.0, x_upper = 0.0, y_lower = 0.0, y_upper = 0.0;

  double x_middle() const { return 0.5 * (x_lower + x_upper); }
  double y_middle() const { return 0.5 * (y_lower + y_upper); }
};

/// The edge along every row and column of elements follows from p^2 of the last three elements,
/// corrected for the known behaviour of a solved contact's elements at an edge; p^2 of a pressure
/// sampled at element centres is extrapolated unchanged. With too few elements, or if the pressure
/// does not fall to an edge (a punch), the element's border is the edge. Repeated calls of a thread
/// allocate nothing.
PatchSize patch_size(const ContactGrid& grid, const Field& pressure);

/// A row of fewer elements than this has its edges at element borders: each end of the patch is
/// then known only to within one element.
inline constexpr int elements_for_edge = 5;

/// Whether an element at the border of the grid carries pressure: the potential contact area is
/// then too small.
bool touches_border(const ContactGrid& grid, const Field& pressure);

// Separate regions of a contact: the position of each and the force it carries.

struct ContactFields;

/// One region of elements with pressure, which meet at sides or corners. On a curved patch y is
/// that of the grid (arc length where it is one) and the forces are the sums of the tractions along
/// the local tangents and normal.
struct PatchPart {
  double x = 0.0, y = 0.0, length = 0.0, width = 0.0;
  double normal_force = 0.0, longitudinal_force = 0.0, lateral_force = 0.0, max_pressure = 0.0;

  static constexpr auto members() {
    using P = PatchPart;
    return std::tuple(
        member("x", &P::x, "mm", "centre of pressure"), member("y", &P::y, "mm", "the same"),
        member("length", &P::length, "mm", "extent in x, found below the element size"),
        member("width", &P::width, "mm", "extent in y"),
        member("normal_force", &P::normal_force, "N"),
        member("longitudinal_force", &P::longitudinal_force, "N", "on the wheel"),
        member("lateral_force", &P::lateral_force, "N", "on the wheel"),
        member("max_pressure", &P::max_pressure, "MPa"));
  }
};

/// The most loaded first. Empty without pressure.
std::vector<PatchPart> patch_parts(const ContactGrid& grid, const ContactFields& fields);

/// Number of regions.
int count_parts(const ContactGrid& grid, const Field& pressure);

}  // namespace rollfem::contact
