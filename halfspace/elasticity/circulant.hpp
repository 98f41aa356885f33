// SPDX-License-Identifier: LGPL-2.1-or-later
// Fourier symbols of the influence coefficients on a periodic plane, and their inverses frequency
// by frequency: the preconditioners of the contact solvers.
#pragma once

#include "contact/iteration/compliance.hpp"
#include "halfspace/elasticity/fft.hpp"
#include "halfspace/elasticity/influence.hpp"
#include "scene/geometry.hpp"

#include <array>
#include <complex>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace rollfem::halfspace {

/// One value per frequency, index kx * py + ky as in PaddedFft.
using Symbol = std::vector<double>;

/// Symbols of the kernels. xx, yy, xy, nn are even under (x, y) -> (-x, -y): real. xn and yn are
/// odd: the symbol is i times the stored values; empty for like materials.
struct Symbols {
  Symbol xx, yy, xy, nn, xn, yn;
};

/// Difference along x applied to A_tt.
enum class Difference { none = 0, first = 1, second = 2 };

/// Size of the periodic plane for the circulants of a grid.
std::array<int, 2> circulant_size(const contact::ContactGrid& grid);

/// Influence coefficients of a grid at offsets from none to nx columns and ny rows, from which the
/// others follow by symmetry; with a layer between the bodies.
class InfluenceQuadrant {
 public:
  InfluenceQuadrant(const contact::ContactGrid& grid, const contact::CombinedMaterial& material,
                    int nx, int ny);
  /// Given row after row.
  InfluenceQuadrant(int nx, std::vector<Influence> coefficients)
      : columns_(static_cast<std::size_t>(nx) + 1), coefficients_(std::move(coefficients)) {}
  const Influence& at(int i, int j) const {
    return coefficients_[static_cast<std::size_t>(j) * columns_ + static_cast<std::size_t>(i)];
  }

 private:
  std::size_t columns_;
  std::vector<Influence> coefficients_;
};

/// Transforms of the influence coefficients laid out periodically on px by py elements: a product
/// of spectra is exact for offsets below px/2 and py/2, the required extent of the quadrant.
Symbol symbol_of(const InfluenceQuadrant& quadrant, double Influence::*part, int px, int py);
/// xx, yy and xy.
Symbols tangential_symbols(const InfluenceQuadrant& quadrant, int px, int py);

/// Factor of D for kx = 0 .. px/2: (1 - e)/dx or (3 - 4 e + e^2)/(2 dx) with
/// e = exp((2 pi i kx - decay)/px); `decay`: D of exp(-decay x/(px dx)) u, over that exponential.
std::vector<std::complex<double>> difference_symbol(Difference difference, int px, double dx,
                                                    double decay = 0.0);

/// Product without the check for NaN that the standard operator makes.
inline std::complex<double> multiply(const std::complex<double>& a, const std::complex<double>& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// spectrum *= symbol.
void multiply(const PaddedFft& fft, const Symbol& symbol, PaddedFft::Spectrum& spectrum);

/// Symmetric positive definite approximation of A_nn^-1.
class NormalCirculant {
 public:
  NormalCirculant(const contact::ContactGrid& grid, const InfluenceQuadrant& quadrant);
  void apply(const contact::Field& residual, contact::Field& result) const;

 private:
  PaddedFft fft_;
  Symbol inverse_;
};

/// Approximation of (r T + shift I)^-1, T = D A_tt or A_tt: for D A_tt a circulant of T after
/// scaling its rows and columns so that everything decays downstream by the same factor from column
/// to column.
class TangentialCirculant {
 public:
  TangentialCirculant(const contact::ContactGrid& grid, const InfluenceQuadrant& quadrant,
                      Difference difference);
  contact::TangentialField apply(const contact::TangentialField& residual, double r,
                                 double shift) const;

 private:
  /// The 2x2 blocks (r d [xx xy; xy yy] + shift I)^-1.
  struct Inverse {
    double r;
    double shift;
    PaddedFft::Spectrum xx, xy, yy;
  };

  Inverse inverted(double r, double shift) const;
  std::shared_ptr<const Inverse> inverse(double r, double shift) const;

  int nx_;
  int ny_;
  PaddedFft fft_;
  Symbols symbols_;
  std::vector<std::complex<double>> factors_;
  contact::Field growth_;  ///< of a column
  mutable std::mutex mutex_;
  mutable std::vector<std::shared_ptr<const Inverse>> inverses_;  ///< most recently used last
};

}  // namespace rollfem::halfspace
