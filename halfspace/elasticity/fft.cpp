#include "halfspace/elasticity/fft.hpp"

#include "contact/base/threads.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cstring>
#include <mutex>
#include <new>

namespace rollfem::halfspace {

namespace {

/// FFTW's planner is not thread-safe; executing plans is.
std::mutex& planner_mutex() {
  static std::mutex mutex;
  return mutex;
}

bool has_small_factors_only(int n) {
  for (const int factor : {2, 3, 5, 7})
    while (n % factor == 0) n /= factor;
  return n == 1;
}

}  // namespace

int good_fft_size(int n) {
  int size = std::max(2, n + n % 2);
  while (!has_small_factors_only(size)) size += 2;
  return size;
}

void* fft_allocate(std::size_t bytes) {
  void* memory = fftw_malloc(bytes);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void fft_free(void* memory) {
  fftw_free(memory);
}

/// Rows of the field along x, ny of them, are transformed and written transposed; the columns of
/// the padded field are then contiguous. Rows of zeros are never transformed.
struct PaddedFft::Plans {
  double* rows = nullptr;   ///< ny * px, zero-padded along x
  double* other = nullptr;  ///< the same for the second of two fields
  fftw_plan rows_forward = nullptr;
  fftw_plan rows_backward = nullptr;
  fftw_plan columns_forward = nullptr;
  fftw_plan columns_backward = nullptr;

  Plans(int ny, int px, int py) {
    const std::lock_guard<std::mutex> lock(planner_mutex());
    const int half = px / 2 + 1;
    rows = fftw_alloc_real(static_cast<std::size_t>(ny) * px);
    other = fftw_alloc_real(static_cast<std::size_t>(ny) * px);
    // Made for one spectrum, executed on any: all are aligned alike. Nothing is overwritten here.
    fftw_complex* columns = fftw_alloc_complex(static_cast<std::size_t>(half) * py);
    const unsigned effort = FFTW_ESTIMATE;
    rows_forward = fftw_plan_many_dft_r2c(1, &px, ny, rows, nullptr, 1, px, columns, nullptr, py, 1,
                                          effort | FFTW_PRESERVE_INPUT);
    rows_backward = fftw_plan_many_dft_c2r(1, &px, ny, columns, nullptr, py, 1, rows, nullptr, 1,
                                           px, effort | FFTW_DESTROY_INPUT);
    columns_forward = fftw_plan_many_dft(1, &py, half, columns, nullptr, 1, py, columns, nullptr, 1,
                                         py, FFTW_FORWARD, effort);
    columns_backward = fftw_plan_many_dft(1, &py, half, columns, nullptr, 1, py, columns, nullptr,
                                          1, py, FFTW_BACKWARD, effort);
    fftw_free(columns);
  }

  ~Plans() {
    const std::lock_guard<std::mutex> lock(planner_mutex());
    for (fftw_plan plan : {rows_forward, rows_backward, columns_forward, columns_backward})
      if (plan) fftw_destroy_plan(plan);
    fftw_free(rows);
    fftw_free(other);
  }
};

PaddedFft::PaddedFft(int nx, int ny, int px, int py)
    : nx_(nx),
      ny_(ny),
      px_(good_fft_size(px)),
      py_(good_fft_size(py)),
      plans_(std::make_unique<Plans>(ny_, px_, py_)) {}

PaddedFft::~PaddedFft() = default;

bool PaddedFft::large() const {
  // 100 elements across, padded: 0.2 ms a transform.
  return spectrum_size() >= 20000;
}

void PaddedFft::forward(const contact::Field& field, Spectrum& spectrum) const {
  forward(field, spectrum, plans_->rows);
}

void PaddedFft::backward(Spectrum& spectrum, contact::Field& field) const {
  backward(spectrum, field, plans_->rows);
}

void PaddedFft::forward(const contact::TangentialField& field, Spectrum& x, Spectrum& y) const {
  contact::both(
      large(), [&] { forward(field.x, x, plans_->rows); },
      [&] { forward(field.y, y, plans_->other); });
}

void PaddedFft::backward(Spectrum& x, Spectrum& y, contact::TangentialField& field) const {
  contact::both(
      large(), [&] { backward(x, field.x, plans_->rows); },
      [&] { backward(y, field.y, plans_->other); });
}

void PaddedFft::forward(const contact::Field& field, Spectrum& spectrum, double* rows) const {
  for (int j = 0; j < ny_; ++j) {
    double* row = rows + static_cast<std::size_t>(j) * px_;
    std::memcpy(row, field.data() + static_cast<std::ptrdiff_t>(j) * nx_, nx_ * sizeof(double));
    std::fill(row + nx_, row + px_, 0.0);
  }
  spectrum.resize(static_cast<std::size_t>(spectrum_size()));
  auto* columns = reinterpret_cast<fftw_complex*>(spectrum.data());
  fftw_execute_dft_r2c(plans_->rows_forward, rows, columns);
  for (int k = 0; k < frequencies_x(); ++k)
    std::fill(spectrum.begin() + static_cast<std::ptrdiff_t>(k) * py_ + ny_,
              spectrum.begin() + static_cast<std::ptrdiff_t>(k + 1) * py_, 0.0);
  fftw_execute_dft(plans_->columns_forward, columns, columns);
}

void PaddedFft::backward(Spectrum& spectrum, contact::Field& field, double* rows) const {
  auto* columns = reinterpret_cast<fftw_complex*>(spectrum.data());
  fftw_execute_dft(plans_->columns_backward, columns, columns);
  fftw_execute_dft_c2r(plans_->rows_backward, columns, rows);
  field.resize(static_cast<Eigen::Index>(nx_) * ny_);
  const double scale = 1.0 / (static_cast<double>(px_) * py_);
  for (int j = 0; j < ny_; ++j) {
    const double* row = rows + static_cast<std::size_t>(j) * px_;
    for (int i = 0; i < nx_; ++i) field[static_cast<Eigen::Index>(j) * nx_ + i] = scale * row[i];
  }
}

}  // namespace rollfem::halfspace
