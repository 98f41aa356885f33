// Separate regions of a contact: the position of each and the force it carries.
#pragma once

#include "contact/base/grid.hpp"

#include <vector>

namespace rollfem::contact {

struct ContactFields;

/// One region of elements with pressure, which meet at sides or corners. On a curved patch y is
/// that of the grid (arc length where it is one) and the forces are the sums of the tractions along
/// the local tangents and normal.
struct PatchPart {
  double x = 0.0, y = 0.0;          ///< mm, centre of pressure
  double length = 0.0;              ///< mm, extent in x, found below the element size
  double width = 0.0;               ///< mm, extent in y
  double normal_force = 0.0;        ///< N
  double longitudinal_force = 0.0;  ///< N, on the wheel
  double lateral_force = 0.0;       ///< N, on the wheel
  double max_pressure = 0.0;        ///< MPa
};

/// The most loaded first. Empty without pressure.
std::vector<PatchPart> patch_parts(const ContactGrid& grid, const ContactFields& fields);

/// How many there are.
int count_parts(const ContactGrid& grid, const Field& pressure);

}  // namespace rollfem::contact
