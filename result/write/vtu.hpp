// SPDX-License-Identifier: LGPL-2.1-or-later
// Files for ParaView (VTK XML unstructured grid, zlib-compressed base64): bodies, the contact
// surface, and both for all load points as time series.
#pragma once

#include "result/result.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace rollfem::result {

/// A body whose nodes and cells are packed once for all load points.
class BodyVtu {
 public:
  explicit BodyVtu(const contact::BodyField& body);
  /// Hexahedra of the undeformed body with displacement (mm), stress (MPa: xx yy zz xy yz xz, VTK's
  /// order of a symmetric tensor) and von Mises stress (MPa) at the points, and plastic strain and
  /// residual stress (MPa) of a body that yields; null: without.
  std::string text(const contact::BodyValues* values = nullptr) const;

 private:
  std::size_t point_count_;
  std::size_t cell_count_;
  std::string points_;
  std::string cells_;
};

/// The contact surface at z = 0 of one load point: quadrilaterals, one per contact element, with
/// tractions, bound, slip, gap, displacement difference and state per cell.
std::string contact_vtu(const contact::ContactGrid& grid, const contact::PointResult& point);

/// Times of the series: the longitudinal creepage if it differs between all load points, otherwise
/// the number of the point from 0 (steps of a history, spin, ...).
std::vector<double> series_times(const std::vector<contact::PointResult>& points);

/// The .pvd file of a series: for each time the names of its parts, relative to the file. ParaView
/// sorts by time.
std::string series_pvd(const std::vector<double>& times,
                       const std::vector<std::vector<std::string>>& files);

}  // namespace rollfem::result
