// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/linear/partial_factor.hpp"

#include <suitesparse/cholmod.h>

#include <algorithm>

namespace rollfem::fem {

PartialFactor::PartialFactor(const cholmod_factor_struct& factor,
                             const std::vector<bool>& of_unknowns) {
  const auto* first = static_cast<const int*>(factor.super);
  const auto* row_start = static_cast<const int*>(factor.pi);
  const auto* value_start = static_cast<const int*>(factor.px);
  const auto* row = static_cast<const int*>(factor.s);
  const auto* value = static_cast<const double*>(factor.x);
  std::vector<bool> reached = of_unknowns;
  std::vector<std::size_t> taken;
  std::size_t rows = 0, values = 0;
  for (std::size_t s = 0; s < factor.nsuper; ++s) {
    const auto begin = reached.begin() + first[s], end = reached.begin() + first[s + 1];
    if (std::find(begin, end, true) == end) continue;
    const int columns = first[s + 1] - first[s], height = row_start[s + 1] - row_start[s];
    if (height > columns) reached[row[row_start[s] + columns]] = true;
    taken.push_back(s);
    supernodes_.push_back({first[s], columns, height, rows, values});
    rows += height - columns;
    values += static_cast<std::size_t>(columns) * height;
  }
  rows_.reserve(rows);
  values_.resize(values);
  for (std::size_t k = 0; k < taken.size(); ++k) {
    const Supernode& at = supernodes_[k];
    rows_.insert(rows_.end(), row + row_start[taken[k]] + at.columns,
                 row + row_start[taken[k]] + at.height);
    const double* const from = value + value_start[taken[k]];
    std::transform(from, from + static_cast<std::size_t>(at.columns) * at.height,
                   values_.begin() + static_cast<std::ptrdiff_t>(at.values),
                   [](double entry) { return static_cast<float>(entry); });
  }
}

namespace {

/// Columns that a product takes at once.
constexpr int at_once = 4;

using Run __attribute__((vector_size(32), aligned(4), may_alias)) = float;
constexpr int run = 8;

/// Supernode of a factor: lower trapezoid by columns.
struct Trapezoid {
  const float* values;
  int columns, height;

  const float* column(int j) const { return values + static_cast<std::ptrdiff_t>(j) * height; }
};

/// y <- L^-1 y of the columns, minus their products below.
__attribute__((always_inline)) inline void forward(const Trapezoid& l, float* y) {
  for (int j = 0; j < l.columns; j += at_once) {
    const int end = std::min(j + at_once, l.columns);
    for (int c = j; c < end; ++c) {
      y[c] /= l.column(c)[c];
      for (int i = c + 1; i < end; ++i) y[i] -= l.column(c)[i] * y[c];
    }
    int i = end;
    if (end - j == at_once) {
      const float *const a = l.column(j), *const b = l.column(j + 1), *const c = l.column(j + 2),
                         *const d = l.column(j + 3);
      const auto of = [](const float* at) { return reinterpret_cast<const Run*>(at); };
      for (; i + run <= l.height; i += run)
        *reinterpret_cast<Run*>(y + i) -= *of(a + i) * y[j] + *of(b + i) * y[j + 1] +
                                          *of(c + i) * y[j + 2] + *of(d + i) * y[j + 3];
    }
    for (; i < l.height; ++i)
      for (int c = j; c < end; ++c) y[i] -= l.column(c)[i] * y[c];
  }
}

/// y <- L^-T y of the columns, where the rest of y is known.
__attribute__((always_inline)) inline void backward(const Trapezoid& l, float* y) {
  for (int j = (l.columns - 1) / at_once * at_once; j >= 0; j -= at_once) {
    const int end = std::min(j + at_once, l.columns);
    Run sums[at_once] = {};
    int i = end;
    if (end - j == at_once)
      for (; i + run <= l.height; i += run)
        for (int c = 0; c < at_once; ++c)
          sums[c] += *reinterpret_cast<const Run*>(l.column(j + c) + i) *
                     *reinterpret_cast<const Run*>(y + i);
    for (int c = end - 1; c >= j; --c) {
      float sum = 0.0F;
      for (int k = 0; k < run; ++k) sum += sums[c - j][k];
      for (int k = i; k < l.height; ++k) sum += l.column(c)[k] * y[k];
      for (int k = c + 1; k < end; ++k) sum += l.column(c)[k] * y[k];
      y[c] = (y[c] - sum) / l.column(c)[c];
    }
  }
}

void forward_plain(const Trapezoid& l, float* y) {
  forward(l, y);
}
void backward_plain(const Trapezoid& l, float* y) {
  backward(l, y);
}
#ifdef __x86_64__
__attribute__((target("avx2,fma"))) void forward_avx2(const Trapezoid& l, float* y) {
  forward(l, y);
}
__attribute__((target("avx2,fma"))) void backward_avx2(const Trapezoid& l, float* y) {
  backward(l, y);
}
const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
const auto solve_forward = has_avx2 ? forward_avx2 : forward_plain;
const auto solve_backward = has_avx2 ? backward_avx2 : backward_plain;
#else
const auto solve_forward = forward_plain, solve_backward = backward_plain;
#endif

}  // namespace

void PartialFactor::solve(Eigen::VectorXf& b) const {
  std::vector<float> y;
  const auto rows_below = [&](const Supernode& at, const auto& visit) {
    for (int i = at.columns; i < at.height; ++i) visit(y[i], b[rows_[at.rows + i - at.columns]]);
  };
  for (const Supernode& at : supernodes_) {
    y.assign(at.height, 0.0F);
    auto own = b.segment(at.first, at.columns);
    std::copy(own.begin(), own.end(), y.begin());
    solve_forward({values_.data() + at.values, at.columns, at.height}, y.data());
    std::copy_n(y.begin(), at.columns, own.begin());
    rows_below(at, [](float product, float& entry) { entry += product; });
  }
  for (auto at = supernodes_.rbegin(); at != supernodes_.rend(); ++at) {
    y.resize(at->height);
    auto own = b.segment(at->first, at->columns);
    std::copy(own.begin(), own.end(), y.begin());
    rows_below(*at, [](float& known, float entry) { known = entry; });
    solve_backward({values_.data() + at->values, at->columns, at->height}, y.data());
    std::copy_n(y.begin(), at->columns, own.begin());
  }
}

double PartialFactor::memory_bytes() const {
  return static_cast<double>(sizeof(float) * values_.size() + sizeof(int) * rows_.size());
}

}  // namespace rollfem::fem
