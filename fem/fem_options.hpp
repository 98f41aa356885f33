// SPDX-License-Identifier: LGPL-2.1-or-later
// Options of the finite-element model, which hybrid and the choice of a model know without its
// library. Their keys: modelling/fem/fem_models.cpp.
#pragma once

#include "scene/scene.hpp"

#include <array>
#include <optional>

namespace rollfem::fem {

enum class LinearMethod { automatic, factorisation, multigrid, algebraic };
/// Meshing of wheel and rail: a graded box fitted to the surface, or a gmsh cross-section revolved
/// and extruded (with profiles, the true section of rail and rim).
enum class MeshFamily { structured, gmsh };
/// Far boundary of the segments: fixed, or displaced like a half-space under the force on the patch
/// as a point load.
enum class FarBoundary { clamped, point_load };
/// Pressure of the passes over bodies that yield: that of the bodies as they are, or of elastic
/// ones.
enum class PassPressure { yielding, elastic };

/// Besides contact::Case::inertia and body_extent.
struct FemOptions {
  std::optional<double> cell_size;  ///< mm, FE cell and contact element in the patch
  int degree = 2;                   ///< polynomial degree of the displacement
  std::optional<double> width;      ///< mm, of the segments across; default twice the extent
  std::optional<double> depth;      ///< mm, of the segments; default the extent
  std::optional<double> length;     ///< mm, of the segments along rolling; default twice the extent
  std::optional<double> fine_extent;        ///< extent of the finest cells, in patch semi-axes
  std::optional<MeshFamily> mesh;           ///< unset: structured where possible
  std::optional<double> rim_thickness;      ///< mm, of the wheel's true section below the tread
  std::optional<FarBoundary> far_boundary;  ///< unset: chosen by the kind of mesh
  LinearMethod linear_solver = LinearMethod::automatic;
  int passes = 1;  ///< over bodies that yield
  int cycle = 1;   ///< load points given, after which the passes repeat them
  PassPressure pass_pressure = PassPressure::yielding;
  bool limit_state = false;     ///< passes approach the state that repeats by extrapolation
  double plastic_extent = 1.0;  ///< of the streamlines that may yield, relative to the usual one
  /// The same along, across and down, where steel has yielded at the border.
  std::array<double, 3> plastic_growth{1.0, 1.0, 1.0};
  std::optional<double> surface_layer;  ///< mm, height of the cells at a surface that yields
  bool thick_rows = false;  ///< memory demanded a thicker surface_layer than the strain needs
};

inline const FemOptions& options_of(const contact::Scene& scene) {
  return scene.options.of<FemOptions>();
}

/// Whether the scene has a patch of true profiles and its bodies are the true sections of wheel and
/// rail, not boxes under the surface.
inline bool has_true_sections(const contact::Scene& scene) {
  return scene.has_profiles() && options_of(scene).mesh == MeshFamily::gmsh;
}

}  // namespace rollfem::fem
