// Two-dimensional real Fourier transforms of fields on a contact grid, zero-padded so that products
// of spectra are convolutions on the infinite plane. FFTW plans are made once and kept.
#pragma once

#include "contact/base/grid.hpp"

#include <complex>
#include <memory>
#include <vector>

namespace rollfem::halfspace {

/// The smallest even 2^a 3^b 5^c 7^d that is at least `n`: sizes for which FFTW is fast.
int good_fft_size(int n);

/// fftw_malloc (throws std::bad_alloc) and fftw_free.
void* fft_allocate(std::size_t bytes);
void fft_free(void* memory);

/// Memory as FFTW wants it, so that spectra are transformed where they are.
template <typename T>
struct FftAllocator {
  using value_type = T;
  FftAllocator() = default;
  template <typename U>
  explicit FftAllocator(const FftAllocator<U>& /*other*/) {}
  T* allocate(std::size_t count) { return static_cast<T*>(fft_allocate(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t /*count*/) { fft_free(memory); }
  friend bool operator==(const FftAllocator&, const FftAllocator&) { return true; }
  friend bool operator!=(const FftAllocator&, const FftAllocator&) { return false; }
};

/// Transforms between a field of nx by ny values and the spectrum of the padded field. The
/// transform of a real field is kept for the frequencies kx = 0 .. px/2, index kx * py + ky.
/// forward() and backward() are const but share work space: one thread at a time per object. Large
/// transforms take a second thread.
class PaddedFft {
 public:
  using Spectrum = std::vector<std::complex<double>, FftAllocator<std::complex<double>>>;

  /// Fields of nx by ny, padded to at least `px` by `py` (made good sizes).
  PaddedFft(int nx, int ny, int px, int py);
  ~PaddedFft();
  PaddedFft(const PaddedFft&) = delete;
  PaddedFft& operator=(const PaddedFft&) = delete;

  int px() const { return px_; }
  int py() const { return py_; }
  int frequencies_x() const { return px_ / 2 + 1; }
  int spectrum_size() const { return frequencies_x() * py_; }

  void forward(const contact::Field& field, Spectrum& spectrum) const;
  /// The nx by ny window of the inverse transform, normalised; destroys the spectrum.
  void backward(Spectrum& spectrum, contact::Field& field) const;

  /// Both components, at once where they are large.
  void forward(const contact::TangentialField& field, Spectrum& x, Spectrum& y) const;
  void backward(Spectrum& x, Spectrum& y, contact::TangentialField& field) const;

  /// Whether a transform takes long enough for a second thread to pay.
  bool large() const;

 private:
  struct Plans;
  void forward(const contact::Field& field, Spectrum& spectrum, double* rows, bool at_once) const;
  void backward(Spectrum& spectrum, contact::Field& field, double* rows, bool at_once) const;

  int nx_;
  int ny_;
  int px_;
  int py_;
  std::unique_ptr<Plans> plans_;
};

}  // namespace rollfem::halfspace
