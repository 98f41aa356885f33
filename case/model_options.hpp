// SPDX-License-Identifier: LGPL-2.1-or-later
// Options of individual models: one section of the case file each, ignored by all other models.
#pragma once

#include "base/choices.hpp"

#include <array>
#include <optional>

namespace rollfem::contact {

struct FastsimOptions {
  BoundShape bound = BoundShape::parabolic;  ///< 4/3 mu p0 (1 - r^2), or mu p0 sqrt(1 - r^2)
  Flexibilities flexibilities = Flexibilities::three;
  FastsimElements elements = FastsimElements::chord;
  int strips = 100;          ///< across the patch
  int strip_elements = 100;  ///< along each strip, for `grid` along the longest
  /// k_0, alpha_inf, beta of the initial slope, which is reduced by 1/k (Spiryagin, Polach and
  /// Cole).
  std::array<double, 3> slope_reduction{1.0, 1.0, 1.0};
};

/// Position of the elements of the model halfspace: in the tangent plane, along the common surface
/// across, or chosen by the spread of the contact's normals.
enum class SurfaceForm { automatic, planar, curved };

struct HalfspaceOptions {
  SurfaceForm surface = SurfaceForm::automatic;
  bool model_error = false;
};

struct StripOptions {
  int strips = 100;
  int strip_elements = 100;
  /// Ratio of virtual penetration to approach; unset: Hertz's ellipse.
  std::optional<double> virtual_penetration;
};

struct CarterOptions {
  int strips = 200;
};

struct PolachOptions {
  double adhesion_reduction = 1.0;  ///< k_A
  double slip_reduction = 1.0;      ///< k_S
};

enum class LinearSolver { automatic, factorisation, multigrid, algebraic };
/// Meshing of wheel and rail: a graded box fitted to the surface, or a gmsh cross-section revolved
/// and extruded (with profiles, the true section of rail and rim).
enum class MeshFamily { structured, gmsh };
/// Far boundary of the segments: fixed, or displaced like a half-space under the force on the patch
/// as a point load.
enum class FarBoundary { clamped, point_load };
/// Pressure of the passes over bodies that yield: that of the bodies as they are, or of elastic
/// ones.
enum class PassPressure { yielding, elastic };

struct FemOptions {
  std::optional<double> cell_size;  ///< mm, FE cell and contact element in the patch
  int degree = 2;                   ///< polynomial degree of the displacement
  std::optional<double> extent;     ///< mm, extent of the segments from the patch
  std::optional<double> width;      ///< mm, of the segments across; default twice the extent
  std::optional<double> depth;      ///< mm, of the segments; default the extent
  std::optional<double> length;     ///< mm, of the segments along rolling; default twice the extent
  std::optional<double> fine_extent;        ///< extent of the finest cells, in patch semi-axes
  std::optional<MeshFamily> mesh;           ///< unset: structured where possible
  std::optional<double> rim_thickness;      ///< mm, of the wheel's true section below the tread
  std::optional<FarBoundary> far_boundary;  ///< unset: chosen by the kind of mesh
  LinearSolver linear_solver = LinearSolver::automatic;
  bool inertia = false;  ///< of wheel and rail at Rolling::speed
  int passes = 1;        ///< over bodies that yield
  int cycle = 1;         ///< load points given, after which the passes repeat them
  PassPressure pass_pressure = PassPressure::yielding;
  bool limit_state = false;     ///< passes approach the state that repeats by extrapolation
  double plastic_extent = 1.0;  ///< of the streamlines that may yield, relative to the usual one
};

/// Each is used only by the model of that name; a scene passes them on.
struct ModelOptions {
  HalfspaceOptions halfspace;
  FastsimOptions fastsim;
  StripOptions strip;
  CarterOptions carter;
  PolachOptions polach;
  FemOptions fem;
};

}  // namespace rollfem::contact
