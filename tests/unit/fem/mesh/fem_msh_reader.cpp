// SPDX-License-Identifier: LGPL-2.1-or-later
// Files that gmsh itself writes in every format are read as gmsh reads them.
#include "base/errors.hpp"
#include "meshes/gmsh_sections.hpp"
#include "meshes/msh_file.hpp"

#include <gmsh.h>

#include "support/mesh_examples.hpp"

using meshes::HexMesh;
using meshes::Side;

namespace {

/// Two boxes of hexahedra in one volume group, or in two that overlap; the top is `contact`, the
/// bottom `fixed`, one end `symmetry`.
void make_model(bool two_volume_groups) {
  using namespace gmsh::model;
  const int square = geo::addPoint(0, 0, -2);
  const int corner2 = geo::addPoint(3, 0, -2);
  const int corner3 = geo::addPoint(3, 1.0 / 3.0, -2);
  const int corner4 = geo::addPoint(0, 1.0 / 3.0, -2);
  const std::vector<int> lines{geo::addLine(square, corner2), geo::addLine(corner2, corner3),
                               geo::addLine(corner3, corner4), geo::addLine(corner4, square)};
  const int bottom = geo::addPlaneSurface({geo::addCurveLoop(lines)});
  geo::mesh::setTransfiniteSurface(bottom);
  geo::mesh::setRecombine(2, bottom);
  gmsh::vectorpair lower, upper;
  geo::extrude({{2, bottom}}, 0.1, 0, 1, lower, {2}, {}, true);
  geo::extrude({lower[0]}, 0, 0, 1, upper, {3}, {}, true);
  geo::synchronize();
  const auto name = [](int dimension, const std::vector<int>& entities, const char* text) {
    setPhysicalName(dimension, addPhysicalGroup(dimension, entities), text);
  };
  name(2, {upper[0].second}, "contact");
  name(2, {bottom}, "fixed");
  name(2, {lower[2].second, upper[2].second}, "symmetry");
  name(1, lines, "edge");
  name(3, {lower[1].second, upper[1].second}, "body");
  if (two_volume_groups) name(3, {lower[1].second}, "lower");
  gmsh::model::mesh::generate(3);
}

using Places = std::vector<Point>;

/// gmsh writes 16 digits, one too few.
Point rounded(Point place) {
  for (double& c : place) c = std::round(c * 1e12) / 1e12;
  return place;
}

/// Corners by place, sorted, so that the numbering does not matter.
std::vector<Places> sorted_cells(const HexMesh& mesh) {
  std::vector<Places> all;
  for (const auto& cell : mesh.cells) {
    Places places;
    for (const int corner : cell) places.push_back(rounded(mesh.points.at(corner)));
    all.push_back(places);
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::map<std::string, std::vector<Places>> sorted_sides(const HexMesh& mesh) {
  std::map<std::string, std::vector<Places>> all;
  for (const auto& quad : mesh.sides) {
    Places places;
    for (const int corner : quad.corners) places.push_back(rounded(mesh.points.at(corner)));
    all[meshes::side_names[static_cast<std::size_t>(quad.side)]].push_back(places);
  }
  for (auto& [name, sides] : all) std::sort(sides.begin(), sides.end());
  return all;
}

Places places_of(const std::vector<std::size_t>& tags) {
  Places places;
  for (const std::size_t tag : tags) {
    std::vector<double> place, unused;
    gmsh::model::mesh::getNode(tag, place, unused);
    places.push_back(rounded({place[0], place[1], place[2]}));
  }
  return places;
}

/// Elements of a type by their places; of one entity, or of all (-1).
std::vector<Places> of_gmsh(int type, std::size_t corners, int entity) {
  std::vector<std::size_t> tags, nodes;
  gmsh::model::mesh::getElementsByType(type, tags, nodes, entity);
  std::vector<Places> all;
  for (std::size_t k = 0; k < nodes.size(); k += corners)
    all.push_back(places_of({nodes.begin() + static_cast<std::ptrdiff_t>(k),
                             nodes.begin() + static_cast<std::ptrdiff_t>(k + corners)}));
  return all;
}

/// What gmsh has in memory.
std::map<std::string, std::vector<Places>> sides_of_gmsh() {
  std::map<std::string, std::vector<Places>> all;
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups, 2);
  for (const auto& [dimension, group] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(dimension, group, name);
    std::vector<int> entities;
    gmsh::model::getEntitiesForPhysicalGroup(dimension, group, entities);
    for (const int entity : entities)
      for (const Places& quad : of_gmsh(3, 4, entity)) all[name].push_back(quad);
    std::sort(all[name].begin(), all[name].end());
  }
  return all;
}

TEST(MshReader, ReadsWhatGmshWritesInEveryFormat) {
  const TemporaryFolder folder;
  const meshes::GmshSession session;
  for (const bool two_groups : {false, true})
    for (const double version : {4.1, 2.2})
      for (const bool binary : {false, true}) {
        gmsh::clear();
        make_model(two_groups);
        const std::string path = folder.path("written.msh");
        gmsh::option::setNumber("Mesh.MshFileVersion", version);
        gmsh::option::setNumber("Mesh.Binary", binary ? 1 : 0);
        gmsh::write(path);
        const HexMesh mesh = meshes::read_msh(path, "written.msh");
        SCOPED_TRACE(std::to_string(version) + (binary ? " binary" : " text"));
        std::vector<Places> cells = of_gmsh(5, 8, -1);
        std::sort(cells.begin(), cells.end());
        ASSERT_EQ(cells.size(), 100u);
        EXPECT_TRUE(sorted_cells(mesh) == cells);
        const auto sides = sorted_sides(mesh);
        EXPECT_TRUE(sides == sides_of_gmsh());
        EXPECT_EQ(sides.size(), 3u);
        meshes::check_mesh(mesh, "written.msh");
      }
}

}  // namespace
