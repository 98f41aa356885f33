// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/stress/subsurface_sum.hpp"

#include "contact/base/pi.hpp"
#include "contact/base/threads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollfem::halfspace {

namespace {

using contact::pi;

/// Up to this many times the longer side of an element from the farthest loaded one, differences of
/// corner functions are used throughout: the stress is then exact to about 1e-15 of the traction.
constexpr double corner_range = 300.0;

/// Of a component of assemble_state.
double unit_of(std::size_t component, double shear_modulus) {
  return component < s_xx ? 1.0 / (4.0 * pi * shear_modulus) : 1.0 / (2.0 * pi);
}

}  // namespace

DirectSum::DirectSum(const LocalProblem& problem) : problem_(problem) {
  const contact::ContactGrid& grid = problem.grid;
  i_first_ = grid.nx;
  j_first_ = grid.ny;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const int k = grid.index(i, j);
      if (std::all_of(problem.loads.begin(), problem.loads.end(),
                      [k](const contact::Field& load) { return load[k] == 0.0; }))
        continue;
      i_first_ = std::min(i_first_, i);
      i_last_ = std::max(i_last_, i);
      j_first_ = std::min(j_first_, j);
      j_last_ = std::max(j_last_, j);
    }
}

long DirectSum::elements() const {
  return static_cast<long>(std::max(0, i_last_ - i_first_ + 1)) *
         std::max(0, j_last_ - j_first_ + 1);
}

/// Each corner function is evaluated once; a corner's weight is the mixed difference of the loads
/// of the (up to) four elements that meet there. In a line contact edges take their place.
DirectSum::Loads DirectSum::near_sum(double x, double y, double z) const {
  const contact::ContactGrid& grid = problem_.grid;
  const double length = grid.longer_side();
  Loads sum = Loads::Zero();
  const auto jump = [&](const contact::Field& load, int i, int j) {
    const auto value = [&](int m, int n) {
      const bool inside = m >= i_first_ && m <= i_last_ && n >= j_first_ && n <= j_last_;
      return inside ? load[grid.index(m, n)] : 0.0;
    };
    return value(i, j) - value(i - 1, j) - value(i, j - 1) + value(i - 1, j - 1);
  };
  const bool line = grid.is_line(), finite = std::isinf(grid.line_reference);
  const double reference = (finite ? grid.dy : grid.line_reference) / length;
  for (int j = j_first_; j <= (line ? j_first_ : j_last_ + 1); ++j)
    for (int i = i_first_; i <= i_last_ + 1; ++i) {
      Eigen::Array3d weight;
      for (std::size_t c = 0; c < 3; ++c) weight[c] = jump(problem_.loads[c], i, j);
      if ((weight == 0.0).all()) continue;
      const double X = (x - grid.x(i) + 0.5 * grid.dx) / length;
      const double Y = (y - grid.y(j) + 0.5 * grid.dy) / length;
      const Potentials corner = line ? edge_potentials(X, z / length, reference, finite)
                                     : corner_potentials(X, Y, z / length);
      for (int c = 0; c < 3; ++c) sum.col(c) += weight[c] * corner;
    }
  sum.topRows<first_dimensionless>() *= length;
  return sum;
}

DirectSum::Loads DirectSum::far_sum(double x, double y, double z) const {
  const contact::ContactGrid& grid = problem_.grid;
  Loads sum = Loads::Zero();
  for (int j = j_first_; j <= j_last_; ++j)
    for (int i = i_first_; i <= i_last_; ++i) {
      const int k = grid.index(i, j);
      const Potentials element =
          rectangle_potentials(x - grid.x(i), y - grid.y(j), z, grid.dx, grid.dy);
      for (std::size_t c = 0; c < 3; ++c) sum.col(c) += problem_.loads[c][k] * element;
    }
  return sum;
}

LocalState DirectSum::at(double x, double y, double z) const {
  if (i_last_ < i_first_) return LocalState{};
  const contact::ContactGrid& grid = problem_.grid;
  const double reach_x = std::max(std::abs(x - grid.x(i_first_)), std::abs(x - grid.x(i_last_)));
  const double reach_y = std::max(std::abs(y - grid.y(j_first_)), std::abs(y - grid.y(j_last_)));
  const bool near = grid.is_line() ||
                    std::hypot(std::hypot(reach_x, reach_y), z) < corner_range * grid.longer_side();
  const Loads sum = near ? near_sum(x, y, z) : far_sum(x, y, z);
  LocalState state = assemble_state(sum.col(0).data(), sum.col(1).data(), sum.col(2).data(),
                                    problem_.poisson_ratio, z);
  for (std::size_t c = 0; c < component_count; ++c) state[c] *= unit_of(c, problem_.shear_modulus);
  return state;
}

