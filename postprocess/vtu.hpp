// Files for ParaView (VTK XML unstructured grid, zlib-compressed base64): bodies and the contact
// surface.
#pragma once

#include "contact/result.hpp"

#include <string>

namespace rollfem::postprocess {

/// Hexahedra of a body with displacement (mm), stress (MPa: xx yy zz xy yz xz, VTK's order of a
/// symmetric tensor) and von Mises stress (MPa) at the points.
std::string body_vtu(const contact::BodyField& body);

/// The contact surface at z = 0 of one load point: quadrilaterals, one per contact element, with
/// tractions, bound, slip, gap, displacement difference and state per cell.
std::string contact_vtu(const contact::ContactGrid& grid, const contact::PointResult& point);

}  // namespace rollfem::postprocess
