// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/iteration/leading_edge.hpp"

#include "base/pieces.hpp"
#include "base/root.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

namespace rollfem::contact {

namespace {

constexpr double usual_weight = 0.5;

/// Largest distance of the edge from the border of the first element, in elements: at most 0.5
/// where elements are in contact when their centres are; a coarse grid locates the pressure less
/// accurately.
constexpr double farthest = 0.75;

using Run = GridRuns::Run;

/// The square of the bound falls linearly to zero at the edge: root of the parabola through the
/// three elements behind the leading one, which may be partly covered and is skipped; the next one
/// is skipped, too, if there are enough, because pressures of constant elements have a relative
/// error there that does not decrease with refinement and puts the edge 0.05 of an element too far
/// ahead (line contact), against at most 0.02 from the three behind. Elements ahead of the leading
/// border; empty when the bound does not fall.
std::optional<double> edge_of(const Field& bound, Eigen::Index leading, int elements) {
  constexpr int enough = 8;
  const int skipped = elements >= enough ? 2 : 1;
  const Eigen::Index k = leading - skipped;
  const double one = bound[k] * bound[k];
  const double two = bound[k - 1] * bound[k - 1];
  const double three = bound[k - 2] * bound[k - 2];
  const double slope = 0.5 * (3.0 * one - 4.0 * two + three);
  const double curvature = 0.5 * (one - 2.0 * two + three);
  const double discriminant = slope * slope - 4.0 * curvature * one;
  if (!(slope < 0.0) || discriminant < 0.0) return std::nullopt;
  const double ahead_of_centre = 2.0 * one / (-slope + std::sqrt(discriminant)) - skipped;
  return std::clamp(ahead_of_centre - 0.5, -farthest, farthest);
}

void add_runs_of_row(const ContactGrid& grid, const Field& bound, int j, std::vector<Run>& runs) {
  int first = -1;
  for (int i = 0; i + 1 < grid.nx; ++i) {
    const Eigen::Index k = grid.index(i, j);
    if (!(bound[k] > 0.0)) {
      first = -1;
      continue;
    }
    if (first < 0) first = i;
    if (bound[k + 1] > 0.0) continue;
    constexpr int fewest = 4;  // a run too short to locate its edge
    const int elements = i - first + 1;
    const std::optional<double> edge =
        elements < fewest ? std::nullopt : edge_of(bound, k, elements);
    runs.push_back({first, i, edge.value_or(0.0), edge.has_value()});
  }
}

/// The run's neighbour in the next row: the overlapping run with the closest leading edge.
double edge_beside(const GridRuns::Row& row, const Run& run) {
  double edge = run.beyond_border;
  int nearest = -1;
  for (const Run& other : row) {
    const int distance = std::abs(other.last - run.last);
    if (!other.has_edge || other.last < run.first || other.first > run.last) continue;
    if (nearest >= 0 && distance >= nearest) continue;
    nearest = distance;
    edge = other.beyond_border;
  }
  return edge;
}

/// A shift of the edge that alternates from row to row needs only a fraction G of the correction of
/// a straight edge: G = 0.52, 0.61, 0.74, 0.88 for elements of dy/dx = 0.33, 1, 2, 5, from the
/// local problem of alternating rows. A weight 1/4 (1 - G) of the second difference across rows
/// leaves straight edges unchanged and reduces alternating ones to G.
double smoothing_across_rows(const ContactGrid& grid) {
  return 0.25 * 0.49 / (1.0 + 0.25 * std::pow(grid.dy / grid.dx, 1.6));
}

/// D of the differences d_i that a first-order D gives.
Field weighted(const ContactGrid& grid, const Field& differences, const Field& weights) {
  Field result(differences.size());
  for_each_element(grid.size() - 1, [&](Eigen::Index k) {
    result[k] = differences[k] + weights[k] * (differences[k] - differences[k + 1]);
  });
  for (int j = 1; j <= grid.ny; ++j) result[j * grid.nx - 1] = differences[j * grid.nx - 1];
  return result;
}

}  // namespace

void GridRuns::find(const ContactGrid& grid, const Field& bound) {
  runs_.clear();
  ends_.assign(1, 0);
  runs_.reserve(2 * static_cast<std::size_t>(grid.ny));
  ends_.reserve(static_cast<std::size_t>(grid.ny) + 1);
  for (int j = 0; j < grid.ny; ++j) {
    add_runs_of_row(grid, bound, j, runs_);
    ends_.push_back(runs_.size());
  }
}

GridRuns::Row GridRuns::of_row(int j) const {
  if (j < 0 || j + 1 >= static_cast<int>(ends_.size())) return {};
  const auto row = static_cast<std::size_t>(j);
  return {runs_.data() + ends_[row], runs_.data() + ends_[row + 1]};
}

double leading_weight(double beyond_border) {
  // Least-squares fit of the local problem's weights at 13 positions, to 5e-4: a line of elements
  // in adhesion under uniform creepage, 400 elements, edge from a fit of p^2 x at 20 to 80
  // elements.
  const double e = std::clamp(beyond_border, -farthest, farthest);
  return usual_weight -
         (0.202677 + e * (1.024325 + e * (-0.379957 + e * (0.156733 - e * 0.059435))));
}

Field upwind_weights(const ContactGrid& grid, const Field& pressure) {
  Field weights;
  GridRuns runs;
  set_upwind_weights(grid, pressure, runs, weights);
  return weights;
}

void set_upwind_weights(const ContactGrid& grid, const Field& pressure, GridRuns& runs,
                        Field& weights) {
  weights.setConstant(grid.size(), usual_weight);
  runs.find(grid, pressure);
  const double smoothing = smoothing_across_rows(grid);
  for (int j = 0; j < grid.ny; ++j) {
    for (const Run& run : runs.of_row(j)) {
      if (!run.has_edge) continue;
      const double below = edge_beside(runs.of_row(j - 1), run);
      const double above = edge_beside(runs.of_row(j + 1), run);
      const double edge = run.beyond_border + smoothing * (below - 2.0 * run.beyond_border + above);
      weights[grid.index(run.last, j)] = leading_weight(edge);
    }
  }
}

Field leading_edges(const ContactGrid& grid, const Field& pressure) {
  GridRuns all;
  all.find(grid, pressure);
  Field edges = Field::Zero(grid.size());
  for (int j = 0; j < grid.ny; ++j)
    for (const Run& run : all.of_row(j)) edges[grid.index(run.last, j)] = run.beyond_border;
  return edges;
}

/// With the weight kappa the steps q of the traction of c D p = s are q_1 = s dx/(c (1 + kappa))
/// and 3/2 q_{n+1} - 1/2 q_n = s dx/c behind it: p_n tends to (n + 3/2 (q_1 - 1)) s dx/c, which is
/// to be (n - 1/2 + e) s dx/c with the edge e beyond the border.
double layer_weight(double weight) {
  const auto too_heavy = [weight](double edge) { return leading_weight(edge) - weight; };
  const double edge =
      bracketed_root(too_heavy, -farthest, farthest, 0.0, "weight of the leading element");
  return 1.5 / (1.0 + edge) - 1.0;
}

TangentialField fitted_difference(const ContactGrid& grid, const TangentialField& displacement,
                                  const Field& weights) {
  const TangentialField d = upwind_difference(grid, displacement, UpwindOrder::first);
  return {weighted(grid, d.x, weights), weighted(grid, d.y, weights)};
}

EdgeFittedRolling::EdgeFittedRolling(const TangentialOperator& first,
                                     const TangentialOperator& second, Field weights)
    : first_(first), second_(second), weights_(std::move(weights)) {
  if (first.layer() == 0.0) return;
  of_layer_ = Field::Zero(weights_.size());
  for (Eigen::Index k = 0; k < weights_.size(); ++k)
    if (weights_[k] != usual_weight)
      of_layer_[k] = first.layer() * (layer_weight(weights_[k]) - weights_[k]);
}

TangentialField EdgeFittedRolling::apply(const TangentialField& traction) const {
  const TangentialField d = first_.apply(traction);
  TangentialField slip{weighted(grid(), d.x, weights_), weighted(grid(), d.y, weights_)};
  if (of_layer_.size() == 0) return slip;
  const TangentialField steps = upwind_difference(grid(), traction, UpwindOrder::first);
  for (int k = 0; k + 1 < grid().size(); ++k) {
    slip.x[k] += of_layer_[k] * (steps.x[k] - steps.x[k + 1]);
    slip.y[k] += of_layer_[k] * (steps.y[k] - steps.y[k + 1]);
  }
  return slip;
}

TangentialField EdgeFittedRolling::precondition(const TangentialField& residual, double r,
                                                double shift) const {
  return second_.precondition(residual, r, shift);
}

}  // namespace rollfem::contact
