// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest pressure between the rows of a coarse grid. Where the profile radius jumps, it is a
// peak narrower than an element.
#pragma once

#include "contact/iteration/bound_constrained_cg.hpp"
#include "scene/geometry.hpp"

#include <vector>

namespace rollfem::halfspace {

/// Angle between the normals of the first and the last row under pressure, rad.
double turn_of(const contact::ChartedGeometry& geometry, const contact::ContactGrid& grid,
               const contact::Field& pressure);
/// A patch whose normals turn by more than this is conformal, rad.
inline constexpr double most_turn = 0.35;

/// Solves the patch across rolling twice with rows of equal length and semi-elliptic pressure along
/// rolling: on the rows of the grid and on rows of a quarter of their width, with equal load. The
/// ratio of the two pressures at a row corrects the pressure of the grid there.
class PeakPressure {
 public:
  /// `modulus`: contact modulus, MPa.
  explicit PeakPressure(double modulus) : modulus_(modulus) {}

  /// A largest pressure and its estimated error, MPa.
  struct Peak {
    double pressure = 0.0;
    double bar = 0.0;
  };
  /// The corrected largest pressure; for a conformal patch the uncorrected one with a larger bar.
  /// Throws contact::SolveError.
  Peak of(const contact::ChartedGeometry& geometry, const contact::ContactGrid& grid,
          const contact::Field& pressure);

 private:
  /// Rows across the patch: displacement of their middles under pressures in MPa.
  struct Rows : contact::NormalMap {
    Eigen::MatrixXd influence;
    contact::Field distance;
    contact::BoundConstrainedCg solver;

    void apply(const contact::Field& pressure, contact::Field& displacement) const override {
      displacement.noalias() = influence * pressure;
    }
    void precondition(const contact::Field& residual, contact::Field& result) const override {
      result = residual;
    }
  };

  void solve(Rows& rows, const contact::ChartedGeometry& geometry,
             const contact::ContactGrid& line);

  double between_rows(const contact::ContactGrid& grid, const contact::Field& pressure) const;

  double modulus_;
  double half_ = 0.0;  ///< half-length of the rows, mm
  double sum_ = 0.0;   ///< sum of middle pressure times width over the rows, N/mm
  Rows coarse_, fine_;
};

}  // namespace rollfem::halfspace
