// SPDX-License-Identifier: LGPL-2.1-or-later
// gmsh mesh files: reading hexahedra with the physical surfaces contact, fixed and symmetry, and
// writing them.
#pragma once

#include "meshes/hex_mesh.hpp"

#include <string>

namespace rollfem::meshes {

/// Reads a .msh file of format 2.2 or 4.1, text or binary, and no other file. Nodes that belong to
/// no hexahedron are left out, and so are lines, points and surface groups of other names.
/// `shown_name` stands in messages. Throws contact::InputError naming line or byte: no such file,
/// not a gmsh mesh, other format, cut short, numbers that cannot be, cells that are not hexahedra
/// with 8 corners. Whether the mesh makes sense is for check_mesh().
HexMesh read_msh(const std::string& path, const std::string& shown_name);

/// The mesh as a file of format 4.1, text; read_msh() gives it back.
std::string msh_text(const HexMesh& mesh);

}  // namespace rollfem::meshes
