// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/trace/middle_displacement.hpp"

#include "base/pi.hpp"
#include "base/threads.hpp"
#include "fem/discretisation/elasticity_assembly.hpp"

#include <Eigen/Dense>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <utility>

namespace rollfem::fem {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::Matrix3cd;
using Eigen::MatrixXcd;

/// Number of waves along each side, at midpoints of [0, pi]; the kernel is the mean over them and
/// reaches a third of their period.
constexpr int waves = 12;

/// Layers of cells, 2^8 of cubes: the longest wave has decayed to 1e-20 there.
constexpr int doublings_of_cubes = 8;

/// One column of cells under a contact element, its sides joined with the phase of a wave.
class Column {
 public:
  explicit Column(const Lattice& lattice)
      : lattice_(lattice), element_(dealii::FE_Q<3>(lattice.degree), 3) {
    const auto& h = lattice.cell_size;
    dealii::Triangulation<3> cell;
    dealii::GridGenerator::hyper_rectangle(cell, {0.0, 0.0, 0.0}, {h[0], h[1], h[2]});
    dealii::DoFHandler<3> dofs(cell);
    dofs.distribute_dofs(element_);
    const dealii::MappingQ<3> mapping(1);
    dealii::AffineConstraints<double> none;
    none.close();
    stiffness_ =
        CellStiffness({dofs, mapping, none, {}, lattice.material}).compute(dofs.begin_active());
    const dealii::QGauss<2> rule(static_cast<unsigned int>(lattice.degree + 1));
    for (unsigned int d = 0; d < element_.dofs_per_cell; ++d) {
      const dealii::Point<3> place = element_.unit_support_point(d);
      Unknown unknown{static_cast<int>(element_.system_to_component_index(d).first), {}, 0.0};
      for (unsigned int k = 0; k < 3; ++k)
        unknown.step[k] = static_cast<int>(std::lround(place[k] * lattice.degree));
      for (unsigned int q = 0; q < rule.size() && unknown.step[2] == 0; ++q)
        unknown.mean += rule.weight(q) *
                        element_.shape_value(d, {rule.point(q)[0], rule.point(q)[1], 0.0}) /
                        (lattice.cells * lattice.cells);
      unknowns_.push_back(unknown);
    }
  }

  /// Mean displacement of a contact element under a wave of unit tractions whose phase grows by
  /// `along_x` and `along_y` from element to element.
  Matrix3cd response(double along_x, double along_y) const {
    const int period = lattice_.cells * lattice_.degree;
    const Index n = 3 * static_cast<Index>(period) * period;
    MatrixXcd layer = MatrixXcd::Zero((lattice_.degree + 1) * n, (lattice_.degree + 1) * n);
    MatrixXcd mean = MatrixXcd::Zero(3, n);
    for (int column = 0; column < lattice_.cells * lattice_.cells; ++column)
      add_cell(column % lattice_.cells, column / lattice_.cells,
               {std::polar(1.0, along_x), std::polar(1.0, along_y)}, layer, mean);
    const double area = std::pow(lattice_.cells, 2) * lattice_.cell_size[0] * lattice_.cell_size[1];
    return area * mean * surface_stiffness(layer, n).ldlt().solve(mean.adjoint());
  }

 private:
  struct Unknown {
    int component;
    std::array<int, 3> step;  ///< relative position in the cell; third: 0 at the surface
    double mean;              ///< weight in the mean over the contact element
  };

  void add_cell(int cell_x, int cell_y, const std::array<Complex, 2>& wave, MatrixXcd& layer,
                MatrixXcd& mean) const {
    const int period = lattice_.cells * lattice_.degree;
    std::vector<Index> place;
    std::vector<Complex> phase;
    for (const Unknown& u : unknowns_) {
      const int x = cell_x * lattice_.degree + u.step[0];
      const int y = cell_y * lattice_.degree + u.step[1];
      phase.push_back((x == period ? wave[0] : 1.0) * (y == period ? wave[1] : 1.0));
      const Index node =
          (static_cast<Index>(u.step[2]) * period + y % period) * period + x % period;
      place.push_back(3 * node + u.component);
      if (u.step[2] == 0) mean(u.component, place.back()) += u.mean * phase.back();
    }
    const std::size_t count = unknowns_.size();
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t b = 0; b < count; ++b)
        layer(place[a], place[b]) += std::conj(phase[a]) * stiffness_[a * count + b] * phase[b];
  }

