#include "meshes/gmsh/gmsh_session.hpp"

#include "contact/base/errors.hpp"

#include <gmsh.h>

namespace rollfem::meshes {

GmshSession::GmshSession() {
  // No configuration files of the user: the same mesh everywhere.
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.NumThreads", 1);
}

GmshSession::~GmshSession() {
  gmsh::finalize();
}

std::string gmsh_complaint() {
  std::string text;
  gmsh::logger::getLastError(text);
  return text.empty() ? "unknown error" : text;
}

void set_quadrilaterals() {
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 1);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  // Frontal-Delaunay; the variant for quadrilaterals (8) crashes on sections in gmsh 4.8.4.
  gmsh::option::setNumber("Mesh.Algorithm", 6);
  gmsh::option::setNumber("Mesh.RecombinationAlgorithm", 1);
  gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", 1);
  gmsh::option::setNumber("Mesh.Smoothing", 10);
}

void mesh_plane(const std::string& what) {
  try {
    gmsh::model::geo::synchronize();
    gmsh::model::mesh::generate(2);
  } catch (...) {
    throw contact::InputError("gmsh cannot mesh the cross-section (" + gmsh_complaint() +
                              "): use [fem] mesh = \"structured\", or change " + what);
  }
}

}  // namespace rollfem::meshes
