// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/elasticity/influence_tables.hpp"

#include "contact/iteration/interpolation.hpp"
#include "halfspace/elasticity/influence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace rollfem::halfspace {

namespace {

constexpr int steps_of_two = 4;  ///< tables from one ratio to its double
constexpr int octaves = 6;       ///< in both directions from 1

InfluenceTable table_of(int nx, int ny, double ratio, const contact::CombinedMaterial& material) {
  InfluenceTable table;
  table.ratio = ratio;
  table.nx = nx;
  table.ny = ny;
  std::vector<Influence> ahead(static_cast<std::size_t>(nx) + 2);
  const auto of = [&](int i) {
    Influence found = ahead[static_cast<std::size_t>(std::abs(i))];
    if (i < 0) found.xy = -found.xy;
    return found;
  };
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i <= nx + 1; ++i)
      ahead[static_cast<std::size_t>(i)] = rectangle_influence(i, j * ratio, 1.0, ratio, material);
    if (j == 0)
      table.diagonal =
          0.25 * (3.0 * (of(0).xx + of(0).yy) - 4.0 * (of(1).xx + of(1).yy) + of(2).xx + of(2).yy);
    for (int i = -nx; i <= nx; ++i) {
      table.nn.push_back(of(i).nn);
      table.xx.push_back(of(i).xx - of(i + 1).xx);
      table.yy.push_back(of(i).yy - of(i + 1).yy);
      table.xy.push_back(of(i).xy - of(i + 1).xy);
    }
  }
  for (auto* list : {&table.nn, &table.xx, &table.yy, &table.xy})
    list->resize(list->size() + read_beyond);
  return table;
}

#define ROLLFEM_INLINE inline __attribute__((always_inline))

/// A register of this many bytes, also for unaligned memory.
template <int bytes>
struct Register {
  static constexpr int lanes = bytes / static_cast<int>(sizeof(double));
  using type [[gnu::vector_size(bytes)]] = double;
  using anywhere [[gnu::vector_size(bytes), gnu::aligned(sizeof(double)), gnu::may_alias]] = double;

  static ROLLFEM_INLINE const anywhere& at(const double* place) {
    return *reinterpret_cast<const anywhere*>(place);
  }
  static ROLLFEM_INLINE anywhere& at(double* place) { return *reinterpret_cast<anywhere*>(place); }
};

/// A result of up to `columns`.
template <int bytes, int columns>
ROLLFEM_INLINE void convolve_columns(const InfluenceRows& influence, const Source* first,
                                     const Source* last, int nx, int ny, double* result) {
  using In = Register<bytes>;
  constexpr int registers = (columns + In::lanes - 1) / In::lanes;
  static_assert(registers * In::lanes <= most_columns + static_cast<int>(read_beyond) / 2);
  for (int l = 0; l < ny; ++l) {
    typename In::type sum[registers] = {};
    for (const Source* source = first; source != last; ++source) {
      const double* at = influence.middle + influence.to_next * std::abs(l - source->j) - source->i;
      for (int r = 0; r < registers; ++r) sum[r] += source->value * In::at(at + r * In::lanes);
    }
    double* const row = result + static_cast<std::ptrdiff_t>(l) * nx;
    for (int r = 0; r < registers; ++r)
      for (int k = 0; k < In::lanes && r * In::lanes + k < nx; ++k)
        row[r * In::lanes + k] = sum[r][k];
  }
}

template <int bytes>
ROLLFEM_INLINE void convolve(const InfluenceRows& influence, const Source* first,
                             const Source* last, int nx, int ny, double* result) {
  if (nx <= 16) return convolve_columns<bytes, 16>(influence, first, last, nx, ny, result);
  if (nx <= 20) return convolve_columns<bytes, 20>(influence, first, last, nx, ny, result);
  convolve_columns<bytes, most_columns>(influence, first, last, nx, ny, result);
}

template <int bytes, int rows>
ROLLFEM_INLINE void multiply_rows(const double* matrix, std::ptrdiff_t stride,
                                  std::ptrdiff_t columns, const double* x, double* y) {
  using In = Register<bytes>;
  typename In::type sum[rows] = {};
  std::ptrdiff_t k = 0;
  for (; k + In::lanes <= columns; k += In::lanes) {
    const typename In::type at = In::at(x + k);
    for (int r = 0; r < rows; ++r) sum[r] += In::at(matrix + r * stride + k) * at;
  }
  for (int r = 0; r < rows; ++r) {
    double all = 0.0;
    for (int lane = 0; lane < In::lanes; ++lane) all += sum[r][lane];
    for (std::ptrdiff_t rest = k; rest < columns; ++rest)
      all += matrix[r * stride + rest] * x[rest];
    y[r] = all;
  }
}

template <int bytes>
ROLLFEM_INLINE void multiply(const double* matrix, std::ptrdiff_t stride, std::ptrdiff_t rows,
                             std::ptrdiff_t columns, const double* x, double* y) {
  constexpr int together = 4;
  std::ptrdiff_t row = 0;
  for (; row + together <= rows; row += together)
    multiply_rows<bytes, together>(matrix + row * stride, stride, columns, x, y + row);
  for (; row < rows; ++row)
    multiply_rows<bytes, 1>(matrix + row * stride, stride, columns, x, y + row);
}

