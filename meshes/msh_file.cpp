// SPDX-License-Identifier: LGPL-2.1-or-later
// Reads a .msh file without gmsh's library, which would run NAME.msh.opt beside a mesh as a script
// and trust the numbers in the mesh.
#include "meshes/msh_file.hpp"

#include "base/text_fields.hpp"
#include "meshes/msh_bytes.hpp"

#include <climits>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <unordered_map>

namespace rollfem::meshes {

namespace {

constexpr std::int64_t largest_number = INT64_MAX;
/// A kind of element, by its number in .msh files.
struct MshKind {
  int dimension;
  int nodes;
  const char* name;  ///< "Tetrahedron 4"
};

constexpr int quadrilateral_corners = 4;
constexpr int hexahedron_corners = 8;
/// mm: exceeded by meshes in micrometres or with garbage.
constexpr double farthest = 1e9;

/// gmsh's names and numbers.
const std::map<std::int64_t, MshKind> kinds{
    {1, {1, 2, "Line 2"}},           {2, {2, 3, "Triangle 3"}},
    {3, {2, 4, "Quadrilateral 4"}},  {4, {3, 4, "Tetrahedron 4"}},
    {5, {3, 8, "Hexahedron 8"}},     {6, {3, 6, "Prism 6"}},
    {7, {3, 5, "Pyramid 5"}},        {8, {1, 3, "Line 3"}},
    {9, {2, 6, "Triangle 6"}},       {10, {2, 9, "Quadrilateral 9"}},
    {11, {3, 10, "Tetrahedron 10"}}, {12, {3, 27, "Hexahedron 27"}},
    {13, {3, 18, "Prism 18"}},       {14, {3, 14, "Pyramid 14"}},
    {15, {0, 1, "Point"}},           {16, {2, 8, "Quadrilateral 8"}},
    {17, {3, 20, "Hexahedron 20"}},  {18, {3, 15, "Prism 15"}},
    {19, {3, 13, "Pyramid 13"}},     {20, {2, 9, "Triangle 9"}},
    {21, {2, 10, "Triangle 10"}},    {26, {1, 4, "Line 4"}},
    {29, {3, 20, "Tetrahedron 20"}}, {36, {2, 16, "Quadrilateral 16"}},
    {92, {3, 64, "Hexahedron 64"}}};

class MshReader {
 public:
  MshReader(const std::string& path, const std::string& name) : bytes_(path, name) {}
  HexMesh read();

 private:
  void read_format();
  void read_names();
  void read_entities();
  void read_entity(int dimension);
  void read_nodes();
  void read_old_nodes();
  void read_elements();
  void read_old_elements();
  std::size_t read_old_block(std::size_t left);
  /// Throws for a number that is not one of gmsh's kinds, and for cells other than hexahedra.
  const MshKind& kind_of(std::int64_t type) const;
  void read_node(std::int64_t number);
  /// `group`: of faces (4.1: the surface, 2.2: the physical group).
  void read_element(std::int64_t number, const MshKind& kind, int group);
  void check_sum(const char* what, const char* section, std::size_t read, std::size_t all) const;
  std::vector<Side> sides_of(int group) const;
  /// The hexahedra with their nodes, and the faces with a side.
  HexMesh mesh() const;

  struct Face {
    std::size_t place;  ///< in the file
    int count;          ///< of nodes, 4 for a quadrilateral
    std::array<int, 4> corners{};
  };

