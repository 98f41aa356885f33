// SPDX-License-Identifier: LGPL-2.1-or-later
// The finite-element compliance A = sum over bodies of S^-1 B K^-1 B^T + M, S the true areas of the
// contact elements: piecewise constant tractions are loaded consistently on the FE faces (B^T,
// exact), displacement is averaged over the contact element (S^-1 B), and M converts the mean to
// the displacement at the element's centre (middle_displacement.hpp). A is symmetric by
// construction.
#pragma once

#include "contact/iteration/compliance.hpp"
#include "fem/discretisation/body.hpp"
#include "fem/fem_options.hpp"
#include "fem/linear/linear_solver.hpp"
#include "fem/trace/middle_displacement.hpp"
#include "scene/contact_surface.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace rollfem::fem {

/// One body's part. Tractions and displacement are along the lateral tangent and the normal of the
/// common contact surface, so that the loads on both bodies are equal and opposite; along rolling
/// the frame turns with the body's streamlines. FemCompliance handles their sign in the difference
/// (wheel +, rail -, load -).
class SurfaceCoupling {
 public:
  /// `grid`: contact elements in (s, t), t the lateral coordinate y; `surface`: the common surface.
  /// A half body includes its mirror image: elements at t < 0 mirror those at t > 0 (x and n
  /// components even, y component odd). Throws contact::InputError when the grid extends beyond the
  /// body's surface or its elements are finer than the FE faces under them.
  SurfaceCoupling(const Body& body, const contact::ContactGrid& grid,
                  const contact::ContactSurface& surface);
  ~SurfaceCoupling();
  /// b = B^T p.
  void load(const contact::SurfaceField& traction, Vector& b) const;
  /// Mean displacement over each element; the same on every process.
  contact::SurfaceField sample(const Vector& displacement) const;
  /// The cells under the grid, if every element consists of whole faces of equal size.
  std::optional<Lattice> lattice() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

class FemCompliance : public contact::Compliance {
 public:
  /// Both null: a rigid body, without contribution.
  struct Part {
    const Body* body;
    const LinearSolver* solver;
  };
  /// Wheel and rail, one of which may be rigid, and their common surface; all must outlive the
  /// compliance. Parts are solved in parallel on two threads when both solvers allow it.
  /// FarBoundary::point_load adds the displacement due to the far boundary, which is linear in the
  /// resultant force (and costs three solves per body, here): the compliance is then no longer
  /// exactly symmetric, see docs/theory.md.
  FemCompliance(const Part& wheel, const Part& rail, const contact::ContactSurface& surface,
                const contact::ContactGrid& grid, FarBoundary far = FarBoundary::clamped);
  /// For load points on several threads: shares everything but the vectors of a solve.
  FemCompliance(const FemCompliance& other);
  ~FemCompliance() override;
  bool copies_run_beside_each_other() const;
  const contact::ContactGrid& grid() const override;
  contact::SurfaceField apply(const contact::SurfaceField& traction) const override;
  /// With the curvature slip of the wheel. Collective; empty on all processes except the first,
  /// which receives the result.
  contact::Response respond(const contact::SurfaceField& traction) const override;
  /// Displacement of wheel (0) and rail (1) under the tractions, for stresses and ParaView; empty
  /// for a rigid body.
  std::vector<Vector> body_displacements(const contact::SurfaceField& traction) const;
  int solves() const;  ///< apply() calls of this copy so far
  /// Displacement of each body beyond the elastic one (mm, with ghost values) as a function of the
  /// elastic one; empty: none. Collective.
  using Beyond = std::function<std::vector<Vector>(const std::vector<Vector>& elastic)>;
  /// Added to every response of this copy.
  void set_beyond_elastic(Beyond beyond);

 private:
  struct Shared;
  struct State;
  std::shared_ptr<const Shared> shared_;
  std::unique_ptr<State> state_;
};

}  // namespace rollfem::fem
