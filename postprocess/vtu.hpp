// Files for ParaView (VTK XML unstructured grid, zlib-compressed base64): bodies, the contact
// surface, and the contact surfaces of all load points as a time series.
#pragma once

#include "contact/result.hpp"

#include <string>
#include <vector>

namespace rollfem::postprocess {

/// Hexahedra of a body with displacement (mm), stress (MPa: xx yy zz xy yz xz, VTK's order of a
/// symmetric tensor) and von Mises stress (MPa) at the points.
std::string body_vtu(const contact::BodyField& body);

/// The contact surface at z = 0 of one load point: quadrilaterals, one per contact element, with
/// tractions, bound, slip, gap, displacement difference and state per cell.
std::string contact_vtu(const contact::ContactGrid& grid, const contact::PointResult& point);

/// What stands for the time in the series of these load points: the longitudinal creepage where it
/// tells all of them apart, else the number of the point from 0 (steps of a history, spin, ...).
std::vector<double> series_times(const std::vector<contact::PointResult>& points);

/// The .pvd file of a series: one file name, relative to it, per time. ParaView sorts by time.
std::string series_pvd(const std::vector<double>& times, const std::vector<std::string>& files);

}  // namespace rollfem::postprocess