  MshBytes bytes_;
  std::vector<std::array<double, 3>> points_;
  std::unordered_map<std::int64_t, int> index_;  ///< in points_, by number
  std::vector<std::array<int, 8>> cells_;
  std::set<std::array<int, 8>> once_;          ///< the cells of 2.2
  std::map<int, std::vector<Face>> faces_;     ///< by group
  std::map<int, Side> side_of_group_;          ///< by the number of the physical group
  std::map<int, std::vector<int>> groups_of_;  ///< 4.1: physical groups of each surface
};

void MshReader::read_format() {
  const auto fields = contact::fields_of(bytes_.line(), " \t");
  if (fields.size() != 3)
    bytes_.fail("is not a gmsh mesh: the format should be three numbers, such as 4.1 0 8",
                "export it from gmsh as .msh");
  if (fields[0] != "2.2" && fields[0] != "4.1")
    bytes_.fail_file(fmt::format("is in the gmsh format {}; allowed: 4.1 and 2.2",
                                 contact::printable(fields[0])),
                     "save it in the format 4.1 or 2.2 (gmsh -format msh41)");
  const bool sized = fields[2] == "8" || (fields[2] == "4" && fields[0] == "4.1");
  if ((fields[1] != "0" && fields[1] != "1") || !sized)
    bytes_.fail(
        fmt::format("file type and data size are {} {}; allowed: 0 (text) or 1 (binary), "
                    "and 8",
                    contact::printable(fields[1]), contact::printable(fields[2])));
  bytes_.set_format({fields[0] == "2.2", fields[1] == "1", fields[2] == "4" ? 4U : 8U});
  if (!bytes_.format().binary) return;
  if (const std::int64_t one = bytes_.integer("the number 1", INT_MIN, INT_MAX); one == 1 << 24)
    bytes_.fail("the numbers are in another byte order",
                "save it as text (gmsh -format msh41 without -bin)");
  else if (one != 1)
    bytes_.fail(fmt::format("the byte-order mark is {}; allowed: 1", one));
}

/// Text even in a binary file: the count, then lines `dimension number "name"`.
void MshReader::read_names() {
  const auto count = contact::whole_number_of(bytes_.line());
  if (!count || *count < 0) bytes_.fail("the number of physical names is missing");
  for (int k = 0; k < *count; ++k) {
    if (bytes_.at_end()) bytes_.fail("the file ends inside $PhysicalNames");
    const std::string_view line = bytes_.line();
    const std::size_t begin = line.find('"');
    const auto fields = contact::fields_of(line.substr(0, begin), " \t");
    const auto number = [&](std::size_t field) {
      return field < fields.size() ? contact::whole_number_of(fields[field]).value_or(-1) : -1;
    };
    const int dimension = number(0), group = number(1);
    if (begin == line.npos || line.size() < begin + 2 || line.back() != '"' || fields.size() != 2 ||
        dimension < 0 || group < 0)
      bytes_.fail(
          fmt::format("`{}` is not a physical name; allowed: dimension, number and \"name\"",
                      contact::printable(line)));
    const std::string_view name = line.substr(begin + 1, line.size() - begin - 2);
    for (std::size_t side = 0; side < side_names.size(); ++side)
      if (dimension == 2 && name == side_names[side])
        side_of_group_[group] = static_cast<Side>(side);
  }
}

/// Only its physical groups are used.
void MshReader::read_entity(int dimension) {
  const int entity = static_cast<int>(bytes_.integer("the number of an entity", INT_MIN, INT_MAX));
  for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k)
    bytes_.real("a coordinate of the box of an entity");
  const std::size_t groups = bytes_.count("the number of physical groups", 2, 4);
  for (std::size_t k = 0; k < groups; ++k) {
    const auto group = bytes_.integer("a physical group", -INT_MAX, INT_MAX);
    // Negative: the surface has the opposite orientation in the group.
    if (dimension == 2) groups_of_[entity].push_back(static_cast<int>(std::abs(group)));
  }
  if (dimension == 0) return;
  const std::size_t around = bytes_.count("the number of bounding entities", 2, 4);
  for (std::size_t k = 0; k < around; ++k) bytes_.integer("a bounding entity", INT_MIN, INT_MAX);
}

void MshReader::read_entities() {
  std::array<std::size_t, 4> counts{};
  for (std::size_t& count : counts) count = bytes_.count("the number of entities", 10, 36);
  for (int dimension = 0; dimension < 4; ++dimension)
    for (std::size_t k = 0; k < counts[static_cast<std::size_t>(dimension)]; ++k)
      read_entity(dimension);
}

const MshKind& MshReader::kind_of(std::int64_t type) const {
  const auto found = kinds.find(type);
  if (found == kinds.end())
    bytes_.fail(fmt::format("gmsh's element type {} is not supported; allowed: 1 (lines), 3 "
                            "(quadrilaterals), 5 (hexahedra), 15 (points)",
                            type),
                "mesh with hexahedra of order 1");
  if (found->second.dimension == 3 && found->second.nodes != hexahedron_corners)
    bytes_.fail(fmt::format("there are cells of type {}; allowed: hexahedra with 8 corners",
                            found->second.name),
                "mesh with hexahedra of order 1 (transfinite, or an extruded recombined section)");
  return found->second;
}

void MshReader::read_node(std::int64_t number) {
  std::array<double, 3> place{};
  for (double& coordinate : place) coordinate = bytes_.real("a coordinate of a node");
  for (const double c : place)
    if (!(std::abs(c) <= farthest))
      bytes_.fail(fmt::format("node {} is at ({}, {}, {}) mm; allowed: magnitudes up to {:g}",
                              number, place[0], place[1], place[2], farthest),
                  "save the mesh again, in mm");
  if (!index_.try_emplace(number, static_cast<int>(points_.size())).second)
    bytes_.fail(fmt::format("there are two nodes with the number {}", number),
                "renumber the nodes (in gmsh Renumber Mesh Nodes)");
  points_.push_back(place);
}

void MshReader::read_element(std::int64_t number, const MshKind& kind, int group) {
  // All are read first: a failure names the last of them.
  std::vector<std::int64_t> nodes(static_cast<std::size_t>(kind.nodes));
  for (std::int64_t& node : nodes) node = bytes_.large("a node of an element", 1, largest_number);
  std::array<int, 8> corners{};
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const auto found = index_.find(nodes[k]);
    if (found == index_.end())
      bytes_.fail(fmt::format(
          "element {} refers to node {}, which does not exist; allowed: nodes listed in $Nodes",
          number, nodes[k]));
    if (k < corners.size()) corners[k] = found->second;
  }
  if (kind.dimension == 2)
    faces_[group].push_back(
        {bytes_.place(), kind.nodes, {corners[0], corners[1], corners[2], corners[3]}});
  // In 2.2 a cell is repeated with another number for each physical group that it belongs to.
  if (kind.dimension == 3 && (!bytes_.format().old || once_.insert(corners).second))
    cells_.push_back(corners);
}

