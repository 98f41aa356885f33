// SPDX-License-Identifier: LGPL-2.1-or-later
// Damaged mesh files: each is quickly read as some mesh or refused with one message.
// ROLLFEM_DAMAGED=10000 tries as many.
#include "contact/base/errors.hpp"
#include "meshes/msh_file.hpp"

#include <gtest/gtest.h>

#include "support/damage.hpp"
#include "support/mesh_examples.hpp"
#include "support/msh_formats.hpp"
#include <chrono>
#include <filesystem>

namespace {

using namespace rollfem;
using namespace rollfem::testing;

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
      EXPECT_NE(said.find("; do: "), std::string::npos) << said;
      EXPECT_TRUE(
          std::all_of(said.begin(), said.end(), [](char c) { return c >= ' ' && c <= '~'; }))
          << k << ": " << said;
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5)) << k;
  }
  // What passes has another coordinate, another box of an entity, a comment or a blank.
  EXPECT_GT(refused, files / 2);
  RecordProperty("refused", refused);
}

}  // namespace
