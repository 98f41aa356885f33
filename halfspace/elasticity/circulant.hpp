// Fourier symbols of the influence coefficients on a periodic plane, and their inverses frequency
// by frequency: the preconditioners of the contact solvers.
#pragma once

#include "contact/iteration/compliance.hpp"
#include "contact/scene/geometry.hpp"
#include "halfspace/elasticity/fft.hpp"

#include <complex>
#include <vector>

namespace rollfem::halfspace {

/// One value per frequency, index kx * py + ky as in PaddedFft.
using Symbol = std::vector<double>;

/// Symbols of the kernels. xx, yy, xy, nn are even under (x, y) -> (-x, -y): real. xn and yn are
/// odd: the symbol is i times what is kept here; empty for like materials.
struct Symbols {
  Symbol xx, yy, xy, nn, xn, yn;
};

/// Which difference along x stands in front of A_tt.
enum class Difference { none = 0, first = 1, second = 2 };

/// Transforms of the influence coefficients laid out periodically on px by py elements: a product
/// of spectra is exact for offsets below px/2 and py/2.
Symbols kernel_symbols(const contact::ContactGrid& grid, const contact::CombinedMaterial& material,
                       int px, int py);

/// Factor of D for kx = 0 .. px/2: (1 - e)/dx or (3 - 4 e + e^2)/(2 dx) with
/// e = exp((2 pi i kx - decay)/px); `decay`: D of exp(-decay x/(px dx)) u, over that exponential.
std::vector<std::complex<double>> difference_symbol(Difference difference, int px, double dx,
                                                    double decay = 0.0);

/// Product without the check for NaN that the standard operator makes.
inline std::complex<double> multiply(const std::complex<double>& a, const std::complex<double>& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// Symmetric positive definite approximation of A_nn^-1.
class NormalCirculant {
 public:
  NormalCirculant(const contact::ContactGrid& grid, const contact::CombinedMaterial& material);
  contact::Field apply(const contact::Field& residual) const;

 private:
  PaddedFft fft_;
  Symbol inverse_;
  mutable PaddedFft::Spectrum spectrum_;
};

/// Approximation of (r T + shift I)^-1, T = D A_tt or A_tt: for D A_tt a circulant of what is left
/// of it when everything decays downstream by the same factor from column to column, which is a
/// scaling of rows and columns of T.
class TangentialCirculant {
 public:
  TangentialCirculant(const contact::ContactGrid& grid, const contact::CombinedMaterial& material,
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
  const Inverse& inverse(double r, double shift) const;

  /// Those of the adhering and of the slipping elements.
  static constexpr std::size_t most_inverses = 2;

  int nx_;
  int ny_;
  PaddedFft fft_;
  Symbols symbols_;
  std::vector<std::complex<double>> factors_;
  contact::Field growth_;                  ///< of a column
  mutable std::vector<Inverse> inverses_;  ///< last used last
  mutable PaddedFft::Spectrum x_, y_;
};

}  // namespace rollfem::halfspace