void MshReader::check_sum(const char* what, const char* section, std::size_t read,
                          std::size_t all) const {
  if (read != all)
    bytes_.fail(fmt::format("there are {} {}, but {} begins with {}", read, what, section, all));
}

void MshReader::read_nodes() {
  const std::size_t blocks = bytes_.count("the number of blocks of nodes", 8, 20);
  const std::size_t all = bytes_.count("the number of nodes", 8, 28);
  for (const char* what : {"the least number of a node", "the largest number of a node"})
    bytes_.large(what, 0, largest_number);
  std::size_t read = 0;
  std::vector<std::int64_t> numbers;
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::int64_t dimension = bytes_.integer("the dimension of an entity", 0, 3);
    bytes_.integer("the number of an entity", INT_MIN, INT_MAX);
    const bool parametric = bytes_.integer("whether nodes have parameters", 0, 1) == 1;
    numbers.resize(bytes_.count("the number of nodes of a block", 8, 28));
    for (std::int64_t& number : numbers) number = bytes_.large("a node", 1, largest_number);
    for (const std::int64_t number : numbers) {
      read_node(number);
      for (std::int64_t k = 0; parametric && k < dimension; ++k)
        bytes_.real("a parameter of a node");
    }
    read += numbers.size();
  }
  check_sum("nodes", "$Nodes", read, all);
}

void MshReader::read_old_nodes() {
  const std::size_t count = bytes_.count("the number of nodes", 8, 28);
  for (std::size_t k = 0; k < count; ++k) read_node(bytes_.large("a node", 1, largest_number));
}

void MshReader::read_elements() {
  const std::size_t blocks = bytes_.count("the number of blocks of elements", 8, 20);
  const std::size_t all = bytes_.count("the number of elements", 4, 8);
  for (const char* what : {"the least number of an element", "the largest number of an element"})
    bytes_.large(what, 0, largest_number);
  std::size_t read = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::int64_t dimension = bytes_.integer("the dimension of an entity", 0, 3);
    const auto entity =
        static_cast<int>(bytes_.integer("the number of an entity", INT_MIN, INT_MAX));
    const MshKind& kind = kind_of(bytes_.integer("the type of elements", 1, INT_MAX));
    if (kind.dimension != dimension)
      bytes_.fail(fmt::format("elements of type {} are in an entity of dimension {}", kind.name,
                              dimension));
    const auto each = static_cast<std::size_t>(kind.nodes) + 1;
    const std::size_t count = bytes_.count("the number of elements of a block", 2 * each, 4 * each);
    for (std::size_t k = 0; k < count; ++k)
      read_element(bytes_.large("an element", 1, largest_number), kind, entity);
    read += count;
  }
  check_sum("elements", "$Elements", read, all);
}