  /// Stiffness of the upper nodes of all layers, with the lowest nodes fixed: nodes in between are
  /// eliminated, and two equal stacks form the next one.
  MatrixXcd surface_stiffness(const MatrixXcd& layer, Index n) const {
    const Index inner = layer.rows() - 2 * n;
    const Index low = layer.rows() - n;
    MatrixXcd top = layer.topLeftCorner(n, n);
    MatrixXcd coupling = layer.block(0, low, n, n);
    MatrixXcd bottom = layer.block(low, low, n, n);
    if (inner > 0) {
      const auto to_top = layer.block(0, n, n, inner);
      const auto to_bottom = layer.block(low, n, n, inner);
      const auto within = layer.block(n, n, inner, inner).eval().ldlt();
      const MatrixXcd from_top = within.solve(to_top.adjoint());
      const MatrixXcd from_bottom = within.solve(to_bottom.adjoint());
      top -= to_top * from_top;
      coupling -= to_top * from_bottom;
      bottom -= to_bottom * from_bottom;
    }
    const double flat = lattice_.cell_size[0] / lattice_.cell_size[2];
    const int doublings =
        doublings_of_cubes + static_cast<int>(std::ceil(std::max(0.0, std::log2(flat))));
    for (int k = 0; k < doublings; ++k) {
      const auto between = (bottom + top).eval().ldlt();
      const MatrixXcd from_above = between.solve(coupling.adjoint());
      const MatrixXcd from_below = between.solve(coupling);
      top -= coupling * from_above;
      bottom -= coupling.adjoint() * from_below;
      coupling = (-coupling * from_below).eval();
    }
    return top;
  }

  Lattice lattice_;
  dealii::FESystem<3> element_;
  std::vector<double> stiffness_;
  std::vector<Unknown> unknowns_;
};

/// The same for the half-space (Cerruti and Boussinesq in wave numbers: 1/(G k) times 1 - nu k_x^2
/// / k^2, 1 - nu k_y^2/k^2, -nu k_x k_y/k^2 and 1 - nu): the wave on the elements is a sum of
/// waves, each with the same factor in the mean as in the load.
ElementResponse halfspace_response(const Lattice& lattice, double along_x, double along_y) {
  constexpr int shorter = 60;
  // A longer phase by whole periods leaves the sine as it is.
  const double sines = std::pow(std::sin(0.5 * along_x) * std::sin(0.5 * along_y), 2);
  const double nu = lattice.material.poisson_ratio;
  const double shear_modulus = contact::shear_modulus(lattice.material);
  const double element_x = lattice.cells * lattice.cell_size[0];
  const double element_y = lattice.cells * lattice.cell_size[1];
  ElementResponse sum;
  for (int n = -shorter; n <= shorter; ++n)
    for (int m = -shorter; m <= shorter; ++m) {
      const double x = along_x + 2.0 * contact::pi * m;
      const double y = along_y + 2.0 * contact::pi * n;
      const double kx = x / element_x;
      const double ky = y / element_y;
      const double square = kx * kx + ky * ky;
      const double weight = 16.0 * sines / (x * x * y * y * shear_modulus * std::sqrt(square));
      sum.xx += weight * (1.0 - nu * kx * kx / square);
      sum.yy += weight * (1.0 - nu * ky * ky / square);
      sum.xy -= weight * nu * kx * ky / square;
      sum.nn += weight * (1.0 - nu);
    }
  return sum;
}

}  // namespace

std::vector<ElementResponse> lattice_deficit(const Lattice& lattice) {
  const Column column(lattice);
  const auto along = [](int wave) { return contact::pi * (wave + 0.5) / waves; };
  std::vector<ElementResponse> less(static_cast<std::size_t>(waves) *
                                    waves);  // of finite elements than of the half-space
  contact::for_each_index(less.size(), [&](std::size_t k) {
    const double x = along(static_cast<int>(k) % waves), y = along(static_cast<int>(k) / waves);
    const ElementResponse half = halfspace_response(lattice, x, y);
    const Matrix3cd fe = column.response(x, y);
    less[k].xx = half.xx - fe(0, 0).real();
    less[k].yy = half.yy - fe(1, 1).real();
    less[k].nn = half.nn - fe(2, 2).real();
    less[k].xy = half.xy - fe(0, 1).real();
  });
  constexpr int side = lattice_reach + 1;
  std::vector<ElementResponse> deficit(static_cast<std::size_t>(side) * side);
  for (std::size_t k = 0; k < less.size(); ++k) {
    const double x = along(static_cast<int>(k) % waves), y = along(static_cast<int>(k) / waves);
    constexpr double share = 1.0 / (waves * waves);
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        ElementResponse& at = deficit[static_cast<std::size_t>(j) * side + i];
        const double even = share * std::cos(i * x) * std::cos(j * y);
        const double odd = -share * std::sin(i * x) * std::sin(j * y);
        at.xx += even * less[k].xx;
        at.yy += even * less[k].yy;
        at.nn += even * less[k].nn;
        at.xy += odd * less[k].xy;
      }
  }
  return deficit;
}

