// A polygon in quadrilaterals through gmsh: cells of twice the size, recombined and split into four
// (a left-over triangle into three).
#include "contact/base/errors.hpp"
#include "meshes/gmsh/gmsh_session.hpp"
#include "meshes/gmsh/true_section.hpp"

#include <gmsh.h>

#include <unordered_map>

namespace rollfem::meshes {

namespace {

namespace geo = gmsh::model::geo;

PolygonMesh collect(const std::vector<int>& lines) {
  PolygonMesh mesh;
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements, corners;
  gmsh::model::mesh::getElements(types, elements, corners, 2, -1);
  constexpr int quadrilateral = 3;
  if (types != std::vector<int>{quadrilateral})
    throw contact::InputError(
        "gmsh left cells in the cross-section that are no quadrilaterals: use [fem] mesh = "
        "\"structured\"");
  std::vector<std::size_t> tags;
  std::vector<double> places, unused;
  gmsh::model::mesh::getNodes(tags, places, unused, -1, -1, false, false);
  std::unordered_map<std::size_t, SectionPoint> place_of;
  for (std::size_t k = 0; k < tags.size(); ++k)
    place_of[tags[k]] = {places[3 * k], places[3 * k + 1]};
  std::unordered_map<std::size_t, int> number;
  for (const std::size_t tag : corners.front())
    if (number.try_emplace(tag, static_cast<int>(mesh.points.size())).second)
      mesh.points.push_back(place_of.at(tag));
  const auto& c = corners.front();
  for (std::size_t k = 0; k < c.size(); k += 4)
    mesh.quads.push_back(
        {number.at(c[k]), number.at(c[k + 1]), number.at(c[k + 2]), number.at(c[k + 3])});
  for (std::size_t line = 0; line < lines.size(); ++line) {
    std::vector<std::vector<std::size_t>> line_elements, ends;
    gmsh::model::mesh::getElements(types, line_elements, ends, 1, lines[line]);
    for (const auto& of_type : ends)
      for (std::size_t k = 0; k < of_type.size(); k += 2) {
        mesh.edges.push_back({number.at(of_type[k]), number.at(of_type[k + 1])});
        mesh.line.push_back(line);
      }
  }
  return mesh;
}

}  // namespace

PolygonMesh mesh_polygon(const std::vector<SectionPoint>& corners) {
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
  return collect(lines);
}

}  // namespace rollfem::meshes
