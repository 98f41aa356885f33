// SPDX-License-Identifier: LGPL-2.1-or-later
// Files that gmsh itself writes in every format are read as gmsh reads them; each way in which a
// file can be wrong has a message with its place.
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

/// One cube: contact above, fixed below.
const std::string cube =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"contact\"\n2 2 \"fixed\"\n"
    "$EndPhysicalNames\n$Entities\n0 0 2 1\n1 0 0 0 1 1 0 1 1 0\n2 0 0 -1 1 1 -1 1 -2 0\n"
    "1 0 0 -1 1 1 0 0 2 1 2\n$EndEntities\n$Nodes\n1 8 1 8\n3 1 0 8\n1\n2\n3\n4\n5\n6\n7\n8\n"
    "0 0 -1\n1 0 -1\n1 1 -1\n0 1 -1\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n$Elements\n"
    "3 3 1 3\n2 1 3 1\n1 5 6 7 8\n2 2 3 1\n2 1 2 3 4\n3 1 5 1\n3 1 2 3 4 5 6 7 8\n$EndElements\n";

std::string refusal_of(const std::string& from, const std::string& to) {
  const TemporaryFolder folder;
  std::string text = cube;
  const std::size_t at = text.rfind(from);
  if (at == text.npos) return "the cube has no " + from;
  text.replace(at, from.size(), to);
  const std::string path = folder.file("cube.msh", text);
  return refusal<contact::InputError>([&] { meshes::read_msh(path, "cube.msh"); });
}

TEST(MshReader, NamesTheErrorAndItsLine) {
  const TemporaryFolder folder;
  const HexMesh mesh = meshes::read_msh(folder.file("cube.msh", cube), "cube.msh");
  meshes::check_mesh(mesh, "cube.msh");
  const std::vector<std::array<std::string, 3>> wrong{
      {"3 1 2 3 4 5 6 7 8", "3 1 2 3 -4 5 6 7 8", "line 42: a node of an element is -4"},
      {"3 1 2 3 4 5 6 7 8", "3 1 2 3 4 5 6 7 9", "line 42: element 3 refers to node 9"},
      {"3 1 2 3 4 5 6 7 8", "3 1 2 3 4 5 6 7 8.5", "line 42: `8.5` is not a node of an element"},
      {"3 1 5 1\n", "3 1 5 1000000000000\n", "line 41: the number of elements of a block is"},
      {"3 1 5 1\n", "3 1 5 99999999999999999999\n", "`99999999999999999999` is not"},
      {"3 1 5 1\n", "3 1 5 -1\n", "line 41: the number of elements of a block is -1"},
      {"3 1 5 1\n", "3 1 4 1\n", "line 41: there are cells of type Tetrahedron 4; allowed"},
      {"3 1 5 1\n", "3 1 77 1\n", "line 41: gmsh's element type 77 is not supported"},
      {"3 1 5 1\n", "2 1 5 1\n", "are in an entity of dimension 2"},
      {"3 3 1 3\n", "3 4 1 3\n", "there are 3 elements, but $Elements begins with 4"},
      {"1 8 1 8\n", "1 9 1 8\n", "there are 8 nodes, but $Nodes begins with 9"},
      {"\n1 1 0\n", "\n1 nan 0\n", "line 32: node 7 is at (1, nan, 0) mm; allowed"},
      {"\n1 1 0\n", "\n1 1e999 0\n", "node 7 is at (1, inf, 0) mm"},
      {"\n1 1 0\n", "\n1 x 0\n", "`x` is not a coordinate of a node"},
      {"\n7\n", "\n6\n", "there are two nodes with the number 6"},
      {"\n7\n", "\n0\n", "a node is 0; allowed: 1 to"},
      {"$EndElements\n", "", "the file ends before $EndElements"},
      {"4 5 6 7 8\n$EndElements\n", "4          5", "the file ends before a node of an element"},
      {"$EndNodes", "$EndNodex", "expected $EndNodes, got `$EndNodex`"},
      {"$EndElements\n", "$EndElements\n$Nodes\n", "there is a second section $Nodes"},
      {"$EndElements\n", "$EndElements\nhello\n", "`hello` does not start a section"},
      {"$EndElements\n", "$EndElements\n$Data\n1\n", "the section $Data has no $EndData"},
      {"2 1 \"contact\"", "2 1 contact", "line 6: `2 1 contact` is not a physical name"},
      {"4.1 0 8", "4.1 2 8", "line 2: file type and data size are 2 8"},
      {"4.1 0 8", "3.0 0 8", "is in the gmsh format 3.0; allowed: 4.1 and 2.2"},
      {"$Entities\n0 0 2", "$PartitionedEntities\n0 0 2", "the mesh is partitioned"},
  };
  for (const auto& [from, to, message] : wrong) {
    const std::string said = refusal_of(from, to);
    EXPECT_TRUE(says(said, message));
    EXPECT_EQ(said.rfind("cube.msh: ", 0), 0u) << said;
    EXPECT_TRUE(says(said, "; do: "));
  }
}

template <class Number>
void put(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

TEST(MshReader, SaysAtWhichByteABinaryFileIsWrong) {
  const TemporaryFolder folder;
  const auto said = [&](const std::string& bytes) {
    const std::string path = folder.file("b.msh", bytes);
    return refusal<contact::InputError>([&] { meshes::read_msh(path, "b.msh"); });
  };
  std::string head = "$MeshFormat\n4.1 1 8\n";
  std::string other = head;
  put<std::int32_t>(other, 1 << 24);
  EXPECT_TRUE(says(said(other), "byte 20: the numbers are in another byte order"));
  EXPECT_TRUE(says(said(head), "byte 20: the file ends before the number 1"));
  put<std::int32_t>(head, 1);
  head += "\n$EndMeshFormat\n$Nodes\n";
  const std::size_t at = head.size();
  put<std::int64_t>(head, 1);
  put<std::int64_t>(head, INT64_MAX);
  head += std::string(40, ' ');
  EXPECT_TRUE(says(said(head), "byte " + std::to_string(at + 8) +
                                   ": the number of nodes is 9223372036854775807, but the rest"));
}

}  // namespace
