// The finite-element compliance A = sum over bodies of B K^-1 B^T / (dx dy): piecewise constant
// tractions are loaded consistently on the FE faces (B^T, exact), displacement is averaged over the
// contact element (B), so that A is symmetric by construction.
#pragma once

#include "contact/compliance.hpp"
#include "contact/result.hpp"
#include "fem/body.hpp"

#include <memory>
#include <vector>

namespace rollfem::fem {

/// One body's part. Tractions and displacement are in the local frame of its own surface; the sign
/// with which they enter the difference (wheel +, rail -, load -) is handled in FemCompliance.
class SurfaceCoupling {
 public:
  /// `grid`: contact elements in (s, t). A half body is loaded with the mirror image understood:
  /// elements at t < 0 mirror those at t > 0 (x and n components even, y component odd).
  /// Throws contact::InputError when the grid reaches beyond the body's surface or its elements are
  /// finer than the FE faces under them.
  SurfaceCoupling(const Body& body, const contact::ContactGrid& grid);
  ~SurfaceCoupling();
  /// b = B^T p.
  void load(const contact::SurfaceField& traction, Vector& b) const;
  /// Mean displacement over each element; the same on every process.
  contact::SurfaceField sample(const Vector& displacement) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Slip u_n / R that a displacement of the wheel's surface towards the axle brings: it shortens the
/// circles on which the material runs. Together with the difference along the streamline it gives
/// the surface strain, so that a rigid displacement slips nowhere.
contact::Field curvature_slip(const SurfaceShape& wheel, const contact::SurfaceField& displacement);

class FemCompliance : public contact::Compliance {
 public:
  struct Part {
    const Body* body;
    const LinearSolver* solver;
  };
  /// Wheel and rail; both outlive the compliance. Parts are solved at the same time on two threads
  /// when there is one process and both solvers are factorisations.
  FemCompliance(const Part& wheel, const Part& rail, const contact::ContactGrid& grid);
  ~FemCompliance() override;
  const contact::ContactGrid& grid() const override;
  contact::SurfaceField apply(const contact::SurfaceField& traction) const override;
  /// With the curvature slip of the wheel.
  contact::Response respond(const contact::SurfaceField& traction) const override;
  /// Displacement of wheel (0) and rail (1) under the tractions, for stresses and ParaView.
  std::vector<Vector> body_displacements(const contact::SurfaceField& traction) const;
  int solves() const;  ///< apply() calls so far

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Displacement and recovered nodal stress of a body as plain arrays (gathered on process 0),
/// mirrored to the full body when it is half. Every FE cell becomes 8 hexahedra (degree 2).
contact::BodyField body_field(const Body& body, const Vector& displacement,
                              const std::string& name);

}  // namespace rollfem::fem
