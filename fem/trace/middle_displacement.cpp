// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/trace/middle_displacement.hpp"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

namespace rollfem::fem {

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
