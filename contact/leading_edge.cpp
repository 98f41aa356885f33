#include "contact/leading_edge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::contact {

namespace {

constexpr double usual_weight = 0.5;

/// Distance of the edge ahead of the centre of the leading element `k`, in elements: the square of
/// the bound falls linearly to zero there. Constant pressures are off in the outermost two elements,
/// however fine the grid; the next three give the edge to 0.02 of an element. Half an element where
/// there are too few elements to tell.
double edge_ahead(const Field& bound, Eigen::Index k, int elements_behind) {
  constexpr double nearest = 0.0;
  constexpr double farthest = 0.95;
  constexpr double unknown = 0.5;
  if (elements_behind < 4) return unknown;
  const double one = bound[k - 2] * bound[k - 2];
  const double two = bound[k - 3] * bound[k - 3];
  const double three = bound[k - 4] * bound[k - 4];
  // Parabola through the three, from the centre of element k - 2 on.
  const double slope = 0.5 * (3.0 * one - 4.0 * two + three);
  const double curvature = 0.5 * (one - 2.0 * two + three);
  const double discriminant = slope * slope - 4.0 * curvature * one;
  if (!(slope < 0.0) || discriminant < 0.0) return unknown;
  const double root = 2.0 * one / (-slope + std::sqrt(discriminant));
  return std::clamp(root - 2.0, nearest, farthest);
}

}  // namespace

Field upwind_weights(const ContactGrid& grid, const Field& traction_bound) {
  Field weights = Field::Constant(grid.size(), usual_weight);
  for (int j = 0; j < grid.ny; ++j) {
    int run = 0;
    for (int i = 0; i + 1 < grid.nx; ++i) {
      const int k = grid.index(i, j);
      run = traction_bound[k] > 0.0 ? run + 1 : 0;
      if (run == 0 || traction_bound[k + 1] > 0.0) continue;
      const double e = edge_ahead(traction_bound, k, run - 1);
      weights[k] = 1.0 / (std::pow((2.0 - e) / (1.0 - e), 1.5) - 2.0);
    }
  }
  return weights;
}

EdgeFittedRolling::EdgeFittedRolling(const TangentialOperator& first,
                                     const TangentialOperator& second, Field weights)
    : first_(first), second_(second), weights_(std::move(weights)) {}

Field EdgeFittedRolling::combined(const Field& differences) const {
  const ContactGrid& on = grid();
  Field result = differences;
  for (int j = 0; j < on.ny; ++j)
    for (int i = 0; i + 1 < on.nx; ++i) {
      const int k = on.index(i, j);
      result[k] += weights_[k] * (differences[k] - differences[k + 1]);
    }
  return result;
}

TangentialField EdgeFittedRolling::apply(const TangentialField& traction) const {
  const TangentialField d = first_.apply(traction);
  return {combined(d.x), combined(d.y)};
}

TangentialField EdgeFittedRolling::precondition(const TangentialField& residual, double r,
                                                double shift) const {
  return second_.precondition(residual, r, shift);
}

}  // namespace rollfem::contact
