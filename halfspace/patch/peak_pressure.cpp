// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/patch/peak_pressure.hpp"

#include "base/pi.hpp"
#include "halfspace/elasticity/influence.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;

namespace {

constexpr int finer = 4;
constexpr double row_tolerance = 1e-4;  ///< relative to the approach
/// Fraction of the largest pressure. Rows with less pressure are only partly covered, which would
/// distort their ratio.
constexpr double least_part = 0.3;
/// Error bar as fractions of the pressure and of the change by the fine rows, from S1002 on 60E1 at
/// shifts of -3 to 8 mm against 64 elements across
/// (unit.CInterface.TheLargestPressureIsWithinItsBar).
constexpr double least_bar = 0.015, part_of_change = 0.75;

/// Effective distance in rows: the displacement there equals the mean over a row `rows` rows away,
/// for a deflection logarithmic in the distance.
double mean_distance(int rows) {
  if (rows == 0) return 0.5 * std::exp(-1.0);
  const double above = rows + 0.5, below = rows - 0.5;
  return std::exp(above * std::log(above) - below * std::log(below) - 1.0);
}

}  // namespace

double turn_of(const contact::ChartedGeometry& geometry, const ContactGrid& grid,
               const Field& pressure) {
  double least = contact::infinity, largest = -contact::infinity;
  for (int j = 0; j < grid.ny; ++j) {
    if (!(pressure.segment(grid.index(0, j), grid.nx).maxCoeff() > 0.0)) continue;
    const double angle = std::atan(geometry.climb(grid.y(j)));
    least = std::min(least, angle);
    largest = std::max(largest, angle);
  }
  return largest - least;
}

PeakPressure::Peak PeakPressure::of(const contact::ChartedGeometry& geometry,
                                    const ContactGrid& grid, const Field& pressure) {
  sum_ = 0.0;
  double force = 0.0, moment = 0.0, lengths = 0.0;
  for (int j = 0; j < grid.ny; ++j) {
    const auto row = pressure.segment(grid.index(0, j), grid.nx);
    const double largest = row.maxCoeff();
    if (!(largest > 0.0)) continue;
    sum_ += largest * grid.dy;
    for (int i = 0; i < grid.nx; ++i) moment += row[i] * grid.x(i);
    force += row.sum();
    lengths += row.sum() * 2.0 / contact::pi * row.sum() * grid.dx / largest;
  }
  half_ = lengths / force;
  const double x = moment / force, width = grid.dy / finer;
  const double y_first = grid.y_first - 0.5 * (finer - 1) * width;
  solve(coarse_, geometry, {1, grid.ny, grid.dx, grid.dy, x, grid.y_first});
  solve(fine_, geometry, {1, finer * grid.ny, grid.dx, width, x, y_first});
  const double of_elements = pressure.maxCoeff(), between = between_rows(grid, pressure);
  const double change = std::abs(between - of_elements);
  // Rows of equal length do not represent a conformal patch.
  const bool conformal = turn_of(geometry, grid, pressure) > most_turn;
  if (conformal) return {of_elements, least_bar * of_elements + change};
  return {between, least_bar * between + part_of_change * change};
}

double PeakPressure::between_rows(const ContactGrid& grid, const Field& pressure) const {
  const Field &coarse = coarse_.solver.pressure(), &fine = fine_.solver.pressure();
  const double least = least_part * coarse.maxCoeff();
  double peak = 0.0;
  for (int j = 0; j < grid.ny; ++j) {
    if (!(coarse[j] > least)) continue;
    const double of_row = pressure.segment(grid.index(0, j), grid.nx).maxCoeff();
    peak = std::max(peak, of_row * fine.segment(finer * j, finer).maxCoeff() / coarse[j]);
  }
  return peak;
}

void PeakPressure::solve(Rows& rows, const contact::ChartedGeometry& geometry,
                         const ContactGrid& line) {
  const int n = line.ny;
  geometry.undeformed_distance(line, rows.distance);
  rows.influence.resize(n, n);
  const double factor = line.dy / (contact::pi * modulus_);
  for (int beside = 0; beside < n; ++beside) {
    const double displacement = factor * row_deflection(mean_distance(beside) * line.dy / half_);
    rows.influence.diagonal(beside).setConstant(displacement);
    rows.influence.diagonal(-beside).setConstant(displacement);
  }
  static const Field none;
  contact::NormalOptions options;
  options.tolerance = row_tolerance;
  rows.solver.solve_sum(rows, rows.distance, sum_ / line.dy, options, none);
}

}  // namespace rollfem::halfspace
