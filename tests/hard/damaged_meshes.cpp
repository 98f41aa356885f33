// SPDX-License-Identifier: LGPL-2.1-or-later
// Damaged mesh files: each is quickly read as some mesh or refused with one message.
// ROLLFEM_DAMAGED=10000 tries as many.
#include "base/errors.hpp"
#include "meshes/msh_file.hpp"

#include "support/damage.hpp"
#include "support/mesh_examples.hpp"
#include <chrono>
#include <cstdint>

namespace {

// Meshes in the formats of .msh files that the program reads but does not write.

template <class Number, class... Values>
void put(std::string& bytes, Values... values) {
  for (const Number number : {static_cast<Number>(values)...})
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// The format 4.1, binary.
std::string binary_msh41(const meshes::HexMesh& mesh) {
  using I = std::int32_t;
  using L = std::int64_t;
  std::string bytes = "$MeshFormat\n4.1 1 8\n";
  put<I>(bytes, 1);
  bytes += "\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"contact\"\n2 2 \"fixed\"\n";
  bytes += "$EndPhysicalNames\n$Entities\n";
  put<L>(bytes, 0, 0, 2, 1);
  for (const int entity : {1, 2, 3}) {  // two surfaces and a volume, which is in no group
    put<I>(bytes, entity == 3 ? 1 : entity);
    put<double>(bytes, 0, 0, 0, 1, 1, 1);
    put<L>(bytes, entity == 3 ? 0 : 1);
    if (entity < 3) put<I>(bytes, entity);
    put<L>(bytes, 0);
  }
  const auto nodes = static_cast<L>(mesh.points.size());
  bytes += "\n$EndEntities\n$Nodes\n";
  put<L>(bytes, 1, nodes, 1, nodes);
  put<I>(bytes, 3, 1, 0);
  put<L>(bytes, nodes);
  for (L k = 1; k <= nodes; ++k) put<L>(bytes, k);
  for (const auto& p : mesh.points) put<double>(bytes, p[0], p[1], p[2]);
  bytes += "\n$EndNodes\n$Elements\n";
  const auto all = static_cast<L>(mesh.sides.size() + mesh.cells.size());
  put<L>(bytes, mesh.sides.size() + 1, all, 1, all);
  L element = 0;
  for (const meshes::SideQuad& quad : mesh.sides) {
    put<I>(bytes, 2, static_cast<int>(quad.side) + 1, 3);
    put<L>(bytes, 1, ++element);
    for (const int corner : quad.corners) put<L>(bytes, corner + 1);
  }
  put<I>(bytes, 3, 1, 5);
  put<L>(bytes, mesh.cells.size());
  for (const auto& cell : mesh.cells) {
    put<L>(bytes, ++element);
    for (const int corner : cell) put<L>(bytes, corner + 1);
  }
  return bytes + "\n$EndElements\n";
}

/// The format 2.2.
std::string msh22(const meshes::HexMesh& mesh, bool binary) {
  std::string bytes = "$MeshFormat\n2.2 " + std::string(binary ? "1" : "0") + " 8\n";
  const auto number = [&](int value, char end) {
    if (binary)
      put<std::int32_t>(bytes, value);
    else
      bytes += std::to_string(value) + end;
  };
  if (binary) put<std::int32_t>(bytes, 1), bytes += '\n';
  bytes += "$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"contact\"\n2 2 \"fixed\"\n";
  bytes += "$EndPhysicalNames\n$Nodes\n" + std::to_string(mesh.points.size()) + '\n';
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    number(static_cast<int>(k) + 1, ' ');
    const auto& p = mesh.points[k];
    if (binary)
      put<double>(bytes, p[0], p[1], p[2]);
    else
      bytes +=
          std::to_string(p[0]) + ' ' + std::to_string(p[1]) + ' ' + std::to_string(p[2]) + '\n';
  }
  bytes += "$EndNodes\n$Elements\n";
  bytes += std::to_string(mesh.sides.size() + mesh.cells.size()) + '\n';
  int element = 0;
  const auto add = [&](int type, int group, const auto& corners) {
    const std::vector<int> head = binary ? std::vector<int>{type, 1, 2, ++element, group, group}
                                         : std::vector<int>{++element, type, 2, group, group};
    for (const int value : head) number(value, ' ');
    for (std::size_t k = 0; k < corners.size(); ++k)
      number(corners[k] + 1, k + 1 < corners.size() ? ' ' : '\n');
  };
  for (const meshes::SideQuad& quad : mesh.sides)
    add(3, static_cast<int>(quad.side) + 1, quad.corners);
  for (const auto& cell : mesh.cells) add(5, 3, cell);
  return bytes + (binary ? "\n" : "") + "$EndElements\n";
}

meshes::HexMesh sound_mesh() {
  return block({-2, -1, 0, 1, 2}, {-1, 0, 1}, {-2, -1, 0}, true);
}

std::vector<std::string> formats(const meshes::HexMesh& mesh) {
  return {meshes::msh_text(mesh), binary_msh41(mesh), msh22(mesh, false), msh22(mesh, true)};
}

TEST(DamagedMeshes, OfEveryFormatTheSoundFileIsTheSameMesh) {
  const TemporaryFolder folder;
  const meshes::HexMesh mesh = sound_mesh();
  const meshes::HexMesh first =
      meshes::read_msh(folder.file("m.msh", meshes::msh_text(mesh)), "m.msh");
  ASSERT_EQ(first.cells.size(), mesh.cells.size());
  for (const std::string& bytes : formats(mesh)) {
    const meshes::HexMesh read = meshes::read_msh(folder.file("m.msh", bytes), "m.msh");
    EXPECT_EQ(read.points, first.points);
    EXPECT_EQ(read.cells, first.cells);
    EXPECT_EQ(read.sides.size(), mesh.sides.size());
    meshes::check_mesh(read, "m.msh");
  }
}

TEST(DamagedMeshes, AreReadOrRefusedInOneMessage) {
  const TemporaryFolder folder;
  const std::vector<std::string> sound = formats(sound_mesh());
  const int files = damaged_files(2000);
  int refused = 0;
  for (int k = 0; k < files; ++k) {
    Damage damage(static_cast<unsigned long long>(k));
    std::filesystem::remove(folder.path("m.msh"));  // else the disk waits for the one before
    const std::string path =
        folder.file("m.msh", damage.of(sound[static_cast<std::size_t>(k) % 4]));
    const auto begin = std::chrono::steady_clock::now();
    try {
      meshes::check_mesh(meshes::read_msh(path, "m.msh"), "m.msh");
    } catch (const contact::InputError& error) {
      ++refused;
      const std::string said = error.what();
      EXPECT_EQ(said.rfind("m.msh: ", 0), 0u) << said;
      EXPECT_TRUE(says(said, "; do: "));
      EXPECT_TRUE(
          std::all_of(said.begin(), said.end(), [](char c) { return c >= ' ' && c <= '~'; }))
          << k << ": " << said;
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5)) << k;
  }
  // What passes has another coordinate, another box of an entity, a comment or a blank.
  EXPECT_GT(refused, files / 2);
}

}  // namespace