/// Reads one element of a text file or all elements that share a header in a binary file; returns
/// their number.
std::size_t MshReader::read_old_block(std::size_t left) {
  const bool binary = bytes_.format().binary;
  std::int64_t number = binary ? 0 : bytes_.integer("an element", INT_MIN, INT_MAX);
  const MshKind& kind = kind_of(bytes_.integer("the type of an element", 1, INT_MAX));
  const auto most = static_cast<std::int64_t>(left);
  const std::int64_t count =
      binary ? bytes_.integer("the number of elements of a kind", 1, most) : 1;
  const std::int64_t tags = bytes_.integer("the number of tags", 0, 1000);
  for (std::int64_t k = 0; k < count; ++k) {
    if (binary) number = bytes_.integer("an element", INT_MIN, INT_MAX);
    int group = 0;
    for (std::int64_t tag = 0; tag < tags; ++tag) {
      const std::int64_t value = bytes_.integer("a tag of an element", -INT_MAX, INT_MAX);
      if (tag == 0) group = static_cast<int>(std::abs(value));
    }
    read_element(number, kind, group);
  }
  return static_cast<std::size_t>(count);
}

void MshReader::read_old_elements() {
  const std::size_t all = bytes_.count("the number of elements", 8, 8);
  for (std::size_t read = 0; read < all;) read += read_old_block(all - read);
}

std::vector<Side> MshReader::sides_of(int group) const {
  std::vector<int> groups{group};
  if (!bytes_.format().old) {
    const auto found = groups_of_.find(group);
    if (found == groups_of_.end()) return {};
    groups = found->second;
  }
  std::vector<Side> sides;
  for (const int number : groups)
    if (const auto found = side_of_group_.find(number); found != side_of_group_.end())
      sides.push_back(found->second);
  return sides;
}

HexMesh MshReader::mesh() const {
  HexMesh mesh;
  std::vector<int> number(points_.size(), -1);
  for (std::array<int, 8> cell : cells_) {
    for (int& corner : cell) {
      int& own = number[static_cast<std::size_t>(corner)];
      if (own < 0) {
        own = static_cast<int>(mesh.points.size());
        mesh.points.push_back(points_[static_cast<std::size_t>(corner)]);
      }
      corner = own;
    }
    mesh.cells.push_back(cell);
  }
  for (const auto& [group, faces] : faces_)
    for (const Side side : sides_of(group))
      for (const Face& face : faces) {
        const char* const name = side_names[static_cast<std::size_t>(side)];
        if (face.count != quadrilateral_corners)
          bytes_.fail_at(
              face.place,
              fmt::format("the group `{}` has faces that are not quadrilaterals with 4 corners",
                          name),
              "recombine the surface mesh");
        SideQuad quad{face.corners, side};
        for (int& corner : quad.corners) {
          corner = number[static_cast<std::size_t>(corner)];
          if (corner < 0)
            bytes_.fail_at(
                face.place,
                fmt::format("the group `{}` has a face that is not a face of a hexahedron", name),
                "save the volume cells too: put the volume into a physical group (gmsh "
                "then saves it), or set Mesh.SaveAll = 1");
        }
        mesh.sides.push_back(quad);
      }
  return mesh;
}

HexMesh MshReader::read() {
  const bool& old = bytes_.format().old;
  const std::map<std::string, std::function<void()>> readers{
      {"MeshFormat", [&] { read_format(); }},
      {"PhysicalNames", [&] { read_names(); }},
      {"Entities", [&] { read_entities(); }},
      {"Nodes", [&] { old ? read_old_nodes() : read_nodes(); }},
      {"Elements", [&] { old ? read_old_elements() : read_elements(); }},
      {"PartitionedEntities", [&] {
         bytes_.fail("the mesh is partitioned",
                     "save it as one part (Mesh.PartitionSplit = 0, or "
                     "Unpartition in gmsh)");
       }}};
  std::set<std::string> seen;
  while (!bytes_.at_end()) {
    const std::string line(bytes_.line());
    if (seen.empty() && line != "$MeshFormat")
      bytes_.fail_file("is not a gmsh mesh: it does not begin with $MeshFormat",
                       "export it from gmsh as .msh");
    if (line.empty() || line.front() != '$')
      bytes_.fail(fmt::format("`{}` does not start a section; allowed: $Nodes, $Elements, ...",
                              contact::printable(line)));
    const std::string section = line.substr(1), end = "$End" + section;
    const auto reader = readers.find(section);
    if (reader == readers.end()) {
      if (!bytes_.pass(end))
        bytes_.fail(fmt::format("the section {} has no {}", contact::printable(line),
                                contact::printable(end)));
      continue;
    }
    if (!seen.insert(section).second)
      bytes_.fail(fmt::format("there is a second section {}", line));
    reader->second();
    if (bytes_.at_end()) bytes_.fail(fmt::format("the file ends before {}", end));
    if (const std::string_view found = bytes_.line(); found != end)
      bytes_.fail(fmt::format("expected {}, got `{}`", end, contact::printable(found)));
  }
  if (seen.empty())
    bytes_.fail_file("is not a gmsh mesh: it is empty", "export it from gmsh as .msh");
  for (const char* section : {"Nodes", "Elements"})
    if (seen.count(section) == 0)
      bytes_.fail(fmt::format("there is no section ${} in the file", section));
  return mesh();
}

