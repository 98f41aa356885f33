// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/elasticity/halfspace_compliance.hpp"

#include "base/threads.hpp"
#include "halfspace/elasticity/circulant.hpp"
#include "halfspace/elasticity/fft.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <mutex>
#include <utility>
#include <vector>

namespace rollfem::halfspace {

using contact::CombinedMaterial;
using contact::ContactGrid;
using contact::Field;
using contact::SurfaceField;
using contact::TangentialField;
using contact::UpwindOrder;

namespace {

using Complex = std::complex<double>;
using Spectrum = PaddedFft::Spectrum;

/// A product of symbol and spectrum at one frequency, for kernels that are odd under (x, y) -> (-x,
/// -y).
Complex odd_product(double symbol, const Complex& value) {
  return {-symbol * value.imag(), symbol * value.real()};
}

class HalfspaceNormal : public contact::NormalOperator {
 public:
  HalfspaceNormal(const ContactGrid& grid, const PaddedFft& fft, const Symbol& nn,
                  const InfluenceQuadrant& quadrant)
      : grid_(grid), fft_(fft), nn_(nn), inverse_(grid, quadrant) {}

  const ContactGrid& grid() const override { return grid_; }

  void apply(const Field& pressure, Field& displacement) const override {
    const auto spectrum = fft_.spectrum();
    fft_.forward(pressure, *spectrum);
    multiply(fft_, nn_, *spectrum);
    fft_.backward(*spectrum, displacement);
  }

  void precondition(const Field& residual, Field& result) const override {
    inverse_.apply(residual, result);
  }

 private:
  const ContactGrid& grid_;
  const PaddedFft& fft_;
  const Symbol& nn_;
  NormalCirculant inverse_;
};

/// T = A_tt or D A_tt. D acts along x only and is exact on the padded plane: a factor per k_x.
class HalfspaceTangential : public contact::TangentialOperator {
 public:
  HalfspaceTangential(const ContactGrid& grid, const PaddedFft& fft, const Symbols& symbols,
                      Difference difference, double diagonal, double layer,
                      const InfluenceQuadrant& quadrant)
      : grid_(grid),
        fft_(fft),
        symbols_(symbols),
        factors_(difference_symbol(difference, fft.px(), grid.dx)),
        diagonal_(diagonal),
        layer_(layer),
        quadrant_(quadrant),
        difference_(difference) {}

  const ContactGrid& grid() const override { return grid_; }
  double diagonal() const override { return diagonal_; }
  double layer() const override { return layer_; }

  TangentialField apply(const TangentialField& traction) const override {
    const auto x = fft_.spectrum(), y = fft_.spectrum();
    fft_.forward(traction, *x, *y);
    const auto size = static_cast<std::ptrdiff_t>(factors_.size());
    contact::for_each_piece(size, fft_.piece(size), [&](std::ptrdiff_t first, std::ptrdiff_t last) {
      multiply_columns(static_cast<std::size_t>(first), static_cast<std::size_t>(last), *x, *y);
    });
    TangentialField result;
    fft_.backward(*x, *y, result);
    return result;
  }

  TangentialField precondition(const TangentialField& residual, double r,
                               double shift) const override {
    std::call_once(inverse_made_, [this] {
      inverse_ = std::make_unique<TangentialCirculant>(grid_, quadrant_, difference_);
    });
    return inverse_->apply(residual, r, shift);
  }

 private:
  void multiply_columns(std::size_t first, std::size_t last, Spectrum& x_spectrum,
                        Spectrum& y_spectrum) const {
    const std::size_t py = static_cast<std::size_t>(fft_.py());
    for (std::size_t kx = first; kx < last; ++kx) {
      const Complex factor = factors_[kx];
      for (std::size_t k = kx * py; k < (kx + 1) * py; ++k) {
        const Complex x = x_spectrum[k];
        const Complex y = y_spectrum[k];
        x_spectrum[k] = multiply(factor, symbols_.xx[k] * x + symbols_.xy[k] * y);
        y_spectrum[k] = multiply(factor, symbols_.xy[k] * x + symbols_.yy[k] * y);
      }
    }
  }

  const ContactGrid& grid_;
  const PaddedFft& fft_;
  const Symbols& symbols_;
  std::vector<Complex> factors_;
  double diagonal_;
  double layer_;
  const InfluenceQuadrant& quadrant_;
  Difference difference_;
  mutable std::once_flag inverse_made_;
  mutable std::unique_ptr<TangentialCirculant> inverse_;  ///< created at first use
};

/// Mean diagonal entry of D A_tt (or A_tt): the element's own influence coefficients.
double mean_diagonal(const ContactGrid& grid, const InfluenceQuadrant& quadrant,
                     Difference difference) {
  const auto coefficient = [&](int offset) {
    const Influence& a = quadrant.at(offset, 0);
    return 0.5 * (a.xx + a.yy);
  };
  // (D A) at element i takes u at i, i+1, i+2: offsets 0, 1, 2 from the loaded element i.
  switch (difference) {
    case Difference::first:
      return (coefficient(0) - coefficient(1)) / grid.dx;
    case Difference::second:
      return (3.0 * coefficient(0) - 4.0 * coefficient(1) + coefficient(2)) / (2.0 * grid.dx);
    case Difference::none:
      break;
  }
  return coefficient(0);
}

}  // namespace

/// Symbols are created at first use: a search for the patch needs only the symbol of the pressure.
/// Callers hold the mutex; a symbol that exists does not change.
struct HalfspaceCompliance::Implementation {
  ContactGrid grid;
  bool couples;
  double layer;
  // Displacements are wanted up to two columns upstream of the grid, for D: 2 nx + 3 keeps the
  // images apart and the kernels even.
  PaddedFft fft;
  InfluenceQuadrant quadrant;
  mutable std::mutex mutex;
  mutable Symbols symbols;
  mutable std::unique_ptr<HalfspaceNormal> normal;
  mutable std::unique_ptr<HalfspaceTangential> tangential[3];