namespace {

using contact::CombinedMaterial;
using contact::ContactGrid;
using contact::Field;
using halfspace::InfluenceQuadrant;
using halfspace::PaddedFft;
using Spectrum = PaddedFft::Spectrum;

void add(double factor, const ElementResponse& what, ElementResponse& sum) {
  sum.xx += factor * what.xx;
  sum.yy += factor * what.yy;
  sum.xy += factor * what.xy;
  sum.nn += factor * what.nn;
}

/// The half-space's displacement in the middle of element (i, j) from the loaded one, less its mean
/// over it. Its slope has a logarithmic singularity at the loaded element's border.
ElementResponse middle_less_mean(int i, int j, const ContactGrid& grid,
                                 const CombinedMaterial& material) {
  const int distance = std::max(std::abs(i), std::abs(j));
  const dealii::QGauss<1> rule(distance < 2 ? 16 : distance < lattice_reach ? 4 : 2);
  ElementResponse result;
  const auto at = [&](double x, double y) {
    return halfspace::rectangle_influence(x, y, grid.dx, grid.dy, material);
  };
  add(1.0, at(i * grid.dx, j * grid.dy), result);
  for (unsigned int b = 0; b < rule.size(); ++b)
    for (unsigned int a = 0; a < rule.size(); ++a)
      add(-rule.weight(a) * rule.weight(b),
          at((i - 0.5 + rule.point(a)[0]) * grid.dx, (j - 0.5 + rule.point(b)[0]) * grid.dy),
          result);
  return result;
}

/// For offsets of up to half a period; zero beyond the grid.
InfluenceQuadrant quadrant(const ContactGrid& grid, const PaddedFft& plane,
                           const contact::Material& material,
                           const std::optional<Lattice>& lattice) {
  const int nx = plane.px() / 2, ny = plane.py() / 2;
  const CombinedMaterial alone = contact::combine(material, contact::rigid_material());
  std::vector<ElementResponse> deficit;
  if (lattice) deficit = lattice_deficit(*lattice);
  std::vector<ElementResponse> kernel(static_cast<std::size_t>(nx + 1) * (ny + 1));
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      ElementResponse& at = kernel[static_cast<std::size_t>(j) * (nx + 1) + i];
      at = middle_less_mean(i, j, grid, alone);
      if (lattice && std::max(i, j) <= lattice_reach)
        add(1.0, deficit[static_cast<std::size_t>(j) * (lattice_reach + 1) + i], at);
    }
  return {nx, std::move(kernel)};
}

}  // namespace

MiddleDisplacement::MiddleDisplacement(const ContactGrid& grid, const contact::Material& material,
                                       const Field& stretch, const std::optional<Lattice>& lattice)
    : fft_(grid.nx, grid.ny, 2 * grid.nx, 2 * grid.ny),
      root_stretch_(stretch.size() == 0 ? Field(Field::Ones(grid.size()))
                                        : Field(stretch.cwiseSqrt())) {
  const InfluenceQuadrant kernel = quadrant(grid, fft_, material, lattice);
  symbols_ = halfspace::tangential_symbols(kernel, fft_.px(), fft_.py());
  symbols_.nn = halfspace::symbol_of(kernel, &halfspace::Influence::nn, fft_.px(), fft_.py());
}

void MiddleDisplacement::add(const contact::SurfaceField& traction,
                             contact::SurfaceField& displacement) const {
  Spectrum x, y, n;
  fft_.forward(traction.x.cwiseProduct(root_stretch_), x);
  fft_.forward(traction.y.cwiseProduct(root_stretch_), y);
  fft_.forward(traction.n.cwiseProduct(root_stretch_), n);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const auto on_x = x[k];
    x[k] = symbols_.xx[k] * on_x + symbols_.xy[k] * y[k];
    y[k] = symbols_.xy[k] * on_x + symbols_.yy[k] * y[k];
    n[k] *= symbols_.nn[k];
  }
  Field result;
  for (const auto& [spectrum, component] :
       {std::pair{&x, &displacement.x}, {&y, &displacement.y}, {&n, &displacement.n}}) {
    fft_.backward(*spectrum, result);
    *component += result.cwiseQuotient(root_stretch_);
  }
}

}  // namespace rollfem::fem
