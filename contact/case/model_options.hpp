// SPDX-License-Identifier: LGPL-2.1-or-later
// What single models are asked for: a section of the case file each, which no other model reads.
#pragma once

#include "contact/base/choices.hpp"

#include <optional>

namespace rollfem::contact {

struct FastsimOptions {
  BoundShape bound = BoundShape::parabolic;  ///< 4/3 mu p0 (1 - r^2), or mu p0 sqrt(1 - r^2)
  Flexibilities flexibilities = Flexibilities::three;
  FastsimElements elements = FastsimElements::chord;
  int strips = 100;          ///< across the patch
  int strip_elements = 100;  ///< along each strip, for `grid` along the longest
};

/// Where the elements of the model halfspace lie: in the tangent plane, along the arc of the common
/// surface across, or as the spread of the contact's normals asks for.
enum class SurfaceForm { automatic, planar, curved };

struct HalfspaceOptions {
  SurfaceForm surface = SurfaceForm::automatic;
  bool model_error = false;
};

struct StripOptions {
  int strips = 100;
  int strip_elements = 100;
  /// Share of the approach by which the profiles penetrate; not given: as Hertz's ellipse does.
  std::optional<double> virtual_penetration;
};

struct CarterOptions {
  int strips = 200;
};

enum class LinearSolver { automatic, factorisation, multigrid, algebraic };
/// How the program meshes wheel and rail: a graded box laid on the surface, or a gmsh cross-section
/// revolved and extruded, with profiles the true section of rail and rim.
enum class MeshFamily { structured, gmsh };
/// How the far boundary of the segments is held: fixed, or displaced as a half-space under the
/// force on the patch, taken as a point load.
enum class FarBoundary { clamped, point_load };

struct FemOptions {
  std::optional<double> cell_size;    ///< mm, FE cell and contact element in the patch
  int degree = 2;                     ///< polynomial degree of the displacement
  std::optional<double> extent;       ///< mm, how far the segments reach from the patch
  std::optional<double> width;        ///< mm, of the segments across; else twice the extent
  std::optional<double> depth;        ///< mm, of the segments; else the extent
  std::optional<double> length;       ///< mm, of the segments along rolling; else twice the extent
  std::optional<double> fine_extent;  ///< finest cells reach this many patch semi-axes
  std::optional<MeshFamily> mesh;     ///< not given: structured where it fits
  std::optional<double> rim_thickness;      ///< mm, of the wheel's true section below the tread
  std::optional<FarBoundary> far_boundary;  ///< not given: chosen by the kind of mesh
  LinearSolver linear_solver = LinearSolver::automatic;
  bool inertia = false;  ///< of wheel and rail at Rolling::speed
};

/// Read by the models that they are named after; a scene carries them unread.
struct ModelOptions {
  HalfspaceOptions halfspace;
  FastsimOptions fastsim;
  StripOptions strip;
  CarterOptions carter;
  FemOptions fem;
};

}  // namespace rollfem::contact
