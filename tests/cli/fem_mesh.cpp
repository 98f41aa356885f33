// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `mesh`: its files, their use in a case, and its refusals.
#include "support/case_examples.hpp"
#include "support/program.hpp"

namespace {

namespace fs = std::filesystem;

const std::string coarse = "[fem]\ncell_size = 1.88\n";

/// The number after a row's name, of the wheel.
double row(const std::string& table, const std::string& name) {
  const auto at = table.find(name);
  if (at == std::string::npos) return NAN;
  return std::stod(table.substr(at + 34));
}

std::string with_mesh(const std::string& file) {
  return with("rolling_radius = 405.0", "rolling_radius = 405.0\nmesh = \"" + file + "\"");
}

}  // namespace

using MeshCommand = ProgramTest;

TEST_F(MeshCommand, WritesMeshesThatACaseTakesAgain) {
  for (const std::string family : {"structured", "gmsh"}) {
    const std::string file = folder.file("case.toml", plus(coarse + "mesh = \"" + family + "\"\n"));
    const Outcome first = done({"mesh", file, "-o", family});
    for (const char* name : {"wheel.msh", "rail.msh", "wheel.vtu", "rail.vtu"})
      EXPECT_TRUE(folder.holds(family + "/" + name)) << name;
    EXPECT_TRUE(says(folder.text(family + "/wheel.vtu"), "UnstructuredGrid"));
    EXPECT_GT(row(first.out, "unknowns"), 5000);
    EXPECT_GT(row(first.out, "smallest scaled Jacobian (1: box)"), 0.3);
    EXPECT_LE(row(first.out, "size of cells in the patch, mm"), 1.8801);
    EXPECT_LE(row(first.out, "times halved at the patch"), 7);

    // The files are the coarse mesh: refined again they give the same cells.
    const std::string again =
        folder.file("again.toml", with_mesh("work/" + family + "/wheel.msh") + coarse);
    const Outcome second = done({"mesh", again, "-o", "again_" + family});
    for (const char* name : {"coarse cells", "cells", "unknowns", "shortest edge, mm"})
      EXPECT_EQ(row(second.out, std::string("\n") + name), row(first.out, std::string("\n") + name))
          << name;
    EXPECT_EQ(folder.text(family + "/wheel.msh").size(),
              folder.text("again_" + family + "/wheel.msh").size());
  }
}

TEST_F(MeshCommand, RefusesBadMeshesAndWritesNothing) {
  refuses({"mesh", folder.file("a.toml", with_mesh("none.msh"))},
          "wheel.mesh = \"none.msh\": there is no such mesh file");
  refuses({"check", folder.file("a.toml", with_mesh("none.msh"))}, "there is no such mesh file");
  folder.file("geo.msh", "Point(1) = {0, 0, 0};\n");
  refuses({"mesh", folder.file("b.toml", with_mesh("geo.msh"))}, "is not a gmsh mesh");
  folder.file(
      "tetrahedron.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 9 0 0\n3 0 9 0\n4 0 0 9\n"
      "$EndNodes\n$Elements\n1\n1 4 2 1 1 1 2 3 4\n$EndElements\n");
  refuses({"run", folder.file("c.toml", with_mesh("tetrahedron.msh")), "--model", "fem"},
          "allowed: hexahedra");
  refuses({"mesh", folder.file("d.toml", small_case + coarse), "-o", "/proc/nowhere"},
          "cannot create the folder");
  refuses({"mesh"}, "case is required");
  EXPECT_TRUE(folder.made().empty());
}

TEST_F(MeshCommand, RunsNoScriptOfTheUsersFolders) {
  const std::string file = folder.file("case.toml", plus(coarse + "mesh = \"gmsh\"\n"));
  done({"mesh", file, "-o", "made"});
  // gmsh would run the first beside the mesh, and the others at its start.
  const std::string script = "SystemCall \"touch " + folder.path("ran") + "\";\n";
  for (const char* name :
       {"work/made/wheel.msh.opt", "work/made/rail.msh.opt", "work/.gmshrc", "work/.gmsh-options",
        "work/gmsh-options", "home/.gmshrc", "home/.gmsh-options", "home/.gmshrc.opt"})
    folder.file(name, script);
  folder.file("work/.petscrc", "-help\n");  // PETSc would print its options, or start a debugger
  const std::string own =
      folder.file("own.toml", with_mesh("work/made/wheel.msh") + coarse + "mesh = \"gmsh\"\n");
  const Outcome outcome = done({"mesh", own, "-o", "again"}, {"HOME=" + folder.path("home")});
  EXPECT_FALSE(fs::exists(folder.path("ran")));
  EXPECT_FALSE(says(outcome.out, "petsc"));
  EXPECT_EQ(outcome.err, "");
}

TEST_F(MeshCommand, RefusesNumbersThatCannotBe) {
  done({"mesh", folder.file("a.toml", plus(coarse)), "-o", "made"});
  std::string text = folder.text("made/wheel.msh");
  const std::size_t line = text.rfind('\n', text.find("\n$EndElements") - 1);
  text.insert(text.find(' ', line) + 1, "-");
  folder.file("negative.msh", text);
  refuses({"mesh", folder.file("b.toml", with_mesh("negative.msh"))}, "a node of an element is -");
}

TEST_F(MeshCommand, SparesTheMeshThatTheCaseNames) {
  folder.file("wheel.msh", "$MeshFormat\n");
  refuses({"mesh", folder.file("a.toml", with_mesh("wheel.msh")), "-o", ".."},
          "would be overwritten");
  EXPECT_EQ(contents(folder.path("wheel.msh")), "$MeshFormat\n");
}
