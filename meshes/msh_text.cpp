// SPDX-License-Identifier: LGPL-2.1-or-later
// Writing gmsh's format 4.1 as text.
#include "meshes/msh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace rollfem::meshes {

namespace {

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
