// The stresses that a case asks for in finite elements: at its [[subsurface.*]] points and the
// largest ones of each body.
#pragma once

#include "contact/result.hpp"
#include "fem/compliance.hpp"

#include <memory>

namespace rollfem::fem {

class StressOutput {
 public:
  /// Finds the points of the case in the bodies, which outlive this. Points above a contact surface
  /// by up to `reach` (mm) are moved onto it; further out they are an contact::InputError that
  /// names the request. `grid`: of the tractions of the load points. Collective.
  StressOutput(const contact::Case& input, const Body& wheel, const Body& rail,
               const contact::ContactGrid& grid, double reach);
  ~StressOutput();
  /// Whether the case asks for anything: else fill() need not be called.
  bool wanted() const;
  /// Adds `subsurface` and `stress_maxima` for the displacements of wheel and rail, which belong to
  /// the tractions in the fields of the point; at the surface these enter (surface_stress.hpp).
  /// Collective.
  void fill(contact::PointResult& point, const std::vector<Vector>& displacement) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// The place at (x, y) and `depth` (mm) below the contact surface of a body: along z in the rail,
/// towards the axle in the wheel. Throws contact::InputError where the wheel does not reach x.
std::array<double, 3> place_below(const SurfaceShape& shape, double x, double y, double depth);

}  // namespace rollfem::fem