  Implementation(const ContactGrid& g, const CombinedMaterial& material)
      : grid(g),
        couples(material.difference != 0.0),
        layer(material.layer),
        fft(g.nx, g.ny, 2 * g.nx + 3, g.is_line() ? 1 : 2 * g.ny),
        quadrant(g, material, std::max(fft.px(), circulant_size(g)[0]) / 2,
                 std::max(fft.py(), circulant_size(g)[1]) / 2) {}

  /// The symbol of an influence coefficient.
  const Symbol& symbol(Symbol Symbols::*kept, double Influence::*part) const {
    if ((symbols.*kept).empty()) symbols.*kept = symbol_of(quadrant, part, fft.px(), fft.py());
    return symbols.*kept;
  }

  const Symbol& normal_symbol() const { return symbol(&Symbols::nn, &Influence::nn); }

  const Symbols& tangential_symbols() const {
    symbol(&Symbols::xx, &Influence::xx);
    symbol(&Symbols::yy, &Influence::yy);
    symbol(&Symbols::xy, &Influence::xy);
    return symbols;
  }

  const Symbols& all_symbols() const {
    const std::lock_guard<std::mutex> lock(mutex);
    normal_symbol();
    if (couples) {
      symbol(&Symbols::xn, &Influence::xn);
      symbol(&Symbols::yn, &Influence::yn);
    }
    return tangential_symbols();
  }

  const HalfspaceTangential& tangential_operator(Difference difference) const {
    const std::lock_guard<std::mutex> lock(mutex);
    auto& kept = tangential[static_cast<int>(difference)];
    if (!kept)
      kept = std::make_unique<HalfspaceTangential>(grid, fft, tangential_symbols(), difference,
                                                   mean_diagonal(grid, quadrant, difference), layer,
                                                   quadrant);
    return *kept;
  }
};

HalfspaceCompliance::HalfspaceCompliance(const ContactGrid& grid, const CombinedMaterial& material)
    : implementation_(std::make_unique<Implementation>(grid, material)) {}

HalfspaceCompliance::~HalfspaceCompliance() = default;

const ContactGrid& HalfspaceCompliance::grid() const {
  return implementation_->grid;
}

SurfaceField HalfspaceCompliance::apply(const SurfaceField& traction) const {
  const Implementation& own = *implementation_;
  const PaddedFft& fft = own.fft;
  const Symbols& symbols = own.all_symbols();
  const auto x_spectrum = fft.spectrum(), y_spectrum = fft.spectrum(), n_spectrum = fft.spectrum();
  const std::array<const Field*, 3> given{&traction.x, &traction.y, &traction.n};
  SurfaceField displacement;
  const std::array<Field*, 3> found{&displacement.x, &displacement.y, &displacement.n};
  const std::array<Spectrum*, 3> spectra{x_spectrum.get(), y_spectrum.get(), n_spectrum.get()};
  const auto each = [&](const auto& transform) {
    contact::for_each_piece(3, fft.piece(3), [&](std::ptrdiff_t first, std::ptrdiff_t last) {
      for (auto c = static_cast<std::size_t>(first); c < static_cast<std::size_t>(last); ++c)
        transform(c);
    });
  };
  each([&](std::size_t c) { fft.forward(*given[c], *spectra[c]); });
  fft.over_spectrum([&](std::ptrdiff_t first, std::ptrdiff_t last) {
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); ++k) {
      Complex &at_x = (*spectra[0])[k], &at_y = (*spectra[1])[k], &at_n = (*spectra[2])[k];
      const Complex x = at_x, y = at_y, n = at_n;
      at_x = symbols.xx[k] * x + symbols.xy[k] * y;
      at_y = symbols.xy[k] * x + symbols.yy[k] * y;
      at_n = symbols.nn[k] * n;
      if (!own.couples) continue;
      at_x += odd_product(symbols.xn[k], n);
      at_y += odd_product(symbols.yn[k], n);
      at_n += odd_product(-symbols.xn[k], x);
      at_n += odd_product(-symbols.yn[k], y);
    }
  });
  each([&](std::size_t c) { fft.backward(*spectra[c], *found[c]); });
  return displacement;
}

const contact::NormalOperator& HalfspaceCompliance::normal() const {
  const Implementation& own = *implementation_;
  const std::lock_guard<std::mutex> lock(own.mutex);
  if (!own.normal)
    own.normal =
        std::make_unique<HalfspaceNormal>(own.grid, own.fft, own.normal_symbol(), own.quadrant);
  return *own.normal;
}

const contact::TangentialOperator& HalfspaceCompliance::shift() const {
  return implementation_->tangential_operator(Difference::none);
}

const contact::TangentialOperator& HalfspaceCompliance::rolling(UpwindOrder order) const {
  return implementation_->tangential_operator(order == UpwindOrder::first ? Difference::first
                                                                          : Difference::second);
}

}  // namespace rollfem::halfspace
