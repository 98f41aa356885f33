// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/stress/subsurface.hpp"

#include "base/errors.hpp"
#include "base/grid.hpp"
#include "base/pi.hpp"
#include "base/threads.hpp"
#include "halfspace/elasticity/fft.hpp"
#include "halfspace/stress/cell_stress.hpp"
#include "scene/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace rollfem::halfspace {

namespace {

using contact::pi;

// The two ways to sum the fields of all contact elements (subsurface.hpp chooses): directly, and by
// Fourier transform on a lattice. In the local frame of cell_stress.hpp.

/// Loads on the surface of one half-space in its local frame, with the constants of its material.
struct LocalProblem {
  contact::ContactGrid grid;
  std::array<contact::Field, 3> loads;  ///< MPa, along x, y, z
  double shear_modulus = 0.0;
  double poisson_ratio = 0.0;
};

/// Sums over the loaded elements of one problem at any point.
class DirectSum {
 public:
  /// Keeps a reference to the problem.
  explicit DirectSum(const LocalProblem& problem);
  explicit DirectSum(LocalProblem&&) = delete;
  LocalState at(double x, double y, double z) const;
  /// Elements in the smallest rectangle that contains all loads.
  long elements() const;

 private:
  using Loads = Eigen::Array<double, potential_count, 3>;
  Loads near_sum(double x, double y, double z) const;
  Loads far_sum(double x, double y, double z) const;

  const LocalProblem& problem_;
  int i_first_ = 0, i_last_ = -1, j_first_ = 0, j_last_ = -1;
};

/// Convolution on a lattice with the spacing of the contact grid, layer by layer: the spectra of
/// the loads and the plans are kept.
class LayerConvolution {
 public:
  /// Keeps a reference to the problem.
  LayerConvolution(const LocalProblem& problem, const contact::ContactGrid& points);
  LayerConvolution(LocalProblem&&, const contact::ContactGrid&) = delete;
  /// One state per point of the lattice.
  std::vector<LocalState> at(double z) const;

 private:
  std::vector<Potentials> corners(double z) const;
  void transform_kernels(double z) const;

