// SPDX-License-Identifier: LGPL-2.1-or-later
// Coupling of contact grid and FE surface: integrals of the shape functions over the overlap of
// contact elements and FE faces (chart_face.hpp), the same for loading and sampling.
#pragma once

#include "contact/scene/contact_surface.hpp"
#include "fem/discretisation/body.hpp"
#include "fem/trace/lattice_deficit.hpp"

#include <memory>
#include <optional>

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

}  // namespace rollfem::fem
