// Two elastic half-planes in plane strain as a compliance: line contact of rollers, on a contact
// grid of one row. Influence coefficients in closed form (the half-space's integrated along y:
// Johnson 1985, eq. 2.30 to 2.33), dense matrices: exact, and quick up to some thousand elements.
#pragma once

#include "contact/scene/geometry.hpp"
#include "contact/solve/compliance.hpp"

#include <memory>

namespace rollfem::halfspace {

/// Half-planes under tractions that do not change with y. The grid has one row (ny = 1); its dy is
/// the length of roller that forces are for: dy = 1 gives N/mm. u_y is that of antiplane shear.
///
/// A half-plane has no fixed point at infinity: displacements are relative to what a traction
/// causes at the distance `reference` from it, which the approach and shift depend on and nothing
/// else does. It must exceed the length of the grid for A to be positive; 0 takes ten of them.
class LineCompliance : public contact::SolvableCompliance {
 public:
  /// Throws contact::InputError for a grid of several rows or more than 4000 elements.
  LineCompliance(const contact::ContactGrid& grid, const contact::CombinedMaterial& material,
                 double reference = 0.0);
  ~LineCompliance() override;

  const contact::ContactGrid& grid() const override;
  /// All components, with the normal-tangential coupling K of unlike materials.
  contact::SurfaceField apply(const contact::SurfaceField& traction) const override;

  const contact::NormalOperator& normal() const override;
  const contact::TangentialOperator& shift() const override;
  const contact::TangentialOperator& rolling(contact::UpwindOrder order) const override;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace rollfem::halfspace
