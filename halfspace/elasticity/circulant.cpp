#include "halfspace/elasticity/circulant.hpp"

#include "halfspace/elasticity/influence.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rollfem::halfspace {

using contact::CombinedMaterial;
using contact::ContactGrid;
using contact::Field;
using contact::TangentialField;

namespace {

using Complex = std::complex<double>;

constexpr double two_pi = 6.28318530717958647692;

/// The preconditioners work on a plane that is padded only a little beyond the grid: they are
/// approximate anyway and a quarter of the padded size costs a quarter of the time.
int preconditioner_size(int n) {
  return n + n / 4;
}

/// Place of an offset between -p/2 and p/2 on a periodic line of p.
Eigen::Index periodic_index(int offset, int p) {
  return offset < 0 ? offset + p : offset;
}

struct Kernels {
  Field xx, yy, xy, nn, xn, yn;
};

/// All coefficients on the periodic plane, from one quadrant by symmetry. Odd kernels vanish on the
/// middle line of an even period, where the sign is ambiguous (no product uses those offsets).
Kernels periodic_kernels(const ContactGrid& grid, const CombinedMaterial& material, int px,
                         int py) {
  const Eigen::Index size = static_cast<Eigen::Index>(px) * py;
  Kernels kernels;
  for (Field* field :
       {&kernels.xx, &kernels.yy, &kernels.xy, &kernels.nn, &kernels.xn, &kernels.yn})
    field->setZero(size);
  for (int j = 0; 2 * j <= py; ++j)
    for (int i = 0; 2 * i <= px; ++i) {
      const Influence a = rectangle_influence(i * grid.dx, j * grid.dy, grid.dx, grid.dy, material);
      const bool middle_x = 2 * i == px;
      const bool middle_y = 2 * j == py;
      for (const int sy : {1, -1})
        for (const int sx : {1, -1}) {
          const Eigen::Index k = periodic_index(sy * j, py) * px + periodic_index(sx * i, px);
          kernels.xx[k] = a.xx;
          kernels.yy[k] = a.yy;
          kernels.nn[k] = a.nn;
          kernels.xy[k] = middle_x || middle_y ? 0.0 : sx * sy * a.xy;
          kernels.xn[k] = middle_x ? 0.0 : sx * a.xn;
          kernels.yn[k] = middle_y ? 0.0 : sy * a.yn;
        }
    }
  return kernels;
}

enum class Part { real, imaginary };

Symbol transform(const PaddedFft& fft, const Field& kernel, Part part) {
  PaddedFft::Spectrum spectrum;
  fft.forward(kernel, spectrum);
  Symbol symbol(spectrum.size());
  std::transform(spectrum.begin(), spectrum.end(), symbol.begin(), [part](const Complex& value) {
    return part == Part::real ? value.real() : value.imag();
  });
  return symbol;
}

}  // namespace

Symbols kernel_symbols(const ContactGrid& grid, const CombinedMaterial& material, int px, int py) {
  const Kernels kernels = periodic_kernels(grid, material, px, py);
  const PaddedFft fft(px, py, px, py);
  Symbols symbols;
  symbols.xx = transform(fft, kernels.xx, Part::real);
  symbols.yy = transform(fft, kernels.yy, Part::real);
  symbols.xy = transform(fft, kernels.xy, Part::real);
  symbols.nn = transform(fft, kernels.nn, Part::real);
  if (material.difference != 0.0) {
    symbols.xn = transform(fft, kernels.xn, Part::imaginary);
    symbols.yn = transform(fft, kernels.yn, Part::imaginary);
  }
  return symbols;
}

std::vector<Complex> difference_symbol(Difference difference, int px, double dx) {
  std::vector<Complex> factors(static_cast<std::size_t>(px / 2 + 1), Complex(1.0));
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const Complex e = std::polar(1.0, two_pi * static_cast<double>(k) / px);
    if (difference == Difference::first) factors[k] = (1.0 - e) / dx;
    if (difference == Difference::second) factors[k] = (3.0 - 4.0 * e + e * e) / (2.0 * dx);
  }
  return factors;
}

NormalCirculant::NormalCirculant(const ContactGrid& grid, const CombinedMaterial& material)
    : fft_(grid.nx, grid.ny, preconditioner_size(grid.nx), preconditioner_size(grid.ny)),
      inverse_(kernel_symbols(grid, material, fft_.px(), fft_.py()).nn) {
  // The true symbol, ~1/|k|, is positive; cutting the kernel off at the period may spoil that for
  // the smallest ones.
  const double floor =
      1e-3 * *std::max_element(inverse_.begin(), inverse_.end()) / std::max(fft_.px(), fft_.py());
  for (double& value : inverse_) value = 1.0 / std::max(value, floor);
}

Field NormalCirculant::apply(const Field& residual) const {
  fft_.forward(residual, spectrum_);
  for (std::size_t k = 0; k < spectrum_.size(); ++k) spectrum_[k] *= inverse_[k];
  Field result;
  fft_.backward(spectrum_, result);
  return result;
}

TangentialCirculant::TangentialCirculant(const ContactGrid& grid, const CombinedMaterial& material,
                                         Difference difference)
    : fft_(grid.nx, grid.ny, preconditioner_size(grid.nx), preconditioner_size(grid.ny)),
      symbols_(kernel_symbols(grid, material, fft_.px(), fft_.py())),
      factors_(difference_symbol(difference, fft_.px(), grid.dx)) {}

/// The 2x2 blocks (r d [xx xy; xy yy] + shift I)^-1, kept for the last r and shift. The real part
/// of d is not negative and the symbol of A_tt positive: the blocks are regular for shift > 0.
void TangentialCirculant::invert(double r, double shift) const {
  if (r == r_ && shift == shift_) return;
  const std::size_t size = symbols_.xx.size();
  inverse_xx_.resize(size);
  inverse_xy_.resize(size);
  inverse_yy_.resize(size);
  const std::size_t py = static_cast<std::size_t>(fft_.py());
  for (std::size_t k = 0; k < size; ++k) {
    const Complex factor = r * factors_[k / py];
    const Complex xx = factor * symbols_.xx[k] + shift;
    const Complex yy = factor * symbols_.yy[k] + shift;
    const Complex xy = factor * symbols_.xy[k];
    const Complex inverse_determinant = 1.0 / (xx * yy - xy * xy);
    inverse_xx_[k] = yy * inverse_determinant;
    inverse_yy_[k] = xx * inverse_determinant;
    inverse_xy_[k] = -xy * inverse_determinant;
  }
  r_ = r;
  shift_ = shift;
}

TangentialField TangentialCirculant::apply(const TangentialField& residual, double r,
                                           double shift) const {
  invert(r, shift);
  fft_.forward(residual.x, x_);
  fft_.forward(residual.y, y_);
  for (std::size_t k = 0; k < x_.size(); ++k) {
    const Complex x = x_[k];
    const Complex y = y_[k];
    x_[k] = multiply(inverse_xx_[k], x) + multiply(inverse_xy_[k], y);
    y_[k] = multiply(inverse_xy_[k], x) + multiply(inverse_yy_[k], y);
  }
  TangentialField result;
  fft_.backward(x_, result.x);
  fft_.backward(y_, result.y);
  return result;
}

}  // namespace rollfem::halfspace
