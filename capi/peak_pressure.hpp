// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest pressure between the rows of a grid of few elements: where the radii of the profiles
// change it is a peak narrower than an element.
#pragma once

#include "contact/iteration/bound_constrained_cg.hpp"
#include "contact/scene/geometry.hpp"

#include <vector>

namespace rollfem::capi {

/// Angle between the normals of the first and the last row under pressure, rad.
double turn_of(const contact::ChartedGeometry& geometry, const contact::ContactGrid& grid,
               const contact::Field& pressure);
/// A patch whose normals turn by more is conformal.
inline constexpr double most_turn = 0.35;

/// Rows of one length under semi-elliptic pressures along rolling are solved across the patch
/// twice, on the rows of the grid and on rows of a quarter of their width; they carry the same. The
/// ratio of both pressures at a row is what the grid leaves out there.
class PeakPressure {
 public:
  /// `modulus`: contact modulus, MPa.
  explicit PeakPressure(double modulus) : modulus_(modulus) {}

  /// A largest pressure and its estimated error, MPa.
  struct Peak {
    double pressure = 0.0;
    double bar = 0.0;
  };
  /// In place of the largest pressure of the elements, but of a conformal patch that with a larger
  /// bar. Throws contact::SolveError.
  Peak of(const contact::ChartedGeometry& geometry, const contact::ContactGrid& grid,
          const contact::Field& pressure);

 private:
  /// Displacement of the middles of the rows under the pressures there, MPa.
  struct Rows {
    Eigen::MatrixXd influence;
    contact::Field distance;
    contact::BoundConstrainedCg solver;

    void apply(const contact::Field& pressure, contact::Field& displacement) const {
      displacement.noalias() = influence * pressure;
    }
    void precondition(const contact::Field& residual, contact::Field& result) const {
      result = residual;
    }
  };

  void solve(Rows& rows, const contact::ChartedGeometry& geometry,
             const contact::ContactGrid& line);

  double between_rows(const contact::ContactGrid& grid, const contact::Field& pressure) const;

  double modulus_;
  double half_ = 0.0;  ///< length of the rows, mm
  double sum_ = 0.0;   ///< of the pressures in the middle of the rows, each times its width, N/mm
  Rows coarse_, fine_;
};

}  // namespace rollfem::capi
