// Fourier symbols of the influence coefficients on a periodic plane, and their inverses frequency
// by frequency: the preconditioners of the contact solvers.
#pragma once

#include "contact/scene/geometry.hpp"
#include "contact/solve/compliance.hpp"
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

/// Factor of D for kx = 0 .. px/2: (1 - e)/dx or (3 - 4 e + e^2)/(2 dx) with e = exp(2 pi i kx/px).
std::vector<std::complex<double>> difference_symbol(Difference difference, int px, double dx);

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

/// Approximation of (r T + shift I)^-1, T = D A_tt or A_tt.
class TangentialCirculant {
 public:
  TangentialCirculant(const contact::ContactGrid& grid, const contact::CombinedMaterial& material,
                      Difference difference);
  contact::TangentialField apply(const contact::TangentialField& residual, double r,
                                 double shift) const;

 private:
  void invert(double r, double shift) const;

  PaddedFft fft_;
  Symbols symbols_;
  std::vector<std::complex<double>> factors_;
  mutable double r_ = -1.0;
  mutable double shift_ = -1.0;
  mutable PaddedFft::Spectrum inverse_xx_, inverse_xy_, inverse_yy_;
  mutable PaddedFft::Spectrum x_, y_;
};

}  // namespace rollfem::halfspace
