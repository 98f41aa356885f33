// SPDX-License-Identifier: LGPL-2.1-or-later
// gmsh mesh files: reading hexahedra with the physical surfaces contact, fixed and symmetry, and
// writing them.
#pragma once

#include "meshes/hex_mesh.hpp"

#include <string>

namespace rollfem::meshes {

/// Reads a .msh file of format 2.2 or 4.1, text or binary, and opens no other file. Nodes that
/// belong to no hexahedron are dropped, and so are lines, points and surface groups of other names.
/// `shown_name` is used in messages. Throws contact::InputError naming line or byte: no such file,
/// not a gmsh mesh, other format, truncated file, impossible numbers, cells that are not hexahedra
/// with 8 corners. check_mesh() checks the mesh itself.
HexMesh read_msh(const std::string& path, const std::string& shown_name);

/// The mesh as the text of a file in format 4.1; read_msh() reads it.
std::string msh_text(const HexMesh& mesh);

}  // namespace rollfem::meshes