  const LocalProblem& problem_;
  contact::ContactGrid points_;
  PaddedFft loads_fft_;
  PaddedFft kernel_fft_;
  PaddedFft points_fft_;
  std::array<PaddedFft::Spectrum, 3> loads_;
  mutable std::array<PaddedFft::Spectrum, potential_count> kernels_;
};

/// Up to this many times the longer side of an element from the farthest loaded one, differences of
/// corner functions are used throughout: the stress is then exact to about 1e-15 of the traction.
constexpr double corner_range = 300.0;

/// Unit of a component of assemble_state.
double unit_of(std::size_t component, double shear_modulus) {
  return component < s_xx ? 1.0 / (4.0 * pi * shear_modulus) : 1.0 / (2.0 * pi);
}

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

contact::Field sized(const contact::Field& field, const contact::ContactGrid& grid,
                     const char* name) {
  if (field.size() == 0) return contact::Field::Zero(grid.size());
  if (field.size() != grid.size())
    throw contact::InputError(
        fmt::format("traction.{} has {} values for a contact grid of {} by {}; allowed: one per "
                    "element, or none",
                    name, field.size(), grid.nx, grid.ny));
  if (!field.allFinite())
    throw contact::InputError(fmt::format("traction.{} is not finite everywhere", name));
  return field;
}

void check_spacing(const contact::ContactGrid& grid, const char* name) {
  if (grid.nx < 1 || grid.ny < 1 || !(grid.dx > 0.0 && grid.dy > 0.0))
    throw contact::InputError(
        fmt::format("{} of {} by {} points {} by {} mm apart; allowed: at least 1 by 1, spacing "
                    "positive",
                    name, grid.nx, grid.ny, grid.dx, grid.dy));
}

/// The rail is the mirror image of the wheel in z = 0: with the opposite tractions the pressure
/// stays a pressure and the tangential tractions change sign, as do u_z, xz, yz in the result.
double mirror(const LoadedBody& body) {
  return body.body == Body::wheel ? 1.0 : -1.0;
}

LocalProblem local_problem(const LoadedBody& body) {
  check_spacing(body.grid, "contact grid");
  LocalProblem problem{body.grid,
                       {mirror(body) * sized(body.traction.x, body.grid, "x"),
                        mirror(body) * sized(body.traction.y, body.grid, "y"),
                        sized(body.traction.n, body.grid, "n")},
                       contact::shear_modulus(body.material),
                       body.material.poisson_ratio};
  check_half_space(0.0, problem.shear_modulus, problem.poisson_ratio);
  return problem;
}

SubsurfaceState global_state(const LocalState& local, double odd) {
  SubsurfaceState state;
  state.displacement = {local[u_x], local[u_y], odd * local[u_z]};
  state.stress = {local[s_xx], local[s_yy],       local[s_zz],
                  local[s_xy], odd * local[s_yz], odd * local[s_xz]};
  return state;
}

bool same_spacing(const contact::ContactGrid& grid, const contact::ContactGrid& points) {
  const auto same = [](double a, double b, int count) {
    return count == 1 || std::abs(a - b) * count < 1e-9 * a;
  };
  return same(grid.dx, points.dx, points.nx) && same(grid.dy, points.dy, points.ny);
}

/// Costs in corner functions: the direct sum needs one per point and element, a layer of the
/// convolution one per offset, and its transforms cost about four times as much in addition
/// (measured).
bool fft_is_cheaper(const LocalProblem& problem, const contact::ContactGrid& points,
                    long loaded_elements) {
  const double offsets = static_cast<double>(problem.grid.nx + points.nx) *
                         static_cast<double>(problem.grid.ny + points.ny);
  return 5.0 * offsets < static_cast<double>(points.size()) * static_cast<double>(loaded_elements);
}

/// On several threads where the sums are long.
void for_each_point(const DirectSum& sum, std::size_t count,
                    const std::function<void(std::size_t)>& work) {
  constexpr long corners_of_a_piece = 10000;  // 1 ms
  const std::ptrdiff_t piece = 1 + corners_of_a_piece / std::max(1L, sum.elements());
  contact::for_each_piece(static_cast<std::ptrdiff_t>(count), piece, [&](auto first, auto end) {
    for (auto k = first; k < end; ++k) work(static_cast<std::size_t>(k));
  });
}

}  // namespace

std::vector<SubsurfaceState> subsurface_at(const LoadedBody& body,
                                           const std::vector<SubsurfacePoint>& points) {
  const LocalProblem problem = local_problem(body);
  const DirectSum sum(problem);
  for (const SubsurfacePoint& point : points)
    check_half_space(point.depth, problem.shear_modulus, problem.poisson_ratio);
  std::vector<SubsurfaceState> states(points.size());
  for_each_point(sum, points.size(), [&](std::size_t k) {
    states[k] = global_state(sum.at(points[k].x, points[k].y, points[k].depth), mirror(body));
  });
  return states;
}

std::vector<SubsurfaceLayer> subsurface_box(const LoadedBody& body,
                                            const contact::ContactGrid& points,
                                            const std::vector<double>& depths,
                                            Summation summation) {
  const LocalProblem problem = local_problem(body);
  check_spacing(points, "lattice");
  for (const double depth : depths)
    check_half_space(depth, problem.shear_modulus, problem.poisson_ratio);
  const bool possible = !body.grid.is_line() && same_spacing(body.grid, points);
  if (summation == Summation::fft && !possible)
    throw contact::InputError(fmt::format(
        "lattice spacing {} by {} mm; allowed for summation by FFT: that of the contact grid, {} "
        "by {} mm; use another spacing or direct summation",
        points.dx, points.dy, body.grid.dx, body.grid.dy));
  const DirectSum sum(problem);
  const bool by_fft =
      summation == Summation::fft || (summation == Summation::automatic && possible &&
                                      fft_is_cheaper(problem, points, sum.elements()));
  std::optional<LayerConvolution> convolution;
  if (by_fft) convolution.emplace(problem, points);
  std::vector<SubsurfaceLayer> layers;
  for (const double depth : depths) {
    std::vector<SubsurfaceState> states(static_cast<std::size_t>(points.size()));
    std::vector<LocalState> local;
    if (convolution) local = convolution->at(depth);
    for_each_point(sum, states.size(), [&](std::size_t n) {
      const int k = static_cast<int>(n);
      states[n] = global_state(
          convolution ? local[n] : sum.at(points.x(k % points.nx), points.y(k / points.nx), depth),
          mirror(body));
    });
    layers.push_back({depth, std::move(states)});
  }
  return layers;
}

