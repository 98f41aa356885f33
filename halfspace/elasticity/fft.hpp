// SPDX-License-Identifier: LGPL-2.1-or-later
// Two-dimensional real Fourier transforms of fields on a contact grid, zero-padded so that products
// of spectra are convolutions on the infinite plane. FFTW plans are made once for each size and
// kept in the process.
#pragma once

#include "base/grid.hpp"
#include "base/spares.hpp"

#include <boost/align/aligned_allocator.hpp>

#include <complex>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace rollfem::halfspace {

/// The smallest even 2^a 3^b 5^c 7^d that is at least `n`: sizes for which FFTW is fast.
int good_fft_size(int n);

/// Transforms between a field of nx by ny values and the spectrum of the padded field. The
/// transform of a real field is stored for the frequencies kx = 0 .. px/2, index kx * py + ky.
/// Several threads may use an object at once. Large transforms are cut into pieces for several
/// threads.
class PaddedFft {
 public:
  /// Aligned for FFTW, so that spectra are transformed without copies.
  using Spectrum = std::vector<std::complex<double>,
                               boost::alignment::aligned_allocator<std::complex<double>, 64>>;

  /// Fields of nx by ny, padded to at least `px` by `py` (rounded up to fast sizes).
  PaddedFft(int nx, int ny, int px, int py);
  ~PaddedFft();
  PaddedFft(const PaddedFft&) = delete;
  PaddedFft& operator=(const PaddedFft&) = delete;

  int px() const { return px_; }
  int py() const { return py_; }
  int frequencies_x() const { return px_ / 2 + 1; }
  int spectrum_size() const { return frequencies_x() * py_; }

  /// A spectrum to work in, the caller's own until it goes out of scope.
  auto spectrum() const { return spectra_.borrow(); }

  void forward(const contact::Field& field, Spectrum& spectrum) const;
  /// The nx by ny window of the inverse transform, normalised.
  void backward(const Spectrum& spectrum, contact::Field& field) const;

  /// Both components, side by side if they are large.
  void forward(const contact::TangentialField& field, Spectrum& x, Spectrum& y) const;
  void backward(const Spectrum& x, const Spectrum& y, contact::TangentialField& field) const;

  /// The pieces in which work on `size` things should go to threads, `of` at a time at least: all
  /// at once where a transform is too short for that. Depends on the sizes alone.
  std::ptrdiff_t piece(std::ptrdiff_t size, std::ptrdiff_t of = 1) const;
  /// Pieces of the indices of a spectrum.
  void over_spectrum(
      const std::function<void(std::ptrdiff_t first, std::ptrdiff_t last)>& work) const;

 private:
  struct Plans;
  void rows_forward(const contact::Field& field, std::ptrdiff_t first, std::ptrdiff_t last,
                    Spectrum& columns) const;
  void rows_backward(const Spectrum& columns, std::ptrdiff_t first, std::ptrdiff_t last,
                     contact::Field& field) const;

  int nx_;
  int ny_;
  int px_;
  int py_;
  std::unique_ptr<Plans> plans_;
  contact::Spares<Spectrum> spectra_;
};

}  // namespace rollfem::halfspace