/// to += factor from, n values.
template <int bytes>
ROLLFEM_INLINE void add(double factor, const double* from, std::ptrdiff_t n, double* to) {
  using In = Register<bytes>;
  std::ptrdiff_t k = 0;
  for (; k + In::lanes <= n; k += In::lanes) In::at(to + k) += factor * In::at(from + k);
  for (; k < n; ++k) to[k] += factor * from[k];
}

template <int bytes>
ROLLFEM_INLINE void invert(double* matrix, std::ptrdiff_t stride, std::ptrdiff_t n) {
  std::ptrdiff_t exchanged[ElementSums::most_rows];
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    double* const row = matrix + k * stride;
    std::ptrdiff_t largest = k;
    for (std::ptrdiff_t i = k + 1; i < n; ++i)
      if (std::abs(matrix[i * stride + k]) > std::abs(matrix[largest * stride + k])) largest = i;
    exchanged[k] = largest;
    if (largest != k) std::swap_ranges(row, row + n, matrix + largest * stride);
    const double pivot = std::exchange(row[k], 1.0);
    for (std::ptrdiff_t c = 0; c < n; ++c) row[c] /= pivot;
    for (std::ptrdiff_t i = 0; i < n; ++i)
      if (i != k)
        add<bytes>(-std::exchange(matrix[i * stride + k], 0.0), row, n, matrix + i * stride);
  }
  for (std::ptrdiff_t k = n - 1; k >= 0; --k)
    for (std::ptrdiff_t i = 0; exchanged[k] != k && i < n; ++i)
      std::swap(matrix[i * stride + k], matrix[i * stride + exchanged[k]]);
}

// Attributes cannot stand in parentheses.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define ROLLFEM_VARIANT(name, bytes, attribute)                                                    \
  attribute void convolve_##name(const InfluenceRows& influence, const Source* first,              \
                                 const Source* last, int nx, int ny, double* result) {             \
    convolve<bytes>(influence, first, last, nx, ny, result);                                       \
  }                                                                                                \
  attribute void multiply_##name(const double* matrix, std::ptrdiff_t stride, std::ptrdiff_t rows, \
                                 std::ptrdiff_t columns, const double* x, double* y) {             \
    multiply<bytes>(matrix, stride, rows, columns, x, y);                                          \
  }                                                                                                \
  attribute void invert_##name(double* matrix, std::ptrdiff_t stride, std::ptrdiff_t n) {          \
    invert<bytes>(matrix, stride, n);                                                              \
  }                                                                                                \
  constexpr ElementSums sums_##name{&convolve_##name, &multiply_##name, &invert_##name};
// NOLINTEND(bugprone-macro-parentheses)

ROLLFEM_VARIANT(sse2, 16, )
#ifdef __x86_64__
ROLLFEM_VARIANT(avx2, 32, __attribute__((target("avx2,fma"))))
ROLLFEM_VARIANT(avx512, 64, __attribute__((target("avx512f,avx512dq,avx512vl,fma"))))
#endif

const ElementSums& of_this_processor() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return sums_avx512;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return sums_avx2;
#endif
  return sums_sse2;
}

}  // namespace

InfluenceTable influence_table(int nx, int ny, double ratio,
                               const contact::CombinedMaterial& material) {
  return table_of(nx, ny, ratio, material);
}

InfluenceTables::InfluenceTables(int nx, int ny, const contact::CombinedMaterial& material)
    : nx_(nx), ny_(ny) {
  constexpr int most = steps_of_two * octaves;
  for (int k = -most; k <= most; ++k)
    tables_.push_back(table_of(nx, ny, std::exp2(static_cast<double>(k) / steps_of_two), material));
}

bool InfluenceTables::interpolate(double ratio, InfluenceTable& table) const {
  constexpr int most = steps_of_two * octaves;
  const double place = steps_of_two * std::log2(ratio) + most;
  if (!(place >= 0.0 && place <= 2 * most)) return false;
  const int first = std::clamp(static_cast<int>(place) - 1, 0, 2 * most - 3);
  const auto part =
      contact::lagrange_weights(std::array<double, 4>{0.0, 1.0, 2.0, 3.0}, place - first);
  const InfluenceTable* const at = &tables_[static_cast<std::size_t>(first)];
  table.ratio = ratio;
  table.nx = nx_;
  table.ny = ny_;
  table.diagonal = 0.0;
  for (std::size_t m = 0; m < part.size(); ++m) table.diagonal += part[m] * at[m].diagonal;
  for (std::vector<double> InfluenceTable::*list :
       {&InfluenceTable::nn, &InfluenceTable::xx, &InfluenceTable::yy, &InfluenceTable::xy}) {
    const std::size_t count = (at->*list).size();
    (table.*list).resize(count);
    const double *a = (at[0].*list).data(), *b = (at[1].*list).data(), *c = (at[2].*list).data(),
                 *d = (at[3].*list).data();
    double* to = (table.*list).data();
    for (std::size_t k = 0; k < count; ++k)
      to[k] = part[0] * a[k] + part[1] * b[k] + part[2] * c[k] + part[3] * d[k];
  }
  return true;
}

const ElementSums& element_sums() {
  static const ElementSums& sums = of_this_processor();
  return sums;
}

}  // namespace rollfem::halfspace