LayerConvolution::LayerConvolution(const LocalProblem& problem, const contact::ContactGrid& points)
    : problem_(problem),
      points_(points),
      loads_fft_(problem.grid.nx, problem.grid.ny, problem.grid.nx + points.nx - 1,
                 problem.grid.ny + points.ny - 1),
      kernel_fft_(loads_fft_.px(), loads_fft_.py(), loads_fft_.px(), loads_fft_.py()),
      points_fft_(points.nx, points.ny, loads_fft_.px(), loads_fft_.py()) {
  for (std::size_t c = 0; c < 3; ++c) loads_fft_.forward(problem.loads[c], loads_[c]);
}

/// Corner functions at all differences of a lattice point and an element corner: (mx + 1) columns
/// by (my + 1) rows, mx = nx of elements + nx of points - 1.
std::vector<Potentials> LayerConvolution::corners(double z) const {
  const contact::ContactGrid& grid = problem_.grid;
  const double length = grid.longer_side();
  const int columns = grid.nx + points_.nx;
  const int rows = grid.ny + points_.ny;
  std::vector<Potentials> table(static_cast<std::size_t>(columns) * rows);
  constexpr int corners_of_a_piece = 10000;  // 1 ms
  const auto row = [&](std::ptrdiff_t j) {
    for (int i = 0; i < columns; ++i) {
      const double x = points_.x_first - grid.x_first + (i - grid.nx + 0.5) * grid.dx;
      const double y =
          points_.y_first - grid.y_first + (static_cast<double>(j) - grid.ny + 0.5) * grid.dy;
      table[static_cast<std::size_t>(j) * columns + i] =
          corner_potentials(x / length, y / length, z / length);
    }
  };
  contact::for_each_piece(rows, 1 + corners_of_a_piece / columns, [&](auto first, auto end) {
    for (auto j = first; j < end; ++j) row(j);
  });
  return table;
}

void LayerConvolution::transform_kernels(double z) const {
  const contact::ContactGrid& grid = problem_.grid;
  const double length = grid.longer_side();
  const std::vector<Potentials> table = corners(z);
  const int columns = grid.nx + points_.nx;
  const int px = kernel_fft_.px();
  const int py = kernel_fft_.py();
  contact::Field kernel(static_cast<Eigen::Index>(px) * py);
  for (int potential = 0; potential < potential_count; ++potential) {
    const double unit = potential < first_dimensionless ? length : 1.0;
    kernel.setZero();
    for (int j = 0; j < grid.ny + points_.ny - 1; ++j)
      for (int i = 0; i < columns - 1; ++i) {
        const std::size_t k = static_cast<std::size_t>(j) * columns + i;
        const double value = table[k + columns + 1][potential] - table[k + columns][potential] -
                             table[k + 1][potential] + table[k][potential];
        // Point minus element, in cells of the lattice, laid out periodically.
        const int m = (i - (grid.nx - 1) + px) % px;
        const int n = (j - (grid.ny - 1) + py) % py;
        kernel[static_cast<Eigen::Index>(n) * px + m] = unit * value;
      }
    kernel_fft_.forward(kernel, kernels_[static_cast<std::size_t>(potential)]);
  }
}

std::vector<LocalState> LayerConvolution::at(double z) const {
  using Complex = std::complex<double>;
  transform_kernels(z);
  const std::size_t frequencies = loads_[0].size();
  std::array<PaddedFft::Spectrum, component_count> spectra;
  for (PaddedFft::Spectrum& spectrum : spectra) spectrum.resize(frequencies);
  using ComplexPotentials = Eigen::Array<Complex, potential_count, 1>;
  const auto add = [&](std::size_t f) {
    ComplexPotentials source;
    for (int potential = 0; potential < potential_count; ++potential)
      source[potential] = kernels_[static_cast<std::size_t>(potential)][f];
    const ComplexPotentials p_x = source * loads_[0][f];
    const ComplexPotentials p_y = source * loads_[1][f];
    const ComplexPotentials p_z = source * loads_[2][f];
    const std::array<Complex, component_count> state =
        assemble_state(p_x.data(), p_y.data(), p_z.data(), problem_.poisson_ratio, z);
    for (std::size_t c = 0; c < component_count; ++c) spectra[c][f] = state[c];
  };
  const auto size = static_cast<std::ptrdiff_t>(frequencies);
  contact::for_each_piece(size, points_fft_.piece(size), [&](auto first, auto end) {
    for (auto f = first; f < end; ++f) add(static_cast<std::size_t>(f));
  });
  std::vector<LocalState> states(static_cast<std::size_t>(points_.size()));
  contact::Field field;
  for (std::size_t c = 0; c < component_count; ++c) {
    points_fft_.backward(spectra[c], field);
    for (std::size_t k = 0; k < states.size(); ++k)
      states[k][c] = unit_of(c, problem_.shear_modulus) * field[static_cast<Eigen::Index>(k)];
  }
  return states;
}

}  // namespace rollfem::halfspace
