// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/elasticity/circulant.hpp"

#include "base/pi.hpp"
#include "base/threads.hpp"

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

/// The preconditioners work on a plane padded only slightly beyond the grid: they are approximate
/// anyway, and a quarter of the padded size takes a quarter of the time.
int preconditioner_size(int n) {
  return n + n / 4;
}

/// D A transports upstream effects with the material. On a periodic line they re-enter at the
/// leading edge; in terms of exp(x) p instead of p they have decayed by this power of e by then.
/// Iteration counts are the same between 2 and 4.
constexpr double decay_over_period = 3.0;

/// Index of an offset between -p/2 and p/2 on a periodic line of p.
Eigen::Index periodic_index(int offset, int p) {
  return offset < 0 ? offset + p : offset;
}

/// One coefficient on the periodic plane. An odd one vanishes on the middle line of an even period,
/// where the sign is ambiguous (no product uses those offsets).
Field periodic_kernel(const InfluenceQuadrant& quadrant, double Influence::*part, bool odd_x,
                      bool odd_y, const PaddedFft& plane) {
  const int px = plane.px(), py = plane.py();
  Field kernel(static_cast<Eigen::Index>(px) * py);
  const auto rows = [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    for (int j = static_cast<int>(first); j < last; ++j)
      for (int i = 0; 2 * i <= px; ++i) {
        const bool ambiguous = (odd_x && 2 * i == px) || (odd_y && 2 * j == py);
        const double value = ambiguous ? 0.0 : quadrant.at(i, j).*part;
        for (const int sy : {1, -1})
          for (const int sx : {1, -1})
            kernel[periodic_index(sy * j, py) * px + periodic_index(sx * i, px)] =
                (odd_x ? sx : 1) * (odd_y ? sy : 1) * value;
      }
  };
  contact::for_each_piece(py / 2 + 1, plane.piece(py / 2 + 1), rows);
  return kernel;
}

}  // namespace

std::array<int, 2> circulant_size(const ContactGrid& grid) {
  return {good_fft_size(preconditioner_size(grid.nx)), good_fft_size(preconditioner_size(grid.ny))};
}

InfluenceQuadrant::InfluenceQuadrant(const ContactGrid& grid, const CombinedMaterial& material,
                                     int nx, int ny)
    : columns_(static_cast<std::size_t>(nx) + 1),
      coefficients_(columns_ * (static_cast<std::size_t>(ny) + 1)) {
  constexpr int values_of_a_piece = 5000;  // 0.5 ms
  contact::for_each_piece(ny + 1, 1 + values_of_a_piece / (nx + 1), [&](auto first, auto last) {
    for (auto j = first; j < last; ++j)
      for (int i = 0; i <= nx; ++i)
        coefficients_[static_cast<std::size_t>(j) * columns_ + static_cast<std::size_t>(i)] =
            element_influence(grid, i, static_cast<int>(j), material);
  });
  // A layer between the bodies moves an element by its own traction alone.
  coefficients_.front().xx += material.layer;
  coefficients_.front().yy += material.layer;
}

Symbol symbol_of(const InfluenceQuadrant& quadrant, double Influence::*part, int px, int py) {
  const bool xy = part == &Influence::xy, xn = part == &Influence::xn, yn = part == &Influence::yn;
  const PaddedFft plane(px, py, px, py);
  PaddedFft::Spectrum spectrum;
  plane.forward(periodic_kernel(quadrant, part, xy || xn, xy || yn, plane), spectrum);
  Symbol symbol(spectrum.size());
  plane.over_spectrum([&](std::ptrdiff_t first, std::ptrdiff_t last) {
    std::transform(spectrum.begin() + first, spectrum.begin() + last, symbol.begin() + first,
                   [imaginary = xn || yn](const Complex& value) {
                     return imaginary ? value.imag() : value.real();
                   });
  });
  return symbol;
}

Symbols tangential_symbols(const InfluenceQuadrant& quadrant, int px, int py) {
  Symbols symbols;
  symbols.xx = symbol_of(quadrant, &Influence::xx, px, py);
  symbols.yy = symbol_of(quadrant, &Influence::yy, px, py);
  symbols.xy = symbol_of(quadrant, &Influence::xy, px, py);
  return symbols;
}

void multiply(const PaddedFft& fft, const Symbol& symbol, PaddedFft::Spectrum& spectrum) {
  fft.over_spectrum([&](std::ptrdiff_t first, std::ptrdiff_t last) {
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); ++k)
      spectrum[k] *= symbol[k];
  });
}

std::vector<Complex> difference_symbol(Difference difference, int px, double dx, double decay) {
  const double left = std::exp(-decay / px);
  std::vector<Complex> factors(static_cast<std::size_t>(px / 2 + 1), Complex(1.0));
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const Complex e = std::polar(left, 2.0 * contact::pi * static_cast<double>(k) / px);
    if (difference == Difference::first) factors[k] = (1.0 - e) / dx;
    if (difference == Difference::second) factors[k] = (3.0 - 4.0 * e + e * e) / (2.0 * dx);
  }
  return factors;
}

