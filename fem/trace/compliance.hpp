// SPDX-License-Identifier: LGPL-2.1-or-later
// The finite-element compliance A = sum over bodies of S^-1 B K^-1 B^T + M, S the true areas of the
// contact elements: piecewise constant tractions are loaded consistently on the FE faces (B^T,
// exact), displacement is averaged over the contact element (S^-1 B), and M makes it that of the
// element's middle (middle_displacement.hpp). A is symmetric by construction.
#pragma once

#include "contact/iteration/compliance.hpp"
#include "contact/scene/contact_surface.hpp"
#include "fem/discretisation/body.hpp"
#include "fem/linear/linear_solver.hpp"
#include "fem/trace/lattice.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace rollfem::fem {

/// One body's part. Tractions and displacement are along the lateral tangent and the normal of the
/// contact surface that both bodies share, so that loads of both are equal and opposite; along
/// rolling the frame turns with the body's own streamlines. The sign with which they enter the
/// difference (wheel +, rail -, load -) is handled in FemCompliance.
class SurfaceCoupling {
 public:
  /// `grid`: contact elements in (s, t), t the lateral coordinate y; `surface`: what both share. A
  /// half body is loaded with the mirror image understood: elements at t < 0 mirror those at t > 0
  /// (x and n components even, y component odd). Throws contact::InputError when the grid reaches
  /// beyond the body's surface or its elements are finer than the FE faces under them.
  SurfaceCoupling(const Body& body, const contact::ContactGrid& grid,
                  const contact::ContactSurface& surface);
  /// On the body's own surface.
  SurfaceCoupling(const Body& body, const contact::ContactGrid& grid);
  ~SurfaceCoupling();
  /// b = B^T p.
  void load(const contact::SurfaceField& traction, Vector& b) const;
  /// Mean displacement over each element; the same on every process.
  contact::SurfaceField sample(const Vector& displacement) const;
  /// The cells under the grid, if every element consists of whole faces of one size.
  std::optional<Lattice> lattice() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// How the far boundary of the segments is held (far_field.hpp).
using FarBoundary = contact::FarBoundary;

class FemCompliance : public contact::Compliance {
 public:
  /// Both null: a rigid body, which contributes nothing.
  struct Part {
    const Body* body;
    const LinearSolver* solver;
  };
  /// Wheel and rail, of which one may be rigid, and the surface that they share; all outlive the
  /// compliance. Parts are solved at the same time on two threads when both solvers allow it.
  /// With FarBoundary::point_load the displacement that the far boundary brings is added, which is
  /// linear in the resultant force (and costs three solves a body, here): then no longer exactly
  /// symmetric, see docs/theory.md.
  FemCompliance(const Part& wheel, const Part& rail, const contact::ContactSurface& surface,
                const contact::ContactGrid& grid, FarBoundary far = FarBoundary::clamped);
  ~FemCompliance() override;
  const contact::ContactGrid& grid() const override;
  contact::SurfaceField apply(const contact::SurfaceField& traction) const override;
  /// With the curvature slip of the wheel. Collective; empty on other processes than the first, for
  /// which this is done.
  contact::Response respond(const contact::SurfaceField& traction) const override;
  /// Displacement of wheel (0) and rail (1) under the tractions, for stresses and ParaView; of a
  /// rigid body empty.
  std::vector<Vector> body_displacements(const contact::SurfaceField& traction) const;
  int solves() const;  ///< apply() calls so far

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace rollfem::fem