// Writing gmsh's format 4.1 as text.

/// Lower and upper corner of all points, which describe an entity.
std::string bounding_box(const HexMesh& mesh) {
  std::array<double, 3> lower{}, upper{};
  if (!mesh.points.empty()) lower = upper = mesh.points.front();
  for (const auto& p : mesh.points)
    for (int d = 0; d < 3; ++d) {
      lower[d] = std::min(lower[d], p[d]);
      upper[d] = std::max(upper[d], p[d]);
    }
  return fmt::format("{} {} {} {} {} {}", lower[0], lower[1], lower[2], upper[0], upper[1],
                     upper[2]);
}

}  // namespace

HexMesh read_msh(const std::string& path, const std::string& shown_name) {
  return MshReader(path, shown_name).read();
}

std::string msh_text(const HexMesh& mesh) {
  std::vector<std::size_t> present;
  std::vector<long> count(side_names.size(), 0);
  for (const SideQuad& quad : mesh.sides) ++count[static_cast<std::size_t>(quad.side)];
  for (std::size_t side = 0; side < side_names.size(); ++side)
    if (count[side] > 0) present.push_back(side);

  fmt::memory_buffer buffer;
  const auto out = std::back_inserter(buffer);
  fmt::format_to(out, "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
  fmt::format_to(out, "$PhysicalNames\n{}\n", present.size() + 1);
  for (const std::size_t side : present)
    fmt::format_to(out, "2 {} \"{}\"\n", side + 1, side_names[side]);
  fmt::format_to(out, "3 10 \"body\"\n$EndPhysicalNames\n");

  // One entity for each side and one for the volume, described by their boxes; no curves, no
  // points.
  const std::string box = bounding_box(mesh);
  fmt::format_to(out, "$Entities\n0 0 {} 1\n", present.size());
  for (const std::size_t side : present)
    fmt::format_to(out, "{} {} 1 {} 0\n", side + 1, box, side + 1);
  fmt::format_to(out, "1 {} 1 10 0\n$EndEntities\n", box);

  fmt::format_to(out, "$Nodes\n1 {0} 1 {0}\n3 1 0 {0}\n", mesh.points.size());
  for (std::size_t k = 1; k <= mesh.points.size(); ++k) fmt::format_to(out, "{}\n", k);
  for (const auto& p : mesh.points) fmt::format_to(out, "{} {} {}\n", p[0], p[1], p[2]);
  fmt::format_to(out, "$EndNodes\n");

  const std::size_t elements = mesh.sides.size() + mesh.cells.size();
  fmt::format_to(out, "$Elements\n{} {} 1 {}\n", present.size() + 1, elements, elements);
  std::size_t element = 0;
  for (const std::size_t side : present) {
    fmt::format_to(out, "2 {} 3 {}\n", side + 1, count[side]);
    for (const SideQuad& quad : mesh.sides)
      if (static_cast<std::size_t>(quad.side) == side)
        fmt::format_to(out, "{} {} {} {} {}\n", ++element, quad.corners[0] + 1, quad.corners[1] + 1,
                       quad.corners[2] + 1, quad.corners[3] + 1);
  }
  fmt::format_to(out, "3 1 5 {}\n", mesh.cells.size());
  for (const auto& cell : mesh.cells) {
    fmt::format_to(out, "{}", ++element);
    for (const int corner : cell) fmt::format_to(out, " {}", corner + 1);
    fmt::format_to(out, "\n");
  }
  fmt::format_to(out, "$EndElements\n");
  return fmt::to_string(buffer);
}

}  // namespace rollfem::meshes
