// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/elasticity/fft.hpp"

#include "base/threads.hpp"

#include <fftw3.h>

#include <algorithm>
#include <array>
#include <deque>
#include <mutex>
#include <tuple>
#include <utility>

namespace rollfem::halfspace {

namespace {

using Complex = std::complex<double>;

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

using Plan = std::shared_ptr<fftw_plan_s>;

/// Plans of this process: grids of one size often follow each other, and planning takes as long as
/// about ten transforms. All are out-of-place complex plans, because FFTW takes four times as long
/// to plan real or in-place transforms. They are executed on any memory, if necessary by several
/// threads at once; all memory has the same alignment.
class KnownPlans {
 public:
  /// `count` lines of n that follow each other; sign: FFTW_FORWARD or FFTW_BACKWARD.
  Plan of(int n, int count, int sign) {
    const Key key{n, count, sign};
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& [known, plan] : plans_)
      if (known == key) return plan;
    Plan plan(made(n, count, sign), [](fftw_plan old) {
      const std::lock_guard<std::mutex> planner(planner_mutex());
      fftw_destroy_plan(old);
    });
    if (plans_.size() == most_kept) plans_.pop_front();
    plans_.emplace_back(key, plan);
    return plan;
  }

 private:
  using Key = std::tuple<int, int, int>;

  static fftw_plan made(int n, int count, int sign) {
    // FFTW_ESTIMATE plans without touching the arrays.
    PaddedFft::Spectrum from(static_cast<std::size_t>(n) * count), to(from.size());
    const std::lock_guard<std::mutex> planner(planner_mutex());
    return fftw_plan_many_dft(1, &n, count, reinterpret_cast<fftw_complex*>(from.data()), nullptr,
                              1, n, reinterpret_cast<fftw_complex*>(to.data()), nullptr, 1, n, sign,
                              FFTW_ESTIMATE);
  }

  /// About ten grids with their preconditioners.
  static constexpr std::size_t most_kept = 128;

  std::mutex mutex_;
  std::deque<std::pair<Key, Plan>> plans_;
};

KnownPlans& known_plans() {
  static KnownPlans plans;
  return plans;
}

void execute(const Plan& plan, const Complex* from, Complex* to) {
  // FFTW's interface is not const-correct, but the input is not modified.
  fftw_execute_dft(plan.get(), reinterpret_cast<fftw_complex*>(const_cast<Complex*>(from)),
                   reinterpret_cast<fftw_complex*>(to));
}

/// Rows are transformed together, two in one complex line.
constexpr int rows_at_once = 8;

/// Rows before and after their transform.
struct Lines {
  PaddedFft::Spectrum from, to;
};

/// The working rows of this thread; no other transform runs on it before they are read.
Lines& lines_of(int px) {
  thread_local Lines lines;
  const std::size_t size = static_cast<std::size_t>(rows_at_once / 2) * px;
  if (lines.from.size() < size) {
    lines.from.resize(size);
    lines.to.resize(size);
  }
  return lines;
}

/// The line a + i b of rows of n values, either of which may be missing, zeros up to its `length`.
void pair_up(const double* a, const double* b, int n, int length, double* line) {
  if (a == nullptr) n = 0;
  for (int i = 0; b != nullptr && i < n; ++i) {
    line[2 * i] = a[i];
    line[2 * i + 1] = b[i];
  }
  for (int i = 0; b == nullptr && i < n; ++i) {
    line[2 * i] = a[i];
    line[2 * i + 1] = 0.0;
  }
  std::fill(line + 2 * n, line + 2 * length, 0.0);
}

/// Plans of one direction, made when needed.
struct Direction {
  std::once_flag made;
  Plan rows, columns, last_columns;  ///< of a piece of columns, and of a shorter last one

  void have(int px, int py, int piece, int sign) {
    std::call_once(made, [&] {
      const int rest = (px / 2 + 1) % piece;
      rows = known_plans().of(px, rows_at_once / 2, sign);
      columns = known_plans().of(py, piece, sign);
      if (rest > 0) last_columns = known_plans().of(py, rest, sign);
    });
  }
  const Plan& of(std::ptrdiff_t count, std::ptrdiff_t piece) const {
    return count == piece ? columns : last_columns;
  }
};

}  // namespace

int good_fft_size(int n) {
  int size = std::max(2, n + n % 2);
  while (!has_small_factors_only(size)) size += 2;
  return size;
}

struct PaddedFft::Plans {
  Direction forward, backward;
};

PaddedFft::PaddedFft(int nx, int ny, int px, int py)
    : nx_(nx),
      ny_(ny),
      px_(good_fft_size(px)),
      py_(good_fft_size(py)),
      plans_(std::make_unique<Plans>()) {}

PaddedFft::~PaddedFft() = default;

std::ptrdiff_t PaddedFft::piece(std::ptrdiff_t size, std::ptrdiff_t of) const {
  // 100 elements across, padded: 0.2 ms a transform.
  constexpr int pays_for_threads = 20000;
  constexpr std::ptrdiff_t most_pieces = 16;
  if (spectrum_size() < pays_for_threads) return std::max<std::ptrdiff_t>(size, 1);
  return ((size + most_pieces - 1) / most_pieces + of - 1) / of * of;
}

void PaddedFft::over_spectrum(
    const std::function<void(std::ptrdiff_t first, std::ptrdiff_t last)>& work) const {
  contact::for_each_piece(spectrum_size(), piece(spectrum_size()), work);
}

void PaddedFft::forward(const contact::TangentialField& field, Spectrum& x, Spectrum& y) const {
  contact::for_each_piece(2, piece(2), [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    if (first == 0) forward(field.x, x);
    if (last == 2) forward(field.y, y);
  });
}

