#include "meshes/gmsh_session.hpp"

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

}  // namespace rollfem::meshes
