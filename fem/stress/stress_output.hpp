// SPDX-License-Identifier: LGPL-2.1-or-later
// The stresses of finite elements requested by a case: at its [[subsurface.*]] points, the largest
// ones of each body, and at all nodes for load points that store them.
#pragma once

#include "fem/discretisation/body_points.hpp"
#include "fem/stress/stress_recovery.hpp"
#include "fem/trace/fem_compliance.hpp"
#include "result/result.hpp"

#include <array>
#include <memory>
#include <vector>

namespace rollfem::fem {

class StressOutput {
 public:
  /// Finds the points of the case in the bodies, which must outlive this object; a rigid one has
  /// none. Points above a contact surface by up to `reach` (mm) are moved onto it; points further
  /// away cause a contact::InputError that names the request. `grid`: grid of the load points'
  /// tractions. `fields`: nodal values are stored according to [output] body_fields. Collective.
  StressOutput(const contact::Scene& scene, const BodyPair& bodies,
               const contact::ContactGrid& grid, double reach, bool fields);
  ~StressOutput();
  /// Whether load point k has requests; otherwise fill() need not be called.
  bool wanted(std::size_t k) const;
  /// Adds `subsurface`, `stress_maxima` and `bodies` to load point k for the displacements of wheel
  /// and rail, which correspond to the tractions in the fields of the point; the tractions
  /// determine the surface stress (surface_stress.hpp). `expansion`: displacement of the wheel by
  /// its spinning, included only in `bodies`; may be null. Collective.
  /// `yielded`: plastic strain of wheel and rail; null: none.
  void fill(std::size_t k, contact::PointResult& point, const std::vector<Vector>& displacement,
            const Vector* expansion, const std::array<const YieldedFields*, 2>& yielded = {}) const;
  /// Wheel and rail for ModelResult::bodies: whole on process 0; none when no load point stores
  /// them.
  std::vector<contact::BodyField> bodies() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// At points: xx yy zz xy yz xz, in space.
std::vector<contact::SymmetricTensor> stress_at(const BodyPoints& points,
                                                const NodalStress& stress);

/// The point at (x, y) and `depth` (mm) below the contact surface of a body: along z in the rail,
/// towards the axle in the wheel. Throws contact::InputError where x is outside the wheel.
std::array<double, 3> place_below(const SurfaceShape& shape, double x, double y, double depth);

}  // namespace rollfem::fem
