// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/trace/middle_displacement.hpp"

#include "halfspace/elasticity/influence.hpp"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rollfem::fem {

namespace {

using contact::CombinedMaterial;
using contact::ContactGrid;
using contact::Field;
using halfspace::PaddedFft;
using halfspace::Symbol;
using Spectrum = PaddedFft::Spectrum;

ElementResponse at_point(double x, double y, const ContactGrid& grid,
                         const CombinedMaterial& material) {
  const halfspace::Influence a = halfspace::rectangle_influence(x, y, grid.dx, grid.dy, material);
  return {a.xx, a.yy, a.xy, a.nn};
}

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
  add(1.0, at_point(i * grid.dx, j * grid.dy, grid, material), result);
  for (unsigned int b = 0; b < rule.size(); ++b)
    for (unsigned int a = 0; a < rule.size(); ++a)
      add(-rule.weight(a) * rule.weight(b),
          at_point((i - 0.5 + rule.point(a)[0]) * grid.dx, (j - 0.5 + rule.point(b)[0]) * grid.dy,
                   grid, material),
          result);
  return result;
}

/// For offsets from 0 on, index j * nx + i.
std::vector<ElementResponse> quadrant(const ContactGrid& grid, const contact::Material& material,
                                      const std::optional<Lattice>& lattice) {
  constexpr contact::Material rigid{contact::infinity};
  const CombinedMaterial alone = contact::combine(material, rigid);
  std::vector<ElementResponse> kernel;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) kernel.push_back(middle_less_mean(i, j, grid, alone));
  if (!lattice) return kernel;
  const std::vector<ElementResponse> deficit = lattice_deficit(*lattice);
  for (int j = 0; j < std::min(grid.ny, lattice_reach + 1); ++j)
    for (int i = 0; i < std::min(grid.nx, lattice_reach + 1); ++i)
      add(1.0, deficit[static_cast<std::size_t>(j * (lattice_reach + 1) + i)],
          kernel[static_cast<std::size_t>(grid.index(i, j))]);
  return kernel;
}

/// Transform of the periodic kernel, which is even under (x, y) -> (-x, -y); `odd`: odd in x and in
/// y.
Symbol symbol_of(const PaddedFft& plane, const ContactGrid& grid,
                 const std::vector<ElementResponse>& quadrant, double ElementResponse::*component,
                 bool odd = false) {
  const int px = plane.px();
  const int py = plane.py();
  Field kernel = Field::Zero(static_cast<Eigen::Index>(px) * py);
  for (int j = 1 - grid.ny; j < grid.ny; ++j)
    for (int i = 1 - grid.nx; i < grid.nx; ++i) {
      const double sign = odd && (i < 0) != (j < 0) ? -1.0 : 1.0;
      const auto at = static_cast<std::size_t>(grid.index(std::abs(i), std::abs(j)));
      kernel[((j + py) % py) * px + (i + px) % px] = sign * quadrant[at].*component;
    }
  Spectrum spectrum;
  PaddedFft(px, py, px, py).forward(kernel, spectrum);
  Symbol symbol;
  for (const auto& value : spectrum) symbol.push_back(value.real());
  return symbol;
}

}  // namespace

MiddleDisplacement::MiddleDisplacement(const ContactGrid& grid, const contact::Material& material,
                                       const Field& stretch, const std::optional<Lattice>& lattice)
    : fft_(grid.nx, grid.ny, 2 * grid.nx, 2 * grid.ny),
      root_stretch_(stretch.size() == 0 ? Field(Field::Ones(grid.size()))
                                        : Field(stretch.cwiseSqrt())) {
  const std::vector<ElementResponse> kernel = quadrant(grid, material, lattice);
  symbols_.xx = symbol_of(fft_, grid, kernel, &ElementResponse::xx);
  symbols_.yy = symbol_of(fft_, grid, kernel, &ElementResponse::yy);
  symbols_.xy = symbol_of(fft_, grid, kernel, &ElementResponse::xy, true);
  symbols_.nn = symbol_of(fft_, grid, kernel, &ElementResponse::nn);
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
