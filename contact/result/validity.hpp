// SPDX-License-Identifier: LGPL-2.1-or-later
// The checks that every result passes before it leaves a model (ModelRegistry::run): conditions
// that hold at every load point in any model, and warnings for the reader.
#pragma once

#include "contact/result/result.hpp"

namespace rollfem::contact {

/// What the gate has to know of the model.
struct ResultKind {
  bool elastic = true;      ///< found on the contact grid; else sampled there from a closed form
  bool bounded = true;      ///< its tractions keep the bound of friction
  bool half_spaces = true;  ///< its bodies are plane for the elasticity
};

/// Fewer elements than this along a side of the patch make no pressure.
inline constexpr int fewest_elements_across = 4;
/// Relative error of the force along the direction of the load.
inline constexpr double largest_imbalance = 1e-6;
/// Beyond this part of a radius the surface turns by 0.3 rad across half the patch, and bodies are
/// no half-spaces: under the same load the largest pressure of the half-space is then
/// 3.7 % below that of Persson's conforming pin (docs/troubleshooting.md).
inline constexpr double largest_patch_part = 0.3;
/// Beyond this part of a radius displacements change the geometry that they are counted from.
inline constexpr double largest_approach_part = 0.02;
/// MPa; beyond it no rail or wheel steel stays elastic: shakedown ends at some 4 times the yield
/// strength in shear, 300 to 600 MPa.
inline constexpr double largest_elastic_pressure = 3000.0;

/// A load point and what it is checked against.
struct CheckedPoint {
  const ContactGrid& grid;
  const PointResult& point;
  NormalLoad load{};     ///< without a force nothing has to balance
  bool touching = true;  ///< the bodies have surfaces that come together
  ResultKind kind{};
  std::size_t index = 0, count = 1;  ///< of the load points of the result
};

/// Throws SolveError for a load point that is not converged, has a number that is not
/// finite, a patch that the grid does not hold or that has fewer than fewest_elements_across
/// elements along a side, a tensile pressure, a gap under pressure or an overlap beside it, a
/// traction beyond its bound, a force that is not the load asked for, or bodies that carry a force
/// and have not come together. The text names load point, figure, limit and what to do.
void check_point(const CheckedPoint& at);

/// The same for the first of all load points that is so.
void check_validity(const Scene& scene, const ModelResult& result, const ResultKind& kind = {});

/// "warning: ..." sentences, each of the worst load point: patch or approach that are not small
/// against the radii, pressure beyond what steel bears.
std::vector<std::string> validity_warnings(const Scene& scene, const ModelResult& result,
                                           const ResultKind& kind = {});

// Violation of the contact conditions by the fields of a load point, computed from the reported
// fields alone and independent of the iteration that found them.

/// 0 each where they hold exactly, and where a model does not give the fields.
struct ContactResidual {
  /// Largest |gap| under pressure and largest penetration elsewhere, over the largest normal
  /// displacement difference.
  double gap = 0.0;
  /// By how much |p_t| exceeds its bound at most, over the largest bound.
  double excess = 0.0;
};

/// What iterations may leave: half-spaces leave less than 1e-6 of either, finite elements too
/// unless unlike materials couple friction with the gap, whose outer iteration ends at 1e-4.
inline constexpr ContactResidual largest_residual{2e-3, 1e-4};

ContactResidual contact_residual(const ContactFields& fields);

}  // namespace rollfem::contact
