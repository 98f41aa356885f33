// gmsh's library for as long as an object lives. Internal to meshes/.
#pragma once

#include <string>

namespace rollfem::meshes {

/// One at a time in a process: gmsh has one global state.
class GmshSession {
 public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;
};

/// What gmsh complained about last; "unknown error" when it did not say.
std::string gmsh_complaint();

/// How cross-sections are meshed: in quadrilaterals whose sizes follow the lines of the boundary,
/// which are given.
void set_quadrilaterals();

/// Meshes the plane surfaces of the model. Throws contact::InputError, which advises to change
/// `what`.
void mesh_plane(const std::string& what);

}  // namespace rollfem::meshes
