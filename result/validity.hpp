// SPDX-License-Identifier: LGPL-2.1-or-later
// The checks that every result passes before it leaves a model (ModelRegistry::run): conditions
// that hold at every load point in any model, and warnings for the reader.
#pragma once

#include "result/patch_size.hpp"
#include "result/result.hpp"

namespace rollfem::contact {

/// Properties of the model needed by the gate.
struct ResultKind {
  bool elastic = true;      ///< solved on the contact grid; otherwise sampled from a closed form
  bool bounded = true;      ///< its tractions respect the friction bound
  bool half_spaces = true;  ///< its bodies are half-spaces
};

/// Fewest elements along a side of the patch for a meaningful pressure.
inline constexpr int fewest_elements_across = 4;
/// Allowed relative error of the force along the direction of the load.
inline constexpr double largest_imbalance = 1e-6;
/// Beyond this fraction of a radius the surface turns by 0.3 rad across half the patch, and the
/// bodies are not half-spaces: under the same load the largest pressure of the half-space is
/// then 3.7 % below that of Persson's conforming pin (docs/troubleshooting.md).
inline constexpr double largest_patch_part = 0.3;
/// Beyond this fraction of a radius displacements change the geometry itself.
inline constexpr double largest_approach_part = 0.02;
/// MPa; beyond it no rail or wheel steel stays elastic: the shakedown limit is about 4 times the
/// yield strength in shear, 300 to 600 MPa.
inline constexpr double largest_elastic_pressure = 3000.0;

/// Whether the case determines every element.
bool gives_grid(const Scene& scene);

/// That these are fewer elements than fewest_elements_across, and what to do.
std::string few_elements_text(long along, long across, const ContactGrid& grid);

/// Whether it also gives the undeformed distance by points, so that nothing is known beyond the
/// grid, or so few elements that all are at the border: then the patch ends where the grid does.
bool ends_with_grid(const Scene& scene, const ContactGrid& grid);

/// Whether the patch ends before the grid does, or with it.
inline bool holds_patch(const Scene& scene, const ContactGrid& grid, const Field& pressure) {
  return ends_with_grid(scene, grid) || !touches_border(grid, pressure);
}

/// A load point and the conditions for its check.
struct ValidatedPoint {
  const ContactGrid& grid;
  const PointResult& point;
  NormalLoad load{};     ///< without a force there is no balance to check
  bool touching = true;  ///< the bodies have surfaces that approach each other
  ResultKind kind{};
  std::size_t index = 0, count = 1;  ///< of the load points of the result
  bool given_grid = false;           ///< gives_grid(): a warning tells of few elements
  bool ends_with_grid = false;
};

/// Throws SolveError for a load point that is not converged, has a non-finite number, a patch that
/// exceeds the grid or, on a grid that the case does not give, has fewer than
/// fewest_elements_across elements along a side, a tensile
/// pressure, a gap under pressure or an overlap beside it, a traction beyond its bound, a force
/// different from the load, or a force without positive approach. The text names load point,
/// figure, limit and remedy.
void check_point(const ValidatedPoint& at);

/// The same for the first such load point.
void check_validity(const Scene& scene, const ModelResult& result, const ResultKind& kind = {});

/// Warnings, each of the worst load point: patch or approach not small against the
/// radii, pressure beyond the elastic limit of steel.
std::vector<Note> validity_warnings(const Scene& scene, const ModelResult& result,
                                    const ResultKind& kind = {});

// Violation of the contact conditions by the fields of a load point, computed only from the
// reported fields, independent of the iteration.

/// 0 where they hold exactly, and for models without these fields.
struct ContactResidual {
  /// Largest |gap| under pressure and largest penetration elsewhere, over the largest normal
  /// displacement difference.
  double gap = 0.0;
  /// Largest excess of |p_t| over its bound, divided by the largest bound.
  double excess = 0.0;
};

/// Allowed violations: half-spaces and finite elements stay below 1e-6 of either, except where
/// unlike materials couple friction with the gap, whose outer iteration ends at 1e-4.
inline constexpr ContactResidual largest_residual{2e-3, 1e-4};

ContactResidual contact_residual(const ContactFields& fields);

}  // namespace rollfem::contact