NormalCirculant::NormalCirculant(const ContactGrid& grid, const InfluenceQuadrant& quadrant)
    : fft_(grid.nx, grid.ny, circulant_size(grid)[0], circulant_size(grid)[1]),
      inverse_(symbol_of(quadrant, &Influence::nn, fft_.px(), fft_.py())) {
  // The true symbol, ~1/|k|, is positive; truncating the kernel at the period may make the smallest
  // values negative.
  const double floor =
      1e-3 * *std::max_element(inverse_.begin(), inverse_.end()) / std::max(fft_.px(), fft_.py());
  for (double& value : inverse_) value = 1.0 / std::max(value, floor);
}

void NormalCirculant::apply(const Field& residual, Field& result) const {
  const auto spectrum = fft_.spectrum();
  fft_.forward(residual, *spectrum);
  multiply(fft_, inverse_, *spectrum);
  fft_.backward(*spectrum, result);
}

TangentialCirculant::TangentialCirculant(const ContactGrid& grid, const InfluenceQuadrant& quadrant,
                                         Difference difference)
    : nx_(grid.nx),
      ny_(grid.ny),
      fft_(grid.nx, grid.ny, circulant_size(grid)[0], circulant_size(grid)[1]),
      symbols_(tangential_symbols(quadrant, fft_.px(), fft_.py())) {
  const double decay = difference == Difference::none ? 0.0 : decay_over_period;
  factors_ = difference_symbol(difference, fft_.px(), grid.dx, decay);
  growth_.resize(nx_);
  for (int i = 0; i < nx_; ++i) growth_[i] = std::exp(decay * (i - 0.5 * nx_) / fft_.px());
}

/// The real part of d is not negative and the symbol of A_tt positive: the blocks are regular for
/// shift > 0.
TangentialCirculant::Inverse TangentialCirculant::inverted(double r, double shift) const {
  Inverse inverse{r, shift, {}, {}, {}};
  const std::size_t size = symbols_.xx.size();
  inverse.xx.resize(size);
  inverse.xy.resize(size);
  inverse.yy.resize(size);
  const std::size_t py = static_cast<std::size_t>(fft_.py());
  fft_.over_spectrum([&](std::ptrdiff_t first, std::ptrdiff_t last) {
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); ++k) {
      const Complex factor = r * factors_[k / py];
      const Complex xx = factor * symbols_.xx[k] + shift;
      const Complex yy = factor * symbols_.yy[k] + shift;
      const Complex xy = factor * symbols_.xy[k];
      const Complex determinant = multiply(xx, yy) - multiply(xy, xy);
      const Complex inverse_determinant = std::conj(determinant) / std::norm(determinant);
      inverse.xx[k] = multiply(yy, inverse_determinant);
      inverse.yy[k] = multiply(xx, inverse_determinant);
      inverse.xy[k] = -multiply(xy, inverse_determinant);
    }
  });
  return inverse;
}

/// Keeps the blocks of the adhering and of the slipping elements of every thread.
std::shared_ptr<const TangentialCirculant::Inverse> TangentialCirculant::inverse(
    double r, double shift) const {
  const auto most_inverses = static_cast<std::size_t>(1 + contact::threads());
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto known = std::find_if(inverses_.begin(), inverses_.end(), [&](const auto& inverse) {
    return inverse->r == r && inverse->shift == shift;
  });
  if (known != inverses_.end()) {
    std::rotate(known, known + 1, inverses_.end());
  } else {
    if (inverses_.size() >= most_inverses) inverses_.erase(inverses_.begin());
    inverses_.push_back(std::make_shared<const Inverse>(inverted(r, shift)));
  }
  return inverses_.back();
}

TangentialField TangentialCirculant::apply(const TangentialField& residual, double r,
                                           double shift) const {
  const std::shared_ptr<const Inverse> block = inverse(r, shift);
  TangentialField result = residual;
  const auto over_rows = [&](const auto& change) {
    contact::for_each_piece(ny_, fft_.piece(ny_), [&](std::ptrdiff_t first, std::ptrdiff_t last) {
      for (std::ptrdiff_t j = first; j < last; ++j)
        for (Field* field : {&result.x, &result.y}) change(field->segment(j * nx_, nx_).array());
    });
  };
  over_rows([&](auto row) { row *= growth_.array(); });
  const auto x_spectrum = fft_.spectrum(), y_spectrum = fft_.spectrum();
  fft_.forward(result, *x_spectrum, *y_spectrum);
  fft_.over_spectrum([&](std::ptrdiff_t first, std::ptrdiff_t last) {
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); ++k) {
      const Complex x = (*x_spectrum)[k];
      const Complex y = (*y_spectrum)[k];
      (*x_spectrum)[k] = multiply(block->xx[k], x) + multiply(block->xy[k], y);
      (*y_spectrum)[k] = multiply(block->xy[k], x) + multiply(block->yy[k], y);
    }
  });
  fft_.backward(*x_spectrum, *y_spectrum, result);
  over_rows([&](auto row) { row /= growth_.array(); });
  return result;
}

}  // namespace rollfem::halfspace