std::vector<SubsurfaceState> smooth_subsurface_at(const LoadedBody& body,
                                                  const std::vector<SubsurfacePoint>& points) {
  constexpr double on_surface = 1e-9;  // mm, rounding
  std::vector<SubsurfacePoint> all = points;
  const contact::ContactGrid& grid = body.grid;
  const auto cell = [](double at, double first, double step) {
    return std::floor((at - first) / step + 1e-9);
  };
  for (const SubsurfacePoint& at : points) {
    if (at.depth > on_surface) continue;
    for (const int b : {0, 1})
      for (const int a : {0, 1})
        all.push_back({grid.x_first + (cell(at.x, grid.x_first, grid.dx) + a) * grid.dx,
                       grid.y_first + (cell(at.y, grid.y_first, grid.dy) + b) * grid.dy, 0.0});
  }
  auto states = subsurface_at(body, all);
  std::size_t next = points.size();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const SubsurfacePoint& at = points[k];
    if (at.depth > on_surface) continue;
    contact::SymmetricTensor stress{};
    for (std::size_t corner = 0; corner < 4; ++corner, ++next) {
      const double weight = (1.0 - std::abs(at.x - all[next].x) / grid.dx) *
                            (1.0 - std::abs(at.y - all[next].y) / grid.dy);
      stress = contact::sum(stress, weight, states[next].stress);
    }
    states[k].stress = stress;
  }
  states.resize(points.size());
  return states;
}

std::vector<std::array<double, 3>> subsurface_points(const contact::SubsurfaceRequest& request) {
  std::vector<std::array<double, 3>> points;
  const auto share = [](int k, int count) {
    return count > 1 ? static_cast<double>(k) / (count - 1) : 0.0;
  };
  for (int j = 0; j < request.points[1]; ++j)
    for (int i = 0; i < request.points[0]; ++i) {
      std::array<double, 3> point = request.from;
      for (int c = 0; c < 3; ++c) {
        point[c] += share(i, request.points[0]) * (request.to[c] - request.from[c]);
        if (request.points[1] > 1)
          point[c] += share(j, request.points[1]) * (request.across[c] - request.from[c]);
      }
      if (request.kind == contact::SubsurfaceRequest::Kind::surface)
        point[2] = request.wheel ? request.depth : 0.0 - request.depth;
      points.push_back(point);
    }
  return points;
}

std::vector<contact::SubsurfaceField> subsurface_fields(const contact::Scene& scene,
                                                        const contact::ContactGrid& grid,
                                                        const contact::SurfaceField& traction) {
  std::vector<contact::SubsurfaceField> fields;
  for (const contact::SubsurfaceRequest& request : scene.subsurface) {
    contact::SubsurfaceField field;
    field.request = request;
    field.points = subsurface_points(request);
    std::vector<SubsurfacePoint> points;
    for (const auto& point : field.points)
      points.push_back({point[0], point[1], request.wheel ? point[2] : 0.0 - point[2]});
    const LoadedBody body{request.wheel ? Body::wheel : Body::rail,
                          request.wheel ? scene.wheel.material : scene.rail.material, grid,
                          traction};
    for (const SubsurfaceState& state : subsurface_at(body, points)) {
      field.displacement.push_back(state.displacement);
      field.stress.push_back(state.stress);
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

}  // namespace rollfem::halfspace
