// SPDX-License-Identifier: LGPL-2.1-or-later
// A polygon in quadrilaterals through gmsh: cells of twice the size, recombined and split into four
// (a left-over triangle into three).
#include "meshes/true_section.hpp"

#include <gmsh.h>

namespace rollfem::meshes {

namespace geo = gmsh::model::geo;

PlaneMesh mesh_polygon(const std::vector<SectionPoint>& corners) {
  const GmshSession session;
  gmsh::model::add("polygon");
  set_quadrilaterals();
  std::vector<int> points, lines;
  for (const SectionPoint& p : corners) points.push_back(geo::addPoint(p[0], p[1], 0.0));
  for (std::size_t k = 0; k < points.size(); ++k) {
    lines.push_back(geo::addLine(points[k], points[(k + 1) % points.size()]));
    geo::mesh::setTransfiniteCurve(lines.back(), 2);
  }
  geo::mesh::setRecombine(2, geo::addPlaneSurface({geo::addCurveLoop(lines)}));
  mesh_plane("the depth");
  return collect_plane(lines);
}

}  // namespace rollfem::meshes
