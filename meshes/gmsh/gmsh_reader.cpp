// Reading a .msh file through gmsh's library.
#include "contact/base/errors.hpp"
#include "meshes/gmsh/gmsh_session.hpp"
#include "meshes/gmsh/msh_file.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <unordered_map>

namespace rollfem::meshes {

namespace {

constexpr int quadrilateral = 3;  // gmsh's element types
constexpr int hexahedron = 5;

[[noreturn]] void fail(const std::string& name, const std::string& wrong,
                       const std::string& action) {
  throw contact::InputError(fmt::format("{}: {}; do: {}", name, wrong, action));
}

/// gmsh would run anything that is no mesh as a script: look before it does.
void check_format(const std::string& path, const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status))
    fail(name, "there is no such mesh file", "check the path, which is relative to the case file");
  if (!fs::is_regular_file(status))
    fail(name, "is not a regular file", "name a gmsh mesh file (.msh)");
  std::ifstream file(path, std::ios::binary);
  std::string line, format;
  std::getline(file, line);
  std::getline(file, format);
  if (!file) fail(name, "is no gmsh mesh, or cannot be read", "export it from gmsh as .msh");
  if (line.rfind("$MeshFormat", 0) != 0)
    fail(name, "is no gmsh mesh: it does not begin with $MeshFormat",
         "export it from gmsh as .msh");
  const std::string version = format.substr(0, format.find(' '));
  if (version != "2.2" && version != "4.1")
    fail(name, fmt::format("is in the gmsh format {:.20}", version),
         "save it in the format 4.1 or 2.2 (gmsh -format msh41)");
}

struct Nodes {
  std::unordered_map<std::size_t, std::array<double, 3>> places;
  std::unordered_map<std::size_t, int> number;  ///< in the HexMesh
  HexMesh* mesh = nullptr;

  int operator()(std::size_t tag) {
    const auto [it, is_new] = number.try_emplace(tag, static_cast<int>(mesh->points.size()));
    if (is_new) mesh->points.push_back(places.at(tag));
    return it->second;
  }
};

void read_cells(const std::string& name, Nodes& nodes) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> tags, corners;
  gmsh::model::mesh::getElements(types, tags, corners, 3, -1);
  for (std::size_t k = 0; k < types.size(); ++k) {
    if (types[k] != hexahedron) {
      std::string kind;
      int dimension = 0, order = 0, count = 0, primary = 0;
      std::vector<double> local;
      gmsh::model::mesh::getElementProperties(types[k], kind, dimension, order, count, local,
                                              primary);
      fail(name,
           fmt::format("has {} cells of the kind {}; allowed: hexahedra with 8 corners",
                       tags[k].size(), kind),
           "mesh with hexahedra of order 1 (transfinite, or an extruded recombined section)");
    }
    for (std::size_t c = 0; c < tags[k].size(); ++c) {
      std::array<int, 8> cell{};
      for (int corner = 0; corner < 8; ++corner) cell[corner] = nodes(corners[k][8 * c + corner]);
      nodes.mesh->cells.push_back(cell);
    }
  }
}

void read_side(const std::string& name, Side side, int group, Nodes& nodes) {
  std::vector<int> entities;
  gmsh::model::getEntitiesForPhysicalGroup(2, group, entities);
  for (const int entity : entities) {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> tags, corners;
    gmsh::model::mesh::getElements(types, tags, corners, 2, entity);
    for (std::size_t k = 0; k < types.size(); ++k) {
      if (types[k] != quadrilateral)
        fail(name,
             fmt::format("the group `{}` has faces that are no quadrilaterals with 4 corners",
                         side_names[static_cast<std::size_t>(side)]),
             "recombine the surface mesh");
      for (std::size_t f = 0; f < tags[k].size(); ++f) {
        SideQuad quad{{}, side};
        for (int c = 0; c < 4; ++c) {
          const std::size_t tag = corners[k][4 * f + c];
          if (nodes.number.count(tag) == 0)
            fail(name,
                 fmt::format("the group `{}` has a face that is no face of a hexahedron",
                             side_names[static_cast<std::size_t>(side)]),
                 "save the volume cells too: put the volume into a physical group (gmsh then saves "
                 "it), or set Mesh.SaveAll = 1");
          quad.corners[c] = nodes(tag);
        }
        nodes.mesh->sides.push_back(quad);
      }
    }
  }
}

}  // namespace

HexMesh read_msh(const std::string& path, const std::string& shown_name) {
  check_format(path, shown_name);
  const GmshSession session;
  try {
    gmsh::open(path);
  } catch (...) {
    fail(shown_name, "gmsh cannot read it: " + gmsh_complaint(), "export it from gmsh again");
  }
  HexMesh mesh;
  Nodes nodes;
  nodes.mesh = &mesh;
  std::vector<std::size_t> tags;
  std::vector<double> places, unused;
  gmsh::model::mesh::getNodes(tags, places, unused, -1, -1, false, false);
  for (std::size_t k = 0; k < tags.size(); ++k)
    nodes.places[tags[k]] = {places[3 * k], places[3 * k + 1], places[3 * k + 2]};
  read_cells(shown_name, nodes);
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups, 2);
  for (const auto& [dimension, group] : groups) {
    std::string group_name;
    gmsh::model::getPhysicalName(dimension, group, group_name);
    for (std::size_t side = 0; side < side_names.size(); ++side)
      if (group_name == side_names[side])
        read_side(shown_name, static_cast<Side>(side), group, nodes);
  }
  return mesh;
}

}  // namespace rollfem::meshes
