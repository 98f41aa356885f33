#include "halfspace/elasticity/fft.hpp"

#include "contact/base/threads.hpp"

#include <fftw3.h>

#include <algorithm>
#include <array>
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

/// Transforms of `count` lines from the `first` on.
struct Share {
  int first = 0;
  int count = 0;
  fftw_plan forward = nullptr;
  fftw_plan backward = nullptr;
};

/// 100 elements across, padded: 0.2 ms a transform.
bool pays_for_a_thread(int px, int py) {
  return (px / 2 + 1) * py >= 20000;
}

/// Halves of n lines, for two threads, and for one so that it rounds alike. The second begins at a
/// multiple of eight: plans demand the alignment of the memory they were made for.
std::array<Share, 2> halves(int n) {
  constexpr int aligned = 8;
  const int first = std::min(n, (n / 2 + aligned - 1) / aligned * aligned);
  return {Share{0, first}, Share{first, n - first}};
}

std::array<Share, 2> shares(int n, bool two) {
  return two ? halves(n) : std::array<Share, 2>{Share{0, n}, Share{n, 0}};
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
  double* memory = nullptr;  ///< ny * px, zero-padded along x
  double* other = nullptr;   ///< the same for the second of two fields
  std::array<Share, 2> rows;
  std::array<Share, 2> columns;

  Plans(int ny, int px, int py)
      : rows(shares(ny, pays_for_a_thread(px, py))),
        columns(shares(px / 2 + 1, pays_for_a_thread(px, py))) {
    const std::lock_guard<std::mutex> lock(planner_mutex());
    memory = fftw_alloc_real(static_cast<std::size_t>(ny) * px);
    other = fftw_alloc_real(static_cast<std::size_t>(ny) * px);
    // Made for one spectrum, executed on any: all are aligned alike. Nothing is overwritten here.
    fftw_complex* spectrum = fftw_alloc_complex(static_cast<std::size_t>(px / 2 + 1) * py);
    const unsigned effort = FFTW_ESTIMATE;
    for (Share& share : rows) {
      if (share.count == 0) continue;
      double* from = memory + static_cast<std::ptrdiff_t>(share.first) * px;
      fftw_complex* to = spectrum + share.first;
      share.forward = fftw_plan_many_dft_r2c(1, &px, share.count, from, nullptr, 1, px, to, nullptr,
                                             py, 1, effort | FFTW_PRESERVE_INPUT);
      share.backward = fftw_plan_many_dft_c2r(1, &px, share.count, to, nullptr, py, 1, from,
                                              nullptr, 1, px, effort | FFTW_DESTROY_INPUT);
    }
    for (Share& share : columns) {
      if (share.count == 0) continue;
      fftw_complex* at = spectrum + static_cast<std::ptrdiff_t>(share.first) * py;
      share.forward = fftw_plan_many_dft(1, &py, share.count, at, nullptr, 1, py, at, nullptr, 1,
                                         py, FFTW_FORWARD, effort);
      share.backward = fftw_plan_many_dft(1, &py, share.count, at, nullptr, 1, py, at, nullptr, 1,
                                          py, FFTW_BACKWARD, effort);
    }
    fftw_free(spectrum);
  }

  ~Plans() {
    const std::lock_guard<std::mutex> lock(planner_mutex());
    for (const auto& lines : {rows, columns})
      for (const Share& share : lines)
        for (fftw_plan plan : {share.forward, share.backward})
          if (plan) fftw_destroy_plan(plan);
    fftw_free(memory);
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
  return pays_for_a_thread(px_, py_);
}

void PaddedFft::forward(const contact::Field& field, Spectrum& spectrum) const {
  forward(field, spectrum, plans_->memory, large());
}

void PaddedFft::backward(Spectrum& spectrum, contact::Field& field) const {
  backward(spectrum, field, plans_->memory, large());
}

void PaddedFft::forward(const contact::TangentialField& field, Spectrum& x, Spectrum& y) const {
  contact::both(
      large(), [&] { forward(field.x, x, plans_->memory, false); },
      [&] { forward(field.y, y, plans_->other, false); });
}

void PaddedFft::backward(Spectrum& x, Spectrum& y, contact::TangentialField& field) const {
  contact::both(
      large(), [&] { backward(x, field.x, plans_->memory, false); },
      [&] { backward(y, field.y, plans_->other, false); });
}

void PaddedFft::forward(const contact::Field& field, Spectrum& spectrum, double* rows,
                        bool at_once) const {
  spectrum.resize(static_cast<std::size_t>(spectrum_size()));
  auto* columns = reinterpret_cast<fftw_complex*>(spectrum.data());
  const auto rows_of = [&](const Share& share) {
    if (share.count == 0) return;
    for (int j = share.first; j < share.first + share.count; ++j) {
      double* row = rows + static_cast<std::ptrdiff_t>(j) * px_;
      std::memcpy(row, field.data() + static_cast<std::ptrdiff_t>(j) * nx_, nx_ * sizeof(double));
      std::fill(row + nx_, row + px_, 0.0);
    }
    fftw_execute_dft_r2c(share.forward, rows + static_cast<std::ptrdiff_t>(share.first) * px_,
                         columns + share.first);
  };
  const auto columns_of = [&](const Share& share) {
    if (share.count == 0) return;
    for (int k = share.first; k < share.first + share.count; ++k)
      std::fill(spectrum.begin() + static_cast<std::ptrdiff_t>(k) * py_ + ny_,
                spectrum.begin() + static_cast<std::ptrdiff_t>(k + 1) * py_, 0.0);
    fftw_complex* at = columns + static_cast<std::ptrdiff_t>(share.first) * py_;
    fftw_execute_dft(share.forward, at, at);
  };
  contact::both(
      at_once, [&] { rows_of(plans_->rows[0]); }, [&] { rows_of(plans_->rows[1]); });
  contact::both(
      at_once, [&] { columns_of(plans_->columns[0]); }, [&] { columns_of(plans_->columns[1]); });
}

void PaddedFft::backward(Spectrum& spectrum, contact::Field& field, double* rows,
                         bool at_once) const {
  auto* columns = reinterpret_cast<fftw_complex*>(spectrum.data());
  field.resize(static_cast<Eigen::Index>(nx_) * ny_);
  const double scale = 1.0 / (static_cast<double>(px_) * py_);
  const auto columns_of = [&](const Share& share) {
    if (share.count == 0) return;
    fftw_complex* at = columns + static_cast<std::ptrdiff_t>(share.first) * py_;
    fftw_execute_dft(share.backward, at, at);
  };
  const auto rows_of = [&](const Share& share) {
    if (share.count == 0) return;
    fftw_execute_dft_c2r(share.backward, columns + share.first,
                         rows + static_cast<std::ptrdiff_t>(share.first) * px_);
    for (int j = share.first; j < share.first + share.count; ++j) {
      const double* row = rows + static_cast<std::ptrdiff_t>(j) * px_;
      for (int i = 0; i < nx_; ++i) field[static_cast<Eigen::Index>(j) * nx_ + i] = scale * row[i];
    }
  };
  contact::both(
      at_once, [&] { columns_of(plans_->columns[0]); }, [&] { columns_of(plans_->columns[1]); });
  contact::both(
      at_once, [&] { rows_of(plans_->rows[0]); }, [&] { rows_of(plans_->rows[1]); });
}

}  // namespace rollfem::halfspace
