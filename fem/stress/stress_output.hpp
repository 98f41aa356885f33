// SPDX-License-Identifier: LGPL-2.1-or-later
// The stresses that a case requests of finite elements: at its [[subsurface.*]] points, the largest
// ones of each body, and those of all nodes where the load point keeps them.
#pragma once

#include "contact/result/result.hpp"
#include "fem/trace/compliance.hpp"

#include <memory>

namespace rollfem::fem {

class StressOutput {
 public:
  /// Finds the points of the case in the bodies, which outlive this; a rigid one has none. Points
  /// above a contact surface by up to `reach` (mm) are moved onto it; further out they are an
  /// contact::InputError that names the request. `grid`: of the tractions of the load points.
  /// `fields`: values of all nodes are kept as [output] body_fields says. Collective.
  StressOutput(const contact::Scene& scene, const BodyPair& bodies,
               const contact::ContactGrid& grid, double reach, bool fields);
  ~StressOutput();
  /// Whether load point k asks for anything: else fill() need not be called.
  bool wanted(std::size_t k) const;
  /// Adds `subsurface`, `stress_maxima` and `bodies` to load point k for the displacements of wheel
  /// and rail, which belong to the tractions in the fields of the point; at the surface these enter
  /// (surface_stress.hpp). `expansion`: displacement of the wheel by its spinning, which is in
  /// `bodies` alone; may be null. Collective.
  void fill(std::size_t k, contact::PointResult& point, const std::vector<Vector>& displacement,
            const Vector* expansion) const;
  /// Wheel and rail for ModelResult::bodies: whole on process 0; none when no load point keeps
  /// them.
  std::vector<contact::BodyField> bodies() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// The place at (x, y) and `depth` (mm) below the contact surface of a body: along z in the rail,
/// towards the axle in the wheel. Throws contact::InputError where the wheel does not reach x.
std::array<double, 3> place_below(const SurfaceShape& shape, double x, double y, double depth);

}  // namespace rollfem::fem
