// SPDX-License-Identifier: LGPL-2.1-or-later
#include "meshes/gmsh_session.hpp"

#include "base/errors.hpp"

#include <gmsh.h>

#include <unordered_map>

namespace rollfem::meshes {

GmshSession::GmshSession() {
  // User configuration files are ignored, so that meshes are the same everywhere.
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.NumThreads", 1);
}

GmshSession::~GmshSession() {
  gmsh::finalize();
}

namespace {

/// Quadrilaterals whose sizes follow the boundary lines.
void set_quadrilaterals() {
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 1);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  // Frontal-Delaunay; the variant for quadrilaterals (8) crashes on sections in gmsh 4.8.4.
  gmsh::option::setNumber("Mesh.Algorithm", 6);
  gmsh::option::setNumber("Mesh.RecombinationAlgorithm", 1);
  gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", 1);
  gmsh::option::setNumber("Mesh.Smoothing", 10);
}

void mesh_plane(const std::string& what) {
  try {
    gmsh::model::geo::synchronize();
    gmsh::model::mesh::generate(2);
  } catch (...) {
    std::string complaint;
    gmsh::logger::getLastError(complaint);
    throw contact::InputError("gmsh cannot mesh the cross-section (" +
                              (complaint.empty() ? "unknown error" : complaint) +
                              "): use [fem] mesh = \"structured\", or change " + what);
  }
}

PlaneMesh collect_plane(const std::vector<int>& lines) {
  PlaneMesh mesh;
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements, corners;
  gmsh::model::mesh::getElements(types, elements, corners, 2, -1);
  constexpr int quadrilateral = 3;
  if (types != std::vector<int>{quadrilateral})
    throw contact::InputError(
        "gmsh left cells in the cross-section that are not quadrilaterals: use [fem] mesh = "
        "\"structured\"");
  std::vector<std::size_t> tags;
  std::vector<double> places, unused;
  gmsh::model::mesh::getNodes(tags, places, unused, -1, -1, false, false);
  std::unordered_map<std::size_t, std::array<double, 2>> place_of;
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

PlaneMesh mesh_polygon(const std::vector<std::array<double, 2>>& corners, const std::string& what) {
  namespace geo = gmsh::model::geo;
  const GmshSession session;
  gmsh::model::add("section");
  set_quadrilaterals();
  std::vector<int> points, lines;
  for (const auto& p : corners) points.push_back(geo::addPoint(p[0], p[1], 0.0));
  for (std::size_t k = 0; k < points.size(); ++k) {
    lines.push_back(geo::addLine(points[k], points[(k + 1) % points.size()]));
    geo::mesh::setTransfiniteCurve(lines.back(), 2);
  }
  geo::mesh::setRecombine(2, geo::addPlaneSurface({geo::addCurveLoop(lines)}));
  mesh_plane(what);
  return collect_plane(lines);
}

}  // namespace rollfem::meshes