void PaddedFft::backward(const Spectrum& x, const Spectrum& y,
                         contact::TangentialField& field) const {
  contact::for_each_piece(2, piece(2), [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    if (first == 0) backward(x, field.x);
    if (last == 2) backward(y, field.y);
  });
}

/// Two real rows a and b are the complex line z = a + i b; of the transforms A and B of both
/// Z(k) = A(k) + i B(k), and Z(-k)* = A(k) - i B(k). They are written transposed: the columns of
/// the padded field are then contiguous. Rows of zeros are never transformed.
void PaddedFft::rows_forward(const contact::Field& field, std::ptrdiff_t first, std::ptrdiff_t last,
                             Spectrum& columns) const {
  Lines& lines = lines_of(px_);
  for (std::ptrdiff_t j = first; j < last; j += rows_at_once) {
    const int rows = static_cast<int>(std::min<std::ptrdiff_t>(rows_at_once, last - j));
    for (int row = 0; row < rows_at_once; row += 2) {
      const double* a = field.data() + (j + std::min(row, rows - 1)) * nx_;
      pair_up(row < rows ? a : nullptr, row + 1 < rows ? a + nx_ : nullptr, nx_, px_,
              reinterpret_cast<double*>(lines.from.data() + row / 2 * px_));
    }
    execute(plans_->forward.rows, lines.from.data(), lines.to.data());
    for (int k = 0; k < frequencies_x(); ++k) {
      Complex* to = columns.data() + static_cast<std::ptrdiff_t>(k) * py_ + j;
      const Complex* plus = lines.to.data() + k;
      const Complex* minus = lines.to.data() + (k == 0 ? 0 : px_ - k);
      for (int row = 0; row < rows; row += 2, plus += px_, minus += px_) {
        to[row] = 0.5 * Complex(plus->real() + minus->real(), plus->imag() - minus->imag());
        to[row + 1] = 0.5 * Complex(plus->imag() + minus->imag(), minus->real() - plus->real());
      }
    }
  }
}

/// In real rows the imaginary parts of the first and the last frequency have no effect.
void PaddedFft::rows_backward(const Spectrum& columns, std::ptrdiff_t first, std::ptrdiff_t last,
                              contact::Field& field) const {
  Lines& lines = lines_of(px_);
  const double scale = 1.0 / (static_cast<double>(px_) * py_);
  for (std::ptrdiff_t j = first; j < last; j += rows_at_once) {
    const int rows = static_cast<int>(std::min<std::ptrdiff_t>(rows_at_once, last - j));
    for (int k = 0; k < frequencies_x(); ++k) {
      const Complex* from = columns.data() + static_cast<std::ptrdiff_t>(k) * py_ + j;
      Complex* plus = lines.from.data() + k;
      Complex* minus = lines.from.data() + px_ - k;
      const bool real = k == 0 || 2 * k == px_;
      for (int row = 0; row < rows; row += 2, plus += px_, minus += px_) {
        const Complex a = from[row], b = from[row + 1];
        *plus =
            real ? Complex(a.real(), b.real()) : Complex(a.real() - b.imag(), a.imag() + b.real());
        if (!real) *minus = Complex(a.real() + b.imag(), b.real() - a.imag());
      }
    }
    execute(plans_->backward.rows, lines.from.data(), lines.to.data());
    for (int row = 0; row < rows; row += 2) {
      const double* from = reinterpret_cast<double*>(lines.to.data() + row / 2 * px_);
      double* a = field.data() + (j + row) * nx_;
      double* b = row + 1 < rows ? a + nx_ : nullptr;
      for (int i = 0; i < nx_; ++i) a[i] = scale * from[2 * i];
      for (int i = 0; b != nullptr && i < nx_; ++i) b[i] = scale * from[2 * i + 1];
    }
  }
}

void PaddedFft::forward(const contact::Field& field, Spectrum& spectrum) const {
  const std::ptrdiff_t some = piece(frequencies_x());
  plans_->forward.have(px_, py_, static_cast<int>(some), FFTW_FORWARD);
  spectrum.resize(static_cast<std::size_t>(spectrum_size()));
  const auto columns = this->spectrum();
  columns->resize(spectrum.size());
  contact::for_each_piece(ny_, piece(ny_, rows_at_once), [&](std::ptrdiff_t first, auto last) {
    rows_forward(field, first, last, *columns);
  });
  contact::for_each_piece(frequencies_x(), some, [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    for (std::ptrdiff_t k = first; k < last; ++k)
      std::fill(columns->data() + k * py_ + ny_, columns->data() + (k + 1) * py_, 0.0);
    execute(plans_->forward.of(last - first, some), columns->data() + first * py_,
            spectrum.data() + first * py_);
  });
}

void PaddedFft::backward(const Spectrum& spectrum, contact::Field& field) const {
  const std::ptrdiff_t some = piece(frequencies_x());
  plans_->backward.have(px_, py_, static_cast<int>(some), FFTW_BACKWARD);
  const auto columns = this->spectrum();
  columns->resize(static_cast<std::size_t>(spectrum_size()));
  field.resize(static_cast<Eigen::Index>(nx_) * ny_);
  contact::for_each_piece(frequencies_x(), some, [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    execute(plans_->backward.of(last - first, some), spectrum.data() + first * py_,
            columns->data() + first * py_);
  });
  contact::for_each_piece(ny_, piece(ny_, rows_at_once), [&](std::ptrdiff_t first, auto last) {
    rows_backward(*columns, first, last, field);
  });
}

}  // namespace rollfem::halfspace
